//! Random tests of any duration: `tests/properties/hostile`, which `cargo xtask test` runs for a limited number of
//! cases.

use anyhow::{Context, Result, bail};

use crate::project::{Project, announce, run};

/// Default duration of each kind, s.
const SECONDS: u64 = 60;

/// Kinds: tests below `hostile` that draw from the seed.
const KINDS: [&str; 9] = [
    "entries::entries_of_a_point_mass",
    "entries::entries_of_a_rigid_body",
    "files::bytes_without_sense_as_files",
    "files::changed_outlines_and_drawings",
    "files::changed_tables",
    "links::links_as_sent_and_changed_on_their_way",
    "texts::changed_texts_of_cases",
    "vehicles::designs_with_and_without_an_impact_sphere",
    "vehicles::outlines_their_coefficients_and_files",
];

struct Arguments<'a> {
    seed: u64,
    seconds: u64,
    kind: &'a str,
}

/// Runs the kinds one after the other on one core.
pub fn run_kinds(project: &Project, arguments: &[&str]) -> Result<()> {
    let Arguments {
        seed,
        seconds,
        kind,
    } = parse(arguments)?;
    announce(format_args!(
        "Random input, {seconds} s of each kind from seed {seed} on"
    ));
    let tests = [
        "--locked",
        "--package",
        "msape-tests",
        "--test",
        "properties",
    ];
    let kinds = named(kind)?.map(|kind| format!("hostile::{kind}"));
    run(project
        .command("cargo")
        .arg("test")
        .args(tests)
        .args(["--", "--nocapture", "--test-threads=1", "--exact"])
        .args(kinds)
        .env("MSAPE_FUZZ_SEED", seed.to_string())
        .env("MSAPE_FUZZ_SECONDS", seconds.to_string()))
}

/// Kinds whose names contain a text.
fn named(part: &str) -> Result<impl Iterator<Item = &'static str>> {
    if !KINDS.iter().any(|kind| kind.contains(part)) {
        bail!(
            "fuzz: got the kind \"{part}\", must be a part of one of\n  {}",
            KINDS.join("\n  ")
        );
    }
    Ok(KINDS.into_iter().filter(move |kind| kind.contains(part)))
}

fn parse<'a>(arguments: &[&'a str]) -> Result<Arguments<'a>> {
    let mut parsed = Arguments {
        seed: 1,
        seconds: SECONDS,
        kind: "",
    };
    let mut rest = arguments.iter();
    while let Some(argument) = rest.next() {
        let mut number = || {
            let text = rest.next().copied().unwrap_or_default();
            let number = text.parse::<u64>();
            number.with_context(|| format!("{argument}: got {text:?}, must be a whole number"))
        };
        match *argument {
            "--seed" => parsed.seed = number()?,
            "--seconds" => parsed.seconds = number()?,
            option if option.starts_with('-') => bail!("fuzz: no such option: {option}"),
            kind => parsed.kind = kind,
        }
    }
    Ok(parsed)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_is_a_test_that_draws_and_every_such_test_a_kind() {
        let folder = concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/../../tests/properties/hostile"
        );
        let mut found = Vec::new();
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let text = std::fs::read_to_string(&path).unwrap();
            let module = path.file_stem().unwrap().to_string_lossy().into_owned();
            // a test extends to the next function
            for test in text.split("\n#[test]\nfn ").skip(1) {
                let test = test.split("\nfn ").next().unwrap();
                if test.contains("    hold(") {
                    let name = test.split('(').next().unwrap();
                    found.push(format!("{module}::{name}"));
                }
            }
        }
        found.sort();
        assert_eq!(found, KINDS);
    }

    #[test]
    fn a_kind_is_named_by_a_part_of_it_and_one_that_is_not_there_is_refused() {
        let tables: Vec<_> = named("tables").unwrap().collect();
        assert_eq!(tables, ["files::changed_tables"]);
        assert_eq!(named("entries").unwrap().count(), 2);
        assert_eq!(named("").unwrap().count(), KINDS.len());
        let fault = named("tabels").err().unwrap().to_string();
        assert!(fault.contains("files::changed_tables"), "{fault}");
    }

    #[test]
    fn seed_seconds_and_kind_in_any_order() {
        let found = parse(&["tables", "--seconds", "5", "--seed", "7"]).unwrap();
        assert_eq!((found.seed, found.seconds, found.kind), (7, 5, "tables"));
        assert!(parse(&["--seed", "x"]).is_err());
        assert!(parse(&["--sed", "1"]).is_err());
    }
}
