//! Headings of a table: the words and units that are understood.
//!
//! ```text
//! SI = factor × number + offset
//! ```
//!
//! with the factor in SI units per unit of the file.
//!
//! # Valid
//! The names and units listed.
//!
//! # References
//! - \[nist-sp-811\] appendix B for the factors.

/// Spellings of a unit, its factor and its offset to SI.
pub type Unit = (&'static [&'static str], f64, f64);

/// A physical quantity of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    Altitude,
    Density,
    Temperature,
    Pressure,
    Eastward,
    Northward,
}

impl Quantity {
    /// Name, and the words that a header may use.
    pub fn names(self) -> (&'static str, &'static [&'static str]) {
        match self {
            Self::Altitude => (
                "altitude",
                &["altitude", "alt", "height", "h", "z", "elevation"],
            ),
            Self::Density => ("density", &["density", "rho", "ρ", "dens"]),
            Self::Temperature => ("temperature", &["temperature", "temp", "t"]),
            Self::Pressure => ("pressure", &["pressure", "press", "p", "pres"]),
            Self::Eastward => ("eastward wind", &["eastward", "east", "u", "ew", "zonal"]),
            Self::Northward => (
                "northward wind",
                &["northward", "north", "v", "ns", "meridional"],
            ),
        }
    }

    /// Units with their factor and offset to SI; the first is SI.
    pub fn units(self) -> (&'static str, &'static [Unit]) {
        match self {
            Self::Altitude => (
                "m, km, ft, kft",
                &[
                    (&["m"], 1.0, 0.0),
                    (&["km"], 1000.0, 0.0),
                    (&["ft", "feet"], 0.3048, 0.0),
                    (&["kft"], 304.8, 0.0),
                ],
            ),
            Self::Density => (
                "kg/m3, g/m3, g/cm3, kg/km3, slug/ft3",
                &[
                    (&["kg/m3", "kgm3", "kgm-3"], 1.0, 0.0),
                    (&["g/m3", "gm3", "gm-3"], 1e-3, 0.0),
                    (&["g/cm3", "gcm3", "gcm-3"], 1e3, 0.0),
                    (&["kg/km3", "kgkm3", "kgkm-3"], 1e-9, 0.0),
                    (&["slug/ft3", "slugft3"], 515.378818393195, 0.0),
                ],
            ),
            Self::Temperature => (
                "K, C, R",
                &[
                    (&["k", "kelvin"], 1.0, 0.0),
                    (&["c", "degc", "celsius"], 1.0, 273.15),
                    (&["r", "degr", "rankine"], 5.0 / 9.0, 0.0),
                ],
            ),
            Self::Pressure => (
                "Pa, hPa, kPa, mbar, bar, atm, psf",
                &[
                    (&["pa"], 1.0, 0.0),
                    (&["hpa", "mbar", "mb"], 100.0, 0.0),
                    (&["kpa"], 1000.0, 0.0),
                    (&["bar"], 1e5, 0.0),
                    (&["atm"], 101325.0, 0.0),
                    (&["psf", "lb/ft2", "lbf/ft2"], 47.8802589803358, 0.0),
                ],
            ),
            Self::Eastward | Self::Northward => (
                "m/s, km/h, kt, ft/s",
                &[
                    (&["m/s", "ms", "ms-1"], 1.0, 0.0),
                    (&["km/h", "kmh"], 1.0 / 3.6, 0.0),
                    (&["kt", "kts", "knots"], 1852.0 / 3600.0, 0.0),
                    (&["ft/s", "fts"], 0.3048, 0.0),
                ],
            ),
        }
    }
}

/// The parts of a heading: `Altitude (km)`, `alt [km]`, `altitude_km`, `T, K` or `density kg/m^3`.
pub fn name_and_unit(field: &str) -> (String, String) {
    let plain: String = field
        .to_lowercase()
        .replace('³', "3")
        .replace('⁻', "-")
        .replace(['^', '*', '°'], "");
    let mut parts = plain.splitn(2, |c: char| "([,_ \t".contains(c));
    let name = parts.next().unwrap_or("").trim().to_string();
    let unit: String = parts
        .next()
        .unwrap_or("")
        .chars()
        .filter(|c| !"()[]_ ,\t".contains(*c))
        .collect();
    // altitude_m, density_kg_m3, eastward_m_s: the unit has lost its stroke and is listed without it.
    (name, unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_usual_spellings() {
        for (field, name, unit) in [
            ("Altitude (km)", "altitude", "km"),
            ("density_kg_m3", "density", "kgm3"),
            ("rho [kg/m^3]", "rho", "kg/m3"),
            ("T, °C", "t", "c"),
            ("p", "p", ""),
        ] {
            assert_eq!(name_and_unit(field), (name.to_string(), unit.to_string()));
        }
    }
}
