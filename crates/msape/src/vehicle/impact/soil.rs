//! Resistance of the ground against depth.
//!
//! ```text
//! F = (α g Dₙ V)² / M · z           equation 1: a rigid vehicle's peak is α Dₙ V² / M
//! F = F₁ (A(z) / A₁)^0.7            Young: F₁ the mean resistance to the largest cross-section A₁
//! ```
//!
//! with F in N, z in m, α the constant of equation 1, g = 9.80665 m/s², Dₙ in m, V in m/s, M in kg, A in m².
//!
//! # Valid
//! Equation 1 gives a peak and no history: a resistance proportional to the depth is the simplest with that peak, an assumption of
//! this project; its depth is M / (α g Dₙ). The ground does not push back: where the vehicle stops, it stays.
//!
//! # References
//! - \[samareh-2014\] equation 1; \[young-1997\].

use crate::vehicle::impact::footprint::Footprint;
use crate::vehicle::impact::striker::Striker;
use crate::vehicle::impact::young::AREA_EXPONENT;
use crate::vehicle::kinds::EARTH_G_M_S2;
use numerics::root;
use numerics::scalar::Single;

/// Relative error of the depth of a rigid vehicle.
const DEPTH_TOLERANCE: f64 = 1e-13;

/// Resistance of the ground to one vehicle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Soil<S = f64> {
    /// Rigid ground.
    Rigid,
    /// Force proportional to the depth.
    Linear {
        /// Force over depth, N/m.
        stiffness_n_m: S,
    },
    /// Force proportional to the cross-section at the surface to the power 0.7.
    Growing {
        /// Force over that power of the area, N/m^1.4.
        coefficient: S,
        /// Cross-sections.
        footprint: Footprint<S>,
    },
}

impl<S: Single> Soil<S> {
    /// The soil in which a rigid vehicle has the peak of equation 1.
    pub fn equation_1(alpha: f64, striker: &Striker<S>) -> Soil<S> {
        let root = striker.nose_diameter_m * (alpha * EARTH_G_M_S2) * striker.speed_m_s;
        Soil::Linear {
            stiffness_n_m: root * root / striker.mass_kg,
        }
    }

    /// A soil with this resistance to the largest cross-section, N.
    pub fn growing(full_n: S, footprint: Footprint<S>) -> Soil<S> {
        Soil::Growing {
            coefficient: full_n / footprint.largest_area_m2().pow(S::constant(AREA_EXPONENT)),
            footprint,
        }
    }

    /// Resistance at a depth, N; infinite where the ground is rigid.
    pub fn force_n(&self, depth_m: S) -> S {
        match *self {
            Soil::Rigid => S::constant(f64::INFINITY),
            Soil::Linear { stiffness_n_m } => stiffness_n_m * depth_m.max(S::constant(0.0)),
            Soil::Growing {
                coefficient,
                footprint,
            } => coefficient * footprint.area_m2(depth_m).pow(S::constant(AREA_EXPONENT)),
        }
    }

    /// Energy taken down to a depth, J.
    pub fn energy_j(&self, depth_m: S) -> S {
        match *self {
            Soil::Rigid => S::constant(0.0),
            Soil::Linear { stiffness_n_m } => stiffness_n_m * 0.5 * depth_m * depth_m,
            Soil::Growing {
                coefficient,
                footprint,
            } => coefficient * footprint.integral(depth_m),
        }
    }

    /// Depth at which a rigid vehicle stops, m.
    pub fn rigid_body_depth_m(&self, striker: &Striker<S>) -> S {
        let energy_j = striker.mass_kg * 0.5 * striker.speed_m_s * striker.speed_m_s;
        if matches!(self, Soil::Rigid) || energy_j.value() == 0.0 {
            return S::constant(0.0);
        }
        let missing = |z: S| self.energy_j(z) - energy_j;
        let missing_j = |z: f64| missing(S::constant(z)).value();
        let mut deep_m = striker.footprint.full_depth_m().value();
        while missing_j(deep_m) < 0.0 && deep_m < 1e6 {
            deep_m *= 2.0;
        }
        let depth_m = root::brent(missing_j, 0.0, deep_m, DEPTH_TOLERANCE * deep_m);
        depth_m.map_or(S::constant(deep_m), |z| S::implicit(z, missing))
    }

    /// Peak load of a rigid vehicle, Earth g; zero at rest.
    pub fn rigid_body_load_earth_g(&self, striker: &Striker<S>) -> S {
        if striker.speed_m_s.value() == 0.0 {
            return S::constant(0.0);
        }
        self.force_n(self.rigid_body_depth_m(striker)) / (striker.mass_kg * EARTH_G_M_S2)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vehicle::forebody::Forebody;
    use crate::vehicle::impact::penetration_load_earth_g;
    use numerics::math::RADIANS_PER_DEGREE;

    fn striker() -> Striker {
        let forebody = Forebody {
            diameter_m: 0.9,
            nose_radius_m: 0.1125,
            shoulder_radius_m: 0.0315,
            cone_half_angle_rad: 60.0 * RADIANS_PER_DEGREE,
        };
        Striker::new(&forebody, 45.0, 30.0)
    }

    #[test]
    fn rigid_vehicle_in_linear_soil_has_equation_1_and_its_depth() {
        let striker = striker();
        let soil = Soil::equation_1(28.0, &striker);
        let load = penetration_load_earth_g(28.0, 0.225, 30.0, 45.0);
        assert!((soil.rigid_body_load_earth_g(&striker) / load - 1.0).abs() < 1e-12);
        // 45 / (28 · 9.80665 · 0.225) = 0.72837
        assert!((soil.rigid_body_depth_m(&striker) - 0.728_37).abs() < 1e-5);
    }

    #[test]
    fn beyond_the_nose_a_cylinder_keeps_young_s_depth() {
        let striker = striker();
        let full_n = 20_000.0;
        let soil = Soil::growing(full_n, striker.footprint);
        let from = striker.footprint.full_depth_m();
        assert!((soil.force_n(2.0 * from) - full_n).abs() < 1e-9);
        assert!((soil.energy_j(from + 0.5) - soil.energy_j(from) - 0.5 * full_n).abs() < 1e-8);
        // the energy of 20250 J is used up in 1.0125 m of full resistance and what the nose spares
        let spared_m = from - soil.energy_j(from) / full_n;
        assert!((soil.rigid_body_depth_m(&striker) - 1.0125 - spared_m).abs() < 1e-9);
    }

    #[test]
    fn energy_is_the_integral_of_the_force() {
        let soil = Soil::growing(2e5, striker().footprint);
        for depth_m in [0.01, 0.1, 0.2, 0.4] {
            let h = 1e-6;
            let slope = (soil.energy_j(depth_m + h) - soil.energy_j(depth_m - h)) / (2.0 * h);
            assert!((slope / soil.force_n(depth_m) - 1.0).abs() < 1e-6);
        }
    }
}
