//! Checked inputs of a design.

use crate::aero::Drag;
use crate::design::drag::DesignDrag;
use crate::flight::freedom::Freedom;
use crate::flight::mission::{Body, Mission};
use crate::heating::afterbody::Afterbody;
use crate::heating::shoulder::Shoulder;
use crate::soak::SoakCorrelation;
use crate::tps::JudgedAt;
use crate::tps::fit_space::FitSpace;
use crate::tps::material::TpsMaterial;
use crate::vehicle::{Vehicle, VehicleInput};

/// Results that the user gives instead of models.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Given {
    /// Thickness of the forebody's heat shield, m.
    pub forebody_tps_m: Option<f64>,
    /// Thickness of the aftbody's heat shield, m.
    pub aftbody_tps_m: Option<f64>,
    /// Peak temperature of the payload, K.
    pub payload_temperature_k: Option<f64>,
}

/// A design problem.
#[derive(Clone, Debug)]
pub struct DesignInput {
    /// Planet, atmosphere, wind, entry, heating, stop, solver.
    pub mission: Mission,
    /// The vehicle; its heat-shield thicknesses and loads are first guesses, which the passes replace.
    pub vehicle: VehicleInput,
    /// Results that the user gives instead of models.
    pub given: Given,
    /// Heat-shield material of the forebody.
    pub forebody_material: TpsMaterial,
    /// Heat-shield material of the aftbody.
    pub aftbody_material: TpsMaterial,
    /// Thermal soak with the forebody's heat shield.
    pub soak: SoakCorrelation,
    /// Trajectory space of the mass-estimating relations.
    pub fit_space: FitSpace,
    /// Environment of the aftbody as fractions of that of the forebody.
    pub afterbody: Afterbody,
    /// Heating of the shoulder relative to that of the stagnation point.
    pub shoulder: Shoulder,
    /// Point at which the forebody's heat shield is sized.
    pub judged_at: JudgedAt,
    /// Drag coefficient against Mach number.
    pub drag: DesignDrag,
    /// Estimated distance of the entry mass from its fixed point below which a design is converged, kg.
    pub mass_criterion_kg: f64,
    /// Largest number of passes; after it the answer is given without convergence.
    pub max_iterations: u32,
    /// Fraction of a change that a pass applies where earlier passes do not yet explain it.
    pub relaxation: f64,
}

impl DesignInput {
    /// Body of a vehicle for the flight; `before` is that of the pass before, whose tables are used again.
    pub fn body(&self, vehicle: &Vehicle, before: Option<Body>) -> Body {
        let drag = match (before, &self.drag) {
            (Some(Body { drag, .. }), DesignDrag::Table(_)) => drag,
            _ => Drag::Table(self.drag.of(vehicle)),
        };
        Body {
            mass_kg: vehicle.mass.mass_kg,
            reference_area_m2: vehicle.dimensions.reference_area_m2,
            nose_radius_m: vehicle.dimensions.nose_radius_m,
            drag,
            reference_length_m: vehicle.dimensions.diameter_m,
            freedom: Freedom::Ballistic,
        }
    }
}
