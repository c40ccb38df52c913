//! Displacement and forces in a shell of revolution under loads spread over it.
//!
//! ```text
//! K a = f        f = Σ ∫ Nᵀ p r ds        forces in the wall = D B a
//! ends of an element: (K a − f)/r = ±(N_s t + Q_s n, N_sθ + (k₂ − k₁) M_sθ / 2, M_s, M_sθ)
//! N_θ = ν N_s + A (1 − ν²) ε_θ        M_θ = ν M_s + D (1 − ν²) κ_θ
//! ```
//!
//! with a in m and rad, p in Pa (amplitudes: p_x and p_r with cos nθ, p_v with sin nθ), f in N per radian; A and D as in
//! [`super::section`]. Within an element forces are taken at the two Gauss points, where they are most accurate; at its ends from
//! the balance of the element, which is as accurate as the displacements; on the axis extrapolated from the Gauss points.
//!
//! # Valid
//! Linear elasticity; supports that leave no rigid motion.
//!
//! # References
//! - \[barlow-1976\] best points for stress; \[zienkiewicz-1977\].

use super::element::{
    FREEDOMS, GAUSS_2, GAUSS_3, NODE_FREEDOMS, Station, resultants, station, strains,
};
use super::mesh::Element;
use super::model::{Freedoms, Model};
use super::section::{Resultants, Stiffness};
use crate::vehicle::segment::Point;
use numerics::linear::skyline::Factor;

/// Displacements of a harmonic.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// Assignment of the unknowns to the degrees of freedom.
    pub freedoms: Freedoms,
    /// The unknowns, m and rad.
    pub unknowns: Vec<f64>,
    /// Loads.
    pub loads: Loads,
}

/// Nodal forces of loads.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Loads {
    /// Forces by unknown, N and N m per radian.
    pub by_unknown: Vec<f64>,
    /// Forces by element and degree of freedom, N per radian.
    pub by_element: Vec<[f64; FREEDOMS]>,
}

/// Forces in the wall, and displacements, at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Number of the element.
    pub element: usize,
    /// Place.
    pub point: Point,
    /// Amplitudes of the forces.
    pub forces: Resultants,
    /// Amplitudes of U_x, U_r, V, m.
    pub displacement_m: [f64; 3],
}

/// Places at which an element is sampled: its ends and its two Gauss points.
pub const SAMPLES: [f64; 4] = [-1.0, -GAUSS_2, GAUSS_2, 1.0];

/// Nodal forces of a load per area: p_x, p_r, p_v, Pa, by element and place on it.
pub fn load(
    model: &Model,
    freedoms: &Freedoms,
    pressure: impl Fn(&Element, &Station) -> [f64; 3],
) -> Loads {
    let mut loads = Loads {
        by_unknown: vec![0.0; freedoms.count()],
        by_element: Vec::with_capacity(model.mesh.elements.len()),
    };
    for (number, element) in model.mesh.elements.iter().enumerate() {
        let points = model.mesh.points(element);
        let mut forces = [0.0; FREEDOMS];
        for (xi, w) in GAUSS_3 {
            let at = station(&points, xi);
            let p = pressure(element, &at);
            let weight = w * at.scale_m * at.point.r_m;
            for (node, shape) in at.shape.iter().enumerate() {
                for (k, p) in p.iter().enumerate() {
                    forces[node * NODE_FREEDOMS + k] += weight * shape * p;
                }
            }
        }
        for (slot, force) in freedoms.of_element(number).iter().zip(forces) {
            if let Some((unknown, sign)) = *slot {
                loads.by_unknown[unknown] += sign * force;
            }
        }
        loads.by_element.push(forces);
    }
    loads
}

/// Displacements for a factored stiffness and loads.
pub fn solve(freedoms: &Freedoms, stiffness: &Factor, loads: Loads) -> Solution {
    let mut unknowns = loads.by_unknown.clone();
    stiffness.solve(&mut unknowns);
    Solution {
        freedoms: freedoms.clone(),
        unknowns,
        loads,
    }
}

impl Solution {
    /// Displacements and rotations of the element at one of its nodes: U_x, U_r, V, β, φ.
    pub fn at_node(&self, element: usize, node: usize) -> [f64; NODE_FREEDOMS] {
        let all = self.freedoms.gather(element, &self.unknowns);
        core::array::from_fn(|k| all[(node * NODE_FREEDOMS + k) % FREEDOMS])
    }

    /// Forces and displacements at [`SAMPLES`] of every element, in order.
    pub fn samples(&self, model: &Model) -> Vec<Sample> {
        let mut list = Vec::with_capacity(SAMPLES.len() * model.mesh.elements.len());
        let walls: Vec<_> = model.walls.iter().map(|w| w.section.stiffness()).collect();
        for (number, element) in model.mesh.elements.iter().enumerate() {
            let Some(wall) = walls.get(element.wall) else {
                continue;
            };
            let points = model.mesh.points(element);
            let a = self.freedoms.gather(number, &self.unknowns);
            let stations = [-GAUSS_2, GAUSS_2].map(|xi| station(&points, xi));
            let n = self.freedoms.harmonic;
            let best = stations.map(|at| resultants(&at, wall, n, &a));
            // the forces with which its neighbors hold the element: Σ Bᵀ F − f
            let mut balance = self
                .loads
                .by_element
                .get(number)
                .map_or([0.0; FREEDOMS], |f| f.map(|f| -f));
            for (at, forces) in stations.iter().zip(&best) {
                let weight = at.scale_m * at.point.r_m;
                let rows = forces.rows();
                for (strain, force) in strains(at, n).iter().zip(rows) {
                    numerics::linear::add_scaled(&mut balance, weight * force, strain);
                }
            }
            for xi in SAMPLES {
                let at = station(&points, xi);
                let inside = between(&best, 0.5 * (xi / GAUSS_2 + 1.0));
                let displacement_m = core::array::from_fn(|k| {
                    let node = |i: usize| at.shape[i] * a[i * NODE_FREEDOMS + k];
                    node(0) + node(1) + node(2)
                });
                list.push(Sample {
                    element: number,
                    point: at.point,
                    forces: if xi.abs() < 1.0 || at.point.r_m <= 0.0 {
                        inside
                    } else {
                        End {
                            at: &at,
                            xi,
                            harmonic: n,
                            wall,
                            freedoms: &a,
                            balance: &balance,
                        }
                        .forces(inside)
                    },
                    displacement_m,
                });
            }
        }
        list
    }
}

/// An end of an element.
struct End<'a> {
    at: &'a Station,
    /// −1 or 1.
    xi: f64,
    harmonic: u32,
    wall: &'a Stiffness,
    freedoms: &'a [f64; FREEDOMS],
    balance: &'a [f64; FREEDOMS],
}

impl End<'_> {
    /// Forces in the wall from the balance of the element; Q_θ is kept from `inside`.
    fn forces(&self, inside: Resultants) -> Resultants {
        let from = if self.xi < 0.0 { 0 } else { 2 * NODE_FREEDOMS };
        let [f_x, f_r, f_v, m_s, m_st]: [f64; NODE_FREEDOMS] =
            core::array::from_fn(|k| self.xi * self.balance[from + k] / self.at.point.r_m);
        let [_, u_r, v, beta, phi]: [f64; NODE_FREEDOMS] =
            core::array::from_fn(|k| self.freedoms[from + k]);
        let ([c, s], r, n) = (
            self.at.direction,
            self.at.point.r_m,
            f64::from(self.harmonic),
        );
        let Stiffness {
            membrane_n_m: a,
            bending_nm: d,
            poisson_ratio: nu,
            ..
        } = *self.wall;
        let n_s = c * f_x + s * f_r;
        let half_twist = 0.5 * (self.at.hoop_curvature_per_m - self.at.meridional_curvature_per_m);
        // N_θ = ν N_s + A (1 − ν²) ε_θ,  M_θ = ν M_s + D (1 − ν²) κ_θ
        let n_t = nu * n_s + a * (1.0 - nu * nu) * (n * v + u_r) / r;
        let m_t = nu * m_s + d * (1.0 - nu * nu) * (n * phi + s * beta) / r;
        Resultants {
            membrane_n_m: [n_s, n_t, f_v - half_twist * m_st],
            bending_n: [m_s, m_t, m_st],
            shear_n_m: [c * f_r - s * f_x, inside.shear_n_m[1]],
        }
    }
}

/// The straight line through two forces, at the part `part` of the way.
fn between([a, b]: &[Resultants; 2], part: f64) -> Resultants {
    let mix = |x: f64, y: f64| x + part * (y - x);
    Resultants {
        membrane_n_m: core::array::from_fn(|i| mix(a.membrane_n_m[i], b.membrane_n_m[i])),
        bending_n: core::array::from_fn(|i| mix(a.bending_n[i], b.bending_n[i])),
        shear_n_m: core::array::from_fn(|i| mix(a.shear_n_m[i], b.shear_n_m[i])),
    }
}
