//! Cases drawn at random or made with bad intent that once gave plausible nonsense, took minutes or were lost, each
//! with the right result.

use crate::designs::LIBRARY;
use msape::answer::outputs;
use msape::quantity::Job;
use msape::{Answer, Case, InputError, Outcome, Request, answer};
use msape_tests::entry::output;
use msape_tests::text::PLAIN;

/// Right result of a case.
enum Right {
    /// Refused; each message begins with one of the keys, and each key begins one.
    Refused(&'static [&'static str]),
    /// An outcome, and part of its reason.
    Ended(Outcome, &'static str),
}

use Right::{Ended, Refused};

const UNSTABLE: &str = "the fixed step is too long";

macro_rules! file {
    ($name:literal) => {
        ($name, include_str!(concat!("robustness/", $name)))
    };
}

/// Files of the folder `robustness`, the command that solves them, and the right result.
const CASES: [((&str, &str), Job, Right); 24] = [
    (
        file!("design-at-rest.toml"),
        Job::Design,
        Refused(&["entry.speed_m_s: got 0 m/s"]),
    ),
    (
        file!("design-beyond-stop-time.toml"),
        Job::Design,
        Ended(Outcome::Converged, ""),
    ),
    (
        file!("design-energy-up.toml"),
        Job::Design,
        Ended(Outcome::GaveUp, UNSTABLE),
    ),
    (
        file!("design-inf-result.toml"),
        Job::Design,
        Ended(
            Outcome::NotClosed,
            "No vehicle of 1.195 m to 2.000 m closes",
        ),
    ),
    (
        file!("design-nan-result.toml"),
        Job::Design,
        Ended(Outcome::GaveUp, "heat load is not a finite number"),
    ),
    (
        file!("design-slow-titan.toml"),
        Job::Design,
        Ended(Outcome::Converged, ""),
    ),
    (
        file!("design-small-planet.toml"),
        Job::Design,
        Ended(Outcome::GaveUp, "the limit of work, 200000 trials of steps"),
    ),
    (
        file!("design-times-order.toml"),
        Job::Design,
        Refused(&[
            "entry.altitude_m: got an altitude",
            "entry.altitude_m: got -5000 m",
        ]),
    ),
    (
        file!("duplicate-key.json"),
        Job::Fly,
        Refused(&["entry.speed_m_s: stands twice"]),
    ),
    (
        file!("fast-spin.toml"),
        Job::Fly,
        Refused(&["attitude.body_rates_deg_s: row 1, p_deg_s: got"]),
    ),
    (
        file!("fly3-last-altitude.toml"),
        Job::Fly,
        Refused(&["planet.equatorial_radius_m: got"]),
    ),
    (
        file!("fly3-stop-altitude.toml"),
        Job::Fly,
        Ended(Outcome::GaveUp, UNSTABLE),
    ),
    (
        file!("fly3-stop-altitude-coarse-tolerance.toml"),
        Job::Fly,
        Ended(Outcome::Landed, ""),
    ),
    (
        file!("fly3-times-order.toml"),
        Job::Fly,
        Refused(&["entry.altitude_m: got an altitude"]),
    ),
    (
        file!("fly6-nan-result.toml"),
        Job::Fly,
        Refused(&["atmosphere.table: row 1", "atmosphere.table: row 2"]),
    ),
    (
        file!("mass-nonpositive.toml"),
        Job::Design,
        Refused(&["design.payload_mass_kg: got"]),
    ),
    (
        file!("odd-key-dotted.json"),
        Job::Fly,
        Refused(&[
            "entry.{peed_m_s: unknown key",
            "entry.speed_m_s: missing",
            "vehicle.aerodynamics.file: was not read",
        ]),
    ),
    (
        file!("odd-key-hash.json"),
        Job::Fly,
        Refused(&["heating.#onvective_margin: unknown key"]),
    ),
    (
        file!("rk4-landed-at-125-km.toml"),
        Job::Fly,
        Ended(Outcome::GaveUp, UNSTABLE),
    ),
    (
        file!("rk4-landed-at-minus-29-km.toml"),
        Job::Fly,
        Ended(Outcome::GaveUp, UNSTABLE),
    ),
    (
        file!("rk4-skips-out-with-3e20-g.toml"),
        Job::Design,
        Ended(Outcome::GaveUp, UNSTABLE),
    ),
    (
        file!("two-spellings-of-one-key.toml"),
        Job::Fly,
        Refused(&["planet.equatorial_radius_m: stands twice"]),
    ),
    (
        file!("unknown-planet.toml"),
        Job::Fly,
        Refused(&["entry.planet: got"]),
    ),
    (
        file!("unknown-top-level-key.toml"),
        Job::Design,
        Refused(&["description: unknown key", "design."]),
    ),
];

fn solve(case: &Case, job: Job) -> Result<Answer, Vec<InputError>> {
    match job {
        Job::Fly => msape::fly(case, &LIBRARY, Request::Steps),
        Job::Design => msape::design(case, &LIBRARY, Request::Steps),
    }
}

fn lines(faults: &[InputError]) -> Vec<String> {
    faults.iter().map(ToString::to_string).collect()
}

/// An answer with an outcome has finite numbers, and a landing is on the ground.
fn stands(name: &str, answer: &Answer, job: Job) {
    let text = answer::text(answer, job);
    assert!(
        serde_json::from_str::<serde_json::Value>(&text).is_ok(),
        "{name}"
    );
    if matches!(answer.outcome, Outcome::GaveUp | Outcome::NotClosed) {
        assert!(answer.reason.is_some(), "{name}: no reason");
        return;
    }
    for output in outputs(job) {
        let finite = (output.get)(answer).is_none_or(f64::is_finite);
        assert!(finite, "{name}: {} is not finite", output.key);
    }
    if let Some(history) = answer.flight.as_ref().and_then(|f| f.trajectory.as_ref()) {
        for (column, values) in history.columns() {
            let named = values.iter().all(|x| history.name(column, *x).is_some());
            assert!(
                named || values.iter().all(|x| x.is_finite()),
                "{name}: {}",
                column.key
            );
        }
        let time_s = history.column("time_s").unwrap();
        assert!(
            time_s.windows(2).all(|pair| pair[1] > pair[0]),
            "{name}: time"
        );
    }
    if answer.outcome == Outcome::Landed {
        assert!(output(answer, "final_altitude_m").abs() <= 1e-3, "{name}");
    }
}

#[test]
fn each_case_is_refused_given_up_or_true() {
    let mut wrong = Vec::new();
    for ((name, text), job, right) in CASES {
        let found = Case::from_text(text).and_then(|case| solve(&case, job));
        match (found, right) {
            (Err(faults), Refused(keys)) => {
                let lines = lines(&faults);
                let told = keys
                    .iter()
                    .all(|key| lines.iter().any(|line| line.starts_with(key)));
                let meant = lines
                    .iter()
                    .all(|line| keys.iter().any(|key| line.starts_with(key)));
                if !(told && meant) {
                    wrong.push(format!("{name}: {lines:#?}"));
                }
            }
            (Ok(answer), Ended(outcome, words)) => {
                stands(name, &answer, job);
                let reason = answer.reason.clone().unwrap_or_default();
                if answer.outcome != outcome || !reason.contains(words) {
                    wrong.push(format!("{name}: {}: {reason}", answer.outcome.name()));
                }
            }
            (Ok(answer), Refused(_)) => {
                wrong.push(format!("{name}: not refused: {}", answer.outcome.name()));
            }
            (Err(faults), Ended(..)) => wrong.push(format!("{name}: {:#?}", lines(&faults))),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Unknown keys that need quotes: above all sections, in one, with dots, blanks, signs, empty.
#[test]
fn a_case_with_any_unknown_key_reads_back() {
    let texts = [
        include_str!("robustness/unknown-top-level-key.toml"),
        include_str!("robustness/odd-key-dotted.json"),
        include_str!("robustness/odd-key-hash.json"),
    ];
    let odd = [
        "\"my key\" = 1",
        "\"a.b c\" = 1",
        "\"\" = 1",
        "\"\\n\" = 1",
        "\"é\" = 'x'",
    ];
    let odd =
        odd.map(|line| format!("schema = 'msape/1'\n{line}\n[entry]\n{line}\nspeed_m_s = 1.0\n"));
    for text in texts.into_iter().chain(odd.iter().map(String::as_str)) {
        let case = Case::from_text(text).unwrap();
        let written = case.to_toml();
        match Case::from_text(&written) {
            Ok(read) => assert_eq!(read, case, "{written}"),
            Err(faults) => panic!("{faults:?}\n{written}"),
        }
    }
}

/// A hundred unknown keys of 3 kB, as in a file of 300 kB: not compared with known keys, and shortened in messages.
#[test]
fn long_unknown_keys_are_told_in_short() {
    let keys: String = (0..100)
        .map(|i| format!("k{i}{} = 1\n", "b".repeat(3000)))
        .collect();
    let case = Case::from_text(&format!("{PLAIN}\n[zz]\n{keys}")).unwrap();
    let faults = lines(&solve(&case, Job::Fly).unwrap_err());
    let (last, told) = faults.split_last().unwrap();
    assert_eq!(last, "and 50 more unknown keys");
    assert_eq!(told.len(), 50);
    assert!(
        told.iter()
            .all(|line| line.starts_with("zz.k") && line.len() < 200)
    );
}

/// Ten thousand passes with very small steps: the total work of the passes is limited.
#[test]
fn passes_without_end_are_given_up_at_a_limit_of_work() {
    for flight in [
        &[][..],
        &[("solver.flight_model", "allen-eggers")],
        &[("solver.method", "rk4"), ("solver.step_s", "0.005")],
    ] {
        let mut case = Case::run_page();
        for (key, value) in [
            ("design.max_iterations", "10000"),
            ("design.relaxation", "1e-6"),
            ("design.mass_criterion_kg", "1e-15"),
        ]
        .iter()
        .chain(flight)
        {
            case.set(key, value);
        }
        let answer = solve(&case, Job::Design).unwrap();
        let reason = answer.reason.clone().unwrap_or_default();
        assert_eq!(answer.outcome, Outcome::GaveUp, "{reason}");
        assert!(
            reason.contains("the limit of work was reached, 20000000 evaluations"),
            "{reason}"
        );
        assert!(answer.passes.len() <= 2000);
        assert!(answer.design.is_some());
    }
}
