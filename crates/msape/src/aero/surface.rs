//! Outer surface of a body of revolution, as the integrals of pressure and shear see it.
//!
//! ```text
//! x = x(t), r = r(t)     n = (−dr, dx)/ds     sin δ = −u·n = p + q cos φ     p = −n_x cos α     q = −n_r sin α
//! ```
//!
//! with x aft from the virtual apex and r from the axis, both in diameters; φ the azimuth in rad, zero on the side to which the
//! normal force points; n the outward normal; u the direction of the air, (cos α, sin α) along the axis and that side; δ the
//! angle between the air and the surface, rad; α the total angle of attack, rad. t runs over 0…1 along a piece.
//!
//! # Valid
//! Closed outlines of lines and arcs that do not cross themselves.
//!
//! # References
//! - Geometry of a surface of revolution.

use crate::vehicle::profile::Profile;
use crate::vehicle::segment::{Point, Segment};
use numerics::math::{FRAC_PI_2, PI, hypot, sin_cos};

/// Longest arc of a piece, rad.
const LONGEST_ARC_RAD: f64 = 0.25 * PI;

/// A point of the meridian: position in diameters and outward normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Station {
    /// Axial position, diameters.
    pub x: f64,
    /// Distance from the axis, diameters.
    pub r: f64,
    /// Axial component of the normal.
    pub normal_x: f64,
    /// Radial component of the normal.
    pub normal_r: f64,
}

/// A part of the meridian that is monotone in x, run with the body on its right.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Piece {
    /// A straight line.
    Line {
        /// Start (x, r), diameters.
        from: [f64; 2],
        /// End (x, r), diameters.
        to: [f64; 2],
    },
    /// A circular arc.
    Arc {
        /// Center (x, r), diameters.
        center: [f64; 2],
        /// Radius, diameters.
        radius: f64,
        /// Direction from the center to the start, rad.
        start_rad: f64,
        /// Angle run through, rad.
        sweep_rad: f64,
    },
}

impl Piece {
    /// The point at `t` of 0…1.
    pub fn at(&self, t: f64) -> Station {
        match *self {
            Piece::Line { from, to } => {
                let (dx, dr) = (to[0] - from[0], to[1] - from[1]);
                let length = hypot(dx, dr);
                Station {
                    x: from[0] + t * dx,
                    r: from[1] + t * dr,
                    normal_x: -dr / length,
                    normal_r: dx / length,
                }
            }
            Piece::Arc {
                center,
                radius,
                start_rad,
                sweep_rad,
            } => {
                let (s, c) = sin_cos(start_rad + t * sweep_rad);
                let outward = if sweep_rad < 0.0 { 1.0 } else { -1.0 };
                Station {
                    x: center[0] + radius * c,
                    r: (center[1] + radius * s).max(0.0),
                    normal_x: outward * c,
                    normal_r: outward * s,
                }
            }
        }
    }

    /// Whether a piece bulges outward, away from the axis and along the meridian, where a station of it is: then it never shades what
    /// faces the air on it.
    pub fn bulges(&self, station: &Station) -> bool {
        let along = match self {
            Piece::Line { .. } => true,
            Piece::Arc { sweep_rad, .. } => *sweep_rad < 0.0,
        };
        along && station.normal_r >= 0.0
    }

    /// Position at `t` of 0…1, diameters.
    pub fn position(&self, t: f64) -> [f64; 2] {
        match *self {
            Piece::Line { from, to } => [
                from[0] + t * (to[0] - from[0]),
                from[1] + t * (to[1] - from[1]),
            ],
            Piece::Arc { .. } => {
                let Station { x, r, .. } = self.at(t);
                [x, r]
            }
        }
    }

    /// Largest extent in a direction of the meridian, diameters.
    fn reach(&self, [x, r]: [f64; 2]) -> f64 {
        let along = |p: [f64; 2]| x * p[0] + r * p[1];
        let ends = [0.0, 1.0].map(|t| self.position(t));
        let most = along(ends[0]).max(along(ends[1]));
        let Piece::Arc {
            center,
            radius,
            sweep_rad,
            ..
        } = *self
        else {
            return most;
        };
        let [from, to] = ends.map(|p| [p[0] - center[0], p[1] - center[1]]);
        let turn = |a: [f64; 2], b: [f64; 2]| (a[0] * b[1] - a[1] * b[0]) * sweep_rad;
        let ahead = from[0] * x + from[1] * r > 0.0;
        match ahead && turn(from, [x, r]) >= 0.0 && turn([x, r], to) >= 0.0 {
            true => along(center) + radius,
            false => most,
        }
    }

    /// Length, diameters.
    pub fn length(&self) -> f64 {
        match *self {
            Piece::Line { from, to } => hypot(to[0] - from[0], to[1] - from[1]),
            Piece::Arc {
                radius, sweep_rad, ..
            } => radius * sweep_rad.abs(),
        }
    }
}

/// Steps between the samples of a piece.
pub const SAMPLE_STEPS: u32 = 8;

/// Positions at even steps along a piece, both ends included, diameters.
pub type Samples = [[f64; 2]; SAMPLE_STEPS as usize + 1];

/// The outer surface of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    pieces: Vec<Piece>,
    samples: Vec<Samples>,
    outermost: Vec<bool>,
    diameter_m: f64,
}

/// Height below which a protruding part of a body is rounding, diameters; assumed.
const LEVEL: f64 = 1e-9;

/// Whether a piece lies on the convex hull of the body: no part protrudes beyond the tangents at its ends.
fn is_outermost(piece: &Piece, pieces: &[Piece]) -> bool {
    [0.0, 1.0].into_iter().all(|t| {
        let station = piece.at(t);
        let normal = [station.normal_x, station.normal_r];
        let level = normal[0] * station.x + normal[1] * station.r + LEVEL;
        piece.bulges(&station) && pieces.iter().all(|other| other.reach(normal) <= level)
    })
}

impl Surface {
    /// The surface of an outline revolved about the axis, its x from the virtual apex; lines on the axis give none.
    pub fn new(outline: &Profile, diameter_m: f64) -> Surface {
        Surface::about(outline, diameter_m, 0.0)
    }

    /// The surface of an outline whose virtual apex is at `apex_x_m`; otherwise as [`Surface::new`].
    pub fn about(outline: &Profile, diameter_m: f64, apex_x_m: f64) -> Surface {
        let forward: f64 = outline.segments.iter().map(|s| s.integrals().r_dx).sum();
        let run = if forward < 0.0 {
            outline.reversed()
        } else {
            outline.clone()
        };
        let mut pieces = Vec::with_capacity(4 * run.segments.len());
        for segment in &run.segments {
            add(&mut pieces, segment, diameter_m, apex_x_m);
        }
        Surface::of_pieces(pieces, diameter_m)
    }

    /// The surface of pieces in order, lengths in diameters.
    pub fn of_pieces(pieces: Vec<Piece>, diameter_m: f64) -> Surface {
        let samples = |piece: &Piece| {
            core::array::from_fn(|n| piece.position(n as f64 / f64::from(SAMPLE_STEPS)))
        };
        Surface {
            outermost: (pieces.iter())
                .map(|piece| is_outermost(piece, &pieces))
                .collect(),
            samples: pieces.iter().map(samples).collect(),
            pieces,
            diameter_m,
        }
    }

    /// The pieces, in order from the nose.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// Positions along each piece.
    pub fn samples(&self) -> &[Samples] {
        &self.samples
    }

    /// Whether a piece lies on the convex hull of the body: then nothing shades what faces the air on it.
    pub fn is_outermost(&self, number: usize) -> bool {
        self.outermost.get(number).copied().unwrap_or(false)
    }

    /// Reference diameter, m.
    pub fn diameter_m(&self) -> f64 {
        self.diameter_m
    }
}

fn add(pieces: &mut Vec<Piece>, segment: &Segment, diameter_m: f64, apex_x_m: f64) {
    let scaled = |p: Point| [(p.x_m - apex_x_m) / diameter_m, p.r_m.max(0.0) / diameter_m];
    match *segment {
        Segment::Line { start, end } => {
            let (from, to) = (scaled(start), scaled(end));
            let empty = hypot(to[0] - from[0], to[1] - from[1]) < 1e-12;
            if !empty && (from[1] > 1e-12 || to[1] > 1e-12) {
                pieces.push(Piece::Line { from, to });
            }
        }
        Segment::Arc {
            center,
            radius_m,
            start_angle_rad,
            sweep_rad,
            ..
        } => {
            let radius = radius_m / diameter_m;
            if radius * sweep_rad.abs() < 1e-12 {
                return;
            }
            let center = [
                (center.x_m - apex_x_m) / diameter_m,
                center.r_m / diameter_m,
            ];
            for [from, to] in parts(start_angle_rad, sweep_rad) {
                pieces.push(Piece::Arc {
                    center,
                    radius,
                    start_rad: from,
                    sweep_rad: to - from,
                });
            }
        }
    }
}

/// An arc divided where x has an extremum and where it is long.
fn parts(start_rad: f64, sweep_rad: f64) -> Vec<[f64; 2]> {
    let end = start_rad + sweep_rad;
    let (low, high) = (start_rad.min(end), start_rad.max(end));
    let mut cuts = vec![low];
    let mut turn = (low / FRAC_PI_2).floor() * FRAC_PI_2;
    while turn < high {
        if turn > low + 1e-9 && turn < high - 1e-9 {
            cuts.push(turn);
        }
        turn += FRAC_PI_2;
    }
    cuts.push(high);
    let mut parts = Vec::new();
    for pair in cuts.windows(2) {
        if let [a, b] = *pair {
            let count = ((b - a) / LONGEST_ARC_RAD - 1e-9).ceil().max(1.0) as u32;
            let at = |n: u32| {
                if n == count {
                    b
                } else {
                    a + (b - a) * (f64::from(n) / f64::from(count))
                }
            };
            parts.extend((0..count).map(|n| [at(n), at(n + 1)]));
        }
    }
    if sweep_rad < 0.0 {
        parts.reverse();
        for part in &mut parts {
            part.reverse();
        }
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sphere_of_diameter_2_is_cut_into_four_arcs_with_normals_outwards() {
        let arc = Segment::arc(Point::on_axis(1.0), 1.0, PI, -PI);
        let outline = Profile {
            segments: vec![arc],
        }
        .closed();
        let surface = Surface::new(&outline, 2.0);
        assert_eq!(surface.pieces().len(), 4);
        let nose = surface.pieces()[0].at(0.0);
        assert!((nose.x - 0.0).abs() < 1e-15 && (nose.normal_x + 1.0).abs() < 1e-15);
        let waist = surface.pieces()[1].at(1.0);
        assert!((waist.r - 0.5).abs() < 1e-15 && (waist.normal_r - 1.0).abs() < 1e-15);
        // the reversed outline gives an equal surface
        let again = Surface::new(&outline.reversed(), 2.0);
        assert!((again.pieces()[0].at(0.0).normal_x + 1.0).abs() < 1e-15);
        assert!((0..4).all(|number| surface.is_outermost(number)));
        let length: f64 = surface.pieces().iter().map(Piece::length).sum();
        assert!((length - 0.5 * PI).abs() < 1e-14);
    }

    #[test]
    fn what_stands_behind_a_step_is_not_outermost() {
        let at = |x_m: f64, r_m: f64| Point { x_m, r_m };
        let points = [
            at(0.0, 0.0),
            at(0.0, 0.5),
            at(0.2, 0.5),
            at(0.2, 0.2),
            at(1.0, 0.2),
            at(1.0, 0.0),
        ];
        let line = |pair: &[Point]| Segment::Line {
            start: pair[0],
            end: pair[1],
        };
        let outline = Profile {
            segments: points.windows(2).map(line).collect(),
        };
        let surface = Surface::new(&outline.closed(), 1.0);
        let outermost = [0, 1, 2, 3, 4].map(|number| surface.is_outermost(number));
        assert_eq!(outermost, [true, true, false, false, true]);
    }
}
