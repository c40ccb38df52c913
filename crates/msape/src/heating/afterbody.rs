//! Heating and pressure behind the shoulder, as fractions of the stagnation point's.
//!
//! ```text
//! q̇ₐ = 0.05 q̇₀      Qₐ = 0.05 Q₀      pₐ = 0.5 p₀
//! ```
//!
//! with q̇ in W/m², Q in J/m², p in Pa.
//!
//! # Valid
//! An estimate for the whole aftbody, without geometry.
//!
//! # References
//! - \[samareh-2014\] section 3.5.2 and Table 6.

use crate::data::Data;
use serde::{Deserialize, Serialize};

/// The fractions, from `heating/afterbody.toml`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Afterbody {
    /// Key of the reference.
    pub source: String,
    /// Place in it.
    pub place: String,
    /// Fraction of the heat flux.
    pub heat_flux_fraction: f64,
    /// Fraction of the heat load.
    pub heat_load_fraction: f64,
    /// Fraction of the pressure.
    pub pressure_fraction: f64,
}

impl Afterbody {
    /// Reads the fractions from the text of `heating/afterbody.toml`.
    pub fn parse(data: Data) -> Result<Self, String> {
        data.read()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions_are_those_of_the_report() {
        let aft =
            Afterbody::parse(include_str!("../../data/heating/afterbody.toml").into()).unwrap();
        assert_eq!(
            [
                aft.heat_flux_fraction,
                aft.heat_load_fraction,
                aft.pressure_fraction
            ],
            [0.05, 0.05, 0.5]
        );
    }
}
