//! DXF release 2000 (AC1015): the half-section as lines and arcs, one layer per part, in millimeters.
//!
//! x of the drawing is the axis, y the distance from it. Layer `outline` holds the outer mold line from nose to aft
//! end, layer `axis` the axis; the other layers are named after the parts.
//!
//! # References
//! - \[autodesk-dxf\].

mod frame;

use crate::export::chain::chains;
use crate::export::model::Model;
use frame::{Handles, Layer};
use msape::vehicle::profile::Profile;
use msape::vehicle::segment::{Point, Segment};
use numerics::math::{PI, RADIANS_PER_DEGREE, atan2};

/// Lengths in the file are in millimeters.
const MM_PER_M: f64 = 1000.0;

/// Colors of the part layers, as DXF color indices; 7 contrasts with the background.
const COLORS: [u8; 12] = [1, 30, 3, 5, 4, 6, 40, 140, 94, 200, 8, 54];

/// The model as the text of a DXF file.
pub fn dxf(model: &Model) -> String {
    let mut layers = vec![Layer::new("outline", 7), Layer::new("axis", 9)];
    let parts = model.parts.iter().zip(COLORS.into_iter().cycle());
    layers.extend(parts.map(|(part, color)| Layer::new(&part.key, color)));
    let mut handles = Handles::default();
    let mut entities = String::new();
    let mut draw = |layer: &str, profile: &Profile, handles: &mut Handles| {
        for segment in chains(profile).iter().flat_map(|chain| &chain.segments) {
            entities.push_str(&entity(segment, layer, handles));
        }
    };
    draw("outline", &model.outline, &mut handles);
    for part in &model.parts {
        for profile in &part.profiles {
            draw(&part.key, profile, &mut handles);
        }
    }
    let [from, to, _] = model.extent_m();
    let axis = Segment::Line {
        start: Point::on_axis(from),
        end: Point::on_axis(to),
    };
    entities.push_str(&entity(&axis, "axis", &mut handles));
    frame::drawing(&layers, &entities, handles)
}

fn entity(segment: &Segment, layer: &str, handles: &mut Handles) -> String {
    let point = |codes: [u8; 3], p: Point| {
        let [x, y] = [p.x_m, p.r_m].map(|v| number(v * MM_PER_M));
        let [a, b, c] = codes;
        format!("{a}\n{x}\n{b}\n{y}\n{c}\n0.0\n")
    };
    let begin = |kind: &str, handle: &str| {
        format!("0\n{kind}\n5\n{handle}\n330\n1F\n100\nAcDbEntity\n8\n{layer}\n")
    };
    let handle = handles.next();
    match *segment {
        Segment::Line { start, end } => format!(
            "{}100\nAcDbLine\n{}{}",
            begin("LINE", &handle),
            point([10, 20, 30], start),
            point([11, 21, 31], end)
        ),
        Segment::Arc {
            start,
            end,
            center,
            radius_m,
            sweep_rad,
            ..
        } => {
            let whole = sweep_rad.abs() >= 2.0 * PI;
            let circle = format!(
                "{}100\nAcDbCircle\n{}40\n{}\n",
                begin(if whole { "CIRCLE" } else { "ARC" }, &handle),
                point([10, 20, 30], center),
                number(radius_m * MM_PER_M)
            );
            if whole {
                return circle;
            }
            // arcs run counter-clockwise
            let (from, to) = if sweep_rad > 0.0 {
                (start, end)
            } else {
                (end, start)
            };
            let [from, to] = [from, to].map(|p| number(angle_deg(center, p)));
            format!("{circle}100\nAcDbArc\n50\n{from}\n51\n{to}\n")
        }
    }
}

/// Direction from a center to a point, 0 to 360 deg.
fn angle_deg(center: Point, p: Point) -> f64 {
    let angle = atan2(p.r_m - center.r_m, p.x_m - center.x_m) / RADIANS_PER_DEGREE;
    if angle < 0.0 { angle + 360.0 } else { angle }
}

/// The number in the shortest form that reads back to the same bits, always with a decimal point.
fn number(value: f64) -> String {
    format!("{:?}", value + 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::model::Measures;

    #[test]
    fn a_ball_is_one_arc_a_layer_from_0_to_180_deg() {
        let half = Segment::arc(Point::on_axis(1.0), 0.5, PI, -PI);
        let profile = Profile {
            segments: vec![half],
        }
        .closed();
        let text = dxf(&Model::of_outline("Ball", &profile, Measures::default()));
        let arc = "100\nAcDbCircle\n10\n1000.0\n20\n0.0\n30\n0.0\n40\n500.0\n100\nAcDbArc\n50\n0.0\n51\n180.0\n";
        assert_eq!(text.matches(arc).count(), 2);
        assert!(text.contains("$INSUNITS\n70\n4\n"));
        // group codes and values alternate
        let lines: Vec<&str> = text.lines().collect();
        let pairs = lines.chunks(2).map(|pair| (pair[0], pair[1]));
        let handle = |(code, value)| ["5", "105"].contains(&code).then_some(value);
        let mut handles: Vec<&str> = pairs.filter_map(handle).collect();
        let count = handles.len();
        handles.sort_unstable();
        handles.dedup();
        assert_eq!(handles.len(), count);
    }
}
