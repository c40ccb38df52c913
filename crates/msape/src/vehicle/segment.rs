//! A straight line or circular arc in the half-plane (x, r), with its exact line integrals.
//!
//! ```text
//! arc: x = x_c + R cos u, r = r_c + R sin u, dx = −R sin u du
//! swept area = 2π ∫ r ds
//! ```
//!
//! with lengths in m, angles u in rad, from the x axis towards the r axis.
//!
//! # Valid
//! Any line; arcs up to a full turn either way.
//!
//! # References
//! - Elementary antiderivatives of powers of sine and cosine.

use numerics::math::{FRAC_PI_2, PI};
use numerics::scalar::Single;
use numerics::scalar::functions::{hypot, sin_cos};
use serde::{Deserialize, Serialize};

/// A point of the half-section.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Point<S = f64> {
    /// Axial position from the virtual apex, aft positive, m.
    pub x_m: S,
    /// Distance from the axis, m.
    pub r_m: S,
}

/// A piece of a profile.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Segment<S = f64> {
    /// A straight line.
    Line {
        /// Start.
        start: Point<S>,
        /// End.
        end: Point<S>,
    },
    /// A circular arc.
    Arc {
        /// Start.
        start: Point<S>,
        /// End.
        end: Point<S>,
        /// Center of the circle.
        center: Point<S>,
        /// Radius of the circle, m.
        radius_m: S,
        /// Direction from the center to the start, from the x axis towards the r axis, rad.
        start_angle_rad: S,
        /// Swept angle, positive from the x axis towards the r axis, rad.
        sweep_rad: S,
    },
}

/// Line integrals over a segment of the powers of x and r that area, volume and inertia need.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Integrals<S = f64> {
    /// ∫ r dx, m².
    pub r_dx: S,
    /// ∫ x r dx, m³.
    pub x_r_dx: S,
    /// ∫ r² dx, m³.
    pub r2_dx: S,
    /// ∫ x r² dx, m⁴.
    pub x_r2_dx: S,
    /// ∫ x² r² dx, m⁵.
    pub x2_r2_dx: S,
    /// ∫ r⁴ dx, m⁵.
    pub r4_dx: S,
}

impl<S: Single> Integrals<S> {
    /// Integrals over nothing: all zero.
    pub fn zero() -> Self {
        let zero = S::constant(0.0);
        Self {
            r_dx: zero,
            x_r_dx: zero,
            r2_dx: zero,
            x_r2_dx: zero,
            x2_r2_dx: zero,
            r4_dx: zero,
        }
    }

    /// Sum with the integrals over another segment.
    pub fn plus(self, other: &Self) -> Self {
        Self {
            r_dx: self.r_dx + other.r_dx,
            x_r_dx: self.x_r_dx + other.x_r_dx,
            r2_dx: self.r2_dx + other.r2_dx,
            x_r2_dx: self.x_r2_dx + other.x_r2_dx,
            x2_r2_dx: self.x2_r2_dx + other.x2_r2_dx,
            r4_dx: self.r4_dx + other.r4_dx,
        }
    }
}

/// Half the chord of a circle at a distance from its center, m; zero outside of it.
pub fn half_chord_m<S: Single>(radius_m: S, distance_m: S) -> S {
    let square = radius_m * radius_m - distance_m * distance_m;
    square.max(S::constant(0.0)).sqrt()
}

impl<S: Single> Point<S> {
    /// A point on the axis.
    pub fn on_axis(x_m: S) -> Self {
        let r_m = S::constant(0.0);
        Self { x_m, r_m }
    }

    /// Whether it is at the same place as another, however both move.
    pub fn is_at(&self, other: &Self) -> bool {
        let places = [self, other].map(|point| (point.x_m.value(), point.r_m.value()));
        places[0] == places[1]
    }
}

impl<S: Single> Segment<S> {
    /// The arc about `center` from `start_angle_rad` through `sweep_rad`; ends within rounding of the axis are on it.
    pub fn arc(center: Point<S>, radius_m: S, start_angle_rad: S, sweep_rad: S) -> Self {
        let at = |angle_rad: S| {
            let (s, c) = sin_cos(angle_rad);
            let r_m = center.r_m + radius_m * s;
            let on_axis = r_m.value().abs() <= 4.0 * f64::EPSILON * radius_m.value();
            let x_m = center.x_m + radius_m * c;
            if on_axis {
                Point::on_axis(x_m)
            } else {
                Point { x_m, r_m }
            }
        };
        Self::Arc {
            start: at(start_angle_rad),
            end: at(start_angle_rad + sweep_rad),
            center,
            radius_m,
            start_angle_rad,
            sweep_rad,
        }
    }

    /// Whether it lies where another does and in its direction, however both move.
    pub fn is_along(&self, other: &Self) -> bool {
        let sweep_rad = |segment: &Self| match segment {
            Self::Line { .. } => 0.0,
            Self::Arc { sweep_rad, .. } => sweep_rad.value(),
        };
        self.start().is_at(&other.start())
            && self.end().is_at(&other.end())
            && sweep_rad(self) == sweep_rad(other)
    }

    /// Start.
    pub fn start(&self) -> Point<S> {
        match *self {
            Self::Line { start, .. } | Self::Arc { start, .. } => start,
        }
    }

    /// End.
    pub fn end(&self) -> Point<S> {
        match *self {
            Self::Line { end, .. } | Self::Arc { end, .. } => end,
        }
    }

    /// The segment in the opposite direction.
    pub fn reversed(&self) -> Self {
        match *self {
            Self::Line { start, end } => Self::Line {
                start: end,
                end: start,
            },
            Self::Arc {
                start,
                end,
                center,
                radius_m,
                start_angle_rad,
                sweep_rad,
            } => Self::Arc {
                start: end,
                end: start,
                center,
                radius_m,
                start_angle_rad: start_angle_rad + sweep_rad,
                sweep_rad: -sweep_rad,
            },
        }
    }

    /// Area swept by revolution about the axis, m².
    pub fn swept_area_m2(&self) -> S {
        match *self {
            Self::Line { start, end } => {
                (start.r_m + end.r_m) * PI * hypot(end.x_m - start.x_m, end.r_m - start.r_m)
            }
            Self::Arc {
                start,
                end,
                center,
                radius_m,
                sweep_rad,
                ..
            } => {
                // ∫ (r_c + R sin u) R du, R cos u being x − x_c
                let area = radius_m * (2.0 * PI) * (center.r_m * sweep_rad + start.x_m - end.x_m);
                if sweep_rad.value() < 0.0 { -area } else { area }
            }
        }
    }

    /// The line integrals, exact; inlined, so that a caller that reads some of them pays for those.
    #[inline]
    pub fn integrals(&self) -> Integrals<S> {
        match *self {
            Self::Line { start, end } => line_integrals(start, end),
            Self::Arc {
                start,
                end,
                center,
                radius_m,
                sweep_rad,
                ..
            } => {
                if radius_m.value() > 0.0 {
                    arc_integrals([start, end], center, radius_m, sweep_rad)
                } else {
                    Integrals::zero()
                }
            }
        }
    }
}

impl Segment {
    /// Point at a fraction of the length, 0 at the start.
    pub fn at(&self, part: f64) -> Point {
        match *self {
            Self::Line { start, end } => Point {
                x_m: start.x_m + part * (end.x_m - start.x_m),
                r_m: start.r_m + part * (end.r_m - start.r_m),
            },
            Self::Arc { end, .. } if part >= 1.0 => end,
            Self::Arc {
                center,
                radius_m,
                start_angle_rad,
                sweep_rad,
                ..
            } => {
                let (s, c) = sin_cos(start_angle_rad + part * sweep_rad);
                Point {
                    x_m: center.x_m + radius_m * c,
                    r_m: center.r_m + radius_m * s,
                }
            }
        }
    }

    /// Whether the arc passes the direction `angle_rad` from its center; never for a line.
    pub fn sweeps(&self, angle_rad: f64) -> bool {
        match *self {
            Self::Line { .. } => false,
            Self::Arc {
                start_angle_rad,
                sweep_rad,
                ..
            } => {
                let turn = (angle_rad - start_angle_rad) * sweep_rad.signum() / (2.0 * PI);
                (turn - turn.floor()) * 2.0 * PI <= sweep_rad.abs()
            }
        }
    }

    /// Least and largest x, least and largest r, m.
    pub fn bounds_m(&self) -> [f64; 4] {
        let (a, b) = (self.start(), self.end());
        let mut bounds = [
            a.x_m.min(b.x_m),
            a.x_m.max(b.x_m),
            a.r_m.min(b.r_m),
            a.r_m.max(b.r_m),
        ];
        if let Self::Arc {
            center, radius_m, ..
        } = *self
        {
            let [left, right, low, high] = &mut bounds;
            let quarters = [
                (PI, left, center.x_m - radius_m),
                (0.0, right, center.x_m + radius_m),
                (-FRAC_PI_2, low, center.r_m - radius_m),
                (FRAC_PI_2, high, center.r_m + radius_m),
            ];
            for (angle_rad, bound, value) in quarters {
                if self.sweeps(angle_rad) {
                    *bound = value;
                }
            }
        }
        bounds
    }
}

#[inline]
fn line_integrals<S: Single>(start: Point<S>, end: Point<S>) -> Integrals<S> {
    let (x0, r0, dx, dr) = (
        start.x_m,
        start.r_m,
        end.x_m - start.x_m,
        end.r_m - start.r_m,
    );
    // over 0..1: ∫ (r0 + dr t)² tᵏ dt, k = 0, 1, 2
    let square = r0 * r0 + r0 * dr + dr * dr / 3.0;
    let square_t = r0 * r0 / 2.0 + r0 * 2.0 * dr / 3.0 + dr * dr / 4.0;
    let square_t2 = r0 * r0 / 3.0 + r0 * dr / 2.0 + dr * dr / 5.0;
    let r1 = r0 + dr;
    let fourth = (r0 * r0 * r0 * r0
        + r0 * r0 * r0 * r1
        + r0 * r0 * r1 * r1
        + r0 * r1 * r1 * r1
        + r1 * r1 * r1 * r1)
        / 5.0;
    Integrals {
        r_dx: dx * (r0 + dr / 2.0),
        x_r_dx: dx * (x0 * (r0 + dr / 2.0) + dx * (r0 / 2.0 + dr / 3.0)),
        r2_dx: dx * square,
        x_r2_dx: dx * (x0 * square + dx * square_t),
        x2_r2_dx: dx * (x0 * x0 * square + x0 * 2.0 * dx * square_t + dx * dx * square_t2),
        r4_dx: dx * fourth,
    }
}

#[inline]
fn arc_integrals<S: Single>(
    ends: [Point<S>; 2],
    center: Point<S>,
    radius: S,
    sweep: S,
) -> Integrals<S> {
    let [from, to] = ends.map(|p| ((p.r_m - center.r_m) / radius, (p.x_m - center.x_m) / radius));
    let ((s0, c0), (s1, c1)) = (from, to);
    let (a, b, big) = (center.x_m, center.r_m, radius);
    let d = |f: fn(S, S) -> S| f(s1, c1) - f(s0, c0);
    // ∫ sinᵐ cosⁿ du, named sᵐcⁿ
    let dc = d(|_, c| c);
    let dc3 = d(|_, c| c * c * c);
    let dc5 = d(|_, c| c * c * c * c * c);
    let dsc = d(|s, c| s * c);
    let dsc_4u = d(|s, c| s * c * (c * c - s * s));
    let s = -dc;
    let s2 = (sweep - dsc) / 2.0;
    let s3 = dc3 / 3.0 - dc;
    let s4 = sweep * 0.375 - dsc / 2.0 + dsc_4u / 8.0;
    let s5 = -dc + dc3 * 2.0 / 3.0 - dc5 / 5.0;
    let sc = d(|s, _| s * s) / 2.0;
    let s2c = d(|s, _| s * s * s) / 3.0;
    let s3c = d(|s, _| s * s * s * s) / 4.0;
    let sc2 = -dc3 / 3.0;
    let s2c2 = (sweep - dsc_4u) / 8.0;
    let s3c2 = dc5 / 5.0 - dc3 / 3.0;
    // r² sin = b² s + 2 b R s² + R² s³, alone, times cos and times cos²
    let square = b * b * s + b * 2.0 * big * s2 + big * big * s3;
    let square_c = b * b * sc + b * 2.0 * big * s2c + big * big * s3c;
    let square_c2 = b * b * sc2 + b * 2.0 * big * s2c2 + big * big * s3c2;
    let fourth = b * b * b * b * s
        + b * 4.0 * b * b * big * s2
        + b * 6.0 * b * big * big * s3
        + b * 4.0 * big * big * big * s4
        + big * big * big * big * s5;
    Integrals {
        r_dx: -big * (b * s + big * s2),
        x_r_dx: -big * (a * (b * s + big * s2) + big * (b * sc + big * s2c)),
        r2_dx: -big * square,
        x_r2_dx: -big * (a * square + big * square_c),
        x2_r2_dx: -big * (a * a * square + a * 2.0 * big * square_c + big * big * square_c2),
        r4_dx: -big * fourth,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn line_from_0_1_to_2_3_has_integral_of_r_dx_4() {
        let line = Segment::Line {
            start: Point { x_m: 0.0, r_m: 1.0 },
            end: Point { x_m: 2.0, r_m: 3.0 },
        };
        // r = 1 + x over 0..2: ∫ r = 4, ∫ r² = 26/3, ∫ x r² = 34/3, ∫ x² r² = 8/3 + 8 + 32/5, ∫ r⁴ = 242/5
        let i = line.integrals();
        let want = [
            4.0,
            2.0 + 8.0 / 3.0,
            26.0 / 3.0,
            2.0 + 16.0 / 3.0 + 4.0,
            8.0 / 3.0 + 8.0 + 6.4,
            48.4,
        ];
        for (got, want) in [i.r_dx, i.x_r_dx, i.r2_dx, i.x_r2_dx, i.x2_r2_dx, i.r4_dx]
            .into_iter()
            .zip(want)
        {
            assert!((got - want).abs() < 1e-13 * want, "{got} against {want}");
        }
    }

    #[test]
    fn an_arc_agrees_with_many_short_chords() {
        let center = Point { x_m: 0.3, r_m: 0.7 };
        let arc = Segment::arc(center, 0.5, 0.4, 1.9).integrals();
        let n = 20000;
        let mut sum = Integrals::zero();
        for k in 0..n {
            let step = 1.9 / f64::from(n);
            let chord = Segment::arc(center, 0.5, 0.4 + step * f64::from(k), step);
            sum = sum.plus(&line_integrals(chord.start(), chord.end()));
        }
        // the relative chord error is about the square of the step, (1e-4)²
        let pairs = [
            (arc.r_dx, sum.r_dx),
            (arc.x_r_dx, sum.x_r_dx),
            (arc.r2_dx, sum.r2_dx),
            (arc.x_r2_dx, sum.x_r2_dx),
            (arc.x2_r2_dx, sum.x2_r2_dx),
            (arc.r4_dx, sum.r4_dx),
        ];
        for (got, want) in pairs {
            assert!((got - want).abs() < 1e-8, "{got} against {want}");
        }
    }
}
