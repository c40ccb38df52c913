//! Tests of the whole: orders of convergence, a published orbit, events, retakes, faults.

use super::event::{Direction, crossing};
use super::*;
use crate::math;

const METHODS: [Method; 3] = [
    Method::DormandPrince54,
    Method::DormandPrince853,
    Method::Rk4 { step: 0.01 },
];

/// No error is too large: the step is what the limit makes it.
fn loose<const N: usize>() -> Tolerance<N> {
    Tolerance {
        relative: [1e6; N],
        absolute: [1e6; N],
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

/// Error at 2 with `n` steps of equal length.
fn error_of_equal_steps(method: Method, n: u32) -> f64 {
    let h = 2.0 / f64::from(n);
    let mut integrator = Integrator::new(with_step(method, h), loose(), 0.0, [1.0]);
    for i in 1..=n {
        integrator
            .step(&mut wave, 2.0 * f64::from(i) / f64::from(n))
            .unwrap();
    }
    assert_eq!(
        (integrator.t(), integrator.statistics().accepted),
        (2.0, u64::from(n))
    );
    (integrator.y()[0] - wave_exact(2.0)).abs()
}

/// Largest error within one step of length `h`, from exact values.
fn error_within_step(method: Method, h: f64) -> f64 {
    let t0 = 0.3;
    let mut integrator = Integrator::new(with_step(method, h), loose(), t0, [wave_exact(t0)]);
    let step = integrator.step(&mut wave, t0 + h).unwrap();
    assert_eq!(step.t1, t0 + h);
    let error = |i: u32| {
        let t = t0 + h * f64::from(i) / 20.0;
        (step.component(0, t) - wave_exact(t)).abs()
    };
    (0..=20).map(error).fold(0.0, f64::max)
}

fn order(coarse: f64, fine: f64) -> f64 {
    math::ln(coarse / fine) / math::ln(2.0)
}

#[test]
fn errors_fall_with_orders_5_8_and_4() {
    for (method, n, expected) in [
        (METHODS[0], 32, 5.0),
        (METHODS[1], 4, 8.0),
        (METHODS[2], 64, 4.0),
    ] {
        let observed = order(
            error_of_equal_steps(method, n),
            error_of_equal_steps(method, 2 * n),
        );
        // The next order of the error weighs a few tenths at these steps.
        assert!((observed - expected).abs() < 0.5, "{method:?}: {observed}");
    }
}

#[test]
fn dense_outputs_have_orders_4_7_and_3() {
    // The error within one step falls with one order more.
    for (method, h, expected) in [
        (METHODS[0], 0.2, 5.0),
        (METHODS[1], 0.4, 8.0),
        (METHODS[2], 0.1, 4.0),
    ] {
        let observed = order(
            error_within_step(method, h),
            error_within_step(method, h / 2.0),
        );
        assert!((observed - expected).abs() < 0.5, "{method:?}: {observed}");
    }
}

#[test]
fn dense_output_ends_on_the_states_and_slopes() {
    for method in METHODS {
        let mut integrator = Integrator::new(method, tight(1e-6), 0.0, [1.0, 0.5]);
        let step = integrator.step(&mut pendulum, 0.01).unwrap();
        assert_eq!(step.at(step.t0), step.y0);
        assert_eq!(step.at(step.t1), step.y1);
        let d = 1e-5 * (step.t1 - step.t0);
        let slope = (step.component(0, step.t1) - step.component(0, step.t1 - d)) / d;
        // One-sided difference: half of y'' d, and the rounding over d.
        assert!((slope - step.y1[1]).abs() < 1e-6 + 1e-15 / d, "{method:?}");
    }
}

#[test]
fn polynomials_are_integrated_exactly_up_to_the_order() {
    // y' = 5 t⁴ from 0 to 2: 32; for the order 8: y' = 8 t⁷: 256; for RK4 (Simpson): y' = 4 t³: 16.
    for (method, power, expected) in [
        (METHODS[0], 4, 32.0),
        (METHODS[1], 7, 256.0),
        (METHODS[2], 3, 16.0),
    ] {
        let mut slope = |t: f64, _: &[f64; 1]| [f64::from(power + 1) * math::powi(t, power)];
        let mut integrator = Integrator::new(with_step(method, 2.0), loose(), 0.0, [0.0]);
        while integrator.t() < 2.0 {
            integrator.step(&mut slope, 2.0).unwrap();
        }
        assert!(
            (integrator.y()[0] / expected - 1.0).abs() < 4e-15,
            "{method:?}: {:?}",
            integrator.y()
        );
    }
}

#[test]
fn linear_oscillator_returns_after_a_turn_within_its_tolerance() {
    for method in [Method::DormandPrince54, Method::DormandPrince853] {
        for tolerance in [1e-6, 1e-9, 1e-12] {
            let mut integrator = Integrator::new(method, tight(tolerance), 0.0, [1.0, 0.0]);
            while integrator.t() < 2.0 * math::PI {
                integrator
                    .step(&mut |_, y: &[f64; 2]| [y[1], -y[0]], 2.0 * math::PI)
                    .unwrap();
            }
            let [u, v] = *integrator.y();
            // The error of each of some tens of steps is below the tolerance, those of a turn add up.
            assert!(
                math::hypot(u - 1.0, v) < 50.0 * tolerance,
                "{method:?} {tolerance}: {u} {v}"
            );
        }
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

#[test]
fn arenstorf_orbit_closes() {
    // Hairer, Norsett, Wanner, eq. II.0.2: initial state and period.
    let start = [0.994, 0.0, 0.0, -2.00158510637908252240537862224];
    let period = 17.0652165601579625588917206249;
    for (method, most_evaluations) in [
        (Method::DormandPrince54, 7000),
        (Method::DormandPrince853, 4500),
    ] {
        let mut integrator = Integrator::new(method, tight(1e-11), 0.0, start);
        while integrator.t() < period {
            integrator.step(&mut arenstorf, period).unwrap();
        }
        let distance = math::hypot(integrator.y()[0] - start[0], integrator.y()[1] - start[1]);
        // The orbit magnifies errors by some 1e5 or more over a period.
        assert!(distance < 2e-5, "{method:?}: {distance}");
        let spent = integrator.statistics();
        assert!(
            spent.evaluations < most_evaluations,
            "{method:?}: {spent:?}"
        );
    }
}

#[test]
fn statistics_count_every_evaluation() {
    for (method, per_step) in [(Method::DormandPrince54, 6), (Method::DormandPrince853, 15)] {
        let mut calls = 0;
        let mut f = |t: f64, y: &[f64; 4]| {
            calls += 1;
            arenstorf(t, y)
        };
        let mut integrator = Integrator::new(method, tight(1e-6), 0.0, [0.994, 0.0, 0.0, -2.0]);
        for _ in 0..50 {
            integrator.step(&mut f, 10.0).unwrap();
        }
        let Statistics {
            accepted,
            rejected,
            evaluations,
        } = integrator.statistics();
        assert_eq!((accepted, evaluations), (50, calls));
        assert!(evaluations >= 2 + per_step * 50 && evaluations <= 2 + per_step * (50 + rejected));
    }
}

#[test]
fn hermite_dense_output_saves_three_evaluations_a_step_and_changes_no_state() {
    let run = |dense: Dense| {
        let mut integrator =
            Integrator::new(Method::DormandPrince853, tight(1e-9), 0.0, [1.0, 0.5])
                .with_dense(dense);
        while integrator.t() < 10.0 {
            integrator.step(&mut pendulum, 10.0).unwrap();
        }
        (*integrator.y(), integrator.statistics())
    };
    let ((full, spent), (hermite, less)) = (run(Dense::Full), run(Dense::Hermite));
    assert_eq!(full, hermite);
    assert_eq!(spent.evaluations - less.evaluations, 3 * spent.accepted);
}

#[test]
fn thrown_body_is_at_its_top_and_lands_when_it_must() {
    // Up at 20 m/s under 10 m/s²: top after 2 s at 20 m, ground after 4 s.
    for method in METHODS {
        let mut fall = |_: f64, y: &[f64; 2]| [y[1], -10.0];
        let mut integrator = Integrator::new(method, tight(1e-9), 0.0, [0.0, 20.0]);
        let (mut top, mut ground) = (None, None);
        while ground.is_none() {
            let step = integrator.step(&mut fall, 100.0).unwrap();
            top = top
                .or(crossing(&step, |_, y| y[1], Direction::Falling)
                    .map(|t| [t, step.component(0, t)]));
            // The start, at height 0, is no landing.
            ground = crossing(&step, |_, y| y[0], Direction::Falling).or((step.t0 == 0.0
                && step.y1[0] < 0.0)
                .then(|| {
                    // The first step flew past the landing: from its top on.
                    let t_top = top.map_or(2.0, |[t, _]| t);
                    crate::root::brent(|t| step.component(0, t), t_top, step.t1, 1e-13)
                        .unwrap_or(f64::NAN)
                }));
        }
        let ([t_top, height], t_ground) = (top.unwrap(), ground.unwrap());
        // Bracket of 1e-13 of a step that may be 100 s; Rk4 sums 400 steps.
        assert!(
            (t_top - 2.0).abs() < 1e-10 && (height - 20.0).abs() < 1e-10,
            "{method:?}: {t_top}"
        );
        assert!((t_ground - 4.0).abs() < 1e-10, "{method:?}: {t_ground}");
    }
}

#[test]
fn retake_ends_where_asked_with_the_accuracy_of_a_step() {
    for method in [
        Method::DormandPrince54,
        Method::DormandPrince853,
        Method::Rk4 { step: 0.5 },
    ] {
        let mut integrator = Integrator::new(method, loose(), 0.0, [1.0]);
        let whole = integrator.step(&mut wave, 0.5).unwrap();
        let part = integrator.retake(&mut wave, 0.3).unwrap();
        assert_eq!((part.t0, part.t1, part.y0), (0.0, 0.3, [1.0]));
        assert_eq!((integrator.t(), *integrator.y()), (0.3, part.y1));
        let error = |y: f64| (y - wave_exact(0.3)).abs();
        assert!(
            error(part.y1[0]) < error(whole.component(0, 0.3)),
            "{method:?}"
        );
        // A step of 0.3 directly gives the same bits, and so does what follows.
        let mut direct = Integrator::new(with_step(method, 0.3), loose(), 0.0, [1.0]);
        assert_eq!(direct.step(&mut wave, 0.3).unwrap(), part);
        assert_eq!(
            integrator.step(&mut wave, 0.6).unwrap().y1,
            direct.step(&mut wave, 0.6).unwrap().y1
        );
        assert_eq!(
            (
                integrator.statistics().accepted,
                direct.statistics().accepted
            ),
            (2, 2)
        );
    }
}

#[test]
fn retake_outside_the_last_step_is_refused() {
    let mut integrator = Integrator::new(Method::DormandPrince54, tight(1e-6), 1.0, [1.0]);
    assert_eq!(
        integrator.retake(&mut wave, 1.5),
        Err(OdeError::Unreachable { t: 1.0, end: 1.5 })
    );
    integrator.step(&mut wave, 1.001).unwrap();
    for end in [1.0, 1.002, f64::NAN] {
        assert!(
            matches!(
                integrator.retake(&mut wave, end),
                Err(OdeError::Unreachable { .. })
            ),
            "{end}"
        );
    }
    assert_eq!(integrator.t(), 1.001);
}

#[test]
fn layer_boundary_with_retake_and_renew_costs_no_accuracy() {
    // y' = 1 below y = 1 and 3 above: y(2) = 1 + 3.
    for method in [
        Method::DormandPrince54,
        Method::DormandPrince853,
        Method::Rk4 { step: 0.3 },
    ] {
        let mut rate = 1.0;
        let mut integrator = Integrator::new(method, tight(1e-9), 0.0, [0.0]);
        while integrator.t() < 2.0 {
            let step = integrator.step(&mut |_, _| [rate], 2.0).unwrap();
            if let Some(t) =
                crossing(&step, |_, y| y[0] - 1.0, Direction::Rising).filter(|_| rate == 1.0)
            {
                integrator.retake(&mut |_, _| [rate], t).unwrap();
                integrator.renew();
                rate = 3.0;
            }
        }
        // The bracket of the crossing, and rounding.
        assert!(
            (integrator.y()[0] - 4.0).abs() < 1e-12,
            "{method:?}: {:?}",
            integrator.y()
        );
        assert_eq!(integrator.statistics().rejected, 0);
    }
}

#[test]
fn step_cut_short_by_its_limit_does_not_shorten_the_next() {
    let mut integrator = Integrator::new(Method::DormandPrince54, tight(1e-6), 0.0, [1.0, 0.5]);
    let mut length = 0.0;
    for _ in 0..10 {
        let step = integrator.step(&mut pendulum, 1e9).unwrap();
        length = step.t1 - step.t0;
    }
    let t = integrator.t();
    integrator.step(&mut pendulum, t + 1e-6 * length).unwrap();
    let step = integrator.step(&mut pendulum, 1e9).unwrap();
    assert!(step.t1 - step.t0 > 0.5 * length);
}

#[test]
fn right_hand_side_that_is_not_finite_is_an_error_and_ends() {
    for method in METHODS {
        for value in [f64::NAN, f64::INFINITY] {
            let mut integrator = Integrator::new(method, tight(1e-6), 0.0, [1.0]);
            let refused = integrator.step(&mut |_, _| [value], 1.0);
            assert_eq!(refused, Err(OdeError::NotFinite { t: 0.0 }));
        }
        // Not a number from t = 0.5 on: the integration comes close and says so.
        let mut root = |t: f64, _: &[f64; 1]| [(0.5 - t).sqrt()];
        let mut integrator = Integrator::new(method, tight(1e-6), 0.0, [1.0]);
        let fault = loop {
            match integrator.step(&mut root, 1.0) {
                Ok(_) => {}
                Err(fault) => break fault,
            }
        };
        assert!(
            matches!(fault, OdeError::NotFinite { .. }),
            "{method:?}: {fault:?}"
        );
        assert!(
            (0.48..=0.5).contains(&integrator.t()),
            "{method:?}: {}",
            integrator.t()
        );
        assert!(integrator.statistics().accepted + integrator.statistics().rejected < 200);
    }
}

#[test]
fn escape_to_infinity_in_finite_time_is_an_error() {
    // y' = y², y = 1 / (1 - t).
    for method in [Method::DormandPrince54, Method::DormandPrince853] {
        let mut integrator = Integrator::new(method, tight(1e-6), 0.0, [1.0]);
        let fault = loop {
            match integrator.step(&mut |_, y: &[f64; 1]| [y[0] * y[0]], 2.0) {
                Ok(_) => {}
                Err(fault) => break fault,
            }
        };
        assert!(
            matches!(
                fault,
                OdeError::StepTooSmall { .. } | OdeError::NotFinite { .. }
            ),
            "{fault:?}"
        );
        // The integrated solution escapes a little beside t = 1, by its tolerance.
        assert!((integrator.t() - 1.0).abs() < 1e-4, "{}", integrator.t());
    }
}

#[test]
fn allowance_of_steps_is_kept() {
    let mut integrator = Integrator::new(METHODS[2], tight(1e-6), 0.0, [1.0]).with_maximum_steps(7);
    for _ in 0..7 {
        integrator.step(&mut wave, 1.0).unwrap();
    }
    let t = integrator.t();
    assert_eq!(
        integrator.step(&mut wave, 1.0),
        Err(OdeError::TooManySteps { t })
    );
}

#[test]
fn limits_and_fixed_steps_that_lead_nowhere_are_refused() {
    for limit in [0.0, -1.0, f64::NAN] {
        let mut integrator = Integrator::new(Method::DormandPrince54, tight(1e-6), 0.0, [1.0]);
        assert!(matches!(
            integrator.step(&mut wave, limit),
            Err(OdeError::Unreachable { .. })
        ));
    }
    for step in [0.0, -1.0, f64::NAN] {
        let mut integrator = Integrator::new(Method::Rk4 { step }, tight(1e-6), 0.0, [1.0]);
        assert_eq!(
            integrator.step(&mut wave, 1.0),
            Err(OdeError::StepTooSmall { t: 0.0 })
        );
    }
}

#[test]
fn three_hundred_fixed_steps_of_a_tenth_end_at_30_exactly() {
    let mut integrator = Integrator::new(Method::Rk4 { step: 0.1 }, tight(1e-6), 0.0, [1.0]);
    while integrator.t() < 30.0 {
        integrator.step(&mut wave, 30.0).unwrap();
    }
    assert_eq!(
        (integrator.t(), integrator.statistics().accepted),
        (30.0, 300)
    );
}

#[test]
fn start_at_rest_and_a_constant_need_no_special_care() {
    // From rest at zero under 10: 5 t². Absolute tolerances alone decide at first.
    let mut integrator =
        Integrator::new(Method::DormandPrince853, tight(1e-9), 0.0, [0.0, 0.0, 3.0]);
    while integrator.t() < 2.0 {
        integrator
            .step(&mut |_, y: &[f64; 3]| [y[1], 10.0, 0.0], 2.0)
            .unwrap();
    }
    let [way, speed, constant] = *integrator.y();
    assert!((way - 20.0).abs() < 1e-12 && (speed - 20.0).abs() < 1e-12);
    assert_eq!(constant, 3.0);
}

#[test]
fn infinite_tolerance_leaves_a_component_out_of_the_control() {
    let steps = |absolute: f64| {
        let tolerance = Tolerance {
            relative: [0.0; 2],
            absolute: [1e-6, absolute],
        };
        let mut integrator = Integrator::new(Method::DormandPrince54, tolerance, 0.0, [1.0, 0.0]);
        while integrator.t() < 10.0 {
            integrator
                .step(&mut |t, y: &[f64; 2]| [-y[0], math::sin(30.0 * t)], 10.0)
                .unwrap();
        }
        integrator.statistics().accepted
    };
    assert!(3 * steps(f64::INFINITY) < steps(1e-6));
}

#[test]
fn same_integration_gives_the_same_bits() {
    let run = || {
        let mut integrator = Integrator::new(Method::DormandPrince54, tight(1e-8), 0.0, [1.0, 0.5]);
        while integrator.t() < 20.0 {
            integrator.step(&mut pendulum, 20.0).unwrap();
        }
        integrator.y().map(f64::to_bits)
    };
    assert_eq!(run(), run());
}
