//! Force and moment of a surface in a flow: pressure and shear integrated over the part that the air reaches.
//!
//! ```text
//! dC = (−P n + g u) dA/S_ref          P = C_p − g s          dA = r dφ ds
//! C_A = (8/π) ∫ r [−n_x ∫P dφ + cos α ∫g dφ] ds                          0 ≤ φ ≤ π, the other half being the same
//! C_N = (8/π) ∫ r [−n_r ∫P cos φ dφ + sin α ∫g dφ] ds
//! C_m = (8/π) ∫ r [(x n_r − r n_x) ∫P cos φ dφ + r cos α ∫g cos φ dφ − x sin α ∫g dφ] ds
//! ```
//!
//! with lengths in diameters, S_ref = π/4, C_m about x = 0 and nose-up positive; angles in rad. Where P and g are polynomials of cos φ the inner
//! integrals are closed forms; in the zone about s = 0 where the thermal motion counts they are Gauss sums. The outer
//! integral is adaptive: a panel is halved until two halves agree with the whole.
//!
//! # Valid
//! Range of the pressure law. A circle of latitude on the lee side feels thermal motion where its own horizon is lit.
//!
//! # References
//! - Definitions of the coefficients: \[samareh-2014\] section 3.3.1 (moments about the virtual apex).

use super::free_molecular::Gas;
use super::shadow::{Lit, Wind, cast, windward};
use super::surface::{Piece, Station, Surface};
use numerics::math::{PI, acos, sin_cos};
use numerics::quadrature::Rule;
use serde::{Deserialize, Serialize};

/// Coefficients of one attitude, about the virtual apex.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Loads {
    /// Axial force coefficient, positive aft.
    pub ca: f64,
    /// Normal force coefficient.
    pub cn: f64,
    /// Pitching moment coefficient about x = 0, nose-up positive, with the diameter.
    pub cm: f64,
}

impl Loads {
    /// The moment about a point `x` diameters aft of the apex and `z` below the axis, as axes of the body have it: axial force
    /// passes above a point below the axis and lifts the nose.
    pub fn cm_about(&self, x: f64, z: f64) -> f64 {
        self.cm + self.cn * x + self.ca * z
    }

    /// Drag coefficient.
    pub fn cd(&self, alpha_rad: f64) -> f64 {
        let (s, c) = sin_cos(alpha_rad);
        self.ca * c + self.cn * s
    }

    /// Lift coefficient.
    pub fn cl(&self, alpha_rad: f64) -> f64 {
        let (s, c) = sin_cos(alpha_rad);
        self.cn * c - self.ca * s
    }

    /// The sum of `a` times this and `b` times another.
    pub fn mixed(&self, a: f64, other: &Loads, b: f64) -> Loads {
        Loads {
            ca: a * self.ca + b * other.ca,
            cn: a * self.cn + b * other.cn,
            cm: a * self.cm + b * other.cm,
        }
    }
}

/// Law of pressure and shear on a surface element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law {
    /// Newton's pressure with C_p,max.
    Newtonian(f64),
    /// Molecules without collisions.
    FreeMolecular(Gas),
}

impl Law {
    /// P = c₀ + c₁ s + c₂ s² and g = c₃ s wherever the air reaches; `None` where thermal motion counts.
    fn powers(&self) -> Option<[f64; 4]> {
        match self {
            Law::Newtonian(most) => Some([0.0, 0.0, *most, 0.0]),
            Law::FreeMolecular(gas) => (gas.zone() == 0.0).then(|| gas.far()),
        }
    }
}

/// Accuracy of the integral over the meridian.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effort {
    /// Largest difference between a panel and its halves, in coefficients.
    pub tolerance: f64,
    /// Largest number of halvings.
    pub depth: u32,
    /// Pieces shorter than this, in diameters, are one panel.
    pub short: f64,
    /// Widths of the thermal motion that one panel of azimuths spans.
    pub thermal_panel: f64,
}

impl Effort {
    /// Effort for single attitudes: 1e-8 in a panel.
    pub const FINE: Effort = Effort {
        tolerance: 1e-8,
        depth: 14,
        short: 0.0,
        thermal_panel: 1.5,
    };
    /// Effort for tables, which are interpolated anyway: 5e-5 between a panel and its halves.
    pub const TABLE: Effort = Effort {
        tolerance: 5e-5,
        depth: 6,
        short: 0.02,
        thermal_panel: 4.6,
    };
}

/// ∫P dφ, ∫P cos φ dφ, ∫g dφ, ∫g cos φ dφ.
type Sums = [f64; 4];

/// Coefficients under several laws at one total angle of attack of 0…π rad.
pub fn loads<const K: usize>(
    surface: &Surface,
    laws: &[Law; K],
    alpha_rad: f64,
    effort: Effort,
) -> [Loads; K] {
    let wind = Wind::new(alpha_rad);
    let mut total = [Loads::default(); K];
    for (own, piece) in surface.pieces().iter().enumerate() {
        let mut circle = Circle {
            surface,
            own,
            wind,
            laws,
            thermal_panel: effort.thermal_panel,
            last: None,
        };
        let length = piece.length();
        let mut at = |t| circle.at(piece, t, length);
        let part = if length < effort.short {
            panel(&mut at, [0.0, 1.0])
        } else {
            adaptive(&mut at, effort)
        };
        for (sum, part) in total.iter_mut().zip(part) {
            *sum = sum.mixed(1.0, &part, 1.0);
        }
    }
    if wind.sin == 0.0 {
        // Along the axis there is no side.
        for sum in &mut total {
            (sum.cn, sum.cm) = (0.0, 0.0);
        }
    }
    total
}

/// Circles of latitude on one piece, with what was found for the last one: along a cone it often holds again.
struct Circle<'a, const K: usize> {
    surface: &'a Surface,
    own: usize,
    wind: Wind,
    laws: &'a [Law; K],
    thermal_panel: f64,
    last: Option<([f64; 2], Lit, [Sums; K])>,
}

impl<const K: usize> Circle<'_, K> {
    fn at(&mut self, piece: &Piece, t: f64, length: f64) -> [Loads; K] {
        let station = piece.at(t);
        let facing = windward(&station, self.wind);
        let mut lit = facing;
        if !self.surface.is_outermost(self.own) {
            cast(&mut lit, self.surface, self.own, &station, self.wind);
        }
        let normal = [station.normal_x, station.normal_r];
        let sums = match self.last {
            Some((n, l, sums)) if n == normal && l == lit => sums,
            _ => self.sums(&station, &facing, &lit),
        };
        self.last = Some((normal, lit, sums));
        let Station {
            x,
            r,
            normal_x,
            normal_r,
        } = station;
        let Wind { sin, cos } = self.wind;
        let weight = 8.0 / PI * r * length;
        sums.map(|[p, p_cos, g, g_cos]| Loads {
            ca: weight * (cos * g - normal_x * p),
            cn: weight * (sin * g - normal_r * p_cos),
            cm: weight * ((x * normal_r - r * normal_x) * p_cos + r * cos * g_cos - x * sin * g),
        })
    }

    fn sums(&self, station: &Station, facing: &Lit, lit: &Lit) -> [Sums; K] {
        let p = -station.normal_x * self.wind.cos;
        let q = -station.normal_r * self.wind.sin;
        let mut all = [[0.0; 4]; K];
        for interval in lit.intervals() {
            let moments = cosine_moments(*interval);
            for (sums, law) in all.iter_mut().zip(self.laws) {
                if let Some(powers) = law.powers() {
                    polynomial(sums, [p, q], powers, &moments);
                }
            }
        }
        for (sums, law) in all.iter_mut().zip(self.laws) {
            if let (Law::FreeMolecular(gas), None) = (law, law.powers()) {
                for interval in thermal(facing, lit, [p, q], gas.zone()).intervals() {
                    molecular(sums, gas, [p, q], *interval, self.thermal_panel);
                }
            }
        }
        all
    }
}

/// ∫ cosᵏ φ dφ for k = 0…3 over an interval of cos φ.
fn cosine_moments([low, high]: [f64; 2]) -> [f64; 4] {
    let below = |cos: f64| {
        let phi = acos(cos.clamp(-1.0, 1.0));
        let sin = (1.0 - cos * cos).max(0.0).sqrt();
        [
            phi,
            sin,
            0.5 * (phi + sin * cos),
            sin - sin * sin * sin / 3.0,
        ]
    };
    let (from, to) = (below(high), below(low));
    core::array::from_fn(|k| to[k] - from[k])
}

/// Adds the integrals of P = c₀ + c₁ s + c₂ s², g = c₃ s with s = p + q cos φ, from those of the powers of cos φ.
fn polynomial(sums: &mut Sums, [p, q]: [f64; 2], c: [f64; 4], j: &[f64; 4]) {
    let [c0, c1, c2, c3] = c;
    let (a0, a1, a2) = (
        c0 + c1 * p + c2 * p * p,
        c1 * q + 2.0 * c2 * p * q,
        c2 * q * q,
    );
    sums[0] += a0 * j[0] + a1 * j[1] + a2 * j[2];
    sums[1] += a0 * j[1] + a1 * j[2] + a2 * j[3];
    sums[2] += c3 * (p * j[0] + q * j[1]);
    sums[3] += c3 * (p * j[1] + q * j[2]);
}

/// Region that the molecules reach: the lit side, and beyond a lit horizon as far as thermal motion carries.
fn thermal(facing: &Lit, lit: &Lit, [p, q]: [f64; 2], zone: f64) -> Lit {
    // s = −zone
    let edge = if q == 0.0 { p } else { (-zone - p) / q };
    let whole = if q == 0.0 {
        if p > -zone { [-1.0, 1.0] } else { [0.0, 0.0] }
    } else if q > 0.0 {
        [edge.clamp(-1.0, 1.0), 1.0]
    } else {
        [-1.0, edge.clamp(-1.0, 1.0)]
    };
    // A circle that the air only grazes has no horizon of its own.
    let Some(&[face_low, face_high]) = facing.intervals().first().filter(|[a, b]| b - a > 1e-6)
    else {
        return Lit::new(whole[0], whole[1]);
    };
    let (first, last) = (lit.intervals().first(), lit.intervals().last());
    let near = |a: f64, b: f64| (a - b).abs() < 1e-5;
    let mut reach = Lit::default();
    for interval in lit.intervals() {
        let [mut low, mut high] = *interval;
        if first == Some(interval) && near(low, face_low) {
            low = low.min(whole[0]);
        }
        if last == Some(interval) && near(high, face_high) {
            high = high.max(whole[1]);
        }
        reach.push([low, high]);
    }
    reach
}

/// Adds the integrals of the free-molecular loads over an interval of cos φ.
fn molecular(
    sums: &mut Sums,
    gas: &Gas,
    [p, q]: [f64; 2],
    [low, high]: [f64; 2],
    thermal_panel: f64,
) {
    let zone = gas.zone();
    let cut = |s: f64| {
        if q == 0.0 { f64::NAN } else { (s - p) / q }
    };
    let mut cuts = [low, high, low, low, low];
    for (place, s) in cuts.iter_mut().skip(2).zip([-zone, 0.0, zone]) {
        let cos = cut(s);
        if cos > low && cos < high {
            *place = cos;
        }
    }
    cuts.sort_unstable_by(f64::total_cmp);
    for pair in cuts.windows(2) {
        let &[a, b] = pair else { continue };
        if b <= a {
            continue;
        }
        let middle = p + q * 0.5 * (a + b);
        if middle >= zone {
            polynomial(sums, [p, q], gas.far(), &cosine_moments([a, b]));
        } else if middle > -zone {
            let azimuths = [acos(b.clamp(-1.0, 1.0)), acos(a.clamp(-1.0, 1.0))];
            // e^(−S²s²) has the width 1/S; on the axis s is level, but cos φ bends
            let widths = (b - a) * q.abs() * gas.speed_ratio / thermal_panel;
            let bends = (azimuths[1] - azimuths[0]) / 1.2;
            let panels = widths.max(bends).ceil().clamp(1.0, 40.0) as u32;
            let panel = (azimuths[1] - azimuths[0]) / f64::from(panels);
            for n in 0..panels {
                let from = azimuths[0] + panel * f64::from(n);
                for (phi, weight) in Rule::Gauss8.points([from, from + panel]) {
                    let cos = numerics::math::cos(phi);
                    let [normal, along] = gas.loads(p + q * cos);
                    sums[0] += weight * normal;
                    sums[1] += weight * normal * cos;
                    sums[2] += weight * along;
                    sums[3] += weight * along * cos;
                }
            }
        }
    }
}

fn panel<const K: usize>(f: &mut impl FnMut(f64) -> [Loads; K], ends: [f64; 2]) -> [Loads; K] {
    let mut sum = [Loads::default(); K];
    for (t, weight) in Rule::Gauss5.points(ends) {
        for (sum, value) in sum.iter_mut().zip(f(t)) {
            *sum = sum.mixed(1.0, &value, weight);
        }
    }
    sum
}

/// Integral over 0…1, panels halved until they agree with their halves.
fn adaptive<const K: usize>(f: &mut impl FnMut(f64) -> [Loads; K], effort: Effort) -> [Loads; K] {
    let mut total = [Loads::default(); K];
    let whole = panel(f, [0.0, 1.0]);
    halve(f, effort, ([0.0, 1.0], whole), 0, &mut total);
    total
}

/// Adds the integral over a panel, of which the one of a single panel is known.
fn halve<const K: usize>(
    f: &mut impl FnMut(f64) -> [Loads; K],
    effort: Effort,
    ([a, b], whole): ([f64; 2], [Loads; K]),
    depth: u32,
    total: &mut [Loads; K],
) {
    let m = 0.5 * (a + b);
    let (left, right) = (panel(f, [a, m]), panel(f, [m, b]));
    let mut error: f64 = 0.0;
    for ((w, l), r) in whole.iter().zip(&left).zip(&right) {
        let rest = l.mixed(1.0, r, 1.0).mixed(1.0, w, -1.0);
        error = error
            .max(rest.ca.abs())
            .max(rest.cn.abs())
            .max(rest.cm.abs());
    }
    if error <= effort.tolerance || depth >= effort.depth {
        for ((sum, l), r) in total.iter_mut().zip(&left).zip(&right) {
            *sum = sum.mixed(1.0, &l.mixed(1.0, r, 1.0), 1.0);
        }
    } else {
        halve(f, effort, ([a, m], left), depth + 1, total);
        halve(f, effort, ([m, b], right), depth + 1, total);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axial_force_above_a_point_below_the_axis_lifts_the_nose() {
        let loads = Loads {
            ca: 1.5,
            cn: 0.0,
            cm: 0.0,
        };
        // 1.5 · 0.02
        assert!((loads.cm_about(0.3, 0.02) - 0.03).abs() < 1e-15);
    }
}
