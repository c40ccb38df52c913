//! Drag and lift of a body of revolution at its trim angle of attack, tabulated beforehand.
//!
//! ```text
//! C_m(α) + C_N(α) x/D + C_A(α) e/D = 0
//! C_D = C_A cos α + C_N sin α,   C_L = |C_N cos α − C_A sin α|
//! ```
//!
//! with α the angle of trim in rad, x the center of gravity aft of the virtual apex and e its distance from the axis in m, D
//! the diameter in m, coefficients about the virtual apex. Both are linear in log₁₀ M and log₁₀ Kn between the nodes of a
//! grid, so that a flight at trim costs what a flight of a point mass does.
//!
//! # Valid
//! Trim between 0 and 90 deg, nose first. Where there is none, the angle is that of the smallest moment. The lift is
//! rotated by the angle of bank; at 0 deg it points up.
//!
//! # References
//! - \[samareh-2014\] section 3.3.1.

use super::equations::{Equations, Surroundings};
use super::lift::DragAndLift;
use super::reach::{Axis, of_database};
use crate::aero::bridging::{CONTINUUM, FREE_MOLECULAR};
use crate::aero::database::Database;
use numerics::math;
use numerics::math::{FRAC_PI_2, RADIANS_PER_DEGREE};
use numerics::root;
use numerics::scalar::Scalar;

/// Mach numbers of the grid: from, to, intervals.
const MACH: ([f64; 2], usize) = ([0.05, 60.0], 120);
/// Intervals of the Knudsen number, whose ends are those of the bridging.
const KNUDSEN_INTERVALS: usize = 24;
/// Step of the search for trim, deg.
const STEP_DEG: f64 = 5.0;

/// Coefficients at trim.
#[derive(Clone, Debug, PartialEq)]
pub struct Trim {
    diameter_m: f64,
    /// Axes of the table of the case from which it comes, if it does.
    pub axes: Vec<Axis>,
    /// One row per Mach number, one entry per Knudsen number: drag and lift coefficient, trim angle in rad.
    grid: Vec<Vec<[f64; 3]>>,
}

impl Trim {
    /// The trim of a database with the center of gravity `cg_m`: x aft of the virtual apex, y and z off the axis, m.
    pub fn new(database: &Database, [x, y, z]: [f64; 3]) -> Trim {
        let ([low, high], intervals) = MACH;
        let node = |ends: [f64; 2], i: usize, n: usize| {
            let [a, b] = ends.map(math::log10);
            math::pow(10.0, a + (b - a) * i as f64 / n as f64)
        };
        let off_axis_m = (y * y + z * z).sqrt();
        let grid = (0..=intervals)
            .map(|i| {
                let mach = node([low, high], i, intervals);
                (0..=KNUDSEN_INTERVALS)
                    .map(|j| {
                        let knudsen = node([CONTINUUM, FREE_MOLECULAR], j, KNUDSEN_INTERVALS);
                        at_trim(database, [mach, knudsen], [x, off_axis_m])
                    })
                    .collect()
            })
            .collect();
        Trim {
            diameter_m: database.diameter_m,
            axes: of_database(database),
            grid,
        }
    }

    /// Drag, lift and angle of trim, rad, at a Mach and a Knudsen number.
    #[inline]
    pub fn coefficients<S: Scalar>(&self, mach: S, knudsen: S) -> [S; 3] {
        let (ends, intervals) = MACH;
        let t = place(mach, ends, intervals);
        let s = place(knudsen, [CONTINUUM, FREE_MOLECULAR], KNUDSEN_INTERVALS);
        let [i, j, cell @ ..]: [S; 14] = t.lookup_pair(s, |t, s| self.cell(t, s));
        let (u, v) = (t - i, s - j);
        let one = S::constant(1.0);
        core::array::from_fn(|k| {
            let [a, b, c, d] = [cell[k], cell[3 + k], cell[6 + k], cell[9 + k]];
            (one - v) * ((one - u) * a + u * b) + v * ((one - u) * c + u * d)
        })
    }

    /// Indices of the cell of two places, and the coefficients at its corners.
    fn cell(&self, t: f64, s: f64) -> [f64; 14] {
        let (i, j) = (
            (t as usize).min(MACH.1 - 1),
            (s as usize).min(KNUDSEN_INTERVALS - 1),
        );
        let corner = |i: usize, j: usize| {
            let row = self.grid.get(i);
            row.and_then(|row| row.get(j)).copied().unwrap_or_default()
        };
        let [a, b, c, d] = [
            corner(i, j),
            corner(i + 1, j),
            corner(i, j + 1),
            corner(i + 1, j + 1),
        ];
        [
            i as f64, j as f64, a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2], d[0], d[1],
            d[2],
        ]
    }

    /// Drag and lift at one state of a flight.
    #[inline]
    pub fn at<S: Scalar>(
        &self,
        equations: &Equations<S>,
        around: &Surroundings<S>,
    ) -> DragAndLift<S> {
        let [mach, knudsen] = self.mach_knudsen(equations, around);
        let [drag, lift, _] = self.coefficients(mach, knudsen);
        DragAndLift { drag, lift }
    }

    /// Mach and Knudsen number at one state.
    #[inline]
    pub fn mach_knudsen<S: Scalar>(
        &self,
        equations: &Equations<S>,
        around: &Surroundings<S>,
    ) -> [S; 2] {
        let air = equations.air(around.altitude_m);
        [
            around.air_speed_m_s / air.speed_of_sound_m_s,
            air.mean_free_path_m / self.diameter_m,
        ]
    }
}

/// Number of intervals from the beginning of the grid, in the logarithm, held beyond the ends.
#[inline]
fn place<S: Scalar>(x: S, ends: [f64; 2], intervals: usize) -> S {
    let [a, b] = ends;
    let held = x.clamp(S::constant(a), S::constant(b));
    (held / a).ln() / math::ln(b / a) * intervals as f64
}

/// Drag, lift and angle at which the moment about the center of gravity vanishes.
fn at_trim(database: &Database, [mach, knudsen]: [f64; 2], [x, off_axis_m]: [f64; 2]) -> [f64; 3] {
    let d = database.diameter_m;
    let moment = |alpha: f64| {
        let c = database.coefficients(mach, knudsen, alpha);
        c.cm + (c.cn * x + c.ca * off_axis_m) / d
    };
    let alpha = if off_axis_m == 0.0 {
        0.0
    } else {
        let step = STEP_DEG * RADIANS_PER_DEGREE;
        let mut found = None;
        let (mut least, mut before) = ((f64::INFINITY, 0.0), moment(0.0));
        let mut alpha = 0.0;
        while found.is_none() && alpha < FRAC_PI_2 {
            let next = alpha + step;
            let here = moment(next);
            if before > 0.0 && here <= 0.0 {
                found = root::brent(moment, alpha, next, 1e-12);
            }
            if here.abs() < least.0 {
                least = (here.abs(), next);
            }
            (alpha, before) = (next, here);
        }
        found.unwrap_or(least.1)
    };
    let c = database.coefficients(mach, knudsen, alpha);
    let (sin, cos) = math::sin_cos(alpha);
    [
        c.ca * cos + c.cn * sin,
        (c.cn * cos - c.ca * sin).abs(),
        alpha,
    ]
}
