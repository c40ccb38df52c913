//! The lighter of two vehicles that both carry themselves at one diameter, and the smallest diameter at which it does.
//!
//! ```text
//! heavy: grown from the diameter asked for, or outgrown every diameter     at D₁, with M₁
//! light: the passes at D₁ itself, from the first guesses                   M < 0.99 M₁, not grown
//! D:     halved between nothing and the largest allowed, while the light vehicle of the next larger D leads to one at D
//! ```
//!
//! A vehicle that grows starts small and dense, with the loads and heat shields of that; where these make a vehicle that asks
//! for as much again, the passes settle there, though at the same diameter a vehicle of half the mass would carry itself.
//! The diameters D are the same whatever was asked for, and so is the vehicle found.
//!
//! # Valid
//! Two vehicles whose masses differ by less than a hundredth are taken as one. The smallest diameter is found to 2⁻¹⁵ of the
//! largest allowed. There the light vehicle ends: below it, each asks for a heavier one.

use super::inputs::DesignInput;
use super::passes::{End, Made, Numbers, Run, Way, Work, run};
use crate::finding::{Adjustment, Finding, Severity};
use crate::outcome::Outcome;
use crate::quantity::input;
use crate::vehicle::PayloadSize;

/// Masses closer than this part of each other are of one vehicle: assumed, between one vehicle found twice, which differs by its mass
/// criterion, and two, of which one was found to have 450 kg and the other 957 kg.
const SAME: f64 = 0.01;

/// Halvings of the largest diameter, assumed: of the report's 2 m 0.06 mm are left, within its 0.1 mm of section 3.1.2.
const HALVINGS: usize = 15;

/// Passes allowed at each diameter, if not more are asked for: assumed. Where the light vehicle ends they settle slowly.
const MOST_PASSES: u32 = 200;

/// The lighter vehicle than the one that the passes found, where it had to grow or closes at no diameter, else what they found; with a
/// remark where the search was cut short. `work` as in [`run`].
pub(super) fn than(input: &DesignInput, found: Run, work: &mut Work) -> (Run, Option<Finding>) {
    let heavy = converged(&found).map(|made| {
        let vehicle = &made.vehicle;
        (vehicle.dimensions.diameter_m, vehicle.mass.mass_kg)
    });
    let (diameter_m, below_kg) = match (&found.end, heavy) {
        (_, Some((diameter_m, mass_kg))) => (diameter_m, (1.0 - SAME) * mass_kg),
        // a vehicle closed before: its loads and heat shield have outgrown every diameter
        (End::Unclosed(..), _) if !found.passes.is_empty() => {
            (input.vehicle.rules.diameter_max_m, f64::INFINITY)
        }
        _ => return (found, None),
    };
    if diameter_m <= input.vehicle.diameter_m {
        return (found, None);
    }
    let light = search(input, diameter_m, below_kg, heavy, work);
    let remark = work.is_spent().then(|| cut_short(light.as_ref(), work));
    (light.unwrap_or(found), remark)
}

/// A vehicle lighter than `below_kg`, at a diameter in m and below; it stops where the work is spent.
fn search(
    input: &DesignInput,
    diameter_m: f64,
    below_kg: f64,
    heavy: Option<(f64, f64)>,
    work: &mut Work,
) -> Option<Run> {
    let asked_m = input.vehicle.diameter_m;
    let largest_m = input.vehicle.rules.diameter_max_m;
    let mut input = input.clone();
    // a payload that is a part of the diameter asked for stays as large
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
        };
        Some(run(&input, way, work)).filter(|run| converged(run).is_some())
    };
    let mut light = light_at(diameter_m, None)?;
    let (mut low_m, mut high_m) = (0.0, largest_m);
    for _ in 0..HALVINGS {
        let middle_m = 0.5 * (low_m + high_m);
        let found = if middle_m >= diameter_m {
            None
        } else {
            light_at(middle_m, numbers(&light))
        };
        if middle_m >= diameter_m || found.is_some() {
            high_m = middle_m;
        } else {
            low_m = middle_m;
        }
        light = found.unwrap_or(light);
    }
    if high_m < asked_m {
        light = light_at(asked_m, numbers(&light))?;
    }
    if let End::Vehicle(made) = &mut light.end {
        explain(made, asked_m, heavy);
    }
    Some(light)
}

/// The remark on a search that the limit of work ended.
fn cut_short(light: Option<&Run>, work: &Work) -> Finding {
    let without = match light {
        Some(_) => {
            "the vehicle given is the smallest found till then; a smaller and lighter one may carry itself"
        }
        None => "whether a lighter vehicle answers these inputs is not known",
    };
    Finding {
        severity: Severity::Exceeded,
        model: "coupling".to_owned(),
        key: "total_entry_mass_kg".to_owned(),
        value: light
            .and_then(converged)
            .map(|made| made.vehicle.mass.mass_kg),
        valid: (None, None),
        message: format!(
            "The search for a lighter vehicle ended at the limit of work, {}: {without}.",
            work.limit()
        ),
        source: "convention of this program".to_owned(),
        field: Some(input::solver::TOLERANCE.key.to_owned()),
    }
}

/// Says what was done: to the diameter asked for, and beside which heavier vehicle, of this diameter in m and mass in kg.
fn explain(made: &mut Made, asked_m: f64, heavy: Option<(f64, f64)>) {
    let vehicle = &mut made.vehicle;
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
    let other = match heavy {
        Some((heavy_m, heavy_kg)) => {
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

fn converged(run: &Run) -> Option<&Made> {
    match &run.end {
        End::Vehicle(made) if made.outcome == Outcome::Converged => Some(made),
        _ => None,
    }
}

fn numbers(run: &Run) -> Option<Numbers> {
    converged(run).map(Made::numbers)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::DesignProblem;
    use crate::{Case, Library};

    /// The remark on the carbon-phenolic vehicle, which grows from 0.9 m, with so much work beyond that of its first passes.
    fn said(more: u64) -> Option<Finding> {
        let text = crate::library::data_file("cases/msr-eev-cp.toml").unwrap();
        let case = Case::from_text(text).unwrap();
        let input = DesignProblem::check(&case, &Library::builtin().unwrap())
            .unwrap()
            .input;
        let mut work = Work::up_to(u64::MAX);
        let first = run(&input, Way::default(), &mut work);
        assert!(converged(&first).unwrap().vehicle.dimensions.diameter_m > 1.0);
        let mut work = work.with_limit(more);
        let (found, remark) = than(&input, first, &mut work);
        assert!(converged(&found).is_some());
        remark
    }

    #[test]
    fn a_search_that_the_limit_of_work_ends_is_told() {
        assert_eq!(said(u64::MAX / 2), None);
        for more in [0, 1] {
            let remark = said(more).unwrap();
            assert_eq!(remark.severity, Severity::Exceeded);
            assert!(
                remark.message.contains("at the limit of work"),
                "{}",
                remark.message
            );
        }
    }
}
