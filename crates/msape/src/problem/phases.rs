//! Checks the phases of a flight.

use super::forms::one_row;
use crate::case::Reader;
use crate::finding::Finding;
use crate::finding::range::short;
use crate::flight::phase::{Begin, Canopy, Change, Direction, Mark, Phase};
use crate::quantity::input::{self, Input, phase, repeated};

/// The inputs of which one begins a phase.
const MARKS: [(&Input, Mark); 5] = [
    (&phase::TIME_S, Mark::Time),
    (&phase::ALTITUDE_M, Mark::Altitude),
    (&phase::MACH, Mark::Mach),
    (&phase::DYNAMIC_PRESSURE_PA, Mark::DynamicPressure),
    (&phase::DECELERATION_EARTH_G, Mark::Deceleration),
];

/// Kind of body that flies through the phases.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Flown {
    /// A point mass.
    Point,
    /// A rigid body.
    Rigid,
}

/// The phases of a case; none where it has none, `None` where one is at fault.
pub(super) fn phases(reader: &mut Reader, flown: Flown) -> Option<Vec<Phase>> {
    let before = reader.faults.len();
    let count = reader.count(&phase::SECTION);
    let mut found: Vec<Phase> = Vec::with_capacity(count);
    let mut earlier_s = 0.0;
    let mut before_kg = reader
        .given(&input::vehicle::MASS_KG)
        .then(|| reader.number(&input::vehicle::MASS_KG))
        .flatten();
    for number in 1..=count {
        let Some(phase) = of_number(reader, number, flown) else {
            continue;
        };
        if found.iter().any(|other| other.name == phase.name) {
            let message = format!(
                "got \"{}\", which an earlier phase is called, too",
                phase.name
            );
            reader.fault(&phase::NAME.of_number(number), message);
        }
        if phase.begin.mark == Mark::Time {
            if phase.begin.value < earlier_s {
                let message = format!(
                    "got {} s, must be at least {earlier_s} s of an earlier phase: phases begin in their order",
                    phase.begin.value
                );
                reader.fault(&phase::TIME_S.of_number(number), message);
            }
            earlier_s = phase.begin.value;
        }
        let heavier = phase
            .change
            .mass_kg
            .zip(before_kg)
            .filter(|(mass_kg, before)| mass_kg > before);
        if let Some((mass_kg, before)) = heavier {
            let message = format!(
                "Phase {} makes the vehicle heavier: {} kg after {} kg.",
                phase.name,
                short(mass_kg),
                short(before)
            );
            note(reader, &phase::MASS_KG, number, message);
        }
        before_kg = phase.change.mass_kg.or(before_kg);
        found.push(phase);
    }
    (reader.faults.len() == before).then_some(found)
}

fn of_number(reader: &mut Reader, number: usize, flown: Flown) -> Option<Phase> {
    let key = phase::NAME.of_number(number);
    let name = reader.words(key).filter(|name| !name.trim().is_empty());
    if name.is_none() {
        reader.fault(&key, "missing; every phase has a name");
    }
    let begin = begin(reader, number);
    let change = change(reader, number, flown);
    Some(Phase {
        name: name?,
        begin: begin?,
        change: change?,
    })
}

fn begin(reader: &mut Reader, number: usize) -> Option<Begin> {
    let given: Vec<_> = MARKS
        .into_iter()
        .filter(|(input, _)| reader.given(input.of_number(number)))
        .collect();
    let ways = || {
        let names = MARKS.map(|(input, _)| repeated::name(input));
        names.join(", ")
    };
    let key = phase::DIRECTION.of_number(number);
    let direction_given = reader.given(key);
    let direction = match direction_given {
        true => reader.choice(key)?,
        false => Direction::Falling,
    };
    match given.as_slice() {
        [(input, mark)] => {
            if *mark == Mark::Time && direction_given {
                let time = repeated::name(input);
                let message =
                    format!("given together with {time}, which only rises; leave it away");
                reader.fault(&key, message);
            }
            Some(Begin {
                mark: *mark,
                value: reader.number(input.of_number(number))?,
                direction,
            })
        }
        [] => {
            let message = format!("missing; give one of {}", ways());
            reader.fault(&phase::ALTITUDE_M.of_number(number), message);
            None
        }
        [_, (second, _), ..] => {
            let message = format!("a phase begins in one way; give one of {}", ways());
            reader.fault(&second.of_number(number), message);
            None
        }
    }
}

fn change(reader: &mut Reader, number: usize, flown: Flown) -> Option<Change> {
    let before = reader.faults.len();
    let [
        mass_kg,
        reference_area_m2,
        drag_coefficient,
        drag_area_m2,
        inflation_s,
    ] = [
        &phase::MASS_KG,
        &phase::REFERENCE_AREA_M2,
        &phase::DRAG_COEFFICIENT,
        &phase::DRAG_AREA_M2,
        &phase::INFLATION_S,
    ]
    .map(|input| reader.number(input.of_number(number)));
    let drag_coefficient_key = phase::DRAG_COEFFICIENT.of_number(number);
    let attachment_key = phase::ATTACHMENT_M.of_number(number);
    let attachment = one_row::<3>(reader, attachment_key).flatten();
    let area = repeated::name(&phase::REFERENCE_AREA_M2);
    let drag_area = repeated::name(&phase::DRAG_AREA_M2);
    let out = reader.given(phase::DRAG_AREA_M2.of_number(number));
    if !out {
        for key in [phase::INFLATION_S.of_number(number), attachment_key] {
            if reader.given(key) {
                let message = format!("given without {drag_area}, to which it belongs");
                reader.fault(&key, message);
            }
        }
    }
    match flown {
        Flown::Rigid => {
            if reader.given(drag_coefficient_key) {
                let message = format!(
                    "is of a point mass; the drag of a rigid body follows from its attitude and one number does not tell its moments: give {area}, by which all its forces and moments are scaled, or {drag_area}, a parachute"
                );
                reader.fault(&drag_coefficient_key, message);
            }
            if reference_area_m2.is_some() {
                let message = "Forces and moments of the vehicle are scaled with its reference area when the phase begins; coefficients and reference lengths stay.";
                note(reader, &phase::REFERENCE_AREA_M2, number, message);
            }
            if out && drag_area_m2 != Some(0.0) && !reader.given(attachment_key) {
                reader.fault(&attachment_key, "missing; a rigid body needs the point at which its parachute pulls, [x, y, z] in m");
            }
            if mass_kg.is_some() {
                let message = "The inertia of the vehicle is scaled with its mass, and its center of gravity stays, when the phase begins.";
                note(reader, &phase::MASS_KG, number, message);
            }
        }
        Flown::Point if reader.given(attachment_key) => {
            let label = phase::ATTACHMENT_M.label;
            let message = format!("{label} is not used in three degrees of freedom.");
            note(reader, &phase::ATTACHMENT_M, number, message);
        }
        Flown::Point => {}
    }
    let canopy = drag_area_m2.map(|drag_area_m2| Canopy {
        drag_area_m2,
        inflation_s: inflation_s.unwrap_or(0.0),
        attachment_m: attachment.unwrap_or_default(),
    });
    (reader.faults.len() == before).then_some(Change {
        mass_kg,
        reference_area_m2,
        drag_coefficient,
        canopy,
    })
}

/// Adds a finding if the case has phases and the command does not use them.
pub(super) fn not_flown(reader: &mut Reader, by: &str) {
    if reader.count(&phase::SECTION) > 0 {
        let message = format!("The phases of the case are not used by {by}.");
        note(reader, &phase::NAME, 1, message);
    }
}

fn note(reader: &mut Reader, input: &'static Input, number: usize, message: impl Into<String>) {
    let note = Finding::note("phases", &input.of_number(number), message);
    reader.findings.push(note);
}

#[cfg(test)]
mod tests {
    use crate::problem::FlightProblem;
    use crate::{Case, Library};

    fn said(phases: &str) -> String {
        let text = crate::library::data_file("cases/stardust.toml").unwrap();
        let case = Case::from_text(&format!("{text}{phases}")).unwrap();
        match FlightProblem::check(&case, &Library::builtin().unwrap()) {
            Ok(problem) => problem
                .findings
                .into_iter()
                .map(|finding| finding.message)
                .collect(),
            Err(faults) => {
                let lines: Vec<String> = faults.iter().map(ToString::to_string).collect();
                lines.join("\n")
            }
        }
    }

    #[test]
    fn every_fault_of_the_phases_is_said_at_once() {
        let said = said(
            "
[[phase]]
altitude_m = 31e3
mach = 1.2
drag_area_m2 = -1.0
[[phase]]
name = 'main'
inflation_s = 2.0
[[phase]]
name = 'main'
time_s = 20.0
direction = 'rising'
[[phase]]
name = 'last'
time_s = 10.0
color = 3
",
        );
        for part in [
            "phase.1.name: missing",
            "phase.1.mach: a phase begins in one way",
            "phase.1.drag_area_m2: got -1 m^2, must be 0 to",
            "phase.2.altitude_m: missing; give one of",
            "phase.2.inflation_s: given without drag_area_m2",
            "phase.3.direction: given together with time_s",
            "phase.4.time_s: got 10 s, must be at least 20 s",
            "phase.4.color: unknown key",
        ] {
            assert!(said.contains(part), "{part}\nnot in\n{said}");
        }
    }

    #[test]
    fn a_phase_that_makes_the_vehicle_heavier_is_told() {
        let heavier = said("[[phase]]\nname = 'odd'\nmach = 1.4\nmass_kg = 50.0\n");
        assert!(
            heavier.contains("Phase odd makes the vehicle heavier: 50 kg after 46 kg."),
            "{heavier}"
        );
        let lighter = said("[[phase]]\nname = 'odd'\nmach = 1.4\nmass_kg = 40.0\n");
        assert!(!lighter.contains("heavier"), "{lighter}");
    }

    #[test]
    fn a_fault_of_a_number_that_is_read_twice_is_told_once() {
        let text = crate::library::data_file("cases/stardust.toml").unwrap();
        let phases = "[[phase]]\nname = 'odd'\nmach = 1.4\nmass_kg = 40.0\n";
        let air = "[atmosphere]\nheat_capacity_ratio = 7.0\nexponential = { density_kg_m3 = 1.2, scale_height_m = 7e3 }\n";
        let mut case = Case::from_text(&format!("{text}{air}{phases}")).unwrap();
        case.set("vehicle.mass_kg", "-1");
        let faults = FlightProblem::check(&case, &Library::builtin().unwrap()).unwrap_err();
        let keys: Vec<&str> = faults.iter().map(|fault| fault.key.as_str()).collect();
        assert_eq!(keys, ["atmosphere.heat_capacity_ratio", "vehicle.mass_kg"]);
    }

    #[test]
    fn one_section_without_list_is_the_first_phase() {
        assert_eq!(said("[phase]\nname = 'drogue'\nmach = 1.4\n"), said(""));
    }
}
