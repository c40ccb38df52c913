//! Checks the phases of a flight.

use super::forms::{choice, one_row};
use crate::case::Reader;
use crate::finding::range::short;
use crate::finding::{Finding, Severity};
use crate::flight::phase::{Begin, Canopy, Change, Direction, Mark, Phase};

/// The keys of which one begins a phase.
const MARKS: [(&str, Mark); 5] = [
    ("time_s", Mark::Time),
    ("altitude_m", Mark::Altitude),
    ("mach", Mark::Mach),
    ("dynamic_pressure_pa", Mark::DynamicPressure),
    ("deceleration_earth_g", Mark::Deceleration),
];

/// What flies through the phases.
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
    let count = reader.phases();
    let mut found: Vec<Phase> = Vec::with_capacity(count);
    let mut earlier_s = 0.0;
    let mut before_kg = reader
        .given("vehicle.mass_kg")
        .then(|| reader.number("vehicle.mass_kg"))
        .flatten();
    for number in 1..=count {
        let Some(phase) = phase(reader, number, flown) else {
            continue;
        };
        let key = format!("phase.{number}");
        if found.iter().any(|other| other.name == phase.name) {
            let message = format!(
                "got \"{}\", which an earlier phase is called, too",
                phase.name
            );
            reader.fault(&format!("{key}.name"), message);
        }
        if phase.begin.mark == Mark::Time {
            if phase.begin.value < earlier_s {
                let message = format!(
                    "got {} s, must be at least {earlier_s} s of an earlier phase: phases begin in their order",
                    phase.begin.value
                );
                reader.fault(&format!("{key}.time_s"), message);
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
            reader
                .findings
                .push(note(&format!("{key}.mass_kg"), &message));
        }
        before_kg = phase.change.mass_kg.or(before_kg);
        found.push(phase);
    }
    (reader.faults.len() == before).then_some(found)
}

fn phase(reader: &mut Reader, number: usize, flown: Flown) -> Option<Phase> {
    let key = |name: &str| format!("phase.{number}.{name}");
    let name = match reader.given(&key("name")) {
        true => reader
            .words(&key("name"))
            .filter(|name| !name.trim().is_empty()),
        false => None,
    };
    if name.is_none() {
        reader.fault(&key("name"), "missing; every phase has a name");
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
    let key = |name: &str| format!("phase.{number}.{name}");
    let given: Vec<_> = MARKS
        .into_iter()
        .filter(|(name, _)| reader.given(&key(name)))
        .collect();
    let direction_given = reader.given(&key("direction"));
    let direction = match direction_given {
        true => choice(reader, &key("direction"))?,
        false => "falling",
    };
    match given.as_slice() {
        [(name, mark)] => {
            if *mark == Mark::Time && direction_given {
                reader.fault(
                    &key("direction"),
                    "given together with time_s, which only rises; leave it away",
                );
            }
            Some(Begin {
                mark: *mark,
                value: reader.number(&key(name))?,
                direction: match direction {
                    "rising" => Direction::Rising,
                    _ => Direction::Falling,
                },
            })
        }
        [] => {
            reader.fault(
                &key("altitude_m"),
                "missing; give one of time_s, altitude_m, mach, dynamic_pressure_pa, deceleration_earth_g",
            );
            None
        }
        [_, (second, _), ..] => {
            reader.fault(&key(second), "a phase begins in one way; give one of time_s, altitude_m, mach, dynamic_pressure_pa, deceleration_earth_g");
            None
        }
    }
}

fn change(reader: &mut Reader, number: usize, flown: Flown) -> Option<Change> {
    let key = |name: &str| format!("phase.{number}.{name}");
    let before = reader.faults.len();
    let mut value = |name: &str| {
        let key = key(name);
        reader.given(&key).then(|| reader.number(&key)).flatten()
    };
    let (mass_kg, reference_area_m2, drag_coefficient) = (
        value("mass_kg"),
        value("reference_area_m2"),
        value("drag_coefficient"),
    );
    let (drag_area_m2, inflation_s) = (value("drag_area_m2"), value("inflation_s"));
    let attachment = one_row::<3>(reader, &key("attachment_m")).flatten();
    let out = reader.given(&key("drag_area_m2"));
    if !out {
        for name in ["inflation_s", "attachment_m"] {
            if reader.given(&key(name)) {
                reader.fault(
                    &key(name),
                    "given without drag_area_m2, to which it belongs",
                );
            }
        }
    }
    match flown {
        Flown::Rigid => {
            if reader.given(&key("drag_coefficient")) {
                reader.fault(&key("drag_coefficient"), "is of a point mass; the drag of a rigid body follows from its attitude and one number does not tell its moments: give reference_area_m2, by which all its forces and moments are scaled, or drag_area_m2, a parachute");
            }
            if reference_area_m2.is_some() {
                let message = "Forces and moments of the vehicle are scaled with its reference area when the phase begins; coefficients and reference lengths stay.";
                reader
                    .findings
                    .push(note(&key("reference_area_m2"), message));
            }
            if out && drag_area_m2 != Some(0.0) && !reader.given(&key("attachment_m")) {
                reader.fault(&key("attachment_m"), "missing; a rigid body needs the point at which its parachute pulls, [x, y, z] in m");
            }
            if mass_kg.is_some() {
                let message = "The inertia of the vehicle is scaled with its mass, and its centre of gravity stays, when the phase begins.";
                reader.findings.push(note(&key("mass_kg"), message));
            }
        }
        Flown::Point if reader.given(&key("attachment_m")) => {
            let message = "Parachute Attachment is not used in three degrees of freedom.";
            reader.findings.push(note(&key("attachment_m"), message));
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

/// What is said of phases where they play no part.
pub(super) fn not_flown(reader: &mut Reader, by: &str) {
    if reader.phases() > 0 {
        let message = format!("The phases of the case are not used by {by}.");
        reader.findings.push(note("phase.1.name", &message));
    }
}

fn note(key: &str, message: &str) -> Finding {
    Finding {
        severity: Severity::Note,
        model: "phases".to_string(),
        key: key.to_string(),
        value: None,
        valid: (None, None),
        message: message.to_string(),
        source: "convention of this program".to_string(),
        field: Some(key.to_string()),
    }
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
colour = 3
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
            "phase.4.colour: unknown key",
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
