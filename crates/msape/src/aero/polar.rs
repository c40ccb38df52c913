//! Coefficients of a body over the angle of attack in one regime, with trim and stability.
//!
//! ```text
//! C_m,cg = C_m + C_N x_cg − C_A z_cg          x_cg, z_cg in diameters
//! C_D = C_A cos α + C_N sin α    C_L = C_N cos α − C_A sin α
//! trim: C_m,cg = 0;  stable where dC_m,cg/dα < 0;  static margin = −(dC_m,cg/dα)/(dC_N/dα) at α = 0
//! ```
//!
//! with α the angle of attack in rad, moments nose-up positive with the diameter as length.
//!
//! # Valid
//! Bodies of revolution; below zero the angles mirror those above.
//!
//! # References
//! - \[samareh-2014\] section 3.3.1.

use super::bridging::CONTINUUM;
use super::damping::Damping;
use super::database::{Coefficients, Database};
use super::free_molecular::Gas;
use super::integral::{Effort, Law, Loads, loads};
use super::newtonian::{STRAIGHT_NEWTON, pressure_coefficient_max};
use super::standard::AeroBody;
use super::trim::{END_STEP_RAD, Search, Trim, trims};
use numerics::math::{PI, RADIANS_PER_DEGREE};
use serde::{Deserialize, Serialize};

mod remarks;
pub mod write;

pub use remarks::remarks;

/// Theory of the coefficients.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Theory {
    /// Newton with a pressure coefficient of the stagnation point; no correction and no base pressure.
    Newtonian {
        /// C_p,max.
        pressure_coefficient_max: f64,
    },
    /// Molecules without collisions.
    FreeMolecular(Gas),
    /// The database.
    Blended {
        /// Mach number.
        mach: f64,
        /// Mean free path over diameter.
        knudsen: f64,
    },
}

impl Theory {
    /// Newton at a Mach number in a gas of a ratio of heat capacities; his own coefficient without one.
    pub fn newtonian(mach: Option<f64>, heat_capacity_ratio: f64) -> Theory {
        Theory::Newtonian {
            pressure_coefficient_max: mach.map_or(STRAIGHT_NEWTON, |mach| {
                pressure_coefficient_max(mach, heat_capacity_ratio)
            }),
        }
    }
}

/// Coefficients at one angle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// Angle of attack, deg.
    pub alpha_deg: f64,
    /// Axial force coefficient.
    pub ca: f64,
    /// Normal force coefficient.
    pub cn: f64,
    /// Moment coefficient about the virtual apex.
    pub cm_apex: f64,
    /// Moment coefficient about the center of gravity, where that is known.
    pub cm_cg: Option<f64>,
    /// Drag coefficient.
    pub cd: f64,
    /// Lift coefficient.
    pub cl: f64,
    /// Damping coefficient, in the database only.
    pub cmq: Option<f64>,
}

/// Coefficients over the angle of attack.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Polar {
    /// One row per angle, in the order requested.
    pub rows: Vec<Row>,
    /// Every trim point from 0 to 180 deg, where the center of gravity is known.
    pub trim: Vec<Trim>,
    /// Center of pressure nose first, diameters aft of the virtual apex.
    pub pressure_center: Option<f64>,
    /// Distance of the center of gravity ahead of it, diameters.
    pub static_margin: Option<f64>,
}

/// Search for trims, in steps of 2.5 deg.
const TRIMS: Search = Search {
    steps: 72,
    tolerance_rad: 1e-7,
    slope_step_rad: END_STEP_RAD,
};

/// Aerodynamic model evaluated at one angle at a time.
pub struct Aero<'a> {
    body: &'a AeroBody,
    theory: Theory,
    database: Option<&'a Database>,
}

impl<'a> Aero<'a> {
    /// A body in a theory; the database is needed for the blended one and gives zero where it is missing.
    pub fn new(body: &'a AeroBody, theory: Theory, database: Option<&'a Database>) -> Aero<'a> {
        Aero {
            body,
            theory,
            database,
        }
    }

    /// Coefficients at an angle of attack, rad, and damping where there is any.
    pub fn at(&self, alpha_rad: f64) -> (Loads, Option<f64>) {
        let law = match self.theory {
            Theory::Newtonian {
                pressure_coefficient_max,
            } => Law::Newtonian(pressure_coefficient_max),
            Theory::FreeMolecular(gas) => Law::FreeMolecular(gas),
            Theory::Blended { mach, knudsen } => {
                let found = self.database.map(|database| {
                    let found = database.coefficients(mach, knudsen, alpha_rad);
                    let cmq = (*database.damping() != Damping::Absent).then_some(found.cmq);
                    (found.loads(), cmq)
                });
                return found.unwrap_or_default();
            }
        };
        let turned = alpha_rad - 2.0 * PI * (alpha_rad / (2.0 * PI)).round();
        let [mut found] = loads(&self.body.surface, &[law], turned.abs(), Effort::FINE);
        if turned < 0.0 {
            found.cn = -found.cn;
            found.cm = -found.cm;
        }
        (found, None)
    }

    fn row(&self, alpha_deg: f64) -> Row {
        let alpha = alpha_deg * RADIANS_PER_DEGREE;
        let (loads, cmq) = self.at(alpha);
        let cg = self.body.cg_over_diameter();
        Row {
            alpha_deg,
            ca: loads.ca,
            cn: loads.cn,
            cm_apex: loads.cm,
            cm_cg: cg.map(|[x, z]| loads.cm_about(x, z)),
            cd: loads.cd(alpha),
            cl: loads.cl(alpha),
            cmq,
        }
    }

    fn moment(&self, alpha_rad: f64, [x, z]: [f64; 2]) -> f64 {
        self.at(alpha_rad).0.cm_about(x, z)
    }

    /// Every trim point from 0 to 180 deg.
    pub fn trim(&self, cg: [f64; 2]) -> Vec<Trim> {
        let moment = |alpha_rad: f64| self.moment(alpha_rad, cg);
        trims(&moment, &moment, TRIMS)
    }
}

/// Coefficients of a body over angles of attack, deg.
pub fn polar(aero: &Aero, alpha_deg: &[f64]) -> Polar {
    let cg = aero.body.cg_over_diameter();
    let (near, _) = aero.at(END_STEP_RAD);
    let pressure_center = (near.cn.abs() > 1e-12).then(|| -near.cm / near.cn);
    Polar {
        rows: alpha_deg.iter().map(|a| aero.row(*a)).collect(),
        trim: cg.map(|cg| aero.trim(cg)).unwrap_or_default(),
        pressure_center,
        static_margin: pressure_center.zip(cg).map(|(cp, [x, _])| cp - x),
    }
}

/// Coefficients over the Mach number in a continuum at one angle of attack, deg.
pub fn over_mach(database: &Database, mach: &[f64], alpha_deg: f64) -> Vec<Coefficients> {
    let alpha = alpha_deg * RADIANS_PER_DEGREE;
    mach.iter()
        .map(|mach| database.coefficients(*mach, CONTINUUM, alpha))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::aero::surface::Surface;
    use crate::vehicle::profile::Profile;
    use crate::vehicle::segment::{Point, Segment};

    fn cone(cg: f64) -> AeroBody {
        let line = Segment::Line {
            start: Point::default(),
            end: Point { x_m: 0.5, r_m: 0.5 },
        };
        let outline = Profile {
            segments: vec![line],
        }
        .line_to(Point::on_axis(0.5))
        .closed();
        AeroBody {
            name: String::new(),
            surface: Surface::new(&outline, 1.0),
            sphere_cone: None,
            cg_m: Some([cg, 0.0, 0.0]),
        }
    }

    #[test]
    fn sharp_cone_of_45_deg_has_its_center_of_pressure_at_two_thirds_of_a_diameter() {
        // x_cp = (2/3) L/cos² θ = (2/3)(0.5)(2) = 2/3; C_A = 2 sin² θ = 1
        let body = cone(0.4);
        let aero = Aero::new(&body, Theory::newtonian(None, 1.4), None);
        let polar = polar(&aero, &[0.0, -10.0, 10.0]);
        assert!((polar.pressure_center.unwrap() - 2.0 / 3.0).abs() < 1e-6);
        assert!((polar.static_margin.unwrap() - (2.0 / 3.0 - 0.4)).abs() < 1e-6);
        assert!((polar.rows[0].ca - 1.0).abs() < 1e-9);
        assert_eq!(polar.rows[1].cn, -polar.rows[2].cn);
        assert_eq!(polar.rows[1].cd, polar.rows[2].cd);
        // nose first it is stable; backward its flat base is: force along the axis only, so neutral moment slopes by C_N
        assert!(polar.trim[0].alpha_deg == 0.0 && polar.trim[0].cm_alpha_per_rad < 0.0);
        assert_eq!(polar.trim.last().unwrap().alpha_deg, 180.0);
    }
}
