//! Properties that hold for every case, checked over many cases drawn with a fixed seed.
//!
//! - [`text`]: output reads back; numbers keep their value through units.
//! - [`garbage`]: any input gives an answer or a list of faults.
//! - [`flights`]: energy, scaling laws, order of refinement, wind.
//! - [`designs`]: mass, volume, closing rules.
//! - [`lanes`]: flights in lanes have the same bits as alone.
//! - [`derivatives`]: derivatives by dual numbers equal central differences.
//! - [`versions`]: cases of the first version keep its defaults, or the answer reports the changes.
//! - [`coupling`]: the passes converge, and an answer is of one pass.
//! - [`geometry`]: ten thousand vehicles: complete, without overlap, every change reported.
//! - [`planets`], [`atmosphere_tables`]: each with its own gas, atmosphere, figure and depth.
//! - [`robustness`]: cases that once gave nonsense, or took minutes.
//! - [`hostile`]: files, cases and vehicles by the thousand, and any number more on request.
//! - [`allocations`]: memory that a vehicle and a design ask for.
//! - [`landings`]: load limit of the payload, equations 3 and 5.

mod allocations;
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

/// A fixed number of cases with a fixed seed; a failure prints the smallest failing case.
fn config(cases: u32) -> Config {
    Config {
        cases,
        rng_seed: RngSeed::Fixed(2014),
        failure_persistence: None,
        ..Config::default()
    }
}
