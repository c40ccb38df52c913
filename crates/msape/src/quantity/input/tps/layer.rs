//! Inputs of a layer of the heat shield in depth: `[[tps.layer]]`, from the wall inwards.

use crate::quantity::Task;
use crate::quantity::input::repeated::Section;
use crate::quantity::input::{CONVENTION, Group, Input, Kind, Preset, Range};
use crate::units::Dimension;

/// The section.
pub const SECTION: Section = Section {
    name: "tps.layer",
    most: 12,
    help: "A layer: a material by name, or by numbers.",
    list_help: "Layers of a heat shield, from the wall inwards.",
    required: &["thickness_m"],
};

inputs! {
    &[Task::InDepth];
    MATERIAL: "tps.layer.material" = Input::new("Material", Group::HeatShield, Kind::Text)
        .help("Name of a card of data/ablators, or of one of the user's own; otherwise the three numbers below.", CONVENTION);
    THICKNESS_M: "tps.layer.thickness_m" = Input::number("Thickness", Group::HeatShield, Dimension::Length, Range::closed(1e-6, 10.0))
        .unit("cm")
        .help("Thickness of the layer.", CONVENTION);
    DENSITY_KG_M3: "tps.layer.density_kg_m3" = Input::number("Density", Group::HeatShield, Dimension::Density, Range::above(0.0, 25_000.0))
        .unit("kg/m^3")
        .help("Density of a layer given by numbers.", CONVENTION);
    SPECIFIC_HEAT_J_KGK: "tps.layer.specific_heat_j_kgk" = Input::number("Specific Heat", Group::HeatShield, Dimension::SpecificHeat, Range::above(0.0, 1e5))
        .unit("J/(kg K)")
        .help("Heat capacity of a layer given by numbers.", CONVENTION);
    CONDUCTIVITY_W_MK: "tps.layer.conductivity_w_mk" = Input::number("Conductivity", Group::HeatShield, Dimension::Conductivity, Range::above(0.0, 1e5))
        .unit("W/(m K)")
        .help("Conductivity of a layer given by numbers.", CONVENTION);
    EMISSIVITY: "tps.layer.emissivity" = Input::number("Emissivity", Group::HeatShield, Dimension::One, Range::closed(0.0, 1.0))
        .preset(Preset::Number(0.9))
        .help("Emissivity and absorptivity of a wall given by numbers. Assumed where it is not given.", "assumed");
    CONTACT_M2K_W: "tps.layer.contact_m2k_w" = Input::number("Contact Resistance", Group::HeatShield, Dimension::ThermalResistance, Range::closed(0.0, 1e4))
        .unit("m^2 K/W")
        .help("Resistance of the joint with the layer before; none when absent.", CONVENTION);
    GAP_EMISSIVITY: "tps.layer.gap_emissivity" = Input::number("Emissivity Across a Gap", Group::HeatShield, Dimension::One, Range::closed(0.0, 1.0))
        .help("Effective emissivity of a gap to the layer before, across which heat is radiated, in the place of a contact.", CONVENTION);
    GAP_CONDUCTANCE_W_M2K: "tps.layer.gap_conductance_w_m2k" = Input::number("Conductance of a Gap", Group::HeatShield, Dimension::HeatTransfer, Range::closed(0.0, 1e6))
        .unit("W/(m^2 K)")
        .help("Conductance of the gap beside its radiation.", CONVENTION);
}
