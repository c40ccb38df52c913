//! Flights in lanes and flights with derivatives.

use msape::flight::batch::{extremes_of_all, fly_all};
use msape::flight::mission::Start;
use msape::flight::numbers::Numbers;
use msape::flight::three_dof::fly_with;
use msape::flight::{Flight, Peak};
use msape::planet::geodetic::Geodetic;
use msape::planet::horizon::Velocity;
use msape::problem::FlightProblem;
use msape::{Case, Library, Request};
use numerics::ode::Method;
use numerics::scalar::{Dual, Scalar};
use std::ops::ControlFlow;
use std::sync::LazyLock;

static LIBRARY: LazyLock<Library> = LazyLock::new(|| Library::builtin().unwrap());

/// Drag by Mach number, radiation, wind: everything that a lane may run into by itself.
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

fn problem(text: &str) -> FlightProblem {
    FlightProblem::check(&Case::from_text(text).unwrap(), &LIBRARY).unwrap()
}

/// Numbers between 0 and 1 by a fixed seed, after Steele, Lea and Flood.
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

/// What a flight is drawn by: entry state in words, and the vehicle.
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
    let problem = problem(EVERYTHING);
    let mut random = Random(1);
    let all: Vec<Numbers> = (0..1000)
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

/// Every number of a flight.
fn outputs<S: Scalar>(flight: &Flight<S>) -> Vec<(&'static str, S)> {
    let mut all = vec![
        ("convective load", flight.convective_heat_load_j_m2),
        ("radiative load", flight.radiative_heat_load_j_m2),
        ("margined load", flight.total_margined_heat_load_j_m2()),
        ("wall temperature", flight.peak_wall_temperature_k),
        ("ballistic coefficient", flight.ballistic_coefficient_kg_m2),
        ("time of flight", flight.time_of_flight_s),
        ("final altitude", flight.final_altitude_m),
        ("final speed", flight.final_speed_m_s),
        ("final angle", flight.final_flight_path_angle_rad),
        ("final latitude", flight.final_latitude_rad),
        ("final longitude", flight.final_longitude_rad),
        ("final density", flight.final_density_kg_m3),
        ("downrange", flight.downrange_m),
        ("inertial speed", flight.entry_inertial.speed_m_s),
        (
            "inertial angle",
            flight.entry_inertial.flight_path_angle_rad,
        ),
        ("inertial azimuth", flight.entry_inertial.azimuth_rad),
    ];
    all.extend(
        flight
            .mach_times_s
            .iter()
            .flatten()
            .map(|t| ("Mach time", *t)),
    );
    let mut peak = |name, peak: &Peak<S>| {
        let Peak {
            value,
            time_s,
            altitude_m,
            speed_m_s,
            density_kg_m3,
        } = *peak;
        all.extend([value, time_s, altitude_m, speed_m_s, density_kg_m3].map(|x| (name, x)));
    };
    peak("deceleration", &flight.peak_deceleration_earth_g);
    peak("dynamic pressure", &flight.peak_dynamic_pressure_pa);
    peak("stagnation pressure", &flight.peak_stagnation_pressure_pa);
    peak("convective flux", &flight.peak_convective_heat_flux_w_m2);
    flight
        .peak_radiative_heat_flux_w_m2
        .iter()
        .for_each(|p| peak("radiative flux", p));
    peak("total flux", &flight.peak_total_heat_flux_w_m2);
    peak("margined flux", &flight.peak_total_margined_heat_flux_w_m2);
    all
}

/// A problem so exactly integrated that differences of flights tell derivatives, without tables: their slopes jump from row
/// to row, which a step that is controlled by its values does not see in its derivatives.
fn exact() -> FlightProblem {
    let text = EVERYTHING
        .replace("atmosphere = \"us-1976\"\n", "")
        .replace(
            "[wind]",
            "[atmosphere.exponential]\ndensity_kg_m3 = 1.4\nscale_height_m = 7000.0\n[wind]",
        )
        .replace(", [12000.0, 40.0, -3.0], [30000.0, 0.0, 0.0]", "")
        .replace("aerodynamics = \"mmeev-60\"", "drag_coefficient = 1.5")
        .replace("tauber-sutton", "brandis-johnston");
    let mut problem = problem(&text);
    problem.mission.solver.method = Method::DormandPrince853;
    problem.mission.solver.tolerance = 1e-12;
    problem
}

/// Size below which an output counts as zero.
fn least(name: &str) -> f64 {
    match name {
        "final altitude" => 1.0,
        _ => 0.0,
    }
}

#[test]
fn derivatives_of_all_outputs_are_those_of_central_differences() {
    let problem = exact();
    let mut random = Random(2);
    let mut worst = (0.0, String::new());
    for case in 0..50 {
        let parameters = drawn(&mut random);
        let dual = core::array::from_fn(|i| Dual::<PARAMETERS>::variable(parameters[i], i));
        let (flight, ..) = fly_with(
            &problem.mission,
            &problem.body,
            numbers(&problem, dual),
            Request::Nothing,
        );
        let derivatives = outputs(&flight);
        let plain = outputs(&alone(&problem, numbers(&problem, parameters)));
        for ((name, value), (_, dual)) in plain.iter().zip(&derivatives) {
            assert_eq!(
                *value, dual.value,
                "{name}: the value is that of plain numbers"
            );
        }
        // A third of the parameters by turns: all are met over the flights.
        for i in (case % 3..PARAMETERS).step_by(3) {
            let scale = parameters[i].abs().max(0.1);
            let moved = |part: f64| {
                let mut moved = parameters;
                moved[i] += part * scale;
                outputs(&alone(&problem, numbers(&problem, moved)))
            };
            let step = 1e-3;
            let [a, b, c, d] = [2.0 * step, step, -step, -2.0 * step].map(moved);
            for (k, (name, dual)) in derivatives.iter().enumerate() {
                // f' = (8 (f₁ − f₋₁) − (f₂ − f₋₂)) / (12 h)
                let near = 8.0 * (b[k].1 - c[k].1) - (a[k].1 - d[k].1);
                let difference = near / (12.0 * step * scale);
                // The altitude at the ground is zero but for rounding.
                let size = difference.abs() + dual.value.abs().max(least(name)) / scale;
                let error = (dual.slope[i] - difference).abs() / size;
                if error > worst.0 {
                    let text = format!("{case} {name} by {i}: {} {difference}", dual.slope[i]);
                    worst = (error, text);
                }
            }
        }
    }
    assert!(worst.0 < 1e-6, "{}: {}", worst.0, worst.1);
}
