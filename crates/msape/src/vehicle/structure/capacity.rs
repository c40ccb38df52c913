//! Capacities of walls, each the reverse of the thickness that it requires.
//!
//! ```text
//! cone under pressure      p_cr = 0.92 γ E t^{5/2} / (L ρ^{3/2}), γ = 0.75, ρ = r̄ / cos θ
//! cone, axial              P_cr = γ 2π E t² cos² θ / √(3 (1 − ν²)), γ = 0.33
//! spherical cap            p_cr = (0.14 + 3.2/λ²) · 2 E (t/R)² / √(3 (1 − ν²)), λ² = √(12 (1 − ν²)) (R/t) 4 sin² (φ/2) ≥ 4
//! cylinder, axial          P_cr = γ 2π E t² / √(3 (1 − ν²)), γ = 1 − 0.901 (1 − e^{−√(R/t)/16})
//! sandwich in the above    t → √3 d, E → 2 E t_f / t, d = h − t_f
//! face wrinkling           σ_wr = 0.5 ∛(E E_c G_c);   honeycomb of the height t_c: σ_wr = 0.33 E √(E_c t_f / (E t_c))
//! dimpling into a cell     σ = 2 E (t_f/S)² / (1 − ν²)
//! shear crimping           N = G_c d² / t_c
//! core shear at a ring     Q = p √(ρ d) / ∜(1 − ν²),  τ = Q / d
//! ```
//!
//! with pressures and stresses in Pa, lengths in m, P in N, N and Q in N/m; θ the cone half-angle, L the slant length and r̄
//! the mean radius of the cone between primary structure and shoulder, φ half the angle of the cap, h the height of a
//! sandwich and t_f one face, t_c the core, S the cell. Q is the shear at an edge that is clamped in a membrane under
//! pressure, with the length 1/b over which bending dies away, b⁴ = A / 4 ρ² D: p/b.
//!
//! # Valid
//! Thin walls; cones of 10-75 deg; λ > 2. The report cites no rule. For cones under pressure the closed form of
//! SP-8019 with its knock-down from tests is preferred to Bruhn's chart, which has none.
//!
//! # References
//! - \[nasa-sp-8019\] cones; \[nasa-sp-8032\] section 4.2.1.1, eqs 1-4, caps; \[nasa-sp-8007\] cylinders;
//!   \[ley-1999\] wrinkling, with the lower factor for honeycomb; \[hexcel-agu-075\] dimpling, crimping;
//!   \[timoshenko-woinowsky-1959\] edge of a shell.

use super::{Carrier, Construction};
use numerics::math::PI;
use numerics::scalar::Single;
use numerics::scalar::functions::cbrt;

/// Knock-down of SP-8019 for cones under hydrostatic pressure.
const CONE_PRESSURE_KNOCKDOWN: f64 = 0.75;
/// Knock-down of SP-8019 for cones under axial load.
const CONE_AXIAL_KNOCKDOWN: f64 = 0.33;
/// Knock-down of SP-8032 for spherical caps: for large λ, and what is added over λ².
const CAP_KNOCKDOWN: [f64; 2] = [0.14, 3.2];
/// λ² below which the knock-down of caps is not given.
const CAP_LEAST_LAMBDA_2: f64 = 4.0;
/// Factor of wrinkling of faces on a thick core.
const WRINKLING: f64 = 0.5;
/// Factor of wrinkling of faces on honeycomb.
const HONEYCOMB_WRINKLING: f64 = 0.33;

/// A spherical cap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cap<S = f64> {
    /// Radius, m.
    pub radius_m: S,
    /// Half the angle that it spans from its center, rad.
    pub half_angle_rad: S,
}

/// A cone between two rings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone<S = f64> {
    /// Slant length, m.
    pub slant_length_m: S,
    /// Mean normal radius of curvature, m.
    pub curvature_radius_m: S,
    /// Half-angle, rad.
    pub half_angle_rad: S,
}

impl<S: Single> Carrier<S> {
    /// √(3 (1 − ν²)).
    fn root(&self) -> S {
        ((-(self.poisson_ratio * self.poisson_ratio) + 1.0) * 3.0).sqrt()
    }

    /// Solid wall of the same stiffness: its thickness in m and modulus in Pa.
    pub fn equivalent(&self, thickness_m: S, face_thickness_m: S) -> (S, S) {
        let e = self.elastic_modulus_pa;
        match self.construction {
            Construction::Solid { .. } => (thickness_m, e),
            Construction::Sandwich { .. } => {
                let none = S::constant(0.0);
                let t = (thickness_m - face_thickness_m).max(none) * 3.0_f64.sqrt();
                (
                    t,
                    if t.value() > 0.0 {
                        e * 2.0 * face_thickness_m / t
                    } else {
                        none
                    },
                )
            }
        }
    }

    /// Thickness of a wall whose capacity is `k E tⁿ`, by the equivalent wall for a sandwich with faces of `face_m`, m.
    fn thickness_for(&self, demand_over_k: S, n: f64, face_m: Option<S>) -> S {
        let e = self.elastic_modulus_pa;
        match face_m {
            None => (demand_over_k / e).pow(S::constant(1.0 / n)),
            // k (2 E t_f / t) tⁿ with t = √3 (h − t_f)
            Some(t_f) => {
                let exponent = S::constant(1.0 / (n - 1.0));
                t_f + (demand_over_k / (e * 2.0 * t_f)).pow(exponent) / 3.0_f64.sqrt()
            }
        }
    }

    /// Pressure at which a cone buckles, Pa, for an equivalent wall (thickness in m, modulus in Pa).
    pub fn cone_pressure_pa(cone: &Cone<S>, (t, e): (S, S)) -> S {
        let rho = cone.curvature_radius_m;
        e * (0.92 * CONE_PRESSURE_KNOCKDOWN) * t * t * t.sqrt()
            / (cone.slant_length_m * rho * rho.sqrt())
    }

    /// Thickness at which a cone carries the pressure `pressure_pa`, m.
    pub fn cone_thickness_m(&self, cone: &Cone<S>, pressure_pa: S, face_m: Option<S>) -> S {
        let (l, rho) = (cone.slant_length_m, cone.curvature_radius_m);
        let over_k = pressure_pa * l * rho * rho.sqrt() / (0.92 * CONE_PRESSURE_KNOCKDOWN);
        self.thickness_for(over_k, 2.5, face_m)
    }

    /// Axial load at which a cone of the half-angle `half_angle_rad` buckles, N, for an equivalent wall.
    pub fn cone_axial_load_n(&self, half_angle_rad: S, (t, e): (S, S)) -> S {
        let cos = half_angle_rad.cos();
        e * (CONE_AXIAL_KNOCKDOWN * 2.0 * PI) * t * t * cos * cos / self.root()
    }

    /// Thickness at which a cone carries the axial load `load_n`, m.
    pub fn cone_axial_thickness_m(&self, half_angle_rad: S, load_n: S, face_m: Option<S>) -> S {
        let cos = half_angle_rad.cos();
        let over_k = load_n * self.root() / (cos * (CONE_AXIAL_KNOCKDOWN * 2.0 * PI) * cos);
        self.thickness_for(over_k, 2.0, face_m)
    }

    /// 3.2/λ² for a unit of thickness, 1/m.
    fn cap_rise_per_m(&self, cap: &Cap<S>) -> S {
        let half = (cap.half_angle_rad * 0.5).sin();
        // λ² = √(12 (1 − ν²)) (R/t) 4 sin² (φ/2), √12 = 2 √3
        S::constant(CAP_KNOCKDOWN[1]) / (self.root() * 2.0 * cap.radius_m * 4.0 * half * half)
    }

    /// Pressure at which a cap buckles, Pa, for an equivalent wall.
    pub fn cap_pressure_pa(&self, cap: &Cap<S>, (t, e): (S, S)) -> S {
        let [large, over_lambda_2] = CAP_KNOCKDOWN;
        let rise =
            (self.cap_rise_per_m(cap) * t).min(S::constant(over_lambda_2 / CAP_LEAST_LAMBDA_2));
        let slender = t / cap.radius_m;
        (rise + large) * 2.0 * e * slender * slender / self.root()
    }

    /// Thickness at which a cap carries the pressure `pressure_pa`, m.
    pub fn cap_thickness_m(&self, cap: &Cap<S>, pressure_pa: S, face_m: Option<S>) -> S {
        let [large, over_lambda_2] = CAP_KNOCKDOWN;
        let (rise, e) = (self.cap_rise_per_m(cap), self.elastic_modulus_pa);
        let most = large + over_lambda_2 / CAP_LEAST_LAMBDA_2;
        // (0.14 + a t) E t² = q
        let q = pressure_pa * cap.radius_m * cap.radius_m * self.root() / 2.0;
        match face_m {
            None => {
                let mut t = (q / (e * large)).sqrt();
                // from above a convex function: Newton's steps fall towards the root and halve its digits' number
                for _ in 0..NEWTON_STEPS {
                    let f = (rise * t + large) * t * t - q / e;
                    let slope = (rise * 3.0 * t + 2.0 * large) * t;
                    if slope.value() > 0.0 {
                        t -= f / slope;
                    }
                }
                t.max((q / (e * most)).sqrt())
            }
            Some(t_f) => {
                // (0.14 + a t) 2 E t_f t = q, t = √3 (h − t_f)
                let q = q / (e * 2.0 * t_f);
                let t = q * 2.0 / ((rise * 4.0 * q + large * large).sqrt() + large);
                t_f + t.max(q / most) / 3.0_f64.sqrt()
            }
        }
    }

    /// Axial load at which a cylinder of radius `radius_m` buckles, N, for an equivalent wall.
    pub fn cylinder_load_n(&self, radius_m: S, (t, e): (S, S)) -> S {
        self.cylinder_knockdown(radius_m) * 2.0 * PI * e * t * t / self.root()
    }

    /// Thickness at which a cylinder carries the axial load `load_n`, m.
    pub fn cylinder_thickness_m(&self, radius_m: S, load_n: S, face_m: Option<S>) -> S {
        let over_k = load_n * self.root() / (self.cylinder_knockdown(radius_m) * 2.0 * PI);
        self.thickness_for(over_k, 2.0, face_m)
    }

    /// Taken at the least gauge: a thicker wall is knocked down less.
    fn cylinder_knockdown(&self, radius_m: S) -> S {
        let slender = (radius_m / self.minimum_gauge_m.max(S::constant(1e-6))).sqrt() / 16.0;
        -((-(-slender).exp() + 1.0) * 0.901) + 1.0
    }

    /// Stress at which faces wrinkle on a thick core, Pa; infinite for a laminate.
    pub fn wrinkling_stress_pa(&self) -> S {
        match self.construction {
            Construction::Solid { .. } => S::constant(f64::INFINITY),
            Construction::Sandwich {
                core_elastic_modulus_pa: e_c,
                core_shear_modulus_pa: g_c,
                ..
            } => cbrt(self.elastic_modulus_pa) * WRINKLING * cbrt(e_c) * cbrt(g_c),
        }
    }

    /// Stress at which the faces of a sandwich `height_m` high wrinkle on honeycomb, Pa; infinite for a laminate.
    pub fn honeycomb_wrinkling_stress_pa(&self, height_m: S, face_thickness_m: S) -> S {
        match self.construction {
            Construction::Solid { .. } => S::constant(f64::INFINITY),
            Construction::Sandwich {
                core_elastic_modulus_pa: e_c,
                ..
            } => {
                let (e, t_f) = (self.elastic_modulus_pa, face_thickness_m);
                let t_c = (height_m - t_f * 2.0).max(S::constant(1e-9));
                e * HONEYCOMB_WRINKLING * (e_c * t_f / (e * t_c)).sqrt()
            }
        }
    }

    /// Stress at which faces dimple into the cells, Pa; infinite for a laminate.
    pub fn dimpling_stress_pa(&self, face_thickness_m: S) -> S {
        match self.construction {
            Construction::Solid { .. } => S::constant(f64::INFINITY),
            Construction::Sandwich { cell_size_m, .. } => {
                let ratio = face_thickness_m / cell_size_m;
                self.elastic_modulus_pa * 2.0 * ratio * ratio
                    / (-(self.poisson_ratio * self.poisson_ratio) + 1.0)
            }
        }
    }

    /// Force at which a sandwich crimps, N/m; infinite for a laminate.
    pub fn crimping_n_m(&self, height_m: S, face_thickness_m: S) -> S {
        match self.construction {
            Construction::Solid { .. } => S::constant(f64::INFINITY),
            Construction::Sandwich {
                core_shear_modulus_pa: g_c,
                ..
            } => {
                let d = height_m - face_thickness_m;
                g_c * d * d / (height_m - face_thickness_m * 2.0).max(S::constant(1e-9))
            }
        }
    }

    /// Shear stress in the core at a ring that holds a shell of the curvature radius `rho_m` under pressure, Pa.
    pub fn ring_shear_pa(&self, pressure_pa: S, rho_m: S, d_m: S) -> S {
        let plane = -(self.poisson_ratio * self.poisson_ratio) + 1.0;
        pressure_pa * (rho_m / d_m.max(S::constant(1e-9))).sqrt() / plane.sqrt().sqrt()
    }

    /// Height at which the core carries that stress, m; zero for a laminate.
    pub fn ring_shear_thickness_m(&self, pressure_pa: S, rho_m: S, face_m: Option<S>) -> S {
        match (self.construction, face_m) {
            (
                Construction::Sandwich {
                    core_shear_strength_pa: tau,
                    ..
                },
                Some(t_f),
            ) => {
                let plane = -(self.poisson_ratio * self.poisson_ratio) + 1.0;
                // τ = p √(ρ/d) / ∜(1 − ν²)
                t_f + rho_m * (pressure_pa / tau) * (pressure_pa / tau) / plane.sqrt()
            }
            _ => S::constant(0.0),
        }
    }
}

/// Steps that find the thickness of a cap: each doubles the digits.
const NEWTON_STEPS: usize = 8;

#[cfg(test)]
mod tests {
    use super::super::tests::{sandwich, solid};
    use super::*;

    const NOSE: Cap = Cap {
        radius_m: 0.5,
        half_angle_rad: PI / 6.0,
    };
    const CONE: Cone = Cone {
        slant_length_m: 0.3,
        curvature_radius_m: 0.6,
        half_angle_rad: PI / 3.0,
    };

    /// Each rule at the thickness that it requires carries exactly its demand.
    fn reversed(
        thickness: impl Fn(&Carrier) -> f64,
        capacity: impl Fn(&Carrier, (f64, f64)) -> f64,
        demand: f64,
    ) {
        for carrier in [solid(), sandwich()] {
            let t = thickness(&carrier);
            let wall = carrier.equivalent(t, carrier.face_thickness_m(0.0).unwrap_or(0.0));
            let ratio = capacity(&carrier, wall) / demand;
            assert!((ratio - 1.0).abs() < 1e-12, "{ratio}");
        }
    }

    #[test]
    fn every_thickness_carries_exactly_what_it_was_asked_for() {
        reversed(
            |c| c.cone_thickness_m(&CONE, 2e5, c.face_thickness_m(0.0)),
            |_, wall| Carrier::cone_pressure_pa(&CONE, wall),
            2e5,
        );
        reversed(
            |c| c.cap_thickness_m(&NOSE, 1e5, c.face_thickness_m(0.0)),
            |c, wall| c.cap_pressure_pa(&NOSE, wall),
            1e5,
        );
        reversed(
            |c| c.cap_thickness_m(&NOSE, 1e8, c.face_thickness_m(0.0)),
            |c, wall| c.cap_pressure_pa(&NOSE, wall),
            1e8,
        );
        reversed(
            |c| c.cylinder_thickness_m(0.2, 5e4, c.face_thickness_m(0.0)),
            |c, wall| c.cylinder_load_n(0.2, wall),
            5e4,
        );
        reversed(
            |c| c.cone_axial_thickness_m(1.0, 5e4, c.face_thickness_m(0.0)),
            |c, wall| c.cone_axial_load_n(1.0, wall),
            5e4,
        );
    }

    #[test]
    fn cap_of_1_mm_and_radius_half_a_meter() {
        // λ² = √10.92 · 500 · 4 sin² 15° = 442.7, 0.14 + 3.2/λ² = 0.14723; 2 · 70e9 / 500² / √2.73 = 338929
        let got = solid().cap_pressure_pa(&NOSE, (0.001, 70e9));
        assert!((got / (0.147_228 * 338_929.0) - 1.0).abs() < 1e-5, "{got}");
    }

    #[test]
    fn cone_of_1_mm_by_hand() {
        // 0.92 · 0.75 · 70e9 · 0.001^2.5 / (0.3 · 0.6^1.5) = 48.3e9 · 3.16228e-8 / 0.139427
        let got = Carrier::cone_pressure_pa(&CONE, (0.001, 70e9));
        assert!((got - 10_954.6).abs() < 1.0, "{got}");
    }

    #[test]
    fn core_of_2_mpa_holds_its_ring() {
        // p 1e5, ρ 0.5 m: d = 0.5 · (1e5 / 2e6)² / √0.91 = 1.3103 mm
        let face = sandwich().face_thickness_m(0.0);
        let t = sandwich().ring_shear_thickness_m(1e5, 0.5, face);
        assert!((t - 0.0005 - 0.001_310_3).abs() < 1e-7, "{t}");
        assert!((sandwich().ring_shear_pa(1e5, 0.5, t - 0.0005) / 2e6 - 1.0).abs() < 1e-12);
        assert_eq!(solid().ring_shear_thickness_m(1e5, 0.5, None), 0.0);
    }

    #[test]
    fn faces_of_the_sandwich_wrinkle_crimp_and_dimple() {
        // 0.5 ∛(70e9 · 1e9 · 2e8) = 0.5 · 2.41014e9
        assert!((sandwich().wrinkling_stress_pa() / 1.205_07e9 - 1.0).abs() < 1e-5);
        // 0.33 · 70e9 √(1e9 · 0.5 / (70e9 · 9)) = 23.1e9 · 0.0281718
        let honeycomb = sandwich().honeycomb_wrinkling_stress_pa(0.01, 0.0005);
        assert!((honeycomb / 6.507_7e8 - 1.0).abs() < 1e-4, "{honeycomb}");
        // 2e8 · 9.5² / 9 mm
        assert!((sandwich().crimping_n_m(0.01, 0.0005) - 2e8 * 9.025e-5 / 0.009).abs() < 1e-3);
        // 2 · 70e9 / 36 / 0.91
        assert!((sandwich().dimpling_stress_pa(0.0005) / 4.273_5e9 - 1.0).abs() < 1e-4);
        assert_eq!(solid().dimpling_stress_pa(0.0), f64::INFINITY);
    }
}
