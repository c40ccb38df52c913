//! Numbers as text, the same in every place and language: point for the decimals, no groups.

/// The shortest text that reads back to the same bits; empty for what is not finite.
pub fn shortest(number: f64) -> String {
    if !number.is_finite() {
        return String::new();
    }
    // Outside of this range an exponent is shorter than the zeros.
    if number == 0.0 || (1e-5..1e16).contains(&number.abs()) {
        format!("{number}")
    } else {
        format!("{number:e}")
    }
}

/// A number in a message: the [`shortest`] text, or a word for a value that is not finite.
pub fn told(number: f64) -> String {
    match number.is_finite() {
        true => shortest(number),
        false => number.to_string(),
    }
}

/// A number for people: rounded to `digits` significant digits, without trailing zeros; empty for what is not finite.
pub fn rounded(number: f64, digits: usize) -> String {
    if !number.is_finite() {
        return String::new();
    }
    // The text rounds decimally; the number nearest to it has that text as its shortest.
    let text = format!("{number:.*e}", digits.saturating_sub(1));
    text.parse().map_or(text, shortest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_text_reads_back_to_the_same_bits() {
        for number in [
            0.1 + 0.2,
            1e-7,
            3.986e14,
            -12_000.0,
            5e-324,
            f64::MAX,
            1.0 / 3.0,
        ] {
            assert_eq!(shortest(number).parse::<f64>(), Ok(number));
        }
        assert_eq!(shortest(12_000.0), "12000");
        assert_eq!(shortest(1e-7), "1e-7");
        assert_eq!(shortest(f64::NAN), "");
        assert_eq!(told(1e300), "1e300");
        assert_eq!(told(f64::INFINITY), "inf");
    }

    #[test]
    fn people_see_as_many_digits_as_they_ask_for() {
        assert_eq!(rounded(29.843_812_3, 6), "29.8438");
        assert_eq!(rounded(158_255_812.0, 6), "158256000");
        assert_eq!(rounded(-0.000_012_345_67, 3), "-0.0000123");
        assert_eq!(rounded(0.0, 6), "0");
        assert_eq!(rounded(1302.0, 6), "1302");
    }
}
