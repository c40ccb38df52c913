//! Number of repetitions needed to time a job.

/// Shortest duration of a batch, ms: far above the resolution of browser clocks, which is up to 1 ms.
const BATCH_MS: f64 = 20.0;
/// Shortest total duration of a measurement, ms.
const ALL_MS: f64 = 300.0;
/// Least number of batches for the median.
const BATCHES_MIN: usize = 9;

/// Measurement of one job.
#[derive(Clone, Debug)]
pub struct Timing {
    /// Repetitions of the next batch.
    pub repetitions: u32,
    batches: Vec<Measured>,
    /// Total duration of the batches, ms.
    all_ms: f64,
}

/// Measured time of a job.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// Time of one repetition, ms.
    pub time_ms: f64,
    /// Ratio to the time of the reference.
    pub ratio: f64,
}

impl Default for Timing {
    fn default() -> Timing {
        Timing {
            repetitions: 1,
            batches: Vec::new(),
            all_ms: 0.0,
        }
    }
}

impl Timing {
    /// Whether a batch of this duration, ms, is too short to count; the next is then twice as long. Meanwhile the
    /// browser compiles the code.
    pub fn is_short(&mut self, batch_ms: f64) -> bool {
        let short = self.batches.is_empty() && batch_ms < BATCH_MS;
        if short {
            self.repetitions = self.repetitions.saturating_mul(2);
        }
        short
    }

    /// Adds the duration of a batch, ms, and that of one repetition of the reference measured beside it, ms: load on
    /// the machine affects both.
    pub fn take(&mut self, batch_ms: f64, reference_ms: f64) {
        let time_ms = batch_ms / f64::from(self.repetitions);
        let ratio = time_ms / reference_ms;
        self.batches.push(Measured { time_ms, ratio });
        self.all_ms += batch_ms;
    }

    /// Whether there are enough measurements.
    pub fn is_done(&self) -> bool {
        self.all_ms >= ALL_MS && self.batches.len() >= BATCHES_MIN
    }

    /// Median of the batches.
    pub fn median(&self) -> Option<Measured> {
        let median = |of: fn(&Measured) -> f64| {
            let mut sorted: Vec<f64> = self.batches.iter().map(of).collect();
            sorted.sort_unstable_by(f64::total_cmp);
            sorted.get(sorted.len() / 2).copied()
        };
        Some(Measured {
            time_ms: median(|batch| batch.time_ms)?,
            ratio: median(|batch| batch.ratio)?,
        })
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
            let batch_ms = f64::from(timing.repetitions);
            if !timing.is_short(batch_ms) {
                timing.take(batch_ms, 0.5);
            }
        }
        // 1, 2, 4, 8, 16 are too short; 10 × 32 ms ≥ 300 ms
        assert_eq!((timing.repetitions, batches), (32, 5 + 10));
        let (time_ms, ratio) = (1.0, 2.0);
        assert_eq!(timing.median(), Some(Measured { time_ms, ratio }));
    }

    #[test]
    fn a_busy_moment_moves_neither_median() {
        let mut timing = Timing::default();
        // load on the machine in the third batch affects both, in the fourth only the job
        for (batch_ms, reference_ms) in [
            (30.0, 10.0),
            (31.0, 10.0),
            (900.0, 300.0),
            (99.0, 10.0),
            (29.0, 10.0),
        ] {
            timing.take(batch_ms, reference_ms);
        }
        let (time_ms, ratio) = (31.0, 3.0);
        assert_eq!(timing.median(), Some(Measured { time_ms, ratio }));
        assert!(!timing.is_done(), "five batches are too few");
    }
}
