//! Walls of carrier and primary structure: materials, and the thickness that the rules require.
//!
//! ```text
//! t = max(gauge, strength, buckling of cone, cap or cylinder, core shear)
//! t_f = max(least face, N / 2 min(σ, σ_wr), ∛(N (1 − ν²) S² / 4 E))
//! ```
//!
//! with thicknesses in m, N the largest force in the wall in N/m, σ the strength and σ_wr the stress at which faces wrinkle,
//! Pa, S the size of a honeycomb's cells, m: a sandwich has faces t_f, and its height follows from the other rules.
//! [`capacity`] contains each rule, [`size`] the loads, [`check`] the results of every rule for a wall as built.
//!
//! # Valid
//! Thin walls; see each rule.
//!
//! # References
//! - \[samareh-2014\] section 3.1.6 names the module; its rules are not published. Those here are cited in [`capacity`].

pub mod capacity;
pub mod check;
pub mod size;

pub use check::{Check, LoadCase, Rule};
pub use size::{AxialLoads, PressureShell, WallLoads};

use crate::vehicle::kinds::WallPlace;
use numerics::scalar::Single;
use numerics::scalar::functions::cbrt;
use serde::{Deserialize, Serialize};

/// How a wall is built.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Construction<S = f64> {
    /// A laminate.
    Solid {
        /// Density, kg/m³.
        density_kg_m3: S,
    },
    /// Two faces and a core.
    Sandwich {
        /// Thickness of one face, at least, m.
        face_thickness_m: S,
        /// Density of the faces, kg/m³.
        face_density_kg_m3: S,
        /// Density of the core, kg/m³.
        core_density_kg_m3: S,
        /// Young's modulus of the core across the wall, Pa.
        core_elastic_modulus_pa: S,
        /// Shear modulus of the core, in its softer direction, Pa.
        core_shear_modulus_pa: S,
        /// Shear strength of the core, in its weaker direction, Pa.
        core_shear_strength_pa: S,
        /// Size of a honeycomb's cells, between flats, m.
        cell_size_m: S,
    },
}

/// Material and build of a wall.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Carrier<S = f64> {
    /// Build and densities.
    pub construction: Construction<S>,
    /// Young's modulus of laminate or faces, Pa.
    pub elastic_modulus_pa: S,
    /// Poisson's ratio of laminate or faces.
    pub poisson_ratio: S,
    /// Allowable stress of laminate or faces, Pa.
    pub strength_pa: S,
    /// Least thickness, m.
    pub minimum_gauge_m: S,
}

/// Accelerations that act at once while the vehicle is launched, Earth g.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct LaunchLoad<S = f64> {
    /// Across the axis, Earth g.
    pub lateral_earth_g: S,
    /// Along the axis, Earth g.
    pub axial_earth_g: S,
}

/// Factors of the structural rules.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct StructureLoads<S = f64> {
    /// Factor on every load.
    pub safety_factor: S,
    /// Corners of the load factors at launch.
    pub launch: [LaunchLoad<S>; 4],
    /// Pressure on the lid as a fraction of that on the forebody.
    pub aftbody_pressure_fraction: S,
}

/// Criterion that determines the thickness of a wall.
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
    /// Shear in the core of a sandwich.
    CoreShear,
}

impl Governs {
    /// Name in plain words.
    pub fn label(self) -> &'static str {
        match self {
            Self::Given => "given",
            Self::MinimumGauge => "minimum gauge",
            Self::Strength => "strength",
            Self::Buckling => "buckling",
            Self::CapBuckling => "buckling of the spherical part",
            Self::CoreShear => "shear of the core",
        }
    }
}

/// A wall as sized.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Wall<S = f64> {
    /// Thickness, of a sandwich its height, m.
    pub thickness_m: S,
    /// Thickness of one face of a sandwich, m; zero for a laminate.
    pub face_thickness_m: S,
    /// Mean density, kg/m³.
    pub density_kg_m3: S,
    /// Criterion that determines the thickness.
    pub governs: Governs,
    /// Thickness that strength alone requires, m.
    pub strength_thickness_m: S,
    /// Thickness that buckling alone requires, m.
    pub buckling_thickness_m: S,
    /// Thickness that buckling of nose or lid alone requires, m.
    pub cap_buckling_thickness_m: S,
    /// Thickness that shear in the core alone requires, m.
    pub core_shear_thickness_m: S,
}

/// The three walls as sized.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Structure<S = f64> {
    /// Forebody carrier structure.
    pub forebody: Wall<S>,
    /// Aftbody carrier structure.
    pub aftbody: Wall<S>,
    /// Primary structure.
    pub primary: Wall<S>,
}

impl<S: Copy> Structure<S> {
    /// These walls with the governing criteria of others, which differ by less than the convergence.
    pub fn with_reasons(self, sized: Self) -> Self {
        let wall = |used: Wall<S>, sized: Wall<S>| Wall {
            thickness_m: used.thickness_m,
            face_thickness_m: used.face_thickness_m,
            density_kg_m3: used.density_kg_m3,
            ..sized
        };
        Self {
            forebody: wall(self.forebody, sized.forebody),
            aftbody: wall(self.aftbody, sized.aftbody),
            primary: wall(self.primary, sized.primary),
        }
    }

    /// The wall at a place.
    pub fn wall(&self, place: WallPlace) -> &Wall<S> {
        match place {
            WallPlace::Forebody => &self.forebody,
            WallPlace::Aftbody => &self.aftbody,
            WallPlace::Primary => &self.primary,
        }
    }
}

/// Requirements of the rules for a wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Needs<S = f64> {
    /// Largest force in the wall, N/m.
    pub membrane_n_m: S,
    /// Thickness of one face of a sandwich that carries it, m; `None` for a laminate.
    pub face_m: Option<S>,
    /// Thickness for buckling, m.
    pub buckling_m: S,
    /// Thickness for buckling of the spherical part, m.
    pub cap_buckling_m: S,
    /// Thickness for shear in the core, m.
    pub core_shear_m: S,
}

impl<S: Single> Needs<S> {
    /// Requirements of a force in the wall alone, N/m, with faces of a sandwich that carry it.
    pub fn of_force(carrier: &Carrier<S>, membrane_n_m: S) -> Self {
        let none = S::constant(0.0);
        Self {
            membrane_n_m,
            face_m: carrier.face_thickness_m(membrane_n_m),
            buckling_m: none,
            cap_buckling_m: none,
            core_shear_m: none,
        }
    }
}

impl<S: Single> Carrier<S> {
    /// The wall at its least thickness.
    pub fn at_minimum_gauge(&self) -> Wall<S> {
        self.wall(&Needs::of_force(self, S::constant(0.0)))
    }

    /// The wall at a given thickness.
    pub fn at_thickness(&self, thickness_m: S) -> Wall<S> {
        let carrier = Self {
            minimum_gauge_m: thickness_m,
            ..*self
        };
        Wall {
            governs: Governs::Given,
            ..carrier.at_minimum_gauge()
        }
    }

    /// Thickness of one face of a sandwich that carries `membrane_n_m`, m; `None` for a laminate.
    pub fn face_thickness_m(&self, membrane_n_m: S) -> Option<S> {
        match self.construction {
            Construction::Solid { .. } => None,
            Construction::Sandwich {
                face_thickness_m,
                cell_size_m,
                ..
            } => {
                let allowed = self.strength_pa.min(self.wrinkling_stress_pa());
                // N / 2 t_f ≤ 2 E (t_f/S)² / (1 − ν²)
                let plane = -(self.poisson_ratio * self.poisson_ratio) + 1.0;
                let dimpling = cbrt(
                    membrane_n_m * plane * cell_size_m * cell_size_m
                        / (self.elastic_modulus_pa * 4.0),
                );
                Some(
                    face_thickness_m
                        .max(membrane_n_m / (allowed * 2.0))
                        .max(dimpling),
                )
            }
        }
    }

    /// The wall that meets every need.
    pub fn wall(&self, needs: &Needs<S>) -> Wall<S> {
        let face = needs.face_m;
        let strength_m = match face {
            None => needs.membrane_n_m / self.strength_pa,
            Some(t_f) => t_f * 2.0,
        };
        let mut wall = Wall {
            thickness_m: self.minimum_gauge_m,
            face_thickness_m: face.unwrap_or(S::constant(0.0)),
            density_kg_m3: S::constant(0.0),
            governs: Governs::MinimumGauge,
            strength_thickness_m: strength_m,
            buckling_thickness_m: needs.buckling_m,
            cap_buckling_thickness_m: needs.cap_buckling_m,
            core_shear_thickness_m: needs.core_shear_m,
        };
        for (thickness, governs) in [
            (strength_m, Governs::Strength),
            (needs.buckling_m, Governs::Buckling),
            (needs.cap_buckling_m, Governs::CapBuckling),
            (needs.core_shear_m, Governs::CoreShear),
        ] {
            if wall.thickness_m.less(thickness) {
                wall.thickness_m = thickness;
                wall.governs = governs;
            }
        }
        wall.density_kg_m3 = match (self.construction, face) {
            (
                Construction::Sandwich {
                    face_density_kg_m3,
                    core_density_kg_m3,
                    ..
                },
                Some(t_f),
            ) if wall.thickness_m.value() > 0.0 => {
                let faces = (t_f * 2.0 / wall.thickness_m).min(S::constant(1.0));
                faces * face_density_kg_m3 + (-faces + 1.0) * core_density_kg_m3
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
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    pub fn solid() -> Carrier {
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

    pub fn sandwich() -> Carrier {
        Carrier {
            construction: Construction::Sandwich {
                face_thickness_m: 0.0005,
                face_density_kg_m3: 2700.0,
                core_density_kg_m3: 50.0,
                core_elastic_modulus_pa: 1.0e9,
                core_shear_modulus_pa: 2.0e8,
                core_shear_strength_pa: 2.0e6,
                cell_size_m: 0.003,
            },
            minimum_gauge_m: 0.01,
            ..solid()
        }
    }

    #[test]
    fn sandwich_of_10_mm_with_half_millimeter_faces_is_mostly_core() {
        // a tenth faces: 270 + 45
        assert!((sandwich().at_minimum_gauge().density_kg_m3 - 315.0).abs() < 1e-9);
        assert_eq!(sandwich().at_thickness(0.02).governs, Governs::Given);
        assert_eq!(sandwich().at_minimum_gauge().face_thickness_m, 0.0005);
    }

    #[test]
    fn faces_grow_until_they_carry_the_force() {
        // 2e5 N/m over 1e8 Pa: two faces of 1 mm; dimpling requires ∛(2e5 · 0.91 · 9e-6 / 2.8e11) = 0.18 mm
        let t_f = sandwich().face_thickness_m(2.0e5).unwrap();
        assert!((t_f - 0.001).abs() < 1e-15);
        let wide = Carrier {
            strength_pa: 1.0e10,
            construction: match sandwich().construction {
                Construction::Sandwich {
                    face_density_kg_m3,
                    core_density_kg_m3,
                    core_shear_modulus_pa,
                    core_shear_strength_pa,
                    ..
                } => Construction::Sandwich {
                    face_thickness_m: 1e-6,
                    face_density_kg_m3,
                    core_density_kg_m3,
                    core_elastic_modulus_pa: 1e15,
                    core_shear_modulus_pa,
                    core_shear_strength_pa,
                    cell_size_m: 0.1,
                },
                solid => solid,
            },
            ..sandwich()
        };
        // the faces then carry exactly the stress at which they dimple
        let t_f = wide.face_thickness_m(2.0e5).unwrap();
        assert!((2.0e5 / (2.0 * t_f) / wide.dimpling_stress_pa(t_f) - 1.0).abs() < 1e-12);
    }
}
