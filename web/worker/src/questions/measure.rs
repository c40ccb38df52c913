//! The time of a job of the benchmark.

use crate::clock::now_ms;
use crate::desk::Desk;
use crate::protocol::Question;
use benchmark::{Bench, JOBS};
use msape::library::DataError;
use msape::progress::Progress;
use serde::{Deserialize, Serialize};

/// Asks for the time of repetitions of a job of [`benchmark::JOBS`], ms.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Measure {
    /// Index of the job.
    pub job: u32,
    /// Number of repetitions.
    pub repetitions: u32,
}

impl Question for Measure {
    type Answer = f64;
    type Refusal = String;

    fn answer(self, desk: &Desk, _: &mut dyn Progress) -> Result<f64, String> {
        let bench = desk.bench.get_or_init(Bench::new);
        let bench = bench.as_ref().map_err(DataError::to_string)?;
        let job = JOBS.get(self.job as usize).ok_or("there is no such job")?;
        let start_ms = now_ms();
        (0..self.repetitions).for_each(|_| job(bench));
        Ok(now_ms() - start_ms)
    }
}
