//! Stiffness of a wall, and the stress in its faces from the forces in it.
//!
//! ```text
//! solid      A = E t / (1 − ν²)         D = E t³ / 12 (1 − ν²)                      S = 5/6 G t
//! sandwich   A = 2 E t_f / (1 − ν²)     D = E (t_f d²/2 + t_f³/6) / (1 − ν²)        S = G_c d² / t_c
//! faces      σ = N/t ± 6 M/t²           σ = N/(2 t_f) ± M/(t_f d)                   τ_c = Q/d
//! ```
//!
//! with A in N/m, D in N m, S in N/m; t the thickness, t_f that of one face, d = h − t_f between the middles of the faces,
//! t_c = h − 2 t_f the core, m; E and G in Pa; N in N/m, M in N, Q in N/m.
//!
//! # Valid
//! Isotropic laminates and faces; a core that carries shear only, the same in every direction.
//!
//! # References
//! - \[timoshenko-woinowsky-1959\] plates; \[zenkert-1995\] sandwich, thin faces; \[reissner-1945\] the factor 5/6.

use serde::{Deserialize, Serialize};

/// Build of a wall.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Build {
    /// A laminate.
    Solid {
        /// Thickness, m.
        thickness_m: f64,
    },
    /// Two faces and a core.
    Sandwich {
        /// Height over both faces, m.
        height_m: f64,
        /// Thickness of one face, m.
        face_thickness_m: f64,
        /// Shear modulus of the core, Pa.
        core_shear_modulus_pa: f64,
    },
}

/// A wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    /// Build.
    pub build: Build,
    /// Young's modulus of laminate or faces, Pa.
    pub elastic_modulus_pa: f64,
    /// Poisson's ratio of laminate or faces.
    pub poisson_ratio: f64,
}

/// Stiffness of a wall.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stiffness {
    /// Stiffness in extension, N/m.
    pub membrane_n_m: f64,
    /// Stiffness in bending, N m.
    pub bending_nm: f64,
    /// Stiffness in transverse shear, N/m.
    pub shear_n_m: f64,
    /// Poisson's ratio.
    pub poisson_ratio: f64,
}

/// Forces in a wall: along the meridian (s), round the axis (θ), in-plane shear, and transverse shear.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Resultants {
    /// N_s, N_θ, N_sθ, N/m.
    pub membrane_n_m: [f64; 3],
    /// M_s, M_θ, M_sθ, N m/m.
    pub bending_n: [f64; 3],
    /// Q_s, Q_θ, N/m.
    pub shear_n_m: [f64; 2],
}

impl Resultants {
    /// N_s, N_θ, N_sθ, M_s, M_θ, M_sθ, Q_s, Q_θ.
    pub fn rows(&self) -> [f64; 8] {
        let ([a, b, c], [d, e, f], [g, h]) = (self.membrane_n_m, self.bending_n, self.shear_n_m);
        [a, b, c, d, e, f, g, h]
    }

    /// Sum of the forces of two harmonics, each times its factors for cos nθ and sin nθ at one place on the circle.
    pub fn at_angle(parts: [(&Self, [f64; 2]); 2]) -> Self {
        let mut sum = Self::default();
        for (part, [cos, sin]) in parts {
            for (i, factor) in [cos, cos, sin].into_iter().enumerate() {
                sum.membrane_n_m[i] += factor * part.membrane_n_m[i];
                sum.bending_n[i] += factor * part.bending_n[i];
            }
            sum.shear_n_m[0] += cos * part.shear_n_m[0];
            sum.shear_n_m[1] += sin * part.shear_n_m[1];
        }
        sum
    }
}

/// Stress in a wall.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stress {
    /// Equivalent stress after von Mises, the larger of both faces, Pa.
    pub equivalent_pa: f64,
    /// Mean transverse shear stress, of a sandwich in its core, Pa.
    pub transverse_shear_pa: f64,
}

/// Shear correction factor of a homogeneous wall.
const SHEAR_CORRECTION: f64 = 5.0 / 6.0;

impl Section {
    /// Stiffness in extension, bending and transverse shear.
    pub fn stiffness(&self) -> Stiffness {
        let (e, nu) = (self.elastic_modulus_pa, self.poisson_ratio);
        let plane = e / (1.0 - nu * nu);
        let (membrane_n_m, bending_nm, shear_n_m) = match self.build {
            Build::Solid { thickness_m: t } => (
                plane * t,
                plane * t * t * t / 12.0,
                SHEAR_CORRECTION * e / (2.0 * (1.0 + nu)) * t,
            ),
            Build::Sandwich {
                height_m: h,
                face_thickness_m: t_f,
                core_shear_modulus_pa: g_c,
            } => {
                let (d, t_c) = (h - t_f, (h - 2.0 * t_f).max(1e-9));
                (
                    2.0 * plane * t_f,
                    plane * (t_f * d * d / 2.0 + t_f * t_f * t_f / 6.0),
                    g_c * d * d / t_c,
                )
            }
        };
        Stiffness {
            membrane_n_m,
            bending_nm,
            shear_n_m,
            poisson_ratio: nu,
        }
    }

    /// Stress for the forces in the wall.
    pub fn stress(&self, forces: &Resultants) -> Stress {
        // σ = N / area ± M / modulus
        let (area, modulus, arm) = match self.build {
            Build::Solid { thickness_m: t } => (t, t * t / 6.0, t),
            Build::Sandwich {
                height_m,
                face_thickness_m: t_f,
                ..
            } => {
                let d = height_m - t_f;
                (2.0 * t_f, t_f * d, d)
            }
        };
        let face = |sign: f64| {
            let [s, theta, shear] = core::array::from_fn(|i| {
                forces.membrane_n_m[i] / area + sign * forces.bending_n[i] / modulus
            });
            s * s - s * theta + theta * theta + 3.0 * shear * shear
        };
        let [q_s, q_theta] = forces.shear_n_m;
        Stress {
            equivalent_pa: face(1.0).max(face(-1.0)).max(0.0).sqrt(),
            transverse_shear_pa: (q_s * q_s + q_theta * q_theta).sqrt() / arm,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sandwich_of_two_faces_of_1_mm_9_mm_apart() {
        let section = Section {
            build: Build::Sandwich {
                height_m: 0.010,
                face_thickness_m: 0.001,
                core_shear_modulus_pa: 2.0e8,
            },
            elastic_modulus_pa: 75.0e9,
            poisson_ratio: 0.0,
        };
        let s = section.stiffness();
        assert!((s.membrane_n_m - 1.5e8).abs() < 1e-4);
        // 75e9 (1e-3 · 81e-6 / 2 + 1e-9 / 6) = 3037.5 + 12.5
        assert!((s.bending_nm - 3050.0).abs() < 1e-9);
        // 2e8 · 81e-6 / 8e-3
        assert!((s.shear_n_m - 2.025e6).abs() < 1e-6);
        let stress = section.stress(&Resultants {
            bending_n: [900.0, 0.0, 0.0],
            shear_n_m: [9000.0, 0.0],
            ..Resultants::default()
        });
        // 900 / (1e-3 · 9e-3), 9000 / 9e-3
        assert!((stress.equivalent_pa - 1.0e8).abs() < 1e-6);
        assert!((stress.transverse_shear_pa - 1.0e6).abs() < 1e-8);
    }

    #[test]
    fn solid_wall_of_2_mm_bends_to_six_m_over_t_squared() {
        let section = Section {
            build: Build::Solid { thickness_m: 0.002 },
            elastic_modulus_pa: 91.0e9,
            poisson_ratio: 0.3,
        };
        let s = section.stiffness();
        assert!((s.membrane_n_m - 2.0e8).abs() < 1e-4);
        assert!((s.bending_nm - 1e11 * 8e-9 / 12.0).abs() < 1e-9);
        let stress = section.stress(&Resultants {
            membrane_n_m: [2000.0, 2000.0, 0.0],
            bending_n: [2.0, 2.0, 0.0],
            ..Resultants::default()
        });
        // 2000 / 2e-3 + 6 · 2 / 4e-6 = 1e6 + 3e6, the same both ways: its own equivalent
        assert!((stress.equivalent_pa - 4.0e6).abs() < 1e-6);
    }
}
