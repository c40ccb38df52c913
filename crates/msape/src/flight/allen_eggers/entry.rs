//! Constants of an entry by the closed form, and results that follow from them.
//!
//! ```text
//! V(h) = V_E exp(−ρ(h) H / (2 β sin γ)),   a_max = V_E² sin γ / (2 e H)
//! ```
//!
//! with the symbols and units of [`super`].
//!
//! # Valid
//! Range of [`super`].
//!
//! # References
//! - \[allen-eggers-1958\] equations 13, 15 and 17.

use crate::aero::Drag;
use crate::flight::mission::{Body, Mission};
use numerics::math;

/// Mach number of the drag coefficient.
const MACH: f64 = 25.0;
/// Least sine of the entry angle; shallower entries are computed with this one.
const SINE_MIN: f64 = 0.01;

/// The constants of one entry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Entry {
    /// Entry speed relative to the planet, m/s.
    pub speed_m_s: f64,
    /// Sine of the angle below the horizon.
    pub sine: f64,
    /// Ballistic coefficient, kg/m².
    pub ballistic_coefficient_kg_m2: f64,
    /// Density at altitude zero, kg/m³.
    pub surface_density_kg_m3: f64,
    /// Scale height, m.
    pub scale_height_m: f64,
}

impl Entry {
    /// The constants of a mission and a vehicle.
    pub fn of(mission: &Mission, body: &Body) -> Entry {
        let density = |altitude_m: f64| mission.atmosphere.density_kg_m3(altitude_m);
        let [low_m, high_m] = mission.planet.exponential_fit_m;
        let scale_height_m = (high_m - low_m) / math::ln(density(low_m) / density(high_m));
        let drag_coefficient = match &body.drag {
            Drag::Constant(coefficient) => *coefficient,
            Drag::Table(table) => table.at(MACH),
        };
        Entry {
            speed_m_s: mission.start.relative.speed_m_s,
            sine: (-math::sin(mission.start.relative.flight_path_angle_rad)).max(SINE_MIN),
            ballistic_coefficient_kg_m2: body.mass_kg
                / (drag_coefficient * body.reference_area_m2).max(f64::MIN_POSITIVE),
            surface_density_kg_m3: density(low_m) * math::exp(low_m / scale_height_m),
            scale_height_m,
        }
    }

    /// Density, kg/m³.
    pub fn density_kg_m3(&self, altitude_m: f64) -> f64 {
        self.surface_density_kg_m3 * math::exp(-altitude_m / self.scale_height_m)
    }

    /// Speed at an altitude, m/s.
    pub fn speed_at_m_s(&self, altitude_m: f64) -> f64 {
        let Entry {
            speed_m_s,
            sine,
            ballistic_coefficient_kg_m2: beta,
            scale_height_m: h,
            ..
        } = *self;
        speed_m_s * math::exp(-self.density_kg_m3(altitude_m) * h / (2.0 * beta * sine))
    }

    /// Largest deceleration, m/s².
    pub fn peak_deceleration_m_s2(&self) -> f64 {
        let Entry {
            speed_m_s: v,
            sine,
            scale_height_m: h,
            ..
        } = *self;
        v * v * sine / (2.0 * math::exp(1.0) * h)
    }

    /// Altitude of the largest deceleration, m; below ground where the vehicle is too heavy to get that slow.
    pub fn peak_deceleration_altitude_m(&self) -> f64 {
        let Entry {
            ballistic_coefficient_kg_m2: beta,
            sine,
            surface_density_kg_m3: rho_0,
            scale_height_m: h,
            ..
        } = *self;
        h * math::ln(rho_0 * h / (beta * sine))
    }
}
