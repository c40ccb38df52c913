//! Display of numbers and units. Conversions are in `msape::units`.

use msape::answer::Output;
use msape::quantity::{Column, Input};
use msape::units::{Dimension, Unit, canonical};
use serde::{Deserialize, Serialize};

/// System of displayed units.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum UnitSystem {
    /// Units of the report.
    #[default]
    Report,
    /// SI without prefixes, angles in degrees.
    Si,
    /// Feet, pounds, degrees Fahrenheit.
    Us,
}

impl UnitSystem {
    /// All systems, in the order of menus.
    pub const ALL: [UnitSystem; 3] = [UnitSystem::Report, UnitSystem::Si, UnitSystem::Us];

    /// Name in menus.
    pub fn label(self) -> &'static str {
        match self {
            UnitSystem::Report => "Report",
            UnitSystem::Si => "SI",
            UnitSystem::Us => "US",
        }
    }

    /// Displayed unit of a quantity whose unit in the report is `printed`.
    pub fn unit(self, dimension: Dimension, printed: &'static Unit) -> &'static Unit {
        match self {
            UnitSystem::Report => printed,
            UnitSystem::Si => canonical(dimension),
            UnitSystem::Us => us_symbol(dimension, printed)
                .and_then(Unit::find)
                .unwrap_or(printed),
        }
    }

    /// Unit displayed instead of the one with this symbol.
    pub fn named(self, symbol: &str) -> &'static Unit {
        let printed = Unit::find(symbol).unwrap_or_else(|| canonical(Dimension::One));
        self.unit(printed.dimension, printed)
    }

    /// Unit of an input.
    pub fn of_input(self, input: &'static Input) -> &'static Unit {
        self.unit(input.dimension(), input.shown_unit())
    }

    /// Unit of an output.
    pub fn of_output(self, output: &'static Output) -> &'static Unit {
        self.unit(output.dimension, output.shown_unit())
    }

    /// Unit of a column of a time history.
    pub fn of_column(self, column: &'static Column) -> &'static Unit {
        let printed = Unit::find(column.unit).unwrap_or_else(|| canonical(column.dimension));
        self.unit(column.dimension, printed)
    }
}

fn us_symbol(dimension: Dimension, printed: &Unit) -> Option<&'static str> {
    Some(match dimension {
        Dimension::Length if printed.factor < 0.5 => "in",
        Dimension::Length => "ft",
        Dimension::Area => "ft^2",
        Dimension::Mass => "lb",
        Dimension::Speed => "ft/s",
        Dimension::Acceleration => "ft/s^2",
        Dimension::Density => "lb/ft^3",
        Dimension::ArealDensity => "lb/ft^2",
        Dimension::Pressure => "psi",
        Dimension::Temperature => "F",
        Dimension::Inertia => "slug-ft^2",
        _ => return None,
    })
}

/// Symbol of a unit as usually written: `W/cm²`; empty for pure numbers.
pub fn symbol(unit: &Unit) -> String {
    unit.symbol
        .replace("^2", "²")
        .replace("^3", "³")
        .replace("kg-m", "kg·m")
        .replace("slug-ft", "slug·ft")
}

/// A number with a number of significant digits and U+2212 as its minus sign.
pub fn number(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return "–".to_string();
    }
    let is_whole = value % 1.0 == 0.0 && value.abs() < 1e6;
    if is_whole {
        return format!("{}", value + 0.0).replace('-', "\u{2212}");
    }
    let scientific = format!("{value:.*e}", digits.saturating_sub(1));
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let text = if (-4..7).contains(&exponent) {
        let decimals = (digits as i32 - 1 - exponent).max(0) as usize;
        format!("{value:.decimals$}")
    } else {
        format!("{mantissa}e{exponent}")
    };
    text.replace('-', "\u{2212}")
}

/// A number of an input, shortest form at twelve digits, so that conversions leave no rounding digits.
pub fn input_number(value: f64) -> String {
    let rounded: f64 = format!("{value:.11e}").parse().unwrap_or(value);
    let magnitude = rounded.abs();
    if rounded != 0.0 && !(1e-5..1e12).contains(&magnitude) {
        format!("{rounded:e}")
    } else {
        format!("{rounded}")
    }
}

/// A number with its unit.
pub fn with_unit(value: f64, digits: usize, unit: &Unit) -> String {
    format!(
        "{} {}",
        number(unit.from_canonical(value), digits),
        symbol(unit)
    )
    .trim_end()
    .to_string()
}

/// Date and time of a moment, ms since 1970, in the user's time zone.
pub fn date(ms: f64) -> String {
    let date = js_sys::Date::new(&ms.into());
    date.to_locale_string("en-GB", &wasm_bindgen::JsValue::UNDEFINED)
        .into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn significant_digits_hold_on_both_sides_of_one() {
        assert_eq!(number(45.678_9, 4), "45.68");
        assert_eq!(number(1302.4, 4), "1302");
        assert_eq!(number(-0.012_345, 3), "\u{2212}0.0123");
        assert_eq!(number(1.302e7, 4), "1.302e7");
        assert_eq!(number(9.999_96, 4), "10.00");
        assert_eq!(number(13.0, 4), "13");
        assert_eq!(number(-0.0, 4), "0");
    }

    #[test]
    fn conversions_leave_no_dust() {
        assert_eq!(input_number(0.1 + 0.2), "0.3");
        assert_eq!(input_number(11.56e3 / 0.3048 * 0.3048), "11560");
    }

    #[test]
    fn heat_shields_are_in_inches_and_altitudes_in_feet() {
        let cm = Unit::find("cm").unwrap();
        let km = Unit::find("km").unwrap();
        assert_eq!(UnitSystem::Us.unit(Dimension::Length, cm).symbol, "in");
        assert_eq!(UnitSystem::Us.unit(Dimension::Length, km).symbol, "ft");
    }
}
