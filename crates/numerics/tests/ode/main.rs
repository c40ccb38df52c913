//! The integrators as a whole: accuracy, the course of the steps, events and retakes, faults.

mod accuracy;
mod course;
mod events;
mod faults;
mod lanes;

use numerics::math;
use numerics::ode::{Method, Tolerance};

const METHODS: [Method; 3] = [
    Method::DormandPrince54,
    Method::DormandPrince853,
    Method::Rk4 { step: 0.01 },
];

/// Tolerances that these problems always meet: the step is set by the limit.
fn loose<const N: usize>() -> Tolerance<N> {
    Tolerance {
        relative: [0.0; N],
        absolute: [1e3; N],
    }
}

fn tight<const N: usize>(tolerance: f64) -> Tolerance<N> {
    Tolerance {
        relative: [tolerance; N],
        absolute: [tolerance; N],
    }
}

/// y' = y cos t, y = exp(sin t).
fn wave(t: f64, y: &[f64; 1]) -> [f64; 1] {
    [y[0] * math::cos(t)]
}

fn wave_exact(t: f64) -> f64 {
    math::exp(math::sin(t))
}

/// A pendulum: u'' = -sin u.
fn pendulum(_: f64, y: &[f64; 2]) -> [f64; 2] {
    [y[1], -math::sin(y[0])]
}

fn with_step(method: Method, h: f64) -> Method {
    match method {
        Method::Rk4 { .. } => Method::Rk4 { step: h },
        adaptive => adaptive,
    }
}

/// The restricted problem of three bodies, Earth and Moon.
fn arenstorf(_: f64, y: &[f64; 4]) -> [f64; 4] {
    let mu = 0.012277471;
    let [y1, y2, v1, v2] = *y;
    let (d1, d2) = (
        (y1 + mu) * (y1 + mu) + y2 * y2,
        (y1 - (1.0 - mu)) * (y1 - (1.0 - mu)) + y2 * y2,
    );
    let (d1, d2) = (d1 * d1.sqrt(), d2 * d2.sqrt());
    let a1 = y1 + 2.0 * v2 - (1.0 - mu) * (y1 + mu) / d1 - mu * (y1 - (1.0 - mu)) / d2;
    let a2 = y2 - 2.0 * v1 - (1.0 - mu) * y2 / d1 - mu * y2 / d2;
    [v1, v2, a1, a2]
}
