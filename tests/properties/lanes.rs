//! Flights in lanes (several at once), and flights with derivatives.

use msape::flight::Flight;
use msape::flight::batch::{extremes_of_all, fly_all};
use msape::flight::mission::Start;
use msape::flight::numbers::Numbers;
use msape::flight::three_dof::fly_with;
use msape::planet::geodetic::Geodetic;
use msape::planet::horizon::Velocity;
use msape::problem::FlightProblem;
use msape::{Case, Library, Request};
use numerics::scalar::Scalar;
use std::ops::ControlFlow;
use std::sync::LazyLock;

static LIBRARY: LazyLock<Library> = LazyLock::new(|| Library::builtin().unwrap());

/// Drag by Mach number, radiation, wind: everything that lanes may encounter at different times.
const EVERYTHING: &str = r#"
schema = "msape/1"
name = "everything"
[entry]
planet = "earth-msape"
atmosphere = "us-1976"
altitude_m = 125000.0
latitude_deg = 33.0
longitude_deg = 246.0
speed_m_s = 12000.0
flight_path_angle_deg = -8.0
azimuth_deg = 90.0
[wind]
table = [[0.0, 5.0, 1.0], [12000.0, 40.0, -3.0], [30000.0, 0.0, 0.0]]
[vehicle]
mass_kg = 46.0
reference_area_m2 = 0.51887
nose_radius_m = 0.2286
aerodynamics = "mmeev-60"
[heating]
radiative = "tauber-sutton"
"#;

/// The same case with phases, which each lane reaches at its own time.
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

fn problem(text: &str) -> FlightProblem {
    FlightProblem::check(&Case::from_text(text).unwrap(), &LIBRARY).unwrap()
}

/// Pseudo-random numbers between 0 and 1 from a fixed seed, after Steele, Lea and Flood.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

/// Number of random parameters of a flight: entry state and vehicle.
const PARAMETERS: usize = 12;

fn drawn(random: &mut Random) -> [f64; PARAMETERS] {
    [
        random.within(100e3, 130e3),
        random.within(-1.0, 1.0),
        random.within(-3.0, 3.0),
        random.within(10e3, 14e3),
        random.within(-0.4, -0.12),
        random.within(0.1, 6.0),
        random.within(30.0, 120.0),
        random.within(0.3, 1.5),
        random.within(0.15, 0.6),
        random.within(0.9, 1.1),
        random.within(0.8, 1.2),
        random.within(0.5, 1.5),
    ]
}

fn numbers<S: Scalar>(problem: &FlightProblem, parameters: [S; PARAMETERS]) -> Numbers<S> {
    let [
        h,
        lat,
        lon,
        v,
        gamma,
        psi,
        mass,
        area,
        nose,
        drag,
        density,
        wind,
    ] = parameters;
    let position = Geodetic {
        altitude_m: h,
        latitude_rad: lat,
        longitude_rad: lon,
    };
    let velocity = Velocity {
        speed_m_s: v,
        flight_path_angle_rad: gamma,
        azimuth_rad: psi,
    };
    Numbers {
        start: Start::relative(&problem.mission.planet, &position, velocity),
        mass_kg: mass,
        reference_area_m2: area,
        nose_radius_m: nose,
        drag_factor: drag,
        density_factor: density,
        wind_factor: wind,
        ..Numbers::constant(&Numbers::of(&problem.mission, &problem.body))
    }
}

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
