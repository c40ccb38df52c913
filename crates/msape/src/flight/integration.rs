//! Integrates equations of motion from the entry state to the end of the flight, whatever their degrees of freedom.
//!
//! ```text
//! y' = f(t, y) by one set of smooth rows after the other
//! ```
//!
//! with y position, velocity (SI, planet-fixed axes), heat loads and further states of a motion. Steps end where a row
//! of a table ends, so that the method keeps its order; between the ends of a step the dense output of the method
//! holds.
//!
//! # Valid
//! Steps end within a millimeter of a boundary of the atmosphere.
//!
//! # References
//! - \[samareh-2014\] section 3.2.

mod course;
mod ending;
mod gate;
mod ladder;
mod marks;
mod node;
mod phases;
mod watch;

use super::equations::STATES;
use super::motion::Motion;
use super::phase::Stage;
use super::reach::{Push, Span};
use super::sample::Loads;
use crate::outcome::Outcome;
use crate::progress::{Progress, Unwatched};
use core::ops::ControlFlow;
use course::{Course, Next};
use marks::Marks;
use node::Node;
use numerics::ode::{Integrator, Step, Tolerance};
use numerics::scalar::{Mask, Scalar, Single};

/// Trials of steps after which a flight is given up.
pub const MOST_STEPS: u64 = 200_000;
/// Height over which the atmosphere changes, and scale of the error in position of a step, m.
const POSITION_SCALE_M: f64 = 1_000.0;
/// Speed below which the allowed error of a step no longer decreases, m/s.
const SPEED_SCALE_M_S: f64 = 10.0;
/// Heat load below which the allowed error of a step no longer decreases, J/m².
const HEAT_LOAD_SCALE_J_M2: f64 = 1e6;

/// A step of a flight, and what holds along it.
#[derive(Clone, Debug)]
pub struct Leg<const N: usize, S = f64> {
    /// The step with its dense output.
    pub step: Step<N, S>,
    /// Rows that held, and phase.
    pub stage: Stage<S>,
    /// Loads at the end of the step.
    pub loads: Loads<S>,
}

/// A flight as integrated.
#[derive(Clone, Debug)]
pub struct Record<const N: usize, S = f64> {
    /// State at the start.
    pub start: [S; N],
    /// Rows that hold at the start.
    pub start_stage: Stage<S>,
    /// Loads at the start.
    pub start_loads: Loads<S>,
    /// The steps, in order; none when the flight ends where it starts.
    pub legs: Vec<Leg<N, S>>,
    /// Altitudes between two steps, m.
    pub altitudes: Span,
    /// Range of the values looked up in each axis of the tables of the case.
    pub spans: Vec<Span>,
    /// Axis of a table at whose end the flight was ended.
    pub refused: Option<usize>,
    /// Place where the air pushed the vehicle.
    pub pushed: Option<Push>,
    /// Times and states at which phases began, with the stage that began.
    pub begun: Vec<(S, [S; N], Stage<S>)>,
    /// Number of times the vehicle has left the atmosphere and flown on.
    pub exits: u32,
    /// Outcome of the flight.
    pub outcome: Outcome,
    /// Reason of the outcome, where it needs one.
    pub reason: Option<String>,
    /// Evaluations of the right-hand side.
    pub evaluations: u64,
}

/// Choice of the steps of a flight to keep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keep {
    /// All steps.
    All,
    /// Steps in which some load exceeds a small fraction of its largest value so far, and the last: enough for peaks.
    Busy,
}

/// Integrates a motion from a state.
pub fn integrate<'a, M, const N: usize, S>(motion: M, start: [S; N], keep: Keep) -> Record<N, S>
where
    M: Motion<'a, N, S, Lane = M>,
    S: Single,
{
    one(motion, start, keep, &mut Unwatched)
}

/// Integrates a motion and keeps all steps; `progress` gets the part of the fall completed before each step, and may
/// stop there.
pub fn integrate_watched<'a, M, const N: usize>(
    motion: M,
    start: [f64; N],
    progress: &mut dyn Progress,
) -> Record<N>
where
    M: Motion<'a, N, Lane = M>,
{
    one(motion, start, Keep::All, progress)
}

fn one<'a, M, const N: usize, S>(
    motion: M,
    start: [S; N],
    keep: Keep,
    progress: &mut dyn Progress,
) -> Record<N, S>
where
    M: Motion<'a, N, S, Lane = M>,
    S: Single,
{
    let mut only = None;
    let queue = core::iter::once((motion, start));
    let mut done = |_, _: &M, record| {
        only = Some(record);
        ControlFlow::Continue(())
    };
    // A flight that is stopped has its record, too.
    let _ = integrate_all::<M, N, S>(keep, queue, progress, &mut done);
    only.unwrap_or_else(|| Course::new(&Marks::of(&motion, keep), motion, start).into_record())
}

/// Integrates the flights of a queue, as many at a time as there are lanes; each begins when a lane is free, and takes
/// the same steps as it would alone.
///
/// `done` gets the number of a flight in the queue, its motion and its record, in the order in which they end; it may
/// stop the rest. `progress` gets before each step the part of the fall completed on average by the flights under way,
/// and may stop them where they are. Planet, atmosphere, kinds of drag and lift, and the accuracy are those of the
/// first.
pub fn integrate_all<'a, M, const N: usize, S>(
    keep: Keep,
    queue: impl IntoIterator<Item = (M::Lane, [S::Lane; N])>,
    progress: &mut dyn Progress,
    done: &mut impl FnMut(usize, &M::Lane, Record<N, S::Lane>) -> ControlFlow<()>,
) -> ControlFlow<()>
where
    M: Motion<'a, N, S>,
    S: Scalar,
{
    let mut queue = queue.into_iter().enumerate();
    let mut waiting = queue.next();
    let Some((_, (first, start))) = &waiting else {
        return ControlFlow::Continue(());
    };
    let marks = Marks::of(first, keep);
    let mut all = M::everywhere(first);
    let mut y = [S::constant(0.0); N];
    for (all, one) in y.iter_mut().zip(start) {
        (0..S::LANES).for_each(|lane| all.set_lane(lane, *one));
    }
    let method = first.point().mission.solver.method;
    let mut integrator = Integrator::new(method, all.tolerance(), S::constant(0.0), y)
        .with_maximum_steps(MOST_STEPS);
    // number of the flight in the queue and its course, lane by lane
    let mut courses = Vec::new();
    courses.resize_with(S::LANES, || None::<(usize, Course<M::Lane, N, S::Lane>)>);
    let mut limit_s = S::constant(0.0);
    let mut active = S::Mask::constant(false);
    loop {
        for (lane, place) in courses.iter_mut().enumerate() {
            while place.is_none()
                && let Some((index, (motion, start))) = waiting.take().or_else(|| queue.next())
            {
                let mut course = Course::new(&marks, motion, start);
                if course.is_over() {
                    let motion = course.first;
                    done(index, &motion, course.into_record())?;
                } else {
                    integrator.restart(lane, S::Lane::constant(0.0), &start);
                    all.set_lane(lane, &course.motion);
                    limit_s.set_lane(lane, course.limit_s);
                    active.set_lane(lane, true);
                    *place = Some((index, course));
                }
            }
        }
        if !active.any() {
            return ControlFlow::Continue(());
        }
        let (mut parts, mut under_way) = (0.0, 0.0);
        for (_, course) in courses.iter().flatten() {
            parts += course.part_done();
            under_way += 1.0;
        }
        if progress.advance(parts / under_way).is_break() {
            for (lane, place) in courses.iter_mut().enumerate() {
                if let Some((index, mut course)) = place.take() {
                    course.stop();
                    course.record.evaluations = integrator.statistics_of(lane).evaluations;
                    let motion = course.first;
                    done(index, &motion, course.into_record())?;
                }
            }
            return ControlFlow::Break(());
        }
        let mut last = None;
        let mut f = |t: S, y: &[S; N]| {
            let around = all.around(y);
            let slope = all.derivative_in(t, y, &around);
            last = Some(around);
            slope
        };
        let attempt = integrator.attempt(&mut f, limit_s, active);
        let step = integrator.last_step();
        let node = (attempt.accepted.any()).then(|| match &last {
            Some(around) if method.ends_at_end() => Node::within(&all, step.t1, &step.y1, around),
            _ => Node::of(&all, step.t1, &step.y1),
        });
        for (lane, place) in courses.iter_mut().enumerate() {
            let Some((index, course)) = place else {
                continue;
            };
            let next = match &node {
                Some(node) if attempt.accepted.lane(lane) => {
                    course.advance(integrator.last_step(), node, lane)
                }
                _ if attempt.failed.lane(lane) => {
                    course.give_up(&integrator.fault(lane, course.limit_s.value()));
                    Next::Over
                }
                _ => continue,
            };
            limit_s.set_lane(lane, course.limit_s);
            match next {
                Next::On => continue,
                Next::Changed => integrator.renew_lane(lane),
                Next::From(t, y) => integrator.put(lane, t, &y),
                Next::Over => {
                    active.set_lane(lane, false);
                    course.record.evaluations = integrator.statistics_of(lane).evaluations;
                    let index = *index;
                    if let Some((_, course)) = place.take() {
                        let motion = course.first;
                        done(index, &motion, course.into_record())?;
                    }
                    continue;
                }
            }
            all.point_mut().set_lane_state(lane, course.motion.point());
        }
    }
}

/// Error allowed in a step of a point mass; `tolerance` is its relative part.
pub fn point_tolerance(tolerance: f64) -> Tolerance<STATES> {
    let speed = tolerance * SPEED_SCALE_M_S;
    let position = tolerance * POSITION_SCALE_M;
    let load = tolerance * HEAT_LOAD_SCALE_J_M2;
    Tolerance {
        relative: [
            0.0, 0.0, 0.0, tolerance, tolerance, tolerance, tolerance, tolerance,
        ],
        absolute: [
            position, position, position, speed, speed, speed, load, load,
        ],
    }
}
