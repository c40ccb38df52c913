//! Thickness of a heat shield by mass-estimating relations.
//!
//! ```text
//! x = HL / V²
//! power       t = a x^b                                                    (13)
//! quadratic   t = p₂ x² + p₁ x + p₀                                         (14)
//! two-branch  t = a x^b up to a heat flux, p₂ x² + p₁ x + p₀ above it
//! ```
//!
//! with HL the cold-wall heat load in J/cm², V the entry speed in km/s, t in cm (arguments and result converted).
//! The thickness used is the larger of t and the least thickness in which the material is made.
//!
//! # Valid
//! 840 trajectories of 10 to 16 km/s at 5 to 25 degrees; bond line at 250 °C, adiabatic back face, no margin; up to the
//! heat-flux limit of the material. A falling quadratic is held at its peak (LI-900 above 10 W/cm², x = 9.63).
//!
//! # References
//! - \[samareh-2014\] eqs 13 and 14, Tables 5 to 8.

use super::Environment;
use super::material::{Limits, TpsMaterial};
use crate::heating::PER_CM2;
use numerics::scalar::Single;
use serde::{Deserialize, Serialize};

/// A relation with its coefficients as printed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "form", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Mer {
    /// t = a x^b.
    Power {
        /// Factor.
        a: f64,
        /// Exponent.
        b: f64,
    },
    /// t = p₂ x² + p₁ x + p₀.
    Quadratic {
        /// Coefficient of the square.
        p2: f64,
        /// Coefficient of the linear term.
        p1: f64,
        /// Constant.
        p0: f64,
    },
    /// t = a x^b up to a heat flux, p₂ x² + p₁ x + p₀ above it.
    TwoBranch {
        /// Heat flux where the branches change, W/cm².
        switch_heat_flux_w_cm2: f64,
        /// Factor.
        a: f64,
        /// Exponent.
        b: f64,
        /// Coefficient of the square.
        p2: f64,
        /// Coefficient of the linear term.
        p1: f64,
        /// Constant.
        p0: f64,
        /// Largest x of the second branch.
        largest_x: f64,
    },
}

/// Criterion that determines the thickness.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Governed {
    /// The mass-estimating relation.
    Relation,
    /// The least thickness that can be made.
    MinimumThickness,
    /// The user.
    Given,
}

/// A heat shield sized.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sizing<S = f64> {
    /// Thickness to use, m.
    pub thickness_m: S,
    /// Thickness required by the relation and by the least thickness made, m.
    pub asked_m: S,
    /// Thickness of the relation, m.
    pub relation_thickness_m: S,
    /// Standard deviation of the relation, m.
    pub standard_deviation_m: S,
    /// Thickness where the relation under-predicts the most, m.
    pub largest_thickness_m: S,
    /// Heat load over squared entry speed, J/cm² per (km/s)².
    pub x: S,
    /// Criterion that determines the thickness.
    pub governed_by: Governed,
    /// Whether the relation gives less than the least thickness it was fitted to.
    pub below_fit: bool,
    /// Least recession among the trajectories of the fit, m; absent where nothing recedes.
    pub least_recession_m: Option<f64>,
    /// Largest recession among them, m.
    pub largest_recession_m: Option<f64>,
}

impl Mer {
    /// Thickness, cm, from x = HL/V² and the heat flux in W/cm².
    pub fn thickness_cm<S: Single>(&self, x: S, heat_flux_w_cm2: S) -> S {
        match *self {
            Self::Power { a, b } => x.pow(S::constant(b)) * a,
            Self::Quadratic { p2, p1, p0 } => quadratic(x, [p2, p1, p0]),
            Self::TwoBranch {
                switch_heat_flux_w_cm2,
                a,
                b,
                p2,
                p1,
                p0,
                ..
            } => {
                if heat_flux_w_cm2.value() <= switch_heat_flux_w_cm2 {
                    x.pow(S::constant(b)) * a
                } else {
                    quadratic(x, [p2, p1, p0])
                }
            }
        }
    }
}

/// p₂ x² + p₁ x + p₀, held at its peak where it would fall.
fn quadratic<S: Single>(x: S, [p2, p1, p0]: [f64; 3]) -> S {
    let x = if p2 < 0.0 {
        x.min(S::constant(-p1 / (2.0 * p2)))
    } else {
        x
    };
    (x * p2 + p1) * x + p0
}

impl<S> Sizing<S> {
    /// This sizing with the thickness that the user gives, m, if any.
    pub fn or_given(self, thickness_m: Option<S>) -> Self {
        match thickness_m {
            None => self,
            Some(thickness_m) => Sizing {
                thickness_m,
                governed_by: Governed::Given,
                ..self
            },
        }
    }
}

/// Thickness of `material` for `environment`.
pub fn size<S: Single>(material: &TpsMaterial, environment: &Environment<S>) -> Sizing<S> {
    let Environment {
        peak_heat_flux_w_m2,
        heat_load_j_m2,
        entry_speed_m_s,
        ..
    } = *environment;
    let Limits {
        minimum_thickness_cm,
        ..
    } = material.limits;
    let fit = material.fit;
    let v = entry_speed_m_s / 1000.0;
    // no heat load is x = 0 also where there is no speed
    let x = if heat_load_j_m2.value() <= 0.0 {
        S::constant(0.0)
    } else {
        heat_load_j_m2 / PER_CM2 / (v * v)
    };
    let t = material.mer.thickness_cm(x, peak_heat_flux_w_m2 / PER_CM2);
    let asked_m = t.max(S::constant(minimum_thickness_cm)) / 100.0;
    Sizing {
        thickness_m: asked_m,
        asked_m,
        relation_thickness_m: t / 100.0,
        standard_deviation_m: t / 100.0 * fit.standard_deviation_percent / 100.0,
        // t = (1 − u) of the ablation code's thickness
        largest_thickness_m: t / 100.0 / (1.0 - fit.largest_underprediction_percent / 100.0),
        x,
        governed_by: if t.value() < minimum_thickness_cm {
            Governed::MinimumThickness
        } else {
            Governed::Relation
        },
        below_fit: t.value() < fit.minimum_thickness_cm,
        least_recession_m: fit.recession_cm.and_then(|range| Some(range.min? / 100.0)),
        largest_recession_m: fit.recession_cm.and_then(|range| Some(range.max? / 100.0)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tps::Point;
    use crate::tps::material::tests::FILES;

    fn material(index: usize) -> TpsMaterial {
        TpsMaterial::parse(FILES[index].into()).unwrap()
    }

    /// Heat load x V² at V = 10 km/s.
    fn at_x(x: f64, heat_flux_w_cm2: f64) -> Environment {
        Environment {
            point: Point::Aftbody,
            peak_heat_flux_w_m2: heat_flux_w_cm2 * 1e4,
            heat_load_j_m2: x * 100.0 * 1e4,
            peak_pressure_pa: 1e4,
            entry_speed_m_s: 1e4,
            entry_flight_path_angle_rad: -0.15,
            time_above_limit_s: None,
        }
    }

    #[test]
    fn at_x_of_one_each_power_gives_its_factor() {
        let factors = [1.8696, 1.1959, 0.5281, 0.623, 0.6961];
        for (index, a) in factors.into_iter().enumerate() {
            let sizing = size(&material(index), &at_x(1.0, 5.0));
            assert!(
                (sizing.relation_thickness_m * 100.0 - a).abs() < 1e-12,
                "{index}"
            );
        }
    }

    #[test]
    fn pica_at_x_of_100_is_4_44_cm() {
        // 100^0.1879 = 10^0.3758 = 2.37575; × 1.8696 = 4.4417 cm; ± 6.3 % = 0.2798 cm; / (1 − 0.117) = 5.0302 cm
        let sizing = size(&material(0), &at_x(100.0, 500.0));
        assert!((sizing.thickness_m - 0.044_417).abs() < 1e-6, "{sizing:?}");
        assert!((sizing.standard_deviation_m - 0.002_798).abs() < 1e-6);
        assert!((sizing.largest_thickness_m - 0.050_302).abs() < 1e-6);
        assert!(!sizing.below_fit && sizing.governed_by == Governed::Relation);
    }

    #[test]
    fn sla_561v_at_x_of_10_is_1_9332_cm() {
        // 0.0064 × 100 + 0.0961 × 10 + 0.3322 = 0.64 + 0.961 + 0.3322
        assert!((size(&material(5), &at_x(10.0, 50.0)).thickness_m - 0.019_332).abs() < 1e-15);
    }

    #[test]
    fn li_900_takes_its_second_branch_above_10_w_cm2_and_never_falls() {
        // x = 4: −0.0306 × 16 + 0.5896 × 4 + 0.6739 = 2.5427; x ≥ 9.634: 0.6739 + 0.5896²/(4 × 0.0306) = 3.5140 cm
        assert!((size(&material(4), &at_x(4.0, 11.0)).thickness_m - 0.025_427).abs() < 1e-15);
        let [peak, beyond] = [9.7, 20.0].map(|x| size(&material(4), &at_x(x, 11.0)).thickness_m);
        assert!(peak == beyond && (peak - 0.035_140).abs() < 1e-6, "{peak}");
        assert_eq!(size(&material(4), &at_x(1.0, 10.0)).thickness_m, 0.006_961);
    }

    #[test]
    fn what_is_too_thin_to_make_takes_the_least_thickness() {
        // SIRCA, x = 0.5: 0.5281 × 0.5^0.5416 = 0.3628 cm, made from 0.5 cm on, fitted from 0.518 cm on
        let sizing = size(&material(2), &at_x(0.5, 5.0));
        assert_eq!(
            (sizing.thickness_m, sizing.governed_by),
            (0.005, Governed::MinimumThickness)
        );
        assert!(
            sizing.below_fit && (sizing.relation_thickness_m - 0.003_628).abs() < 1e-6,
            "{sizing:?}"
        );
    }

    #[test]
    fn recession_is_that_of_table_7_and_an_insulator_has_none() {
        // 0.60 to 1.15 cm and 0.0002 to 0.141 cm
        for (index, expected) in [(0, [0.006, 0.0115]), (1, [2e-6, 0.00141])] {
            let sizing = size(&material(index), &at_x(4.0, 5.0));
            let recession = [sizing.least_recession_m, sizing.largest_recession_m];
            for (ours, table) in recession.into_iter().zip(expected) {
                assert!((ours.unwrap() - table).abs() < 1e-15, "{index}: {ours:?}");
            }
        }
        let tile = size(&material(4), &at_x(4.0, 5.0));
        assert!(tile.least_recession_m.is_none() && tile.largest_recession_m.is_none());
    }

    #[test]
    fn no_heating_is_the_least_thickness_at_any_speed() {
        for entry_speed_m_s in [1e4, 0.0] {
            let none = Environment {
                entry_speed_m_s,
                ..at_x(0.0, 0.0)
            };
            let sizing = size(&material(0), &none);
            assert_eq!(
                (sizing.thickness_m, sizing.governed_by),
                (0.005, Governed::MinimumThickness)
            );
            assert!(sizing.relation_thickness_m == 0.0 && sizing.below_fit);
        }
    }

    #[test]
    fn a_heat_load_that_is_no_number_is_not_taken_for_none() {
        assert!(
            size(&material(0), &at_x(f64::NAN, 0.0))
                .thickness_m
                .is_nan()
        );
    }
}
