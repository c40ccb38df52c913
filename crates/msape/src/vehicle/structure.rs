//! Thickness of carrier and primary structure: the largest of minimum gauge, strength and buckling.
//!
//! ```text
//! cone under pressure      p_cr = 0.92 γ E t^{5/2} / (L ρ^{3/2}), γ = 0.75, ρ = r̄ / cos θ
//! spherical cap            p_cr = 0.14 · 2 E (t/R)² / √(3 (1 − ν²))
//! cylinder, axial          P_cr = γ 2π E t² / √(3 (1 − ν²)), γ = 1 − 0.901 (1 − e^{−√(R/t)/16})
//! membrane                 N = p r / cos θ (cone), p R / 2 (cap), P / (2π R) (cylinder); t = N / σ
//! sandwich                 t → √3 (h − t_f), E → 2 E t_f / t
//! ```
//!
//! with pressures in Pa, lengths in m, E and σ in Pa, P in N, N in N/m; θ the cone half-angle, L the slant length and r̄
//! the mean radius of the cone between primary structure and shoulder, h the height of a sandwich and t_f one face.
//! Loads, all times the safety factor: on the forebody the larger of peak stagnation pressure and entry load times mass
//! over area; on the lid a fraction of it (the aft side of the wing is a dish that the wing's filling backs: it follows the
//! lid); on the primary structure the larger of entry and launch load times the mass it carries.
//!
//! # Valid
//! Thin isotropic walls; cones of 10-75 deg. Wrinkling and shear of the core are not checked.
//!
//! # References
//! - \[nasa-sp-8019\] cones, hydrostatic pressure; \[nasa-sp-8032\] caps, lower bound of the knock-down for large λ;
//!   \[nasa-sp-8007\] cylinders; \[nasa-std-5001\] factors. The loads and gauges are choices: see data/vehicles/mmeev.toml.

use numerics::math::{PI, exp, pow};
use serde::{Deserialize, Serialize};

/// How a wall is built.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Construction {
    /// One laminate.
    Solid {
        /// Density, kg/m³.
        density_kg_m3: f64,
    },
    /// Two faces and a core.
    Sandwich {
        /// Thickness of one face, at least, m.
        face_thickness_m: f64,
        /// Density of the faces, kg/m³.
        face_density_kg_m3: f64,
        /// Density of the core, kg/m³.
        core_density_kg_m3: f64,
    },
}

/// Material and build of a wall.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Carrier {
    /// Build and densities.
    pub construction: Construction,
    /// Young's modulus of laminate or faces, Pa.
    pub elastic_modulus_pa: f64,
    /// Poisson's ratio of laminate or faces.
    pub poisson_ratio: f64,
    /// Allowable stress of laminate or faces, Pa.
    pub strength_pa: f64,
    /// Least thickness, m.
    pub minimum_gauge_m: f64,
}

/// Factors of the structural rules.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct StructureLoads {
    /// Factor on every load.
    pub safety_factor: f64,
    /// Axial load at launch, Earth g.
    pub launch_axial_load_earth_g: f64,
    /// Pressure on the lid as a fraction of that on the forebody.
    pub aftbody_pressure_fraction: f64,
}

/// What determines the thickness of a wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Governs {
    /// Given by the user.
    Given,
    /// The least thickness made.
    MinimumGauge,
    /// Stress.
    Strength,
    /// Buckling of the cone between primary structure and shoulder, or of the cylinder.
    Buckling,
    /// Buckling of the spherical nose or lid.
    CapBuckling,
}

/// One wall as sized.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Wall {
    /// Thickness, of a sandwich its height, m.
    pub thickness_m: f64,
    /// Mean density, kg/m³.
    pub density_kg_m3: f64,
    /// What determines it.
    pub governs: Governs,
    /// Thickness that strength alone asks for, m.
    pub strength_thickness_m: f64,
    /// Thickness that buckling alone asks for, m.
    pub buckling_thickness_m: f64,
    /// Thickness that buckling of nose or lid alone asks for, m.
    pub cap_buckling_thickness_m: f64,
}

/// A cone between two rings under external pressure, Pa, with its spherical cap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PressureShell {
    /// Design pressure, factor included, Pa.
    pub pressure_pa: f64,
    /// Slant length of the cone, m; zero when there is none.
    pub slant_length_m: f64,
    /// Mean normal radius of curvature of the cone, m.
    pub cone_curvature_radius_m: f64,
    /// Largest normal radius of curvature of the cone, m.
    pub largest_curvature_radius_m: f64,
    /// Radius of the cap, m.
    pub cap_radius_m: f64,
}

/// The three walls as sized.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Structure {
    /// Forebody carrier structure.
    pub forebody: Wall,
    /// Aftbody carrier structure.
    pub aftbody: Wall,
    /// Primary structure.
    pub primary: Wall,
}

/// Knock-down of SP-8019 for cones under hydrostatic pressure.
const CONE_PRESSURE_KNOCKDOWN: f64 = 0.75;
/// Knock-down of SP-8032 for spherical caps, lower bound.
const CAP_KNOCKDOWN: f64 = 0.14;

impl Carrier {
    /// The wall at its least thickness.
    pub fn at_minimum_gauge(&self) -> Wall {
        self.wall(0.0, 0.0, 0.0)
    }

    /// The wall at a given thickness.
    pub fn at_thickness(&self, thickness_m: f64) -> Wall {
        let carrier = Self {
            minimum_gauge_m: thickness_m,
            ..*self
        };
        Wall {
            governs: Governs::Given,
            ..carrier.wall(0.0, 0.0, 0.0)
        }
    }

    /// Thickness √3 (h − t_f) and face thickness of a wall that carries `membrane_n_m`, as functions of the height.
    fn face_thickness_m(&self, membrane_n_m: f64) -> Option<f64> {
        match self.construction {
            Construction::Solid { .. } => None,
            Construction::Sandwich {
                face_thickness_m, ..
            } => Some(face_thickness_m.max(membrane_n_m / (2.0 * self.strength_pa))),
        }
    }

    /// Thickness for a solid wall whose capacity is `k E tⁿ`, or of a sandwich after equivalent thickness and modulus, m.
    fn thickness_for(&self, demand_over_k: f64, n: f64, membrane_n_m: f64) -> f64 {
        let e = self.elastic_modulus_pa;
        match self.face_thickness_m(membrane_n_m) {
            None => pow(demand_over_k / e, 1.0 / n),
            // k (2 E t_f / t) tⁿ with t = √3 (h − t_f)
            Some(t_f) => {
                t_f + pow(demand_over_k / (2.0 * e * t_f), 1.0 / (n - 1.0)) / 3.0_f64.sqrt()
            }
        }
    }

    fn wall(&self, membrane_n_m: f64, buckling_m: f64, cap_m: f64) -> Wall {
        let strength_m = match self.face_thickness_m(membrane_n_m) {
            None => membrane_n_m / self.strength_pa,
            Some(t_f) => 2.0 * t_f,
        };
        let mut wall = Wall {
            thickness_m: self.minimum_gauge_m,
            density_kg_m3: 0.0,
            governs: Governs::MinimumGauge,
            strength_thickness_m: strength_m,
            buckling_thickness_m: buckling_m,
            cap_buckling_thickness_m: cap_m,
        };
        for (thickness, governs) in [
            (strength_m, Governs::Strength),
            (buckling_m, Governs::Buckling),
            (cap_m, Governs::CapBuckling),
        ] {
            if thickness > wall.thickness_m {
                wall.thickness_m = thickness;
                wall.governs = governs;
            }
        }
        wall.density_kg_m3 = match (self.construction, self.face_thickness_m(membrane_n_m)) {
            (
                Construction::Sandwich {
                    face_density_kg_m3,
                    core_density_kg_m3,
                    ..
                },
                Some(t_f),
            ) if wall.thickness_m > 0.0 => {
                let faces = (2.0 * t_f / wall.thickness_m).min(1.0);
                faces * face_density_kg_m3 + (1.0 - faces) * core_density_kg_m3
            }
            (
                Construction::Sandwich {
                    face_density_kg_m3, ..
                },
                _,
            ) => face_density_kg_m3,
            (Construction::Solid { density_kg_m3 }, _) => density_kg_m3,
        };
        wall
    }

    /// The wall of a shell under external pressure.
    pub fn pressure_wall(&self, shell: &PressureShell) -> Wall {
        let PressureShell {
            pressure_pa: p,
            slant_length_m: l,
            cone_curvature_radius_m: rho,
            ..
        } = *shell;
        let cap = shell.cap_radius_m;
        let membrane = p * shell.largest_curvature_radius_m.max(cap / 2.0);
        let cone = if l > 0.0 {
            self.thickness_for(
                p * l * rho * rho.sqrt() / (0.92 * CONE_PRESSURE_KNOCKDOWN),
                2.5,
                membrane,
            )
        } else {
            0.0
        };
        let root = (3.0 * (1.0 - self.poisson_ratio * self.poisson_ratio)).sqrt();
        let sphere =
            self.thickness_for(p * cap * cap * root / (2.0 * CAP_KNOCKDOWN), 2.0, membrane);
        self.wall(membrane, cone, sphere)
    }

    /// The wall of a cylinder of radius `radius_m` under the axial design load `load_n`.
    pub fn axial_wall(&self, radius_m: f64, load_n: f64) -> Wall {
        let membrane = load_n / (2.0 * PI * radius_m);
        let slender = (radius_m / self.minimum_gauge_m.max(1e-6)).sqrt() / 16.0;
        // taken at the least gauge: a thicker wall is knocked down less
        let gamma = 1.0 - 0.901 * (1.0 - exp(-slender));
        let root = (3.0 * (1.0 - self.poisson_ratio * self.poisson_ratio)).sqrt();
        let buckling = self.thickness_for(load_n * root / (gamma * 2.0 * PI), 2.0, membrane);
        self.wall(membrane, buckling, 0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn solid() -> Carrier {
        Carrier {
            construction: Construction::Solid {
                density_kg_m3: 1600.0,
            },
            elastic_modulus_pa: 70.0e9,
            poisson_ratio: 0.3,
            strength_pa: 100.0e6,
            minimum_gauge_m: 0.001,
        }
    }

    #[test]
    fn cone_wall_carries_exactly_the_pressure_it_was_sized_for() {
        let shell = PressureShell {
            pressure_pa: 2.0e5,
            slant_length_m: 0.3,
            cone_curvature_radius_m: 0.6,
            largest_curvature_radius_m: 0.8,
            cap_radius_m: 0.2,
        };
        let t = solid().pressure_wall(&shell).buckling_thickness_m;
        let capacity = 0.92 * 0.75 * 70.0e9 * t * t * t.sqrt() / (0.3 * 0.6 * 0.6_f64.sqrt());
        assert!((capacity / 2.0e5 - 1.0).abs() < 1e-12);
        // strength: 2e5 · 0.8 / 1e8 = 1.6 mm
        assert!((solid().pressure_wall(&shell).strength_thickness_m - 0.0016).abs() < 1e-15);
    }

    #[test]
    fn cap_wall_carries_exactly_the_pressure_it_was_sized_for() {
        let shell = PressureShell {
            pressure_pa: 1.0e5,
            slant_length_m: 0.0,
            cone_curvature_radius_m: 0.0,
            largest_curvature_radius_m: 0.0,
            cap_radius_m: 0.5,
        };
        let wall = solid().pressure_wall(&shell);
        let t = wall.cap_buckling_thickness_m;
        let capacity = 0.14 * 2.0 * 70.0e9 * (t / 0.5) * (t / 0.5) / (3.0_f64 * 0.91).sqrt();
        assert!((capacity / 1.0e5 - 1.0).abs() < 1e-12);
        assert_eq!(wall.governs, Governs::CapBuckling);
    }

    #[test]
    fn light_load_leaves_the_minimum_gauge() {
        let wall = solid().axial_wall(0.2, 1000.0);
        assert_eq!(
            (wall.thickness_m, wall.governs),
            (0.001, Governs::MinimumGauge)
        );
    }

    #[test]
    fn sandwich_of_10_mm_with_half_millimetre_faces_is_mostly_core() {
        let sandwich = Carrier {
            construction: Construction::Sandwich {
                face_thickness_m: 0.0005,
                face_density_kg_m3: 2700.0,
                core_density_kg_m3: 50.0,
            },
            minimum_gauge_m: 0.01,
            ..solid()
        };
        // a tenth faces: 270 + 45
        assert!((sandwich.at_minimum_gauge().density_kg_m3 - 315.0).abs() < 1e-9);
        assert_eq!(sandwich.at_thickness(0.02).governs, Governs::Given);
    }

    #[test]
    fn sandwich_needs_the_height_at_which_equivalent_wall_buckles() {
        let e = 70.0e9;
        let (t_f, k) = (0.0005, 3.0);
        let sandwich = Carrier {
            construction: Construction::Sandwich {
                face_thickness_m: t_f,
                face_density_kg_m3: 2700.0,
                core_density_kg_m3: 50.0,
            },
            ..solid()
        };
        let h = sandwich.thickness_for(1.0e6 / k, 2.5, 0.0);
        let t = 3.0_f64.sqrt() * (h - t_f);
        let capacity = k * (2.0 * e * t_f / t) * t * t * t.sqrt();
        assert!((capacity / 1.0e6 - 1.0).abs() < 1e-12);
    }
}
