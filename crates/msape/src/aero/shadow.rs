//! Part of a circle of latitude that the air reaches: exact shadows of a body of revolution on itself.
//!
//! ```text
//! the ray against the air from (x₀, r₀, φ) passes through the circle (x, r) when   cos φ = h(x, r)
//! h = (r₀² − r² + τ²)/(2 r₀ τ)        τ = (x₀ − x) tan α > 0
//! ```
//!
//! with lengths in diameters, φ the azimuth and α the angle of attack in rad. A piece of the meridian upstream of the circle therefore shades
//! the azimuths whose cosines h takes on it, from its smallest to its largest value. On a line
//! h has one extremum, at τ² = (r₀² − a²)/(1 − b²) for r = a + bτ; on an arc it is the zero of dh beside the extreme samples.
//! The rest of the windward side is a few intervals of cos φ.
//!
//! # Valid
//! Any meridian, re-entrant ones too. At angles within 1e-9 rad of 0, 90 and 180 deg the shadow is that of the angle beside.
//!
//! # References
//! - Intersection of a line with a circle about the axis.

use super::surface::{Piece, SAMPLE_STEPS, Samples, Station, Surface};
use numerics::root;

/// Smallest distance kept from the axis and from the plane normal to it, rad.
const NUDGE_RAD: f64 = 1e-9;
/// Tolerance of the place of an extremum, relative to the chord between the samples beside it, assumed.
const CLOSE: f64 = 1e-6;
/// Distance from the circle itself, relative to the same chord, within which no extremum is sought, assumed.
const APART: f64 = 1e-4;
/// Distance from the circle itself, diameters, assumed, within which the ray leaves along the surface.
const BESIDE: f64 = 1e-8;
/// Largest number of intervals kept.
const MOST: usize = 6;

/// The direction of the air.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wind {
    /// Sine of the total angle of attack.
    pub sin: f64,
    /// Cosine of the total angle of attack.
    pub cos: f64,
}

impl Wind {
    /// The air at a total angle of attack of 0…π rad.
    pub fn new(alpha_rad: f64) -> Wind {
        let (sin, cos) = numerics::math::sin_cos(alpha_rad);
        let sin = if sin.abs() < 1e-15 { 0.0 } else { sin };
        let cos = if cos.abs() < 1e-15 { 0.0 } else { cos };
        Wind { sin, cos }
    }

    /// Tangent of the angle, kept off zero and infinity.
    fn tangent(&self) -> f64 {
        let cos = if self.cos.abs() < NUDGE_RAD {
            if self.cos < 0.0 {
                -NUDGE_RAD
            } else {
                NUDGE_RAD
            }
        } else {
            self.cos
        };
        self.sin.max(NUDGE_RAD) / cos
    }
}

/// Intervals of the cosine of the azimuth, ascending.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lit {
    intervals: [[f64; 2]; MOST],
    count: usize,
}

impl Lit {
    /// One interval, or none when it is empty.
    pub fn new(low: f64, high: f64) -> Lit {
        let mut lit = Lit::default();
        lit.push([low, high]);
        lit
    }

    /// The intervals.
    pub fn intervals(&self) -> &[[f64; 2]] {
        self.intervals.get(..self.count).unwrap_or_default()
    }

    pub(super) fn push(&mut self, [low, high]: [f64; 2]) {
        if high > low
            && let Some(place) = self.intervals.get_mut(self.count)
        {
            *place = [low, high];
            self.count += 1;
        }
    }

    /// Interval from the least to the largest cosine; `None` in the shade.
    fn hull(&self) -> Option<[f64; 2]> {
        match (self.intervals().first(), self.intervals().last()) {
            (Some([low, _]), Some([_, high])) => Some([*low, *high]),
            _ => None,
        }
    }

    /// Takes an interval away.
    fn shade(&mut self, low: f64, high: f64) {
        let before = *self;
        self.count = 0;
        for &[a, b] in before.intervals() {
            self.push([a, b.min(low)]);
            self.push([a.max(high), b]);
        }
    }
}

/// Cosines of the azimuths at which a circle of latitude faces the air, before any shadow.
pub fn windward(station: &Station, wind: Wind) -> Lit {
    let (p, q) = (-station.normal_x * wind.cos, -station.normal_r * wind.sin);
    if q == 0.0 {
        return if p > 0.0 {
            Lit::new(-1.0, 1.0)
        } else {
            Lit::default()
        };
    }
    let limit = (-p / q).clamp(-1.0, 1.0);
    if q > 0.0 {
        Lit::new(limit, 1.0)
    } else {
        Lit::new(-1.0, limit)
    }
}

/// Takes the shadows of the body on the circle of latitude through a station of the piece `own` away from `lit`.
pub fn cast(lit: &mut Lit, surface: &Surface, own: usize, station: &Station, wind: Wind) {
    let eye = Eye {
        x: station.x,
        r: station.r,
        tangent: wind.tangent(),
    };
    for (n, (piece, samples)) in surface.pieces().iter().zip(surface.samples()).enumerate() {
        let Some(hull) = lit.hull() else { return };
        let range = if n == own {
            match piece.bulges(station) {
                // it shades what faces away from the air, and that is not in `lit`
                true => None,
                false => eye.own(piece, station, hull),
            }
        } else if eye.may_shade(samples, hull) {
            eye.other(piece, samples, hull)
        } else {
            None
        };
        if let Some([low, high]) = range {
            lit.shade(low, high);
        }
    }
}

/// The circle whose rays are followed.
#[derive(Clone, Copy)]
struct Eye {
    x: f64,
    r: f64,
    tangent: f64,
}

impl Eye {
    fn tau(&self, x: f64) -> f64 {
        (self.x - x) * self.tangent
    }

    fn h(&self, [x, r]: [f64; 2]) -> f64 {
        let tau = self.tau(x);
        ((self.r - r) * (self.r + r) + tau * tau) / (2.0 * self.r * tau)
    }

    /// The slope of h along an arc, times something that keeps its sign where the arc is upstream.
    fn slope(&self, arc: &Arc, [x, r]: [f64; 2]) -> f64 {
        let (c, s) = (x - arc.center[0], r - arc.center[1]);
        let ahead = self.x - x;
        let tau = self.tau(x);
        s * (tau * tau - (self.r - r) * (self.r + r)) - 2.0 * r * c * ahead
    }

    /// Whether a point lies on the circle itself.
    fn is_beside(&self, [x, r]: [f64; 2]) -> bool {
        (self.x - x).abs() < BESIDE && (self.r - r).abs() < BESIDE
    }

    /// h where the piece passes beside the circle itself.
    fn beside(&self, r: f64) -> f64 {
        if self.r > r {
            f64::INFINITY
        } else {
            f64::NEG_INFINITY
        }
    }

    /// Range of h over the piece on which the circle lies.
    fn own(&self, piece: &Piece, station: &Station, hull: [f64; 2]) -> Option<[f64; 2]> {
        // The ray that leaves along the surface.
        let along = -station.normal_x / station.normal_r / self.tangent;
        let ends = [0.0, 1.0].map(|end| (end, self.tau(piece.position(end)[0])));
        let mut range = None;
        for (end, tau) in ends {
            if tau <= 0.0 {
                continue;
            }
            include(&mut range, along);
            match piece {
                Piece::Line { .. } => {
                    // a = r₀: no extremum between
                    include(&mut range, self.h(piece.position(end)));
                }
                Piece::Arc { center, radius, .. } => {
                    let h = |point: [f64; 2]| match self.is_beside(point) {
                        true => along,
                        false => self.h(point),
                    };
                    let arc = Arc {
                        center: *center,
                        radius: *radius,
                    };
                    let ends = [[station.x, station.r], piece.position(end)];
                    self.include_arc(&mut range, &arc, &arc.samples(ends), h, hull);
                }
            }
        }
        range
    }

    /// Whether h can meet the cosines of `hull` anywhere between the ends of a piece, which is monotone in x and in r.
    fn may_shade(&self, samples: &Samples, [low, high]: [f64; 2]) -> bool {
        let [[x0, r0], .., [x1, r1]] = *samples;
        let (ta, tb) = (self.tau(x0), self.tau(x1));
        let (near, far) = (ta.min(tb).max(0.0), ta.max(tb));
        if far <= 0.0 {
            return false;
        }
        let excess = |r: f64| (self.r - r) * (self.r + r);
        let h = |excess: f64, tau: f64| (excess / tau + tau) / (2.0 * self.r);
        // h falls with r: from below by the largest r, from above by the smallest
        let (outer, inner) = (excess(r0.max(r1)), excess(r0.min(r1)));
        let least = if outer > 0.0 {
            h(outer, outer.sqrt().clamp(near, far))
        } else if near > 0.0 {
            h(outer, near)
        } else {
            f64::NEG_INFINITY
        };
        let most = if near > 0.0 {
            h(inner, near).max(h(inner, far))
        } else if inner > 0.0 {
            f64::INFINITY
        } else {
            h(inner, far)
        };
        // NaN: the closer search decides.
        !(least > high || most < low)
    }

    /// Range of h over the upstream part of another piece.
    fn other(&self, piece: &Piece, samples: &Samples, hull: [f64; 2]) -> Option<[f64; 2]> {
        let [first, .., last] = *samples;
        let ends = [first, last];
        let taus = ends.map(|[x, _]| self.tau(x));
        if taus[0] <= 0.0 && taus[1] <= 0.0 {
            return None;
        }
        let mut range = None;
        for (end, tau) in ends.iter().zip(taus) {
            if tau > 0.0 {
                include(&mut range, self.h(*end));
            }
        }
        let straddles = taus[0].min(taus[1]) < 0.0;
        match *piece {
            Piece::Line { from, to } => {
                let slope = (to[1] - from[1]) / (taus[1] - taus[0]);
                let r_at = |tau: f64| from[1] + slope * (tau - taus[0]);
                if straddles {
                    include(&mut range, self.beside(r_at(0.0)));
                }
                let a = r_at(0.0);
                let square = (self.r - a) * (self.r + a) / (1.0 - slope * slope);
                let (low, high) = (taus[0].min(taus[1]).max(0.0), taus[0].max(taus[1]));
                if square > low * low && square < high * high {
                    let tau = square.sqrt();
                    let r = r_at(tau);
                    let h = ((self.r - r) * (self.r + r) + tau * tau) / (2.0 * self.r * tau);
                    include(&mut range, h);
                }
            }
            Piece::Arc { center, radius, .. } => {
                let arc = Arc { center, radius };
                if straddles {
                    let h = |point: [f64; 2]| match self.tau(point[0]) > 0.0 {
                        true => self.h(point),
                        false => self.beside(point[1]),
                    };
                    let crossing = arc.at(self.x, samples[samples.len() / 2][1] > center[1]);
                    include(&mut range, self.beside(crossing[1]));
                    let upstream = ends[usize::from(taus[1] > 0.0)];
                    let points = arc.samples([crossing, upstream]);
                    self.include_arc(&mut range, &arc, &points, h, hull);
                } else {
                    self.include_arc(&mut range, &arc, samples, |point| self.h(point), hull);
                }
            }
        }
        range
    }

    /// Includes h at points along an arc, and where one of them is extreme, the extremum beside it.
    fn include_arc(
        &self,
        range: &mut Option<[f64; 2]>,
        arc: &Arc,
        points: &Samples,
        h: impl Fn([f64; 2]) -> f64,
        [low, high]: [f64; 2],
    ) {
        let (mut least, mut most) = ((0, f64::INFINITY), (0, f64::NEG_INFINITY));
        for (n, point) in points.iter().enumerate() {
            let value = h(*point);
            include(range, value);
            if value < least.1 {
                least = (n, value);
            }
            if value > most.1 {
                most = (n, value);
            }
        }
        // A lower minimum or a higher maximum matters only where something lit is left beyond the sample.
        let sought = [
            (least.1 > low).then_some(least.0),
            (most.1 < high).then_some(most.0),
        ];
        for n in sought.into_iter().flatten() {
            let last = points.len() - 1;
            let ends = [n.saturating_sub(1), (n + 1).min(last)].map(|n| points[n]);
            // on the circle itself the slope is 0 / 0
            let from = if self.is_beside(ends[0]) { APART } else { 0.0 };
            let slope = |u: f64| self.slope(arc, arc.above(ends, u));
            if let Some(u) = root::brent(slope, from, 1.0, CLOSE) {
                include(range, h(arc.above(ends, u)));
            }
        }
    }
}

fn include(range: &mut Option<[f64; 2]>, value: f64) {
    if value.is_nan() {
        return;
    }
    *range = Some(match *range {
        Some([low, high]) => [low.min(value), high.max(value)],
        None => [value, value],
    });
}

/// The circle of an arc. Between two of its points it is run through along their chord: an extremum does not mind, and no angle is
/// needed.
#[derive(Clone, Copy)]
struct Arc {
    center: [f64; 2],
    radius: f64,
}

impl Arc {
    /// The point at an axial position, on the outer or on the inner side of the center.
    fn at(&self, x: f64, outer: bool) -> [f64; 2] {
        let dx = x - self.center[0];
        let dr = ((self.radius - dx) * (self.radius + dx)).max(0.0).sqrt();
        let r = self.center[1] + if outer { dr } else { -dr };
        [x, r.max(0.0)]
    }

    /// The point above `u` of 0…1 of the chord between two points, less than 180 deg apart.
    fn above(&self, [from, to]: [[f64; 2]; 2], u: f64) -> [f64; 2] {
        let on_chord = |i: usize| from[i] + u * (to[i] - from[i]) - self.center[i];
        let (x, r) = (on_chord(0), on_chord(1));
        let scale = self.radius / (x * x + r * r).sqrt();
        [
            self.center[0] + scale * x,
            (self.center[1] + scale * r).max(0.0),
        ]
    }

    /// Points from one to another.
    fn samples(&self, ends: [[f64; 2]; 2]) -> Samples {
        core::array::from_fn(|n| self.above(ends, n as f64 / f64::from(SAMPLE_STEPS)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use numerics::math::RADIANS_PER_DEGREE;

    fn line(from: [f64; 2], to: [f64; 2]) -> Piece {
        Piece::Line { from, to }
    }

    /// Whether one azimuth is lit.
    fn reached(lit: &Lit, cos: f64) -> bool {
        lit.intervals()
            .iter()
            .any(|[a, b]| (*a..=*b).contains(&cos))
    }

    #[test]
    fn a_disc_shades_the_stem_behind_it() {
        // a disc of radius 0.5 at x = 0 and a stem of radius 0.1 behind it; the air comes at 45 deg
        let pieces = [
            line([0.0, 0.0], [0.0, 0.5]),
            line([0.0, 0.5], [0.01, 0.5]),
            line([0.01, 0.5], [0.01, 0.1]),
            line([0.01, 0.1], [2.01, 0.1]),
        ];
        let body = Surface::of_pieces(pieces.to_vec(), 1.0);
        let wind = Wind::new(45.0 * RADIANS_PER_DEGREE);
        let at = |x: f64| {
            let t = (x - 0.01) / 2.0;
            let mut lit = windward(&pieces[3].at(t), wind);
            cast(&mut lit, &body, 3, &pieces[3].at(t), wind);
            lit
        };
        // the windward line φ = π is y = −0.1; its ray reaches the disc's plane x = 0.01 at −0.1 − (x − 0.01) and
        // leaves the shadow where that is −0.5: x = 0.41
        assert!(!reached(&at(0.40), -1.0));
        assert!(reached(&at(0.42), -1.0));
        // far behind, the whole windward half is lit
        assert!(reached(&at(1.5), -0.01) && !reached(&at(1.5), 0.01));
    }

    #[test]
    fn a_ball_shades_the_ring_behind_it_however_close_to_90_deg_the_air_comes() {
        // a ball of radius 0.33 about the axis at x = 0.32, whose aft half stands in a ring that opens aft, as of an entry vehicle
        let ball = |n: f64| Piece::Arc {
            center: [0.32, 0.0],
            radius: 0.33,
            start_rad: (0.5 - 0.25 * n) * numerics::math::PI,
            sweep_rad: -0.25 * numerics::math::PI,
        };
        let ring = line([0.345, 0.44], [0.32, 0.4]);
        let body = Surface::of_pieces(
            vec![ring, line([0.32, 0.4], [0.32, 0.33]), ball(0.0), ball(1.0)],
            1.0,
        );
        for degrees in [90.3, 91.0, 92.0, 95.0] {
            let wind = Wind::new(degrees * RADIANS_PER_DEGREE);
            let station = ring.at(0.3);
            let mut lit = windward(&station, wind);
            cast(&mut lit, &body, 0, &station, wind);
            // across the axis every ray meets the ball, whose half at this x is 0.3295 wide: sin φ < 0.3295/0.428
            for cos in [0.66, 0.8, 1.0] {
                assert!(!reached(&lit, cos), "{degrees} deg, {cos}: {lit:?}");
            }
        }
    }

    #[test]
    fn a_convex_body_casts_no_shadow_on_its_windward_side() {
        let arc = |start: f64| Piece::Arc {
            center: [0.5, 0.0],
            radius: 0.5,
            start_rad: start,
            sweep_rad: -0.25 * numerics::math::PI,
        };
        let pieces: Vec<Piece> = [4.0, 3.0, 2.0, 1.0]
            .map(|n| arc(0.25 * n * numerics::math::PI))
            .to_vec();
        let body = Surface::of_pieces(pieces.clone(), 1.0);
        for degrees in [0.0, 1e-4, 17.0, 45.0, 89.9, 90.0, 90.1, 133.0, 179.0, 180.0] {
            let wind = Wind::new(degrees * RADIANS_PER_DEGREE);
            for (own, piece) in pieces.iter().enumerate() {
                for t in [0.05, 0.4, 0.9] {
                    let before = windward(&piece.at(t), wind);
                    let mut after = before;
                    cast(&mut after, &body, own, &piece.at(t), wind);
                    for (a, b) in before.intervals().iter().zip(after.intervals()) {
                        assert!(
                            (a[0] - b[0]).abs() < 1e-6 && (a[1] - b[1]).abs() < 1e-6,
                            "{degrees} deg, piece {own}, t {t}: {before:?} {after:?}"
                        );
                    }
                    assert_eq!(before.intervals().len(), after.intervals().len());
                }
            }
        }
    }

    #[test]
    fn a_cup_shades_its_own_bottom_from_behind() {
        // a thin cup of radius 0.5 whose rim is 0.2 behind its bottom at x = 0; air from behind at 135 deg
        let pieces = [
            line([-0.01, 0.0], [-0.01, 0.5]),
            line([-0.01, 0.5], [0.2, 0.5]),
            line([0.2, 0.5], [0.2, 0.49]),
            line([0.2, 0.49], [0.0, 0.49]),
            line([0.0, 0.49], [0.0, 0.0]),
        ];
        let body = Surface::of_pieces(pieces.to_vec(), 1.0);
        let wind = Wind::new(135.0 * RADIANS_PER_DEGREE);
        let t = 0.5; // r = 0.245 on the bottom
        let mut lit = windward(&pieces[4].at(t), wind);
        assert_eq!(lit, Lit::new(-1.0, 1.0));
        cast(&mut lit, &body, 4, &pieces[4].at(t), wind);
        // at the rim's plane the ray from y = 0.245 cos φ is at y − 0.2: |(0.245 cos φ − 0.2, 0.245 sin φ)| < 0.49 is
        // 0.245² + 0.04 − 2·0.2·0.245 cos φ < 0.2401, cos φ > −1.43: all lit
        assert!(reached(&lit, -0.999));
        let t = 0.1; // r = 0.441: 0.194481 + 0.04 − 0.1764 cos φ < 0.2401 where cos φ > −0.03185
        let mut lit = windward(&pieces[4].at(t), wind);
        cast(&mut lit, &body, 4, &pieces[4].at(t), wind);
        assert!(reached(&lit, -0.0318) && !reached(&lit, -0.0320), "{lit:?}");
    }
}
