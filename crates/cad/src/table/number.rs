//! Numbers of a file: one decimal sign for the whole file.
//!
//! ```text
//! 1.2250  0,7361  1.5e-3  1.234,5  1,234.5  1,234,567    determine the decimal sign
//! 1.400  1,212                                           ambiguous: decimal sign or thousands separator
//! ```
//!
//! A decimal sign that one number determines holds for the file. Two different decimal signs are a fault, and so is a
//! sign that may separate thousands where the file uses the other one for decimals; but a column of altitudes in m or
//! ft without any decimal sign may have thousands separators. Where nothing is determined, the point is the decimal
//! sign, and the comma only where semicolons separate the cells.
//!
//! # Valid
//! Digits 0 to 9, exponents with e, E, d or D.
//!
//! # References
//! - Own convention.

use super::TableFault;
use super::separator::Separator;
use super::shown;
use std::borrow::Cow;

/// Words for missing values.
const HOLES: [&str; 9] = ["", "-", "--", "---", "nan", "na", "n/a", "null", "none"];
/// Numbers that stand for missing values.
const HOLE_NUMBERS: [f64; 3] = [-999.0, -9999.0, -99999.0];

/// Whether a cell is a number with either decimal sign.
pub fn is_number(cell: &str) -> bool {
    Parts::of(cell).is_some()
}

/// Whether a cell is a number or marks a missing value.
pub fn is_number_or_hole(cell: &str) -> bool {
    is_hole(cell) || is_number(cell)
}

/// Whether a cell marks a missing value.
pub fn is_hole(cell: &str) -> bool {
    HOLES.iter().any(|hole| cell.eq_ignore_ascii_case(hole))
}

/// Parts of a number as typed.
struct Parts<'c> {
    negative: bool,
    /// Digits, points and commas.
    body: Cow<'c, str>,
    exponent: &'c str,
}

/// Evidence of a number for the decimal sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Evidence {
    /// None: digits only.
    Nothing,
    /// The sign is a decimal sign.
    Proof(char),
    /// The sign is a decimal sign or a thousands separator.
    Either(char),
    /// Not a number with either sign.
    Malformed,
}

impl<'c> Parts<'c> {
    fn of(cell: &'c str) -> Option<Self> {
        let cell = cell.trim();
        let (negative, unsigned) = match cell.strip_prefix(['-', '−']) {
            Some(rest) => (true, rest),
            None => (false, cell.strip_prefix('+').unwrap_or(cell)),
        };
        let at = unsigned.find(['e', 'E', 'd', 'D']);
        let (body, exponent) = match at {
            Some(at) => (unsigned.get(..at)?, unsigned.get(at + 1..)?),
            None => (unsigned, "0"),
        };
        let digits = exponent.strip_prefix(['+', '-']).unwrap_or(exponent);
        let whole = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
        if !whole(digits) || !body.contains(|c: char| c.is_ascii_digit()) {
            return None;
        }
        // no-break and thin spaces and apostrophes only ever separate thousands
        let groups = ['\u{a0}', '\u{202f}', '\u{2009}', '\'', '’'];
        let body = if body.contains(groups) {
            let sound = body.split(groups).enumerate().all(|(n, part)| {
                let part = part.split(['.', ',']).next().unwrap_or_default();
                whole(part)
                    && (if n == 0 {
                        part.len() <= 3
                    } else {
                        part.len() == 3
                    })
            });
            if !sound {
                return None;
            }
            Cow::Owned(body.replace(groups, ""))
        } else {
            Cow::Borrowed(body)
        };
        let fits = body
            .bytes()
            .all(|b| b.is_ascii_digit() || b == b'.' || b == b',');
        let ends = body.ends_with(',');
        (fits && !ends).then_some(Parts {
            negative,
            body,
            exponent,
        })
    }

    fn evidence(&self) -> Evidence {
        let marks = |sign: char| self.body.matches(sign).count();
        let in_groups = |sign: char, text: &str| {
            text.split(sign).enumerate().all(|(n, part)| {
                if n == 0 {
                    (1..=3).contains(&part.len()) && !part.starts_with('0')
                } else {
                    part.len() == 3
                }
            })
        };
        match (marks('.'), marks(',')) {
            (0, 0) => Evidence::Nothing,
            (0, n) | (n, 0) => {
                let (sign, other) = if marks('.') == 0 {
                    (',', '.')
                } else {
                    ('.', ',')
                };
                let groups = in_groups(sign, &self.body);
                match (n, groups, self.exponent) {
                    (1, true, "0") => Evidence::Either(sign),
                    (1, ..) => Evidence::Proof(sign),
                    (_, true, _) => Evidence::Proof(other),
                    _ => Evidence::Malformed,
                }
            }
            _ => {
                let last = self.body.chars().rev().find(|c| matches!(c, '.' | ','));
                let sign = last.unwrap_or('.');
                let other = if sign == '.' { ',' } else { '.' };
                let whole = self.body.split(sign).next().unwrap_or_default();
                if marks(sign) == 1 && in_groups(other, whole) {
                    Evidence::Proof(sign)
                } else {
                    Evidence::Malformed
                }
            }
        }
    }

    fn value(&self, decimal: char) -> Option<f64> {
        let other = if decimal == '.' { ',' } else { '.' };
        let sign = if self.negative { "-" } else { "" };
        let body = self.body.replace(other, "").replace(decimal, ".");
        let spelled = match self.exponent {
            "0" => format!("{sign}{body}"),
            exponent => format!("{sign}{body}e{exponent}"),
        };
        spelled.parse().ok().filter(|value: &f64| value.is_finite())
    }
}

/// Content of a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cell {
    /// A number.
    Number(f64),
    /// Missing value.
    Hole,
    /// Anything else.
    Words,
}

/// Spelling of the numbers of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Spelling {
    /// Decimal sign.
    pub decimal: char,
}

impl Spelling {
    /// The spelling determined by the cells, each with its line.
    pub fn of<'c>(
        cells: impl Iterator<Item = (u64, &'c str)>,
        separator: Separator,
    ) -> Result<Self, TableFault> {
        let (mut proven, mut either) = ([None; 2], [None; 2]);
        for (line, cell) in cells {
            let Some(parts) = Parts::of(cell) else {
                continue;
            };
            let (first, sign) = match parts.evidence() {
                Evidence::Proof(sign) => (&mut proven, sign),
                Evidence::Either(sign) => (&mut either, sign),
                Evidence::Nothing | Evidence::Malformed => continue,
            };
            let place = &mut first[usize::from(sign == ',')];
            *place = place.or(Some((line, cell)));
        }
        let decimal = match (proven, either) {
            ([Some((line_a, a)), Some((line_b, b))], _) => {
                return Err(TableFault::TwoDecimalSigns {
                    lines: [line_a, line_b],
                    texts: [shown(a), shown(b)],
                });
            }
            ([Some(_), None], _) => '.',
            ([None, Some(_)], _) => ',',
            ([None, None], [Some((line_a, a)), Some((line_b, b))]) => {
                return Err(TableFault::TwoDecimalSigns {
                    lines: [line_a, line_b],
                    texts: [shown(a), shown(b)],
                });
            }
            ([None, None], [None, Some((line, text))]) => {
                if separator != Separator::Sign(';') {
                    return Err(TableFault::Thousands {
                        line,
                        text: shown(text),
                    });
                }
                ','
            }
            _ => '.',
        };
        Ok(Spelling { decimal })
    }

    /// Content of a cell.
    pub fn read(self, cell: &str) -> Cell {
        if is_hole(cell) {
            return Cell::Hole;
        }
        let parts = Parts::of(cell).filter(|parts| parts.evidence() != Evidence::Malformed);
        match parts.and_then(|parts| parts.value(self.decimal)) {
            Some(value) if HOLE_NUMBERS.contains(&value) => Cell::Hole,
            Some(value) => Cell::Number(value),
            None => Cell::Words,
        }
    }

    /// Whether a cell is ambiguous: its only sign is not the decimal sign of the file, but could be one.
    pub fn is_doubtful(self, cell: &str) -> bool {
        let evidence = Parts::of(cell).map(|parts| parts.evidence());
        matches!(evidence, Some(Evidence::Either(sign)) if sign != self.decimal)
    }

    /// Whether a cell contains the decimal sign of the file and not the other sign.
    pub fn has_plain_decimals(self, cell: &str) -> bool {
        let parts = Parts::of(cell);
        parts.is_some_and(|parts| {
            let other = if self.decimal == '.' { ',' } else { '.' };
            parts.body.contains(self.decimal) && !parts.body.contains(other)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spelling(cells: &[&str], separator: char) -> Result<Spelling, TableFault> {
        let lines = cells
            .iter()
            .enumerate()
            .map(|(i, cell)| (i as u64 + 1, *cell));
        Spelling::of(lines, Separator::Sign(separator))
    }

    #[test]
    fn the_file_proves_its_decimal_sign() {
        for (cells, decimal) in [
            (&["1.400", "0.5"][..], '.'),
            (&["1,400", "0,5"], ','),
            (&["1.234,5", "7"], ','),
            (&["1,234.5", "7"], '.'),
            (&["1.234.567"], ','),
            (&["1,5e3"], ','),
            (&["1.225"], '.'),
            (&["12"], '.'),
        ] {
            assert_eq!(spelling(cells, '\t').unwrap().decimal, decimal, "{cells:?}");
        }
        assert_eq!(spelling(&["1,225"], ';').unwrap().decimal, ',');
    }

    #[test]
    fn what_may_be_two_things_is_refused() {
        let said = |cells: &[&str]| spelling(cells, '\t').unwrap_err().to_string();
        assert!(
            said(&["5,000", "7"]).starts_with("line 1: got \"5,000\""),
            "{}",
            said(&["5,000"])
        );
        assert!(said(&["0.5", "1", "0,5"]).contains("\"0.5\" (line 1) and \"0,5\" (line 3)"));
        assert!(said(&["1.400", "1,212"]).contains("decimal sign"));
    }

    #[test]
    fn cells_as_numbers() {
        let point = Spelling { decimal: '.' };
        let comma = Spelling { decimal: ',' };
        assert_eq!(point.read("1,234.5"), Cell::Number(1234.5));
        assert_eq!(comma.read("1.234,5"), Cell::Number(1234.5));
        assert_eq!(point.read("1.5D-03"), Cell::Number(1.5e-3));
        assert_eq!(point.read("−2"), Cell::Number(-2.0));
        assert_eq!(point.read(".5"), Cell::Number(0.5));
        assert_eq!(comma.read("1\u{a0}000,5"), Cell::Number(1000.5));
        assert_eq!(point.read("1'000"), Cell::Number(1000.0));
        for hole in ["", "NaN", "-", "-9999.00", "N/A"] {
            assert_eq!(point.read(hole), Cell::Hole, "{hole}");
        }
        for words in [
            "dense", "inf", "1 000", "5,", "1,2,3", "1.2.3", "1e", "0x10", "1,2.3,4", "1e400",
            "1'00", "e5", ",", ".",
        ] {
            assert_eq!(point.read(words), Cell::Words, "{words}");
        }
        assert!(
            point.is_doubtful("5,000")
                && !point.is_doubtful("1,000.5")
                && !point.is_doubtful("1.400")
        );
    }
}
