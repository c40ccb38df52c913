//! How often a job is repeated until its time is known.

/// Time that a batch takes at least, ms: far above the grain of browsers' clocks, which is up to 1 ms.
const BATCH_MS: f64 = 20.0;
/// Time for which a job is measured at least, ms.
const ALL_MS: f64 = 300.0;
/// Batches of which the median is taken at least.
const BATCHES_MIN: usize = 9;

/// Batches of one job.
#[derive(Clone, Debug)]
pub struct Timing {
    /// Repetitions in the next batch.
    pub repetitions: u32,
    /// Time of one repetition in each batch, ms.
    samples_ms: Vec<f64>,
    /// Time of all batches, ms.
    all_ms: f64,
}

impl Default for Timing {
    fn default() -> Timing {
        Timing {
            repetitions: 1,
            samples_ms: Vec::new(),
            all_ms: 0.0,
        }
    }
}

impl Timing {
    /// Takes the time of a batch, ms. Batches that are too short, at first, only make the next one longer; meanwhile the
    /// browser compiles what it repeats.
    pub fn take(&mut self, batch_ms: f64) {
        if self.samples_ms.is_empty() && batch_ms < BATCH_MS {
            self.repetitions = self.repetitions.saturating_mul(2);
            return;
        }
        self.samples_ms.push(batch_ms / f64::from(self.repetitions));
        self.all_ms += batch_ms;
    }

    /// Whether this is enough.
    pub fn is_done(&self) -> bool {
        self.all_ms >= ALL_MS && self.samples_ms.len() >= BATCHES_MIN
    }

    /// Time of one repetition, ms: median over the batches.
    pub fn median_ms(&self) -> Option<f64> {
        let mut sorted = self.samples_ms.clone();
        sorted.sort_by(f64::total_cmp);
        sorted.get(sorted.len() / 2).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_job_of_1_ms_is_measured_in_ten_batches_of_32() {
        let mut timing = Timing::default();
        let mut batches = 0;
        while !timing.is_done() {
            batches += 1;
            timing.take(f64::from(timing.repetitions));
        }
        // 1, 2, 4, 8, 16 are too short; 10 x 32 ms >= 300 ms.
        assert_eq!((timing.repetitions, batches), (32, 5 + 10));
        assert_eq!(timing.median_ms(), Some(1.0));
    }

    #[test]
    fn a_busy_moment_does_not_move_the_median() {
        let mut timing = Timing::default();
        [30.0, 31.0, 900.0].map(|batch_ms| timing.take(batch_ms));
        assert_eq!(timing.median_ms(), Some(31.0));
        assert!(!timing.is_done(), "three batches are too few");
    }
}
