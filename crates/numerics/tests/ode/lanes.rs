//! Many integrations at a time, and integrations with derivatives.

use super::{arenstorf, pendulum, tight};
use numerics::ode::{Integrator, Method, OdeError, Step};
use numerics::scalar::{Dual, Lanes, Mask, Scalar};

/// The pendulum over any number.
fn swing<S: Scalar>(_: S, y: &[S; 2]) -> [S; 2] {
    [y[1], -y[0].sin()]
}

/// Ends of ten integrations that begin at different angles and end at different times.
fn flights() -> Vec<([f64; 2], f64)> {
    (0..10)
        .map(|i| ([0.1 + 0.28 * f64::from(i), 0.0], 3.0 + f64::from(i * i % 7)))
        .collect()
}

fn alone(method: Method, tolerance: f64, (start, end): ([f64; 2], f64)) -> Vec<Step<2>> {
    let mut integrator = Integrator::new(method, tight(tolerance), 0.0, start);
    let mut steps = Vec::new();
    while integrator.t() < end {
        steps.push(integrator.step(&mut swing, end).unwrap());
    }
    steps
}

#[test]
fn lanes_refilled_from_a_queue_take_the_same_steps_as_alone() {
    for method in [
        Method::DormandPrince54,
        Method::DormandPrince853,
        Method::Rk4 { step: 0.07 },
    ] {
        let flights = flights();
        let mut steps: Vec<Vec<Step<2>>> = vec![Vec::new(); flights.len()];
        let (mut waiting, mut in_lane) = (3, [0, 1, 2]);
        let y0 = core::array::from_fn(|i| Lanes([0, 1, 2].map(|k: usize| flights[k].0[i])));
        let mut integrator = Integrator::new(method, tight(1e-7), Lanes([0.0; 3]), y0);
        let mut active = <Lanes<3> as Scalar>::Mask::constant(true);
        while active.any() {
            let limit = Lanes(in_lane.map(|flight| flights[flight].1));
            let attempt = integrator.attempt(&mut swing, limit, active);
            assert!(!attempt.failed.any());
            for lane in (0..3).filter(|lane| attempt.accepted.lane(*lane)) {
                let flight = in_lane[lane];
                let step = integrator.last_step().lane(lane);
                let over = step.t1 >= flights[flight].1;
                steps[flight].push(step);
                if over && waiting < flights.len() {
                    in_lane[lane] = waiting;
                    integrator.restart(lane, 0.0, &flights[waiting].0);
                    waiting += 1;
                } else if over {
                    active.set_lane(lane, false);
                }
            }
        }
        for (steps, flight) in steps.iter().zip(flights) {
            assert_eq!(*steps, alone(method, 1e-7, flight), "{method:?}");
        }
    }
}

#[test]
fn counts_of_a_lane_are_those_of_the_same_integration_alone() {
    let start: [f64; 4] = [0.994, 0.0, 0.0, -2.0];
    let mut alone = Integrator::new(Method::DormandPrince54, tight(1e-6), 0.0, start);
    let y0 = start.map(|y| Lanes([y, y + 0.01]));
    let mut lanes = Integrator::new(Method::DormandPrince54, tight(1e-6), Lanes([0.0; 2]), y0);
    let mut f = |_: Lanes<2>, y: &[Lanes<2>; 4]| {
        let of: [[f64; 4]; 2] = [0, 1].map(|k| arenstorf(0.0, &y.map(|y| y.lane(k))));
        core::array::from_fn(|i| Lanes([of[0][i], of[1][i]]))
    };
    let everywhere = <Lanes<2> as Scalar>::Mask::constant(true);
    let mut accepted = 0;
    while accepted < 40 {
        let attempt = lanes.attempt(&mut f, Lanes([f64::INFINITY; 2]), everywhere);
        accepted += u32::from(attempt.accepted.lane(0));
    }
    for _ in 0..40 {
        alone.step(&mut arenstorf, f64::INFINITY).unwrap();
    }
    assert_eq!(lanes.statistics_of(0), alone.statistics());
    assert!(alone.statistics().rejected > 0);
}

#[test]
fn step_ended_on_its_dense_output_goes_on_from_there_at_the_cost_of_one_evaluation() {
    let mut integrator = Integrator::new(Method::DormandPrince54, tight(1e-9), 0.0, [1.0, 0.5]);
    let step = integrator.step(&mut pendulum, 10.0).unwrap();
    let middle = 0.5 * (step.t0 + step.t1);
    let before = integrator.statistics().evaluations;
    integrator.put(0, middle, &step.at(middle));
    assert_eq!(integrator.t(), middle);
    let next = integrator.step(&mut pendulum, 10.0).unwrap();
    assert_eq!((next.t0, next.y0), (middle, step.at(middle)));
    assert_eq!(integrator.statistics().evaluations - before, 6 + 1);
}

#[test]
fn lane_that_cannot_go_on_stops_no_other() {
    let mut root = |t: Lanes<2>, y: &[Lanes<2>; 1]| [(y[0] * 0.0 + 0.5 - t).sqrt()];
    let mut integrator = Integrator::new(
        Method::DormandPrince54,
        tight(1e-6),
        Lanes([0.0, -1.0]),
        [Lanes([0.0; 2])],
    );
    let mut active = <Lanes<2> as Scalar>::Mask::constant(true);
    let limit = Lanes([1.0, 0.4]);
    while active.any() {
        let attempt = integrator.attempt(&mut root, limit, active);
        let over = limit.less(integrator.t() + 1e-12);
        active = active.and(attempt.failed.not()).and(over.not());
        if attempt.failed.lane(0) {
            let fault = integrator.fault(0, 1.0);
            assert!(matches!(fault, OdeError::NotFinite { .. }), "{fault:?}");
        }
    }
    assert_eq!(integrator.t().lane(1), 0.4);
    assert!((0.48..=0.5).contains(&integrator.t().lane(0)));
}

#[test]
fn derivative_of_the_end_by_the_start_is_that_of_central_differences() {
    let end = |angle: f64| {
        alone(Method::DormandPrince853, 1e-11, ([angle, 0.0], 5.0))
            .pop()
            .unwrap()
            .y1
    };
    let start = [Dual::<1>::variable(1.2, 0), Dual::constant(0.0)];
    let mut integrator = Integrator::new(
        Method::DormandPrince853,
        tight(1e-11),
        Dual::constant(0.0),
        start,
    );
    while integrator.t().value < 5.0 {
        integrator.step(&mut swing, 5.0).unwrap();
    }
    // Steps go by the values alone: the same bits as without derivatives.
    assert_eq!(integrator.y().map(|y| y.value), end(1.2));
    let (more, less) = (end(1.2 + 1e-4), end(1.2 - 1e-4));
    for i in 0..2 {
        let difference = (more[i] - less[i]) / 2e-4;
        // Errors of the steps, 1e-11, over the difference of 1e-4, and its square.
        assert!((integrator.y()[i].slope[0] - difference).abs() < 1e-6);
    }
}
