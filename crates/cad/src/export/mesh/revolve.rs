//! Surface of revolution: stations along a chain, repeated about the axis.

use super::stations::{Station, chords, stations};
use super::{Mesh, MeshOptions};
use crate::export::chain::Chain;
use msape::vehicle::segment::{Point, Segment};
use numerics::math::{PI, sin_cos};

/// Stations of each segment of a chain; a joint is the last station of one segment and the first of the next.
pub type Run = Vec<Vec<Station>>;

/// Sines and cosines of the azimuths.
pub struct Turn {
    /// (sine, cosine) of each column of vertices.
    pub columns: Vec<(f64, f64)>,
    whole: bool,
}

impl Turn {
    /// As many columns as the largest circle of the chains needs.
    pub fn new(chains: &[Chain], options: &MeshOptions) -> Self {
        let widest = |s: &Segment| match *s {
            Segment::Line { start, end } => start.r_m.max(end.r_m),
            Segment::Arc {
                center, radius_m, ..
            } => center.r_m + radius_m,
        };
        let segments = chains.iter().flat_map(|c| &c.segments);
        let radius_m = segments.map(widest).fold(0.0, f64::max);
        let whole = options.sweep_rad >= 2.0 * PI;
        let sweep = options.sweep_rad.clamp(0.0, 2.0 * PI);
        let count = chords(sweep, radius_m, options.chord_error_m);
        let last = if whole { count } else { count + 1 };
        let angle = |j: usize| options.start_rad + sweep * j as f64 / count as f64;
        Self {
            columns: (0..last).map(|j| sin_cos(angle(j))).collect(),
            whole,
        }
    }

    /// Whether the revolution is a full turn.
    pub fn is_whole(&self) -> bool {
        self.whole
    }
}

/// Stations of a chain.
pub fn run(chain: &Chain, options: &MeshOptions) -> Run {
    let segments = chain.segments.iter();
    segments
        .map(|s| stations(s, options.chord_error_m, options.longest_piece_m))
        .collect()
}

/// Position of a point of the half-section at a column, m; negative zero becomes positive zero.
pub fn position_m(at: Point, (sine, cosine): (f64, f64)) -> [f32; 3] {
    [at.x_m, at.r_m * cosine, at.r_m * sine].map(|v| v as f32 + 0.0)
}

/// Adds the surface of the stations.
pub fn surface(mesh: &mut Mesh, run: &Run, turn: &Turn) {
    let columns = turn.columns.len() as u32;
    let turns = if turn.whole { columns } else { columns - 1 };
    for stations in run {
        let first = mesh.positions_m.len() as u32;
        for station in stations {
            let (nx, nr) = station.normal;
            for &column in &turn.columns {
                let (sine, cosine) = column;
                mesh.positions_m.push(position_m(station.at, column));
                mesh.normals
                    .push([nx, nr * cosine, nr * sine].map(|v| v as f32));
                mesh.section_m
                    .push([station.at.x_m as f32, station.at.r_m as f32]);
            }
        }
        for (i, (from, to)) in stations.iter().zip(stations.iter().skip(1)).enumerate() {
            let row = first + i as u32 * columns;
            for j in 0..turns {
                let next = (j + 1) % columns;
                let [a, b, c, d] = [row + j, row + next, row + columns + next, row + columns + j];
                // a station on the axis is a single point: one of the two triangles has no area
                if from.at.r_m > 0.0 {
                    mesh.triangles.push([a, b, c]);
                }
                if to.at.r_m > 0.0 {
                    mesh.triangles.push([a, c, d]);
                }
            }
        }
    }
}
