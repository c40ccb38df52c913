//! Numbers as typed: `11.56 km/s`, `38e3 ft/s`, `11,56`, `=1.3*0.25/2 m`.

use super::{Dimension, Unit, canonical, units_of};
use thiserror::Error;

/// Reason why a typed number was not understood.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum TextError {
    /// Nothing was typed.
    #[error("empty: type a number, such as 12 or 1.2e4")]
    Empty,
    /// The text is not a number.
    #[error("\"{0}\" is not a number")]
    NotANumber(String),
    /// A comma that could divide thousands or decimals.
    #[error("\"{0}\" could mean {1} or {2}: write it without the comma")]
    AmbiguousComma(String, String, String),
    /// The unit is not known, or has another dimension.
    #[error("unit \"{unit}\" does not fit here: use one of {known}")]
    UnknownUnit {
        /// Unit as typed.
        unit: String,
        /// The units that fit.
        known: String,
    },
}

/// Largest number of characters of a key or a text that a message repeats.
pub(crate) const SHOWN_MAX: usize = 100;

/// A text short enough for a message.
pub(crate) fn cut(text: &str) -> String {
    match text.char_indices().nth(SHOWN_MAX) {
        Some((end, _)) => format!("{}…", text.get(..end).unwrap_or_default()),
        None => text.to_string(),
    }
}

/// Reads a number with an optional unit into the canonical unit of `dimension`; without a unit it is in `default`.
///
/// Accepts a decimal comma, and a sum or product after `=`.
///
/// # Errors
/// [`TextError`] with the text that was not understood and the units that fit.
pub fn parse_number(text: &str, dimension: Dimension, default: &Unit) -> Result<f64, TextError> {
    let text = text.trim().replace('\u{2212}', "-");
    if text.is_empty() {
        return Err(TextError::Empty);
    }
    let (number, symbol) = split_unit(&text);
    if !number.contains(|c: char| c.is_ascii_digit()) {
        return Err(TextError::NotANumber(cut(&text)));
    }
    let unit = if symbol.is_empty() {
        default
    } else {
        find_unit(symbol, dimension)?
    };
    let value = match number.strip_prefix('=') {
        Some(sum) => expression(sum.trim()).ok_or_else(|| TextError::NotANumber(cut(number)))?,
        None => plain_number(number)?,
    };
    if !value.is_finite() {
        return Err(TextError::NotANumber(cut(number)));
    }
    Ok(unit.to_canonical(value))
}

/// Divides `11.56 km/s` into the number and the unit; an exponent such as `1e4` belongs to the number.
fn split_unit(text: &str) -> (&str, &str) {
    let bytes = text.as_bytes();
    for (i, c) in text.char_indices() {
        let exponent = (c == 'e' || c == 'E')
            && i > 0
            && (bytes[i - 1].is_ascii_digit() || bytes[i - 1] == b'.')
            && text[i + 1..]
                .trim_start_matches(['+', '-'])
                .starts_with(|d: char| d.is_ascii_digit());
        if (c.is_alphabetic() && !exponent) || c == '%' || c == '°' {
            return (text[..i].trim_end(), text[i..].trim());
        }
    }
    (text, "")
}

fn find_unit(symbol: &str, dimension: Dimension) -> Result<&'static Unit, TextError> {
    let plain = symbol
        .replace('²', "^2")
        .replace('³', "^3")
        .replace('·', "-")
        .replace('°', if symbol == "°" { "deg" } else { "" });
    let same = |unit: &&Unit| unit.symbol == plain;
    let without_caret = |unit: &&Unit| unit.symbol.replace('^', "") == plain.replace('^', "");
    units_of(dimension)
        .find(same)
        .or_else(|| units_of(dimension).find(without_caret))
        .or_else(|| (dimension == Dimension::Load && plain == "g").then(|| canonical(dimension)))
        .ok_or_else(|| TextError::UnknownUnit {
            unit: cut(symbol),
            known: units_of(dimension)
                .map(|unit| {
                    if unit.symbol.is_empty() {
                        "(none)"
                    } else {
                        unit.symbol
                    }
                })
                .collect::<Vec<_>>()
                .join(", "),
        })
}

fn plain_number(text: &str) -> Result<f64, TextError> {
    let compact: String = text
        .chars()
        .filter(|c| !c.is_whitespace() && *c != '_')
        .collect();
    let fault = || TextError::NotANumber(cut(text));
    let numeric = |s: &str| {
        let ok = s
            .bytes()
            .all(|b| b.is_ascii_digit() || b"+-.eE".contains(&b));
        if ok { s.parse::<f64>().ok() } else { None }
    };
    match compact.matches(',').count() {
        0 => numeric(&compact).ok_or_else(fault),
        1 if !compact.contains('.') => {
            let decimal = compact.replace(',', ".");
            let value = numeric(&decimal).ok_or_else(fault)?;
            let (whole, rest) = compact.split_once(',').unwrap_or((&compact, ""));
            let whole = whole.trim_start_matches(['+', '-']);
            let looks_like_thousands = rest.len() == 3
                && rest.bytes().all(|b| b.is_ascii_digit())
                && (1..=3).contains(&whole.len())
                && !whole.starts_with('0');
            if looks_like_thousands {
                return Err(TextError::AmbiguousComma(
                    cut(text),
                    compact.replace(',', ""),
                    decimal,
                ));
            }
            Ok(value)
        }
        _ => Err(fault()),
    }
}

/// A sum of products of numbers with parentheses, such as `1.3*(0.25 + 0.1)/2`.
fn expression(text: &str) -> Option<f64> {
    let mut rest = text;
    let value = sum(&mut rest, 0)?;
    rest.trim().is_empty().then_some(value)
}

/// Parentheses deeper than this are refused, so that no input can exhaust the stack.
const DEPTH_MAX: usize = 32;

fn sum(rest: &mut &str, depth: usize) -> Option<f64> {
    let mut value = product(rest, depth)?;
    loop {
        *rest = rest.trim_start();
        if let Some(after) = rest.strip_prefix('+') {
            *rest = after;
            value += product(rest, depth)?;
        } else if let Some(after) = rest.strip_prefix('-') {
            *rest = after;
            value -= product(rest, depth)?;
        } else {
            return Some(value);
        }
    }
}

fn product(rest: &mut &str, depth: usize) -> Option<f64> {
    let mut value = factor(rest, depth)?;
    loop {
        *rest = rest.trim_start();
        if let Some(after) = rest.strip_prefix('*') {
            *rest = after;
            value *= factor(rest, depth)?;
        } else if let Some(after) = rest.strip_prefix('/') {
            *rest = after;
            value /= factor(rest, depth)?;
        } else {
            return Some(value);
        }
    }
}

fn factor(rest: &mut &str, depth: usize) -> Option<f64> {
    *rest = rest.trim_start();
    if depth > DEPTH_MAX {
        return None;
    }
    if let Some(after) = rest.strip_prefix('-') {
        *rest = after;
        return Some(-factor(rest, depth + 1)?);
    }
    if let Some(after) = rest.strip_prefix('(') {
        *rest = after;
        let value = sum(rest, depth + 1)?;
        *rest = rest.trim_start().strip_prefix(')')?;
        return Some(value);
    }
    let bytes = rest.as_bytes();
    let mut end = 0;
    while end < bytes.len() {
        let sign_of_exponent = (bytes[end] == b'-' || bytes[end] == b'+')
            && end > 0
            && (bytes[end - 1] == b'e' || bytes[end - 1] == b'E');
        if bytes[end].is_ascii_digit() || b".eE".contains(&bytes[end]) || sign_of_exponent {
            end += 1;
        } else {
            break;
        }
    }
    let value = rest[..end].parse().ok()?;
    *rest = &rest[end..];
    Some(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn speed(text: &str) -> Result<f64, TextError> {
        parse_number(text, Dimension::Speed, canonical(Dimension::Speed))
    }

    #[test]
    fn units_and_decimal_commas_are_understood() {
        assert_eq!(speed("11.56 km/s"), Ok(11560.0));
        assert_eq!(speed("11,56km/s"), Ok(11560.0));
        assert!((speed("38000 ft/s").unwrap() - 11582.4).abs() < 1e-9);
        assert_eq!(speed("1.2e4"), Ok(12000.0));
        assert_eq!(speed("0,125"), Ok(0.125));
        assert_eq!(speed("\u{2212}5"), Ok(-5.0));
    }

    #[test]
    fn sums_after_an_equals_sign() {
        assert_eq!(speed("=1.3*0.25/2"), Ok(1.3 * 0.25 / 2.0));
        assert_eq!(speed("= (10 + 2)*1e3 m/s"), Ok(12000.0));
        assert_eq!(speed("=-(2-5)"), Ok(3.0));
    }

    #[test]
    fn angles_loads_and_temperatures() {
        let angle = canonical(Dimension::Angle);
        assert_eq!(parse_number("-25°", Dimension::Angle, angle), Ok(-25.0));
        assert_eq!(
            parse_number(
                "20 °C",
                Dimension::Temperature,
                canonical(Dimension::Temperature)
            ),
            Ok(293.15)
        );
        assert_eq!(
            parse_number("1500 g", Dimension::Load, canonical(Dimension::Load)),
            Ok(1500.0)
        );
        let flux = canonical(Dimension::HeatFlux);
        assert_eq!(
            parse_number("1200 W/cm²", Dimension::HeatFlux, flux),
            Ok(1.2e7)
        );
        assert_eq!(
            parse_number("1200 W/cm2", Dimension::HeatFlux, flux),
            Ok(1.2e7)
        );
    }

    #[test]
    fn what_is_not_a_number_says_so() {
        assert_eq!(speed(""), Err(TextError::Empty));
        assert!(matches!(
            speed("12,000"),
            Err(TextError::AmbiguousComma(..))
        ));
        assert_eq!(speed("abc"), Err(TextError::NotANumber("abc".to_string())));
        assert!(matches!(speed("12 kg"), Err(TextError::UnknownUnit { .. })));
        assert!(speed("nan").is_err());
        assert!(matches!(speed("1e999"), Err(TextError::NotANumber(_))));
        assert!(matches!(speed("=1/0"), Err(TextError::NotANumber(_))));
        assert!(speed(&format!("={}1", "(".repeat(100_000))).is_err());
        assert!(matches!(speed("1.2.3"), Err(TextError::NotANumber(_))));
    }
}
