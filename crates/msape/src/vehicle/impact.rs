//! Landing without parachute: load of ground penetration, stroke and strength of the impact foam on a rigid surface.
//!
//! ```text
//! G = α Dₙ V_t² / M                      (1)
//! Stroke = k V_t² / (2 Ḡ g)              (4), k = 2 for MSR (triangular pulse), 1 for non-MSR
//! FS = M_PL V_t² / (2 A_p Stroke)        (6)
//! foam thickness = Stroke / η
//! ```
//!
//! with G in Earth g, α the empirical constant of the ground, Dₙ the nose diameter in m (twice the nose radius), V_t the
//! speed at impact in m/s, M the mass in kg, Ḡ the design load in Earth g, g = 9.80665 m/s², FS in Pa, M_PL the payload's
//! mass in kg, A_p its cross-section in m², η the usable fraction of the foam's thickness.
//!
//! The landing in time, with crush of the foam and penetration together, is in [`crush`] and [`landing`]. The payload feels the
//! foam over its footprint there and not over its own cross-section as in equation 6: [`foam_rule`] takes thickness and strength
//! from that law, or from equation 6 as printed.
//!
//! # Valid
//! Vertical fall, one dimension, rigid payload. Equation 1: soft clay for which α was measured.
//! The printed 456 g of Table 16 needs Dₙ = 0.70-0.76 m; twice the nose radius of a 1.0 m vehicle with the ratio 0.75 is 0.75 m.
//!
//! # References
//! - \[samareh-2014\] section 3.1.5, equations 1, 4 and 6.

pub mod absorber;
pub mod crush;
pub mod estimates;
pub mod foam;
pub mod foam_rule;
pub mod footprint;
pub mod ground;
pub mod history;
pub mod landing;
pub mod remarks;
pub mod soil;
pub mod striker;
pub mod supply;
pub mod young;

pub use ground::{Ground, RigidBodyLoad};

use crate::vehicle::kinds::Concept;
use crate::vehicle::kinds::EARTH_G_M_S2;
use crate::vehicle::kinds::FoamStrength;
use numerics::math::PI;
use numerics::scalar::Single;
use serde::{Deserialize, Serialize};

/// Loads and foam of the landing.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Impact<S = f64> {
    /// Load of a rigid vehicle in the chosen ground, Earth g; absent on rigid ground.
    pub ground_penetration: Option<RigidBodyLoad<S>>,
    /// The constant α of equation 1; absent on other grounds.
    pub penetration_alpha: Option<f64>,
    /// Load on a rigid surface for which the foam is designed, Earth g.
    pub crush_load_limit_earth_g: S,
    /// Nose diameter in equation 1, m.
    pub nose_diameter_m: S,
    /// Stroke of the payload, m.
    pub required_stroke_m: S,
    /// Foam thickness that gives this stroke, m.
    pub required_foam_thickness_m: S,
    /// Fraction of the foam's thickness used for the stroke.
    pub stroke_efficiency: S,
    /// Law that determines the strength of the foam.
    pub foam_strength_by: FoamStrength,
    /// Requested compressive strength, Pa.
    pub foam_strength_pa: S,
    /// Compressive strength by equation 6, Pa.
    pub equation_6_strength_pa: S,
    /// Density of the foam, kg/m³.
    pub foam_density_kg_m3: S,
    /// Energy of the vehicle at impact, J.
    pub impact_energy_j: S,
}

/// Peak load of ground penetration, Earth g.
pub fn penetration_load_earth_g<S: Single>(
    alpha: f64,
    nose_diameter_m: S,
    speed_m_s: S,
    mass_kg: S,
) -> S {
    nose_diameter_m * alpha * speed_m_s * speed_m_s / mass_kg
}

/// Stroke over that of a constant deceleration: a triangular pulse takes twice as much.
pub fn pulse_factor(concept: Concept) -> f64 {
    match concept {
        Concept::Msr => 2.0,
        Concept::NonMsr => 1.0,
    }
}

/// Stroke of the payload on a rigid surface, m.
pub fn required_stroke_m<S: Single>(concept: Concept, speed_m_s: S, design_load_earth_g: S) -> S {
    speed_m_s * pulse_factor(concept) * speed_m_s / (design_load_earth_g * 2.0 * EARTH_G_M_S2)
}

/// Compressive strength of the foam, Pa.
pub fn foam_strength_pa<S: Single>(
    payload_mass_kg: S,
    payload_diameter_m: S,
    speed_m_s: S,
    stroke_m: S,
) -> S {
    let area_m2 = payload_diameter_m * PI * payload_diameter_m / 4.0;
    payload_mass_kg * speed_m_s * speed_m_s / (area_m2 * 2.0 * stroke_m)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn table_16_stroke_of_2_4_cm_is_26_7_m_s_at_1500_g() {
        // 26.7² / (2 · 1500 · 9.80665) = 712.89 / 29419.95 = 0.024231
        let stroke = required_stroke_m(Concept::NonMsr, 26.7, 1500.0);
        assert!((stroke - 0.024_231).abs() < 1e-6);
        assert_eq!(required_stroke_m(Concept::Msr, 26.7, 1500.0), 2.0 * stroke);
    }

    #[test]
    fn penetration_load_of_28_by_half_a_meter_at_20_m_s_with_40_kg_is_140_g() {
        // 28 · 0.5 · 400 / 40
        assert_eq!(penetration_load_earth_g(28.0, 0.5, 20.0, 40.0), 140.0);
    }

    #[test]
    fn foam_strength_is_payload_weight_at_the_design_load_over_its_area() {
        // with eq. 4 in eq. 6 the speed drops out: FS = M G g / A
        let stroke = required_stroke_m(Concept::NonMsr, 31.0, 1000.0);
        let area = PI * 0.2 * 0.2 / 4.0;
        let strength = foam_strength_pa(10.0, 0.2, 31.0, stroke);
        assert!((strength - 10.0 * 1000.0 * EARTH_G_M_S2 / area).abs() < 1e-6);
    }
}
