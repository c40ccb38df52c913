//! Shear-deformable shell of revolution: strains of a harmonic n, and element matrices of three nodes.
//!
//! ```text
//! U = (U_x cos nθ, U_r cos nθ, V sin nθ) + ζ (β cos nθ t + φ sin nθ e_θ)
//! t = (c, s) = (dx/ds, dr/ds),  n = (−s, c),  u = c U_x + s U_r,  w = −s U_x + c U_r
//! ε_s  = c U_x' + s U_r'                 ε_θ  = (n V + U_r) / r
//! γ_sθ = V' − (s V + n u) / r            κ_s  = β'
//! κ_θ  = (n φ + s β) / r                 κ_sθ = φ' − (s φ + n β) / r + (k₂ − k₁) [V' + (s V + n u) / r] / 2
//! γ_sζ = β − s U_x' + c U_r'             γ_θζ = φ − (n w + c V) / r
//! ```
//!
//! with displacements U in m, rotations β, φ in rad, ζ the distance from the middle surface along n in m, ′ = d/ds,
//! k₁ = −dα/ds and k₂ = c/r the curvatures in 1/m, α the direction of t.
//!
//! Three nodes with quadratic shape functions for everything, geometry included; stiffness at two Gauss points, which
//! leaves no locking however thin the wall, mass and loads at three.
//!
//! # Valid
//! Small displacements; walls much thinner than their radii of curvature (ζ/R is left out); n ≥ 0.
//!
//! # References
//! - \[sanders-1959\] strains that vanish in every rigid motion, here with the rotations independent;
//!   \[zienkiewicz-1977\] shear-deformable shells of revolution with reduced integration.

use super::section::{Resultants, Stiffness};
use crate::vehicle::segment::Point;

/// Displacements and rotations of a node: U_x, U_r, V, β, φ.
pub const NODE_FREEDOMS: usize = 5;
/// Freedoms of an element.
pub const FREEDOMS: usize = 3 * NODE_FREEDOMS;
/// ±1/√3.
pub const GAUSS_2: f64 = 0.577_350_269_189_625_8;
/// Points and weights of the three-point rule.
pub const GAUSS_3: [(f64, f64); 3] = [
    (-0.774_596_669_241_483_4, 5.0 / 9.0),
    (0.0, 8.0 / 9.0),
    (0.774_596_669_241_483_4, 5.0 / 9.0),
];

/// A place on an element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Station {
    /// Position.
    pub point: Point,
    /// dx/ds and dr/ds.
    pub direction: [f64; 2],
    /// Length for a unit of the element's coordinate, m.
    pub scale_m: f64,
    /// Curvature along the meridian, 1/m.
    pub meridional_curvature_per_m: f64,
    /// Curvature round the axis, 1/m.
    pub hoop_curvature_per_m: f64,
    /// Shape functions.
    pub shape: [f64; 3],
    /// Derivatives of the shape functions along the meridian, 1/m.
    pub slope_per_m: [f64; 3],
}

/// The place at `xi`, −1 to 1, on the element through three nodes, its ends and its middle: first, middle, last.
#[inline]
pub fn station(nodes: &[Point; 3], xi: f64) -> Station {
    let shape = [
        0.5 * xi * (xi - 1.0),
        (1.0 - xi) * (1.0 + xi),
        0.5 * xi * (xi + 1.0),
    ];
    let slope = [xi - 0.5, -2.0 * xi, xi + 0.5];
    let bend = [1.0, -2.0, 1.0];
    let sum = |weights: &[f64; 3]| {
        let [a, b, c] = nodes;
        let [p, q, r] = weights;
        (
            p * a.x_m + q * b.x_m + r * c.x_m,
            p * a.r_m + q * b.r_m + r * c.r_m,
        )
    };
    let ((x, r), (dx, dr), (ddx, ddr)) = (sum(&shape), sum(&slope), sum(&bend));
    let scale_m = (dx * dx + dr * dr).sqrt();
    let direction = [dx / scale_m, dr / scale_m];
    Station {
        point: Point { x_m: x, r_m: r },
        direction,
        scale_m,
        // −dα/ds
        meridional_curvature_per_m: (dr * ddx - dx * ddr) / (scale_m * scale_m * scale_m),
        hoop_curvature_per_m: direction[0] / r,
        shape,
        slope_per_m: slope.map(|d| d / scale_m),
    }
}

/// Rows of the strains ε_s, ε_θ, γ_sθ, κ_s, κ_θ, κ_sθ, γ_sζ, γ_θζ over the five freedoms of each node.
pub type Strains = [[f64; FREEDOMS]; 8];

/// The strains of unit freedoms in the harmonic `harmonic`.
pub fn strains(station: &Station, harmonic: u32) -> Strains {
    let n = f64::from(harmonic);
    let [c, s] = station.direction;
    let r = station.point.r_m;
    let half_twist = 0.5 * (station.hoop_curvature_per_m - station.meridional_curvature_per_m);
    let mut rows = [[0.0; FREEDOMS]; 8];
    for node in 0..3 {
        let (shape, d) = (station.shape[node], station.slope_per_m[node]);
        let (over, wave) = (shape / r, n * shape / r);
        //                     U_x            U_r            V                       β            φ
        let of_node: [[f64; NODE_FREEDOMS]; 8] = [
            [c * d, s * d, 0.0, 0.0, 0.0],
            [0.0, over, wave, 0.0, 0.0],
            [-c * wave, -s * wave, d - s * over, 0.0, 0.0],
            [0.0, 0.0, 0.0, d, 0.0],
            [0.0, 0.0, 0.0, s * over, wave],
            [
                half_twist * c * wave,
                half_twist * s * wave,
                half_twist * (d + s * over),
                -wave,
                d - s * over,
            ],
            [-s * d, c * d, 0.0, shape, 0.0],
            [s * wave, -c * wave, -c * over, 0.0, shape],
        ];
        for (row, part) in rows.iter_mut().zip(of_node) {
            let at = node * NODE_FREEDOMS;
            row[at..at + NODE_FREEDOMS].copy_from_slice(&part);
        }
    }
    rows
}

/// A matrix over the freedoms of an element; only the upper triangle is filled.
pub type Matrix = [[f64; FREEDOMS]; FREEDOMS];

/// Stiffness of an element in a harmonic, per radian (the integral over cos² or sin² is left out), N/m.
pub fn stiffness(nodes: &[Point; 3], wall: &Stiffness, harmonic: u32) -> Matrix {
    let mut k = [[0.0; FREEDOMS]; FREEDOMS];
    for xi in [-GAUSS_2, GAUSS_2] {
        let at = station(nodes, xi);
        let b = strains(&at, harmonic);
        let db = forces_of(wall, &b);
        let weight = at.scale_m * at.point.r_m;
        for (strain, force) in b.iter().zip(&db) {
            for (i, row) in k.iter_mut().enumerate() {
                let left = weight * strain[i];
                if left != 0.0 {
                    for (entry, right) in row[i..].iter_mut().zip(&force[i..]) {
                        *entry += left * right;
                    }
                }
            }
        }
    }
    k
}

/// D B: the rows of the forces N_s, N_θ, N_sθ, M_s, M_θ, M_sθ, Q_s, Q_θ.
fn forces_of(wall: &Stiffness, b: &Strains) -> Strains {
    let Stiffness {
        membrane_n_m: a,
        bending_nm: d,
        shear_n_m: s,
        poisson_ratio: nu,
    } = *wall;
    let half = 0.5 * (1.0 - nu);
    let mut rows = [[0.0; FREEDOMS]; 8];
    for j in 0..FREEDOMS {
        rows[0][j] = a * (b[0][j] + nu * b[1][j]);
        rows[1][j] = a * (b[1][j] + nu * b[0][j]);
        rows[2][j] = a * half * b[2][j];
        rows[3][j] = d * (b[3][j] + nu * b[4][j]);
        rows[4][j] = d * (b[4][j] + nu * b[3][j]);
        rows[5][j] = d * half * b[5][j];
        rows[6][j] = s * b[6][j];
        rows[7][j] = s * b[7][j];
    }
    rows
}

/// Forces in the wall at a place, amplitudes of the harmonic, from the freedoms of the element.
pub fn resultants(
    at: &Station,
    wall: &Stiffness,
    harmonic: u32,
    freedoms: &[f64; FREEDOMS],
) -> Resultants {
    let strain = strains(at, harmonic).map(|row| numerics::linear::dot(&row, freedoms));
    let Stiffness {
        membrane_n_m: a,
        bending_nm: d,
        shear_n_m: s,
        poisson_ratio: nu,
    } = *wall;
    let half = 0.5 * (1.0 - nu);
    let [e_s, e_t, g, k_s, k_t, k_st, g_s, g_t] = strain;
    Resultants {
        membrane_n_m: [a * (e_s + nu * e_t), a * (e_t + nu * e_s), a * half * g],
        bending_n: [d * (k_s + nu * k_t), d * (k_t + nu * k_s), d * half * k_st],
        shear_n_m: [s * g_s, s * g_t],
    }
}

/// Mass of a wall for an area: translation, and rotation of its normal.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ArealMass {
    /// Mass, kg/m².
    pub mass_kg_m2: f64,
    /// Second moment of the mass through the thickness, kg.
    pub rotary_kg: f64,
}

/// Entries of the mass matrix between two nodes: for U_x, U_r, V the first, for β, φ the second, kg.
pub type NodeMasses = [[[f64; 2]; 3]; 3];

/// Mass matrix of an element, per radian.
pub fn mass(nodes: &[Point; 3], areal: &ArealMass) -> NodeMasses {
    let mut m = [[[0.0; 2]; 3]; 3];
    for (xi, w) in GAUSS_3 {
        let at = station(nodes, xi);
        let weight = w * at.scale_m * at.point.r_m;
        for (i, row) in m.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                let both = weight * at.shape[i] * at.shape[j];
                entry[0] += areal.mass_kg_m2 * both;
                entry[1] += areal.rotary_kg * both;
            }
        }
    }
    m
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A curved element off the axis: three points of a circle of radius 1 about (0, 1).
    fn arc() -> [Point; 3] {
        [2.6_f64, 2.5, 2.4].map(|angle| Point {
            x_m: numerics::math::cos(angle),
            r_m: 1.0 + numerics::math::sin(angle),
        })
    }

    fn strain_of(field: impl Fn(&Point, [f64; 2]) -> [f64; 5], harmonic: u32) -> f64 {
        let nodes = arc();
        let mut freedoms = [0.0; FREEDOMS];
        for (i, xi) in [-1.0, 0.0, 1.0].into_iter().enumerate() {
            let at = station(&nodes, xi);
            freedoms[5 * i..5 * i + 5].copy_from_slice(&field(&at.point, at.direction));
        }
        let at = station(&nodes, GAUSS_2);
        strains(&at, harmonic)
            .iter()
            .map(|row| numerics::linear::dot(row, &freedoms).abs())
            .fold(0.0, f64::max)
    }

    #[test]
    fn rigid_motions_make_no_strain() {
        // along x; across: U_r = cos θ, V = −sin θ
        assert!(strain_of(|_, _| [1.0, 0.0, 0.0, 0.0, 0.0], 0) < 1e-13);
        assert!(strain_of(|_, _| [0.0, 1.0, -1.0, 0.0, 0.0], 1) < 1e-13);
        // pitch about z: U_x = −r cos θ, U_r = x cos θ, V = −x sin θ; the normal (−s, c) rotates by β = −1 round e_θ at
        // θ = 0, at θ = 90° by the component of the rotation about the meridian, φ = s
        let pitch = |p: &Point, [_, s]: [f64; 2]| [-p.r_m, p.x_m, -p.x_m, -1.0, s];
        // s is not quadratic along a curved element: its error, of order h², is left
        assert!(strain_of(pitch, 1) < 2e-3, "{}", strain_of(pitch, 1));
    }

    #[test]
    fn circle_of_radius_1_has_that_curvature() {
        let at = station(&arc(), 0.0);
        assert!((at.meridional_curvature_per_m - 1.0).abs() < 6e-3);
        assert!((at.hoop_curvature_per_m - at.direction[0] / at.point.r_m).abs() < 1e-15);
    }

    #[test]
    fn mass_of_a_cylinder_of_length_2_and_radius_3_is_six_per_radian() {
        let nodes = [0.0, 1.0, 2.0].map(|x_m| Point { x_m, r_m: 3.0 });
        let areal = ArealMass {
            mass_kg_m2: 1.0,
            rotary_kg: 0.5,
        };
        let m = mass(&nodes, &areal);
        let sum = |k: usize| m.iter().flatten().map(|entry| entry[k]).sum::<f64>();
        assert!((sum(0) - 6.0).abs() < 1e-14 && (sum(1) - 3.0).abs() < 1e-14);
    }

    #[test]
    fn stretched_cylinder_stores_the_energy_of_a_bar() {
        let nodes = [0.0, 1.0, 2.0].map(|x_m| Point { x_m, r_m: 3.0 });
        let wall = Stiffness {
            membrane_n_m: 10.0,
            bending_nm: 1.0,
            shear_n_m: 4.0,
            poisson_ratio: 0.0,
        };
        let k = stiffness(&nodes, &wall, 0);
        let stretch = [0.0, 0.1, 0.2];
        let mut twice_energy = 0.0;
        for i in 0..3 {
            for j in 0..3 {
                let entry = k[5 * i.min(j)][5 * i.max(j)];
                twice_energy += entry * stretch[i] * stretch[j];
            }
        }
        // A ε² r L = 10 · 0.01 · 3 · 2
        assert!((twice_energy - 0.6).abs() < 1e-14);
    }
}
