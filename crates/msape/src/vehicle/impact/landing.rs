//! The landing of a designed vehicle, on the chosen ground and on a rigid surface.
//!
//! ```text
//! m₁ = M_PL                                 the payload alone, as in equations 4 and 6
//! m₁ = M_PL + (foam + shell) (1 + margin)   MSR, on request: the impact sphere with the payload
//! m₂ = M − m₁
//! ```
//!
//! with masses in kg, m₁ the mass that crushes the foam, m₂ the rest, M the entry mass. The plateau of the foam is what its grade
//! offers, see [`super::supply`]. For the MSR concept the load with the whole sphere as m₁ is always given as well: on a
//! rigid surface it is the force where the foam has taken its energy, see [`super::absorber`].
//!
//! # Valid
//! As [`super::crush`]. With the payload alone the rest of the sphere is assumed to support itself: neither the mass of its foam
//! and panels nor the strength of its panels counts. With the whole sphere its mass counts and the panels' strength does not,
//! which is conservative. Crush of carrier and heat shield, which would help, is left out.
//!
//! # References
//! - \[samareh-2014\] section 3.1.5.

use crate::vehicle::Vehicle;
use crate::vehicle::impact::absorber::{Absorber, Shape};
use crate::vehicle::impact::crush::{Pulse, Touchdown, pulse};
use crate::vehicle::impact::soil::Soil;
use crate::vehicle::impact::striker::Striker;
use crate::vehicle::impact::supply::Supply;
use crate::vehicle::input::VehicleInput;
use crate::vehicle::kinds::ComponentKind;
use crate::vehicle::kinds::Concept;
use crate::vehicle::kinds::CrushingMass;
use crate::vehicle::kinds::EARTH_G_M_S2;
use numerics::math;
use numerics::scalar::Single;
use serde::{Deserialize, Serialize};

/// Velocity at touchdown, relative to the ground.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct TouchdownVelocity {
    /// Speed, m/s.
    pub speed_m_s: f64,
    /// Horizontal part, m/s.
    pub horizontal_m_s: f64,
}

/// Landing of a designed vehicle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Landing {
    /// Velocity at touchdown.
    pub velocity: TouchdownVelocity,
    /// Mass that crushes the foam, kg.
    pub payload_side_kg: f64,
    /// The foam.
    pub absorber: Absorber,
    /// Pulse on a rigid surface.
    pub rigid_surface: Pulse,
    /// Largest load on a rigid surface with the whole impact sphere as the mass that crushes the foam, Earth g; absent in the
    /// non-MSR concept.
    pub sphere_peak_load_earth_g: Option<f64>,
    /// Pulse on the chosen ground.
    pub ground: Pulse,
    /// Depth of a rigid vehicle in the chosen ground, m; zero on rigid ground.
    pub rigid_body_depth_m: f64,
    /// Foam of this strength that would stay on its plateau on a rigid surface, m; absent beyond ten meters.
    pub foam_needed_m: Option<f64>,
    /// Strength with which the foam would stay on its plateau on a rigid surface, Pa.
    pub strength_needed_pa: f64,
}

impl TouchdownVelocity {
    /// Velocity at the end of a flight with a speed, m/s, at an angle against the horizon, rad.
    pub fn new(speed_m_s: f64, flight_path_angle_rad: f64) -> TouchdownVelocity {
        TouchdownVelocity {
            speed_m_s,
            horizontal_m_s: speed_m_s * math::cos(flight_path_angle_rad).abs(),
        }
    }

    /// Downward part, m/s.
    pub fn vertical_m_s(&self) -> f64 {
        let (v, h) = (self.speed_m_s, self.horizontal_m_s);
        (v * v - h * h).max(0.0).sqrt()
    }

    /// Angle between velocity and vertical, rad.
    pub fn off_axis_rad(&self) -> f64 {
        math::atan2(self.horizontal_m_s, self.vertical_m_s())
    }
}

impl Landing {
    /// The landing of a vehicle built from an input.
    pub fn new(input: &VehicleInput, vehicle: &Vehicle, velocity: TouchdownVelocity) -> Landing {
        let speed_m_s = velocity.speed_m_s;
        let mass_kg = vehicle.mass.mass_kg;
        let sphere_kg = sphere_kg(vehicle).min(mass_kg);
        let payload_side_kg = match input.impact.crushing_mass {
            CrushingMass::Payload => input.payload_mass_kg,
            CrushingMass::ImpactSphere => sphere_kg,
        };
        let absorber = absorber(input, vehicle);
        let striker = Striker::new(&vehicle.layout.outline.forebody, mass_kg, speed_m_s);
        let soil = input.impact.ground.soil(&striker);
        let on = |soil| {
            pulse(&Touchdown {
                payload_side_kg,
                vehicle_side_kg: mass_kg - payload_side_kg,
                speed_m_s,
                absorber,
                soil,
            })
        };
        let rigid_surface = on(Soil::Rigid);
        let ground = match soil {
            Soil::Rigid => rigid_surface.clone(),
            softer => on(softer),
        };
        let energy_j = 0.5 * payload_side_kg * speed_m_s * speed_m_s;
        Landing {
            velocity,
            payload_side_kg,
            absorber,
            rigid_surface,
            sphere_peak_load_earth_g: match vehicle.concept {
                Concept::Msr => Some(rigid_surface_load_earth_g(&absorber, sphere_kg, speed_m_s)),
                Concept::NonMsr => None,
            },
            ground,
            rigid_body_depth_m: soil.rigid_body_depth_m(&striker),
            foam_needed_m: absorber.thickness_needed_m(energy_j),
            strength_needed_pa: absorber.plateau_needed_pa(energy_j),
        }
    }

    /// Part of the plateau that a rigid surface leaves: negative where the foam densifies.
    pub fn densification_margin(&self) -> f64 {
        1.0 - self.rigid_surface.stroke_m / self.absorber.plateau_crush_m()
    }
}

/// Mass of the payload and of the parts that move with it in the MSR concept, kg; of the payload alone in the other.
fn sphere_kg(vehicle: &Vehicle) -> f64 {
    let sphere: &[ComponentKind] = match vehicle.concept {
        Concept::Msr => &[
            ComponentKind::Payload,
            ComponentKind::ImpactFoam,
            ComponentKind::ImpactShell,
        ],
        Concept::NonMsr => &[ComponentKind::Payload],
    };
    sphere
        .iter()
        .filter_map(|kind| vehicle.component(*kind))
        .map(|component| component.mass_with_margin_kg)
        .sum()
}

/// Largest load of a mass that crushes the foam on a rigid surface, Earth g.
pub fn rigid_surface_load_earth_g<S: Single>(
    absorber: &Absorber<S>,
    mass_kg: S,
    speed_m_s: S,
) -> S {
    let stop_m = absorber.stop_m(mass_kg * 0.5 * speed_m_s * speed_m_s);
    absorber.force_n(stop_m) / (mass_kg * EARTH_G_M_S2)
}

/// The foam as built.
fn absorber(input: &VehicleInput, vehicle: &Vehicle) -> Absorber {
    Absorber {
        shape: Shape::of(input),
        thickness_m: vehicle.dimensions.foam_thickness_m,
        law: Supply::new(input).law(vehicle.impact.foam_strength_pa),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use numerics::math::RADIANS_PER_DEGREE;

    #[test]
    fn thirty_meters_per_second_at_60_deg_below_the_horizon_are_15_sideways() {
        let velocity = TouchdownVelocity::new(30.0, -60.0 * RADIANS_PER_DEGREE);
        assert!((velocity.horizontal_m_s - 15.0).abs() < 1e-12);
        assert!((velocity.off_axis_rad() / RADIANS_PER_DEGREE - 30.0).abs() < 1e-12);
        // 30 cos 30°
        assert!((velocity.vertical_m_s() - 25.980_762).abs() < 1e-6);
    }
}
