//! The structure of a converged design: the results of every rule, and those of the shell model.
//!
//! # References
//! - \[samareh-2014\] section 3.1.6.

use super::Design;
use super::inputs::DesignInput;
use crate::finding::{Finding, Severity};
use crate::flight::Flight;
use crate::shell::analysis::{AnalysisLoads, CarrierAnalysis, CaseStress, PartStress};
use crate::shell::carrier::CarrierModel;
use crate::vehicle::WallPlace;
use crate::vehicle::structure::{Check, LoadCase, Rule, Structure, size};
use crate::vehicle::{Loads, VehicleInput};
use serde::{Deserialize, Serialize};

/// The structure of a design.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Structural {
    /// Every rule of the conceptual level, for every wall and load case.
    pub checks: Vec<Check>,
    /// The shell model; absent when it cannot be made, as for walls without thickness.
    pub shell: Option<CarrierAnalysis>,
}

/// Margin of safety that is zero within rounding.
const ROUNDING: f64 = 1e-6;
/// Relative difference between the decelerations of shell model and flight above which it is reported.
const LOAD_DIFFERENCE: f64 = 0.15;

impl Structural {
    /// Computes both levels for a design and its flight.
    pub fn new(input: &DesignInput, design: &Design, flight: &Flight) -> Self {
        let vehicle = &design.vehicle;
        let input = VehicleInput {
            loads: Loads {
                entry_load_earth_g: flight.peak_deceleration_earth_g.value,
                peak_stagnation_pressure_pa: flight.peak_stagnation_pressure_pa.value,
                ..input.vehicle.loads
            },
            ..input.vehicle.clone()
        };
        let loads = size::loads(&input, &vehicle.layout, &vehicle.components, &vehicle.mass);
        let shell = CarrierModel::new(&input, vehicle, 1.0).and_then(|model| {
            model.analyze(&AnalysisLoads {
                stagnation_pressure_pa: input.loads.peak_stagnation_pressure_pa,
                deceleration_earth_g: input.loads.entry_load_earth_g,
                structure: input.structure_loads,
            })
        });
        Self {
            checks: crate::vehicle::structure::check::checks(&input, &loads, &vehicle.structure),
            shell,
        }
    }

    /// Check of a wall with the least margin, minimum gauge left out.
    pub fn critical(&self, wall: WallPlace) -> Option<&Check> {
        let of_wall = |check: &&Check| check.wall == wall && check.rule != Rule::MinimumGauge;
        let checks = self.checks.iter().filter(of_wall);
        checks.min_by(|a, b| a.margin.total_cmp(&b.margin))
    }

    /// Least margin of the shell model in both load cases, laminate, faces and core.
    pub fn shell_margin(&self) -> Option<f64> {
        let shell = self.shell.as_ref()?;
        let cases = [&shell.entry, &shell.launch];
        cases
            .iter()
            .filter_map(|case| least_margin(case))
            .reduce(f64::min)
    }

    /// Findings on the governing rule of each wall, on negative margins, and on disagreement between rules and shell model.
    pub fn findings(&self, structure: &Structure, flight: &Flight) -> Vec<Finding> {
        let mut list = vec![self.governing(structure)];
        list.extend(
            self.checks
                .iter()
                .filter(|c| c.margin < -ROUNDING)
                .map(failed),
        );
        if let Some(shell) = &self.shell {
            for (case, name) in [(&shell.entry, "entry"), (&shell.launch, "launch")] {
                list.extend(self.overstressed(case, name));
            }
            list.extend(unlike_the_flight(shell, flight));
        }
        list
    }

    fn governing(&self, structure: &Structure) -> Finding {
        let walls = [
            (WallPlace::Forebody, "Forebody carrier", &structure.forebody),
            (WallPlace::Aftbody, "aftbody carrier", &structure.aftbody),
            (WallPlace::Primary, "primary structure", &structure.primary),
        ];
        let of_wall = walls.map(|(place, name, wall)| {
            let margin = self.critical(place).map_or(String::new(), |check| {
                // the margin of a wall sized by a rule is zero within rounding
                format!(
                    " (least margin of safety {:+.2}, {})",
                    check.margin + ROUNDING,
                    check.rule.label()
                )
            });
            format!("{name}: {} governs{margin}", wall.governs.label())
        });
        Finding {
            severity: Severity::Note,
            model: "structural rules".to_owned(),
            key: "forebody_carrier_structure_thickness_m".to_owned(),
            value: Some(structure.forebody.thickness_m),
            valid: (None, None),
            message: format!("{}.", of_wall.join("; ")),
            source: "NASA/TM-2014-218507, section 3.1.6; each rule with its source in the design's structure".to_owned(),
            field: None,
        }
    }

    /// Finding on a part that the shell model finds too weak, with the result of the conceptual level for its wall.
    fn overstressed(&self, case: &CaseStress, name: &str) -> Option<Finding> {
        let worst = worst(case).filter(|part| part.least_margin() < 0.0)?;
        let wall = worst.part.wall();
        let in_case = |check: &&Check| {
            let launch = matches!(check.load_case, LoadCase::Launch(_));
            check.wall == wall && check.rule == Rule::Strength && launch == (name == "launch")
        };
        let conceptual = self
            .checks
            .iter()
            .filter(in_case)
            .map(|c| c.margin)
            .reduce(f64::min);
        let core = worst.core_margin.is_some_and(|core| core < worst.margin);
        let (what, stress_pa, r_m) = if core {
            ("shear in the core", worst.shear_pa, worst.shear_at.r_m)
        } else {
            ("stress", worst.stress_pa, worst.at.r_m)
        };
        let other = conceptual.map_or(String::new(), |m| {
            format!("; membrane strength alone has {m:+.2}, so that bending where walls meet makes the difference")
        });
        Some(Finding {
            severity: Severity::Exceeded,
            model: "shell model".to_owned(),
            key: format!("shell_{name}_margin"),
            value: Some(worst.least_margin()),
            valid: (Some(0.0), None),
            message: format!(
                "At {name} the {what} of the {} reaches {:.1} MPa {:.0} mm from the axis, a margin of safety of {:+.2}{other}: a local reinforcement, or a thicker wall, is needed.",
                worst.part.label(),
                stress_pa / 1e6,
                r_m * 1000.0,
                worst.least_margin(),
            ),
            source: "axisymmetric shell model; NASA-STD-5001".to_owned(),
            field: None,
        })
    }
}

fn worst(case: &CaseStress) -> Option<&PartStress> {
    case.parts
        .iter()
        .min_by(|a, b| a.least_margin().total_cmp(&b.least_margin()))
}

/// Least margin of a load case.
pub fn least_margin(case: &CaseStress) -> Option<f64> {
    worst(case).map(PartStress::least_margin)
}

fn failed(check: &Check) -> Finding {
    Finding {
        severity: Severity::Exceeded,
        model: "structural rules".to_owned(),
        key: String::new(),
        value: Some(check.margin),
        valid: (Some(0.0), None),
        message: format!(
            "{:?} wall, {}: {:.3e} {} asked, {:.3e} {} carried, a margin of safety of {:+.2}.",
            check.wall,
            check.rule.label(),
            check.demand,
            check.unit,
            check.capacity,
            check.unit,
            check.margin
        ),
        source: check.source.clone(),
        field: None,
    }
}

/// Newtonian pressure at its peak against the deceleration of the flight: they rest on different drag.
fn unlike_the_flight(shell: &CarrierAnalysis, flight: &Flight) -> Option<Finding> {
    let flown = flight.peak_deceleration_earth_g.value;
    let ours = shell.deceleration_earth_g / shell.pressure_factor;
    let apart = (ours / flown - 1.0).abs() > LOAD_DIFFERENCE;
    apart.then(|| Finding {
        severity: Severity::Note,
        model: "shell model".to_owned(),
        key: "shell_deceleration_earth_g".to_owned(),
        value: Some(ours),
        valid: (Some(flown * (1.0 - LOAD_DIFFERENCE)), Some(flown * (1.0 + LOAD_DIFFERENCE))),
        message: format!(
            "Newtonian pressure at the peak stagnation pressure decelerates the shell model by {ours:.1} g, the flight peaks at {flown:.1} g: the larger is taken."
        ),
        source: "NASA/TM-2014-218507, equation 10".to_owned(),
        field: None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer::sample::designed;

    #[test]
    fn msr_has_every_rule_for_every_wall_and_all_four_corners() {
        let (input, design, flight) = designed("msr-eev-pica");
        let structural = Structural::new(&input, &design, &flight);
        let count = |rule, wall| {
            let those = structural.checks.iter();
            those.filter(|c| c.rule == rule && c.wall == wall).count()
        };
        // entry and four corners; entry and launch
        assert_eq!(count(Rule::CylinderBuckling, WallPlace::Primary), 5);
        assert_eq!(count(Rule::Strength, WallPlace::Forebody), 2);
        assert_eq!(count(Rule::ConePressureBuckling, WallPlace::Forebody), 1);
        assert_eq!(count(Rule::CapBuckling, WallPlace::Aftbody), 1);
        assert_eq!(count(Rule::CoreShear, WallPlace::Forebody), 1);
        // each required thickness is the wall's where it governs, and less elsewhere
        for check in &structural.checks {
            if let Some(required) = check.required_thickness_m {
                let wall = match check.wall {
                    WallPlace::Forebody => &design.vehicle.structure.forebody,
                    WallPlace::Aftbody => &design.vehicle.structure.aftbody,
                    WallPlace::Primary => &design.vehicle.structure.primary,
                };
                assert!(required <= wall.thickness_m * (1.0 + 1e-6), "{check:?}");
                assert!(check.margin >= -1e-6, "{check:?}");
            }
        }
    }

    #[test]
    fn a_hundred_times_the_pressure_is_found_too_much_by_both_levels() {
        let (input, design, flight) = designed("msr-eev-pica");
        let found = |flight: &Flight| {
            Structural::new(&input, &design, flight).findings(&design.vehicle.structure, flight)
        };
        let exceeded = |list: &[Finding], model: &str| {
            let those = list.iter().filter(|f| f.severity == Severity::Exceeded);
            those.filter(|f| f.model == model).count()
        };
        let as_flown = found(&flight);
        assert_eq!(exceeded(&as_flown, "shell model"), 0);
        assert_eq!(exceeded(&as_flown, "structural rules"), 0);
        assert!(as_flown[0].message.contains("minimum gauge governs"));
        let mut harsh = flight.clone();
        harsh.peak_stagnation_pressure_pa.value *= 100.0;
        let list = found(&harsh);
        assert_eq!(exceeded(&list, "shell model"), 1);
        assert!(exceeded(&list, "structural rules") >= 3);
        assert!(list.iter().any(|f| f.key == "shell_deceleration_earth_g"));
    }
}
