//! Interleaved timing of several jobs, so that load on the machine affects all of them alike.

use super::clock::now;
use std::time::Duration;

/// Number of rounds through all measurements.
const ROUNDS: usize = 101;
/// Least duration of one sample.
const SAMPLE: Duration = Duration::from_millis(2);

/// Measured job.
pub struct Measurement<'a> {
    name: &'static str,
    run: Box<dyn FnMut() + 'a>,
    /// Repetitions per sample.
    repetitions: u32,
    /// Seconds per repetition, one entry per round.
    samples_s: Vec<f64>,
}

impl<'a> Measurement<'a> {
    /// A job with its name.
    pub fn new(name: &'static str, run: impl FnMut() + 'a) -> Self {
        Self {
            name,
            run: Box::new(run),
            repetitions: 1,
            samples_s: Vec::with_capacity(ROUNDS),
        }
    }

    fn sample(&mut self) -> Duration {
        let start = now();
        (0..self.repetitions).for_each(|_| (self.run)());
        now().saturating_sub(start)
    }

    /// Quantile of the samples, s.
    fn quantile(&self, part: f64) -> f64 {
        let last = self.samples_s.len() - 1;
        self.samples_s[(part * last as f64).round() as usize]
    }
}

/// Runs all measurements and prints quartiles and the ratio of the lower quartiles to the first: other programs only
/// add time.
pub fn report(measurements: &mut [Measurement]) {
    for measurement in measurements.iter_mut() {
        while measurement.sample() < SAMPLE {
            measurement.repetitions *= 2;
        }
    }
    for _ in 0..ROUNDS {
        for measurement in measurements.iter_mut() {
            let sample = measurement.sample().as_secs_f64();
            let each = sample / f64::from(measurement.repetitions);
            measurement.samples_s.push(each);
        }
    }
    for measurement in measurements.iter_mut() {
        measurement.samples_s.sort_by(f64::total_cmp);
    }
    let reference = measurements[0].quantile(0.25);
    println!(
        "{:52} {:>10} {:>21} {:>9}",
        "", "median", "quartiles", "ratio"
    );
    for measurement in measurements.iter() {
        let micro = |part| 1e6 * measurement.quantile(part);
        println!(
            "{:52} {:>7.1} us {:>9.1} .. {:>5.1} us {:>9.2}",
            measurement.name,
            micro(0.5),
            micro(0.25),
            micro(0.75),
            measurement.quantile(0.25) / reference
        );
    }
}
