//! Force of the impact foam against its crush, the energy that it absorbs, and its unloading.
//!
//! ```text
//! F = A(s) σ(s/t)        A = A_p                    column under the payload (non-MSR)
//!                        A = π (2 R s − s²)         sphere flattened by a plane (MSR), R = R_p + t
//! W = ∫ F ds             the rigid surface stops a mass m of the speed V at W = ½ m V², where F is largest
//! F↓ = F(s) A(u d)/A(d) u          u = 1 − (s − x)/d from the crush s back to s − d      column: F↓ = F(s) u
//! d = F/k ≤ F/F'         k = E A/t, of denser foam in proportion to its stress up to the solid's
//! ```
//!
//! with F in N, s the crush in m, t the foam's thickness in m, A_p the payload's cross-section in m², R_p its radius in m, W in J,
//! F↓ the force at x < s on the way back in N, d the elastic way in m, F' the slope of the force in N/m, E the modulus in Pa.
//! The way back has the shape of the law's own elastic branch, so that it is that branch at the start of the plateau.
//!
//! # Valid
//! Up to s = t. One strain for the whole footprint, that on the axis, where the foam is thinnest: the rise by
//! densification is on the high side. The shell of the sphere folds without resisting. Foam never gives back more than it took:
//! F↓ lies below the law, or gives back F d/2 ≤ F²/2F' at most, less than the law took above its tangent.
//!
//! # References
//! - \[samareh-2014\] section 3.1.5: design by stroke and strength of the foam. The way back is a choice of ours.

use crate::vehicle::impact::foam::CrushLaw;
use crate::vehicle::input::VehicleInput;
use crate::vehicle::kinds::Concept;
use numerics::math::PI;
use numerics::root;
use numerics::scalar::Single;
use serde::{Deserialize, Serialize};

/// Relative rounding.
const ROUNDING: f64 = 1e-13;
/// Largest crush over thickness in searches: far into the solid.
const MOST_CRUSH: f64 = 10.0;

/// Shape of the foam.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Shape<S = f64> {
    /// Column under the payload, with this cross-section.
    Column {
        /// Cross-section, m².
        area_m2: S,
    },
    /// Sphere around the payload.
    Sphere {
        /// Radius of the payload, m.
        payload_radius_m: S,
    },
}

impl<S: Single> Shape<S> {
    /// Shape of the foam of a vehicle.
    pub fn of(input: &VehicleInput<S>) -> Shape<S> {
        let payload_radius_m = input.payload_diameter_m() / 2.0;
        match input.concept {
            Concept::Msr => Shape::Sphere { payload_radius_m },
            Concept::NonMsr => Shape::Column {
                area_m2: payload_radius_m * PI * payload_radius_m,
            },
        }
    }
}

/// Foam that takes the landing.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Absorber<S = f64> {
    /// Shape of the foam.
    pub shape: Shape<S>,
    /// Thickness, m.
    pub thickness_m: S,
    /// Stress against strain.
    pub law: CrushLaw<S>,
}

impl<S: Single> Absorber<S> {
    /// Footprint, m².
    pub fn area_m2(&self, crush_m: S) -> S {
        match self.shape {
            Shape::Column { area_m2 } => area_m2,
            Shape::Sphere { payload_radius_m } => {
                let r = payload_radius_m + self.thickness_m;
                let s = crush_m.clamp(S::constant(0.0), r);
                s * PI * (r * 2.0 - s)
            }
        }
    }

    /// Force, N.
    pub fn force_n(&self, crush_m: S) -> S {
        self.area_m2(crush_m) * self.law.stress_pa(crush_m / self.thickness_m)
    }

    /// Crushes at which the law has a kink: start and end of the plateau, closed cells, m; rising.
    pub fn bends_m(&self) -> [S; 3] {
        let law = &self.law;
        [law.yield_strain(), law.plateau_strain(), law.last_strain()]
            .map(|strain| strain * self.thickness_m)
    }

    /// Slope of the force, N/m.
    pub fn slope_n_m(&self, crush_m: S) -> S {
        let strain = crush_m / self.thickness_m;
        let growth_m = match self.shape {
            Shape::Column { .. } => S::constant(0.0),
            Shape::Sphere { payload_radius_m } => {
                let r = payload_radius_m + self.thickness_m;
                (r - crush_m.clamp(S::constant(0.0), r)) * (2.0 * PI)
            }
        };
        growth_m * self.law.stress_pa(strain)
            + self.area_m2(crush_m) * self.law.slope_pa(strain) / self.thickness_m
    }

    /// Elastic recovery over which the force falls to zero on unloading, m.
    pub fn elastic_way_m(&self, crush_m: S) -> S {
        let law = &self.law;
        let yield_m = law.yield_strain() * self.thickness_m;
        if crush_m.value() <= yield_m.value() * (1.0 + ROUNDING) {
            return crush_m;
        }
        let stress_pa = law.stress_pa(crush_m / self.thickness_m);
        let denser = (stress_pa / law.plateau_pa).max(S::constant(1.0));
        let stiffest_pa = law.modulus_pa.max(S::constant(law.solid_modulus_pa));
        let modulus_pa = (law.modulus_pa * denser).min(stiffest_pa);
        // with k = E A / t the elastic recovery depends on the stress alone
        let soft_m = stress_pa * self.thickness_m / modulus_pa;
        let steepest_m = self.force_n(crush_m) / self.slope_n_m(crush_m);
        soft_m.min(steepest_m)
    }

    /// Force on the way back from the largest crush so far, m, at a smaller crush, m, N.
    pub fn unloading_n(&self, largest_m: S, crush_m: S) -> S {
        let way_m = self.elastic_way_m(largest_m);
        let left_m = crush_m - (largest_m - way_m);
        if left_m.value() <= 0.0 {
            return S::constant(0.0);
        }
        let area = self.area_m2(left_m) / self.area_m2(way_m);
        self.force_n(largest_m) * area * left_m / way_m
    }

    /// Energy taken up to a crush, J: the integral of the force.
    pub fn energy_j(&self, crush_m: S) -> S {
        let [yield_m, plateau_m, last_m] = self.bends_m();
        // at a bend the crush is taken, not the bend: the energy grows with it; footprint and stress are polynomials there, of degree 3 together: Simpson's rule is exact
        let simple = |from_m: S, to_m: S, stress_pa: &dyn Fn(S) -> S| {
            let force_n = |s: S| self.area_m2(s) * stress_pa(s / self.thickness_m);
            let middle_n = force_n((from_m + to_m) * 0.5);
            (to_m - from_m) / 6.0 * (force_n(from_m) + middle_n * 4.0 + force_n(to_m))
        };
        let law = &self.law;
        let elastic = simple(S::constant(0.0), yield_m.min(crush_m), &|strain| {
            law.modulus_pa * strain
        });
        if crush_m.value() <= yield_m.value() {
            return elastic;
        }
        let plateau = simple(yield_m, plateau_m.min(crush_m), &|_| law.plateau_pa);
        if crush_m.value() <= plateau_m.value() {
            return elastic + plateau;
        }
        let dense = self.dense_j(plateau_m, last_m.min(crush_m));
        if crush_m.value() <= last_m.value() {
            return elastic + plateau + dense;
        }
        let solid = simple(last_m, crush_m, &|strain| law.stress_pa(strain));
        elastic + plateau + dense + solid
    }

    /// Energy taken on the rising branch, J: ∫ A c / (ε_D − s/t) ds, term by term in y = ε_D − s/t.
    fn dense_j(&self, from_m: S, to_m: S) -> S {
        let (t, law) = (self.thickness_m, &self.law);
        let closed_m = law.closed_strain * t;
        let (high, low) = (law.closed_strain - from_m / t, law.closed_strain - to_m / t);
        let logarithm = (high / low).ln();
        let sum_m2 = match self.shape {
            Shape::Column { area_m2 } => area_m2 * logarithm,
            Shape::Sphere { payload_radius_m } => {
                // 2 R s − s² with s = closed − t y
                let r = payload_radius_m + t;
                (closed_m * (r * 2.0 - closed_m) * logarithm
                    + t * 2.0 * (closed_m - r) * (high - low)
                    - t * 0.5 * t * (high * high - low * low))
                    * PI
            }
        };
        law.scale_pa() * t * sum_m2
    }

    /// Crush at which a rigid surface has taken an energy, m: the largest of a landing on it.
    pub fn stop_m(&self, energy_j: S) -> S {
        let left_j = |crush_m: S| self.energy_j(crush_m) - energy_j;
        let longest_m = self.thickness_m * MOST_CRUSH;
        let at_j = |crush_m: f64| left_j(S::constant(crush_m)).value();
        let tolerance_m = ROUNDING * self.thickness_m.value();
        root::brent(at_j, 0.0, longest_m.value(), tolerance_m)
            .map_or(longest_m, |stop_m| S::implicit(stop_m, left_j))
    }

    /// Energy taken by each Pa of plateau up to a crush on the plateau, m³: the volume swept by the footprint, less what the
    /// elastic part leaves of it.
    pub fn taken_m3(&self, crush_m: S) -> S {
        let elastic_m = self.law.yield_strain() * self.thickness_m;
        match self.shape {
            Shape::Column { area_m2 } => area_m2 * (crush_m - elastic_m * 0.5),
            Shape::Sphere { payload_radius_m } => {
                let (r, s, y) = (payload_radius_m + self.thickness_m, crush_m, elastic_m);
                // π s² (R − s/3) less ∫ A (1 − s/y) ds over the elastic part
                (s * s * (r - s / 3.0) - y * y * (r / 3.0 - y / 12.0)) * PI
            }
        }
    }

    /// Crush at which the plateau ends, m.
    pub fn plateau_crush_m(&self) -> S {
        self.law.plateau_strain() * self.thickness_m
    }

    /// Plateau that takes an energy in the crush up to the end of the plateau, Pa.
    pub fn plateau_needed_pa(&self, energy_j: S) -> S {
        energy_j / self.taken_m3(self.plateau_crush_m())
    }

    /// Thickness that takes an energy up to the end of the plateau, m; `None` beyond ten meters.
    pub fn thickness_needed_m(&self, energy_j: S) -> Option<S> {
        let left_j = |thickness_m: S| {
            let other = Absorber {
                thickness_m,
                ..*self
            };
            self.law.plateau_pa * other.taken_m3(other.plateau_crush_m()) - energy_j
        };
        let at_j = |thickness_m: f64| left_j(S::constant(thickness_m)).value();
        let needed = root::brent(at_j, 0.0, 10.0, 1e-9);
        needed.map(|thickness_m| S::implicit(thickness_m, left_j))
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

    fn shapes() -> [Absorber; 2] {
        [sphere().shape, Shape::Column { area_m2: 0.03 }]
            .map(|shape| Absorber { shape, ..sphere() })
    }

    /// ∫ of a force up to a crush by the midpoint rule, J.
    fn midpoints(to_m: f64, force_n: impl Fn(f64) -> f64) -> f64 {
        let n = 20_000;
        let step = to_m / f64::from(n);
        (0..n)
            .map(|i| force_n((f64::from(i) + 0.5) * step) * step)
            .sum()
    }

    #[test]
    fn sphere_of_0p2_m_crushed_by_2_cm_pushes_with_47_8_kn() {
        // π 0.02 (0.4 − 0.02) = 0.0238761 m²
        assert!((sphere().force_n(0.02) - 47_752.2).abs() < 0.1);
        assert_eq!(sphere().force_n(0.0), 0.0);
        // 2e6 / 1e9 · 0.1 m of elastic recovery on the plateau
        assert!((sphere().elastic_way_m(0.02) - 2e-4).abs() < 1e-15);
    }

    #[test]
    fn energy_is_the_integral_of_the_force() {
        for foam in shapes() {
            // elastic up to 0.2 mm, plateau up to 40 mm, solid from about 78 mm
            for crush_m in [1e-4, 2e-4, 0.03, 0.04, 0.06, 0.075, 0.079, 0.08] {
                let sum = midpoints(crush_m, |s| foam.force_n(s));
                let energy = foam.energy_j(crush_m);
                assert!(
                    (energy / sum - 1.0).abs() < 1e-6,
                    "{crush_m} {energy} {sum}"
                );
                assert!((foam.stop_m(energy) - crush_m).abs() < 1e-12, "{crush_m}");
            }
        }
    }

    #[test]
    fn foam_never_gives_back_more_than_it_took() {
        for mut foam in shapes() {
            // stiff and soft at yield, light and dense
            for (modulus_pa, closed_strain) in [(1e9, 0.8), (1.3e8, 0.95), (1e8, 0.3), (7e6, 0.8)] {
                foam.law.modulus_pa = modulus_pa;
                foam.law.closed_strain = closed_strain;
                for n in 1..=400 {
                    let crush_m = f64::from(n) * 0.0025 * foam.thickness_m;
                    let back_m = foam.elastic_way_m(crush_m);
                    let start_m = crush_m - back_m;
                    let back_j = midpoints(back_m, |s| foam.unloading_n(crush_m, start_m + s));
                    let taken_j = foam.energy_j(crush_m);
                    // elastic foam gives all back
                    assert!(
                        back_j <= taken_j * (1.0 + 1e-7),
                        "{foam:?} {crush_m} {}",
                        back_j / taken_j
                    );
                    assert!(start_m >= -1e-15 && back_m > 0.0);
                }
            }
        }
    }

    #[test]
    fn the_way_back_begins_as_the_elastic_branch_and_ends_at_the_law() {
        for foam in shapes() {
            let yield_m = foam.law.yield_strain() * foam.thickness_m;
            // just beyond the yield, unloading still follows the law itself
            let beyond_m = yield_m * (1.0 + 1e-9);
            for share in [0.1, 0.5, 0.9] {
                let crush_m = share * yield_m;
                let ratio = foam.unloading_n(beyond_m, crush_m) / foam.force_n(crush_m);
                assert!((ratio - 1.0).abs() < 1e-7, "{ratio}");
            }
            for crush_m in [0.01, 0.05, 0.078] {
                let ratio = foam.unloading_n(crush_m, crush_m) / foam.force_n(crush_m);
                assert!((ratio - 1.0).abs() < 1e-10, "{ratio}");
                let h = 1e-9;
                let before = foam.unloading_n(crush_m, crush_m - h);
                let slope = (foam.force_n(crush_m) - before) / h;
                // never softer than the law, or the foam would crush on while it is unloaded
                assert!(slope >= foam.slope_n_m(crush_m) * (1.0 - 1e-4), "{crush_m}");
            }
        }
    }

    #[test]
    fn what_is_needed_takes_the_energy_on_the_plateau() {
        let energy_j = 3000.0;
        for foam in shapes() {
            let thick = Absorber {
                thickness_m: foam.thickness_needed_m(energy_j).unwrap(),
                ..foam
            };
            let taken = 2.0e6 * thick.taken_m3(thick.plateau_crush_m());
            assert!((taken - energy_j).abs() < 1e-4);
            let needed_pa = foam.plateau_needed_pa(energy_j);
            assert!((needed_pa * foam.taken_m3(foam.plateau_crush_m()) - energy_j).abs() < 1e-9);
        }
        // column: 3000 / (2e6 · 0.03 · (0.4 − 0.002/2)) = 0.125313 m
        let column = Absorber {
            shape: Shape::Column { area_m2: 0.03 },
            ..sphere()
        };
        assert!((column.thickness_needed_m(energy_j).unwrap() - 0.125_313_28).abs() < 1e-8);
    }
}
