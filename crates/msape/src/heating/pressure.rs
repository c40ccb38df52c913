//! Pressure at the stagnation point, and over the surface by modified Newtonian theory.
//!
//! ```text
//! p − p∞ = ρ V²                          newtonian-limit: Cp,max = 2, the limit of M → ∞ and γ = 1
//! p − p∞ = C ρ^m V^n                     equation-9                                                 (9)
//! Cp = Cp,max sin² θ                                                                              (10)
//! Cp,max = 2/(γ M²) { [(γ+1)² M² / (4γ M² − 2(γ−1))]^(γ/(γ−1)) [(1 − γ + 2γ M²)/(γ+1)] − 1 }       (11)
//! p − p∞ = Cp,max ρ V²/2                                                                          (12)
//! M ≤ 1:  Cp,max = 2/(γ M²) { [1 + (γ−1)/2 M²]^(γ/(γ−1)) − 1 }
//! ```
//!
//! with p in Pa, ρ in kg/m³, V in m/s, M the free-stream Mach number, γ the ratio of specific heats, θ the angle
//! between the surface and the flow. Below Mach 1 the report has no rule: isentropic compression, which meets eq. 11 at
//! Mach 1. Equation 9 is printed for p; it is read as the rise above p∞, which is less than 0.3 % of it where it was fitted
//! and keeps it whole down to rest.
//!
//! # Valid
//! The limit bounds the others at every Mach number: behind a strong shock dissociating air comes to 1.9 to 1.97 times
//! the dynamic pressure (eq. 9), a perfect gas of γ = 1.4 to 1.84, which is 5 to 7 % below eq. 9 at peak heating. The
//! report calls its values conservative against Navier-Stokes; that is true of the limit, and of eqs 10 to 12 only with γ
//! near 1. Eq. 9: geometry v1, the report's Navier-Stokes points (entry at 10 to 16 km/s).
//!
//! # References
//! - \[samareh-2014\] eqs 9-12.

use crate::data::Data;
use crate::finding::{Finding, Severity};
pub use crate::quantity::choice::PressureModel;
use crate::quantity::input;
use numerics::math;
use numerics::scalar::Scalar;
use serde::Deserialize;

impl PressureModel {
    /// Name in plain words.
    pub fn label(self) -> &'static str {
        match self {
            Self::NewtonianLimit => "the Newtonian limit, Cp,max = 2",
            Self::Equation9 => "equation 9, the fit to Navier-Stokes results",
            Self::PerfectGas => {
                "a perfect gas with the gamma of the undisturbed air, equations 10 to 12"
            }
        }
    }
}

/// Pressure at the stagnation point by one of the models.
#[derive(Clone, Debug, PartialEq)]
pub struct StagnationPressure {
    /// The model.
    pub model: PressureModel,
    /// Coefficients of equation 9.
    pub fit: PressureFit,
}

impl StagnationPressure {
    /// Stagnation pressure, Pa.
    #[inline]
    pub fn pressure_pa<S: Scalar>(&self, stream: &Stream<S>) -> S {
        match self.model {
            // p − p∞ = 2 ρ V²/2
            PressureModel::NewtonianLimit => {
                stream.pressure_pa + stream.dynamic_pressure_pa() * 2.0
            }
            PressureModel::Equation9 => {
                stream.pressure_pa + self.fit.rise_pa(stream.density_kg_m3, stream.speed_m_s)
            }
            PressureModel::PerfectGas => perfect_gas_pa(stream),
        }
    }

    /// Finding that names the model of the pressure.
    pub fn findings(&self, peak_pa: f64) -> Vec<Finding> {
        let beside = match self.model {
            PressureModel::NewtonianLimit => "it bounds the other models, 3 % above equation 9",
            PressureModel::Equation9 => "of one geometry: 3 % below the Newtonian limit",
            PressureModel::PerfectGas => {
                "in air 5 to 7 % below the report's Navier-Stokes results: it is not conservative"
            }
        };
        let message = format!(
            "Stagnation pressure is that of {}: {beside}.",
            self.model.label()
        );
        vec![Finding {
            severity: Severity::Note,
            model: "stagnation pressure".into(),
            key: "peak_stagnation_pressure_pa".into(),
            value: Some(peak_pa),
            valid: (None, None),
            message,
            source: "NASA/TM-2014-218507, equations 9 to 12".into(),
            field: Some(input::heating::STAGNATION_PRESSURE.key.into()),
        }]
    }
}

/// The report's fit to Navier-Stokes results, from `heating/stagnation-pressure.toml`.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PressureFit {
    /// Key of the reference.
    pub source: String,
    /// Place in it.
    pub place: String,
    c: f64,
    m: f64,
    n: f64,
}

impl PressureFit {
    /// Reads the fit from the text of `heating/stagnation-pressure.toml`.
    pub fn parse(data: Data) -> Result<Self, String> {
        data.read()
    }

    /// Rise of the stagnation pressure above that of the air, Pa, from density in kg/m³ and speed in m/s.
    #[inline]
    pub fn rise_pa<S: Scalar>(&self, density_kg_m3: S, speed_m_s: S) -> S {
        // p − p∞ = C ρ^m V^n
        density_kg_m3.pow(S::constant(self.m)) * speed_m_s.pow(S::constant(self.n)) * self.c
    }
}

/// A free stream.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stream<S> {
    /// Static pressure, Pa.
    pub pressure_pa: S,
    /// Density, kg/m³.
    pub density_kg_m3: S,
    /// Speed, m/s.
    pub speed_m_s: S,
    /// Mach number.
    pub mach: S,
    /// Ratio of specific heats.
    pub heat_capacity_ratio: S,
}

impl<S: Scalar> Stream<S> {
    /// Dynamic pressure, Pa.
    #[inline]
    pub fn dynamic_pressure_pa(&self) -> S {
        self.density_kg_m3 * 0.5 * self.speed_m_s * self.speed_m_s
    }
}

/// Largest pressure coefficient at `mach` in a gas with ratio of specific heats `gamma`.
#[inline]
pub fn maximum_pressure_coefficient<S: Scalar>(mach: S, gamma: S) -> S {
    let one = S::constant(1.0);
    let (less, more) = (gamma - 1.0, gamma + 1.0);
    let exponent = gamma / less;
    // below Mach 0.001 the coefficient is 1 to 1e-6
    let m = mach.max(S::constant(1e-3));
    let m2 = m * m;
    let supersonic = m2.max(one);
    let base = supersonic * (more * more) / (supersonic * (gamma * 4.0) - less * 2.0);
    let jump = (supersonic * (gamma * 2.0) - less) / more;
    let compression = m2.min(one) * (less * 0.5) + 1.0;
    let fast = one.less(m2);
    let ratio = S::select(fast, base, compression).pow(exponent) * S::select(fast, jump, one);
    (ratio - 1.0) * (S::constant(2.0) / gamma) / m2
}

/// Stagnation pressure of a perfect gas, Pa.
#[inline]
fn perfect_gas_pa<S: Scalar>(stream: &Stream<S>) -> S {
    // p − p∞ = Cp,max ρ V²/2
    stream.pressure_pa
        + maximum_pressure_coefficient(stream.mach, stream.heat_capacity_ratio)
            * stream.dynamic_pressure_pa()
}

/// Pressure coefficient of a surface at `angle_rad` to the flow; 0 in its shadow.
pub fn newtonian_pressure_coefficient(maximum: f64, angle_rad: f64) -> f64 {
    let sine = math::sin(angle_rad).max(0.0);
    // Cp = Cp,max sin² θ
    maximum * sine * sine
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantity::choice::Choice;

    fn fit() -> PressureFit {
        PressureFit::parse(include_str!("../../data/heating/stagnation-pressure.toml").into())
            .unwrap()
    }

    #[test]
    fn fit_at_unit_density_and_speed_is_its_constant() {
        let fit = fit();
        assert_eq!(fit.rise_pa(1.0, 1.0), 0.792);
        // 0.792 × 3e-4^0.00357 × 12000^0.02529 = 0.792 × 0.97146 × 1.26812 = 0.97569 of ρ V² = 43200 Pa
        let ratio: f64 = fit.rise_pa(3e-4, 12e3) / 43200.0;
        assert!((ratio - 0.97569).abs() < 1e-5, "{ratio}");
    }

    #[test]
    fn limit_bounds_equation_9_which_bounds_the_perfect_gas_and_each_is_named() {
        // 12 km/s at 3e-4 kg/m³: rises of 2, 1.9514 and 1.8388 times the dynamic pressure of 21600 Pa, above 20 Pa
        let stream = Stream {
            pressure_pa: 20.0,
            density_kg_m3: 3e-4,
            speed_m_s: 12e3,
            mach: 39.0,
            heat_capacity_ratio: 1.4,
        };
        let expected = [2.0, 1.9514, 1.8388];
        for ((model, ..), times) in PressureModel::ALL.iter().zip(expected) {
            let pressure = StagnationPressure {
                model: *model,
                fit: fit(),
            };
            let rise: f64 = (pressure.pressure_pa(&stream) - 20.0) / 21600.0;
            assert!((rise - times).abs() < 2e-4, "{model:?}: {rise}");
            let [said] = &pressure.findings(4e4)[..] else {
                panic!("one finding")
            };
            assert!(said.message.contains(model.label()), "{}", said.message);
        }
    }

    #[test]
    fn pitot_ratios_are_those_of_naca_1135() {
        // NACA 1135, γ 1.4: M 2: p02/p1 = 5.640, M 5: 32.65; M 0.5: p/p0 = 0.8430
        for (mach, ratio) in [(2.0, 5.640), (5.0, 32.65), (0.5, 1.0 / 0.8430)] {
            let stream = Stream {
                pressure_pa: 1.0,
                // a speed of sound of 1 m/s: ρ = γ p, q = 0.7 M²
                density_kg_m3: 1.4,
                speed_m_s: mach,
                mach,
                heat_capacity_ratio: 1.4,
            };
            let ours: f64 = perfect_gas_pa(&stream);
            assert!(
                (ours / ratio - 1.0).abs() < 2e-4,
                "Mach {mach}: {ours} against {ratio}"
            );
        }
    }

    #[test]
    fn coefficient_tends_to_1_839_for_air_and_to_2_as_gamma_tends_to_1() {
        // γ 1.4, M → ∞: 2/γ [(γ+1)²/4γ]^(γ/(γ−1)) 2γ/(γ+1) = 1.8394
        let air: f64 = maximum_pressure_coefficient(1e4, 1.4);
        assert!((air - 1.8394).abs() < 1e-4, "{air}");
        let soft: f64 = maximum_pressure_coefficient(1e4, 1.0001);
        assert!((soft - 2.0).abs() < 1e-3, "{soft}");
    }

    #[test]
    fn both_branches_meet_at_mach_1_and_the_slow_limit_is_1() {
        // γ 1.4, M 1: 2/1.4 (1.2^3.5 − 1) = 1.27561
        let [below, above]: [f64; 2] =
            [1.0 - 1e-12, 1.0 + 1e-12].map(|mach| maximum_pressure_coefficient(mach, 1.4));
        assert!(
            (below - above).abs() < 1e-10 && (below - 1.275_61).abs() < 1e-5,
            "{below} {above}"
        );
        assert!((maximum_pressure_coefficient(0.0, 1.4) - 1.0_f64).abs() < 1e-6);
    }

    #[test]
    fn newtonian_surface_at_30_degrees_has_a_quarter_and_the_shadow_nothing() {
        assert!((newtonian_pressure_coefficient(2.0, math::PI / 6.0) - 0.5).abs() < 1e-15);
        assert_eq!(newtonian_pressure_coefficient(2.0, -0.1), 0.0);
    }
}
