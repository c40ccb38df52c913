//! Statistics of a sample, summed in the order of the sample.
//!
//! Extremes are compared by hand: which zero `f64::min` gives of -0 and 0 is not the same on every platform.

/// Arithmetic mean; `None` of an empty sample.
pub fn mean(sample: &[f64]) -> Option<f64> {
    match sample.len() {
        0 => None,
        n => Some(sample.iter().sum::<f64>() / n as f64),
    }
}

/// Standard deviation with the divisor n - 1; `None` of fewer than two.
pub fn sample_standard_deviation(sample: &[f64]) -> Option<f64> {
    let n = sample.len();
    let mean = mean(sample).filter(|_| n > 1)?;
    let squares: f64 = sample.iter().map(|x| (x - mean) * (x - mean)).sum();
    // The remaining sum of the deviations is the rounding of the mean.
    let rest: f64 = sample.iter().map(|x| x - mean).sum();
    Some(
        ((squares - rest * rest / n as f64) / (n - 1) as f64)
            .max(0.0)
            .sqrt(),
    )
}

/// Smallest of the sample; `None` for an empty one. NaN is skipped unless there is nothing else.
pub fn minimum(sample: &[f64]) -> Option<f64> {
    sample
        .iter()
        .copied()
        .reduce(|a, b| if b < a || a.is_nan() { b } else { a })
}

/// Largest of the sample; `None` for an empty one. NaN is skipped unless there is nothing else.
pub fn maximum(sample: &[f64]) -> Option<f64> {
    sample
        .iter()
        .copied()
        .reduce(|a, b| if b > a || a.is_nan() { b } else { a })
}

/// Value below which `percent` of the sample lie, linear between its members; `None` of an empty sample, of one that
/// holds what is not a number, and outside 0…100.
///
/// ```text
/// x(h) = x₍ₖ₎ + (h - k) (x₍ₖ₊₁₎ - x₍ₖ₎)      h = (n - 1) percent / 100      k = ⌊h⌋, counted from 0
/// ```
///
/// # References
/// - \[hyndman-fan-1996\] definition 7.
pub fn percentile(sample: &[f64], percent: f64) -> Option<f64> {
    let mut sorted = sample.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    percentile_of_sorted(&sorted, percent)
}

/// [`percentile`] of a sample in ascending order: several of them for one sort.
pub fn percentile_of_sorted(sorted: &[f64], percent: f64) -> Option<f64> {
    if !(0.0..=100.0).contains(&percent) || sorted.iter().any(|x| x.is_nan()) {
        return None;
    }
    let h = (sorted.len().checked_sub(1)? as f64) * (percent / 100.0);
    let k = h.floor();
    let below = *sorted.get(k as usize)?;
    let above = *sorted.get(k as usize + 1).unwrap_or(&below);
    let part = h - k;
    Some(if part == 0.0 {
        below
    } else {
        below + part * (above - below)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const SAMPLE: [f64; 8] = [4.0, 2.0, 4.0, 5.0, 4.0, 7.0, 5.0, 9.0];

    #[test]
    fn mean_of_sum_40_over_8_is_5() {
        assert_eq!(mean(&SAMPLE), Some(5.0));
    }

    #[test]
    fn squared_deviations_of_32_over_7() {
        // 1 + 9 + 1 + 0 + 1 + 4 + 0 + 16 = 32
        assert_eq!(
            sample_standard_deviation(&SAMPLE),
            Some((32.0_f64 / 7.0).sqrt())
        );
    }

    #[test]
    fn deviation_does_not_suffer_from_a_large_mean() {
        let far: Vec<f64> = SAMPLE.iter().map(|x| x + 1e9).collect();
        assert_eq!(
            sample_standard_deviation(&far),
            sample_standard_deviation(&SAMPLE)
        );
    }

    #[test]
    fn percentiles_are_linear_between_members() {
        // sorted 2 4 4 4 5 5 7 9: h = 7 · 0.9 = 6.3 → 7 + 0.3 · 2
        assert!((percentile(&SAMPLE, 90.0).unwrap() - 7.6).abs() < 1e-12);
        assert_eq!(percentile(&SAMPLE, 50.0), Some(4.5));
        assert_eq!(
            [0.0, 100.0].map(|p| percentile(&SAMPLE, p)),
            [Some(2.0), Some(9.0)]
        );
    }

    #[test]
    fn extremes() {
        assert_eq!((minimum(&SAMPLE), maximum(&SAMPLE)), (Some(2.0), Some(9.0)));
        assert_eq!(maximum(&[f64::NAN, 1.0]), Some(1.0));
    }

    #[test]
    fn nothing_of_nothing() {
        assert_eq!(mean(&[]), None);
        assert_eq!(sample_standard_deviation(&[1.0]), None);
        assert_eq!(
            (minimum(&[]), maximum(&[]), percentile(&[], 50.0)),
            (None, None, None)
        );
        assert_eq!(percentile(&[1.0], 101.0), None);
        assert_eq!(percentile(&[1.0, f64::NAN], 50.0), None);
        assert_eq!(percentile(&[3.0], 70.0), Some(3.0));
    }
}
