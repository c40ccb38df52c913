//! Cross-section of a sphere-cone forebody at the surface of the ground, when the nose is a depth z in it.
//!
//! ```text
//! r² = 2 Rₙ z − z²                       z ≤ z₁ = Rₙ (1 − sin θ)
//! r  = Rₙ cos θ + (z − z₁) tan θ         up to r = D/2, the same beyond
//! ```
//!
//! with lengths in m, θ the cone half-angle in rad.
//!
//! # Valid
//! The shoulder is taken as sharp. The ground neither rises nor sinks beside the vehicle.
//!
//! # References
//! - \[samareh-2014\] section 3.1.4.

use crate::vehicle::forebody::Forebody;
use crate::vehicle::impact::young;
use numerics::math::{self, PI};
use numerics::scalar::Single;

/// Terms of the series: z / 2 Rₙ is below a half, and below 0.07 for a cone of 60 deg.
const SERIES: u32 = 40;

/// Cross-section of a forebody at the surface of the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Footprint<S = f64> {
    nose_radius_m: S,
    nose_depth_m: S,
    nose_edge_m: S,
    slope: S,
    largest_radius_m: S,
    /// ∫ A^0.7 dz over the nose.
    nose_integral: S,
}

impl<S: Single> Footprint<S> {
    /// Footprint of the outer mold line of a forebody.
    pub fn new(forebody: &Forebody<S>) -> Footprint<S> {
        let (sin, cos) = forebody.sin_cos();
        let nose_radius_m = forebody.nose_radius_m;
        let nose_depth_m = nose_radius_m * (-sin + 1.0);
        let bare = Footprint {
            nose_radius_m,
            nose_depth_m,
            nose_edge_m: nose_radius_m * cos,
            slope: sin / cos,
            largest_radius_m: forebody.diameter_m / 2.0,
            nose_integral: S::constant(0.0),
        };
        Footprint {
            nose_integral: bare.cap_integral(nose_depth_m),
            ..bare
        }
    }

    /// Area of the largest cross-section, m².
    pub fn largest_area_m2(&self) -> S {
        self.largest_radius_m * PI * self.largest_radius_m
    }

    /// Depth of the spherical nose, m.
    pub fn nose_depth_m(&self) -> S {
        self.nose_depth_m
    }

    /// Depth at which the largest cross-section is reached, m.
    pub fn full_depth_m(&self) -> S {
        self.nose_depth_m + (self.largest_radius_m - self.nose_edge_m) / self.slope
    }

    /// Nose coefficient of Young's equation.
    pub fn nose_coefficient(&self) -> S {
        let diameter_m = self.largest_radius_m * 2.0;
        let sharp_m = self.largest_radius_m / self.slope;
        young::nose_coefficient(sharp_m / diameter_m, self.full_depth_m() / diameter_m)
    }

    /// Area of the cross-section at a depth, m².
    pub fn area_m2(&self, depth_m: S) -> S {
        let z = depth_m.max(S::constant(0.0));
        if z.value() <= self.nose_depth_m.value() {
            return z * PI * (self.nose_radius_m * 2.0 - z);
        }
        let r =
            (self.nose_edge_m + (z - self.nose_depth_m) * self.slope).min(self.largest_radius_m);
        r * PI * r
    }

    /// ∫ A^0.7 dz from the surface to a depth, m^2.4.
    pub fn integral(&self, depth_m: S) -> S {
        let z = depth_m.max(S::constant(0.0));
        if z.value() <= self.nose_depth_m.value() {
            return self.cap_integral(z);
        }
        let full_m = self.full_depth_m();
        let power = 2.0 * young::AREA_EXPONENT + 1.0;
        let r = self.nose_edge_m + (z.min(full_m) - self.nose_depth_m) * self.slope;
        let [power_of, exponent] = [power, young::AREA_EXPONENT].map(S::constant);
        let cone = (r.pow(power_of) - self.nose_edge_m.pow(power_of))
            * math::pow(PI, young::AREA_EXPONENT)
            / (self.slope * power);
        let beyond = (z - full_m).max(S::constant(0.0));
        let cylinder = beyond * self.largest_area_m2().pow(exponent);
        self.nose_integral + cone + cylinder
    }

    /// The integral over the nose: ∫ (π z (2 Rₙ − z))^0.7 dz, its last factor as a binomial series in z / 2 Rₙ.
    fn cap_integral(&self, depth_m: S) -> S {
        let (n, ratio) = (young::AREA_EXPONENT, depth_m / (self.nose_radius_m * 2.0));
        let (mut sum, mut coefficient) = (S::constant(0.0), S::constant(1.0));
        for k in 0..SERIES {
            let k = f64::from(k);
            sum += coefficient / (n + k + 1.0);
            coefficient *= ratio * ((k - n) / (k + 1.0));
        }
        let scale = self.nose_radius_m * (2.0 * PI) * depth_m;
        sum * depth_m * scale.pow(S::constant(n))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use numerics::math::RADIANS_PER_DEGREE;

    fn footprint() -> Footprint {
        Footprint::new(&Forebody {
            diameter_m: 2.0,
            nose_radius_m: 0.5,
            shoulder_radius_m: 0.02,
            cone_half_angle_rad: 45.0 * RADIANS_PER_DEGREE,
        })
    }

    #[test]
    fn nose_and_cone_meet_and_the_shoulder_ends_it() {
        let footprint = footprint();
        // 0.5 (1 − √½) = 0.146447; r² = ⅛ there
        assert!((footprint.nose_depth_m() - 0.146_447).abs() < 1e-6);
        for z in [footprint.nose_depth_m(), footprint.nose_depth_m() + 1e-15] {
            assert!((footprint.area_m2(z) - PI / 8.0).abs() < 1e-12);
        }
        // 0.146447 + 1 − 0.353553
        assert!((footprint.full_depth_m() - 0.792_893).abs() < 1e-6);
        assert_eq!(footprint.area_m2(5.0), PI);
        assert_eq!(footprint.area_m2(-1.0), 0.0);
    }

    #[test]
    fn integral_is_that_of_the_area_to_the_0p7() {
        let footprint = footprint();
        for depth_m in [0.05, 0.146_447, 0.5, 0.9] {
            let panels = 20_000;
            let step = depth_m / f64::from(panels);
            let sum: f64 = (0..panels)
                .map(|i| math::pow(footprint.area_m2((f64::from(i) + 0.5) * step), 0.7) * step)
                .sum();
            // midpoints of an integrand that starts as z^0.7: about 1e-7
            assert!((footprint.integral(depth_m) / sum - 1.0).abs() < 1e-6);
        }
    }

    #[test]
    fn nose_coefficient_counts_both_lengths() {
        // 0.56 + 0.125 (0.5 + 0.792893 / 2)
        assert!((footprint().nose_coefficient() - 0.672_056).abs() < 1e-6);
    }
}
