//! Inputs of a vehicle: those of section 3.1.1 of the report and the data that the rules need.

use crate::vehicle::impact::Ground;
use crate::vehicle::impact::foam::FoamKind;
use crate::vehicle::kinds::FoamGrade;
use crate::vehicle::kinds::{
    ComponentDensities, ComponentKind, Concept, CrushingMass, FoamStrength,
};
use crate::vehicle::material::Materials;
use crate::vehicle::rules::Rules;
use crate::vehicle::structure::{Carrier, StructureLoads};
use numerics::math::PI;
use numerics::scalar::Single;
use numerics::scalar::functions::cbrt;
use serde::{Deserialize, Serialize};

/// How the size of the payload, a ball, is given.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum PayloadSize<S = f64> {
    /// Mean density, kg/m³.
    DensityKgM3(S),
    /// Diameter, m.
    DiameterM(S),
    /// Diameter as a fraction of the requested vehicle diameter.
    DiameterRatio(S),
}

/// Inputs of the landing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ImpactInput<S = f64> {
    /// Design load of the payload, Earth g.
    pub crush_load_limit_earth_g: S,
    /// Usable fraction of the foam's thickness; `None` takes the end of the plateau of the foam in use.
    pub stroke_efficiency: Option<S>,
    /// The ground.
    pub ground: Ground,
    /// Law that determines the strength of the foam.
    pub foam_strength: FoamStrength,
    /// How the foam crushes.
    pub foam: FoamKind,
    /// Mass that crushes the foam.
    pub crushing_mass: CrushingMass,
}

/// Heat shield, bond and carrier of the forebody.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LayerStack<S = f64> {
    /// Thickness of the heat shield, m.
    pub tps_thickness_m: S,
    /// Density of the heat shield, kg/m³.
    pub tps_density_kg_m3: S,
    /// Thickness of the bond, m.
    pub bond_thickness_m: S,
    /// Density of the bond, kg/m³.
    pub bond_density_kg_m3: S,
    /// Thickness of the carrier structure, m; `None` has it sized by the structural rules.
    pub carrier_thickness_m: Option<S>,
    /// Material and build of the carrier structure.
    pub carrier: Carrier<S>,
}

/// Loads from the flight.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Loads<S = f64> {
    /// Peak deceleration in flight, Earth g.
    pub entry_load_earth_g: S,
    /// Peak stagnation pressure, Pa.
    pub peak_stagnation_pressure_pa: S,
    /// Speed at impact, m/s.
    pub terminal_speed_m_s: S,
}

/// Everything that determines a vehicle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct VehicleInput<S = f64> {
    /// Concept.
    pub concept: Concept,
    /// Requested diameter, m.
    pub diameter_m: S,
    /// Nose radius over vehicle radius.
    pub nose_radius_ratio: S,
    /// Shoulder radius over vehicle radius.
    pub shoulder_radius_ratio: S,
    /// Angle between axis and cone, rad.
    pub cone_half_angle_rad: S,
    /// Mass of the payload, kg.
    pub payload_mass_kg: S,
    /// Size of the payload.
    pub payload_size: PayloadSize<S>,
    /// Margin on the mass of everything but the payload, as a fraction.
    pub mass_margin: S,
    /// Layers of the forebody.
    pub forebody: LayerStack<S>,
    /// Thickness of the aftbody's heat shield, m.
    pub aftbody_tps_thickness_m: S,
    /// Density of the aftbody's heat shield, kg/m³.
    pub aftbody_tps_density_kg_m3: S,
    /// Material and build of the aftbody's carrier structure.
    pub aftbody_carrier: Carrier<S>,
    /// Material and build of the primary structure.
    pub primary_carrier: Carrier<S>,
    /// Densities of the fillings.
    pub densities: ComponentDensities<S>,
    /// Masses of components that the user gives, kg, before the margin.
    pub given_masses: Vec<(ComponentKind, S)>,
    /// Material of each component, and source of its density.
    pub materials: Materials,
    /// Loads of flight and landing.
    pub loads: Loads<S>,
    /// Factors of the structural rules.
    pub structure_loads: StructureLoads<S>,
    /// Crush load limit, stroke efficiency, ground.
    pub impact: ImpactInput<S>,
    /// Foam grades by rising density, for judging the requested strength.
    pub foam_grades: Vec<FoamGrade>,
    /// Constants of the geometry.
    pub rules: Rules,
}

impl<S: Single> VehicleInput<S> {
    /// Mass of a component that the user gives, kg, before the margin.
    pub fn given_mass_kg(&self, kind: ComponentKind) -> Option<S> {
        let mut given = self.given_masses.iter();
        given
            .find(|(of, _)| *of == kind)
            .map(|(_, mass_kg)| *mass_kg)
    }

    /// Diameter of the payload, m.
    pub fn payload_diameter_m(&self) -> S {
        match self.payload_size {
            PayloadSize::DensityKgM3(density) => cbrt(self.payload_mass_kg * 6.0 / (density * PI)),
            PayloadSize::DiameterM(diameter_m) => diameter_m,
            PayloadSize::DiameterRatio(ratio) => ratio * self.diameter_m,
        }
    }

    /// Density of the payload, a ball, kg/m³.
    pub fn payload_density_kg_m3(&self) -> S {
        let diameter = self.payload_diameter_m();
        self.payload_mass_kg / (diameter * (PI / 6.0) * diameter * diameter)
    }
}

impl VehicleInput {
    /// Fault of the numbers, as one sentence; `None` if a vehicle can be laid out.
    pub fn fault(&self) -> Option<String> {
        let positive = [
            ("diameter_m", self.diameter_m),
            ("nose_radius_ratio", self.nose_radius_ratio),
            ("shoulder_radius_ratio", self.shoulder_radius_ratio),
            ("payload_mass_kg", self.payload_mass_kg),
            ("payload_diameter_m", self.payload_diameter_m()),
            (
                "crush_load_limit_earth_g",
                self.impact.crush_load_limit_earth_g,
            ),
            (
                "stroke_efficiency",
                self.impact.stroke_efficiency.unwrap_or(1.0),
            ),
        ];
        let not_negative = [
            ("mass_margin", self.mass_margin),
            ("forebody_tps_thickness_m", self.forebody.tps_thickness_m),
            ("bond_thickness_m", self.forebody.bond_thickness_m),
            (
                "carrier_thickness_m",
                self.forebody.carrier_thickness_m.unwrap_or(0.0),
            ),
            ("aftbody_tps_thickness_m", self.aftbody_tps_thickness_m),
            ("entry_load_earth_g", self.loads.entry_load_earth_g),
            (
                "peak_stagnation_pressure_pa",
                self.loads.peak_stagnation_pressure_pa,
            ),
            ("terminal_speed_m_s", self.loads.terminal_speed_m_s),
        ];
        let bad = |(name, value): (&str, f64), least: &str| {
            format!("{name}: got {value}, must be {least}")
        };
        if let Some(&pair) = positive.iter().find(|(_, v)| !(v.is_finite() && *v > 0.0)) {
            return Some(bad(pair, "above 0"));
        }
        if let Some(&pair) = not_negative
            .iter()
            .find(|(_, v)| !(v.is_finite() && *v >= 0.0))
        {
            return Some(bad(pair, "at least 0"));
        }
        let angle_deg = self.cone_half_angle_rad / numerics::math::RADIANS_PER_DEGREE;
        if !(10.0..=84.0).contains(&angle_deg) {
            return Some(bad(("cone_half_angle_deg", angle_deg), "from 10 to 84 deg"));
        }
        None
    }
}
