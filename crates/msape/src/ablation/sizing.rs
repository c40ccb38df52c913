//! Thickness of the first layer at which the temperature behind a layer keeps its limit.
//!
//! ```text
//! max over t of T_behind(t; L) = T_limit − ΔT
//! L_total = L + m s(L)
//! ```
//!
//! with the limit and its margin ΔT in K, the recession s in m and its margin m.
//!
//! # Valid
//! The temperature behind falls with thickness. Each run goes on until the temperature behind has passed its maximum.
//!
//! # References
//! - \[samareh-2014\] section 3.5: the bond line governs.

use ::ablation::environment::Environment;
use ::ablation::fault::Fault;
use ::ablation::march::{Response, Run};
use ::ablation::settings::{Outcome, Settings};
use ::ablation::stack::Stack;
use core::ops::ControlFlow;
use numerics::math;
use numerics::root;

/// Limit of the temperature behind a layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limit {
    /// Layer, from 0.
    pub layer: usize,
    /// Highest temperature allowed behind it, K, its margin taken off.
    pub temperature_k: f64,
    /// Share of the recession that is added to the thickness.
    pub recession_margin: f64,
}

/// Least and greatest thickness that is tried, m. Assumed: thinner and thicker heat shields are not made.
pub const THICKNESS_M: [f64; 2] = [0.001, 0.3];
/// Width of the bracket of the thickness, relative. Assumed.
const WIDTH: f64 = 1e-4;
/// Least rise of a temperature that counts, K. Assumed.
const LEAST_RISE_K: f64 = 1e-6;
/// Share of the rise by which the limit may be missed. Assumed: far below the error of the steps.
const KEPT: f64 = 3e-5;
/// First step of the search in the logarithm of the thickness.
const STEP: f64 = 0.2;

/// Result of a sizing.
#[derive(Clone, Debug, PartialEq)]
pub struct Sized {
    /// Thickness at which the limit is kept, m; none where it is not kept in the range.
    pub thickness_m: Option<f64>,
    /// Thickness with the margin on recession, m.
    pub with_margin_m: Option<f64>,
    /// Response at the thickness, or at the greatest.
    pub response: Response,
    /// Stack of that response.
    pub stack: Stack,
    /// Runs.
    pub runs: usize,
}

/// The response of a stack whose first layer has a thickness, m; `watch` may stop it.
fn respond(
    stack: &mut Stack,
    thickness_m: f64,
    (environment, settings): (&Environment, &Settings),
    watch: &mut dyn FnMut(f64) -> ControlFlow<()>,
) -> Result<Response, Fault> {
    if let Some(first) = stack.layers.first_mut() {
        first.thickness_m = thickness_m;
    }
    Ok(Run::try_new(stack, environment, settings)?.response(watch))
}

/// Sizes the first layer of a stack.
///
/// # Errors
/// Settings beyond their ranges.
pub fn size(
    stack: &Stack,
    environment: &Environment,
    settings: &Settings,
    limit: &Limit,
    watch: &mut dyn FnMut(f64) -> ControlFlow<()>,
) -> Result<Sized, Fault> {
    let mut stack = stack.clone();
    let given = stack.layers.first().map_or(0.0, |layer| layer.thickness_m);
    // Of the search only the peak counts.
    let silent = Settings {
        output_step_s: None,
        depths_m: Vec::new(),
        ..settings.clone()
    };
    let mut runs = 0;
    let mut fault = None;
    let mut excess = |ln_l: f64| {
        runs += 1;
        match respond(&mut stack, math::exp(ln_l), (environment, &silent), watch) {
            Ok(response) => above(&response, limit),
            Err(found) => {
                fault = Some(found);
                f64::NAN
            }
        }
    };
    let [low, high] = THICKNESS_M.map(math::ln);
    let start = math::ln(given.clamp(THICKNESS_M[0], THICKNESS_M[1]));
    let found = bracketed(&mut excess, start, [low, high]);
    if let Some(fault) = fault {
        return Err(fault);
    }
    let thickness_m = found.map(math::exp);
    let response = respond(
        &mut stack,
        thickness_m.unwrap_or(THICKNESS_M[1]),
        (environment, settings),
        watch,
    )?;
    let recession = response
        .history
        .rows
        .last()
        .map_or(0.0, |row| row.recession_m);
    Ok(Sized {
        thickness_m,
        with_margin_m: thickness_m.map(|l| l + limit.recession_margin * recession),
        response,
        stack,
        runs: runs + 1,
    })
}

/// Logarithm of the thickness from which on the limit is kept, searched from a start; none where it is not kept in the range.
fn bracketed(
    excess: &mut impl FnMut(f64) -> f64,
    start: f64,
    [low, high]: [f64; 2],
) -> Option<f64> {
    let kept = excess(start) <= 0.0;
    let (mut inside, mut step) = (start, STEP);
    loop {
        let next = if kept {
            (inside - step).max(low)
        } else {
            (inside + step).min(high)
        };
        let above = excess(next);
        if (above <= 0.0) != kept {
            let bracket = root::bracket(&mut *excess, inside, next, WIDTH)?;
            // Of the two sides of the root the thicker keeps the limit.
            return bracket.into_iter().reduce(f64::max);
        }
        if above.is_nan() || next == low || next == high {
            return kept.then_some(low).filter(|_| !above.is_nan());
        }
        inside = next;
        step *= 2.0;
    }
}

/// Logarithm of the rise behind over the rise allowed, nearly linear in the thickness; the rise of the wall where the layer is
/// gone, no number where the run did not end.
fn above(response: &Response, limit: &Limit) -> f64 {
    let history = &response.history;
    let peak = match response.outcome {
        Outcome::Finished | Outcome::Cooled => history
            .behind
            .get(limit.layer)
            .map_or(f64::NAN, |peak| peak.temperature_k),
        Outcome::BurntThrough => history.wall.temperature_k,
        Outcome::OutOfWork | Outcome::NotSettled | Outcome::Stopped => f64::NAN,
    };
    let start = history.rows.first().map_or(0.0, |row| row.wall_k);
    let allowed = (limit.temperature_k - start).max(LEAST_RISE_K);
    let excess = math::ln((peak - start).max(LEAST_RISE_K) / allowed);
    if excess.abs() < KEPT { 0.0 } else { excess }
}
