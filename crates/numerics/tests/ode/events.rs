//! Crossings, retakes, and a right-hand side that changes.

use super::{METHODS, loose, tight, wave, wave_exact, with_step};
use numerics::ode::event::{Direction, crossing};
use numerics::ode::{Integrator, Method, OdeError};

#[test]
fn thrown_body_is_at_its_top_and_lands_when_it_must() {
    // Thrown up at 20 m/s under 10 m/s²: top after 2 s at 20 m, ground after 4 s.
    for method in METHODS {
        let mut integrator =
            Integrator::new(method, tight(1e-9), 0.0, [0.0, 20.0]).with_longest_step(1.0);
        let (mut top, mut ground) = (None, None);
        while ground.is_none() {
            let step = integrator
                .step(&mut |_, y: &[f64; 2]| [y[1], -10.0], 100.0)
                .unwrap();
            assert!(step.t1 - step.t0 < 1.0 + 1e-12);
            top = top
                .or(crossing(&step, |_, y| y[1], Direction::Falling)
                    .map(|t| [t, step.component(0, t)]));
            // The start, at height 0, is no landing.
            ground = crossing(&step, |_, y| y[0], Direction::Falling);
        }
        let ([t_top, height], t_ground) = (top.unwrap(), ground.unwrap());
        // Bracket of 1e-13 of a step, and the rounding of up to 400 steps.
        assert!(
            (t_top - 2.0).abs() < 1e-12 && (height - 20.0).abs() < 1e-12,
            "{method:?}: {t_top}"
        );
        assert!((t_ground - 4.0).abs() < 1e-12, "{method:?}: {t_ground}");
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
fn retake_after_renew_is_taken_with_the_new_right_hand_side() {
    let mut growth = |_: f64, y: &[f64; 1]| [2.0 * y[0]];
    let mut integrator = Integrator::new(Method::DormandPrince54, loose(), 0.0, [1.0]);
    integrator.step(&mut wave, 0.2).unwrap();
    integrator.renew();
    let again = integrator.retake(&mut growth, 0.1).unwrap();
    let mut direct = Integrator::new(Method::DormandPrince54, loose(), 0.0, [1.0]);
    assert_eq!(direct.step(&mut growth, 0.1).unwrap(), again);
}
