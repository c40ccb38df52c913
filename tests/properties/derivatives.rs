//! Derivatives of flights by dual numbers, against differences of flights.

use crate::drawn::{EVERYTHING, PARAMETERS, Random, drawn, numbers, problem};
use msape::Request;
use msape::flight::three_dof::fly_with;
use msape::flight::{Flight, Peak};
use msape::problem::FlightProblem;
use numerics::ode::Method;
use numerics::scalar::{Dual, Single};

fn flown<S: Single>(problem: &FlightProblem, parameters: [S; PARAMETERS]) -> Flight<S> {
    let numbers = numbers(problem, parameters);
    fly_with(&problem.mission, &problem.body, numbers, Request::Nothing).0
}

/// Every number of a flight.
fn outputs<S: Single>(flight: &Flight<S>) -> Vec<(&'static str, S)> {
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
    let times = flight.mach_times_s.iter().flatten();
    all.extend(times.map(|t| ("Mach time", *t)));
    let mut peak = |names: [&'static str; 5], peak: &Peak<S>| {
        let Peak {
            value,
            time_s,
            altitude_m,
            speed_m_s,
            density_kg_m3,
        } = *peak;
        let numbers = [value, time_s, altitude_m, speed_m_s, density_kg_m3];
        all.extend(names.into_iter().zip(numbers));
    };
    macro_rules! peaks {
        ($($name:literal $of:expr;)*) => {$(
            peak(
                [
                    $name,
                    concat!("time of ", $name),
                    concat!("altitude of ", $name),
                    concat!("speed at ", $name),
                    concat!("density at ", $name),
                ],
                $of,
            );
        )*};
    }
    peaks! {
        "deceleration" &flight.peak_deceleration_earth_g;
        "dynamic pressure" &flight.peak_dynamic_pressure_pa;
        "stagnation pressure" &flight.peak_stagnation_pressure_pa;
        "convective flux" &flight.peak_convective_heat_flux_w_m2;
        "total flux" &flight.peak_total_heat_flux_w_m2;
        "margined flux" &flight.peak_total_margined_heat_flux_w_m2;
    }
    if let Some(radiative) = &flight.peak_radiative_heat_flux_w_m2 {
        peaks! { "radiative flux" radiative; }
    }
    all
}

const WIND: &str = "table = [[0.0, 5.0, 1.0], [12000.0, 40.0, -3.0], [30000.0, 0.0, 0.0]]";
const STANDARD: &str = "atmosphere = \"us-1976\"\n";

/// Air in which a flight is compared.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Air {
    /// Cells of cubics, whose curvature jumps by 2e-5 from one to the next.
    Standard,
    /// With derivatives of all orders.
    Exponential,
}

/// A flight in one of the kinds of air, wind, drag and heating, so exactly integrated that differences of flights tell
/// derivatives.
fn exact(kind: usize) -> FlightProblem {
    let air = [Air::Standard, Air::Exponential][kind % 2];
    let radiation = ["tauber-sutton", "none", "brandis-johnston"][kind % 3];
    let wind = [
        WIND,
        "eastward_m_s = 20.0\nnorthward_m_s = -10.0",
        "eastward_m_s = 0.0",
    ];
    let mut text = EVERYTHING
        .replace("tauber-sutton", radiation)
        .replace(WIND, wind[kind / 4 % 3]);
    if air == Air::Exponential {
        let exponential =
            "[atmosphere.exponential]\ndensity_kg_m3 = 1.4\nscale_height_m = 7000.0\n[wind]";
        text = text.replace(STANDARD, "").replace("[wind]", exponential);
    }
    // The temperature of exponential air has kinks, at which no step ends: they do not matter to a drag that is constant.
    if air == Air::Exponential || kind / 2 % 2 == 1 {
        text = text.replace("aerodynamics = \"mmeev-60\"", "drag_coefficient = 1.5");
    }
    let mut problem = problem(&text);
    problem.mission.solver.method = Method::DormandPrince853;
    problem.mission.solver.tolerance = 1e-12;
    problem
}

/// Steps of differences as a part of the parameter.
const STEPS: [f64; 5] = [8e-3, 2e-3, 5e-4, 1.2e-4, 3e-5];
/// Two steps must tell a difference to this part.
const SETTLED: f64 = 2e-5;

/// Error allowed to the derivative of an output, as a part of it.
fn allowed(name: &str) -> f64 {
    let of_place = ["time of ", "altitude of ", "speed at ", "density at "];
    let is_place = name != "time of flight" && of_place.iter().any(|start| name.starts_with(start));
    match name {
        // By the slope of the interpolation within a step, and of the cells of the standard atmosphere.
        _ if is_place => 1e-4,
        // No step ends where the exponent of the nose radius meets its cap.
        "radiative load" => 1e-5,
        _ => 1e-6,
    }
}

/// Size below which an output counts as zero.
fn least(name: &str) -> f64 {
    match name {
        "final altitude" => 1e3,
        _ => 0.0,
    }
}

#[test]
fn derivatives_of_all_outputs_are_those_of_differences() {
    let mut random = Random(2);
    let mut faults = Vec::new();
    for case in 0..4 * PARAMETERS {
        let problem = exact(case);
        let mut parameters = drawn(&mut random);
        parameters[0] = 125e3;
        let dual = core::array::from_fn(|i| Dual::<PARAMETERS>::variable(parameters[i], i));
        let derivatives = outputs(&flown(&problem, dual));
        let plain = outputs(&flown(&problem, parameters));
        for ((name, value), (_, dual)) in plain.iter().zip(&derivatives) {
            assert_eq!(*value, dual.value, "{name}");
        }
        // One of the parameters by turns, each in two flights of either kind of air.
        let i = case / 2 % PARAMETERS;
        let scale = parameters[i].abs().max(0.1);
        let moved = |part: f64| {
            let mut moved = parameters;
            moved[i] += part * scale;
            outputs(&flown(&problem, moved))
        };
        // f' = (8 (f₁ − f₋₁) − (f₂ − f₋₂)) / (12 h)
        let by_step = STEPS.map(|step| {
            let [a, b, c, d] = [2.0, 1.0, -1.0, -2.0].map(|part| moved(part * step));
            let of = |k: usize| {
                let [a, b, c, d] = [&a, &b, &c, &d].map(|f| f.get(k).map_or(f64::NAN, |f| f.1));
                (8.0 * (b - c) - (a - d)) / (12.0 * step * scale)
            };
            (0..derivatives.len()).map(of).collect::<Vec<f64>>()
        });
        for (k, (name, dual)) in derivatives.iter().enumerate() {
            // Of two steps that agree best, which shows how well the difference is known.
            let pairs = by_step.windows(2).map(|pair| [pair[0][k], pair[1][k]]);
            let gap = |pair: &[f64; 2]| (pair[0] - pair[1]).abs();
            let best = pairs.min_by(|a, b| gap(a).total_cmp(&gap(b)));
            let best = best.unwrap_or([f64::NAN; 2]);
            let size = best[0].abs() + dual.value.abs().max(least(name)) / scale;
            let size = size.max(f64::MIN_POSITIVE);
            let known = gap(&best) / size;
            let error = (dual.slope[i] - 0.5 * (best[0] + best[1])).abs() / size;
            if !(known < SETTLED && error < allowed(name)) {
                faults.push(format!(
                    "flight {case}, {name} by {i}: {} {best:?}, {error:.1e}, known to {known:.1e}",
                    dual.slope[i]
                ));
            }
        }
    }
    assert!(faults.is_empty(), "{}: {}", faults.len(), faults.join("\n"));
}
