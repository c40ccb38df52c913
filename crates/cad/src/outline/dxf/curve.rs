//! Curves of a drawing before conversion to lines and arcs: chains, ellipses, rational Bézier curves.
//!
//! ```text
//! ellipse: P = C + u cos t + v sin t        a piece of δ of it: control points P₀, C + (u cos m + v sin m) / cos(δ/2), P₁
//! with the weights 1, cos(δ/2), 1, m its middle: a quadratic rational curve, exactly
//! ```
//!
//! with lengths in the unit of the drawing or, once mapped, in m, angles in rad. Circles stay arcs, which are exact.
//!
//! # Valid
//! Conjugate half-axes u and v, as an affine map leaves them.
//!
//! # References
//! - \[piegl-tiller-1997\] section 7.3 (conics as rational quadratic curves).

use super::affine::{Affine, circle, cross};
use super::biarc::{self, Bezier};
use msape::vehicle::body::points::bulged;
use msape::vehicle::segment::{Point, Segment};
use numerics::math::{FRAC_PI_2, PI, cos, sin_cos, tan};

/// Sweeps short of a full turn by no more than this count as full, rad.
const WHOLE: f64 = 1e-9;

/// Curve of a drawing.
#[derive(Clone, Debug, PartialEq)]
pub enum Curve {
    /// Lines and arcs: x, y and the bulge of the segment to the next point.
    Chain(Vec<[f64; 3]>),
    /// Arc of an ellipse or circle.
    Ellipse {
        /// Center.
        center: [f64; 2],
        /// Half-axis at t = 0.
        u: [f64; 2],
        /// Half-axis at t = π/2.
        v: [f64; 2],
        /// Start parameter, rad.
        from: f64,
        /// Parameter range, rad.
        sweep: f64,
    },
    /// Consecutive smooth pieces.
    Smooth(Vec<Bezier>),
}

impl Curve {
    /// The curve mapped by `map`.
    pub fn moved(&self, map: &Affine) -> Vec<Self> {
        match self {
            Self::Chain(points) => {
                let straight = points.iter().all(|point| point[2] == 0.0);
                match map.keeps_circles() {
                    None if !straight => points
                        .windows(2)
                        .flat_map(|pair| match pair {
                            [from, to] => piece(from, to).moved(map),
                            _ => Vec::new(),
                        })
                        .collect(),
                    sense => {
                        let sense = sense.unwrap_or(1.0);
                        let place = |&[x, y, bulge]: &[f64; 3]| {
                            let [x, y] = map.point([x, y]);
                            [x, y, sense * bulge]
                        };
                        vec![Self::Chain(points.iter().map(place).collect())]
                    }
                }
            }
            Self::Ellipse {
                center,
                u,
                v,
                from,
                sweep,
            } => vec![Self::Ellipse {
                center: map.point(*center),
                u: map.direction(*u),
                v: map.direction(*v),
                from: *from,
                sweep: *sweep,
            }],
            Self::Smooth(pieces) => {
                vec![Self::Smooth(
                    pieces.iter().map(|piece| piece.moved(map)).collect(),
                )]
            }
        }
    }

    /// Upper estimate of the largest distance from the x axis.
    pub fn reach(&self) -> f64 {
        match self {
            Self::Chain(points) => points.iter().map(|p| p[1].abs()).fold(0.0, f64::max),
            Self::Ellipse { center, u, v, .. } => {
                center[1].abs() + (u[1] * u[1] + v[1] * v[1]).sqrt()
            }
            Self::Smooth(pieces) => pieces.iter().map(Bezier::reach).fold(0.0, f64::max),
        }
    }

    /// Points and bulges, those of smooth pieces to within `tolerance`; stops at about `room` points.
    pub fn flattened(&self, tolerance: f64, room: usize) -> Vec<[f64; 3]> {
        match self {
            Self::Chain(points) => points.clone(),
            &Self::Ellipse {
                center,
                u,
                v,
                from,
                sweep,
            } => {
                if !circle(u, v) {
                    return biarc::flattened(
                        &quadratics(center, u, v, from, sweep),
                        tolerance,
                        room,
                    );
                }
                let sense = cross(u, v).signum();
                if sweep.abs() >= 2.0 * PI - WHOLE {
                    // cut where a half-section of a sphere begins and ends
                    let radius = (u[0] * u[0] + u[1] * u[1]).sqrt();
                    let [left, right] =
                        [-radius, radius].map(|dx| [center[0] + dx, center[1], 1.0]);
                    return vec![left, right, left];
                }
                let [start, end] = [from, from + sweep].map(|t| on_ellipse(center, u, v, t));
                let bulge = sense * tan(sweep / 4.0);
                vec![[start[0], start[1], bulge], [end[0], end[1], 0.0]]
            }
            Self::Smooth(pieces) => biarc::flattened(pieces, tolerance, room),
        }
    }
}

/// One segment of a chain; an arc becomes an arc of a circle.
fn piece(from: &[f64; 3], to: &[f64; 3]) -> Curve {
    let [start, end] = [from, to].map(|p| Point {
        x_m: p[0],
        r_m: p[1],
    });
    match bulged(start, end, from[2]) {
        Segment::Line { .. } => Curve::Chain(vec![[from[0], from[1], 0.0], *to]),
        Segment::Arc {
            center,
            radius_m: radius,
            start_angle_rad,
            sweep_rad,
            ..
        } => Curve::Ellipse {
            center: [center.x_m, center.r_m],
            u: [radius, 0.0],
            v: [0.0, radius],
            from: start_angle_rad,
            sweep: sweep_rad,
        },
    }
}

fn on_ellipse(center: [f64; 2], u: [f64; 2], v: [f64; 2], t: f64) -> [f64; 2] {
    let (s, c) = sin_cos(t);
    [0, 1].map(|i| center[i] + u[i] * c + v[i] * s)
}

/// Rational quadratic pieces of an ellipse, each of at most a quarter turn.
fn quadratics(center: [f64; 2], u: [f64; 2], v: [f64; 2], from: f64, sweep: f64) -> Vec<Bezier> {
    let count = (sweep.abs() / FRAC_PI_2 - WHOLE).ceil().max(1.0);
    let step = sweep / count;
    let weight = cos(0.5 * step);
    let at = |t: f64| on_ellipse(center, u, v, t);
    let mut pieces = Vec::new();
    let mut k = 0.0;
    while k < count {
        let [start, end] = [at(from + k * step), at(from + (k + 1.0) * step)];
        let middle = on_ellipse([0.0; 2], u, v, from + (k + 0.5) * step);
        // the weight times C + middle / weight
        let [x, y] = [0, 1].map(|i| weight * center[i] + middle[i]);
        pieces.push(Bezier(vec![
            [start[0], start[1], 1.0],
            [x, y, weight],
            [end[0], end[1], 1.0],
        ]));
        k += 1.0;
    }
    pieces
}
