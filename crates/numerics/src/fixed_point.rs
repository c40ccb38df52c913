//! Fixed points of several variables by Anderson acceleration of depth two.
//!
//! ```text
//! r = f(x) − x
//! γ = argmin |r − Σ γⱼ Δrⱼ|
//! x ← x − Σ γⱼ Δxⱼ + ω (r − Σ γⱼ Δrⱼ)
//! ```
//!
//! with Δxⱼ, Δrⱼ the last two steps and what they did to the residual r, each variable in parts of its own size; ω the
//! relaxation. Without steps to learn from it is the damped step x ← x + ω r, and so it is again after an accelerated
//! step that overshot, to a larger residual in the opposite direction; each such step halves ω, down to an eighth, each
//! other doubles it again. Where the steps show that the fixed point lies behind, against r, it is one that f leaves:
//! then x moves along the last change of f, twice as far each time, to the next fixed point or to where f ends. An
//! accelerated step is shortened to twenty residuals and to twice or half of a variable.
//!
//! # References
//! - \[anderson-1965\]; \[walker-ni-2011\].

/// Steps that are remembered.
const DEPTH: usize = 2;
/// Least relaxation, as a fraction of the one requested.
const LEAST_RELAXATION: f64 = 0.125;
/// Two steps whose residuals differ by less than the angle with this squared sine are one.
const PARALLEL: f64 = 1e-6;
/// Longest accelerated step, in damped steps: 1 / (1 − G) with G = 0.95.
const LONGEST: f64 = 20.0;
/// An accelerated step divides or multiplies a variable by no more than this.
const LARGEST_CHANGE: f64 = 2.0;

/// A step of a variable vector and what it changed.
#[derive(Clone, Debug)]
struct Step<const N: usize> {
    dx: [f64; N],
    dr: [f64; N],
    dwatched: f64,
}

/// A place that was visited.
#[derive(Clone, Debug)]
struct Place<const N: usize> {
    x: [f64; N],
    r: [f64; N],
    watched: f64,
}

/// Next variables, and their estimated distance from the fixed point.
#[derive(Clone, Debug, PartialEq)]
pub struct Proposal<const N: usize> {
    /// The next variables.
    pub next: [f64; N],
    /// The damped step alone, for cases in which `next` is not usable.
    pub damped: [f64; N],
    /// Estimated distance of the watched number from its value at the fixed point, from the remembered steps; absent
    /// while there are none. The part of the residual that they leave unexplained counts as much as the steepest of
    /// them.
    pub distance: Option<f64>,
}

/// The iteration: its memory of steps and its relaxation.
#[derive(Clone, Debug)]
pub struct Anderson<const N: usize> {
    relaxation: f64,
    least_relaxation: f64,
    largest_relaxation: f64,
    steps: Vec<Step<N>>,
    place: Option<Place<N>>,
    accelerated: bool,
    /// Length of a step away from a fixed point behind, in last changes of f.
    stride: f64,
}

impl<const N: usize> Anderson<N> {
    /// An iteration with this relaxation, the part of a residual that a step without memory takes.
    pub fn new(relaxation: f64) -> Self {
        Self {
            relaxation,
            least_relaxation: LEAST_RELAXATION * relaxation,
            largest_relaxation: relaxation,
            steps: Vec::new(),
            place: None,
            accelerated: false,
            stride: 1.0,
        }
    }

    /// Tells that the next value is of another, similar function: the steps are kept, the one between the two is not.
    pub fn change_function(&mut self) {
        self.place = None;
    }

    /// Forgets every step.
    pub fn forget(&mut self) {
        self.steps.clear();
    }

    /// Proposes the next variables from x, f(x) and a number that is watched, such as the mass of a vehicle.
    pub fn propose(&mut self, x: [f64; N], fx: [f64; N], watched: f64) -> Proposal<N> {
        let r: [f64; N] = std::array::from_fn(|i| fx[i] - x[i]);
        let size: [f64; N] = std::array::from_fn(|i| {
            let largest = x[i].abs().max(fx[i].abs());
            if largest > 0.0 { largest } else { 1.0 }
        });
        let worse = self.learn(Place { x, r, watched }, &size);
        let factor = if worse { 0.5 } else { 2.0 };
        self.relaxation =
            (factor * self.relaxation).clamp(self.least_relaxation, self.largest_relaxation);
        let damped = std::array::from_fn(|i| x[i] + self.relaxation * r[i]);
        let gamma = self.coefficients(&r, &size);
        let explained = |part: fn(&Step<N>) -> &[f64; N], i: usize| -> f64 {
            self.steps
                .iter()
                .zip(gamma)
                .map(|(step, gamma)| gamma * part(step)[i])
                .sum()
        };
        let rest: [f64; N] = std::array::from_fn(|i| r[i] - explained(|step| &step.dr, i));
        let mut far: [f64; N] =
            std::array::from_fn(|i| self.relaxation * rest[i] - explained(|step| &step.dx, i));
        if dot(&far, &r, &size) < 0.0 {
            // a fixed point behind is one that f leaves: the next one lies where f goes
            self.stride *= 2.0;
            let newest = self.steps.first();
            let change = |i: usize| newest.map_or(0.0, |step| step.dx[i] + step.dr[i]);
            far = std::array::from_fn(|i| r[i] + self.stride * change(i));
            if dot(&far, &r, &size) < 0.0 {
                far = r;
            }
        } else {
            self.stride = 1.0;
        }
        let part = allowed(&x, &far, &r, &size);
        let accelerated: [f64; N] = std::array::from_fn(|i| x[i] + part * far[i]);
        let distance: f64 = self
            .steps
            .iter()
            .zip(gamma)
            .map(|(step, gamma)| gamma * step.dwatched)
            .sum();
        // a damped step that made it worse has taught the slope that the next one needs
        let misled = worse && self.accelerated;
        self.accelerated = !self.steps.is_empty() && !misled;
        Proposal {
            next: if self.accelerated {
                accelerated
            } else {
                damped
            },
            damped,
            distance: (!self.steps.is_empty())
                .then(|| distance.abs() + self.slope(&size) * largest(&rest, &size)),
        }
    }

    /// Remembers the step to this place; whether it left a larger residual.
    fn learn(&mut self, place: Place<N>, size: &[f64; N]) -> bool {
        let mut worse = false;
        if let Some(before) = &self.place {
            // a larger residual in the same direction is no overshoot
            worse = square(&place.r, size) > square(&before.r, size)
                && dot(&place.r, &before.r, size) < 0.0;
            let step = Step {
                dx: std::array::from_fn(|i| place.x[i] - before.x[i]),
                dr: std::array::from_fn(|i| place.r[i] - before.r[i]),
                dwatched: place.watched - before.watched,
            };
            if square(&step.dr, size) > 0.0 {
                self.steps.insert(0, step);
                self.steps.truncate(DEPTH);
            }
        }
        self.place = Some(place);
        worse
    }

    /// Steepest change of the watched number per relative change of a variable.
    fn slope(&self, size: &[f64; N]) -> f64 {
        let slopes = self.steps.iter().map(|step| {
            let part = largest(&step.dx, size);
            if part > 0.0 {
                (step.dwatched / part).abs()
            } else {
                0.0
            }
        });
        slopes.fold(0.0, f64::max)
    }

    /// γ of the remembered steps, the newest first; zero for an older step nearly parallel to it.
    fn coefficients(&self, r: &[f64; N], size: &[f64; N]) -> [f64; DEPTH] {
        let Some(newest) = self.steps.first() else {
            return [0.0; DEPTH];
        };
        let a = square(&newest.dr, size);
        let p = dot(&newest.dr, r, size);
        let alone = [p / a, 0.0];
        let Some(older) = self.steps.get(1) else {
            return alone;
        };
        let b = dot(&newest.dr, &older.dr, size);
        let c = square(&older.dr, size);
        let q = dot(&older.dr, r, size);
        let determinant = a * c - b * b;
        if determinant > PARALLEL * a * c {
            [(p * c - q * b) / determinant, (q * a - p * b) / determinant]
        } else {
            alone
        }
    }
}

/// Fraction of a step that is neither much longer than the residual nor changes a variable by much.
fn allowed<const N: usize>(x: &[f64; N], step: &[f64; N], r: &[f64; N], size: &[f64; N]) -> f64 {
    let length = square(step, size).sqrt();
    let longest = LONGEST * square(r, size).sqrt();
    let mut part = if length > longest {
        longest / length
    } else {
        1.0
    };
    for (x, step) in x.iter().zip(step) {
        let most = if step * x < 0.0 {
            (1.0 - 1.0 / LARGEST_CHANGE) * x.abs()
        } else {
            (LARGEST_CHANGE - 1.0) * x.abs()
        };
        if most > 0.0 && step.abs() > most {
            part = part.min(most / step.abs());
        }
    }
    part
}

fn dot<const N: usize>(a: &[f64; N], b: &[f64; N], size: &[f64; N]) -> f64 {
    (0..N).map(|i| (a[i] / size[i]) * (b[i] / size[i])).sum()
}

/// Largest part of a variable.
fn largest<const N: usize>(a: &[f64; N], size: &[f64; N]) -> f64 {
    (0..N).fold(0.0, |most: f64, i| most.max((a[i] / size[i]).abs()))
}

fn square<const N: usize>(a: &[f64; N], size: &[f64; N]) -> f64 {
    dot(a, a, size)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{cos, exp};

    fn passes(relaxation: f64, f: impl Fn([f64; 2]) -> [f64; 2], start: [f64; 2]) -> usize {
        let mut anderson = Anderson::new(relaxation);
        let mut x = start;
        for pass in 1..=200 {
            let fx = f(x);
            if (0..2).all(|i| (fx[i] - x[i]).abs() < 1e-12) {
                return pass;
            }
            x = anderson.propose(x, fx, x[0]).next;
        }
        200
    }

    #[test]
    fn a_fixed_point_that_f_leaves_is_left() {
        // x = 1, where f has the slope 1/2, and x = 3, where it has 3/2
        let mut anderson = Anderson::new(1.0);
        let f = |x: f64| 0.25 * x * x + 0.75;
        let mut x = 2.9;
        for _ in 0..12 {
            x = anderson.propose([x], [f(x)], 0.0).next[0];
        }
        assert!((x - 1.0).abs() < 1e-6, "{x}");
        let mut anderson = Anderson::new(1.0);
        let mut x = 3.1;
        for _ in 0..12 {
            let next = anderson.propose([x], [f(x)], 0.0).next[0];
            assert!(next > x, "{next} after {x}");
            x = next;
        }
        assert!(x > 100.0, "{x}");
    }

    #[test]
    fn linear_map_of_rank_one_is_solved_once_its_slope_is_known() {
        // x = 1 + 0.9 y, y = 2 + 0.9 y has y = 20, x = 19; the damped iteration needs 260 passes to 1e-12
        let f = |x: [f64; 2]| [1.0 + 0.9 * x[1], 2.0 + 0.9 * x[1]];
        let mut anderson = Anderson::new(1.0);
        let mut x = [10.0, 15.0];
        for _ in 0..2 {
            x = anderson.propose(x, f(x), x[0]).next;
        }
        let proposal = anderson.propose(x, f(x), x[0]);
        let [a, b] = proposal.next;
        assert!(
            (a - 19.0).abs() < 1e-9 && (b - 20.0).abs() < 1e-9,
            "{a} {b}"
        );
        let distance = proposal.distance.unwrap();
        assert!((distance - (19.0 - x[0]).abs()).abs() < 1e-9, "{distance}");
    }

    #[test]
    fn settles_where_plain_passes_do_and_where_they_do_not() {
        let gentle = |[a, b]: [f64; 2]| [cos(b), 0.5 + 0.3 * exp(-a)];
        assert!(passes(1.0, gentle, [1.0, 1.0]) <= 10);
        for relaxation in [0.05, 0.3, 1.0, 1.5] {
            assert!(passes(relaxation, gentle, [1.0, 1.0]) <= 12, "{relaxation}");
        }
        // slopes of -1.5 and -1.4: each plain pass is further away than the one before
        let steep = |[a, b]: [f64; 2]| [2.5 - 1.5 * b, 2.4 - 1.4 * a];
        assert!(passes(1.0, steep, [1.1, 0.95]) <= 12);
    }

    #[test]
    fn an_accelerated_step_that_overshoots_is_followed_by_a_damped_one() {
        let mut anderson = Anderson::new(1.0);
        anderson.propose([1.0], [1.1], 0.0);
        // slope 0.5: 1.1 + 0.05 / (1 - 0.5)
        let next = anderson.propose([1.1], [1.15], 0.0).next;
        assert!((next[0] - 1.2).abs() < 1e-12);
        let proposal = anderson.propose([1.2], [0.8], 0.0);
        assert_eq!(proposal.next, proposal.damped);
        // half of the residual -0.4
        assert!((proposal.damped[0] - 1.0).abs() < 1e-12);
    }

    #[test]
    fn a_step_between_two_functions_is_not_learned() {
        let mut anderson = Anderson::new(1.0);
        anderson.propose([1.0], [1.2], 0.0);
        anderson.change_function();
        assert_eq!(anderson.propose([1.2], [1.3], 0.0).distance, None);
    }
}
