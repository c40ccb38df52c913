//! Database of a body by the recipe of this program: choice of tables, correction and damping.
//!
//! ```text
//! C_A0(M):  the drag of the case where it has one, else that of the outline
//! static:   impact theory and molecules over the outline;  damping: section 3.3.7 of the report
//! ```
//!
//! # Valid
//! Bodies of revolution; tables, damping and the fit of the Euler solutions are of air.
//!
//! # References
//! - \[samareh-2014\] section 3.3; what is assumed is named by [`Regime::provenance`](super::database::Regime).

use super::bridging::Bridging;
use super::damping::{Damping, DampingData, Reading};
use super::database::{Database, GAMMA, Options};
use super::euler::{EulerCorrection, SphereCone, axial_force};
use super::integral::{Effort, Law, loads};
use super::surface::Surface;
use super::{Drag, DragTable};
use crate::vehicle::Vehicle;
use crate::vehicle::body::RigidBody;
use crate::vehicle::profile::Profile;
use crate::vehicle::segment::Segment;

/// A body as aerodynamics sees it.
#[derive(Clone, Debug, PartialEq)]
pub struct AeroBody {
    /// Name.
    pub name: String,
    /// Surface of the body, x from the virtual apex.
    pub surface: Surface,
    /// Dimensions of its forebody, where that is a sphere-cone.
    pub sphere_cone: Option<SphereCone>,
    /// Center of gravity, m: x aft of the virtual apex, y to the right, z down.
    pub cg_m: Option<[f64; 3]>,
}

impl AeroBody {
    /// A rigid body; its virtual apex is that of its cone, else the tip of its nose.
    pub fn of_rigid(body: &RigidBody, cg_m: Option<[f64; 3]>) -> AeroBody {
        let apex_x_m = body.virtual_apex_x_m.unwrap_or_else(|| body.nose_tip_x_m());
        let radius_m = 0.5 * body.diameter_m;
        AeroBody {
            name: body.name.clone(),
            surface: Surface::about(&body.outline, body.diameter_m, apex_x_m),
            sphere_cone: body
                .cone_half_angle_rad
                .map(|cone_half_angle_rad| SphereCone {
                    cone_half_angle_rad,
                    nose_radius_ratio: body.nose_radius_m.unwrap_or(0.0) / radius_m,
                    shoulder_radius_ratio: shoulder_radius_m(&body.outline, radius_m) / radius_m,
                }),
            cg_m,
        }
    }

    /// A designed vehicle with its center of gravity.
    pub fn of_vehicle(name: &str, vehicle: &Vehicle) -> AeroBody {
        let d = &vehicle.dimensions;
        let radius_m = 0.5 * d.diameter_m;
        AeroBody {
            name: name.to_string(),
            surface: Surface::new(&vehicle.outline, d.diameter_m),
            sphere_cone: Some(SphereCone {
                cone_half_angle_rad: vehicle.layout.outline.forebody.cone_half_angle_rad,
                nose_radius_ratio: d.nose_radius_m / radius_m,
                shoulder_radius_ratio: d.shoulder_radius_m / radius_m,
            }),
            cg_m: Some([d.cg_from_apex_m, 0.0, 0.0]),
        }
    }

    /// This body with another center of gravity, m, where there is one.
    pub fn with_cg(self, cg_m: Option<[f64; 3]>) -> AeroBody {
        AeroBody {
            cg_m: cg_m.or(self.cg_m),
            ..self
        }
    }

    /// Center of gravity in diameters: aft of the apex, and off the axis.
    pub fn cg_over_diameter(&self) -> Option<[f64; 2]> {
        let diameter_m = self.surface.diameter_m();
        self.cg_m.map(|[x, _, z]| [x / diameter_m, z / diameter_m])
    }

    /// The database, with a drag for zero angle of attack or that of the outline itself.
    pub fn database(&self, standard: &Standard, drag: Option<&Drag>) -> Database {
        Database::of_surface(&self.surface, self.options(standard, drag))
    }

    /// The recipe, ready to be changed.
    pub fn options(&self, standard: &Standard, drag: Option<&Drag>) -> Options {
        Options {
            axial_force: match drag {
                Some(Drag::Constant(c)) => DragTable::from_ascending(&[(0.0, *c)]),
                Some(Drag::Table(table)) => table.clone(),
                None => standard.forces.of_outline(self),
            },
            bridging: Bridging::SineSquared,
            wall_temperature_ratio: 1.0,
            accommodation: [1.0, 1.0],
            damping: standard.damping(Reading::Corrected),
            heat_capacity_ratio: standard.forces.heat_capacity_ratio,
        }
    }
}

/// Data of the recipe.
#[derive(Clone, Debug, PartialEq)]
pub struct Standard {
    /// Data for the axial force of an outline nose first.
    pub forces: AxialForces,
    /// Damping of the report's section 3.3.7.
    pub damping: DampingData,
}

impl Standard {
    /// The data for a gas with another ratio of specific heats.
    #[must_use]
    pub fn in_gas(self, heat_capacity_ratio: f64) -> Self {
        Self {
            forces: self.forces.in_gas(heat_capacity_ratio),
            ..self
        }
    }

    /// Damping of the report's section 3.3.7.
    pub fn damping(&self, reading: Reading) -> Damping {
        Damping::Report {
            data: self.damping.clone(),
            reading,
        }
    }
}

/// Data from which the axial force of an outline nose first is computed.
#[derive(Clone, Debug, PartialEq)]
pub struct AxialForces {
    /// Published tables by the half-angle of their cone, deg, ascending.
    tables: Vec<(f64, DragTable)>,
    /// Correction of impact theory toward solutions of the Euler equations.
    correction: EulerCorrection,
    /// Ratio of specific heats of the gas.
    heat_capacity_ratio: f64,
}

impl AxialForces {
    /// Published tables by the half-angle of their cone, deg, in any order, the first of each angle used, and a correction of
    /// impact theory for other angles.
    pub fn new(mut tables: Vec<(f64, DragTable)>, correction: EulerCorrection) -> Self {
        tables.sort_by(|a, b| a.0.total_cmp(&b.0));
        tables.dedup_by(|a, b| a.0 == b.0);
        Self {
            tables,
            correction,
            heat_capacity_ratio: GAMMA,
        }
    }

    /// The data for a gas with another ratio of specific heats.
    #[must_use]
    pub fn in_gas(self, heat_capacity_ratio: f64) -> Self {
        Self {
            heat_capacity_ratio,
            ..self
        }
    }

    /// Axial force of a body in continuum flow against Mach number.
    pub fn of_outline(&self, body: &AeroBody) -> DragTable {
        let [newtonian] = loads(&body.surface, &[Law::Newtonian(1.0)], 0.0, Effort::FINE);
        let tables: Vec<(f64, &DragTable)> = self.tables.iter().map(|(a, t)| (*a, t)).collect();
        axial_force(
            newtonian.ca,
            body.sphere_cone.as_ref(),
            &self.correction,
            &tables,
            self.heat_capacity_ratio,
        )
    }
}

/// Radius of the arc that makes the largest diameter, m; zero where an edge does.
fn shoulder_radius_m(outline: &Profile, radius_m: f64) -> f64 {
    outline
        .segments
        .iter()
        .find_map(|segment| match *segment {
            Segment::Arc {
                center,
                radius_m: r,
                ..
            } if center.r_m > 0.0 && (center.r_m + r - radius_m).abs() < 1e-6 * radius_m => Some(r),
            _ => None,
        })
        .unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::library::Library;

    #[test]
    fn stardust_is_recognized_and_its_hypersonic_force_is_near_the_published_one() {
        let library = Library::builtin().unwrap();
        let (_, data) = library
            .outlines
            .iter()
            .find(|(name, _)| name == "stardust")
            .unwrap();
        let body = AeroBody::of_rigid(&data.scaled_body(None).unwrap(), None);
        let cone = body.sphere_cone.unwrap();
        assert!((cone.nose_radius_ratio - 0.5625).abs() < 1e-3);
        assert!((cone.shoulder_radius_ratio - 0.0469).abs() < 1e-3);
    }
}
