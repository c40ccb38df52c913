//! The impact foam that a landing asks for: least thickness, strength, and density at a thickness.
//!
//! ```text
//! t ≥ Stroke / η
//! ρ = ρ(FS) + ρ_panels        the grade that has the strength FS of equation 6; panels in the MSR concept only
//! ```
//!
//! with t the thickness in m, η the usable fraction of it, FS in Pa, ρ in kg/m³.
//!
//! # Valid
//! As [`crate::vehicle::impact`].
//!
//! # References
//! - \[samareh-2014\] section 3.1.5, equations 4 and 6.

use crate::vehicle::impact::{foam_density_kg_m3, foam_strength_pa, required_stroke_m};
use crate::vehicle::input::VehicleInput;
use crate::vehicle::kinds::{Concept, Foam};

/// Impact foam as the landing asks for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoamRule {
    /// Stroke of the payload on a rigid surface, m.
    pub stroke_m: f64,
    /// Thickness that gives this stroke, m.
    pub required_thickness_m: f64,
    /// The same or the least that the rules allow, m.
    pub least_thickness_m: f64,
    /// Compressive strength asked for, Pa.
    pub strength_pa: f64,
    density_kg_m3: f64,
}

impl FoamRule {
    /// The foam for the landing of a vehicle.
    pub fn new(input: &VehicleInput) -> FoamRule {
        let v = input.loads.terminal_speed_m_s;
        let stroke_m = required_stroke_m(input.concept, v, input.impact.crush_load_limit_earth_g);
        let required_thickness_m = stroke_m / input.impact.stroke_efficiency;
        // equation 6 with equation 4: the speed drops out, so that any speed above rest gives the same
        let strength_pa = if stroke_m > 0.0 {
            foam_strength_pa(
                input.payload_mass_kg,
                input.payload_diameter_m(),
                v,
                stroke_m,
            )
        } else {
            0.0
        };
        let density_kg_m3 = match input.densities.impact_foam_kg_m3 {
            Some(density) => density,
            None => {
                let panels = match input.concept {
                    Concept::Msr => input.densities.impact_panels_kg_m3,
                    Concept::NonMsr => 0.0,
                };
                foam_density_kg_m3(&input.foam_grades, strength_pa).unwrap_or(0.0) + panels
            }
        };
        FoamRule {
            stroke_m,
            required_thickness_m,
            least_thickness_m: required_thickness_m.max(input.rules.foam_thickness_min_m),
            strength_pa,
            density_kg_m3,
        }
    }

    /// The foam at a thickness, m.
    pub fn at(&self, thickness_m: f64) -> Foam {
        Foam {
            thickness_m,
            density_kg_m3: self.density_kg_m3,
        }
    }
}
