//! Pressure at the stagnation point, and over the surface by modified Newtonian theory.
//!
//! ```text
//! p = C ρ^m V^n                                                                                    (9)
//! Cp = Cp,max sin² θ                                                                              (10)
//! Cp,max = 2/(γ M²) { [(γ+1)² M² / (4γ M² − 2(γ−1))]^(γ/(γ−1)) [(1 − γ + 2γ M²)/(γ+1)] − 1 }       (11)
//! p − p∞ = Cp,max ρ V²/2                                                                          (12)
//! M ≤ 1:  Cp,max = 2/(γ M²) { [1 + (γ−1)/2 M²]^(γ/(γ−1)) − 1 }
//! ```
//!
//! with p in Pa, ρ in kg/m³, V in m/s, M the free-stream Mach number, γ the ratio of specific heats, θ the angle
//! between the surface and the flow. Below Mach 1 the report has no rule: isentropic compression, which meets eq. 11 at
//! Mach 1.
//!
//! # Valid
//! Eq. 9: geometry v1, the report's Navier-Stokes points (10 to 16 km/s). Eqs 10-12: a perfect gas; the report finds
//! them conservative against Navier-Stokes.
//!
//! # References
//! - \[samareh-2014\] eqs 9-12.

use numerics::math;
use numerics::scalar::Scalar;
use serde::Deserialize;

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
    pub fn parse(text: &str) -> Result<Self, String> {
        toml::from_str(text).map_err(|error| error.to_string())
    }

    /// Stagnation pressure, Pa, from density in kg/m³ and speed in m/s.
    pub fn pressure_pa<S: Scalar>(&self, density_kg_m3: S, speed_m_s: S) -> S {
        // p = C ρ^m V^n
        density_kg_m3.pow(S::constant(self.m)) * speed_m_s.pow(S::constant(self.n)) * self.c
    }
}

/// A free stream.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stream<S> {
    /// Static pressure, Pa.
    pub pressure_pa: S,
    /// Dynamic pressure, Pa.
    pub dynamic_pressure_pa: S,
    /// Mach number.
    pub mach: S,
}

/// Largest pressure coefficient at `mach` in a gas with ratio of specific heats `gamma`.
#[inline]
pub fn maximum_pressure_coefficient<S: Scalar>(mach: S, gamma: f64) -> S {
    let one = S::constant(1.0);
    let exponent = S::constant(gamma / (gamma - 1.0));
    // below Mach 0.001 the coefficient is 1 to 1e-6
    let m = mach.max(S::constant(1e-3));
    let m2 = m * m;
    let supersonic = m2.max(one);
    let base = supersonic * ((gamma + 1.0) * (gamma + 1.0))
        / (supersonic * (4.0 * gamma) - 2.0 * (gamma - 1.0));
    let jump = (supersonic * (2.0 * gamma) + (1.0 - gamma)) / (gamma + 1.0);
    let compression = m2.min(one) * (0.5 * (gamma - 1.0)) + 1.0;
    let fast = one.less(m2);
    let ratio = S::select(fast, base, compression).pow(exponent) * S::select(fast, jump, one);
    (ratio - 1.0) * (2.0 / gamma) / m2
}

/// Stagnation pressure, Pa.
#[inline]
pub fn stagnation_pressure_pa<S: Scalar>(stream: &Stream<S>, gamma: f64) -> S {
    // p − p∞ = Cp,max ρ V²/2
    stream.pressure_pa
        + maximum_pressure_coefficient(stream.mach, gamma) * stream.dynamic_pressure_pa
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

    #[test]
    fn fit_at_unit_density_and_speed_is_its_constant() {
        let fit = PressureFit::parse(include_str!("../../data/heating/stagnation-pressure.toml"))
            .unwrap();
        assert_eq!(fit.pressure_pa(1.0, 1.0), 0.792);
        // ρ V² = 43200 Pa at 3e-4 kg/m³ and 12 km/s; a blunt nose sees 0.92 to 1 of it
        let ratio: f64 = fit.pressure_pa(3e-4, 12e3) / 43200.0;
        assert!(ratio > 0.92 && ratio < 1.0, "{ratio}");
    }

    #[test]
    fn pitot_ratios_are_those_of_naca_1135() {
        // NACA 1135, γ 1.4: M 2: p02/p1 = 5.640, M 5: 32.65; M 0.5: p/p0 = 0.8430
        for (mach, ratio) in [(2.0, 5.640), (5.0, 32.65), (0.5, 1.0 / 0.8430)] {
            let stream = Stream {
                pressure_pa: 1.0,
                dynamic_pressure_pa: 0.7 * mach * mach,
                mach,
            };
            let ours: f64 = stagnation_pressure_pa(&stream, 1.4);
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
