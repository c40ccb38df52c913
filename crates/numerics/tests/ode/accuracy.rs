//! Orders of convergence, exactness on polynomials, a published orbit.

use super::{METHODS, arenstorf, loose, pendulum, tight, wave, wave_exact, with_step};
use numerics::math;
use numerics::ode::{Integrator, Method};

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
            // Each of some tens of steps has an error below the tolerance; the errors of one revolution add up.
            assert!(
                math::hypot(u - 1.0, v) < 50.0 * tolerance,
                "{method:?} {tolerance}: {u} {v}"
            );
        }
    }
}

#[test]
fn arenstorf_orbit_closes() {
    // \[hairer-norsett-wanner-1993\] eq. II.0.2, initial state and period, rounded to doubles.
    let start = [0.994, 0.0, 0.0, -2.001_585_106_379_082_4];
    let period = 17.065_216_560_157_964;
    for (method, most_evaluations) in [
        (Method::DormandPrince54, 8500),
        (Method::DormandPrince853, 4500),
    ] {
        let mut integrator = Integrator::new(method, tight(1e-11), 0.0, start);
        while integrator.t() < period {
            integrator.step(&mut arenstorf, period).unwrap();
        }
        let distance = math::hypot(integrator.y()[0] - start[0], integrator.y()[1] - start[1]);
        // The orbit magnifies the tolerance by some hundreds; scipy's codes of the same formulae end 2e-9 and 1e-10 away.
        assert!(distance < 1e-8, "{method:?}: {distance}");
        let spent = integrator.statistics();
        assert!(
            spent.evaluations < most_evaluations,
            "{method:?}: {spent:?}"
        );
    }
}
