//! Number formatting: grouped thousands, a true minus sign, powers of ten.

use numerics::math::{log10, powi};

/// Narrow no-break space between groups of three digits.
const GROUP: char = '\u{202F}';

/// 10 to an integer power.
pub(crate) fn power_of_ten(n: i32) -> f64 {
    let power = powi(10.0, n.unsigned_abs());
    if n < 0 { 1.0 / power } else { power }
}

/// `m` times 10 to the `n`, correctly rounded for the small `m` of ticks.
pub(crate) fn scaled(m: f64, n: i32) -> f64 {
    let power = powi(10.0, n.unsigned_abs());
    if n < 0 { m / power } else { m * power }
}

/// Exponent of the largest power of ten that is at most `x`, for `x` above 0.
pub(crate) fn decade(x: f64) -> i32 {
    let n = log10(x).floor() as i32;
    // the logarithm of a power of ten may round to either side
    if scaled(1.0, n + 1) <= x {
        n + 1
    } else if scaled(1.0, n) > x {
        n - 1
    } else {
        n
    }
}

/// `value` with `decimals` digits after the point, thousands grouped from 10 000 on.
pub(crate) fn fixed(value: f64, decimals: usize) -> String {
    let digits = format!("{:.*}", decimals, value.abs());
    let (whole, fraction) = digits.split_once('.').unwrap_or((&digits, ""));
    let mut text = String::new();
    if value < 0.0 && digits.bytes().any(|b| (b'1'..=b'9').contains(&b)) {
        text.push('−');
    }
    for (i, c) in whole.chars().enumerate() {
        if i > 0 && whole.len() > 4 && (whole.len() - i).is_multiple_of(3) {
            text.push(GROUP);
        }
        text.push(c);
    }
    if !fraction.is_empty() {
        text.push('.');
        text.push_str(fraction);
    }
    text
}

/// 10ⁿ.
pub(crate) fn ten_to_the(n: i32) -> String {
    let mut text = String::from("10");
    for c in n.to_string().chars() {
        text.push(match c {
            '-' => '⁻',
            '0' => '⁰',
            '1' => '¹',
            '2' => '²',
            '3' => '³',
            '4' => '⁴',
            '5' => '⁵',
            '6' => '⁶',
            '7' => '⁷',
            '8' => '⁸',
            _ => '⁹',
        });
    }
    text
}

/// `value` to `digits` significant digits, with a power of ten where it is very large or small.
pub(crate) fn significant(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return "–".to_owned();
    }
    if value == 0.0 {
        return "0".to_owned();
    }
    let places = digits.max(1) as i32 - 1;
    let n = decade(value.abs());
    // rounding may carry into the next decade: 9.9996 to 4 digits is 10.00
    let mantissa = value / power_of_ten(n);
    let n = if format!("{:.*}", places as usize, mantissa.abs()).starts_with("10") {
        n + 1
    } else {
        n
    };
    if (-4..6).contains(&n) {
        trimmed(fixed(value, (places - n).max(0) as usize))
    } else {
        let mantissa = trimmed(fixed(value / power_of_ten(n), places as usize));
        format!("{mantissa}×{}", ten_to_the(n))
    }
}

/// The number without trailing zeros in its fraction.
fn trimmed(text: String) -> String {
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thousands_are_grouped_from_five_digits_on() {
        assert_eq!(fixed(1250.0, 0), "1250");
        assert_eq!(fixed(125_000.0, 0), "125\u{202F}000");
        assert_eq!(fixed(-12_345.5, 1), "−12\u{202F}345.5");
        assert_eq!(fixed(-0.001, 1), "0.0");
    }

    #[test]
    fn decades_are_exact_at_powers_of_ten() {
        for n in -20..=20 {
            assert_eq!(decade(scaled(1.0, n)), n);
            assert_eq!(decade(scaled(9.99, n)), n);
        }
    }

    #[test]
    fn significant_digits_are_kept_and_zeros_dropped() {
        assert_eq!(significant(134.256, 4), "134.3");
        assert_eq!(significant(0.5, 5), "0.5");
        assert_eq!(significant(1.302e7, 4), "1.302×10⁷");
        assert_eq!(significant(9.999_96e5, 5), "1×10⁶");
        assert_eq!(significant(-2.5e-6, 3), "−2.5×10⁻⁶");
        assert_eq!(significant(f64::NAN, 3), "–");
    }
}
