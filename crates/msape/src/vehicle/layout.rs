//! Where everything in a vehicle stands at one diameter, and why it may not fit: what both concepts share.
//!
//! ```text
//! room = (x_a − x_s) cos φ + (r_s − r_a) sin φ − R_s ≥ 0      the wing is no steeper than φ
//! ```
//!
//! with (x_a, r_a) the outer edge of the annulus and (x_s, r_s) the centre of the shoulder arc in m, φ the steepest slope
//! allowed in rad, R_s the shoulder radius in m.
//!
//! # Valid
//! As [`crate::vehicle::outline`].
//!
//! # References
//! - \[samareh-2014\] section 3.1.2. Thickening the impact foam where the vehicle is too flat for its wing is a rule of ours.

use crate::vehicle::forebody::Forebody;
use crate::vehicle::outline::{Outline, smallest_shoulder_radius_m, wing_slope_rad};
use crate::vehicle::rules::Rules;
use crate::vehicle::segment::Point;
use numerics::math::{FRAC_PI_2, RADIANS_PER_DEGREE, sin_cos};
use serde::{Deserialize, Serialize};

/// Depths of the layers under the outer mould line and thickness of the inner walls.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Depths {
    /// Forebody heat shield, m.
    pub forebody_tps_m: f64,
    /// Bond under it, m.
    pub bond_m: f64,
    /// Forebody carrier structure, m.
    pub forebody_carrier_m: f64,
    /// Aftbody heat shield, m.
    pub aftbody_tps_m: f64,
    /// Aftbody carrier structure, m.
    pub aftbody_carrier_m: f64,
    /// Primary structure, m.
    pub primary_m: f64,
}

impl Depths {
    /// All layers of the forebody, m.
    pub fn fore_m(&self) -> f64 {
        self.forebody_tps_m + self.bond_m + self.forebody_carrier_m
    }

    /// All layers of the aftbody, m.
    pub fn aft_m(&self) -> f64 {
        self.aftbody_tps_m + self.aftbody_carrier_m
    }
}

/// What a concept is laid out from.
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a> {
    /// Forebody with the shoulder radius asked for.
    pub forebody: Forebody,
    /// Layers.
    pub depths: Depths,
    /// Radius of the payload, m.
    pub payload_radius_m: f64,
    /// Impact foam that the stroke asks for, m.
    pub foam_thickness_m: f64,
    /// Centre of gravity, the lid's centre of curvature in the non-MSR concept, m.
    pub cg_x_m: f64,
    /// Constants.
    pub rules: &'a Rules,
}

/// Where everything stands.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Layout {
    /// Outer mould line.
    pub outline: Outline,
    /// Layers.
    pub depths: Depths,
    /// Axial position of the payload's centre, m.
    pub payload_x_m: f64,
    /// Radius of the payload, m.
    pub payload_radius_m: f64,
    /// Impact foam, m.
    pub foam_thickness_m: f64,
    /// Impact shell, m; zero without one.
    pub impact_shell_thickness_m: f64,
    /// Body foam above the impact sphere on the axis, m; zero in the non-MSR concept.
    pub body_foam_thickness_m: f64,
    /// Lid insulation on the axis, m.
    pub lid_insulation_thickness_m: f64,
}

/// Why a vehicle does not fit at a diameter.
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
        /// Distance of the shoulder's centre from the axis, m.
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
    /// Payload and clearance are wider than the space under the lid.
    PayloadWiderThanLid {
        /// Radius of the payload, m.
        payload_radius_m: f64,
    },
    /// Masses and geometry kept moving.
    NotConverged {
        /// Last move of the centre of gravity, m.
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
                "the lid's annulus crosses the shoulder: payload, foam and lid with its annulus reach {:.0} mm from the axis, the shoulder's centre stands at {:.0} mm",
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
            Self::PayloadWiderThanLid { payload_radius_m } => format!(
                "the payload crosses the primary structure under the lid: it is {:.0} mm in radius",
                mm(payload_radius_m)
            ),
            Self::NotConverged { move_m } => {
                format!(
                    "masses and geometry did not settle: the lid about the centre of gravity and the foam that raises the payload to it move it on by {:.3} mm a turn",
                    mm(move_m)
                )
            }
        }
    }
}

/// A shoulder this part smaller than the layers ask for is rounding: the slope of a wing at its limit carries that much.
pub const SHOULDER_TOLERANCE: f64 = 1e-9;

/// At the smallest shoulder a wing at its limit is parallel to the forebody, and the layers touch: to within this, m.
const ROUNDING_M: f64 = 1e-9;

/// How much impact foam a search may add, m.
const MOST_ADDED_FOAM_M: f64 = 0.5;

impl Frame<'_> {
    /// Steepest slope of the wing: the rule's, and never steeper than the forebody, rad.
    pub fn steepest_rad(&self) -> f64 {
        self.rules
            .wing_slope_max_rad
            .min(FRAC_PI_2 - self.forebody.cone_half_angle_rad)
    }

    /// Smallest shoulder radius for the layers when the wing slopes `slope_rad`, m.
    pub fn shoulder_floor_m(&self, slope_rad: f64) -> f64 {
        let theta = self.forebody.cone_half_angle_rad;
        smallest_shoulder_radius_m(self.depths.fore_m(), self.depths.aft_m(), theta, slope_rad)
    }

    /// The forebody with another shoulder radius.
    pub fn with_shoulder(&self, shoulder_radius_m: f64) -> Forebody {
        Forebody {
            shoulder_radius_m,
            ..self.forebody
        }
    }

    /// How far an annulus edge stands behind where the steepest wing would put it, m (along the wing's normal).
    pub fn room_m(&self, shoulder_radius_m: f64, edge: Point) -> f64 {
        let center = self.with_shoulder(shoulder_radius_m).shoulder_center();
        let (s, c) = sin_cos(self.steepest_rad());
        (edge.x_m - center.x_m) * c + (center.r_m - edge.r_m) * s - shoulder_radius_m
    }

    /// Largest shoulder radius at which an annulus edge has room, m; negative when there is none. The room is linear in it.
    pub fn shoulder_with_room_m(&self, edge: Point) -> f64 {
        let none = self.room_m(0.0, edge);
        let slope = none - self.room_m(1.0, edge);
        none / slope
    }

    /// Least impact foam, at least what was asked for, at which `room` is not negative, m.
    pub fn thickened_foam_m(&self, room: impl Fn(f64) -> f64) -> Result<f64, Misfit> {
        let (mut low, mut high) = (
            self.foam_thickness_m,
            self.foam_thickness_m + MOST_ADDED_FOAM_M,
        );
        if room(low) >= 0.0 {
            return Ok(low);
        }
        if room(high) < 0.0 || room(high).is_nan() {
            return Err(Misfit::WingTooSteep);
        }
        // to 0.5 m / 2⁴⁵, well under a nanometre
        for _ in 0..45 {
            let middle = 0.5 * (low + high);
            if room(middle) >= 0.0 {
                high = middle
            } else {
                low = middle
            }
        }
        Ok(high)
    }

    /// Finishes a layout: the slope of the wing, and whether the layers fit everywhere.
    pub fn outline(&self, lid: Lid, shoulder_radius_m: f64) -> Result<Outline, Misfit> {
        let forebody = self.with_shoulder(shoulder_radius_m);
        let (nose, shoulder) = (
            forebody.nose_tangent(0.0).r_m,
            forebody.shoulder_tangent(0.0).r_m,
        );
        if nose >= shoulder {
            return Err(Misfit::NoseWiderThanShoulder {
                nose_r_m: nose,
                shoulder_r_m: shoulder,
            });
        }
        let edge = lid.edge(self.rules.annulus_width_m);
        let too_wide = Misfit::LidWiderThanShoulder {
            annulus_r_m: edge.r_m,
            shoulder_r_m: forebody.shoulder_center().r_m,
        };
        let slope = wing_slope_rad(&forebody, edge).ok_or(too_wide)?;
        let outline = Outline {
            forebody,
            wing_slope_rad: slope.min(self.steepest_rad()),
            attached_structure_x_m: lid.foot_x_m,
            annulus_width_m: self.rules.annulus_width_m,
            lid_radius_m: lid.radius_m,
            lid_center_x_m: lid.center_x_m,
        };
        let least_rad = RADIANS_PER_DEGREE;
        if slope < least_rad {
            return Err(Misfit::WingTooShallow {
                slope_rad: slope,
                least_rad: self.rules.wing_slope_min_rad,
            });
        }
        let (fore, aft) = (self.depths.fore_m(), self.depths.aft_m());
        let corner_r = outline.annulus_outer_r_m(aft);
        if outline.on_tip_line(shoulder_radius_m - aft).r_m <= corner_r {
            return Err(too_wide);
        }
        let no_room = Misfit::NoRoomForLayers {
            layers_m: fore + aft,
        };
        let wall_r = outline.lid_foot_r_m(aft) + self.depths.primary_m;
        if wall_r >= corner_r
            || forebody.depth_x_m(fore, corner_r) > lid.foot_x_m - aft + ROUNDING_M
            || aft >= lid.radius_m
        {
            return Err(no_room);
        }
        Ok(outline)
    }
}

/// A lid: a spherical cap that stands on the plane of the annulus.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lid {
    /// Axial position of its centre, m.
    pub center_x_m: f64,
    /// Outer radius, m.
    pub radius_m: f64,
    /// Axial position of its foot, m.
    pub foot_x_m: f64,
}

impl Lid {
    /// Outer edge of the annulus around it.
    pub fn edge(&self, annulus_width_m: f64) -> Point {
        let height = self.foot_x_m - self.center_x_m;
        let foot_r_m = (self.radius_m * self.radius_m - height * height)
            .max(0.0)
            .sqrt();
        Point {
            x_m: self.foot_x_m,
            r_m: foot_r_m + annulus_width_m,
        }
    }
}

impl Layout {
    /// Inner radius of the primary structure, which stands under the foot of the lid, m.
    pub fn primary_inner_r_m(&self) -> f64 {
        self.outline.lid_foot_r_m(self.depths.aft_m())
    }

    /// Outer radius of the primary structure, m.
    pub fn primary_outer_r_m(&self) -> f64 {
        self.primary_inner_r_m() + self.depths.primary_m
    }

    /// Radius of payload and impact foam, with the shell where there is one, m.
    pub fn impact_sphere_radius_m(&self) -> f64 {
        self.payload_radius_m + self.foam_thickness_m + self.impact_shell_thickness_m
    }
}
