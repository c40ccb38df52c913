//! A shell of revolution with walls and supports: degrees of freedom of a harmonic, stiffness and mass.
//!
//! ```text
//! K = Σ ∫ Bᵀ D B r ds        M = Σ ∫ Nᵀ m N r ds        K_ij(n) = K_ij(0) + nᵖ [K_ij(1) − K_ij(0)]
//! axis: n = 0: U_r = β = 0;  n = 1: U_x = 0, V = −U_r, φ = −β;  n ≥ 2: all zero
//! ```
//!
//! with K in N/m and M in kg, per radian; p = 1 between a freedom that goes with cos nθ and one that goes with sin nθ, else 2.
//!
//! # Valid
//! Any branched shell of revolution; in the harmonic 0 without torsion.
//!
//! # References
//! - \[zienkiewicz-1977\]; conditions on the axis: displacements and rotations have one value there.

use super::element::{ArealMass, FREEDOMS, Matrix, NODE_FREEDOMS, mass, stiffness};
use super::mesh::{Element, Mesh};
use super::section::Section;
use numerics::linear::skyline::Skyline;
use numerics::linear::sparse::Sparse;

/// A wall and the mass that moves with it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wall {
    /// Build and material.
    pub section: Section,
    /// Mass of the wall and of the layers on it.
    pub areal: ArealMass,
}

/// Support of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Held {
    /// Held along the axis.
    Axially,
    /// Held across the axis; free to move along it and to rotate.
    ByDiaphragm,
    /// All displacements held; free to rotate about the circle.
    ByHinge,
    /// Displacements and rotations held.
    Clamped,
    /// Symmetry about a plane normal to the axis.
    BySymmetry,
}

impl Held {
    /// Whether each of U_x, U_r, V, β, φ is zero.
    fn freedoms(self) -> [bool; NODE_FREEDOMS] {
        match self {
            Self::Axially => [true, false, false, false, false],
            Self::ByDiaphragm => [false, true, true, false, true],
            Self::ByHinge => [true, true, true, false, true],
            Self::Clamped => [true; NODE_FREEDOMS],
            Self::BySymmetry => [true, false, false, true, false],
        }
    }
}

/// A node and how it is held.
pub type Support = (usize, Held);

/// A shell of revolution.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Model {
    /// Nodes and elements.
    pub mesh: Mesh,
    /// Walls.
    pub walls: Vec<Wall>,
}

/// Index of an unknown, and the sign with which it gives a degree of freedom; `None` where that is zero.
type Slot = Option<(usize, f64)>;

/// The unknowns of a harmonic.
#[derive(Clone, Debug, PartialEq)]
pub struct Freedoms {
    /// Harmonic.
    pub harmonic: u32,
    /// Unknowns of each element.
    slots: Vec<[Slot; FREEDOMS]>,
    /// First row of each column of the matrices.
    first: Vec<usize>,
}

impl Freedoms {
    /// Numbers the unknowns in the order of the elements.
    pub fn new(model: &Model, harmonic: u32, supports: &[Support]) -> Self {
        let mesh = &model.mesh;
        let mut of_node: Vec<Option<[Slot; 4]>> = vec![None; mesh.nodes.len()];
        let mut of_twist: Vec<Option<Slot>> = vec![None; mesh.twists.len()];
        let mut count = 0;
        let mut new = |held: bool| {
            (!held).then(|| {
                count += 1;
                (count - 1, 1.0)
            })
        };
        let minus = |slot: Slot| slot.map(|(unknown, sign)| (unknown, -sign));
        let mut slots = Vec::with_capacity(mesh.elements.len());
        for element in &mesh.elements {
            let mut all = [None; FREEDOMS];
            for (place, (&node, &twist)) in element.nodes.iter().zip(&element.twists).enumerate() {
                let held = held(supports, node, harmonic);
                let on_axis = mesh.point(node).r_m <= 0.0;
                let [u_x, u_r, v, beta] = match of_node.get(node).copied().flatten() {
                    Some(known) => known,
                    None if !on_axis => core::array::from_fn(|k| new(held[k])),
                    None => match harmonic {
                        0 => [new(held[0]), None, None, None],
                        1 => {
                            let (u_r, beta) = (new(held[1]), new(held[3]));
                            [None, u_r, minus(u_r), beta]
                        }
                        _ => [None; 4],
                    },
                };
                let phi = match of_twist.get(twist).copied().flatten() {
                    Some(known) => known,
                    None if on_axis && harmonic == 1 => minus(beta),
                    None => new(held[4] || on_axis),
                };
                if let Some(entry) = of_node.get_mut(node) {
                    *entry = Some([u_x, u_r, v, beta]);
                }
                if let Some(entry) = of_twist.get_mut(twist) {
                    *entry = Some(phi);
                }
                for (k, slot) in [u_x, u_r, v, beta, phi].into_iter().enumerate() {
                    all[place * NODE_FREEDOMS + k] = slot;
                }
            }
            slots.push(all);
        }
        let mut first: Vec<usize> = (0..count).collect();
        for all in &slots {
            let used = || all.iter().flatten().map(|&(unknown, _)| unknown);
            let least = used().min().unwrap_or(0);
            for unknown in used() {
                first[unknown] = first[unknown].min(least);
            }
        }
        Self {
            harmonic,
            slots,
            first,
        }
    }

    /// Number of unknowns.
    pub fn count(&self) -> usize {
        self.first.len()
    }

    /// Unknowns of an element.
    pub fn of_element(&self, number: usize) -> &[Slot; FREEDOMS] {
        const NONE: &[Slot; FREEDOMS] = &[None; FREEDOMS];
        self.slots.get(number).unwrap_or(NONE)
    }

    /// Degrees of freedom of an element from the unknowns.
    pub fn gather(&self, number: usize, unknowns: &[f64]) -> [f64; FREEDOMS] {
        self.of_element(number).map(|slot| {
            slot.and_then(|(unknown, sign)| unknowns.get(unknown).map(|value| sign * value))
                .unwrap_or(0.0)
        })
    }

    /// Zero matrix over the unknowns.
    pub fn matrix(&self) -> Skyline {
        Skyline::new(&self.first)
    }
}

/// Whether each degree of freedom of a node is zero; in the harmonic 0 those of torsion are.
fn held(supports: &[Support], node: usize, harmonic: u32) -> [bool; NODE_FREEDOMS] {
    let torsion = harmonic == 0;
    let mut all = [false, false, torsion, false, torsion];
    for (_, held) in supports.iter().filter(|(at, _)| *at == node) {
        for (sum, one) in all.iter_mut().zip(held.freedoms()) {
            *sum |= one;
        }
    }
    all
}

impl Model {
    /// Wall of an element.
    pub fn wall(&self, element: &Element) -> Option<&Wall> {
        self.walls.get(element.wall)
    }

    /// Stiffness of every harmonic.
    pub fn stiffness(&self) -> Stiffness {
        let walls: Vec<_> = self.walls.iter().map(|w| w.section.stiffness()).collect();
        let of = |element: &Element| {
            let (points, wall) = (self.mesh.points(element), walls.get(element.wall)?);
            let [still, mut once] = [0, 1].map(|harmonic| stiffness(&points, wall, harmonic));
            for (once, still) in once.iter_mut().flatten().zip(still.iter().flatten()) {
                *once -= still;
            }
            Some([still, once])
        };
        Stiffness {
            elements: self.mesh.elements.iter().map(of).collect(),
        }
    }

    /// Mass over the unknowns.
    pub fn mass(&self, freedoms: &Freedoms) -> Sparse {
        let mut matrix = Sparse::new(freedoms.count());
        for (number, element) in self.mesh.elements.iter().enumerate() {
            let Some(wall) = self.wall(element) else {
                continue;
            };
            let m = mass(&self.mesh.points(element), &wall.areal);
            let slots = freedoms.of_element(number);
            for (a, row) in m.iter().enumerate() {
                for (b, [moving, turning]) in row.iter().enumerate().skip(a) {
                    for k in 0..NODE_FREEDOMS {
                        let (at, to) = (a * NODE_FREEDOMS + k, b * NODE_FREEDOMS + k);
                        if let (Some((gi, si)), Some((gj, sj))) = (slots[at], slots[to]) {
                            let value = if k < 3 { moving } else { turning };
                            matrix.add(gi, gj, si * sj * value);
                        }
                    }
                }
            }
        }
        matrix
    }
}

/// Stiffness of a model in every harmonic, by element.
#[derive(Clone, Debug, PartialEq)]
pub struct Stiffness {
    /// Stiffness of the harmonic 0, and the difference of that of the harmonic 1; absent where an element has no wall.
    elements: Vec<Option<[Matrix; 2]>>,
}

impl Stiffness {
    /// Stiffness over the unknowns of a harmonic.
    pub fn over(&self, freedoms: &Freedoms) -> Skyline {
        let mut matrix = freedoms.matrix();
        let n = f64::from(freedoms.harmonic);
        // V and φ go with sin nθ
        let sine = |i: usize| matches!(i % NODE_FREEDOMS, 2 | 4);
        for (element, slots) in self.elements.iter().zip(&freedoms.slots) {
            let Some([still, more]) = element else {
                continue;
            };
            for i in 0..FREEDOMS {
                let Some((gi, si)) = slots[i] else { continue };
                for j in i..FREEDOMS {
                    let Some((gj, sj)) = slots[j] else { continue };
                    let power = if sine(i) == sine(j) { n * n } else { n };
                    // two freedoms that are one unknown: the entry and its mirror
                    let times = if i != j && gi == gj { 2.0 } else { 1.0 };
                    matrix.add(gi, gj, times * si * sj * (still[i][j] + power * more[i][j]));
                }
            }
        }
        matrix
    }
}
