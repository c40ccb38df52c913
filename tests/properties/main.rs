//! What holds for every case, over many cases drawn by a fixed seed.
//!
//! - [`text`]: what is written reads back; numbers keep their value through units.
//! - [`garbage`]: whatever comes in, an answer or a list of faults goes out.
//! - [`flights`]: energy, scaling laws, order of refinement, wind.
//! - [`designs`]: mass, volume, closing rules.
//! - [`lanes`]: flights in lanes have the bits of each alone; [`derivatives`]: those of dual numbers are those of differences.
//! - [`versions`]: cases of the first version keep its defaults, or are told what changed.
//! - [`coupling`]: the passes settle, and an answer is of one pass.
//! - [`geometry`]: ten thousand vehicles: whole, without overlap, every change told.
//! - [`planets`], [`atmosphere_tables`]: each its own gas, air, figure and depth.
//! - [`robustness`]: cases that once gave nonsense, or took minutes.
//! - [`hostile`]: files, cases and vehicles by the thousand, and as many more as one likes.
//! - [`landings`]: the limit of the payload, equations 3 and 5.

mod atmosphere_tables;
mod coupling;
mod derivatives;
mod designs;
mod drawn;
mod flights;
mod garbage;
mod geometry;
mod hostile;
mod landings;
mod lanes;
mod planets;
mod robustness;
mod text;
mod versions;

use proptest::test_runner::{Config, RngSeed};

/// A fixed number of cases by a fixed seed; a failure prints the smallest case that fails.
fn config(cases: u32) -> Config {
    Config {
        cases,
        rng_seed: RngSeed::Fixed(2014),
        failure_persistence: None,
        ..Config::default()
    }
}
