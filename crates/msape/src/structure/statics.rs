//! Displacement and forces in a shell of revolution under loads spread over it.
//!
//! ```text
//! K a = f        f = Σ ∫ Nᵀ p r ds        forces in the wall = D B a
//! ```
//!
//! with a in m and rad, p in Pa (amplitudes: p_x and p_r with cos nθ, p_v with sin nθ), f in N per radian.
//! Forces are taken at the two Gauss points, where they are best, and carried on to the ends of the element in a line.
//!
//! # Valid
//! Linear elasticity; supports that leave no rigid motion.
//!
//! # References
//! - \[barlow-1976\] best points for stress; \[zienkiewicz-1977\].

use super::element::{FREEDOMS, GAUSS_2, GAUSS_3, NODE_FREEDOMS, Station, resultants, station};
use super::mesh::Element;
use super::model::{Freedoms, Model};
use super::section::Resultants;
use crate::vehicle::segment::Point;
use numerics::linear::skyline::Factor;

/// Displacements of a harmonic.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// Which unknown is what.
    pub freedoms: Freedoms,
    /// The unknowns, m and rad.
    pub unknowns: Vec<f64>,
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

/// Where an element is sampled: its ends and its two Gauss points.
pub const SAMPLES: [f64; 4] = [-1.0, -GAUSS_2, GAUSS_2, 1.0];

/// Nodal forces of a load per area: p_x, p_r, p_v, Pa, by element and place on it.
pub fn load(
    model: &Model,
    freedoms: &Freedoms,
    pressure: impl Fn(&Element, &Station) -> [f64; 3],
) -> Vec<f64> {
    let mut f = vec![0.0; freedoms.count()];
    for (number, element) in model.mesh.elements.iter().enumerate() {
        let points = model.mesh.points(element);
        let slots = freedoms.of_element(number);
        for (xi, w) in GAUSS_3 {
            let at = station(&points, xi);
            let p = pressure(element, &at);
            let weight = w * at.scale_m * at.point.r_m;
            for (node, shape) in at.shape.iter().enumerate() {
                for (k, p) in p.iter().enumerate() {
                    if let Some((unknown, sign)) = slots[node * NODE_FREEDOMS + k] {
                        f[unknown] += sign * weight * shape * p;
                    }
                }
            }
        }
    }
    f
}

/// Displacements for a factored stiffness and nodal forces.
pub fn solve(freedoms: &Freedoms, stiffness: &Factor, mut forces: Vec<f64>) -> Solution {
    stiffness.solve(&mut forces);
    Solution {
        freedoms: freedoms.clone(),
        unknowns: forces,
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
            let best = [-GAUSS_2, GAUSS_2].map(|xi| {
                resultants(&station(&points, xi), wall, self.freedoms.harmonic, &a)
            });
            for xi in SAMPLES {
                let at = station(&points, xi);
                let displacement_m = core::array::from_fn(|k| {
                    let node = |i: usize| at.shape[i] * a[i * NODE_FREEDOMS + k];
                    node(0) + node(1) + node(2)
                });
                list.push(Sample {
                    element: number,
                    point: at.point,
                    forces: between(&best, 0.5 * (xi / GAUSS_2 + 1.0)),
                    displacement_m,
                });
            }
        }
        list
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
