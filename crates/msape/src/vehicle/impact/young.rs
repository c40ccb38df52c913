//! Young's penetration equation: how deep a rigid body goes into uniform soil.
//!
//! ```text
//! D = 0.0008 S N K (m/A)^0.7 ln(1 + 2.15·10⁻⁴ V²)      V < 61 m/s
//! D = 0.000018 S N K (m/A)^0.7 (V − 30.5)              V ≥ 61 m/s
//! K = 0.27 m^0.4 below 27 kg, 1 above                  N = 0.56 + 0.125 (L + L')/d
//! ```
//!
//! with D in m, S the penetrability of the soil, N the nose coefficient, m in kg, A the cross-section in m², V in m/s,
//! d the diameter, L the length of the sharp cone and L' that of the blunted one, all in m.
//!
//! # Valid
//! Slender bodies of more than 2 kg that stay whole and go in by three diameters or more. An entry vehicle goes in by less than
//! one: the equation is used beyond its range, and a finding says so. At 61 m/s the two branches are 15 % apart.
//!
//! # References
//! - \[young-1997\], soil and SI units.

use numerics::scalar::Single;

/// Speed at which the second branch begins, m/s.
const FAST_M_S: f64 = 61.0;
/// Mass below which the scale factor applies, kg.
const LIGHT_KG: f64 = 27.0;
/// Exponent of the mass over the cross-section.
pub const AREA_EXPONENT: f64 = 0.7;

/// Penetrator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Penetrator<S = f64> {
    /// Mass, kg.
    pub mass_kg: S,
    /// Cross-section, m².
    pub area_m2: S,
    /// Nose coefficient.
    pub nose_coefficient: S,
    /// Speed, m/s.
    pub speed_m_s: S,
}

/// Depth, m.
pub fn depth_m<S: Single>(penetrability: f64, penetrator: &Penetrator<S>) -> S {
    let Penetrator {
        mass_kg: m,
        area_m2: a,
        nose_coefficient: n,
        speed_m_s: v,
    } = *penetrator;
    let s = penetrability;
    let k = if m.value() < LIGHT_KG {
        m.pow(S::constant(0.4)) * 0.27
    } else {
        S::constant(1.0)
    };
    let snk = n * s * k * (m / a).pow(S::constant(AREA_EXPONENT));
    if v.value() < FAST_M_S {
        snk * 0.0008 * (v * 2.15e-4 * v + 1.0).ln()
    } else {
        snk * 0.000_018 * (v - 30.5)
    }
}

/// Force that would stop the penetrator over this depth, N.
pub fn mean_resistance_n<S: Single>(penetrability: f64, penetrator: &Penetrator<S>) -> S {
    let Penetrator {
        mass_kg: m,
        speed_m_s: v,
        ..
    } = *penetrator;
    m * v * v / (depth_m(penetrability, penetrator) * 2.0)
}

/// Nose coefficient of a cone with a blunted tip: lengths over the diameter.
pub fn nose_coefficient<S: Single>(sharp_length_ratio: S, blunted_length_ratio: S) -> S {
    (sharp_length_ratio + blunted_length_ratio) * 0.125 + 0.56
}

#[cfg(test)]
mod tests {
    use super::*;
    use numerics::math;

    const PENETRATOR: Penetrator = Penetrator {
        mass_kg: 100.0,
        area_m2: 0.01,
        nose_coefficient: 1.0,
        speed_m_s: 200.0,
    };

    #[test]
    fn hundred_kilograms_on_100_cm2_at_200_m_s_go_19p2_m_into_soil_of_10() {
        // 0.000018 · 10 · 10000^0.7 · 169.5 = 0.00018 · 630.957 · 169.5
        assert!((depth_m(10.0, &PENETRATOR) - 19.2505).abs() < 1e-3);
    }

    #[test]
    fn at_50_m_s_they_go_2p17_m() {
        // 0.0008 · 10 · 630.957 · ln 1.5375 = 5.04766 · 0.430158
        let slow = Penetrator {
            speed_m_s: 50.0,
            ..PENETRATOR
        };
        assert!((depth_m(10.0, &slow) - 2.171_29).abs() < 1e-4);
        // 100 · 2500 / (2 · 2.17129)
        assert!((mean_resistance_n(10.0, &slow) - 57_569.5).abs() < 3.0);
    }

    #[test]
    fn scale_factor_is_nearly_one_where_it_begins() {
        // 0.27 · 27^0.4 = 1.0090
        let of = |mass_kg| {
            let light = Penetrator {
                mass_kg,
                ..PENETRATOR
            };
            depth_m(10.0, &light) / math::pow(mass_kg, 0.7)
        };
        assert!((of(26.999_999) / of(27.0) - 1.009_0).abs() < 1e-4);
    }

    #[test]
    fn flat_face_has_0p56_and_a_cone_as_long_as_wide_0p81() {
        assert_eq!(nose_coefficient(0.0, 0.0), 0.56);
        assert_eq!(nose_coefficient(1.0, 1.0), 0.81);
    }
}
