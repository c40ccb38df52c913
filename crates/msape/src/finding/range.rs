//! Ranges in data files, and the findings on values outside them.

use super::{Finding, Severity};
use serde::{Deserialize, Serialize};

/// A closed range, in the unit of its key; an open end is `None`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Range {
    /// Least value.
    pub min: Option<f64>,
    /// Greatest value.
    pub max: Option<f64>,
}

impl Range {
    /// Values up to `max`.
    pub fn up_to(max: f64) -> Self {
        Self {
            min: None,
            max: Some(max),
        }
    }

    /// Values from `min` on.
    pub fn from(min: f64) -> Self {
        Self {
            min: Some(min),
            max: None,
        }
    }

    /// Whether `value` lies inside, ends included; a value that is not a number lies outside.
    pub fn contains(&self, value: f64) -> bool {
        self.min.is_none_or(|min| value >= min) && self.max.is_none_or(|max| value <= max)
    }

    /// The range in a unit `factor` times smaller.
    pub fn scaled(&self, factor: f64) -> Self {
        Self {
            min: self.min.map(|min| min * factor),
            max: self.max.map(|max| max * factor),
        }
    }

    fn text(&self) -> String {
        match (self.min, self.max) {
            (Some(min), Some(max)) => format!("the range {} to {}", short(min), short(max)),
            (Some(min), None) => format!("the least value {}", short(min)),
            (None, Some(max)) => format!("the limit {}", short(max)),
            (None, None) => "the open range".into(),
        }
    }
}

/// A comparison of a value with a range, all in the unit of the source.
#[derive(Clone, Copy, Debug)]
pub struct Check<'a> {
    /// Severity of a value outside the range.
    pub severity: Severity,
    /// Model that the finding is about.
    pub model: &'a str,
    /// Key of the quantity.
    pub key: &'a str,
    /// The quantity in words.
    pub quantity: &'a str,
    /// The value.
    pub value: f64,
    /// The range.
    pub range: Range,
    /// The unit of both.
    pub unit: &'a str,
    /// Value of the unit in SI (1 for degrees).
    pub si_per_unit: f64,
    /// Consequence of a value outside the range, as the end of the sentence.
    pub meaning: &'a str,
    /// Source of the range.
    pub source: &'a str,
    /// Key of the input that removes the cause.
    pub field: Option<&'a str>,
}

impl Check<'_> {
    /// The finding, when the value is outside.
    pub fn finding(&self) -> Option<Finding> {
        if self.range.contains(self.value) {
            return None;
        }
        let range = self.range.scaled(self.si_per_unit);
        Some(Finding {
            severity: self.severity,
            model: self.model.into(),
            key: self.key.into(),
            value: Some(self.value * self.si_per_unit),
            valid: (range.min, range.max),
            message: format!(
                "{} {} {} is outside {} {}: {}.",
                self.quantity,
                short(self.value),
                self.unit,
                self.range.text(),
                self.unit,
                self.meaning
            )
            .replace("  ", " ")
            .replace(" :", ":"),
            source: self.source.into(),
            field: self.field.map(str::to_owned),
        })
    }
}

/// `value` in four significant digits.
pub fn short(value: f64) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-3..1e7).contains(&size) {
        return format!("{value:.3e}");
    }
    let (mut digits, mut power) = (3, 10.0);
    while digits > 0 && size >= power {
        digits -= 1;
        power *= 10.0;
    }
    let text = format!("{value:.digits$}");
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_belong_to_the_range_and_nan_does_not() {
        let range = Range {
            min: Some(1.0),
            max: Some(2.0),
        };
        assert!(range.contains(1.0) && range.contains(2.0));
        assert!(!range.contains(0.999) && !range.contains(2.001) && !range.contains(f64::NAN));
        assert!(!Range::up_to(2.0).contains(3.0) && Range::from(2.0).contains(3.0));
    }

    #[test]
    fn four_digits_without_idle_zeros() {
        assert_eq!(short(1302.4), "1302");
        assert_eq!(short(0.25), "0.25");
        assert_eq!(short(12.0), "12");
        assert_eq!(short(6.66e-5), "6.660e-5");
        assert_eq!(short(39943.0), "39943");
        assert_eq!(short(100.0), "100");
    }

    #[test]
    fn a_finding_carries_si_values_and_the_units_of_the_source() {
        let check = Check {
            severity: Severity::Exceeded,
            model: "mer pica",
            key: "forebody_peak_total_heat_flux_w_m2",
            quantity: "Peak heat flux",
            value: 1302.0,
            range: Range::up_to(1200.0),
            unit: "W/cm²",
            si_per_unit: 1e4,
            meaning: "beyond the material",
            source: "Table 8",
            field: None,
        };
        let finding = check.finding().unwrap();
        assert_eq!(finding.value, Some(1.302e7));
        assert_eq!(finding.valid, (None, Some(1.2e7)));
        assert_eq!(
            finding.message,
            "Peak heat flux 1302 W/cm² is outside the limit 1200 W/cm²: beyond the material."
        );
        assert!(
            Check {
                value: 1200.0,
                ..check
            }
            .finding()
            .is_none()
        );
    }
}
