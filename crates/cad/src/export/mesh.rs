//! Triangles of a profile revolved about the axis: vertices with normals, watertight, outside out.
//!
//! ```text
//! position = (x, r cos φ, r sin φ)
//! step = 4 asin √(e / 2R)        the angle at which the chord of a circle of radius R is e away from it
//! ```
//!
//! with x along the axis from the virtual apex, aft positive, r from the axis and e the chord error in m, φ about the
//! axis from y towards z in rad. Adjacent triangles share bitwise equal positions, so that welding needs no tolerance;
//! along an edge between two segments there is one vertex with the normal of each.

mod cut;
mod revolve;
mod stations;

pub use stations::{Station, stations};

use crate::export::chain::{Chain, Ends, chains};
use msape::vehicle::ComponentKind;
use msape::vehicle::Vehicle;
use msape::vehicle::profile::Profile;
use nalgebra::Vector3;
use numerics::math::PI;

/// Triangles in the vehicle frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Positions (x, y, z), m.
    pub positions_m: Vec<[f32; 3]>,
    /// Unit normals, outward.
    pub normals: Vec<[f32; 3]>,
    /// Position of each vertex in the half-section: (x, r), m.
    pub section_m: Vec<[f32; 2]>,
    /// Three vertex indices each, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

/// Treatment of the cut faces of a partly revolved body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cut {
    /// Closed by flat faces.
    Closed,
    /// Left open: the inside is visible.
    Open,
}

/// Resolution and extent of the revolution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshOptions {
    /// Largest distance between a circle and its chord, m.
    pub chord_error_m: f64,
    /// Longest piece of a line, m; infinite leaves lines undivided.
    pub longest_piece_m: f64,
    /// Start angle of the revolution, from y towards z, rad.
    pub start_rad: f64,
    /// Angle of the revolution, rad; 2π or more gives the whole body.
    pub sweep_rad: f64,
    /// Treatment of the cut faces, where there is a cut.
    pub cut: Cut,
}

impl MeshOptions {
    /// The whole body with a chord error in m.
    pub fn whole(chord_error_m: f64) -> Self {
        Self {
            chord_error_m,
            longest_piece_m: f64::INFINITY,
            start_rad: 0.0,
            sweep_rad: 2.0 * PI,
            cut: Cut::Closed,
        }
    }
}

/// The triangles of one component.
#[derive(Clone, Debug, PartialEq)]
pub struct ComponentMesh {
    /// Component.
    pub kind: ComponentKind,
    /// Triangles of the component.
    pub mesh: Mesh,
}

/// Triangles of each component that has a body, in the order of the vehicle.
pub fn components(vehicle: &Vehicle, options: &MeshOptions) -> Vec<ComponentMesh> {
    let with_body = vehicle.components.iter().filter(|c| !c.profiles.is_empty());
    with_body
        .map(|c| ComponentMesh {
            kind: c.kind,
            mesh: mesh(&c.profiles, options),
        })
        .collect()
}

/// Triangles of revolved profiles. An open profile gives a surface whose outside is on the left of its direction.
pub fn mesh(profiles: &[Profile], options: &MeshOptions) -> Mesh {
    let mut mesh = Mesh::default();
    for profile in profiles {
        let chains = chains(profile);
        let turn = revolve::Turn::new(&chains, options);
        let runs: Vec<_> = chains
            .iter()
            .map(|chain| revolve::run(chain, options))
            .collect();
        for run in &runs {
            revolve::surface(&mut mesh, run, &turn);
        }
        let closed = chains.iter().all(|chain: &Chain| chain.ends != Ends::Open);
        if closed && !turn.is_whole() && options.cut == Cut::Closed {
            cut::faces(&mut mesh, &runs, &turn);
        }
    }
    mesh
}

impl Mesh {
    /// Appends another mesh.
    pub fn append(&mut self, other: &Mesh) {
        let offset = self.positions_m.len() as u32;
        self.positions_m.extend_from_slice(&other.positions_m);
        self.normals.extend_from_slice(&other.normals);
        self.section_m.extend_from_slice(&other.section_m);
        self.triangles
            .extend(other.triangles.iter().map(|t| t.map(|i| i + offset)));
    }

    /// Enclosed volume, m³.
    pub fn volume_m3(&self) -> f64 {
        let sum: f64 = self.corners_m().map(|[a, b, c]| a.dot(&b.cross(&c))).sum();
        sum / 6.0
    }

    /// Total area of the triangles, m².
    pub fn area_m2(&self) -> f64 {
        let twice: f64 = self
            .corners_m()
            .map(|[a, b, c]| (b - a).cross(&(c - a)).norm_squared().sqrt())
            .sum();
        twice / 2.0
    }

    /// Corners of each triangle, m.
    pub fn corners_m(&self) -> impl Iterator<Item = [Vector3<f64>; 3]> + '_ {
        let at = |i: u32| {
            self.positions_m
                .get(i as usize)
                .copied()
                .unwrap_or_default()
        };
        let at = move |i: u32| Vector3::from(at(i)).map(f64::from);
        self.triangles.iter().map(move |t| t.map(at))
    }
}

#[cfg(test)]
mod tests;
