//! Initial value problems y' = f(t, y), forward in t: explicit Runge-Kutta with step control and dense output.
//!
//! An [`Integrator`] takes one step at a time, independent of the meaning of its equations; the caller inspects each
//! [`Step`], finds events on it ([`event`]), repeats it so that it ends there ([`Integrator::retake`]) or continues
//! from within it ([`Integrator::put`]), and reports when the right-hand side has changed ([`Integrator::renew`]). Over
//! [`crate::scalar::Lanes`] it is many integrations side by side, each with its own time and steps
//! ([`Integrator::attempt`]).
//!
//! ```
//! use numerics::ode::{Integrator, Method, Tolerance};
//!
//! let tolerance = Tolerance { relative: [1e-9], absolute: [1e-9] };
//! let mut integrator = Integrator::new(Method::DormandPrince54, tolerance, 0.0, [1.0]);
//! let mut decay = |_t: f64, y: &[f64; 1]| [-y[0]];
//! while integrator.t() < 1.0 {
//!     integrator.step(&mut decay, 1.0)?;
//! }
//! assert!((integrator.y()[0] - 0.36787944117).abs() < 1e-8);
//! # Ok::<(), numerics::ode::OdeError>(())
//! ```
//!
//! # References
//! - \[hairer-norsett-wanner-1993\] sections II.4 (step control, first step), II.5 and II.6 (formulae, dense output).

mod control;
mod dormand_prince_54;
mod dormand_prince_853;
pub mod event;
mod formula;
mod integrator;
mod rk4;
mod step;

pub use control::Tolerance;
pub use integrator::{Attempt, Integrator, Statistics};
pub use step::Step;

/// The formula that takes the steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// Order 5 with an error of order 4, dense output of order 4; six evaluations a step.
    DormandPrince54,
    /// Order 8 with errors of order 5 and 3, dense output of order 7; twelve evaluations a step and three for the
    /// dense output (see [`Dense`]).
    DormandPrince853,
    /// The classical formula of order 4 at a fixed step, dense output of order 3; four evaluations a step.
    Rk4 {
        /// Length of a step, in the unit of t.
        step: f64,
    },
}

impl Method {
    /// Whether the last evaluation of a step that is accepted is at its end.
    #[inline]
    pub fn ends_at_end(self) -> bool {
        matches!(self, Method::DormandPrince54)
    }
}

/// Effort spent on the interpolation within a step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Dense {
    /// The interpolation that belongs to the method, computed with every step.
    #[default]
    Full,
    /// No extra evaluation: order 7 of [`Method::DormandPrince853`] becomes order 3; the other methods lose nothing.
    Hermite,
}

/// Reason why no step could be taken.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum OdeError {
    /// The tolerance cannot be met, or the fixed step is not a positive number.
    #[error("the step became too small at t = {t}")]
    StepTooSmall {
        /// Start of the step.
        t: f64,
    },
    /// The right-hand side, or what follows from it, is infinite or not a number.
    #[error("the right-hand side is not finite at t = {t}")]
    NotFinite {
        /// Start of the step.
        t: f64,
    },
    /// The allowance of [`Integrator::with_maximum_steps`] is used up.
    #[error("too many steps: stopped at t = {t}")]
    TooManySteps {
        /// Present time of the integration.
        t: f64,
    },
    /// The requested end is not ahead of the start of the step, or, for a retake, not within the last step.
    #[error("a step from t = {t} cannot end at t = {end}")]
    Unreachable {
        /// Start of the step.
        t: f64,
        /// Requested end.
        end: f64,
    },
}
