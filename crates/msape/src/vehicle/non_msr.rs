//! The non-MSR concept: payload nested in impact foam, under a lid centred on the vehicle's centre of gravity.
//!
//! ```text
//! x_p = rest of a ball of radius R_p + foam on the forebody's layers
//! R_L = x_p + R_p + 50 mm + t_a − x_cg
//! x_a ≥ x_cg                                    the lid is at most a hemisphere
//! ```
//!
//! with lengths in m, x_p the payload's centre, x_cg the centre of gravity, x_a the attached structure. Of all x_a the least is
//! taken at which the wing is no steeper than allowed; when payload and wall then collide the shoulder radius shrinks, then
//! the impact foam is thickened. The foam reaches up to the attached structure or the payload's centre, whichever is higher;
//! lid insulation fills the rest.
//!
//! # Valid
//! As [`crate::vehicle::outline`].
//!
//! # References
//! - \[samareh-2014\] sections 3.1.2 and 3.1.4. How the payload is nested is a choice of ours.

use crate::vehicle::kinds::ComponentKind;
use crate::vehicle::layout::{Frame, Layout, Lid, Misfit, SHOULDER_TOLERANCE};
use crate::vehicle::profile::Profile;
use crate::vehicle::segment::{Point, Segment};
use numerics::math::{FRAC_PI_2, PI, atan2};

impl Frame<'_> {
    fn payload_x_m(&self, foam_m: f64) -> f64 {
        self.forebody
            .resting_ball_x_m(self.depths.fore_m(), self.payload_radius_m + foam_m)
    }

    fn lid_radius_m(&self, foam_m: f64) -> f64 {
        let top = self.payload_x_m(foam_m) + self.payload_radius_m + self.rules.payload_lid_gap_m;
        top + self.depths.aft_m() - self.cg_x_m
    }

    fn lid_at(&self, foam_m: f64, foot_x_m: f64) -> Lid {
        Lid {
            center_x_m: self.cg_x_m,
            radius_m: self.lid_radius_m(foam_m),
            foot_x_m,
        }
    }

    /// The highest lid foot at which the payload still passes through, m; `None` when it never does.
    fn highest_foot_x_m(&self, foam_m: f64) -> Option<f64> {
        let inner = self.lid_radius_m(foam_m) - self.depths.aft_m();
        let least = self.payload_radius_m + self.rules.payload_wall_gap_min_m;
        (inner > least).then(|| self.cg_x_m + (inner * inner - least * least).sqrt())
    }
}

/// Lays the concept out at the diameter and the centre of gravity of the frame.
pub fn layout(frame: &Frame) -> Result<Layout, Misfit> {
    let width = frame.rules.annulus_width_m;
    let mut floor = frame.shoulder_floor_m(frame.steepest_rad());
    for _ in 0..20 {
        let mut shoulder = frame.forebody.shoulder_radius_m.max(floor);
        let mut foam = frame.foam_thickness_m;
        let too_wide = Misfit::PayloadWiderThanLid {
            payload_radius_m: frame.payload_radius_m,
        };
        let highest_edge = |foam_m| {
            frame
                .highest_foot_x_m(foam_m)
                .map(|x_m| frame.lid_at(foam_m, x_m).edge(width))
        };
        // no lid over the payload counts as no room: a payload far ahead of the centre of gravity is raised, too
        let room = |radius_m: f64, edge: Option<Point>| {
            edge.map_or(-1.0, |edge| frame.room_m(radius_m, edge))
        };
        if room(shoulder, highest_edge(foam)) < 0.0 {
            shoulder = highest_edge(foam)
                .map_or(floor, |edge| frame.shoulder_with_room_m(edge).max(floor));
            foam = frame.thickened_foam_m(|f| room(shoulder * (1.0 - 1e-12), highest_edge(f)))?;
        }
        let foot = lowest_foot_x_m(frame, foam, shoulder).ok_or(too_wide)?;
        let outline = frame.outline(frame.lid_at(foam, foot), shoulder)?;
        let needed = frame.shoulder_floor_m(outline.wing_slope_rad);
        if needed > shoulder * (1.0 + SHOULDER_TOLERANCE) {
            floor = needed;
            continue;
        }
        return Ok(Layout {
            outline,
            depths: frame.depths,
            payload_x_m: frame.payload_x_m(foam),
            payload_radius_m: frame.payload_radius_m,
            foam_thickness_m: foam,
            impact_shell_thickness_m: 0.0,
            body_foam_thickness_m: 0.0,
            lid_insulation_thickness_m: frame.rules.payload_lid_gap_m,
        });
    }
    Err(Misfit::NoRoomForLayers {
        layers_m: frame.depths.fore_m() + frame.depths.aft_m(),
    })
}

/// The lowest lid foot, at or above the centre of gravity, at which the wing is not too steep, m.
fn lowest_foot_x_m(frame: &Frame, foam_m: f64, shoulder_m: f64) -> Option<f64> {
    let width = frame.rules.annulus_width_m;
    let room = |x_m: f64| frame.room_m(shoulder_m, frame.lid_at(foam_m, x_m).edge(width));
    let (mut low, mut high) = (frame.cg_x_m, frame.highest_foot_x_m(foam_m)?);
    if room(low) >= 0.0 {
        return Some(low);
    }
    // a higher foot is narrower: the room rises all the way
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if room(middle) >= 0.0 {
            high = middle
        } else {
            low = middle
        }
    }
    Some(high)
}

/// What is inside the primary structure and under the lid.
pub fn filling(layout: &Layout) -> Vec<(ComponentKind, Vec<Profile>)> {
    vec![
        (ComponentKind::ImpactFoam, vec![impact_foam(layout)]),
        (ComponentKind::LidInsulation, vec![lid_insulation(layout)]),
    ]
}

/// Top of the impact foam, m.
fn nest_x_m(layout: &Layout) -> f64 {
    layout
        .outline
        .attached_structure_x_m
        .max(layout.payload_x_m)
}

/// The lid's inner surface from the axial position `from_x_m` (at its foot when below it) to the axis.
fn lid_above(layout: &Layout, from_x_m: f64) -> Profile {
    let aft = layout.depths.aft_m();
    let outline = &layout.outline;
    let (radius_m, center) = (
        outline.lid_radius_m - aft,
        Point::on_axis(outline.lid_center_x_m),
    );
    let start = lid_inner_angle_rad(layout, from_x_m);
    if from_x_m <= outline.attached_structure_x_m {
        outline.lid(aft)
    } else {
        Profile {
            segments: vec![Segment::arc(center, radius_m, start, -start)],
        }
    }
}

fn lid_inner_angle_rad(layout: &Layout, x_m: f64) -> f64 {
    let radius = layout.outline.lid_radius_m - layout.depths.aft_m();
    let along = x_m - layout.outline.lid_center_x_m;
    atan2((radius * radius - along * along).max(0.0).sqrt(), along)
}

/// Direction from the payload's centre to where the top of the foam meets it, rad; zero when the foam covers it.
fn payload_angle_rad(layout: &Layout) -> f64 {
    let (radius, along) = (
        layout.payload_radius_m,
        nest_x_m(layout) - layout.payload_x_m,
    );
    if along <= 0.0 {
        FRAC_PI_2
    } else {
        atan2((radius * radius - along * along).max(0.0).sqrt(), along)
    }
}

fn impact_foam(layout: &Layout) -> Profile {
    let outline = &layout.outline;
    let fore = layout.depths.fore_m();
    let wall_r = layout.primary_inner_r_m();
    let (nest, foot) = (nest_x_m(layout), outline.attached_structure_x_m);
    let mut path = outline.forebody.between(fore, 0.0, wall_r).line_to(Point {
        x_m: foot,
        r_m: wall_r,
    });
    if nest > foot {
        let (from, to) = (
            lid_inner_angle_rad(layout, foot),
            lid_inner_angle_rad(layout, nest),
        );
        let center = Point::on_axis(outline.lid_center_x_m);
        let radius = outline.lid_radius_m - layout.depths.aft_m();
        path = path.then(&Profile {
            segments: vec![Segment::arc(center, radius, from, to - from)],
        });
    }
    if nest > layout.payload_x_m + layout.payload_radius_m {
        path = path.line_to(Point::on_axis(nest));
    }
    path.then(&payload_arc(layout, payload_angle_rad(layout), PI))
        .closed()
}

fn lid_insulation(layout: &Layout) -> Profile {
    let nest = nest_x_m(layout);
    let path = lid_above(layout, nest);
    let angle = payload_angle_rad(layout);
    if angle > 0.0 {
        path.then(&payload_arc(layout, 0.0, angle)).closed()
    } else {
        path.line_to(Point::on_axis(nest)).closed()
    }
}

fn payload_arc(layout: &Layout, from_rad: f64, to_rad: f64) -> Profile {
    let center = Point::on_axis(layout.payload_x_m);
    Profile {
        segments: vec![Segment::arc(
            center,
            layout.payload_radius_m,
            from_rad,
            to_rad - from_rad,
        )],
    }
}
