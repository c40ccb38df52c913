//! Outputs of the structural rules and of the shell model.

use super::Output;
use crate::answer::Answer;
use crate::design::structural::{Structural, least_margin};
use crate::quantity::Module;
use crate::shell::analysis::{CarrierAnalysis, CaseStress};
use crate::units::Dimension;
use crate::vehicle::WallPlace;

fn structural<T>(answer: &Answer, get: impl Fn(&Structural) -> Option<T>) -> Option<T> {
    answer.design.as_ref()?.structural.as_ref().and_then(get)
}

fn shell(answer: &Answer, get: impl Fn(&CarrierAnalysis) -> Option<f64>) -> Option<f64> {
    structural(answer, |s| s.shell.as_ref().and_then(&get))
}

fn critical(answer: &Answer, wall: WallPlace) -> Option<f64> {
    structural(answer, |s| s.critical(wall).map(|check| check.margin))
}

fn largest_stress_pa(case: &CaseStress) -> Option<f64> {
    case.parts
        .iter()
        .map(|part| part.stress_pa)
        .reduce(f64::max)
}

fn largest_shear_pa(case: &CaseStress) -> Option<f64> {
    let sandwich = case.parts.iter().filter(|part| part.core_margin.is_some());
    sandwich.map(|part| part.shear_pa).reduce(f64::max)
}

fn frequency_hz(shell: &CarrierAnalysis, harmonic: u32) -> Option<f64> {
    let mut list = shell.frequencies.iter();
    list.find(|f| f.harmonic == harmonic)
        .map(|f| f.frequency_hz)
}

const RULES: &str = "NASA/TM-2014-218507, section 3.1.6; NASA SP-8007, SP-8019, SP-8032";
const SHELL: &str = "NASA/TM-2014-218507, section 3.1.6; axisymmetric shell elements";

#[rustfmt::skip]
pub(super) static OUTPUTS: &[Output] = &[
    Output::new("forebody_carrier_structure_margin", "Forebody Carrier Structure Margin of Safety", Module::Structure, |a| critical(a, WallPlace::Forebody))
        .help("Least margin of safety of the structural rules for the wall as built; gauge left out.", RULES),
    Output::new("aftbody_carrier_structure_margin", "Aftbody Carrier Structure Margin of Safety", Module::Structure, |a| critical(a, WallPlace::Aftbody))
        .help("Least margin of safety of the structural rules for the wall as built; gauge left out.", RULES),
    Output::new("primary_structure_margin", "Primary Structure Margin of Safety", Module::Structure, |a| critical(a, WallPlace::Primary))
        .help("Least margin of safety of the structural rules for the wall as built; gauge left out.", RULES),
    Output::new("shell_entry_stress_pa", "Shell Model Entry Stress", Module::Structure, |a| shell(a, |s| largest_stress_pa(&s.entry)))
        .unit(Dimension::Pressure, "MPa")
        .help("Largest equivalent stress in laminate or faces at peak pressure, without safety factor.", SHELL),
    Output::new("shell_entry_core_shear_pa", "Shell Model Entry Core Shear Stress", Module::Structure, |a| shell(a, |s| largest_shear_pa(&s.entry)))
        .unit(Dimension::Pressure, "MPa")
        .help("Largest shear stress in the core of a sandwich at peak pressure, without safety factor.", SHELL),
    Output::new("shell_entry_margin", "Shell Model Entry Margin of Safety", Module::Structure, |a| shell(a, |s| least_margin(&s.entry)))
        .help("Least margin of safety of laminate, faces and core at peak pressure.", SHELL),
    Output::new("shell_entry_displacement_m", "Shell Model Entry Displacement", Module::Structure, |a| shell(a, |s| Some(s.entry.largest_displacement_m)))
        .unit(Dimension::Length, "mm")
        .help("Largest displacement relative to the foot of the lid at peak pressure.", SHELL),
    Output::new("shell_deceleration_earth_g", "Shell Model Deceleration", Module::Structure, |a| shell(a, |s| Some(s.deceleration_earth_g)))
        .unit(Dimension::Load, "g's")
        .help("Deceleration that balances the pressure on the shell model.", SHELL),
    Output::new("shell_launch_stress_pa", "Shell Model Launch Stress", Module::Structure, |a| shell(a, |s| largest_stress_pa(&s.launch)))
        .unit(Dimension::Pressure, "MPa")
        .help("Largest equivalent stress in laminate or faces over all corners of the launch loads, without safety factor.", SHELL),
    Output::new("shell_launch_margin", "Shell Model Launch Margin of Safety", Module::Structure, |a| shell(a, |s| least_margin(&s.launch)))
        .help("Least margin of safety of laminate, faces and core over all corners of the launch loads.", SHELL),
    Output::new("first_frequency_hz", "First Natural Frequency", Module::Structure, |a| shell(a, |s| s.first_frequency().map(|f| f.frequency_hz)))
        .unit(Dimension::Frequency, "Hz")
        .help("Lowest natural frequency of the vehicle held at the foot of the lid.", SHELL),
    Output::new("first_frequency_waves", "First Natural Frequency, Waves round the Axis", Module::Structure, |a| shell(a, |s| s.first_frequency().map(|f| f64::from(f.harmonic))))
        .help("Number of waves round the axis of the mode of the lowest frequency.", SHELL),
    Output::new("first_axial_frequency_hz", "First Axial Frequency", Module::Structure, |a| shell(a, |s| frequency_hz(s, 0)))
        .unit(Dimension::Frequency, "Hz")
        .help("Lowest natural frequency with no wave round the axis, held at the foot of the lid.", SHELL),
    Output::new("first_lateral_frequency_hz", "First Lateral Frequency", Module::Structure, |a| shell(a, |s| frequency_hz(s, 1)))
        .unit(Dimension::Frequency, "Hz")
        .help("Lowest natural frequency with one wave round the axis, held at the foot of the lid.", SHELL),
];
