//! Hostile and random input of every kind from a seed: a bounded number of cases in `cargo test`, any duration with
//! `cargo xtask fuzz`, which continues with the next seeds and counts.
//!
//! - [`texts`]: cases with changed letters, numbers and lines.
//! - [`files`]: tables, outlines and drawings changed likewise, in text and binary.
//! - [`links`]: links to a design, unchanged and changed in transit.
//! - [`entries`]: entries of vehicles at all planets, with three and six degrees of freedom.
//! - [`vehicles`]: designs, outlines, and their exports.
//! - [`edits`], [`samples`]: changes of files, and the files; [`truths`]: conditions that hold for each answer.

mod edits;
mod entries;
mod files;
mod links;
mod samples;
mod texts;
pub(crate) mod truths;
mod vehicles;

use proptest::prelude::*;
use proptest::test_runner::{RngSeed, TestRunner};
use std::collections::BTreeMap;
use std::fmt::Debug;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Time limit for one case, s: a longer run counts as endless.
const LONGEST_S: u64 = 180;

/// Counts by name; read at the end.
#[derive(Default)]
pub(crate) struct Tally {
    counts: Mutex<BTreeMap<&'static str, u64>>,
    since: Mutex<Option<Instant>>,
    slowest: Mutex<Duration>,
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    // a case that fails while counting leaves the counts unchanged
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Tally {
    /// Adds one.
    pub fn one(&self, name: &'static str) {
        self.add(name, 1);
    }

    /// Adds a number.
    pub fn add(&self, name: &'static str, more: usize) {
        *locked(&self.counts).entry(name).or_default() += more as u64;
    }

    fn begins(&self) {
        *locked(&self.since) = Some(Instant::now());
    }

    fn ends(&self) {
        if let Some(since) = locked(&self.since).take() {
            let mut slowest = locked(&self.slowest);
            *slowest = slowest.max(since.elapsed());
        }
    }

    fn is_endless(&self) -> bool {
        locked(&self.since).is_some_and(|since| since.elapsed().as_secs() > LONGEST_S)
    }

    fn line(&self) -> String {
        let counts = locked(&self.counts);
        let counts: Vec<String> = counts.iter().map(|(k, n)| format!("{n} {k}")).collect();
        let slowest_s = locked(&self.slowest).as_secs_f64();
        format!("{}; slowest {slowest_s:.1} s", counts.join(", "))
    }
}

/// A number from the environment, with which `cargo xtask fuzz` asks for more.
fn asked(name: &str) -> Option<u64> {
    let text = std::env::var(name).ok()?;
    Some(text.parse().expect("a whole number"))
}

/// Draws cases from the seed and checks each; for as many seconds as requested, with one seed after the other.
pub(crate) fn hold<S: Strategy>(
    kind: &str,
    cases: u32,
    drawn: &S,
    check: impl Fn(&S::Value, &Tally) -> Result<(), TestCaseError>,
) where
    S::Value: Debug,
{
    let seconds = asked("MSAPE_FUZZ_SECONDS");
    let first = asked("MSAPE_FUZZ_SEED").unwrap_or(2014);
    let tally = Tally::default();
    let start = Instant::now();
    let mut faults = Vec::new();
    let over = Mutex::new(false);
    std::thread::scope(|threads| {
        threads.spawn(|| {
            while !*locked(&over) {
                if tally.is_endless() {
                    eprintln!("{kind}, seed {first} or later: a case takes over {LONGEST_S} s");
                    std::process::abort();
                }
                std::thread::sleep(Duration::from_millis(100));
            }
        });
        for seed in first.. {
            let config = ProptestConfig {
                rng_seed: RngSeed::Fixed(seed),
                ..crate::config(cases)
            };
            let found = TestRunner::new(config).run(drawn, |case| {
                tally.one("cases");
                tally.begins();
                let found = check(&case, &tally);
                tally.ends();
                found
            });
            if let Err(fault) = found {
                let fault = format!("{kind}, seed {seed}: {fault}");
                println!("{fault}");
                faults.push(fault);
            }
            if seconds.is_none_or(|seconds| start.elapsed().as_secs() >= seconds) {
                println!("{kind}, seeds {first} to {seed}: {}", tally.line());
                break;
            }
        }
        *locked(&over) = true;
    });
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
