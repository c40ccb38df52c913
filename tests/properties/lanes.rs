//! Flights in lanes: several at once.

use crate::drawn::{EVERYTHING, Random, drawn, numbers, problem};
use msape::Request;
use msape::flight::Flight;
use msape::flight::batch::{extremes_of_all, fly_all};
use msape::flight::numbers::Numbers;
use msape::flight::three_dof::fly_with;
use msape::problem::FlightProblem;
use std::ops::ControlFlow;

/// Phases added to the case, which each lane reaches at its own time.
const PHASES: &str = r#"
[[phase]]
name = "drogue"
mach = 1.4
drag_area_m2 = 0.4
inflation_s = 0.7
[[phase]]
name = "shield"
dynamic_pressure_pa = 300.0
mass_kg = 30.0
drag_coefficient = 0.8
[[phase]]
name = "main"
altitude_m = 3000.0
drag_area_m2 = 20.0
"#;

fn alone(problem: &FlightProblem, numbers: Numbers) -> Flight {
    fly_with(&problem.mission, &problem.body, numbers, Request::Nothing).0
}

#[test]
fn thousand_flights_in_lanes_have_the_bits_of_each_alone() {
    in_lanes_as_alone(EVERYTHING, 1000);
}

#[test]
fn flights_with_phases_in_lanes_have_the_bits_of_each_alone() {
    let flights = in_lanes_as_alone(&format!("{EVERYTHING}{PHASES}"), 100);
    assert!(flights.iter().any(|flight| flight.phases.len() == 3));
}

fn in_lanes_as_alone(text: &str, count: usize) -> Vec<Flight> {
    let problem = problem(text);
    let mut random = Random(1);
    let all: Vec<Numbers> = (0..count)
        .map(|_| numbers(&problem, drawn(&mut random)))
        .collect();
    let expected: Vec<Flight> = all.iter().map(|n| alone(&problem, *n)).collect();
    let (mission, body) = (&problem.mission, &problem.body);
    let mut seen = vec![0; all.len()];
    let done = fly_all::<8>(mission, body, all.iter().copied(), |flown| {
        assert_eq!(flown.results, expected[flown.number]);
        seen[flown.number] += 1;
        ControlFlow::Continue(())
    });
    assert!(done.is_continue());
    let done = extremes_of_all::<2>(mission, body, all.iter().copied(), |flown| {
        let (extremes, flight) = (flown.results, &expected[flown.number]);
        assert_eq!(
            extremes.peak_deceleration_earth_g,
            flight.peak_deceleration_earth_g
        );
        assert_eq!(
            extremes.peak_stagnation_pressure_pa,
            flight.peak_stagnation_pressure_pa
        );
        let margined = flight.peak_total_margined_heat_flux_w_m2;
        assert_eq!(extremes.peak_total_margined_heat_flux_w_m2, margined);
        assert_eq!(
            extremes.radiative_heat_load_j_m2,
            flight.radiative_heat_load_j_m2
        );
        assert_eq!(extremes.final_speed_m_s, flight.final_speed_m_s);
        seen[flown.number] += 1;
        ControlFlow::Continue(())
    });
    assert!(done.is_continue());
    assert!(seen.iter().all(|seen| *seen == 2));
    expected
}

#[test]
fn batch_can_be_stopped() {
    let problem = problem(EVERYTHING);
    let one = Numbers::of(&problem.mission, &problem.body);
    let mut ended = 0;
    let stopped = fly_all::<4>(&problem.mission, &problem.body, [one; 20], |_| {
        ended += 1;
        match ended {
            3 => ControlFlow::Break(()),
            _ => ControlFlow::Continue(()),
        }
    });
    assert_eq!((stopped, ended), (ControlFlow::Break(()), 3));
}
