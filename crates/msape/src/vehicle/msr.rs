//! The MSR concept: payload in a foam-filled impact sphere with a shell, under a hemispherical lid.
//!
//! ```text
//! x_c = (R_i + T) / sin θ            center of an impact sphere R_i that rests in the cone under layers T,
//! x_c = x_n − (Rₙ − T) + R_i         or in the nose when R_i < Rₙ − T
//! R_L = R_i + gap + t_a              lid, concentric; its foot and the attached structure are at x_c
//! ```
//!
//! with lengths in m. The gap contains body foam and lid insulation in the proportion of the rules; it is narrowed as far as the
//! rules allow when the wing would be too steep or the lid would reach the shoulder, then the shoulder radius shrinks, then the
//! impact foam is thickened: sphere, lid and attached structure being tied to each other and to the forebody, nothing else
//! raises the lid.
//!
//! # Valid
//! Same as [`crate::vehicle::outline`].
//!
//! # References
//! - \[samareh-2014\] sections 3.1.2 and 3.1.4. With Table 9's thicknesses, 1.05 m and a nose radius of 0.35 m the gap of the
//!   rules makes a lid of 0.276 m whose wing root closes at 30 deg for a shoulder ratio of 0.067.

use crate::vehicle::draft::Draft;
use crate::vehicle::kinds::ComponentKind;
use crate::vehicle::layout::{Frame, LID_TOLERANCE_M, Layout, Misfit, Trial};
use crate::vehicle::lid::Lid;
use crate::vehicle::profile::Profile;
use crate::vehicle::segment::{Point, Segment};
use numerics::math::{FRAC_PI_2, PI};
use numerics::root;
use numerics::scalar::Single;
use numerics::scalar::functions::sin_cos;

impl<S: Single> Frame<'_, S> {
    fn msr_lid(&self, foam_m: S, gap_m: S) -> Lid<S> {
        let sphere = self.payload_radius_m + foam_m + self.rules.impact_shell_thickness_m;
        let x_m = self.forebody.resting_ball_x_m(self.depths.fore_m(), sphere);
        Lid {
            center_x_m: x_m,
            radius_m: sphere + gap_m + self.depths.aft_m(),
            foot_x_m: x_m,
        }
    }

    /// Impact foam to add for an edge that is `lack_m` ahead of the steepest wing, m.
    ///
    /// Foam that is thicker by 1 m moves the edge outwards by as much and aft by 1 m on the nose, by 1 / sin θ m in the cone.
    fn foam_to_add_m(&self, lack_m: S) -> S {
        let (s, c) = sin_cos(self.steepest_rad());
        let sin_theta = self.forebody.sin_cos().0;
        let sphere =
            self.payload_radius_m + self.foam_thickness_m + self.rules.impact_shell_thickness_m;
        let nose = self.forebody.nose_radius_m - self.depths.fore_m();
        let on_nose = lack_m / (c - s);
        // until it leaves the nose, then in the cone
        let left = (nose - sphere).max(S::constant(0.0));
        if on_nose.value() <= left.value() {
            on_nose
        } else {
            left + (lack_m - left * (c - s)) / (c / sin_theta - s)
        }
    }
}

/// Most impact foam that is added for the wing, m.
const MOST_ADDED_FOAM_M: f64 = 0.5;

/// Lays the concept out at the diameter of the frame.
pub fn layout<S: Single>(frame: &Frame<S>) -> Trial<S> {
    frame.with_room_for_layers(|floor_m| at(frame, floor_m))
}

/// The layout with a shoulder radius of at least `floor_m`.
fn at<S: Single>(frame: &Frame<S>, floor_m: S) -> Trial<S> {
    let rules = frame.rules;
    let width = rules.annulus_width_m;
    let wanted_gap = rules.body_foam_gap_m + rules.lid_insulation_gap_m;
    let [least_gap, most_gap] =
        [rules.lid_gap_min_m, wanted_gap.max(rules.lid_gap_min_m)].map(S::constant);
    let narrowest = |foam_m: S| frame.msr_lid(foam_m, least_gap).edge(width);
    let mut foam = frame.foam_thickness_m;
    let wing = frame.wing_for(narrowest(foam), floor_m);
    let clearance = |foam_m: S| wing.clearance_m(narrowest(foam_m));
    if clearance(foam).value() < -LID_TOLERANCE_M {
        // on the steepest wing, unless the shoulder allows a wider edge further forward
        let lack_m = -wing.behind_steepest_m(narrowest(foam));
        let most = foam + frame.foam_to_add_m(lack_m.max(S::constant(0.0)));
        foam = if wing.is_aft_of_steepest(narrowest(most)) {
            let clearance_m = |foam_m: f64| clearance(S::constant(foam_m)).value();
            let found = root::brent(clearance_m, foam.value(), most.value(), LID_TOLERANCE_M);
            found.map_or(most, |foam_m| S::implicit(foam_m, clearance))
        } else {
            most
        };
    }
    // a wider gap moves the edge straight outwards
    let gap = (least_gap + clearance(foam)).clamp(least_gap, most_gap);
    let (outline, room_m, misfit) = frame.outline(frame.msr_lid(foam, gap), &wing);
    let too_thick = (foam - frame.foam_thickness_m).value() > MOST_ADDED_FOAM_M;
    let body_foam = gap * rules.body_foam_gap_m / wanted_gap;
    Trial {
        layout: Layout {
            outline,
            depths: frame.depths,
            payload_x_m: outline.lid_center_x_m,
            payload_radius_m: frame.payload_radius_m,
            foam_thickness_m: foam,
            impact_shell_thickness_m: S::constant(rules.impact_shell_thickness_m),
            body_foam_thickness_m: body_foam,
            lid_insulation_thickness_m: gap - body_foam,
        },
        room_m,
        misfit: if too_thick {
            Some(Misfit::WingTooSteep)
        } else {
            misfit
        },
    }
}

/// Draws what is inside the primary structure and under the lid.
pub fn filling<S: Single>(layout: &Layout<S>, draft: &mut Draft<S>) {
    let Layout {
        payload_radius_m: payload,
        foam_thickness_m: foam,
        ..
    } = *layout;
    let center = Point::on_axis(layout.payload_x_m);
    let sphere = layout.impact_sphere_radius_m();
    let [zero, quarter, half] = [0.0, FRAC_PI_2, PI].map(S::constant);
    let half_ring = |path: Profile<S>, inner, outer| {
        path.and(Segment::arc(center, outer, half, -half))
            .and(Segment::arc(center, inner, zero, half))
    };
    draft.part(ComponentKind::ImpactFoam, |path| {
        half_ring(path, payload, payload + foam)
    });
    draft.part(ComponentKind::ImpactShell, |path| {
        half_ring(path, payload + foam, sphere)
    });
    body_foam(layout, center, sphere, draft);
    draft.part(ComponentKind::LidInsulation, |path| {
        let inner_m = sphere + layout.body_foam_thickness_m;
        path.and(layout.outline.lid(layout.depths.aft_m()))
            .and(Segment::arc(center, inner_m, zero, quarter))
    });
}

/// Around the sphere inside the primary structure and in a dome above it; ahead of it, too, where it rests in the cone.
fn body_foam<S: Single>(layout: &Layout<S>, center: Point<S>, sphere: S, draft: &mut Draft<S>) {
    let [zero, quarter, half] = [0.0, FRAC_PI_2, PI].map(S::constant);
    let forebody = &layout.outline.forebody;
    let fore = layout.depths.fore_m();
    let theta = forebody.cone_half_angle_rad;
    let wall_r = layout.primary_inner_r_m();
    let dome_r = sphere + layout.body_foam_thickness_m;
    let dome = Segment::arc(center, dome_r, quarter, -quarter);
    let in_nose = sphere.less(forebody.nose_radius_m - fore);
    // direction from the sphere's center to where it touches
    let touch = if in_nose { half } else { theta + FRAC_PI_2 };
    let touch_r = if in_nose {
        zero
    } else {
        sphere * sin_cos(touch).0
    };
    draft.part(ComponentKind::BodyFoam, |path| {
        forebody
            .between(path, fore, [touch_r, wall_r])
            .line_to(Point {
                x_m: center.x_m,
                r_m: wall_r,
            })
            .and(dome)
            .and(Segment::arc(center, sphere, zero, touch))
    });
    if !in_nose {
        draft.part(ComponentKind::BodyFoam, |path| {
            forebody
                .between(path, fore, [zero, touch_r])
                .and(Segment::arc(center, sphere, touch, half - touch))
        });
    }
}
