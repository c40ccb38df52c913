//! Inputs of a design: the report's run page and what it holds fixed.

use super::{Alternatives, Choices, Group, Input, Kind, Need, Preset, RUN_PAGE, Range};
use crate::quantity::Task;
use crate::quantity::choice::{Choice, CrushingMass, FoamStrength};
use crate::units::Dimension;

const REPORT_VEHICLE: &str = "NASA/TM-2014-218507, section 3.1";
const IMPACT: &str = "NASA/TM-2014-218507, section 3.1.5";
const ASSUMED: &str = "assumed: not printed in NASA/TM-2014-218507";
const GIVEN: &str = "NASA/TM-2014-218507, section 1: hooks to high-fidelity analysis";

const RATIO: Range = Range::above(0.0, 1.0);

const fn density(label: &'static str) -> Input {
    Input::number(label, Group::Densities, Dimension::Density, Range::above(0.0, 25_000.0))
        .unit("kg/m^3")
        .help("Density of the component; when absent, that of the vehicle's data file or of the chosen material.", ASSUMED)
}

const fn mass(label: &'static str) -> Input {
    Input::number(label, Group::Densities, Dimension::Mass, Range::closed(0.0, 10_000.0))
        .unit("kg")
        .help("Mass of the component before the margin, found elsewhere, in place of its density; its shape stays that of the rules.", GIVEN)
}

const fn thickness(label: &'static str) -> Input {
    Input::number(label, Group::HeatShield, Dimension::Length, Range::closed(0.001, 1.0))
        .unit("cm")
        .help("Thickness found elsewhere, in place of that of the mass-estimating relation, which is told beside it.", GIVEN)
}

/// Alternatives of components: the case gives density or mass.
macro_rules! density_or_mass {
    ($($component:ident = $density:ident, $mass:ident;)+) => {
        $(static $component: Alternatives = Alternatives {
            asked_as: None,
            ways: &[&[&$density], &[&$mass]],
        };)+
    };
}

density_or_mass! {
    MADE_OF_FOREBODY_TPS = DENSITY_KG_M3_FOREBODY_TPS, COMPONENT_MASS_KG_FOREBODY_TPS;
    MADE_OF_FOREBODY_CARRIER_STRUCTURE = DENSITY_KG_M3_FOREBODY_CARRIER_STRUCTURE, COMPONENT_MASS_KG_FOREBODY_CARRIER_STRUCTURE;
    MADE_OF_AFTBODY_TPS = DENSITY_KG_M3_AFTBODY_TPS, COMPONENT_MASS_KG_AFTBODY_TPS;
    MADE_OF_AFTBODY_CARRIER_STRUCTURE = DENSITY_KG_M3_AFTBODY_CARRIER_STRUCTURE, COMPONENT_MASS_KG_AFTBODY_CARRIER_STRUCTURE;
    MADE_OF_PRIMARY_STRUCTURE = DENSITY_KG_M3_PRIMARY_STRUCTURE, COMPONENT_MASS_KG_PRIMARY_STRUCTURE;
    MADE_OF_WING_INSULATION = DENSITY_KG_M3_WING_INSULATION, COMPONENT_MASS_KG_WING_INSULATION;
    MADE_OF_IMPACT_FOAM = DENSITY_KG_M3_IMPACT_FOAM, COMPONENT_MASS_KG_IMPACT_FOAM;
    MADE_OF_IMPACT_SHELL = DENSITY_KG_M3_IMPACT_SHELL, COMPONENT_MASS_KG_IMPACT_SHELL;
    MADE_OF_BODY_FOAM = DENSITY_KG_M3_BODY_FOAM, COMPONENT_MASS_KG_BODY_FOAM;
    MADE_OF_LID_INSULATION = DENSITY_KG_M3_LID_INSULATION, COMPONENT_MASS_KG_LID_INSULATION;
}

/// Ways to give the size of the payload.
pub static PAYLOAD_SIZE: Alternatives = Alternatives {
    asked_as: Some("Payload size"),
    ways: &[
        &[&PAYLOAD_DENSITY_KG_M3],
        &[&PAYLOAD_DIAMETER_M],
        &[&PAYLOAD_DIAMETER_RATIO],
    ],
};

inputs! {
    &[Task::Design, Task::DesignedBody];
    MSR_MODE: "design.msr_mode" = Input::new("MSR Mode", Group::Vehicle, Kind::Flag)
        .preset(Preset::Flag(true))
        .basic()
        .help("Whether the payload sits in a foam-filled impact sphere with a shell (MSR), or is nested in impact foam.", RUN_PAGE);
    DIAMETER_M: "design.diameter_m" = Input::number("Input Vehicle Diameter", Group::Vehicle, Dimension::Length, Range::above(0.0, 20.0))
        .unit("m")
        .usual(0.5, 2.0)
        .preset(Preset::Number(1.0))
        .need(Need::Design)
        .basic()
        .help("Largest diameter of the vehicle; it grows when the payload does not fit.", RUN_PAGE);
    NOSE_RADIUS_RATIO: "design.nose_radius_ratio" = Input::number("Nose Radius / Vehicle Radius", Group::Vehicle, Dimension::One, Range::above(0.0, 1.5))
        .usual(0.25, 0.9)
        .preset(Preset::Number(0.75))
        .need(Need::Design)
        .basic()
        .help("Radius of the nose as a fraction of the vehicle radius.", RUN_PAGE);
    SHOULDER_RADIUS_RATIO: "design.shoulder_radius_ratio" = Input::number("Input Shoulder Radius / Vehicle Radius", Group::Vehicle, Dimension::One, Range::above(0.0, 0.5))
        .usual(0.02, 0.1)
        .preset(Preset::Number(0.05))
        .need(Need::Design)
        .basic()
        .help("Radius of the shoulder as a fraction of the vehicle radius; it changes when the wing or the heat shield asks for it.", RUN_PAGE);
    CONE_HALF_ANGLE_DEG: "design.cone_half_angle_deg" = Input::number("Forebody Cone Angle", Group::Vehicle, Dimension::Angle, Range::closed(45.0, 70.0))
        .unit("deg")
        .usual(45.0, 70.0)
        .preset(Preset::Number(60.0))
        .help("Half-angle of the forebody cone.", REPORT_VEHICLE);
    PAYLOAD_MASS_KG: "design.payload_mass_kg" = Input::number("Payload Mass", Group::Payload, Dimension::Mass, Range::closed(1e-6, 1_000.0))
        .unit("kg")
        .usual(5.0, 20.0)
        .preset(Preset::Number(15.0))
        .need(Need::Design)
        .basic()
        .help("Mass of sample and canister; the mass margin does not touch it.", RUN_PAGE);
    PAYLOAD_DENSITY_KG_M3: "design.payload_density_kg_m3" = Input::number("Payload Density", Group::Payload, Dimension::Density, Range::above(0.0, 25_000.0))
        .unit("kg/m^3")
        .usual(500.0, 8_000.0)
        .basic()
        .one_way_of(&PAYLOAD_SIZE)
        .help("Mean density of the payload, a sphere; gives its diameter.", REPORT_VEHICLE);
    PAYLOAD_DIAMETER_M: "design.payload_diameter_m" = Input::number("Payload Diameter", Group::Payload, Dimension::Length, Range::above(0.0, 5.0))
        .unit("m")
        .usual(0.1, 0.6)
        .basic()
        .one_way_of(&PAYLOAD_SIZE)
        .help("Diameter of the payload, a sphere, instead of its density.", REPORT_VEHICLE);
    PAYLOAD_DIAMETER_RATIO: "design.payload_diameter_ratio" = Input::number("Payload Diameter / Vehicle Diameter", Group::Payload, Dimension::One, RATIO)
        .usual(0.2, 0.6)
        .basic()
        .one_way_of(&PAYLOAD_SIZE)
        .help("Diameter of the payload as a fraction of the input vehicle diameter, instead of its density.", RUN_PAGE);
    FOREBODY_TPS: "design.forebody_tps" = Input::new("Forebody TPS Concept", Group::HeatShield, Kind::Choice(Choices::ForebodyConcepts))
        .preset(Preset::Name("pica-al-5056"))
        .basic()
        .help("Heat shield, bond and carrier structure of the forebody together.", RUN_PAGE);
    AFTBODY_TPS: "design.aftbody_tps" = Input::new("Aftbody TPS Concept", Group::HeatShield, Kind::Choice(Choices::AftbodyMaterials))
        .preset(Preset::Name("sirca"))
        .basic()
        .help("Heat-shield material of the aftbody.", RUN_PAGE);
    FOREBODY_TPS_THICKNESS_M: "design.forebody_tps_thickness_m" = thickness("Given Forebody TPS Thickness");
    AFTBODY_TPS_THICKNESS_M: "design.aftbody_tps_thickness_m" = thickness("Given Aftbody TPS Thickness");
    PAYLOAD_TEMPERATURE_K: "design.payload_temperature_k" = Input::number("Given Payload Temperature", Group::HeatShield, Dimension::Temperature, Range::closed(50.0, 2_000.0))
        .unit("K")
        .help("Peak temperature of the payload found elsewhere, in place of that of the soak correlation, which is told beside it.", GIVEN);
    MASS_MARGIN: "design.mass_margin" = Input::number("Mass Margin", Group::Margins, Dimension::One, Range::closed(0.0, 5.0))
        .usual(0.0, 1.0)
        .preset(Preset::Number(0.3))
        .basic()
        .help("Fraction added to the mass of every component but the payload.", RUN_PAGE);
    CRUSH_LOAD_LIMIT_EARTH_G: "design.crush_load_limit_earth_g" = Input::number("Crush Load Limit", Group::Impact, Dimension::Load, Range::above(0.0, 1e6))
        .unit("g's")
        .usual(500.0, 5_000.0)
        .preset(Preset::Number(3_500.0))
        .basic()
        .help("Design impact load of the payload on a rigid surface; a higher one needs less stroke. Not printed; 3500 g is assumed, with which the vehicle of Table 15 closes.", IMPACT);
    STROKE_EFFICIENCY: "design.stroke_efficiency" = Input::number("Stroke Efficiency", Group::Impact, Dimension::One, RATIO)
        .usual(0.3, 0.5)
        .help("Fraction of the foam thickness that can be crushed; when absent, the end of the plateau of the foam in use (for a slab less half of its elastic strain). A larger one is reduced to it.", IMPACT);
    FOAM_STRENGTH: "design.foam_strength" = Input::new("Foam Strength", Group::Impact, Kind::Choice(FoamStrength::CHOICES))
        .preset(Preset::Name(FoamStrength::CrushLaw.name()))
        .help("Where the crush strength of the impact foam comes from: the law by which the landing is judged, with which the payload keeps its limit, or equation 6 as printed, over the payload's cross-section.", IMPACT);
    GROUND: "design.ground" = Input::new("Ground", Group::Impact, Kind::Choice(Choices::Grounds))
        .preset(Preset::Name("uttr-clay"))
        .help("Ground on which the vehicle lands; the load on a rigid surface is shown beside it.", IMPACT);
    CRUSHING_MASS: "design.crushing_mass" = Input::new("Crushing Mass", Group::Impact, Kind::Choice(CrushingMass::CHOICES))
        .preset(Preset::Name(CrushingMass::Payload.name()))
        .help("Mass that crushes the impact foam in the crush dynamics: the payload alone, as equations 4 and 6 have it, or the whole impact sphere of the MSR concept. The foam is made for the payload alone.", IMPACT);
    TERMINAL_DRAG_COEFFICIENT: "design.terminal_drag_coefficient" = Input::number("Terminal Drag Coefficient", Group::Models, Dimension::One, Range::above(0.0, 5.0))
        .usual(0.5, 1.1)
        .preset(Preset::Number(0.73))
        .help("Axial-force coefficient below Mach 0.5. Equation 7 prints 0.654; 0.73 gives the terminal velocity of Table 15 and is calibrated on it.", "NASA/TM-2014-218507, equation 7 and Table 15");
    AERODYNAMICS: "design.aerodynamics" = Input::new("Aerodynamics", Group::Models, Kind::Choice(Choices::DesignAerodynamics))
        .preset(Preset::Name("outline"))
        .help("Axial force above Mach 0.5: computed from the outline of each pass, or a table by name whatever the outline.", "NASA/TM-2014-218507, section 3.3");
    DENSITY_KG_M3_FOREBODY_TPS: "design.density_kg_m3.forebody_tps" = density("Forebody TPS Density").one_way_of(&MADE_OF_FOREBODY_TPS);
    DENSITY_KG_M3_FOREBODY_CARRIER_STRUCTURE: "design.density_kg_m3.forebody_carrier_structure" = density("Forebody Carrier Structure Density").one_way_of(&MADE_OF_FOREBODY_CARRIER_STRUCTURE);
    DENSITY_KG_M3_AFTBODY_TPS: "design.density_kg_m3.aftbody_tps" = density("Aftbody TPS Density").one_way_of(&MADE_OF_AFTBODY_TPS);
    DENSITY_KG_M3_AFTBODY_CARRIER_STRUCTURE: "design.density_kg_m3.aftbody_carrier_structure" = density("Aftbody Carrier Structure Density").one_way_of(&MADE_OF_AFTBODY_CARRIER_STRUCTURE);
    DENSITY_KG_M3_PRIMARY_STRUCTURE: "design.density_kg_m3.primary_structure" = density("Primary Structure Density").one_way_of(&MADE_OF_PRIMARY_STRUCTURE);
    DENSITY_KG_M3_IMPACT_FOAM: "design.density_kg_m3.impact_foam" = density("Foam Density").one_way_of(&MADE_OF_IMPACT_FOAM);
    DENSITY_KG_M3_IMPACT_PANELS: "design.density_kg_m3.impact_panels" = Input::number("Impact Panels Density", Group::Densities, Dimension::Density, Range::closed(0.0, 25_000.0))
        .unit("kg/m^3")
        .help("Radial composite panels of the MSR impact sphere, smeared over its foam and added to it; when absent, that of the vehicle's data file, which is calibrated on Table 15.", ASSUMED);
    DENSITY_KG_M3_IMPACT_SHELL: "design.density_kg_m3.impact_shell" = density("Impact Shell Density").one_way_of(&MADE_OF_IMPACT_SHELL);
    DENSITY_KG_M3_BODY_FOAM: "design.density_kg_m3.body_foam" = density("Body Foam Density").one_way_of(&MADE_OF_BODY_FOAM);
    DENSITY_KG_M3_LID_INSULATION: "design.density_kg_m3.lid_insulation" = density("Lid Density").one_way_of(&MADE_OF_LID_INSULATION);
    DENSITY_KG_M3_WING_INSULATION: "design.density_kg_m3.wing_insulation" = density("Wing Insulation Density").one_way_of(&MADE_OF_WING_INSULATION);
    COMPONENT_MASS_KG_FOREBODY_TPS: "design.component_mass_kg.forebody_tps" = mass("Given Forebody TPS Mass").one_way_of(&MADE_OF_FOREBODY_TPS);
    COMPONENT_MASS_KG_BOND: "design.component_mass_kg.bond" = mass("Given Bond Mass");
    COMPONENT_MASS_KG_FOREBODY_CARRIER_STRUCTURE: "design.component_mass_kg.forebody_carrier_structure" = mass("Given Forebody Carrier Structure Mass").one_way_of(&MADE_OF_FOREBODY_CARRIER_STRUCTURE);
    COMPONENT_MASS_KG_AFTBODY_TPS: "design.component_mass_kg.aftbody_tps" = mass("Given Aftbody TPS Mass").one_way_of(&MADE_OF_AFTBODY_TPS);
    COMPONENT_MASS_KG_AFTBODY_CARRIER_STRUCTURE: "design.component_mass_kg.aftbody_carrier_structure" = mass("Given Aftbody Carrier Structure Mass").one_way_of(&MADE_OF_AFTBODY_CARRIER_STRUCTURE);
    COMPONENT_MASS_KG_PRIMARY_STRUCTURE: "design.component_mass_kg.primary_structure" = mass("Given Primary Structure Mass").one_way_of(&MADE_OF_PRIMARY_STRUCTURE);
    COMPONENT_MASS_KG_WING_INSULATION: "design.component_mass_kg.wing_insulation" = mass("Given Wing Insulation Mass").one_way_of(&MADE_OF_WING_INSULATION);
    COMPONENT_MASS_KG_IMPACT_FOAM: "design.component_mass_kg.impact_foam" = mass("Given Impact Foam Mass").one_way_of(&MADE_OF_IMPACT_FOAM);
    COMPONENT_MASS_KG_IMPACT_SHELL: "design.component_mass_kg.impact_shell" = mass("Given Impact Shell Mass").one_way_of(&MADE_OF_IMPACT_SHELL);
    COMPONENT_MASS_KG_BODY_FOAM: "design.component_mass_kg.body_foam" = mass("Given Body Foam Mass").one_way_of(&MADE_OF_BODY_FOAM);
    COMPONENT_MASS_KG_LID_INSULATION: "design.component_mass_kg.lid_insulation" = mass("Given Lid Insulation Mass").one_way_of(&MADE_OF_LID_INSULATION);
    MASS_CRITERION_KG: "design.mass_criterion_kg" = Input::number("Mass Convergence Criterion", Group::Solver, Dimension::Mass, Range::above(0.0, 10.0))
        .unit("kg")
        .usual(0.0001, 1.0)
        .preset(Preset::Number(0.001))
        .basic()
        .help("A design is converged when its entry mass is estimated to be no further than this from where further passes would lead it.", RUN_PAGE);
    MAX_ITERATIONS: "design.max_iterations" = Input::number("Max Number of Iterations", Group::Solver, Dimension::One, Range::closed(1.0, 10_000.0))
        .usual(1.0, 200.0)
        .whole()
        .preset(Preset::Number(20.0))
        .basic()
        .help("Passes through the modules after which an answer that has not converged is given as it is.", RUN_PAGE);
    RELAXATION: "design.relaxation" = Input::number("Relaxation", Group::Solver, Dimension::One, Range::above(0.0, 1.5))
        .usual(0.3, 1.0)
        .preset(Preset::Number(1.0))
        .help("Fraction of a change that a pass applies where earlier passes do not yet tell how the change goes on; the answer does not depend on it.", "convention of this program");
}
