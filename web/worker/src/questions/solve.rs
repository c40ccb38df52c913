//! A design.

use crate::clock::now_ms;
use crate::desk::Desk;
use crate::protocol::{Fault, Question, faults};
use msape::problem::design_watched;
use msape::progress::Progress;
use msape::{Answer, Case, Request};
use serde::{Deserialize, Serialize};

/// Asks for the design of a case.
#[derive(Debug, Serialize, Deserialize)]
pub struct Solve(pub Case);

/// Design of a case.
#[derive(Debug, Serialize, Deserialize)]
pub struct Solution {
    /// Answer.
    pub answer: Answer,
    /// Solution time, ms.
    pub duration_ms: f64,
}

impl Question for Solve {
    type Answer = Solution;
    type Refusal = Vec<Fault>;

    fn answer(self, desk: &Desk, progress: &mut dyn Progress) -> Result<Solution, Vec<Fault>> {
        let start_ms = now_ms();
        let answer = design_watched(&self.0, &desk.library, Request::Steps, progress);
        Ok(Solution {
            answer: answer.map_err(faults)?,
            duration_ms: now_ms() - start_ms,
        })
    }
}
