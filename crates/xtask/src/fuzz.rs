//! The random tests for as long as one likes: `tests/properties/hostile`, which `cargo xtask test` runs for a bounded number.

use anyhow::{Context, Result, bail};

use crate::project::{Project, announce, run};

/// Seconds of each kind when none are given.
const SECONDS: u64 = 60;

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
    let kinds = format!("hostile::{kind}");
    run(project
        .command("cargo")
        .arg("test")
        .args(tests)
        .args([
            kinds.trim_end_matches("::"),
            "--",
            "--nocapture",
            "--test-threads=1",
        ])
        .env("MSAPE_FUZZ_SEED", seed.to_string())
        .env("MSAPE_FUZZ_SECONDS", seconds.to_string()))
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
    fn seed_seconds_and_kind_in_any_order() {
        let found = parse(&["tables", "--seconds", "5", "--seed", "7"]).unwrap();
        assert_eq!((found.seed, found.seconds, found.kind), (7, 5, "tables"));
        assert!(parse(&["--seed", "x"]).is_err());
        assert!(parse(&["--sed", "1"]).is_err());
    }
}
