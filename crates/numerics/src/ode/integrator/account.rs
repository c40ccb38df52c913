//! Result of a trial, and cost of an integration.

use crate::scalar::Scalar;

/// Cost of an integration.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Statistics {
    /// Steps taken, each counted once however often it was retaken.
    pub accepted: u64,
    /// Trials refused: too large an error, or not finite.
    pub rejected: u64,
    /// Evaluations of the right-hand side.
    pub evaluations: u64,
}

/// Result of a trial.
#[derive(Clone, Copy, Debug)]
pub struct Attempt<S: Scalar> {
    /// Lanes whose step was accepted; [`super::Integrator::last_step`] is that step.
    pub accepted: S::Mask,
    /// Lanes that cannot go on; [`super::Integrator::fault`] gives the reason.
    pub failed: S::Mask,
}
