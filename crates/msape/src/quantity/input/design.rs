//! Inputs of a design: the report's run page and what it holds fixed.

use super::{Choices, Group, Input, Kind, Need, Preset, Range};
use crate::units::Dimension;

const RUN_PAGE: &str = "NASA/TM-2014-218507, Appendix D, run page";
const REPORT_VEHICLE: &str = "NASA/TM-2014-218507, section 3.1";
const IMPACT: &str = "NASA/TM-2014-218507, section 3.1.5";
const ASSUMED: &str = "assumed: not printed in NASA/TM-2014-218507";

const GIVEN: &str = "NASA/TM-2014-218507, section 1: hooks to high-fidelity analysis";

const RATIO: Range = Range::above(0.0, 1.0);

const fn density(key: &'static str, label: &'static str) -> Input {
    Input::number(key, label, Group::Densities, Dimension::Density, Range::above(0.0, 25_000.0))
        .unit("kg/m^3")
        .help("Density of the component; when absent, that of the vehicle's data file or of the chosen material.", ASSUMED)
}

const fn mass(key: &'static str, label: &'static str) -> Input {
    Input::number(key, label, Group::Densities, Dimension::Mass, Range::closed(0.0, 10_000.0))
        .unit("kg")
        .help("Mass of the component before the margin, found elsewhere, in place of its density; its shape stays that of the rules.", GIVEN)
}

const fn thickness(key: &'static str, label: &'static str) -> Input {
    Input::number(key, label, Group::HeatShield, Dimension::Length, Range::closed(0.001, 1.0))
        .unit("cm")
        .help("Thickness found elsewhere, in place of that of the mass-estimating relation, which is told beside it.", GIVEN)
}

pub(super) const INPUTS: &[Input] = &[
    Input::new("design.msr_mode", "MSR Mode", Group::Vehicle, Kind::Flag)
        .preset(Preset::Flag(true))
        .basic()
        .help("Whether the payload sits in a foam-filled impact sphere with a shell (MSR), or is nested in impact foam.", RUN_PAGE),
    Input::number("design.diameter_m", "Input Vehicle Diameter", Group::Vehicle, Dimension::Length, Range::above(0.0, 20.0))
        .unit("m")
        .usual(0.5, 2.0)
        .preset(Preset::Number(1.0))
        .need(Need::Design)
        .basic()
        .help("Largest diameter of the vehicle; it grows when the payload does not fit.", RUN_PAGE),
    Input::number("design.nose_radius_ratio", "Nose Radius / Vehicle Radius", Group::Vehicle, Dimension::One, Range::above(0.0, 1.5))
        .usual(0.25, 0.9)
        .preset(Preset::Number(0.75))
        .need(Need::Design)
        .basic()
        .help("Radius of the nose as a fraction of the vehicle radius.", RUN_PAGE),
    Input::number("design.shoulder_radius_ratio", "Input Shoulder Radius / Vehicle Radius", Group::Vehicle, Dimension::One, Range::above(0.0, 0.5))
        .usual(0.02, 0.1)
        .preset(Preset::Number(0.05))
        .need(Need::Design)
        .basic()
        .help("Radius of the shoulder as a fraction of the vehicle radius; it changes when the wing or the heat shield asks for it.", RUN_PAGE),
    Input::number("design.cone_half_angle_deg", "Forebody Cone Angle", Group::Vehicle, Dimension::Angle, Range::closed(45.0, 70.0))
        .unit("deg")
        .usual(45.0, 70.0)
        .preset(Preset::Number(60.0))
        .help("Half-angle of the forebody cone.", REPORT_VEHICLE),
    Input::number("design.payload_mass_kg", "Payload Mass", Group::Payload, Dimension::Mass, Range::closed(1e-6, 1_000.0))
        .unit("kg")
        .usual(5.0, 20.0)
        .preset(Preset::Number(15.0))
        .need(Need::Design)
        .basic()
        .help("Mass of sample and canister; the mass margin does not touch it.", RUN_PAGE),
    Input::number("design.payload_density_kg_m3", "Payload Density", Group::Payload, Dimension::Density, Range::above(0.0, 25_000.0))
        .unit("kg/m^3")
        .usual(500.0, 8_000.0)
        .basic()
        .help("Mean density of the payload, a sphere; gives its diameter.", REPORT_VEHICLE),
    Input::number("design.payload_diameter_m", "Payload Diameter", Group::Payload, Dimension::Length, Range::above(0.0, 5.0))
        .unit("m")
        .usual(0.1, 0.6)
        .basic()
        .help("Diameter of the payload, a sphere, instead of its density.", REPORT_VEHICLE),
    Input::number("design.payload_diameter_ratio", "Payload Diameter / Vehicle Diameter", Group::Payload, Dimension::One, RATIO)
        .usual(0.2, 0.6)
        .basic()
        .help("Diameter of the payload as a fraction of the input vehicle diameter, instead of its density.", RUN_PAGE),
    Input::new("design.forebody_tps", "Forebody TPS Concept", Group::HeatShield, Kind::Choice(Choices::ForebodyConcepts))
        .preset(Preset::Name("pica-al-5056"))
        .basic()
        .help("Heat shield, bond and carrier structure of the forebody together.", RUN_PAGE),
    Input::new("design.aftbody_tps", "Aftbody TPS Concept", Group::HeatShield, Kind::Choice(Choices::AftbodyMaterials))
        .preset(Preset::Name("sirca"))
        .basic()
        .help("Heat-shield material of the aftbody.", RUN_PAGE),
    thickness("design.forebody_tps_thickness_m", "Given Forebody TPS Thickness"),
    thickness("design.aftbody_tps_thickness_m", "Given Aftbody TPS Thickness"),
    Input::number("design.payload_temperature_k", "Given Payload Temperature", Group::HeatShield, Dimension::Temperature, Range::closed(50.0, 2_000.0))
        .unit("K")
        .help("Peak temperature of the payload found elsewhere, in place of that of the soak correlation, which is told beside it.", GIVEN),
    Input::number("design.mass_margin", "Mass Margin", Group::Margins, Dimension::One, Range::closed(0.0, 5.0))
        .usual(0.0, 1.0)
        .preset(Preset::Number(0.3))
        .basic()
        .help("Fraction added to the mass of every component but the payload.", RUN_PAGE),
    Input::number("design.crush_load_limit_earth_g", "Crush Load Limit", Group::Impact, Dimension::Load, Range::above(0.0, 1e6))
        .unit("g's")
        .usual(500.0, 5_000.0)
        .preset(Preset::Number(3_500.0))
        .basic()
        .help("Design impact load of the payload on a rigid surface; a higher one needs less stroke. Not printed; 3500 g is assumed, with which the vehicle of Table 15 closes.", IMPACT),
    Input::number("design.stroke_efficiency", "Stroke Efficiency", Group::Impact, Dimension::One, RATIO)
        .usual(0.3, 0.5)
        .help("Fraction of the foam thickness that can be crushed; when absent, the end of the plateau of the foam in use (for a slab less half of its elastic strain). A larger one is reduced to it.", IMPACT),
    Input::new(
        "design.foam_strength",
        "Foam Strength",
        Group::Impact,
        Kind::Choice(Choices::Fixed(&[("crush-law", "Crush law"), ("equation-6", "Equation 6")])),
    )
    .preset(Preset::Name("crush-law"))
    .help("Where the crush strength of the impact foam comes from: the law by which the landing is judged, with which the payload keeps its limit, or equation 6 as printed, over the payload's cross-section.", IMPACT),
    Input::new("design.ground", "Ground", Group::Impact, Kind::Choice(Choices::Grounds))
        .preset(Preset::Name("uttr-clay"))
        .help("Ground on which the vehicle lands; the load on a rigid surface is shown beside it.", IMPACT),
    Input::new(
        "design.crushing_mass",
        "Crushing Mass",
        Group::Impact,
        Kind::Choice(Choices::Fixed(&[("payload", "Payload"), ("impact-sphere", "Impact sphere with payload")])),
    )
    .preset(Preset::Name("payload"))
    .help("Mass that crushes the impact foam in the crush dynamics: the payload alone, as equations 4 and 6 have it, or the whole impact sphere of the MSR concept. The foam is made for the payload alone.", IMPACT),
    Input::number("design.terminal_drag_coefficient", "Terminal Drag Coefficient", Group::Models, Dimension::One, Range::above(0.0, 5.0))
        .usual(0.5, 1.1)
        .preset(Preset::Number(0.73))
        .help("Axial-force coefficient below Mach 0.5. Equation 7 prints 0.654; 0.73 gives the terminal velocity of Table 15 and is calibrated on it.", "NASA/TM-2014-218507, equation 7 and Table 15"),
    Input::new("design.aerodynamics", "Aerodynamics", Group::Models, Kind::Choice(Choices::DesignAerodynamics))
        .preset(Preset::Name("outline"))
        .help("Axial force above Mach 0.5: computed from the outline of each pass, or a table by name whatever the outline.", "NASA/TM-2014-218507, section 3.3"),
    density("design.density_kg_m3.forebody_tps", "Forebody TPS Density"),
    density("design.density_kg_m3.forebody_carrier_structure", "Forebody Carrier Structure Density"),
    density("design.density_kg_m3.aftbody_tps", "Aftbody TPS Density"),
    density("design.density_kg_m3.aftbody_carrier_structure", "Aftbody Carrier Structure Density"),
    density("design.density_kg_m3.primary_structure", "Primary Structure Density"),
    density("design.density_kg_m3.impact_foam", "Foam Density"),
    Input::number("design.density_kg_m3.impact_panels", "Impact Panels Density", Group::Densities, Dimension::Density, Range::closed(0.0, 25_000.0))
        .unit("kg/m^3")
        .help("Radial composite panels of the MSR impact sphere, smeared over its foam and added to it; when absent, that of the vehicle's data file, which is calibrated on Table 15.", ASSUMED),
    density("design.density_kg_m3.impact_shell", "Impact Shell Density"),
    density("design.density_kg_m3.body_foam", "Body Foam Density"),
    density("design.density_kg_m3.lid_insulation", "Lid Density"),
    density("design.density_kg_m3.wing_insulation", "Wing Insulation Density"),
    mass("design.component_mass_kg.forebody_tps", "Given Forebody TPS Mass"),
    mass("design.component_mass_kg.bond", "Given Bond Mass"),
    mass("design.component_mass_kg.forebody_carrier_structure", "Given Forebody Carrier Structure Mass"),
    mass("design.component_mass_kg.aftbody_tps", "Given Aftbody TPS Mass"),
    mass("design.component_mass_kg.aftbody_carrier_structure", "Given Aftbody Carrier Structure Mass"),
    mass("design.component_mass_kg.primary_structure", "Given Primary Structure Mass"),
    mass("design.component_mass_kg.wing_insulation", "Given Wing Insulation Mass"),
    mass("design.component_mass_kg.impact_foam", "Given Impact Foam Mass"),
    mass("design.component_mass_kg.impact_shell", "Given Impact Shell Mass"),
    mass("design.component_mass_kg.body_foam", "Given Body Foam Mass"),
    mass("design.component_mass_kg.lid_insulation", "Given Lid Insulation Mass"),
    Input::number("design.mass_criterion_kg", "Mass Convergence Criterion", Group::Solver, Dimension::Mass, Range::above(0.0, 10.0))
        .unit("kg")
        .usual(0.0001, 1.0)
        .preset(Preset::Number(0.001))
        .basic()
        .help("A design is converged when its entry mass is estimated to be no further than this from where further passes would lead it.", RUN_PAGE),
    Input::number("design.max_iterations", "Max Number of Iterations", Group::Solver, Dimension::One, Range::closed(1.0, 10_000.0))
        .usual(1.0, 200.0)
        .whole()
        .preset(Preset::Number(20.0))
        .basic()
        .help("Passes through the modules after which an answer that has not converged is given as it is.", RUN_PAGE),
    Input::number("design.relaxation", "Relaxation", Group::Solver, Dimension::One, Range::above(0.0, 1.5))
        .usual(0.3, 1.0)
        .preset(Preset::Number(1.0))
        .help("Fraction of a change that a pass applies where earlier passes do not yet tell how the change goes on; the answer does not depend on it.", "convention of this program"),
];
