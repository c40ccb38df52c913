//! The course of the steps: their length, their count, what they cost.

use super::{arenstorf, pendulum, tight, wave};
use numerics::math;
use numerics::ode::{Dense, Integrator, Method, Statistics, Tolerance};

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
            integrator.step(&mut f, f64::INFINITY).unwrap();
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
    // Fall from rest at zero under 10: 5 t². Absolute tolerances alone decide at first.
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
