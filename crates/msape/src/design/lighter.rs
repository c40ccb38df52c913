//! The lighter of two vehicles that both close at one diameter, and the smallest diameter at which it does.
//!
//! ```text
//! heavy: grown from the requested diameter, or outgrown every diameter     at D₁, with M₁
//! light: the passes at D₁ itself, from the first guesses                   M < 0.99 M₁, not grown
//! D:     bisected between 0 and the largest allowed, while the light vehicle of the next larger D leads to one at D
//! ```
//!
//! A vehicle that grows starts small and dense, with the corresponding loads and heat shields; where these lead to a vehicle that
//! requires them again, the passes converge there, though at the same diameter a vehicle of half the mass would close, too.
//! The diameters D do not depend on the requested one, and neither does the vehicle found.
//!
//! # Valid
//! Two vehicles whose masses differ by less than 1 % count as one. The smallest diameter is found to 2⁻¹⁵ of the
//! largest allowed. There the light vehicle ends: below it, each pass requires a heavier one.

use super::inputs::DesignInput;
use super::passes::{Cut, End, Made, Run, Way, Work, run};
use super::start::Numbers;
use crate::finding::{Adjustment, Finding, Severity};
use crate::quantity::input;
use crate::vehicle::{PayloadSize, Vehicle};

/// Relative difference below which two masses are of one vehicle: assumed, between a vehicle found twice, which differs by its mass
/// criterion, and two, of which one was found to have 450 kg and the other 957 kg.
const SAME: f64 = 0.01;

/// Halvings of the largest diameter, assumed: of the report's 2 m 0.06 mm are left, within its 0.1 mm of section 3.1.2.
const HALVINGS: usize = 15;

/// Passes allowed at each diameter, unless the case allows more: assumed. Where the light vehicle ends they converge slowly.
const MOST_PASSES: u32 = 200;

/// Result of the search for a lighter vehicle.
#[derive(Debug)]
pub(super) struct Searched<'a> {
    /// Passes of the vehicle that is the answer.
    pub(super) run: Run<'a>,
    /// The heavier vehicle, if the answer is a lighter one.
    pub(super) heavier: Option<Heavier>,
    /// Reason why the search was cut short, if it was.
    pub(super) cut: Option<Cut>,
}

/// A heavier vehicle that satisfies the case, too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Heavier {
    /// Diameter from which it was grown, m.
    asked_m: f64,
    /// Diameter, m, and mass, kg, to which it converges; absent where it outgrows every diameter allowed.
    settled: Option<[f64; 2]>,
}

/// A lighter vehicle than that found by the passes, if that had to grow or closes at no diameter; otherwise the result of the
/// passes.
/// `work` as in [`run`].
pub(super) fn than<'a>(input: &DesignInput, found: Run<'a>, work: &mut Work) -> Searched<'a> {
    let settled = found.converged().map(|made| {
        let vehicle = &made.vehicle;
        [vehicle.dimensions.diameter_m, vehicle.mass.mass_kg]
    });
    let alone = |run| Searched {
        run,
        heavier: None,
        cut: None,
    };
    let (diameter_m, below_kg) = match (&found.end, settled) {
        (_, Some([diameter_m, mass_kg])) => (diameter_m, (1.0 - SAME) * mass_kg),
        // a vehicle closed before: its loads and heat shield have outgrown every diameter
        (End::Unclosed(..), _) if !found.passes.is_empty() => {
            (input.vehicle.rules.diameter_max_m, f64::INFINITY)
        }
        _ => return alone(found),
    };
    let asked_m = input.vehicle.diameter_m;
    if diameter_m <= asked_m {
        return alone(found);
    }
    let light = search(input, diameter_m, below_kg, work);
    let cut = work.end();
    match light {
        None => Searched {
            cut,
            ..alone(found)
        },
        Some(run) => Searched {
            run,
            heavier: Some(Heavier { asked_m, settled }),
            cut,
        },
    }
}

/// A vehicle lighter than `below_kg`, at a diameter in m and below; it stops where the work is spent.
fn search(
    input: &DesignInput,
    diameter_m: f64,
    below_kg: f64,
    work: &mut Work,
) -> Option<Run<'static>> {
    let asked_m = input.vehicle.diameter_m;
    let largest_m = input.vehicle.rules.diameter_max_m;
    let mut input = input.clone();
    // a payload that is a part of the requested diameter stays as large
    input.vehicle.payload_size = PayloadSize::DiameterM(input.vehicle.payload_diameter_m());
    input.max_iterations = input.max_iterations.max(MOST_PASSES);
    let mut light_at = |diameter_m: f64, from: Option<Numbers>| {
        if work.is_spent() {
            return None;
        }
        input.vehicle.diameter_m = diameter_m;
        let way = Way {
            from,
            as_asked_below_kg: Some(below_kg),
            ..Way::default()
        };
        let run = run(&input, way, work);
        run.converged().is_some().then(|| run.into_owned())
    };
    let mut light = light_at(diameter_m, None)?;
    let (mut low_m, mut high_m) = (0.0, largest_m);
    for _ in 0..HALVINGS {
        let middle_m = 0.5 * (low_m + high_m);
        let found = if middle_m >= diameter_m {
            None
        } else {
            light_at(middle_m, light.converged().map(Made::numbers))
        };
        if middle_m >= diameter_m || found.is_some() {
            high_m = middle_m;
        } else {
            low_m = middle_m;
        }
        light = found.unwrap_or(light);
    }
    if high_m < asked_m {
        light = light_at(asked_m, light.converged().map(Made::numbers))?;
    }
    Some(light)
}

impl Searched<'_> {
    /// The remark on a search that was cut short.
    pub(super) fn remark(&self) -> Option<Finding> {
        let cut = self.cut?;
        let light = self.heavier.and_then(|_| self.run.converged());
        let without = match light {
            Some(_) => {
                "the vehicle given is the smallest found till then; a smaller and lighter one may carry itself"
            }
            None => "whether a lighter vehicle answers these inputs is not known",
        };
        Some(Finding {
            severity: Severity::Exceeded,
            model: "coupling".to_owned(),
            key: "total_entry_mass_kg".to_owned(),
            value: light.map(|made| made.vehicle.mass.mass_kg),
            valid: (None, None),
            message: format!(
                "The search for a lighter vehicle ended when {}: {without}.",
                cut.reason()
            ),
            source: "convention of this program".to_owned(),
            field: Some(input::solver::TOLERANCE.key.to_owned()),
        })
    }
}

impl Heavier {
    /// Adds the origin of the lighter vehicle to its remarks: grown from the requested diameter, and the heavier alternative.
    pub(super) fn explain(&self, vehicle: &mut Vehicle) {
        let asked_m = self.asked_m;
        let diameter_m = vehicle.dimensions.diameter_m;
        if diameter_m > asked_m {
            let grown = Adjustment {
                key: input::design::DIAMETER_M.key.to_owned(),
                from: asked_m,
                to: diameter_m,
                reason: "The vehicle was grown to the smallest diameter at which it carries its own heat shield and foam: below it, each vehicle asks for a heavier one.".to_owned(),
                source: "NASA/TM-2014-218507, section 3.1.2".to_owned(),
            };
            vehicle.adjustments.insert(0, grown);
        }
        let other = match self.settled {
            Some([heavy_m, heavy_kg]) => {
                format!("of {heavy_kg:.2} kg settles at {heavy_m:.4} m")
            }
            None => "outgrows every diameter allowed".to_owned(),
        };
        vehicle.findings.push(Finding {
            severity: Severity::Note,
            model: "coupling".to_owned(),
            key: "total_entry_mass_kg".to_owned(),
            value: Some(vehicle.mass.mass_kg),
            valid: (None, None),
            message: format!(
                "Two vehicles answer these inputs: grown from {asked_m:.4} m, one {other}; this one, lighter, is found from larger diameters down. Its passes begin with the numbers of the next larger one."
            ),
            source: "convention of this program".to_owned(),
            field: Some(input::design::DIAMETER_M.key.to_owned()),
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::DesignProblem;
    use crate::progress::Unwatched;
    use crate::{Case, Library};

    /// The remark on the carbon-phenolic vehicle, which grows from 0.9 m, with so much work beyond that of its first passes.
    fn said(more: u64) -> Option<Finding> {
        let text = crate::library::data_file("cases/msr-eev-cp.toml").unwrap();
        let case = Case::from_text(text).unwrap();
        let input = DesignProblem::check(&case, &Library::builtin().unwrap())
            .unwrap()
            .input;
        let mut watcher = Unwatched;
        let mut work = Work::up_to(u64::MAX, &mut watcher);
        let first = run(&input, Way::default(), &mut work);
        assert!(first.converged().unwrap().vehicle.dimensions.diameter_m > 1.0);
        let mut work = work.with_limit(more);
        let found = than(&input, first, &mut work);
        assert!(found.run.converged().is_some());
        found.remark()
    }

    #[test]
    fn a_search_that_the_limit_of_work_ends_is_told() {
        assert_eq!(said(u64::MAX / 2), None);
        for more in [0, 1] {
            let remark = said(more).unwrap();
            assert_eq!(remark.severity, Severity::Exceeded);
            assert!(
                remark
                    .message
                    .contains("when the limit of work was reached"),
                "{}",
                remark.message
            );
        }
    }
}
