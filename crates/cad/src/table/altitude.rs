//! Kind of altitude of a file, and the geometric altitude of each row.
//!
//! ```text
//! z = r H / (r − H)
//! ln(p₁/p₂) = ½ (ρ₁/p₁ + ρ₂/p₂) g (h₂ − h₁)      g = g₀ where h is geopotential, g₀ (r/(r + h))² where it is geometric
//! ```
//!
//! with z, H and h in m, r the radius of the planet in m, p in Pa, ρ in kg/m³, g₀ = 9.80665 m/s². The second line
//! decides whether a column "H" of the Earth is geopotential, as in standard atmospheres, or geometric, as elsewhere.
//!
//! # Valid
//! Atmosphere at rest. A column "H" that cannot be decided from at least two rows with two of pressure, density and
//! temperature is a fault.
//!
//! # References
//! - \[coesa-1976\] for geopotential altitude and g₀.

use super::layout::Sheet;
use super::quantity::Quantity;
use super::{Ground, TableFault};
use numerics::math::ln;

/// Standard gravity, m/s²; \[coesa-1976\].
pub(super) const G_0_M_S2: f64 = 9.80665;
/// Altitude up to which the composition of the air is constant, m; \[coesa-1976\].
pub(super) const MIXED_TO_M: f64 = 86e3;
/// Smallest relative difference between the two altitudes that figures of three or four digits can resolve; assumed.
const LEAST_DIFFERENCE: f64 = 0.004;
/// Largest deviation of the data from one of the two, as a fraction of the distance between them; assumed.
const NEAR: f64 = 0.3;

/// Kind of altitude of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Heights {
    /// Geometric altitude.
    Geometric,
    /// Column "H" that is geometric altitude.
    PlainGeometric,
    /// Geopotential altitude.
    Geopotential,
    /// Column "H" that is geopotential altitude.
    PlainGeopotential,
    /// Pressure altitude: the geopotential altitude at which the standard atmosphere has the pressure.
    Pressure,
}

impl Heights {
    /// The altitude column to use: geometric where there are several.
    pub fn of(sheet: &Sheet, ground: &Ground) -> Result<Self, Vec<TableFault>> {
        if sheet.has(Quantity::Altitude) {
            return Ok(Self::Geometric);
        }
        if sheet.has(Quantity::Geopotential) {
            return Ok(Self::Geopotential);
        }
        let on_earth = ground.standard.is_some();
        if sheet.has(Quantity::CapitalH) {
            return match (on_earth, plain(sheet, ground)) {
                (false, _) => Ok(Self::PlainGeometric),
                (true, Some(heights)) => Ok(heights),
                (true, None) => Err(vec![TableFault::CapitalH]),
            };
        }
        if sheet.has(Quantity::PressureAltitude) {
            let heavy = sheet.has(Quantity::Temperature) || sheet.has(Quantity::Density);
            let why = match (on_earth, heavy) {
                (true, true) => return Ok(Self::Pressure),
                (true, false) => "give temperature or density beside it",
                (false, _) => "it belongs to the standard atmosphere of the Earth",
            };
            return Err(vec![TableFault::PressureAltitude(why)]);
        }
        Err(vec![sheet.missing("altitude")])
    }

    /// Geometric altitude of a row, m; for pressure altitude the geopotential altitude in the standard atmosphere.
    pub fn altitude_m(self, sheet: &Sheet, row: &[f64], ground: &Ground) -> f64 {
        let value = |q: Quantity| sheet.value(row, q).unwrap_or_default();
        match self {
            Self::Geometric => value(Quantity::Altitude),
            Self::PlainGeometric => value(Quantity::CapitalH),
            Self::Geopotential => geometric_m(value(Quantity::Geopotential), ground.radius_m),
            Self::PlainGeopotential => geometric_m(value(Quantity::CapitalH), ground.radius_m),
            Self::Pressure => value(Quantity::PressureAltitude),
        }
    }

    /// Message to the user on the kind of altitude taken.
    pub fn remark(self, ground: &Ground) -> Option<String> {
        let told = if ground.standard.is_some() {
            ", as its pressure and density tell"
        } else {
            ""
        };
        let converted = format!(
            "geopotential altitudes are made geometric with a radius of {} km",
            ground.radius_m / 1e3
        );
        match self {
            Self::Geometric => None,
            Self::PlainGeometric => Some(format!("H is taken as geometric altitude{told}")),
            Self::Geopotential => Some(converted),
            Self::PlainGeopotential => {
                Some(format!("H is taken as geopotential altitude{told}; {converted}"))
            }
            Self::Pressure => Some(
                "heights are stacked from pressure altitudes; the lowest row stands at its own, as if the pressure at sea level were standard (assumed)"
                    .to_owned(),
            ),
        }
    }
}

/// Geometric from geopotential altitude, m.
pub(super) fn geometric_m(geopotential_m: f64, radius_m: f64) -> f64 {
    radius_m * geopotential_m / (radius_m - geopotential_m)
}

/// Kind of altitude of a column "H", from hydrostatic equilibrium in the upper half of the rows, where the two differ
/// most.
fn plain(sheet: &Sheet, ground: &Ground) -> Option<Heights> {
    // the comparison uses the Earth's standard gravity
    ground.standard.as_ref()?;
    let r = ground.gas_constant_j_kg_k?;
    let whole = sheet.has(Quantity::Pressure) && sheet.has(Quantity::Density);
    // altitude, m; logarithm of the pressure; density over pressure, s²/m²
    let mut air: Vec<[f64; 3]> = Vec::new();
    for (_, row) in &sheet.rows {
        let value = |q: Quantity| sheet.value(row, q);
        let height_m = value(Quantity::CapitalH)?;
        let (pressure_pa, density_kg_m3) = match (
            value(Quantity::Pressure),
            value(Quantity::Density),
            value(Quantity::Temperature),
        ) {
            (Some(p), Some(rho), _) => (p, rho),
            (Some(p), None, Some(t)) => (p, p / (r * t)),
            (None, Some(rho), Some(t)) => (rho * r * t, rho),
            _ => return None,
        };
        // the gas law supplies a missing quantity only where the composition, and so the gas constant, is known
        if (whole || height_m <= MIXED_TO_M) && pressure_pa > 0.0 && density_kg_m3 > 0.0 {
            air.push([height_m, ln(pressure_pa), density_kg_m3 / pressure_pa]);
        }
    }
    air.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let half_m = 0.5 * air.last()?[0];
    let (mut fall, mut geopotential, mut geometric) = (0.0, 0.0, 0.0);
    for pair in air.windows(2) {
        let [[low, ln_below, heavy], [high, ln_above, light]] = *pair else {
            continue;
        };
        let middle = 0.5 * (low + high);
        if middle < half_m {
            continue;
        }
        let weight = 0.5 * (heavy + light) * G_0_M_S2 * (high - low);
        let weaker = ground.radius_m / (ground.radius_m + middle);
        fall += ln_below - ln_above;
        geopotential += weight;
        geometric += weight * weaker * weaker;
    }
    let apart = 1.0 - geometric / geopotential;
    let found = (1.0 - fall / geopotential) / apart;
    if apart.is_nan() || apart < LEAST_DIFFERENCE {
        None
    } else if found.abs() < NEAR {
        Some(Heights::PlainGeopotential)
    } else if (found - 1.0).abs() < NEAR {
        Some(Heights::PlainGeometric)
    } else {
        None
    }
}
