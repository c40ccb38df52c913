//! Hostile and random input of every kind by a seed: a bounded number of cases in `cargo test`, as long as one likes with
//! `cargo xtask fuzz`, which goes on with the next seeds and counts.
//!
//! - [`texts`]: cases with letters, numbers and lines that somebody changed.
//! - [`files`]: tables, outlines and drawings likewise, in text and binary.
//! - [`links`]: links to a design, as sent and changed on their way.
//! - [`entries`]: entries of vehicles at all planets, with three and six degrees of freedom.
//! - [`vehicles`]: designs, outlines, what is exported of them.
//! - [`edits`], [`samples`]: how a file is changed, and the files; [`truths`]: what holds for each answer.

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

/// Longest time for one case, s: what takes longer is taken for endless.
const LONGEST_S: u64 = 180;

/// What was counted, by name; read at the end.
#[derive(Default)]
pub(crate) struct Tally {
    counts: Mutex<BTreeMap<&'static str, u64>>,
    since: Mutex<Option<Instant>>,
    slowest: Mutex<Duration>,
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    // a case that fails while it counts leaves the counts as they are
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Tally {
    /// One more.
    pub fn one(&self, name: &'static str) {
        self.add(name, 1);
    }

    /// So many more.
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

/// A number of the environment, by which `cargo xtask fuzz` asks for more.
fn asked(name: &str) -> Option<u64> {
    let text = std::env::var(name).ok()?;
    Some(text.parse().expect("a whole number"))
}

/// Draws cases by the seed and lets each be checked; for as many seconds as were asked for, by one seed after the other.
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
