//! What a trial has come to, and what an integration has cost.

use crate::scalar::Scalar;

/// What an integration has cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Statistics {
    /// Steps taken, each counted once however often it was retaken.
    pub accepted: u64,
    /// Trials refused: too large an error, or not finite.
    pub rejected: u64,
    /// Evaluations of the right-hand side.
    pub evaluations: u64,
}

/// What became of a trial.
#[derive(Clone, Copy, Debug)]
pub struct Attempt<S: Scalar> {
    /// Lanes whose step was accepted; [`super::Integrator::last_step`] is that step.
    pub accepted: S::Mask,
    /// Lanes that cannot go on; [`super::Integrator::fault`] says why.
    pub failed: S::Mask,
}
