//! Layout of a vehicle at one diameter, and the reasons why it may not fit: the part common to both concepts.
//!
//! ```text
//! R_s ≥ (t + t_a cos δ) / (1 + cos δ), cos δ = sin (θ + φ)      the layers fit into the shoulder
//! ```
//!
//! with R_s the shoulder radius, t and t_a the layers of forebody and aftbody in m, θ the cone half-angle and φ the slope of the
//! wing in rad. Of the lids possible in a concept, the lowest and widest that [`Wing`] allows is taken; its distance
//! ahead of the shallowest wing then measures by how much a vehicle is too small, continuously in every dimension.
//!
//! # Valid
//! Same as [`crate::vehicle::outline`].
//!
//! # References
//! - \[samareh-2014\] section 3.1.2.

use crate::vehicle::forebody::Forebody;
use crate::vehicle::lid::Lid;
use crate::vehicle::outline::{Outline, smallest_shoulder_radius_m, wing_slope_rad};
use crate::vehicle::rules::Rules;
use crate::vehicle::segment::Point;
use crate::vehicle::wing::Wing;
use numerics::math::{FRAC_PI_2, RADIANS_PER_DEGREE};
use numerics::root;
use numerics::scalar::Single;
use numerics::scalar::functions::sin_cos;
use serde::{Deserialize, Serialize};

/// Depths of the layers under the outer mold line and thickness of the inner walls.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Depths<S = f64> {
    /// Forebody heat shield, m.
    pub forebody_tps_m: S,
    /// Bond under it, m.
    pub bond_m: S,
    /// Forebody carrier structure, m.
    pub forebody_carrier_m: S,
    /// Aftbody heat shield, m.
    pub aftbody_tps_m: S,
    /// Aftbody carrier structure, m.
    pub aftbody_carrier_m: S,
    /// Primary structure, m.
    pub primary_m: S,
}

impl<S: Single> Depths<S> {
    /// All layers of the forebody, m.
    pub fn fore_m(&self) -> S {
        self.forebody_tps_m + self.bond_m + self.forebody_carrier_m
    }

    /// All layers of the aftbody, m.
    pub fn aft_m(&self) -> S {
        self.aftbody_tps_m + self.aftbody_carrier_m
    }
}

/// Data from which a concept is laid out.
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a, S = f64> {
    /// Forebody with the requested shoulder radius.
    pub forebody: Forebody<S>,
    /// Layers.
    pub depths: Depths<S>,
    /// Radius of the payload, m.
    pub payload_radius_m: S,
    /// Impact foam that the stroke requires, m.
    pub foam_thickness_m: S,
    /// Center of gravity, the lid's center of curvature in the non-MSR concept, m.
    pub cg_x_m: S,
    /// Constants.
    pub rules: &'a Rules,
}

/// Layout of all components.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Layout<S = f64> {
    /// Outer mold line.
    pub outline: Outline<S>,
    /// Layers.
    pub depths: Depths<S>,
    /// Axial position of the payload's center, m.
    pub payload_x_m: S,
    /// Radius of the payload, m.
    pub payload_radius_m: S,
    /// Impact foam, m.
    pub foam_thickness_m: S,
    /// Impact shell, m; zero without one.
    pub impact_shell_thickness_m: S,
    /// Body foam above the impact sphere on the axis, m; zero in the non-MSR concept.
    pub body_foam_thickness_m: S,
    /// Lid insulation on the axis, m.
    pub lid_insulation_thickness_m: S,
}

/// Reason why a vehicle does not fit at a diameter.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum Misfit {
    /// The payload is wider than the vehicle.
    PayloadWiderThanVehicle {
        /// Radius of the payload, m.
        payload_radius_m: f64,
        /// Radius of the vehicle, m.
        vehicle_radius_m: f64,
    },
    /// The nose sphere would end outside the shoulder.
    NoseWiderThanShoulder {
        /// Distance from the axis where the nose would touch the cone, m.
        nose_r_m: f64,
        /// Distance from the axis where the shoulder begins, m.
        shoulder_r_m: f64,
    },
    /// The lid and its annulus reach the shoulder.
    LidWiderThanShoulder {
        /// Outer radius of the annulus, m.
        annulus_r_m: f64,
        /// Distance of the shoulder's center from the axis, m.
        shoulder_r_m: f64,
    },
    /// The wing's aft side would be shallower than allowed.
    WingTooShallow {
        /// Slope, rad.
        slope_rad: f64,
        /// Least slope allowed, rad.
        least_rad: f64,
    },
    /// No shoulder radius and no impact foam make the wing shallow enough.
    WingTooSteep,
    /// The layers do not fit between forebody and aftbody.
    NoRoomForLayers {
        /// Layers of forebody and aftbody together, m.
        layers_m: f64,
    },
    /// Walls that meet the rules were not found: each iteration requires thicker ones.
    NotConverged {
        /// Last growth of a wall, m.
        move_m: f64,
    },
}

impl Misfit {
    /// The reason, one sentence.
    pub fn reason(&self) -> String {
        let mm = |m: f64| m * 1000.0;
        match *self {
            Self::PayloadWiderThanVehicle { payload_radius_m, vehicle_radius_m } => format!(
                "the payload crosses the outline: it is {:.0} mm in radius, the vehicle {:.0} mm",
                mm(payload_radius_m),
                mm(vehicle_radius_m)
            ),
            Self::NoseWiderThanShoulder { nose_r_m, shoulder_r_m } => format!(
                "the nose sphere crosses the shoulder: it would touch the cone {:.0} mm from the axis, where the shoulder begins at {:.0} mm",
                mm(nose_r_m),
                mm(shoulder_r_m)
            ),
            Self::LidWiderThanShoulder { annulus_r_m, shoulder_r_m } => format!(
                "the lid's annulus crosses the shoulder: payload, foam and lid with its annulus reach {:.0} mm from the axis, the shoulder's center stands at {:.0} mm",
                mm(annulus_r_m),
                mm(shoulder_r_m)
            ),
            Self::WingTooShallow { slope_rad, least_rad } => format!(
                "payload and foam stand so high that the wing's aft side slopes {:.1} deg, less than {:.1} deg",
                slope_rad / RADIANS_PER_DEGREE,
                least_rad / RADIANS_PER_DEGREE
            ),
            Self::WingTooSteep => {
                "the wing's aft side stays steeper than allowed for every shoulder radius and foam thickness tried".to_owned()
            }
            Self::NoRoomForLayers { layers_m } => format!(
                "the layers of forebody and aftbody cross: {:.0} mm together, they do not fit between the outer surfaces",
                mm(layers_m)
            ),
            Self::NotConverged { move_m } => format!(
                "no walls carry themselves: masses and geometry did not settle, walls still grow by {:.3} mm a turn",
                mm(move_m)
            ),
        }
    }
}

/// Room below which no shoulder between the smallest and the largest floor is searched for, m.
const NEARLY_M: f64 = -0.01;

/// Precision of the shoulder that leaves the most to spare, m.
const NEAR_M: f64 = 1e-7;

/// Precision of the smallest shoulder, as part of what counts as rounding.
const SHOULDER_PRECISION: f64 = 1e-3;

/// At the smallest shoulder a wing at its limit is parallel to the forebody, and the layers touch: to within this, m.
const ROUNDING_M: f64 = 1e-9;

/// Width of the last interval in the search for a lid or its shoulder, m.
pub const LID_TOLERANCE_M: f64 = 1e-14;

/// A layout, whether it closes or not.
#[derive(Clone, Copy, Debug)]
pub struct Trial<S = f64> {
    /// Layout of all components.
    pub layout: Layout<S>,
    /// Margin of the wing to its least slope, measured at the edge of the annulus, m; negative when it is shallower.
    pub room_m: S,
    /// Why it does not close.
    pub misfit: Option<Misfit>,
}

impl<S: Single> Frame<'_, S> {
    /// Steepest slope of the wing: the rule's, and never steeper than the forebody, rad.
    pub fn steepest_rad(&self) -> S {
        let forebody_rad = -self.forebody.cone_half_angle_rad + FRAC_PI_2;
        S::constant(self.rules.wing_slope_max_rad).min(forebody_rad)
    }

    /// Least slope of the wing: the rule's, or the steepest where that is less, rad.
    pub fn shallowest_rad(&self) -> S {
        S::constant(self.rules.wing_slope_min_rad).min(self.steepest_rad())
    }

    /// Smallest shoulder radius for the layers when the wing slopes `slope_rad`, m.
    fn shoulder_floor_m(&self, slope_rad: S) -> S {
        let theta = self.forebody.cone_half_angle_rad;
        smallest_shoulder_radius_m(self.depths.fore_m(), self.depths.aft_m(), theta, slope_rad)
    }

    /// The layout with the requested shoulder radius or, when the layers have no room in it, with the smallest in which they
    /// have. `lay_out` is given a floor for the radius; the room needed depends on the slope of the wing, and so on the radius.
    pub fn with_room_for_layers(&self, lay_out: impl Fn(S) -> Trial<S>) -> Trial<S> {
        let (least, most) = (self.shallowest_rad(), self.steepest_rad());
        let lack_m = |trial: &Trial<S>| {
            let outline = &trial.layout.outline;
            // shallower than allowed it requires more than any slope that is allowed
            let slope_rad = outline
                .wing_slope_rad
                .max(-self.forebody.cone_half_angle_rad);
            self.shoulder_floor_m(slope_rad.min(most)) - outline.forebody.shoulder_radius_m
        };
        let floors = [least, most].map(|slope_rad| self.shoulder_floor_m(slope_rad));
        let (low_m, high_m) = (floors[0].min(floors[1]), floors[0].max(floors[1]));
        let tolerance_m = ROUNDING_M * SHOULDER_PRECISION;
        let trial = lay_out(low_m);
        if lack_m(&trial).value() <= tolerance_m {
            return trial;
        }
        let lack_with_m = |floor_m: S| lack_m(&lay_out(floor_m));
        let lack_at_m = |floor_m: f64| lack_with_m(S::constant(floor_m)).value();
        let widest = |[one, other]: [f64; 2]| S::implicit(one.max(other), lack_with_m);
        let mut found = root::bracket(lack_at_m, low_m.value(), high_m.value(), tolerance_m);
        let mut trial = lay_out(found.map_or(high_m, widest));
        if found.is_none() && trial.room_m.value() > NEARLY_M {
            // a larger shoulder may want the lid raised: then a radius between the two may be enough where the larger is not
            let (low_m, high_m) = (low_m.value(), high_m.value());
            let (radius_m, spare_m) = root::maximum(|r| -lack_at_m(r), low_m, high_m, NEAR_M);
            if spare_m > 0.0 {
                found = root::bracket(lack_at_m, low_m, radius_m, tolerance_m);
                trial = lay_out(found.map_or(S::constant(radius_m), widest));
            }
        }
        trial
    }

    /// The forebody with another shoulder radius.
    fn with_shoulder(&self, shoulder_radius_m: S) -> Forebody<S> {
        Forebody {
            shoulder_radius_m,
            ..self.forebody
        }
    }

    /// The limits that a shoulder sets to the annulus.
    fn wing(&self, shoulder_radius_m: S) -> Wing<S> {
        Wing {
            center: self.with_shoulder(shoulder_radius_m).shoulder_center(),
            radius_m: shoulder_radius_m,
            steepest: sin_cos(self.steepest_rad()),
            shallowest: sin_cos(self.shallowest_rad()),
        }
    }

    /// The limits at the largest shoulder radius, from the one asked for down to `floor_m`, at which an annulus edge has room;
    /// at the floor when it has at none.
    pub fn wing_for(&self, edge: Point<S>, floor_m: S) -> Wing<S> {
        let asked_m = self.forebody.shoulder_radius_m.max(floor_m);
        let asked = self.wing(asked_m);
        if asked.clearance_m(edge).value() >= 0.0 {
            return asked;
        }
        let clearance = |radius_m: S| self.wing(radius_m).clearance_m(edge);
        let clearance_m = |radius_m: f64| clearance(S::constant(radius_m)).value();
        let (low_m, high_m) = (floor_m.value(), asked_m.value());
        let found = root::bracket(clearance_m, low_m, high_m, LID_TOLERANCE_M);
        self.wing(found.map_or(floor_m, |[one, other]| {
            S::implicit(one.min(other), clearance)
        }))
    }

    /// Finishes a layout: the slope of the wing, and whether the layers fit everywhere.
    pub fn outline(&self, lid: Lid<S>, wing: &Wing<S>) -> (Outline<S>, S, Option<Misfit>) {
        let forebody = self.with_shoulder(wing.radius_m);
        let edge = lid.edge(self.rules.annulus_width_m);
        let slope = wing_slope_rad(&forebody, edge);
        let outline = Outline {
            forebody,
            wing_slope_rad: slope.unwrap_or(S::constant(0.0)).min(self.steepest_rad()),
            attached_structure_x_m: lid.foot_x_m,
            annulus_width_m: S::constant(self.rules.annulus_width_m),
            lid_radius_m: lid.radius_m,
            lid_center_x_m: lid.center_x_m,
        };
        let room = wing.room_m(edge);
        let room_m = room.value();
        let too_steep = wing.clearance_m(edge).value() < -ROUNDING_M && room_m >= 0.0;
        let misfit = if too_steep {
            Some(Misfit::WingTooSteep)
        } else {
            self.misfit(&outline, edge, slope.map(S::value), room_m)
        };
        (outline, room, misfit)
    }

    fn misfit(
        &self,
        outline: &Outline<S>,
        edge: Point<S>,
        slope: Option<f64>,
        room_m: f64,
    ) -> Option<Misfit> {
        let forebody = &outline.forebody;
        let surface = S::constant(0.0);
        let (nose_r_m, shoulder_r_m) = (
            forebody.nose_tangent(surface).r_m.value(),
            forebody.shoulder_tangent(surface).r_m.value(),
        );
        if nose_r_m >= shoulder_r_m {
            return Some(Misfit::NoseWiderThanShoulder {
                nose_r_m,
                shoulder_r_m,
            });
        }
        let too_wide = Misfit::LidWiderThanShoulder {
            annulus_r_m: edge.r_m.value(),
            shoulder_r_m: forebody.shoulder_center().r_m.value(),
        };
        let Some(slope_rad) = slope else {
            return Some(too_wide);
        };
        if room_m < 0.0 && slope_rad >= self.shallowest_rad().value() {
            return Some(too_wide);
        }
        if room_m < 0.0 {
            return Some(Misfit::WingTooShallow {
                slope_rad,
                least_rad: self.rules.wing_slope_min_rad,
            });
        }
        let (fore, aft) = (self.depths.fore_m(), self.depths.aft_m());
        let corner_r = outline.annulus_outer_r_m(aft);
        let wall_r = outline.lid_foot_r_m(aft) + self.depths.primary_m;
        let floor_m = outline.attached_structure_x_m - aft + ROUNDING_M;
        let crossed = wall_r.value() >= corner_r.value()
            || floor_m.less(forebody.depth_x_m(fore, corner_r))
            || aft.value() >= outline.lid_radius_m.value();
        crossed.then_some(Misfit::NoRoomForLayers {
            layers_m: (fore + aft).value(),
        })
    }
}

impl<S: Single> Layout<S> {
    /// Inner radius of the primary structure, which is under the foot of the lid, m.
    pub fn primary_inner_r_m(&self) -> S {
        self.outline.lid_foot_r_m(self.depths.aft_m())
    }

    /// Outer radius of the primary structure, m.
    pub fn primary_outer_r_m(&self) -> S {
        self.primary_inner_r_m() + self.depths.primary_m
    }

    /// Radius of payload and impact foam, including the shell if there is one, m.
    pub fn impact_sphere_radius_m(&self) -> S {
        self.payload_radius_m + self.foam_thickness_m + self.impact_shell_thickness_m
    }
}
