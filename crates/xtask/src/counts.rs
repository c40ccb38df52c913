//! Instructions executed by the command, counted by valgrind: the same binary gives the same number on a busy and on an
//! idle machine, so that a slower solver fails a test, which a clock cannot do reliably.

use std::{fs, path::PathBuf};

use anyhow::{Context, Result, bail};
use serde_json::Value;

use crate::project::Project;
use crate::{build, setup};

/// Commands and their counts, for the release build of the README.
const FILE: &str = "tests/counts.json";
/// Allowed excess over a count, percent: other processors take other paths through the C library. Assumed; the same
/// machine gives 0.1.
const ROOM_PERCENT: u64 = 20;

/// Counts each command of the file and compares with its record.
pub fn check(project: &Project) -> Result<()> {
    build::command(project)?;
    let text = fs::read_to_string(project.root.join(FILE))
        .with_context(|| format!("cannot read {FILE}"))?;
    let counts: Value =
        serde_json::from_str(&text).with_context(|| format!("cannot read {FILE}"))?;
    let counts = counts
        .as_object()
        .with_context(|| format!("{FILE}: must be commands with their counts"))?;
    println!("{:>14} {:>14}  command", "instructions", "may be");
    let mut above = Vec::new();
    for (command, count) in counts {
        let count = count
            .as_u64()
            .with_context(|| format!("{FILE}: {command}: must be a whole number"))?;
        let most = count / 100 * (100 + ROOM_PERCENT);
        let now = counted(project, command)?;
        println!("{now:>14} {most:>14}  msape {command}");
        if now > most {
            above.push(format!("msape {command}: {now} instructions, above {most}"));
        }
    }
    if !above.is_empty() {
        bail!(
            "{}\nthat is {ROOM_PERCENT} % above {FILE}: make it faster, or write the new count there and the reason into CHANGELOG.md",
            above.join("\n")
        );
    }
    Ok(())
}

/// Instructions of one run.
fn counted(project: &Project, command: &str) -> Result<u64> {
    let valgrind = setup::program_of_tests(project, "valgrind").context("valgrind is missing")?;
    let program: PathBuf = project.target.join("release/msape");
    let output = project
        .command(valgrind)
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(program)
        .args(command.split(' '))
        .output()?;
    let said = String::from_utf8_lossy(&output.stderr);
    if !output.status.success() {
        bail!("msape {command} failed under valgrind:\n{said}");
    }
    collected(&said).with_context(|| format!("valgrind says no count for msape {command}:\n{said}"))
}

/// The number after `Collected :` in valgrind's output.
fn collected(said: &str) -> Option<u64> {
    let (_, rest) = said.split_once("Collected :")?;
    rest.split_whitespace().next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_count_is_read_from_what_valgrind_says() {
        let said = "==7== Events    : Ir\n==7== Collected : 23080940\n==7== \n==7== I   refs:      23,080,940\n";
        assert_eq!(collected(said), Some(23_080_940));
        assert_eq!(collected("==7== Events    : Ir\n"), None);
    }
}
