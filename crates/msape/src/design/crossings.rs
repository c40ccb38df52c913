//! Values passed between the modules: the entries of the design structure matrix off its diagonal.
//!
//! # References
//! - \[samareh-2014\] Figure 4.

use super::flown::Flown;
use super::sized::Sized;
use crate::quantity::Module;
use crate::units::Dimension;
use crate::vehicle::Vehicle;

/// Data of a pass from which the modules give values to others.
pub(super) struct Crossed<'a> {
    pub(super) vehicle: &'a Vehicle,
    pub(super) flown: &'a Flown,
    pub(super) sized: &'a Sized,
}

impl Crossed<'_> {
    /// The value of each crossing.
    pub(super) fn values(&self) -> [f64; CROSSINGS.len()] {
        CROSSINGS.each_ref().map(|crossing| (crossing.get)(self))
    }
}

/// Value that one module gives to others.
#[derive(Clone, Copy)]
pub struct Crossing {
    /// Key with its SI unit.
    pub key: &'static str,
    /// Label.
    pub label: &'static str,
    /// Physical dimension.
    pub dimension: Dimension,
    /// Symbol of the unit shown by default.
    pub unit: &'static str,
    /// Module that computes the value.
    pub from: Module,
    /// Modules that use the value.
    pub to: &'static [Module],
    /// Function that returns the value in a pass.
    get: fn(&Crossed) -> f64,
}

/// The modules in the order of the matrix.
pub const MODULES: [Module; 8] = [
    Module::Geometry,
    Module::Mass,
    Module::Impact,
    Module::Structure,
    Module::Flight,
    Module::Heating,
    Module::HeatShield,
    Module::ThermalSoak,
];

const fn crossing(
    key: &'static str,
    label: &'static str,
    (dimension, unit): (Dimension, &'static str),
    from: Module,
    to: &'static [Module],
    get: fn(&Crossed) -> f64,
) -> Crossing {
    Crossing {
        key,
        label,
        dimension,
        unit,
        from,
        to,
        get,
    }
}

const LENGTH: (Dimension, &str) = (Dimension::Length, "m");
const THICKNESS: (Dimension, &str) = (Dimension::Length, "cm");
const MASS: (Dimension, &str) = (Dimension::Mass, "kg");
const SPEED: (Dimension, &str) = (Dimension::Speed, "m/s");
const FLUX: (Dimension, &str) = (Dimension::HeatFlux, "W/cm^2");

/// The crossings; a pass records a value for each.
pub static CROSSINGS: [Crossing; 15] = [
    crossing(
        "diameter_m",
        "Vehicle diameter",
        LENGTH,
        Module::Geometry,
        &[
            Module::Mass,
            Module::Impact,
            Module::Structure,
            Module::Flight,
            Module::ThermalSoak,
        ],
        |s| s.vehicle.dimensions.diameter_m,
    ),
    crossing(
        "nose_radius_m",
        "Nose radius",
        LENGTH,
        Module::Geometry,
        &[Module::Heating, Module::Impact],
        |s| s.vehicle.dimensions.nose_radius_m,
    ),
    crossing(
        "cg_m",
        "Center of gravity from virtual apex",
        LENGTH,
        Module::Mass,
        &[Module::Geometry],
        |s| s.vehicle.mass.cg_x_m,
    ),
    crossing(
        "total_entry_mass_kg",
        "Entry mass",
        MASS,
        Module::Mass,
        &[Module::Impact, Module::Structure, Module::Flight],
        |s| s.vehicle.mass.mass_kg,
    ),
    crossing(
        "required_stroke_m",
        "Required stroke",
        THICKNESS,
        Module::Impact,
        &[Module::Geometry],
        |s| s.vehicle.impact.required_stroke_m,
    ),
    crossing(
        "impact_foam_density_kg_m3",
        "Impact foam density",
        (Dimension::Density, "kg/m^3"),
        Module::Impact,
        &[Module::Mass],
        |s| s.vehicle.impact.foam_density_kg_m3,
    ),
    crossing(
        "forebody_carrier_thickness_m",
        "Forebody carrier thickness",
        THICKNESS,
        Module::Structure,
        &[Module::Geometry, Module::Mass],
        |s| s.vehicle.structure.forebody.thickness_m,
    ),
    crossing(
        "primary_structure_thickness_m",
        "Primary structure thickness",
        THICKNESS,
        Module::Structure,
        &[Module::Geometry, Module::Mass],
        |s| s.vehicle.structure.primary.thickness_m,
    ),
    crossing(
        "terminal_speed_m_s",
        "Terminal velocity",
        SPEED,
        Module::Flight,
        &[Module::Impact],
        |s| s.flown.impact_speed_m_s,
    ),
    crossing(
        "entry_load_earth_g",
        "Entry load",
        (Dimension::Load, "Earth g"),
        Module::Flight,
        &[Module::Structure],
        |s| s.flown.flight.peak_deceleration_earth_g.value,
    ),
    crossing(
        "peak_stagnation_pressure_pa",
        "Stagnation pressure",
        (Dimension::Pressure, "kPa"),
        Module::Flight,
        &[Module::Structure, Module::HeatShield],
        |s| s.flown.flight.peak_stagnation_pressure_pa.value,
    ),
    crossing(
        "peak_total_margined_heat_flux_w_m2",
        "Peak heat rate (margined)",
        FLUX,
        Module::Heating,
        &[Module::HeatShield, Module::ThermalSoak],
        |s| s.sized.stagnation.peak_heat_flux_w_m2,
    ),
    crossing(
        "total_margined_heat_load_j_m2",
        "Heat load (margined)",
        (Dimension::HeatLoad, "J/cm^2"),
        Module::Heating,
        &[Module::HeatShield, Module::ThermalSoak],
        |s| s.sized.stagnation.heat_load_j_m2,
    ),
    crossing(
        "forebody_tps_thickness_m",
        "Forebody TPS thickness",
        THICKNESS,
        Module::HeatShield,
        &[Module::Geometry, Module::Mass],
        |s| s.sized.forebody.thickness_m,
    ),
    crossing(
        "aftbody_tps_thickness_m",
        "Aftbody TPS thickness",
        THICKNESS,
        Module::HeatShield,
        &[Module::Geometry, Module::Mass],
        |s| s.sized.aftbody.thickness_m,
    ),
];
