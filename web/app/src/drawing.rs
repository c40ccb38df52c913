//! Section of a vehicle as SVG paths, in mm, nose down; x of the screen is the radius.

use msape::vehicle::body::RigidBody;
use msape::vehicle::profile::Profile;
use msape::vehicle::segment::{Point, Segment};
use msape::vehicle::{Component, ComponentKind, Vehicle};

/// Millimeters per meter.
const MM: f64 = 1e3;

/// Component as drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Component.
    pub kind: ComponentKind,
    /// Both halves of its section, as filled path.
    pub fill: String,
    /// Edges, without the seam on the axis.
    pub edges: String,
    /// Position of its number.
    pub label: (f64, f64),
    /// Point inside the component that a number outside refers to.
    pub anchor: Option<(f64, f64)>,
}

/// Complete drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// Components in the order of the mass tree.
    pub parts: Vec<Part>,
    /// Outer mold line.
    pub outline: String,
    /// Radius, mm.
    pub radius_mm: f64,
    /// Highest and lowest point, mm, downward positive.
    pub top_mm: f64,
    /// See `top_mm`.
    pub bottom_mm: f64,
    /// Height of the largest diameter, mm, downward positive.
    pub shoulder_mm: f64,
}

/// Name of a component in style classes.
pub fn class(kind: ComponentKind) -> &'static str {
    match kind {
        ComponentKind::ForebodyTps => "part-forebody-tps",
        ComponentKind::Bond => "part-bond",
        ComponentKind::ForebodyCarrier => "part-forebody-carrier",
        ComponentKind::AftbodyTps => "part-aftbody-tps",
        ComponentKind::AftbodyCarrier => "part-aftbody-carrier",
        ComponentKind::PrimaryStructure => "part-primary-structure",
        ComponentKind::WingInsulation => "part-wing-insulation",
        ComponentKind::ImpactFoam => "part-impact-foam",
        ComponentKind::ImpactShell => "part-impact-shell",
        ComponentKind::BodyFoam => "part-body-foam",
        ComponentKind::LidInsulation => "part-lid-insulation",
        ComponentKind::Payload => "part-payload",
    }
}

/// Name of a component's color in the style sheet.
pub fn variable(kind: ComponentKind) -> &'static str {
    match kind {
        ComponentKind::ForebodyTps => "--part-forebody-tps",
        ComponentKind::Bond => "--part-bond",
        ComponentKind::ForebodyCarrier => "--part-forebody-carrier",
        ComponentKind::AftbodyTps => "--part-aftbody-tps",
        ComponentKind::AftbodyCarrier => "--part-aftbody-carrier",
        ComponentKind::PrimaryStructure => "--part-primary-structure",
        ComponentKind::WingInsulation => "--part-wing-insulation",
        ComponentKind::ImpactFoam => "--part-impact-foam",
        ComponentKind::ImpactShell => "--part-impact-shell",
        ComponentKind::BodyFoam => "--part-body-foam",
        ComponentKind::LidInsulation => "--part-lid-insulation",
        ComponentKind::Payload => "--part-payload",
    }
}

/// Drawing of a vehicle.
pub fn section(vehicle: &Vehicle) -> Section {
    let radius_mm = 0.5 * vehicle.dimensions.diameter_m * MM;
    let nose_mm = -vehicle.dimensions.virtual_apex_ahead_m * MM;
    let height_mm = vehicle.dimensions.vehicle_height_m * MM;
    let mut fore = 0.0;
    let mut aft = 0.0;
    let parts = vehicle
        .components
        .iter()
        .filter(|component| component.volume_m3 > 0.0)
        .map(|component| part(component, radius_mm, &mut fore, &mut aft))
        .collect();
    Section {
        parts,
        outline: both(&vehicle.outline, Ends::WithoutAxis),
        radius_mm,
        top_mm: nose_mm - height_mm,
        bottom_mm: nose_mm,
        shoulder_mm: -vehicle.layout.outline.forebody.shoulder_center().x_m * MM,
    }
}

fn part(component: &Component, radius_mm: f64, fore: &mut f64, aft: &mut f64) -> Part {
    let kind = component.kind;
    let fill = component
        .profiles
        .iter()
        .map(|profile| both(profile, Ends::All));
    let edges = component
        .profiles
        .iter()
        .map(|profile| both(profile, Ends::WithoutAxis));
    let (label, anchor) = match kind {
        ComponentKind::ForebodyTps | ComponentKind::Bond | ComponentKind::ForebodyCarrier => {
            *fore += 1.0;
            let at = inside_layer(component, 0.2 + 0.17 * *fore);
            let out = (0.055 * radius_mm * (1.0 + *fore), 0.26 * radius_mm);
            ((at.0 + out.0, at.1 + out.1), Some(at))
        }
        ComponentKind::AftbodyTps | ComponentKind::AftbodyCarrier => {
            *aft += 1.0;
            let at = inside_layer(component, 0.75 - 0.2 * *aft);
            let out = (0.07 * radius_mm * (3.0 - *aft), -0.2 * radius_mm);
            ((at.0 + out.0, at.1 + out.1), Some(at))
        }
        // left of the center-of-gravity symbol
        ComponentKind::Payload => {
            let (x, y) = middle(component);
            ((-1.35 * x, y), None)
        }
        ComponentKind::ImpactShell => on_shell(component),
        ComponentKind::ImpactFoam => (in_ball(component).unwrap_or(middle(component)), None),
        _ => (middle(component), None),
    };
    Part {
        kind,
        fill: fill.collect(),
        edges: edges.collect(),
        label,
        anchor,
    }
}

/// Outline of one body as drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Silhouette {
    /// Path of both halves.
    pub path: String,
    /// Radius, mm.
    pub radius_mm: f64,
    /// Highest and lowest point, mm, downward positive.
    pub top_mm: f64,
    /// See `top_mm`.
    pub bottom_mm: f64,
    /// Height of the largest diameter, mm, downward positive.
    pub widest_mm: f64,
}

/// Drawing of a rigid body.
pub fn silhouette(body: &RigidBody) -> Silhouette {
    let radius_m = 0.5 * body.diameter_m;
    let [from_m, to_m] = body.extent_m();
    let widest_m = body.nose_tip_x_m() + body.facts().largest_diameter_from_nose_m;
    Silhouette {
        path: both(&body.outline, Ends::WithoutAxis),
        radius_mm: radius_m * MM,
        top_mm: -to_m * MM,
        bottom_mm: -from_m * MM,
        widest_mm: -widest_m * MM,
    }
}

/// A point inside a thin layer: midway between its two longest sides, at a fraction of their length.
fn inside_layer(component: &Component, fraction: f64) -> (f64, f64) {
    let mut sides: Vec<(f64, Point, Point)> = component
        .profiles
        .iter()
        .flat_map(|profile| &profile.segments)
        .map(|segment| (segment.start(), segment.end()))
        .map(|(start, end)| ((end.x_m - start.x_m).hypot(end.r_m - start.r_m), start, end))
        .collect();
    sides.sort_by(|a, b| b.0.total_cmp(&a.0));
    let on = |(_, start, end): &(f64, Point, Point)| {
        // outward from the axis, whatever the direction of the side
        let (inner, outer) = if start.r_m < end.r_m {
            (start, end)
        } else {
            (end, start)
        };
        Point {
            x_m: inner.x_m + fraction * (outer.x_m - inner.x_m),
            r_m: inner.r_m + fraction * (outer.r_m - inner.r_m),
        }
    };
    match sides.as_slice() {
        [a, b, ..] => {
            let (a, b) = (on(a), on(b));
            (0.5 * (a.r_m + b.r_m) * MM, -0.5 * (a.x_m + b.x_m) * MM)
        }
        _ => (0.0, 0.0),
    }
}

/// A point midway between two concentric arcs, forward and outward; `None` if there are none.
fn in_ball(component: &Component) -> Option<(f64, f64)> {
    let arcs = arcs(component);
    let (outer_center, outer_m) = arcs.iter().copied().max_by(|a, b| a.1.total_cmp(&b.1))?;
    let (inner_center, inner_m) = arcs.iter().copied().min_by(|a, b| a.1.total_cmp(&b.1))?;
    let is_ball = (outer_center.x_m - inner_center.x_m).abs() < 1e-6 && inner_m < outer_m;
    let d = std::f64::consts::FRAC_1_SQRT_2 * 0.5 * (outer_m + inner_m);
    is_ball.then(|| ((outer_center.r_m + d) * MM, -(outer_center.x_m - d) * MM))
}

fn arcs(component: &Component) -> Vec<(Point, f64)> {
    component
        .profiles
        .iter()
        .flat_map(|profile| &profile.segments)
        .filter_map(|segment| match segment {
            Segment::Arc {
                center, radius_m, ..
            } => Some((*center, *radius_m)),
            Segment::Line { .. } => None,
        })
        .collect()
}

/// A point on the outermost arc of a shell, aft and outward, and a position for its number further inward.
fn on_shell(component: &Component) -> ((f64, f64), Option<(f64, f64)>) {
    let arcs = arcs(component).into_iter();
    match arcs.max_by(|a, b| a.1.total_cmp(&b.1)) {
        Some((center, radius_m)) => {
            let at = |part: f64| {
                let d = std::f64::consts::FRAC_1_SQRT_2 * part * radius_m;
                ((center.r_m + d) * MM, -(center.x_m + d) * MM)
            };
            (at(0.8), Some(at(0.995)))
        }
        None => (middle(component), None),
    }
}

fn middle(component: &Component) -> (f64, f64) {
    let center = component
        .profiles
        .first()
        .and_then(Profile::section_centroid)
        .unwrap_or_default();
    (center.r_m * MM, -center.x_m * MM)
}

#[derive(Clone, Copy, PartialEq)]
enum Ends {
    All,
    WithoutAxis,
}

/// A profile and its mirror image.
fn both(profile: &Profile, ends: Ends) -> String {
    format!("{}{}", half(profile, 1.0, ends), half(profile, -1.0, ends))
}

fn half(profile: &Profile, side: f64, ends: Ends) -> String {
    let at = |point: Point| format!("{:.3} {:.3}", side * point.r_m * MM, -point.x_m * MM);
    let mut path = String::new();
    let mut pen_is_down = false;
    for segment in &profile.segments {
        let on_axis = segment.start().r_m.abs() < 1e-9 && segment.end().r_m.abs() < 1e-9;
        if ends == Ends::WithoutAxis && on_axis && matches!(segment, Segment::Line { .. }) {
            pen_is_down = false;
            continue;
        }
        if !pen_is_down {
            path.push_str(&format!("M{}", at(segment.start())));
            pen_is_down = true;
        }
        match *segment {
            Segment::Line { end, .. } => path.push_str(&format!("L{}", at(end))),
            Segment::Arc {
                end,
                center,
                radius_m,
                start_angle_rad,
                sweep_rad,
                ..
            } => {
                // two halves, so that an arc may be a full turn
                let angle = start_angle_rad + 0.5 * sweep_rad;
                let half_way = Point {
                    x_m: center.x_m + radius_m * angle.cos(),
                    r_m: center.r_m + radius_m * angle.sin(),
                };
                let clockwise = u8::from((sweep_rad > 0.0) == (side > 0.0));
                let r = radius_m * MM;
                for point in [half_way, end] {
                    path.push_str(&format!("A{r:.3} {r:.3} 0 0 {clockwise} {}", at(point)));
                }
            }
        }
    }
    if ends == Ends::All {
        path.push('Z');
    }
    path
}

/// A length of 1, 2 or 5 times a power of ten, about a quarter of `of_mm`.
pub fn scale_bar_mm(of_mm: f64) -> f64 {
    [1000.0, 500.0, 200.0, 100.0, 50.0, 20.0, 10.0]
        .into_iter()
        .find(|length| *length <= 0.3 * of_mm)
        .unwrap_or(10.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quarter_arc_is_drawn_on_both_sides() {
        // from the nose (x = -1, r = 0) to the largest radius (x = 0, r = 1): 180 deg to 90 deg
        let arc = Segment::arc(
            Point::default(),
            1.0,
            std::f64::consts::PI,
            -std::f64::consts::FRAC_PI_2,
        );
        let profile = Profile {
            segments: vec![arc],
        };
        let path = both(&profile, Ends::WithoutAxis);
        assert!(
            path.starts_with("M0.000 1000.000A1000.000 1000.000 0 0 0 707.107 707.107"),
            "{path}"
        );
        assert!(path.contains("0 0 1 -707.107 707.107"), "{path}");
    }

    #[test]
    fn a_vehicle_of_nine_hundred_mm_has_a_bar_of_two_hundred() {
        assert_eq!(scale_bar_mm(900.0), 200.0);
    }

    #[test]
    fn a_ball_of_one_arc_and_a_hollow_base_have_their_whole_length() {
        let shown = |rows: &[Vec<f64>]| {
            let body = msape::vehicle::body::from_rows("x", rows).unwrap();
            let drawn = silhouette(&body);
            [drawn.bottom_mm, drawn.top_mm, drawn.widest_mm].map(|mm| mm.round() + 0.0)
        };
        let ball = [vec![0.0, 0.0, -1.0], vec![1.0, 0.0, 0.0]];
        assert_eq!(shown(&ball), [0.0, -1000.0, -500.0]);
        let dish = [vec![0.0, 0.0], vec![0.4, 0.5], vec![0.2, 0.0]];
        assert_eq!(shown(&dish), [0.0, -400.0, -400.0]);
    }
}
