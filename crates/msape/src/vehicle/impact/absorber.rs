//! Force of the impact foam against its crush.
//!
//! ```text
//! F = A(s) σ(s/t)        A = A_p                    column under the payload (non-MSR)
//!                        A = π (2 R s − s²)         sphere flattened by a plane (MSR), R = R_p + t
//! ```
//!
//! with F in N, s the crush in m, t the foam's thickness in m, A_p the payload's cross-section in m², R_p its radius in m.
//!
//! # Valid
//! Up to s = t. One strain for the whole footprint, that on the axis, where the foam is thinnest: the rise by
//! densification is on the high side. The shell of the sphere folds without resisting.
//!
//! # References
//! - \[samareh-2014\] section 3.1.5: design by stroke and strength of the foam.

use crate::vehicle::impact::foam::CrushLaw;
use numerics::math::PI;
use numerics::root;
use serde::{Deserialize, Serialize};

/// Where the foam stands.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Shape {
    /// Under the payload, over this cross-section.
    Column {
        /// Cross-section, m².
        area_m2: f64,
    },
    /// Around the payload.
    Sphere {
        /// Radius of the payload, m.
        payload_radius_m: f64,
    },
}

/// Foam that takes the landing.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Absorber {
    /// Where it stands.
    pub shape: Shape,
    /// Thickness, m.
    pub thickness_m: f64,
    /// Stress against strain.
    pub law: CrushLaw,
}

impl Absorber {
    /// Footprint, m².
    pub fn area_m2(&self, crush_m: f64) -> f64 {
        match self.shape {
            Shape::Column { area_m2 } => area_m2,
            Shape::Sphere { payload_radius_m } => {
                let r = payload_radius_m + self.thickness_m;
                let s = crush_m.clamp(0.0, r);
                PI * s * (2.0 * r - s)
            }
        }
    }

    /// Force, N.
    pub fn force_n(&self, crush_m: f64) -> f64 {
        self.area_m2(crush_m) * self.law.stress_pa(crush_m / self.thickness_m)
    }

    /// Crushes at which the law bends: start and end of the plateau, closed cells, m; rising.
    pub fn bends_m(&self) -> [f64; 3] {
        let law = &self.law;
        [law.yield_strain(), law.plateau_strain(), law.last_strain()]
            .map(|strain| strain * self.thickness_m)
    }

    /// Slope of the force, N/m.
    pub fn slope_n_m(&self, crush_m: f64) -> f64 {
        let strain = crush_m / self.thickness_m;
        let growth_m = match self.shape {
            Shape::Column { .. } => 0.0,
            Shape::Sphere { payload_radius_m } => {
                let r = payload_radius_m + self.thickness_m;
                2.0 * PI * (r - crush_m.clamp(0.0, r))
            }
        };
        growth_m * self.law.stress_pa(strain)
            + self.area_m2(crush_m) * self.law.slope_pa(strain) / self.thickness_m
    }

    /// Stiffness when the load is taken off, N/m: denser foam is stiffer in proportion to its stress, up to the solid; never
    /// less than the slope of the law, so that foam gives back no more than it took.
    pub fn unloading_n_m(&self, crush_m: f64) -> f64 {
        let law = &self.law;
        let stress_pa = law.stress_pa(crush_m / self.thickness_m);
        let denser = (stress_pa / law.plateau_pa).max(1.0);
        let stiffest_pa = law.solid_modulus_pa.max(law.modulus_pa);
        let modulus_pa = (law.modulus_pa * denser).min(stiffest_pa);
        (self.area_m2(crush_m) * modulus_pa / self.thickness_m).max(self.slope_n_m(crush_m))
    }

    /// Volume swept by the footprint, m³: the energy taken by each Pa of a rigid plastic plateau.
    fn swept_m3(&self, crush_m: f64) -> f64 {
        match self.shape {
            Shape::Column { area_m2 } => area_m2 * crush_m,
            Shape::Sphere { payload_radius_m } => {
                let (r, s) = (payload_radius_m + self.thickness_m, crush_m);
                PI * s * s * (r - s / 3.0)
            }
        }
    }

    /// Crush at which the plateau ends, m.
    pub fn plateau_crush_m(&self) -> f64 {
        self.law.plateau_strain() * self.thickness_m
    }

    /// Plateau that takes an energy in the crush up to the end of the plateau, Pa.
    pub fn plateau_needed_pa(&self, energy_j: f64) -> f64 {
        energy_j / self.swept_m3(self.plateau_crush_m())
    }

    /// Thickness that takes an energy up to the end of the plateau, m; `None` beyond ten metres.
    pub fn thickness_needed_m(&self, energy_j: f64) -> Option<f64> {
        let left_j = |thickness_m: f64| {
            let other = Absorber {
                thickness_m,
                ..*self
            };
            self.law.plateau_pa * other.swept_m3(other.plateau_crush_m()) - energy_j
        };
        root::brent(left_j, 0.0, 10.0, 1e-9)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sphere() -> Absorber {
        Absorber {
            shape: Shape::Sphere {
                payload_radius_m: 0.1,
            },
            thickness_m: 0.1,
            law: CrushLaw {
                plateau_pa: 2.0e6,
                closed_strain: 0.8,
                knee_factor: 2.0,
                modulus_pa: 1e9,
                solid_modulus_pa: 5e9,
            },
        }
    }

    #[test]
    fn sphere_of_0p2_m_crushed_by_2_cm_pushes_with_47_8_kn() {
        // π 0.02 (0.4 − 0.02) = 0.0238761 m²
        assert!((sphere().force_n(0.02) - 47_752.2).abs() < 0.1);
        assert_eq!(sphere().force_n(0.0), 0.0);
        // E A / t = 1e9 · 0.0238761 / 0.1
        assert!((sphere().unloading_n_m(0.02) - 2.387_61e8).abs() < 1e3);
    }

    #[test]
    fn unloading_is_never_softer_than_the_law() {
        for shape in [sphere().shape, Shape::Column { area_m2: 0.03 }] {
            let foam = Absorber { shape, ..sphere() };
            for n in 1..1000 {
                let crush_m = f64::from(n) * 1e-4;
                let h = 1e-9;
                let slope = (foam.force_n(crush_m) - foam.force_n(crush_m - h)) / h;
                assert!(
                    foam.unloading_n_m(crush_m) >= slope * (1.0 - 1e-4),
                    "{crush_m}"
                );
            }
        }
    }

    #[test]
    fn what_is_needed_takes_the_energy_on_the_plateau() {
        let energy_j = 3000.0;
        for shape in [sphere().shape, Shape::Column { area_m2: 0.03 }] {
            let foam = Absorber { shape, ..sphere() };
            let thick = Absorber {
                thickness_m: foam.thickness_needed_m(energy_j).unwrap(),
                ..foam
            };
            let taken = 2.0e6 * thick.swept_m3(thick.plateau_crush_m());
            assert!((taken - energy_j).abs() < 1e-4);
            let needed_pa = foam.plateau_needed_pa(energy_j);
            assert!((needed_pa * foam.swept_m3(foam.plateau_crush_m()) - energy_j).abs() < 1e-9);
        }
        // column: 3000 / (2e6 · 0.03 · 0.4) = 0.125 m
        let column = Absorber {
            shape: Shape::Column { area_m2: 0.03 },
            ..sphere()
        };
        assert!((column.thickness_needed_m(energy_j).unwrap() - 0.125).abs() < 1e-8);
    }
}
