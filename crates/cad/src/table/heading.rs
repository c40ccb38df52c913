//! Headings of a table: name and unit in the spellings that files use.
//!
//! ```text
//! Altitude (km)    alt [km]    altitude_km    T, K    p / Pa    density kg/m^3
//! ```
//!
//! # Valid
//! One name per heading.
//!
//! # References
//! - Own convention.

use super::quantity::Quantity;
use super::squeezed::squeezed;

/// Parsed heading.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Heading<'h> {
    /// A quantity with its unit, or without one.
    Known(Quantity, Option<&'h str>),
    /// A quantity with a unit that is not one of its own.
    OddUnit(Quantity, &'h str),
    /// No known quantity.
    Unknown,
}

/// Parsed heading, among the quantities that the table may hold: `Altitude (km)`, `alt [km]`, `altitude_km`, `T, K`, `p
/// / Pa` or `density kg/m^3`.
pub fn heading<'h>(field: &'h str, quantities: &[Quantity]) -> Heading<'h> {
    let (name, unit) = parts(field);
    if name.trim() == "H" && quantities.contains(&Quantity::Altitude) {
        return match unit {
            Some(unit) if Quantity::CapitalH.unit(unit).is_none() => {
                Heading::OddUnit(Quantity::CapitalH, unit)
            }
            unit => Heading::Known(Quantity::CapitalH, unit),
        };
    }
    let plain = squeezed(name);
    let exact = quantities
        .iter()
        .find(|q| q.names().1.contains(&plain.as_str()));
    if let Some(quantity) = exact {
        return match unit {
            Some(unit) if quantity.unit(unit).is_none() => Heading::OddUnit(*quantity, unit),
            unit => Heading::Known(*quantity, unit),
        };
    }
    if unit.is_some() {
        return Heading::Unknown;
    }
    // the unit follows the name: density_kg_m3, T_K, Höhe km
    let mut longest: Option<(usize, Quantity, &str)> = None;
    for (quantity, name) in quantities
        .iter()
        .flat_map(|q| q.names().1.iter().map(|name| (*q, *name)))
    {
        let rest = plain.strip_prefix(name).filter(|rest| !rest.is_empty());
        if rest.is_some_and(|rest| quantity.unit(rest).is_some())
            && longest.is_none_or(|(length, ..)| name.len() > length)
        {
            longest = after(field, name).map(|unit| (name.len(), quantity, unit));
        }
    }
    match longest {
        Some((_, Quantity::Altitude, unit))
            if field.starts_with('H')
                && field.chars().nth(1).is_none_or(|c| !c.is_alphabetic()) =>
        {
            Heading::Known(Quantity::CapitalH, Some(unit))
        }
        Some((_, quantity, unit)) => Heading::Known(quantity, Some(unit)),
        None => Heading::Unknown,
    }
}

/// Text of a field after the characters of `name`.
fn after<'f>(field: &'f str, name: &str) -> Option<&'f str> {
    let mut left = name.chars().count();
    for (place, sign) in field.char_indices() {
        if left == 0 {
            return field.get(place..);
        }
        left = left.saturating_sub(squeezed(sign.encode_utf8(&mut [0; 4])).chars().count());
    }
    None
}

/// Name and unit of a heading separated by brackets, a comma or a slash.
fn parts(field: &str) -> (&str, Option<&str>) {
    let inner = |open: usize, text: &'_ str| {
        text.get(open + 1..)
            .map(|rest| rest.split([')', ']', '}']).next().unwrap_or_default().len())
    };
    let mut name = field;
    if let Some(open) = field.rfind(['(', '[', '{']) {
        let closed = inner(open, field).and_then(|length| {
            Some((
                field.get(open + 1..open + 1 + length)?,
                field.get(open + 1 + length..)?,
            ))
        });
        if let Some((unit, rest)) = closed
            && rest.chars().skip(1).all(char::is_whitespace)
        {
            name = field.get(..open).unwrap_or_default();
            let kinds = ["geometric", "geopotential", "pressure", "msl", "amsl"];
            if kinds.contains(&squeezed(unit).as_str()) {
                return (field, None);
            }
            return (name, Some(unit));
        }
    }
    if let Some((before, unit)) = name.rsplit_once(',') {
        return (before, Some(unit.trim()));
    }
    match name.split_once('/') {
        Some((before, unit)) if !before.trim().contains([' ', '_']) => {
            (before, Some(unit.trim().trim_matches(['(', ')'])))
        }
        _ => (name, None),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const AIR: &[Quantity] = &[
        Quantity::Altitude,
        Quantity::Geopotential,
        Quantity::PressureAltitude,
        Quantity::Density,
        Quantity::Temperature,
        Quantity::Pressure,
    ];

    #[test]
    fn the_usual_spellings() {
        use Quantity::{
            Altitude, CapitalH, Density, Geopotential, Pressure, PressureAltitude, Temperature,
        };
        for (field, quantity, factor) in [
            ("Altitude (km)", Altitude, 1e3),
            ("alt [ft]", Altitude, 0.3048),
            ("altitude_km", Altitude, 1e3),
            ("Z(m)", Altitude, 1.0),
            ("Altitude (geometric) [km]", Altitude, 1e3),
            ("H, m", CapitalH, 1.0),
            ("H_km", CapitalH, 1e3),
            ("h", Altitude, 1.0),
            ("HGHT", Geopotential, 1.0),
            ("Geopotential height (m)", Geopotential, 1.0),
            ("geopotential_altitude_m", Geopotential, 1.0),
            ("pressure altitude (ft)", PressureAltitude, 0.3048),
            ("density_kg_m3", Density, 1.0),
            ("rho [kg/m^3]", Density, 1.0),
            ("rho, kg m3", Density, 1.0),
            ("rho (kg m-3)", Density, 1.0),
            ("ρ / (kg/m³)", Density, 1.0),
            ("density kg/m**3", Density, 1.0),
            ("rho_g_cm3", Density, 1e3),
            ("rho [g cm^-3]", Density, 1e3),
            ("T, °C", Temperature, 1.0),
            ("T_K", Temperature, 1.0),
            ("Temp(K)", Temperature, 1.0),
            ("p", Pressure, 1.0),
            ("P, Nm2", Pressure, 1.0),
            ("P(N/m2)", Pressure, 1.0),
            ("pressure_hPa", Pressure, 100.0),
            ("T / K", Temperature, 1.0),
        ] {
            match heading(field, AIR) {
                Heading::Known(found, unit) => {
                    assert_eq!(found, quantity, "{field}");
                    let got = found.unit(unit.unwrap_or_default()).map(|unit| unit.0);
                    assert_eq!(got, Some(factor), "{field}");
                }
                other => panic!("{field}: {other:?}"),
            }
        }
        assert_eq!(Temperature.unit("°C"), Some((1.0, 273.15)));
        // 32 F = 0 C
        let (factor, offset) = Temperature.unit("F").unwrap();
        assert!((factor * 32.0 + offset - 273.15).abs() < 1e-12);
    }

    #[test]
    fn other_columns_are_not_taken_for_these() {
        for field in [
            "speed_of_sound_m_s",
            "a, m/s",
            "density ratio",
            "temperature deviation (K)",
            "rho_low_kgm3",
            "CP (0 to 4 deg)",
            "hPa",
            "sd_rho_pct",
        ] {
            assert_eq!(heading(field, AIR), Heading::Unknown, "{field}");
        }
        assert_eq!(
            heading("altitude (furlong)", AIR),
            Heading::OddUnit(Quantity::Altitude, "furlong")
        );
    }
}
