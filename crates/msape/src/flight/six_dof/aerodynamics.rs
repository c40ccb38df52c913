//! Aerodynamic force and moment on a body at any attitude.
//!
//! ```text
//! F = q S (−C_A, −C_N v/v_⊥, −C_N w/v_⊥),   v_⊥ = √(v² + w²),   tan α = v_⊥/u
//! M = q S d C_m (0, w/v_⊥, −v/v_⊥) + r × F + q S (b C_lp p̂, d C_mq q̂, b C_nr r̂)
//! p̂ = p b/(2 V),   q̂ = q d/(2 V),   r̂ = r b/(2 V)
//! ```
//!
//! with F in N and M in N·m about the center of gravity, axes of the body (x forward, y right, z down); (u, v, w) the
//! velocity relative to the air and V its size in m/s, q the dynamic pressure in Pa, S in m², d and b the reference length
//! and span in m, r from the center of gravity to the point to which C_m belongs, m; p, q, r the inertial rates in rad/s;
//! α the total angle of attack in rad. C_m is positive when it lifts the nose away from the velocity.
//!
//! # Valid
//! Bodies of revolution, and bodies with constants. Constants are linear in α at every α. The coefficients of a database
//! belong to the virtual apex and to its diameter; constants of damping are added to its pitch damping, which holds for yaw,
//! too. The rate of the planet in the damping is left out, as in \[nesc-2015\].
//!
//! # References
//! - \[samareh-2014\] sections 3.3.1 (reference point) and 3.3.7; \[stevens-lewis-2016\] section 2.3.

use super::rigid::Rigid;
use crate::aero::DragTable;
use crate::aero::database::{Coefficients, Database};
use nalgebra::Vector3;
use numerics::math;

/// Model of force and moment.
#[derive(Clone, Debug, PartialEq)]
pub enum Aerodynamics {
    /// Drag against the velocity, without moment, by the drag of the body.
    Drag,
    /// Constants.
    Constants(Constants),
    /// Coefficients of an outline at any Mach number, Knudsen number and angle.
    Database(Box<OfOutline>),
}

/// The database of an outline, or of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct OfOutline {
    /// Coefficients.
    pub database: Database,
    /// Axial force nose first against Mach number, where they rest on a table; its rows are kinks.
    pub axial_force: Option<DragTable>,
}

/// Coefficients that do not depend on Mach number, moment about the center of gravity.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Constants {
    /// Axial force coefficient.
    pub ca: f64,
    /// Slope of the normal force coefficient, 1/rad.
    pub cn_alpha_per_rad: f64,
    /// Slope of the pitching moment coefficient, 1/rad.
    pub cm_alpha_per_rad: f64,
}

/// Damping of rates, coefficients over the rate times length over twice the speed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Damping {
    /// Roll.
    pub clp: f64,
    /// Pitch.
    pub cmq: f64,
    /// Yaw.
    pub cnr: f64,
}

/// Reference lengths and area of the coefficients.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reference {
    /// Area, m².
    pub area_m2: f64,
    /// Length of pitch, m.
    pub length_m: f64,
    /// Span of roll and yaw, m.
    pub span_m: f64,
}

/// The air as it meets the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stream {
    /// Velocity relative to the air, axes of the body, m/s.
    pub velocity_m_s: Vector3<f64>,
    /// Speed relative to the air, m/s.
    pub speed_m_s: f64,
    /// Density, kg/m³.
    pub density_kg_m3: f64,
    /// Drag coefficient by the drag of the body.
    pub drag_coefficient: f64,
    /// Inertial rates, axes of the body, rad/s.
    pub rates_rad_s: Vector3<f64>,
    /// Mach and Knudsen number, where the coefficients depend on them.
    pub mach_knudsen: [f64; 2],
}

/// Force and moment about the center of gravity, axes of the body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Load {
    /// Force, N.
    pub force_n: Vector3<f64>,
    /// Moment, N·m.
    pub moment_n_m: Vector3<f64>,
}

impl Load {
    /// The load multiplied by a factor.
    pub fn times(self, factor: f64) -> Load {
        Load {
            force_n: self.force_n * factor,
            moment_n_m: self.moment_n_m * factor,
        }
    }

    /// The load with that of a parachute, which pulls at a point, given like the center of gravity, m, against the
    /// velocity of the point relative to the air.
    ///
    /// ```text
    /// F = −½ ρ |u_p| (C_D S) u_p,   u_p = u + ω × r,   M = r × F
    /// ```
    pub fn with_canopy(
        self,
        stream: &Stream,
        drag_area_m2: f64,
        attachment_m: [f64; 3],
        cg_m: [f64; 3],
    ) -> Load {
        // x aft, y right, z down become forward, right, down from the center of gravity.
        let (cg_m, attachment_m) = (Vector3::from(cg_m), Vector3::from(attachment_m));
        let arm_m = (attachment_m - cg_m).component_mul(&Vector3::new(-1.0, 1.0, 1.0));
        let velocity_m_s = stream.velocity_m_s + stream.rates_rad_s.cross(&arm_m);
        let speed_m_s = velocity_m_s.norm_squared().sqrt();
        let force_n = velocity_m_s * (-0.5 * stream.density_kg_m3 * speed_m_s * drag_area_m2);
        Load {
            force_n: self.force_n + force_n,
            moment_n_m: self.moment_n_m + arm_m.cross(&force_n),
        }
    }
}

/// Coefficients of a body of revolution at one total angle of attack.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Static {
    ca: f64,
    cn: f64,
    cm: f64,
    /// Pitch and yaw damping.
    cmq: f64,
    /// Length of `cm` and `cmq`, m.
    length_m: f64,
    /// Vector from the center of gravity to the point of `cm`, body axes, m.
    arm_m: Vector3<f64>,
}

/// Angle between the axis and the velocity, rad; nothing at rest.
#[inline]
pub fn total_alpha_rad(velocity_m_s: &Vector3<f64>) -> f64 {
    let [u, v, w] = (*velocity_m_s).into();
    math::atan2((v * v + w * w).sqrt(), u)
}

impl Aerodynamics {
    /// Force and moment.
    #[inline]
    pub fn load(&self, stream: &Stream, body: &Rigid) -> Load {
        let Rigid {
            reference,
            damping,
            cg_m: [x, y, z],
            ..
        } = body;
        let Stream {
            velocity_m_s,
            speed_m_s,
            density_kg_m3: rho,
            rates_rad_s,
            ..
        } = *stream;
        let ([_, v, w], [p, q, r]) = (velocity_m_s.into(), rates_rad_s.into());
        let Reference {
            area_m2: s,
            length_m: d,
            span_m: b,
        } = *reference;
        let pressure_area = 0.5 * rho * speed_m_s * speed_m_s * s;
        // q S/(2 V): the damping does not divide by a speed that may be zero.
        let rate_area = 0.25 * rho * speed_m_s * s;
        let damped = Vector3::new(
            rate_area * b * b * damping.clp * p,
            rate_area * d * d * damping.cmq * q,
            rate_area * b * b * damping.cnr * r,
        );
        let coefficients = match self {
            Aerodynamics::Drag => {
                let along = -0.5 * rho * speed_m_s * s * stream.drag_coefficient;
                return Load {
                    force_n: velocity_m_s * along,
                    moment_n_m: damped,
                };
            }
            Aerodynamics::Constants(constants) => {
                let alpha = total_alpha_rad(&stream.velocity_m_s);
                Static {
                    ca: constants.ca,
                    cn: constants.cn_alpha_per_rad * alpha,
                    cm: constants.cm_alpha_per_rad * alpha,
                    cmq: 0.0,
                    length_m: d,
                    arm_m: Vector3::zeros(),
                }
            }
            Aerodynamics::Database(of_outline) => {
                let database = &of_outline.database;
                let alpha = total_alpha_rad(&stream.velocity_m_s);
                let [mach, knudsen] = stream.mach_knudsen;
                let Coefficients {
                    ca, cn, cm, cmq, ..
                } = database.coefficients(mach, knudsen, alpha);
                Static {
                    ca,
                    cn,
                    cm,
                    cmq,
                    length_m: database.diameter_m,
                    arm_m: Vector3::new(*x, -y, -z),
                }
            }
        };
        let across = (v * v + w * w).sqrt().max(f64::MIN_POSITIVE);
        let (cv, cw) = (v / across, w / across);
        let Static {
            ca,
            cn,
            cm,
            cmq,
            length_m,
            arm_m,
        } = coefficients;
        let force_n = Vector3::new(ca, cn * cv, cn * cw) * -pressure_area;
        let moment = pressure_area * length_m * cm;
        let damping = rate_area * length_m * length_m * cmq;
        let turning = Vector3::new(0.0, moment * cw + damping * q, damping * r - moment * cv);
        Load {
            force_n,
            moment_n_m: arm_m.cross(&force_n) + turning + damped,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::flight::six_dof::inertia::Inertia;
    use nalgebra::UnitQuaternion;

    fn body(aerodynamics: Aerodynamics, damping: Damping) -> Rigid {
        let unit = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        Rigid {
            inertia: Inertia::try_new(unit).unwrap(),
            cg_m: [0.3, 0.0, 0.0],
            reference: Reference {
                area_m2: 2.0,
                length_m: 3.0,
                span_m: 4.0,
            },
            aerodynamics,
            damping,
            attitude: UnitQuaternion::identity(),
            rates_rad_s: Vector3::zeros(),
        }
    }

    fn load_on(body: &Rigid, stream: &Stream) -> Load {
        body.aerodynamics.load(stream, body)
    }

    const STABLE: Aerodynamics = Aerodynamics::Constants(Constants {
        ca: 1.0,
        cn_alpha_per_rad: 0.5,
        cm_alpha_per_rad: -0.1,
    });

    fn stream(velocity_m_s: [f64; 3]) -> Stream {
        let velocity_m_s = Vector3::from(velocity_m_s);
        Stream {
            velocity_m_s,
            speed_m_s: velocity_m_s.norm_squared().sqrt(),
            density_kg_m3: 0.01,
            drag_coefficient: 0.7,
            rates_rad_s: Vector3::zeros(),
            mach_knudsen: [0.0; 2],
        }
    }

    #[test]
    fn nose_up_in_pitch_and_nose_left_in_sideslip_are_turned_back() {
        // 3-4-5: α = atan(4/3) = 0.927295, q S = ½ 0.01 25 · 2 = 0.25 N, C_N = 0.463648, C_m = −0.0927295
        let load = load_on(&body(STABLE, Damping::default()), &stream([3.0, 0.0, 4.0]));
        assert!((load.force_n[0] + 0.25).abs() < 1e-15 && load.force_n[1] == 0.0);
        assert!((load.force_n[2] + 0.115_911_90).abs() < 1e-8);
        assert!((load.moment_n_m[1] + 0.069_547_14).abs() < 1e-8);
        // The velocity to the right: the nose is left of it and is turned right.
        let aside = load_on(&body(STABLE, Damping::default()), &stream([3.0, 4.0, 0.0]));
        assert!((aside.force_n[1] - load.force_n[2]).abs() < 1e-15);
        assert!((aside.moment_n_m[2] + load.moment_n_m[1]).abs() < 1e-15);
    }

    #[test]
    fn drag_is_against_the_velocity_at_any_attitude() {
        let load = load_on(
            &body(Aerodynamics::Drag, Damping::default()),
            &stream([-3.0, 0.0, 4.0]),
        );
        // q S C_D = 0.25 · 0.7
        for (force, part) in load.force_n.iter().zip([0.6, 0.0, -0.8]) {
            assert!((force - 0.175 * part).abs() < 1e-16);
        }
        assert_eq!(load.moment_n_m, Vector3::zeros());
    }

    #[test]
    fn damping_takes_the_span_in_roll_and_yaw_and_the_length_in_pitch() {
        let damping = Damping {
            clp: -1.0,
            cmq: -1.0,
            cnr: -1.0,
        };
        let turning = Stream {
            rates_rad_s: Vector3::repeat(1.0),
            ..stream([5.0, 0.0, 0.0])
        };
        let load = load_on(&body(Aerodynamics::Drag, damping), &turning);
        // q S b · b/(2 V) = 0.25 · 16/10 and 0.25 · 9/10
        for (moment, expected) in load.moment_n_m.iter().zip([-0.4, -0.225, -0.4]) {
            assert!((moment - expected).abs() < 1e-15);
        }
    }

    #[test]
    fn a_parachute_behind_the_center_of_gravity_turns_the_nose_into_the_air() {
        // 3-4-5: ½ 0.01 · 5 · 2 m² = 0.05 on each part; arm −0.5 m along the axis
        let air = stream([3.0, 0.0, 4.0]);
        let load = Load::default().with_canopy(&air, 2.0, [0.8, 0.0, 0.0], [0.3, 0.0, 0.0]);
        for (force, expected) in load.force_n.iter().zip([-0.15, 0.0, -0.2]) {
            assert!((force - expected).abs() < 1e-15);
        }
        // M = r × F: (−0.5, 0, 0) × (−0.15, 0, −0.2) = (0, −0.1, 0): nose down, toward the velocity
        assert!((load.moment_n_m[1] + 0.1).abs() < 1e-15, "{load:?}");
    }

    #[test]
    fn at_rest_there_is_nothing() {
        let load = load_on(&body(STABLE, Damping::default()), &stream([0.0; 3]));
        assert_eq!(
            load,
            Load {
                force_n: Vector3::zeros(),
                moment_n_m: Vector3::zeros()
            }
        );
    }
}
