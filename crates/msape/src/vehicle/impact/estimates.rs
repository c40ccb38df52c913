//! Load and stroke of a landing at terminal speed, without its speed: equations 3 and 5 of the report.
//!
//! ```text
//! ½ ρ C_D A V_t² = M g                          (2)
//! G = α (8 g / (π ρ C_D)) (Dₙ/D) (1/D)          (3), equation 1 with equation 2
//! Stroke = k β / (ρ Ḡ),  β = M / (C_D A)        (5), equation 4 with equation 2, k = 2 for MSR, 1 for non-MSR
//! ```
//!
//! with ρ the density of the air at the ground in kg/m³, C_D the drag coefficient there, A = π D²/4 in m², D the diameter and Dₙ
//! twice the nose radius in m, M the mass in kg, α the empirical constant of the ground, G and the design load Ḡ in Earth g,
//! β in kg/m², g = 9.80665 m/s².
//!
//! # Valid
//! On Earth, at terminal speed. A vehicle that falls into denser and denser air is a little faster: by 0 to 1.4 % in most designs over
//! the run page's ranges and 3 % at 113 m/s, so that both lie 0 to 6 % below equations 1 and 4.
//!
//! # References
//! - \[samareh-2014\] equations 2, 3 and 5, Figures 19 and 20.

use crate::vehicle::impact::pulse_factor;
use crate::vehicle::kinds::{Concept, EARTH_G_M_S2};
use numerics::math::PI;

/// A vehicle that falls at terminal speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fall {
    /// Mass, kg.
    pub mass_kg: f64,
    /// Diameter, m.
    pub diameter_m: f64,
    /// Drag coefficient.
    pub drag_coefficient: f64,
    /// Density of the air, kg/m³.
    pub density_kg_m3: f64,
}

impl Fall {
    /// Terminal speed, m/s: equation 2.
    pub fn terminal_speed_m_s(&self) -> f64 {
        let area_m2 = PI * self.diameter_m * self.diameter_m / 4.0;
        let drag_kg_m = 0.5 * self.density_kg_m3 * self.drag_coefficient * area_m2;
        (self.mass_kg * EARTH_G_M_S2 / drag_kg_m).sqrt()
    }

    /// Peak load of ground penetration, Earth g: equation 3.
    pub fn penetration_load_earth_g(&self, alpha: f64, nose_diameter_m: f64) -> f64 {
        let Fall {
            diameter_m: d,
            drag_coefficient: c_d,
            density_kg_m3: rho,
            ..
        } = *self;
        alpha * (8.0 * EARTH_G_M_S2 / (PI * rho * c_d)) * (nose_diameter_m / d) / d
    }

    /// Stroke of the payload on a rigid surface, m: equation 5.
    pub fn required_stroke_m(&self, concept: Concept, design_load_earth_g: f64) -> f64 {
        let area_m2 = PI * self.diameter_m * self.diameter_m / 4.0;
        let beta = self.mass_kg / (self.drag_coefficient * area_m2);
        pulse_factor(concept) * beta / (self.density_kg_m3 * design_load_earth_g)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vehicle::impact::{penetration_load_earth_g, required_stroke_m};

    const FALL: Fall = Fall {
        mass_kg: 40.0,
        diameter_m: 1.0,
        drag_coefficient: 0.73,
        density_kg_m3: 1.225,
    };

    #[test]
    fn forty_kilograms_of_one_meter_have_195_g_and_3_8_cm() {
        // 28 · 8 · 9.80665 / (π 1.225 0.73) · 0.25 = 195.48
        let load = FALL.penetration_load_earth_g(28.0, 0.25);
        assert!((load - 195.48).abs() < 0.01, "{load}");
        // 40 / (0.73 · 0.785398) / (1.225 · 1500) = 0.037968
        let stroke = FALL.required_stroke_m(Concept::NonMsr, 1500.0);
        assert!((stroke - 0.037_968).abs() < 1e-6, "{stroke}");
        assert_eq!(FALL.required_stroke_m(Concept::Msr, 1500.0), 2.0 * stroke);
    }

    #[test]
    fn they_are_equations_1_and_4_at_the_speed_of_equation_2() {
        let speed = FALL.terminal_speed_m_s();
        // √(2 · 40 · 9.80665 / (1.225 · 0.73 · π/4))
        assert!((speed - 33.422).abs() < 1e-3, "{speed}");
        let equation_1 = penetration_load_earth_g(28.0, 0.25, speed, 40.0);
        assert!((FALL.penetration_load_earth_g(28.0, 0.25) / equation_1 - 1.0).abs() < 1e-14);
        for concept in [Concept::Msr, Concept::NonMsr] {
            let equation_4 = required_stroke_m(concept, speed, 1500.0);
            let equation_5 = FALL.required_stroke_m(concept, 1500.0);
            assert!((equation_5 / equation_4 - 1.0).abs() < 1e-14);
        }
    }

    #[test]
    fn mass_does_not_matter_to_equation_3() {
        let heavy = Fall {
            mass_kg: 80.0,
            ..FALL
        };
        let load = |fall: Fall| fall.penetration_load_earth_g(28.0, 0.25);
        assert_eq!(load(heavy), load(FALL));
    }
}
