//! Angles at which the moment about the center of gravity vanishes.
//!
//! ```text
//! C_m,cg(α) = 0;   stable where dC_m,cg/dα < 0
//! ```
//!
//! with α the angle of attack in rad, the moment positive where the angle grows.
//!
//! # Valid
//! 0 to 180 deg. Two trims within one step of the search, with the same sign beside them, are missed.
//!
//! # References
//! - \[samareh-2014\] section 3.3.1; \[brent-1973\] for the root.

use numerics::math::{PI, RADIANS_PER_DEGREE};
use numerics::root;
use serde::{Deserialize, Serialize};

/// Step of slopes at 0 and 180 deg, rad.
pub const END_STEP_RAD: f64 = 1e-3;
/// On the axis the moment about a point of the axis vanishes by symmetry, but for rounding.
const NOTHING: f64 = 1e-9;
/// Slope that is rounding: a sphere about its center is stable nowhere, per rad.
const NEUTRAL_PER_RAD: f64 = 1e-6;
/// Part of the rise over a secant that may be left of the moment at its root: 2 % of its length.
const STRAIGHT: f64 = 0.02;

/// An angle at which the moment about the center of gravity vanishes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Trim {
    /// Angle of attack, deg.
    pub alpha_deg: f64,
    /// Slope of the moment, per rad; negative is stable.
    pub cm_alpha_per_rad: f64,
}

impl Trim {
    /// Whether a disturbed body returns to it.
    pub fn is_stable(&self) -> bool {
        self.cm_alpha_per_rad < -NEUTRAL_PER_RAD
    }

    /// `stable`, `unstable` or `neutral`.
    pub fn word(&self) -> &'static str {
        if self.is_stable() {
            "stable"
        } else if self.cm_alpha_per_rad > NEUTRAL_PER_RAD {
            "unstable"
        } else {
            "neutral"
        }
    }
}

/// Settings of the search for trims.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Search {
    /// Steps from 0 to 180 deg.
    pub steps: u32,
    /// Tolerance of the root of the coarse moment, rad.
    pub tolerance_rad: f64,
    /// Step of slopes, and of the last correction by the fine moment, rad.
    pub slope_step_rad: f64,
}

/// Every trim from 0 to 180 deg of a moment against the angle, rad: sought by `coarse`, corrected by one secant of `fine`, which
/// also gives the slopes. Both are odd about 0 and 180 deg where they vanish there.
pub fn trims(coarse: &dyn Fn(f64) -> f64, fine: &dyn Fn(f64) -> f64, search: Search) -> Vec<Trim> {
    let nothing = |moment: f64| moment.abs() < NOTHING;
    let at = |n: u32| PI * (f64::from(n) / f64::from(search.steps));
    let h = END_STEP_RAD;
    let end = |alpha_deg: f64, cm_alpha_per_rad: f64| Trim {
        alpha_deg,
        cm_alpha_per_rad,
    };
    let mut found = Vec::new();
    let (mut before, mut from) = (coarse(0.0), 0.0);
    if nothing(before) {
        // Just beside zero the moment has the sign of its slope.
        (before, from) = (coarse(h), h);
        found.push(end(0.0, fine(h) / h));
    }
    for n in 1..=search.steps {
        let (mut here, mut to, mut last) = (coarse(at(n)), at(n), None);
        if n == search.steps && nothing(here) {
            (here, to) = (coarse(PI - h), PI - h);
            last = Some(end(180.0, -fine(PI - h) / h));
        }
        if nothing(here) && n < search.steps {
            // A trim at a step is found between its neighbors.
            continue;
        }
        if !nothing(before) && before * here < 0.0 {
            let root = root::brent(coarse, from, to, search.tolerance_rad);
            found.extend(root.map(|alpha| corrected(fine, alpha, [from, to], search)));
        }
        (before, from) = (here, to);
        found.extend(last);
    }
    found
}

/// The trim of the fine moment about a coarse root: on its secant, or where that is no root, by Brent's method.
fn corrected(fine: &dyn Fn(f64) -> f64, alpha: f64, ends: [f64; 2], search: Search) -> Trim {
    let h = search.slope_step_rad;
    let (low, high) = (fine(alpha - h), fine(alpha + h));
    let rise = high - low;
    let step = -h * (high + low) / rise;
    let on_secant = alpha + step;
    let is_root = step.abs() <= h && fine(on_secant).abs() <= STRAIGHT * rise.abs();
    let brent = |[a, b]: [f64; 2]| root::brent(fine, a, b, search.tolerance_rad);
    let found = if is_root {
        Some(on_secant)
    } else {
        brent([alpha - h, alpha + h]).or_else(|| brent(ends))
    };
    Trim {
        alpha_deg: found.unwrap_or(alpha) / RADIANS_PER_DEGREE,
        cm_alpha_per_rad: rise / (2.0 * h),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use numerics::math::{sin, sin_cos};

    const SEARCH: Search = Search {
        steps: 24,
        tolerance_rad: 1e-9,
        slope_step_rad: 1e-4,
    };

    #[test]
    fn trims_of_a_moment_in_closed_form() {
        // −sin α cos α − 0.5 sin α = 0 at 0, 120 and 180 deg; slopes −cos 2α − 0.5 cos α: −1.5, 0.75, −0.5
        let moment = |a: f64| {
            let (s, c) = sin_cos(a);
            -s * c - 0.5 * s
        };
        let found = trims(&moment, &moment, SEARCH);
        let want = [
            (0.0, -1.5, "stable"),
            (120.0, 0.75, "unstable"),
            (180.0, -0.5, "stable"),
        ];
        assert_eq!(found.len(), want.len(), "{found:?}");
        for (trim, (alpha_deg, slope, word)) in found.iter().zip(want) {
            assert!((trim.alpha_deg - alpha_deg).abs() < 1e-6, "{found:?}");
            assert!((trim.cm_alpha_per_rad - slope).abs() < 1e-5, "{found:?}");
            assert_eq!(trim.word(), word);
        }
    }

    #[test]
    fn a_trim_beside_the_ends_is_found() {
        // sin α (cos 1° − cos α): slopes cos 1° − 1 at 0, sin² 1° at 1 deg and −(cos 1° + 1) at 180 deg
        let edge = numerics::math::cos(RADIANS_PER_DEGREE);
        let moment = |a: f64| {
            let (s, c) = sin_cos(a);
            s * (edge - c)
        };
        let found = trims(&moment, &moment, SEARCH);
        let angles: Vec<f64> = found
            .iter()
            .map(|t| (t.alpha_deg * 1e4).round() / 1e4)
            .collect();
        assert_eq!(angles, [0.0, 1.0, 180.0]);
        let words: Vec<_> = found.iter().map(Trim::word).collect();
        assert_eq!(words, ["stable", "unstable", "stable"]);
    }

    #[test]
    fn a_coarse_root_is_corrected() {
        // sin 2α turned by 0.5 deg either way: coarse root at 90.5, fine one at 89.5 deg
        let turned = |by_deg: f64| move |a: f64| sin(2.0 * (a - by_deg * RADIANS_PER_DEGREE));
        let search = Search {
            slope_step_rad: 0.02,
            ..SEARCH
        };
        let found = trims(&turned(0.5), &turned(-0.5), search);
        // The secant over 0.04 rad leaves its cubic part: (2 · 0.0175)³/6 rad
        assert!(
            found.iter().any(|t| (t.alpha_deg - 89.5).abs() < 1e-3),
            "{found:?}"
        );
    }

    #[test]
    fn no_moment_is_neutral() {
        let found = trims(&|_| 0.0, &|_| 0.0, SEARCH);
        assert_eq!(found.len(), 2);
        assert!(found.iter().all(|t| t.word() == "neutral"));
    }
}
