//! The coefficients by name, and whether each is published, computed or assumed in a part of a database.
//!
//! ```text
//! origin(C_D) = origin(C_L) = the less certain of origin(C_A) and origin(C_N)       given < published < computed < assumed
//! ```
//!
//! # Valid
//! Range of [`super::database::Database`]; nothing is computed from the origins. The axial force of the transonic
//! tables is in part constructed and counts as assumed; so does everything blended there.
//!
//! # References
//! - \[samareh-2014\] sections 3.3.1 to 3.3.7; the sentences of [`Regime::provenance`] say it at length.

use super::database::Regime;
use super::polar::Row;
use serde::{Deserialize, Serialize};

/// A coefficient.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Coefficient {
    /// Axial force.
    Ca,
    /// Normal force.
    Cn,
    /// Pitching moment about the virtual apex.
    CmApex,
    /// Pitching moment about the center of gravity.
    CmCg,
    /// Drag.
    Cd,
    /// Lift.
    Cl,
    /// Pitch damping.
    Cmq,
}

/// Origin of a coefficient, the more certain first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Origin {
    /// A table of the user.
    Given,
    /// A published table or equation.
    Published,
    /// Computed over the outline.
    Computed,
    /// A choice of this program.
    Assumed,
}

impl Origin {
    /// Name in one or two words.
    pub fn name(self) -> &'static str {
        match self {
            Origin::Given => "own table",
            Origin::Published => "published",
            Origin::Computed => "computed",
            Origin::Assumed => "assumed",
        }
    }
}

/// Angle up to which equation 7 answers below the speed of sound, deg.
pub const SUBSONIC_ALPHA_MAX_DEG: f64 = 60.0;

impl Coefficient {
    /// All coefficients, in the order of tables.
    pub const ALL: [Coefficient; 7] = [
        Coefficient::Ca,
        Coefficient::Cn,
        Coefficient::CmApex,
        Coefficient::CmCg,
        Coefficient::Cd,
        Coefficient::Cl,
        Coefficient::Cmq,
    ];

    /// Name for axes and headings.
    pub fn label(self) -> &'static str {
        match self {
            Coefficient::Ca => "Axial Force Coefficient CA",
            Coefficient::Cn => "Normal Force Coefficient CN",
            Coefficient::CmApex => "Pitching Moment about the Apex Cm",
            Coefficient::CmCg => "Pitching Moment about the CG Cm",
            Coefficient::Cd => "Drag Coefficient CD",
            Coefficient::Cl => "Lift Coefficient CL",
            Coefficient::Cmq => "Pitch Damping Cmq",
        }
    }

    /// Symbol of the coefficient.
    pub fn symbol(self) -> &'static str {
        match self {
            Coefficient::Ca => "CA",
            Coefficient::Cn => "CN",
            Coefficient::CmApex => "Cm, apex",
            Coefficient::CmCg => "Cm, CG",
            Coefficient::Cd => "CD",
            Coefficient::Cl => "CL",
            Coefficient::Cmq => "Cmq",
        }
    }

    /// Value in a row, where there is one.
    pub fn of(self, row: &Row) -> Option<f64> {
        match self {
            Coefficient::Ca => Some(row.ca),
            Coefficient::Cn => Some(row.cn),
            Coefficient::CmApex => Some(row.cm_apex),
            Coefficient::CmCg => row.cm_cg,
            Coefficient::Cd => Some(row.cd),
            Coefficient::Cl => Some(row.cl),
            Coefficient::Cmq => row.cmq,
        }
    }

    /// Origin of the static value; damping is that of the report's section 3.3.7.
    pub fn origin(self, regime: Regime, alpha_deg: f64) -> Origin {
        use Origin::{Assumed, Computed, Given, Published};
        let beyond = alpha_deg.abs() > SUBSONIC_ALPHA_MAX_DEG;
        match (self, regime) {
            (Coefficient::Cmq, Regime::Subsonic) => Published,
            (Coefficient::Cmq, _) => Assumed,
            (_, Regime::Table) => Given,
            (_, Regime::FreeMolecular | Regime::Transitional) => Computed,
            (Coefficient::Ca, Regime::Supersonic) if alpha_deg == 0.0 => Published,
            (_, Regime::Hypersonic | Regime::Supersonic) => Computed,
            (_, Regime::Transonic) => Assumed,
            (Coefficient::CmApex | Coefficient::CmCg, Regime::Subsonic) => Assumed,
            (_, Regime::Subsonic) if beyond => Assumed,
            (_, Regime::Subsonic) => Published,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equation_7_is_published_up_to_60_deg_and_its_center_of_pressure_is_not() {
        let at = |coefficient: Coefficient, alpha| coefficient.origin(Regime::Subsonic, alpha);
        assert_eq!(at(Coefficient::Cn, 60.0), Origin::Published);
        assert_eq!(at(Coefficient::Cn, 61.0), Origin::Assumed);
        assert_eq!(at(Coefficient::CmCg, 5.0), Origin::Assumed);
        assert_eq!(at(Coefficient::Cmq, 5.0), Origin::Published);
    }

    #[test]
    fn drag_is_no_more_certain_than_axial_and_normal_force() {
        for regime in [
            Regime::FreeMolecular,
            Regime::Transitional,
            Regime::Hypersonic,
            Regime::Supersonic,
            Regime::Transonic,
            Regime::Subsonic,
            Regime::Table,
        ] {
            for alpha in [1.0, 30.0, 90.0] {
                let [a, n, d, l] = [
                    Coefficient::Ca,
                    Coefficient::Cn,
                    Coefficient::Cd,
                    Coefficient::Cl,
                ]
                .map(|c| c.origin(regime, alpha));
                assert_eq!((d, l), (a.max(n), a.max(n)), "{regime:?} {alpha}");
            }
        }
    }

    #[test]
    fn the_viking_placeholder_is_assumed_wherever_it_has_a_part() {
        for regime in [Regime::Transonic, Regime::Supersonic, Regime::Hypersonic] {
            assert_eq!(Coefficient::Cmq.origin(regime, 0.0), Origin::Assumed);
        }
    }
}
