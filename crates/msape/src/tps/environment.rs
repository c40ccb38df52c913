//! Environment of a heat shield, and the point at which it is sized.
//!
//! ```text
//! q̇ = max(1, f) q̇₀      Q = max(1, f) Q₀      p = p₀            forebody, hottest-point
//! q̇ₐ = 0.05 q̇₀          Qₐ = 0.05 Q₀          pₐ = 0.5 p₀       aftbody
//! ```
//!
//! with q̇ in W/m², Q in J/m², p in Pa, 0 the stagnation point and f the shoulder's heat flux over that of the stagnation
//! point.
//!
//! The forebody's heat shield runs round the shoulder, so its hottest point is the stagnation point or the shoulder. The
//! heat load there is taken with the factor of the flux, as if the ratio held along the whole entry, and the factor is on
//! radiation too, for whose share at the shoulder no source was found: both are conservative. The pressure is that of
//! the stagnation point, the largest of the part. The aftbody's fractions hold for the whole of it.
//!
//! # Valid
//! Same as for the shoulder factor. The relations of Table 7 were fitted with the environments of the stagnation point.
//!
//! # References
//! - \[samareh-2014\] sections 3.4.3 and 3.5.2, Table 6.

use super::Side;
use crate::finding::range::short;
use crate::finding::{Finding, Severity};
use crate::heating::afterbody::Afterbody;
pub use crate::quantity::choice::JudgedAt;
use crate::quantity::input;
use numerics::math::RADIANS_PER_DEGREE;
use numerics::scalar::Single;
use serde::{Deserialize, Serialize};

impl JudgedAt {
    /// Environment for which the forebody's heat shield is sized, from those of the stagnation point and the hottest point off it.
    pub fn environment<S: Single>(
        self,
        stagnation: &Environment<S>,
        off: &OffStagnation<S>,
    ) -> Environment<S> {
        match self {
            Self::HottestPoint
                if off.heat_flux_ratio.value() > 1.0 || off.heat_load_ratio.value() > 1.0 =>
            {
                let least = S::constant(1.0);
                Environment {
                    point: off.point,
                    peak_heat_flux_w_m2: stagnation.peak_heat_flux_w_m2
                        * off.heat_flux_ratio.max(least),
                    heat_load_j_m2: stagnation.heat_load_j_m2 * off.heat_load_ratio.max(least),
                    ..*stagnation
                }
            }
            Self::HottestPoint | Self::StagnationPoint => *stagnation,
        }
    }
}

/// The hottest point off the stagnation point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OffStagnation<S = f64> {
    /// Point with this heat flux.
    pub point: Point,
    /// Peak heat flux over that of the stagnation point.
    pub heat_flux_ratio: S,
    /// Heat load over that of the stagnation point.
    pub heat_load_ratio: S,
}

impl<S: Copy> OffStagnation<S> {
    /// The shoulder, with the factor of its heat flux on its heat load too.
    pub fn shoulder(factor: S) -> Self {
        Self {
            point: Point::Shoulder,
            heat_flux_ratio: factor,
            heat_load_ratio: factor,
        }
    }
}

/// A point of the surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Point {
    /// The stagnation point.
    Stagnation,
    /// The hottest point of the shoulder.
    Shoulder,
    /// Any point of the aftbody.
    Aftbody,
    /// The hottest of the points of the forebody for which the case gives heat fluxes.
    Given,
}

impl Point {
    /// Side of the vehicle to which the point belongs.
    pub fn side(self) -> Side {
        match self {
            Self::Stagnation | Self::Shoulder | Self::Given => Side::Forebody,
            Self::Aftbody => Side::Aftbody,
        }
    }

    /// Place of the point, as part of a sentence.
    pub fn place(self) -> &'static str {
        match self {
            Self::Stagnation => "at the stagnation point",
            Self::Shoulder => "on the shoulder",
            Self::Aftbody => "on the aftbody",
            Self::Given => "at the hottest of the points given",
        }
    }

    /// Key of its heat flux with margins.
    pub fn heat_flux_key(self) -> &'static str {
        match self {
            Self::Stagnation => "peak_total_margined_heat_flux_w_m2",
            Self::Shoulder | Self::Given => "shoulder_peak_heat_flux_w_m2",
            Self::Aftbody => "aftbody_peak_heat_flux_w_m2",
        }
    }

    /// Key of its heat load with margins.
    pub fn heat_load_key(self) -> &'static str {
        match self {
            Self::Stagnation => "total_margined_heat_load_j_m2",
            Self::Shoulder | Self::Given => "shoulder_heat_load_j_m2",
            Self::Aftbody => "aftbody_heat_load_j_m2",
        }
    }

    /// Key of the pressure that is compared with the limits.
    pub fn pressure_key(self) -> &'static str {
        match self.side() {
            Side::Forebody => "peak_stagnation_pressure_pa",
            Side::Aftbody => "aftbody_peak_pressure_pa",
        }
    }
}

/// Environment of a heat shield at its own place: the values for an aftbody are already those on the aftbody.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Environment<S = f64> {
    /// Point on the surface.
    pub point: Point,
    /// Peak total heat flux, cold wall, with margins, W/m².
    pub peak_heat_flux_w_m2: S,
    /// Total heat load, cold wall, with margins, J/m².
    pub heat_load_j_m2: S,
    /// Peak pressure, Pa.
    pub peak_pressure_pa: S,
    /// Entry speed, m/s.
    pub entry_speed_m_s: S,
    /// Entry flight-path angle against the horizon, negative down, rad.
    pub entry_flight_path_angle_rad: S,
    /// Time for which the heat flux is above the material's limit, s; unknown is `None`.
    pub time_above_limit_s: Option<S>,
}

impl<S: Single> Environment<S> {
    /// Environment of the aftbody, given this of the stagnation point.
    pub fn aftbody(&self, fractions: &Afterbody) -> Self {
        Self {
            point: Point::Aftbody,
            peak_heat_flux_w_m2: self.peak_heat_flux_w_m2 * fractions.heat_flux_fraction,
            heat_load_j_m2: self.heat_load_j_m2 * fractions.heat_load_fraction,
            peak_pressure_pa: self.peak_pressure_pa * fractions.pressure_fraction,
            time_above_limit_s: None,
            ..*self
        }
    }
}

impl Environment {
    /// Side of the vehicle to which the point belongs.
    pub fn side(&self) -> Side {
        self.point.side()
    }

    /// Entry angle below the horizon, deg.
    pub fn entry_depth_deg(&self) -> f64 {
        -self.entry_flight_path_angle_rad / RADIANS_PER_DEGREE
    }

    /// Finding on the choice by which the forebody's heat shield is sized, and on the point.
    pub fn judged(&self, by: JudgedAt, off: &OffStagnation) -> Finding {
        let [factor, load_factor] = [off.heat_flux_ratio, off.heat_load_ratio].map(short);
        let place = self.point.place();
        let message = match (by, self.point) {
            (JudgedAt::HottestPoint, _) if off.point == Point::Given => format!(
                "The forebody's heat shield is judged by the largest heat flux and the largest heat load of the points given \
                 by the user: off the stagnation point they are {factor} and {load_factor} times its own."
            ),
            (JudgedAt::StagnationPoint, _) if off.point == Point::Given => format!(
                "The forebody's heat shield is judged {place}, as chosen; the other points given by the user have {factor} \
                 times its heat flux and {load_factor} times its heat load and are left out."
            ),
            (JudgedAt::HottestPoint, Point::Shoulder) => format!(
                "The forebody's heat shield is judged {place}, its hottest point: {factor} times the heat flux of the \
                 stagnation point, and as much of its heat load."
            ),
            (JudgedAt::HottestPoint, _) => format!(
                "The forebody's heat shield is judged {place}, its hottest point: the shoulder has {factor} times its heat \
                 flux."
            ),
            (JudgedAt::StagnationPoint, _) => format!(
                "The forebody's heat shield is judged {place}, as chosen; the shoulder has {factor} times its heat flux and \
                 is left out."
            ),
        };
        Finding {
            severity: Severity::Note,
            model: "heat shield".into(),
            key: self.point.heat_flux_key().into(),
            value: Some(self.peak_heat_flux_w_m2),
            valid: (None, None),
            message,
            source: "NASA/TM-2014-218507, sections 3.4.3 and 3.5".into(),
            field: Some(input::heating::JUDGED_AT.key.into()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STAGNATION: Environment = Environment {
        point: Point::Stagnation,
        peak_heat_flux_w_m2: 2e7,
        heat_load_j_m2: 2e8,
        peak_pressure_pa: 1e5,
        entry_speed_m_s: 12e3,
        entry_flight_path_angle_rad: -RADIANS_PER_DEGREE,
        time_above_limit_s: Some(1.0),
    };

    #[test]
    fn aftbody_has_a_twentieth_of_the_heating_and_half_the_pressure() {
        let text = include_str!("../../data/heating/afterbody.toml");
        let aft = STAGNATION.aftbody(&Afterbody::parse(text.into()).unwrap());
        assert_eq!(
            [
                aft.peak_heat_flux_w_m2,
                aft.heat_load_j_m2,
                aft.peak_pressure_pa
            ],
            [1e6, 1e7, 5e4]
        );
        assert_eq!(
            (aft.side(), aft.time_above_limit_s, aft.entry_depth_deg()),
            (Side::Aftbody, None, 1.0)
        );
    }

    #[test]
    fn shoulder_is_judged_where_it_is_hotter_and_only_by_the_hottest_point() {
        // 1.25 × 2000 W/cm² and 20 kJ/cm²: 2500 and 25; the pressure stays
        let shoulder = OffStagnation::shoulder(1.25);
        let hot = JudgedAt::HottestPoint.environment(&STAGNATION, &shoulder);
        assert_eq!(
            (hot.point, hot.peak_heat_flux_w_m2, hot.heat_load_j_m2),
            (Point::Shoulder, 2.5e7, 2.5e8)
        );
        assert_eq!(hot.peak_pressure_pa, 1e5);
        let said = hot.judged(JudgedAt::HottestPoint, &shoulder).message;
        assert!(
            said.contains("on the shoulder") && said.contains("1.25"),
            "{said}"
        );
        for (by, factor) in [
            (JudgedAt::HottestPoint, 0.9),
            (JudgedAt::StagnationPoint, 1.25),
        ] {
            let off = OffStagnation::shoulder(factor);
            let judged = by.environment(&STAGNATION, &off);
            assert_eq!(judged, STAGNATION);
            let said = judged.judged(by, &off).message;
            assert!(said.contains("at the stagnation point"), "{said}");
        }
    }

    #[test]
    fn points_given_are_judged_by_the_largest_flux_and_the_largest_load() {
        // 1.5 × 2000 W/cm², and no point with more than the 20 kJ/cm² of the stagnation point
        let off = OffStagnation {
            point: Point::Given,
            heat_flux_ratio: 1.5,
            heat_load_ratio: 0.8,
        };
        let hot = JudgedAt::HottestPoint.environment(&STAGNATION, &off);
        assert_eq!(
            (hot.point, hot.peak_heat_flux_w_m2, hot.heat_load_j_m2),
            (Point::Given, 3e7, 2e8)
        );
        let said = hot.judged(JudgedAt::HottestPoint, &off).message;
        assert!(
            said.contains("given by the user") && said.contains("1.5 and 0.8"),
            "{said}"
        );
    }
}
