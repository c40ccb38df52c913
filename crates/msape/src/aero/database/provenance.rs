//! Origin of coefficients.
//!
//! ```text
//! table > free-molecular (Kn ≥ 10) > transitional (Kn > 10⁻³) > hypersonic (M ≥ 5) > supersonic (M ≥ 1.5) > transonic (M > 0.5) > subsonic
//! ```
//!
//! # Valid
//! Names of the models used by [`super::Database`]; nothing is computed from them.
//!
//! # References
//! - \[samareh-2014\] section 3.3.1.

use serde::{Deserialize, Serialize};

/// Part of a database that gave the coefficients.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Regime {
    /// Free-molecular flow.
    FreeMolecular,
    /// Between free-molecular flow and continuum.
    Transitional,
    /// Continuum from Mach 5.
    Hypersonic,
    /// Continuum from Mach 1.5 to 5.
    Supersonic,
    /// Continuum from Mach 0.5 to 1.5.
    Transonic,
    /// Continuum below Mach 0.5.
    Subsonic,
    /// A table of the user.
    Table,
}

impl Regime {
    /// The regime of a continuum at a Mach number.
    pub fn of_mach(mach: f64) -> Regime {
        match mach {
            m if m >= 5.0 => Regime::Hypersonic,
            m if m >= 1.5 => Regime::Supersonic,
            m if m > 0.5 => Regime::Transonic,
            _ => Regime::Subsonic,
        }
    }

    /// Name of the regime.
    pub fn name(self) -> &'static str {
        match self {
            Regime::FreeMolecular => "free-molecular",
            Regime::Transitional => "transitional",
            Regime::Hypersonic => "hypersonic",
            Regime::Supersonic => "supersonic",
            Regime::Transonic => "transonic",
            Regime::Subsonic => "subsonic",
            Regime::Table => "table",
        }
    }

    /// Origin of the axial force, the normal force and the moment: measured, computed or assumed.
    pub fn provenance(self) -> &'static str {
        match self {
            Regime::FreeMolecular => "computed: Schaaf and Chambre over the outline",
            Regime::Transitional => {
                "computed: both limits over the outline; bridging in Knudsen number from Wilmoth 1999"
            }
            Regime::Hypersonic => {
                "axial force published or computed, by the named table; the rest computed: modified Newton over the outline; base pressure assumed"
            }
            Regime::Supersonic => {
                "axial force published; normal force and moment computed: modified Newton over the outline, for want of measurements"
            }
            Regime::Transonic => {
                "axial force in part constructed; normal force and moment assumed: blended from equation 7 to modified Newton"
            }
            Regime::Subsonic => {
                "axial and normal force published (equation 7) up to 60 deg; center of pressure assumed (Newtonian); beyond 100 deg assumed (modified Newton)"
            }
            Regime::Table => "the table of the case",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_belong_to_the_faster_regime_but_for_the_slowest() {
        assert_eq!(Regime::of_mach(5.0), Regime::Hypersonic);
        assert_eq!(Regime::of_mach(1.5), Regime::Supersonic);
        assert_eq!(Regime::of_mach(0.5), Regime::Subsonic);
    }
}
