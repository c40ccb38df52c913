//! Units of measurement: conversions happen here and nowhere else.
//!
//! Values in memory are in SI; cases and results are in SI with angles in degrees ("canonical"). A unit is known by its symbol,
//! which is ASCII and is used in CSV headers, axes and typed input.

pub mod number;
mod text;

pub use number::told;
pub(crate) use text::{SHOWN_MAX, cut};
pub use text::{TextError, parse_number};

/// Physical dimension of a number; units of one dimension convert into each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Dimension {
    /// A ratio or count, without unit.
    One,
    /// Length, m.
    Length,
    /// Area, m².
    Area,
    /// Volume, m³.
    Volume,
    /// Mass, kg.
    Mass,
    /// Time, s.
    Time,
    /// Speed, m/s.
    Speed,
    /// Acceleration, m/s².
    Acceleration,
    /// Load or deceleration as a multiple of 9.80665 m/s².
    Load,
    /// Angle, degrees.
    Angle,
    /// Rate of rotation of a planet, rad/s.
    AngularRate,
    /// Angular rate of a vehicle, deg/s.
    BodyRate,
    /// Density, kg/m³.
    Density,
    /// Mass over area, such as a ballistic coefficient, kg/m².
    ArealDensity,
    /// Pressure or stress, Pa.
    Pressure,
    /// Heat flux, W/m².
    HeatFlux,
    /// Heat load, J/m².
    HeatLoad,
    /// Temperature, K.
    Temperature,
    /// Moment of inertia, kg·m².
    Inertia,
    /// Gravitational parameter, m³/s².
    GravitationalParameter,
    /// Frequency, Hz.
    Frequency,
    /// Molar mass, kg/kmol.
    MolarMass,
    /// Specific heat capacity, J/(kg K).
    SpecificHeat,
    /// Thermal conductivity, W/(m K).
    Conductivity,
    /// Heat transfer coefficient, W/(m² K).
    HeatTransfer,
    /// Thermal resistance of an area, m² K/W.
    ThermalResistance,
}

/// A unit: `canonical = value * factor + offset`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    /// Symbol in ASCII, such as `W/cm^2`; empty for pure numbers.
    pub symbol: &'static str,
    /// Physical dimension.
    pub dimension: Dimension,
    /// Factor from this unit to the canonical unit.
    pub factor: f64,
    /// Canonical value of zero in this unit.
    pub offset: f64,
}

impl Unit {
    /// A value in this unit, expressed in the canonical unit of its dimension.
    pub fn to_canonical(&self, value: f64) -> f64 {
        value * self.factor + self.offset
    }

    /// A canonical value, expressed in this unit.
    pub fn from_canonical(&self, value: f64) -> f64 {
        (value - self.offset) / self.factor
    }

    /// The unit with this symbol.
    pub fn find(symbol: &str) -> Option<&'static Unit> {
        UNITS.iter().find(|unit| unit.symbol == symbol)
    }
}

const FOOT_M: f64 = 0.3048;
const POUND_KG: f64 = 0.45359237;
const PSI_PA: f64 = 6894.757293168361;
const DEGREES_PER_RADIAN: f64 = 180.0 / core::f64::consts::PI;

const fn unit(symbol: &'static str, dimension: Dimension, factor: f64) -> Unit {
    Unit {
        symbol,
        dimension,
        factor,
        offset: 0.0,
    }
}

/// All units known. The first of a dimension is the canonical one.
pub static UNITS: &[Unit] = &[
    unit("", Dimension::One, 1.0),
    unit("%", Dimension::One, 0.01),
    unit("m", Dimension::Length, 1.0),
    unit("mm", Dimension::Length, 1e-3),
    unit("cm", Dimension::Length, 1e-2),
    unit("km", Dimension::Length, 1e3),
    unit("in", Dimension::Length, 0.0254),
    unit("ft", Dimension::Length, FOOT_M),
    unit("mi", Dimension::Length, 1609.344),
    unit("nmi", Dimension::Length, 1852.0),
    unit("m^2", Dimension::Area, 1.0),
    unit("cm^2", Dimension::Area, 1e-4),
    unit("ft^2", Dimension::Area, FOOT_M * FOOT_M),
    unit("m^3", Dimension::Volume, 1.0),
    unit("l", Dimension::Volume, 1e-3),
    unit("kg", Dimension::Mass, 1.0),
    unit("g", Dimension::Mass, 1e-3),
    unit("lb", Dimension::Mass, POUND_KG),
    unit("slug", Dimension::Mass, 14.593902937206365),
    unit("s", Dimension::Time, 1.0),
    unit("ms", Dimension::Time, 1e-3),
    unit("min", Dimension::Time, 60.0),
    unit("h", Dimension::Time, 3600.0),
    unit("m/s", Dimension::Speed, 1.0),
    unit("km/s", Dimension::Speed, 1e3),
    unit("km/h", Dimension::Speed, 1.0 / 3.6),
    unit("ft/s", Dimension::Speed, FOOT_M),
    unit("mph", Dimension::Speed, 0.44704),
    unit("kn", Dimension::Speed, 1852.0 / 3600.0),
    unit("m/s^2", Dimension::Acceleration, 1.0),
    unit("ft/s^2", Dimension::Acceleration, FOOT_M),
    unit("Earth g", Dimension::Load, 1.0),
    unit("g's", Dimension::Load, 1.0),
    unit("deg", Dimension::Angle, 1.0),
    unit("rad", Dimension::Angle, DEGREES_PER_RADIAN),
    unit("rad/s", Dimension::AngularRate, 1.0),
    unit("deg/s", Dimension::BodyRate, 1.0),
    unit("rpm", Dimension::BodyRate, 6.0),
    unit("kg/m^3", Dimension::Density, 1.0),
    unit("g/cm^3", Dimension::Density, 1e3),
    unit(
        "lb/ft^3",
        Dimension::Density,
        POUND_KG / (FOOT_M * FOOT_M * FOOT_M),
    ),
    unit("kg/m^2", Dimension::ArealDensity, 1.0),
    unit(
        "lb/ft^2",
        Dimension::ArealDensity,
        POUND_KG / (FOOT_M * FOOT_M),
    ),
    unit("Pa", Dimension::Pressure, 1.0),
    unit("kPa", Dimension::Pressure, 1e3),
    unit("MPa", Dimension::Pressure, 1e6),
    unit("GPa", Dimension::Pressure, 1e9),
    unit("bar", Dimension::Pressure, 1e5),
    unit("atm", Dimension::Pressure, 101325.0),
    unit("psi", Dimension::Pressure, PSI_PA),
    unit("W/m^2", Dimension::HeatFlux, 1.0),
    unit("W/cm^2", Dimension::HeatFlux, 1e4),
    unit("MW/m^2", Dimension::HeatFlux, 1e6),
    unit("J/m^2", Dimension::HeatLoad, 1.0),
    unit("J/cm^2", Dimension::HeatLoad, 1e4),
    unit("kJ/cm^2", Dimension::HeatLoad, 1e7),
    unit("MJ/m^2", Dimension::HeatLoad, 1e6),
    unit("J/(kg K)", Dimension::SpecificHeat, 1.0),
    unit("W/(m K)", Dimension::Conductivity, 1.0),
    unit("W/(m^2 K)", Dimension::HeatTransfer, 1.0),
    unit("m^2 K/W", Dimension::ThermalResistance, 1.0),
    unit("K", Dimension::Temperature, 1.0),
    Unit {
        symbol: "C",
        dimension: Dimension::Temperature,
        factor: 1.0,
        offset: 273.15,
    },
    Unit {
        symbol: "F",
        dimension: Dimension::Temperature,
        factor: 5.0 / 9.0,
        offset: 459.67 * 5.0 / 9.0,
    },
    unit("kg-m^2", Dimension::Inertia, 1.0),
    unit("kg-m2", Dimension::Inertia, 1.0),
    unit("slug-ft^2", Dimension::Inertia, 1.3558179483314004),
    unit("m^3/s^2", Dimension::GravitationalParameter, 1.0),
    unit("km^3/s^2", Dimension::GravitationalParameter, 1e9),
    unit("Hz", Dimension::Frequency, 1.0),
    unit("kg/kmol", Dimension::MolarMass, 1.0),
    unit("g/mol", Dimension::MolarMass, 1.0),
];

/// Units of one dimension, the canonical one first.
pub fn units_of(dimension: Dimension) -> impl Iterator<Item = &'static Unit> {
    UNITS.iter().filter(move |unit| unit.dimension == dimension)
}

/// The canonical unit of a dimension.
pub fn canonical(dimension: Dimension) -> &'static Unit {
    units_of(dimension).next().unwrap_or(&UNITS[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_watt_per_square_centimeter_is_ten_thousand_si() {
        let unit = Unit::find("W/cm^2").unwrap();
        assert_eq!(unit.to_canonical(1302.0), 1.302e7);
        assert_eq!(unit.from_canonical(1.302e7), 1302.0);
    }

    #[test]
    fn freezing_water_is_273_15_k_and_32_f() {
        assert_eq!(Unit::find("C").unwrap().to_canonical(0.0), 273.15);
        assert!((Unit::find("F").unwrap().from_canonical(273.15) - 32.0).abs() < 1e-12);
    }

    #[test]
    fn every_symbol_is_ascii_and_stands_once() {
        for (i, unit) in UNITS.iter().enumerate() {
            assert!(unit.symbol.is_ascii(), "{}", unit.symbol);
            assert!(
                UNITS[..i].iter().all(|u| u.symbol != unit.symbol),
                "{}",
                unit.symbol
            );
        }
    }

    #[test]
    fn the_canonical_unit_has_factor_one() {
        for unit in UNITS {
            let first = canonical(unit.dimension);
            assert_eq!((first.factor, first.offset), (1.0, 0.0), "{}", unit.symbol);
        }
    }
}
