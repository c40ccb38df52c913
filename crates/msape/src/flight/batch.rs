//! Many flights at once, several in the lanes of one integration.
//!
//! ```text
//! y'ₖ = f(tₖ, yₖ; pₖ)   in lane k, each with its own time, step, entry state and numbers p
//! ```
//!
//! A lane whose flight has ended takes the next flight of the queue. Each flight has the same bits as alone, whatever
//! its lane and its neighbors.
//!
//! # Valid
//! Three degrees of freedom; one mission, one kind of drag and lift for all flights.
//!
//! # References
//! - Own convention.

use super::equations::{Equations, STATES};
use super::integration::{self, Keep, Record};
use super::mission::{Body, Mission};
use super::motion::PointMass;
use super::numbers::Numbers;
use super::summary::{self, Extremes};
use super::{Flight, Request, three_dof};
use crate::outcome::Outcome;
use crate::progress::Unwatched;
use core::ops::ControlFlow;
use numerics::scalar::Lanes;

/// A flight of a batch that has ended, with its results.
#[derive(Clone, Debug, PartialEq)]
pub struct Flown<R> {
    /// Number in the queue, from 0.
    pub number: usize,
    /// Results of the flight.
    pub results: R,
    /// Outcome of the flight.
    pub outcome: Outcome,
    /// Reason of the outcome, where it needs one.
    pub reason: Option<String>,
}

/// Flies a queue of flights, `N` at a time; `done` gets each flight as it ends, and may stop the rest.
///
/// The vehicle gives the kind of drag and lift; its numbers are those of the queue.
pub fn fly_all<const N: usize>(
    mission: &Mission,
    body: &Body,
    queue: impl IntoIterator<Item = Numbers>,
    done: impl FnMut(Flown<Flight>) -> ControlFlow<()>,
) -> ControlFlow<()> {
    let results: Results<Flight> =
        |motion, record| summary::summarize(motion, record, Request::Nothing);
    all::<N, Flight>(mission, body, (Keep::All, results), queue, done)
}

/// Flies a queue of flights as [`fly_all`] does, but finds only the few results that sizing a vehicle needs, in less
/// time.
pub fn extremes_of_all<const N: usize>(
    mission: &Mission,
    body: &Body,
    queue: impl IntoIterator<Item = Numbers>,
    done: impl FnMut(Flown<Extremes>) -> ControlFlow<()>,
) -> ControlFlow<()> {
    let results: Results<Extremes> = |motion, record| summary::extremes(motion, record);
    all::<N, Extremes>(mission, body, (Keep::Busy, results), queue, done)
}

type Results<R> = fn(PointMass, &Record<STATES>) -> R;

fn all<const N: usize, R>(
    mission: &Mission,
    body: &Body,
    (keep, results): (Keep, Results<R>),
    queue: impl IntoIterator<Item = Numbers>,
    mut done: impl FnMut(Flown<R>) -> ControlFlow<()>,
) -> ControlFlow<()> {
    let flights = queue.into_iter().map(|numbers| {
        let point = Equations::with_numbers(mission, body, numbers);
        (PointMass { point }, three_dof::start(&numbers.start))
    });
    integration::integrate_all::<PointMass<Lanes<N>>, STATES, Lanes<N>>(
        keep,
        flights,
        &mut Unwatched,
        &mut |number, motion, record| {
            done(Flown {
                number,
                results: results(*motion, &record),
                outcome: record.outcome,
                reason: record.reason,
            })
        },
    )
}
