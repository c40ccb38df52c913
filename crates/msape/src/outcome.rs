//! How a flight or a design ended.

use serde::{Deserialize, Serialize};

/// Outcome of a flight or a design. None of them is an error.
///
/// ```
/// assert_eq!(msape::Outcome::NotClosed.name(), "not-closed");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Outcome {
    /// The design closed and its mass converged.
    Converged,
    /// The flight reached the ground.
    Landed,
    /// The flight ended at a time or altitude given in the case.
    Stopped,
    /// The vehicle left the atmosphere faster than escape speed.
    SkippedOut,
    /// The vehicle left the atmosphere again on a bound orbit.
    Captured,
    /// The payload fits into no vehicle that the rules allow.
    NotClosed,
    /// The mass had not converged after the last pass.
    NotConverged,
    /// The flight was given up at a limit of work, or where its numbers are no longer reliable.
    GaveUp,
}

impl Outcome {
    /// Name as in files and tables.
    pub fn name(self) -> &'static str {
        match self {
            Outcome::Converged => "converged",
            Outcome::Landed => "landed",
            Outcome::Stopped => "stopped",
            Outcome::SkippedOut => "skipped-out",
            Outcome::Captured => "captured",
            Outcome::NotClosed => "not-closed",
            Outcome::NotConverged => "not-converged",
            Outcome::GaveUp => "gave-up",
        }
    }
}
