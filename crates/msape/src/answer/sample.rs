//! Answers made by hand, for tests of what writes answers.

use super::PlanetNames;
use super::{Answer, Outcome};
use crate::case::Case;
use crate::design::Design;
use crate::design::inputs::DesignInput;
use crate::finding::{Adjustment, Finding, Severity};
use crate::flight::columns::columns;
use crate::flight::mission::Model;
use crate::flight::{Flight, Peak, Request, Trajectory};
use crate::library::{Library, data_file};
use crate::planet::horizon::Velocity;
use crate::problem::DesignProblem;
use crate::quantity::input;

fn peak(value: f64, time_s: f64) -> Peak {
    Peak {
        value,
        time_s,
        altitude_m: 54_864.9,
        speed_m_s: 7_800.09,
        density_kg_m3: 5.5e-4,
    }
}

/// The design of a shipped case, with its input and its flight.
pub fn designed(case: &str) -> (DesignInput, Design, Flight) {
    let text = data_file(&format!("cases/{case}.toml")).unwrap();
    let library = Library::builtin().unwrap();
    let problem = DesignProblem::check(&Case::from_text(text).unwrap(), &library).unwrap();
    let answer = problem.solve("", Request::Nothing);
    (
        problem.input,
        answer.design.unwrap(),
        answer.flight.unwrap(),
    )
}

/// A flight of three rows across the date line, with a name that must be quoted, without radiation.
pub fn flight() -> Answer {
    let velocity = Velocity {
        speed_m_s: 12_000.0,
        flight_path_angle_rad: -0.125,
        azimuth_rad: 1.5,
    };
    let values = columns()
        .map(|column| match column.key {
            "time_s" => vec![0.0, 2.0, 4.0],
            "altitude_m" => vec![125_000.0, 60_000.0, 0.0],
            "latitude_deg" => vec![33.0, 32.5, 32.0],
            "longitude_deg" => vec![179.0, -179.0, -178.0],
            "temperature_k" => vec![360.0, f64::NAN, 288.15],
            _ => vec![0.0, 0.5, 1e-7],
        })
        .collect();
    Answer {
        name: "sample \"one\", first".to_string(),
        planet: PlanetNames {
            title: "Earth".to_string(),
            kml_target: Some("earth".to_string()),
        },
        outcome: Outcome::Landed,
        reason: None,
        flight: Some(Flight {
            model: Model::ThreeDof,
            entry_relative: velocity,
            entry_inertial: velocity,
            peak_deceleration_earth_g: peak(29.84381, 1.0),
            peak_dynamic_pressure_pa: peak(17_560.07, 1.0),
            peak_stagnation_pressure_pa: peak(33_000.0, 1.0),
            peak_convective_heat_flux_w_m2: peak(4.987819e6, 1.0),
            peak_radiative_heat_flux_w_m2: None,
            peak_total_heat_flux_w_m2: peak(4.987819e6, 1.0),
            peak_total_margined_heat_flux_w_m2: peak(6.4841647e6, 1.0),
            convective_heat_load_j_m2: 1.582558e8,
            radiative_heat_load_j_m2: 0.0,
            convective_margin: 1.3,
            radiative_margin: 1.0,
            peak_wall_temperature_k: 3000.0,
            ballistic_coefficient_kg_m2: f64::INFINITY,
            time_of_flight_s: 4.0,
            final_altitude_m: 0.0,
            final_speed_m_s: 31.05,
            final_flight_path_angle_rad: -1.5,
            final_latitude_rad: 0.5,
            final_longitude_rad: -3.0,
            final_density_kg_m3: 1.225,
            downrange_m: 809_371.0,
            mach_times_s: [None, None, Some(3.0), Some(3.5)],
            trajectory: Some(Trajectory {
                values,
                coarsened_s: None,
                phases: Vec::new(),
            }),
            passed: Vec::new(),
            pushed: None,
            altitudes_m: [0.0, 125e3],
            points: Vec::new(),
            phases: Vec::new(),
            exits: 0,
            attitude: None,
            evaluations: 100,
        }),
        design: None,
        adjustments: Vec::new(),
        findings: vec![Finding {
            severity: Severity::Extrapolated,
            model: "tauber-sutton".to_string(),
            key: input::design::NOSE_RADIUS_RATIO.to_string(),
            value: Some(0.1),
            valid: (Some(0.3), None),
            message: "The nose is smaller than the relation was fitted to.".to_string(),
            source: "Tauber and Sutton 1991".to_string(),
            field: None,
        }],
        passes: Vec::new(),
    }
}

/// A design that does not close: no numbers at all.
pub fn not_closed() -> Answer {
    Answer {
        name: "too large".to_string(),
        planet: PlanetNames {
            title: "Earth".to_string(),
            kml_target: Some("earth".to_string()),
        },
        outcome: Outcome::NotClosed,
        reason: Some("The payload fits at no diameter up to 2 m.".to_string()),
        flight: None,
        design: None,
        adjustments: vec![Adjustment {
            key: input::design::DIAMETER_M.to_string(),
            from: 0.5,
            to: 2.0,
            reason: "Grown to make room for the payload.".to_string(),
            source: "NASA/TM-2014-218507, section 3.1.2".to_string(),
        }],
        findings: Vec::new(),
        passes: Vec::new(),
    }
}
