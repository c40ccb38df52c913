//! Many flights at a time, several in the lanes of one integration.
//!
//! ```text
//! y'ₖ = f(tₖ, yₖ; pₖ)   in lane k, each with its own time, step, entry state and numbers p
//! ```
//!
//! A flight that ends gives its lane to the next of the queue. Each flight has the same bits as alone, whatever its lane and
//! its neighbors.
//!
//! # Valid
//! Three degrees of freedom; one mission, one kind of drag and lift for all flights.
//!
//! # References
//! - Own convention.

use super::equations::{Equations, STATES};
use super::integration::{self, Record};
use super::mission::{Body, Mission};
use super::motion::PointMass;
use super::numbers::Numbers;
use super::summary::{self, Extremes};
use super::{Flight, Request, three_dof};
use crate::outcome::Outcome;
use core::ops::ControlFlow;
use numerics::scalar::Lanes;

/// A flight of a batch that has ended.
pub struct Flown<'f, 'a> {
    /// Its number in the queue, from 0.
    pub number: usize,
    /// How it ended.
    pub outcome: Outcome,
    /// Why, where the outcome needs a reason.
    pub reason: Option<&'f str>,
    motion: PointMass<'a>,
    record: &'f Record<STATES>,
}

impl Flown<'_, '_> {
    /// All results, and the time history that is asked for.
    pub fn flight(&self, request: Request) -> Flight {
        summary::summarize(self.motion, self.record, request)
    }

    /// The results that sizing a vehicle needs.
    pub fn extremes(&self) -> Extremes {
        summary::extremes(self.motion, self.record)
    }
}

/// Flies a queue of flights, `N` at a time; `done` is told of each as it ends, and may stop the rest.
///
/// The vehicle gives the kind of drag and lift; its numbers are those of the queue.
pub fn fly_all<const N: usize>(
    mission: &Mission,
    body: &Body,
    queue: impl IntoIterator<Item = Numbers>,
    mut done: impl FnMut(&Flown) -> ControlFlow<()>,
) -> ControlFlow<()> {
    let flights = queue.into_iter().map(|numbers| {
        let point = Equations::with_numbers(mission, body, 0, numbers);
        (PointMass { point }, three_dof::start(&numbers.start))
    });
    integration::integrate_all::<PointMass<Lanes<N>>, STATES, Lanes<N>>(
        flights,
        |number, motion, record| {
            done(&Flown {
                number,
                outcome: record.outcome,
                reason: record.reason.as_deref(),
                motion: *motion,
                record: &record,
            })
        },
    )
}
