//! The non-MSR concept: payload nested in impact foam, under a lid centered on the vehicle's center of gravity.
//!
//! ```text
//! x_p = rest of a ball of radius R_p + foam on the forebody's layers
//! R_L = x_p + R_p + 50 mm + t_a − x_cg
//! x_a ≥ x_cg                                    the lid is at most a hemisphere
//! (R_L − t_a)² ≥ (R_p + c)² + (x_a − x_cg)²     the payload passes the foot of the lid, where the primary structure ends
//! ```
//!
//! with lengths in m, x_p the payload's center, x_cg the center of gravity, x_a the attached structure, t_a the layers of the
//! aftbody, c the clearance between payload and wall. Of all x_a the least is taken at which the wing is no steeper than allowed;
//! when the payload does not pass there the shoulder radius shrinks, then the lid is raised: R_L grows beyond the
//! 50 mm until the foot is where the wing requires it. The payload stays where it is. The foam reaches up to the
//! attached structure or the payload's center, whichever is higher, and never above the payload; lid insulation fills the
//! rest.
//!
//! # Valid
//! Same as [`crate::vehicle::outline`].
//!
//! # References
//! - \[samareh-2014\] sections 3.1.2 and 3.1.4. How the payload is nested, and that the lid is raised where 50 mm leave no room
//!   for the wing, are choices of ours.

use crate::vehicle::draft::Draft;
use crate::vehicle::kinds::ComponentKind;
use crate::vehicle::layout::{Frame, LID_TOLERANCE_M, Layout, Misfit, Trial};
use crate::vehicle::lid::Lid;
use crate::vehicle::profile::Profile;
use crate::vehicle::segment::{Point, Segment, half_chord_m};
use crate::vehicle::wing::Wing;
use numerics::math::{FRAC_PI_2, PI};
use numerics::root;
use numerics::scalar::Single;

impl<S: Single> Frame<'_, S> {
    fn payload_x_m(&self) -> S {
        let radius_m = self.payload_radius_m + self.foam_thickness_m;
        self.forebody
            .resting_ball_x_m(self.depths.fore_m(), radius_m)
    }

    fn lid_at(&self, radius_m: S, foot_x_m: S) -> Lid<S> {
        Lid {
            center_x_m: self.cg_x_m,
            radius_m,
            foot_x_m,
        }
    }

    /// The lid with the highest foot through which the payload passes.
    fn narrowest_lid(&self, radius_m: S) -> Lid<S> {
        let inner = radius_m - self.depths.aft_m();
        let passage = self.payload_radius_m + self.rules.payload_wall_gap_min_m;
        self.lid_at(radius_m, self.cg_x_m + half_chord_m(inner, passage))
    }
}

/// Lays the concept out at the diameter and the center of gravity of the frame.
pub fn layout<S: Single>(frame: &Frame<S>) -> Trial<S> {
    frame.with_room_for_layers(|floor_m| at(frame, floor_m))
}

/// Furthest that a lid is raised for its wing, m.
const MOST_RAISED_M: f64 = 1.0;

/// The layout with a shoulder radius of at least `floor_m`.
fn at<S: Single>(frame: &Frame<S>, floor_m: S) -> Trial<S> {
    let (rules, width) = (frame.rules, frame.rules.annulus_width_m);
    let aft = frame.depths.aft_m();
    let payload_x_m = frame.payload_x_m();
    let payload_top = payload_x_m + frame.payload_radius_m;
    let passage = frame.payload_radius_m + rules.payload_wall_gap_min_m;
    // a payload far ahead of the center of gravity needs a wider lid to pass
    let radius = (payload_top + rules.payload_lid_gap_m - frame.cg_x_m).max(passage) + aft;
    let narrowest = frame.narrowest_lid(radius);
    let wing = frame.wing_for(narrowest.edge(width), floor_m);
    let clearance = |radius: S| wing.clearance_m(frame.narrowest_lid(radius).edge(width));
    let lid = if clearance(radius).value() < -LID_TOLERANCE_M {
        let clearance_m = |radius_m: f64| clearance(S::constant(radius_m)).value();
        let (low, high) = (radius.value(), radius.value() + MOST_RAISED_M);
        let raised = root::brent(clearance_m, low, high, LID_TOLERANCE_M);
        raised.map(|radius_m| frame.narrowest_lid(S::implicit(radius_m, clearance)))
    } else {
        Some(lowest_lid(frame, &wing, narrowest))
    };
    let (outline, room_m, misfit) = frame.outline(lid.unwrap_or(narrowest), &wing);
    Trial {
        layout: Layout {
            outline,
            depths: frame.depths,
            payload_x_m,
            payload_radius_m: frame.payload_radius_m,
            foam_thickness_m: frame.foam_thickness_m,
            impact_shell_thickness_m: S::constant(0.0),
            body_foam_thickness_m: S::constant(0.0),
            lid_insulation_thickness_m: outline.lid_top_x_m() - aft - payload_top,
        },
        room_m,
        misfit: match lid {
            Some(_) => misfit,
            None => misfit.or(Some(Misfit::WingTooSteep)),
        },
    }
}

/// The lid with the lowest foot, at or above its center, at which the wing is not too steep; it is at `narrowest`.
fn lowest_lid<S: Single>(frame: &Frame<S>, wing: &Wing<S>, narrowest: Lid<S>) -> Lid<S> {
    let width = frame.rules.annulus_width_m;
    let at = |foot_x_m: S| frame.lid_at(narrowest.radius_m, foot_x_m);
    let hemisphere = at(frame.cg_x_m);
    let edge = hemisphere.edge(width);
    if wing.clearance_m(edge).value() >= 0.0 {
        return hemisphere;
    }
    // behind the steepest wing by −K + R sin(β − φ) at the angle β above the hemisphere's foot: zero at β = φ + arcsin(K/R)
    let (s, c) = wing.steepest;
    let k = -wing.behind_steepest_m(edge) / narrowest.radius_m - s;
    let sin_angle = s * (-(k * k) + 1.0).max(S::constant(0.0)).sqrt() + c * k;
    let sin_angle = sin_angle.max(S::constant(0.0));
    let lid = at(frame.cg_x_m + narrowest.radius_m * sin_angle);
    if !wing.is_aft_of_steepest(lid.edge(width)) {
        return lid;
    }
    // a higher foot is narrower: once clear it stays so
    let clearance = |foot_x_m: S| wing.clearance_m(at(foot_x_m).edge(width));
    let clearance_m = |foot_x_m: f64| clearance(S::constant(foot_x_m)).value();
    let (low, high) = (frame.cg_x_m.value(), narrowest.foot_x_m.value());
    let found = root::brent(clearance_m, low, high, LID_TOLERANCE_M);
    found.map_or(narrowest, |foot_x_m| at(S::implicit(foot_x_m, clearance)))
}

/// Draws what is inside the primary structure and under the lid.
pub fn filling<S: Single>(layout: &Layout<S>, draft: &mut Draft<S>) {
    draft.part(ComponentKind::ImpactFoam, |path| impact_foam(path, layout));
    draft.part(ComponentKind::LidInsulation, |path| {
        lid_insulation(path, layout)
    });
}

/// Top of the impact foam, m.
fn nest_x_m<S: Single>(layout: &Layout<S>) -> S {
    let payload_top = layout.payload_x_m + layout.payload_radius_m;
    layout
        .outline
        .attached_structure_x_m
        .max(layout.payload_x_m)
        .min(payload_top)
}

/// The lid's inner surface from the axial position `from_x_m` (at its foot when below it) to the axis.
fn lid_above<S: Single>(layout: &Layout<S>, from_x_m: S) -> Segment<S> {
    let aft = layout.depths.aft_m();
    let outline = &layout.outline;
    if from_x_m.value() <= outline.attached_structure_x_m.value() {
        return outline.lid(aft);
    }
    let (radius_m, center) = (
        outline.lid_radius_m - aft,
        Point::on_axis(outline.lid_center_x_m),
    );
    let start = lid_inner_angle_rad(layout, from_x_m);
    Segment::arc(center, radius_m, start, -start)
}

fn lid_inner_angle_rad<S: Single>(layout: &Layout<S>, x_m: S) -> S {
    let radius = layout.outline.lid_radius_m - layout.depths.aft_m();
    let along = x_m - layout.outline.lid_center_x_m;
    half_chord_m(radius, along).atan2(along)
}

/// Direction from the payload's center to where the top of the foam meets it, rad.
fn payload_angle_rad<S: Single>(layout: &Layout<S>) -> S {
    let (radius, along) = (
        layout.payload_radius_m,
        nest_x_m(layout) - layout.payload_x_m,
    );
    if along.value() <= 0.0 {
        S::constant(FRAC_PI_2)
    } else {
        half_chord_m(radius, along).atan2(along)
    }
}

fn impact_foam<S: Single>(path: Profile<S>, layout: &Layout<S>) -> Profile<S> {
    let outline = &layout.outline;
    let fore = layout.depths.fore_m();
    let wall_r = layout.primary_inner_r_m();
    let (nest, foot) = (nest_x_m(layout), outline.attached_structure_x_m);
    let mut path = outline
        .forebody
        .between(path, fore, [S::constant(0.0), wall_r])
        .line_to(Point {
            x_m: foot.min(nest),
            r_m: wall_r,
        });
    if foot.less(nest) {
        let (from, to) = (
            lid_inner_angle_rad(layout, foot),
            lid_inner_angle_rad(layout, nest),
        );
        let center = Point::on_axis(outline.lid_center_x_m);
        let radius = outline.lid_radius_m - layout.depths.aft_m();
        path = path.and(Segment::arc(center, radius, from, to - from));
    }
    path.and(payload_arc(
        layout,
        payload_angle_rad(layout),
        S::constant(PI),
    ))
}

fn lid_insulation<S: Single>(path: Profile<S>, layout: &Layout<S>) -> Profile<S> {
    let (nest, foot) = (nest_x_m(layout), layout.outline.attached_structure_x_m);
    let (angle, wall_r) = (payload_angle_rad(layout), layout.primary_inner_r_m());
    let lid = path.and(lid_above(layout, nest));
    let path = if angle.value() > 0.0 {
        lid.and(payload_arc(layout, S::constant(0.0), angle))
    } else {
        lid.line_to(Point::on_axis(nest))
    };
    if nest.less(foot) {
        path.line_to(Point {
            x_m: nest,
            r_m: wall_r,
        })
    } else {
        path
    }
}

fn payload_arc<S: Single>(layout: &Layout<S>, from_rad: S, to_rad: S) -> Segment<S> {
    let center = Point::on_axis(layout.payload_x_m);
    let radius_m = layout.payload_radius_m;
    Segment::arc(center, radius_m, from_rad, to_rad - from_rad)
}
