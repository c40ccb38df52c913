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
    batches: Vec<Measured>,
    /// Time of all batches, ms.
    all_ms: f64,
}

/// How long a job takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// Time of one repetition, ms.
    pub time_ms: f64,
    /// The same over that of the reference.
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
    /// Whether a batch of this time, ms, is too short to be taken: then the next is twice as long. Meanwhile the browser
    /// compiles what is repeated.
    pub fn is_short(&mut self, batch_ms: f64) -> bool {
        let short = self.batches.is_empty() && batch_ms < BATCH_MS;
        if short {
            self.repetitions = self.repetitions.saturating_mul(2);
        }
        short
    }

    /// Takes the time of a batch, ms, and that of one repetition of the reference beside it, ms: a busy moment of the
    /// machine meets both.
    pub fn take(&mut self, batch_ms: f64, reference_ms: f64) {
        let time_ms = batch_ms / f64::from(self.repetitions);
        let ratio = time_ms / reference_ms;
        self.batches.push(Measured { time_ms, ratio });
        self.all_ms += batch_ms;
    }

    /// Whether this is enough.
    pub fn is_done(&self) -> bool {
        self.all_ms >= ALL_MS && self.batches.len() >= BATCHES_MIN
    }

    /// Medians over the batches.
    pub fn median(&self) -> Option<Measured> {
        let median = |of: fn(&Measured) -> f64| {
            let mut sorted: Vec<f64> = self.batches.iter().map(of).collect();
            sorted.sort_by(f64::total_cmp);
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
        // 1, 2, 4, 8, 16 are too short; 10 x 32 ms >= 300 ms.
        assert_eq!((timing.repetitions, batches), (32, 5 + 10));
        let (time_ms, ratio) = (1.0, 2.0);
        assert_eq!(timing.median(), Some(Measured { time_ms, ratio }));
    }

    #[test]
    fn a_busy_moment_moves_neither_median() {
        let mut timing = Timing::default();
        // The third batch met it together with the reference, the fourth alone.
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
