//! Problems that cannot be integrated give an error, never a hang.

use super::{METHODS, tight, wave};
use numerics::ode::{Integrator, Method, OdeError};

#[test]
fn right_hand_side_that_is_not_finite_is_an_error_and_ends() {
    for method in METHODS {
        for value in [f64::NAN, f64::INFINITY] {
            let mut integrator = Integrator::new(method, tight(1e-6), 0.0, [1.0]);
            let refused = integrator.step(&mut |_, _| [value], 1.0);
            assert_eq!(refused, Err(OdeError::NotFinite { t: 0.0 }));
        }
        // NaN from t = 0.5 on: the integration comes close and reports it.
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
