//! Kinetic temperature of the U.S. Standard Atmosphere 1976 above 86 km.
//!
//! ```text
//! 86–91 km      T = T₇
//! 91–110 km     T = T_c + A √(1 − ((z − z₈)/a)²)
//! 110–120 km    T = T₉ + L (z − z₉)
//! 120–1000 km   T = T∞ − (T∞ − T₁₀) exp(−λ ξ),   ξ = (z − z₁₀) (r₀ + z₁₀)/(r₀ + z)
//! ```
//!
//! with T in K, z, ξ, a and r₀ in m, L in K/m, λ in 1/m.
//!
//! # Valid
//! 86 to 1000 km; constant beyond the limit T∞ in effect.
//!
//! # References
//! - \[coesa-1976\] equations 25, 27, 29, 31.

use crate::definition::Definition;
use crate::lower::Lower;
use numerics::scalar::Scalar;

/// z₇, upper end of the homosphere, m.
pub const Z7_M: f64 = 86_000.0;
/// z₈, m.
pub const Z8_M: f64 = 91_000.0;
/// z₉, m.
pub const Z9_M: f64 = 110_000.0;
/// z₁₀, m.
pub const Z10_M: f64 = 120_000.0;

/// Formula that holds at an altitude.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Segment {
    /// 86 to 91 km.
    Isothermal,
    /// 91 to 110 km.
    Ellipse,
    /// 110 to 120 km.
    Linear,
    /// Above 120 km.
    Exponential,
}

/// The four formulas in SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Upper {
    t_7: f64,
    t_c: f64,
    ellipse_k: f64,
    ellipse_m: f64,
    t_9: f64,
    gradient_k_m: f64,
    t_10: f64,
    /// T∞, K.
    pub exosphere_k: f64,
    /// λ, 1/m.
    pub rate_per_m: f64,
    r_0: f64,
}

impl Upper {
    /// The formulas of the data file.
    pub fn new(definition: &Definition) -> Self {
        let u = &definition.upper_temperature;
        Self {
            t_7: u.isothermal_k,
            t_c: u.ellipse_centre_k,
            ellipse_k: u.ellipse_axis_k,
            ellipse_m: u.ellipse_axis_km * 1000.0,
            t_9: u.linear_base_k,
            gradient_k_m: u.linear_gradient_k_km / 1000.0,
            t_10: u.exponential_base_k,
            exosphere_k: u.exosphere_k,
            rate_per_m: u.exponential_rate_per_km / 1000.0,
            r_0: definition.constants.earth_radius_km * 1000.0,
        }
    }

    /// ξ, geopotential altitude above 120 km measured with the gravity there, m.
    #[inline]
    pub fn xi_m<S: Scalar>(&self, altitude_m: S) -> S {
        (altitude_m - Z10_M) * (self.r_0 + Z10_M) / (altitude_m + self.r_0)
    }

    /// Temperature, K.
    #[inline]
    pub fn temperature_k<S: Scalar>(&self, segment: Segment, altitude_m: S) -> S {
        let z = altitude_m;
        match segment {
            Segment::Isothermal => S::constant(self.t_7),
            Segment::Ellipse => {
                let x = (z - Z8_M) / self.ellipse_m;
                (S::constant(1.0) - x * x).max(S::constant(0.0)).sqrt() * self.ellipse_k + self.t_c
            }
            Segment::Linear => (z - Z9_M) * self.gradient_k_m + self.t_9,
            Segment::Exponential => {
                (self.xi_m(z) * -self.rate_per_m).exp() * (self.t_10 - self.exosphere_k)
                    + self.exosphere_k
            }
        }
    }

    /// dT/dz, K/m.
    pub fn gradient_k_m(&self, segment: Segment, altitude_m: f64) -> f64 {
        let z = altitude_m;
        match segment {
            Segment::Isothermal => 0.0,
            Segment::Ellipse => {
                let x = (z - Z8_M) / self.ellipse_m;
                -self.ellipse_k * x / self.ellipse_m / (1.0 - x * x).sqrt()
            }
            Segment::Linear => self.gradient_k_m,
            Segment::Exponential => {
                let stretch = (self.r_0 + Z10_M) / (self.r_0 + z);
                self.rate_per_m
                    * (self.exosphere_k - self.temperature_k(segment, z))
                    * stretch
                    * stretch
            }
        }
    }

    /// Temperature, K, the formula chosen by the altitude.
    #[inline]
    fn by_altitude<S: Scalar>(&self, altitude_m: S) -> S {
        let below = |limit_m: f64| altitude_m.less(S::constant(limit_m));
        let of = |segment| self.temperature_k(segment, altitude_m);
        let high = S::select(below(Z10_M), of(Segment::Linear), of(Segment::Exponential));
        let middle = S::select(below(Z9_M), of(Segment::Ellipse), high);
        S::select(below(Z8_M), of(Segment::Isothermal), middle)
    }
}

/// Kinetic temperature of the standard atmosphere at any altitude, for models that give a density only.
#[derive(Clone, Debug, PartialEq)]
pub struct StandardTemperature {
    /// Below 86 km.
    pub lower: Lower,
    /// Above 86 km.
    pub upper: Upper,
}

impl StandardTemperature {
    /// Kinetic temperature, K, the layer chosen by the altitude.
    #[inline]
    pub fn kinetic_k<S: Scalar>(&self, altitude_m: S) -> S {
        let low = self.lower.kinetic_temperature_k(self.upper.r_0, altitude_m);
        S::select(
            altitude_m.less(S::constant(Z7_M)),
            low,
            self.upper.by_altitude(altitude_m),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn standard() -> StandardTemperature {
        let definition = crate::sample::definition();
        StandardTemperature {
            lower: Lower::new(&definition),
            upper: Upper::new(&definition),
        }
    }

    #[test]
    fn printed_temperatures() {
        // Table I of the document: geometric altitude in m, T in K to the printed digit.
        for (z, t, digit) in [
            (0.0, 288.15, 1e-3),
            (11_000.0, 216.774, 1e-3),
            (86_000.0, 186.87, 1e-2),
            (100_000.0, 195.08, 1e-2),
            (110_000.0, 240.0, 1e-2),
            (120_000.0, 360.0, 1e-2),
            (200_000.0, 854.56, 1e-2),
        ] {
            assert!(
                (standard().kinetic_k(z) - t).abs() < digit,
                "{z}: {}",
                standard().kinetic_k(z)
            );
        }
    }

    #[test]
    fn gradient_is_the_slope_of_the_temperature() {
        let upper = standard().upper;
        for (segment, z) in [
            (Segment::Ellipse, 104_000.0),
            (Segment::Linear, 112_000.0),
            (Segment::Exponential, 180_000.0),
        ] {
            let slope = (upper.temperature_k(segment, z + 1.0)
                - upper.temperature_k(segment, z - 1.0))
                / 2.0;
            assert!((upper.gradient_k_m(segment, z) - slope).abs() < 1e-9, "{z}");
        }
    }
}
