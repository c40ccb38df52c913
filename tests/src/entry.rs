//! Invented entries for tests: a body with constant drag coefficient over the report's Earth.

use msape::{Answer, Case, Library, Request};

/// An entry eastward from 125 km.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Entry {
    /// Speed relative to the planet, m/s.
    pub speed_m_s: f64,
    /// Flight path angle, negative downward, deg.
    pub flight_path_angle_deg: f64,
    /// Ballistic coefficient, kg/m².
    pub ballistic_coefficient_kg_m2: f64,
    /// Nose radius, m.
    pub nose_radius_m: f64,
}

impl Entry {
    /// The default entry of the report's run page with 60 kg/m².
    pub const RUN_PAGE: Entry = Entry {
        speed_m_s: 12_000.0,
        flight_path_angle_deg: -8.0,
        ballistic_coefficient_kg_m2: 60.0,
        nose_radius_m: 0.35,
    };

    /// The entry as a case: with an area of 1 m² and a drag coefficient of 1 the mass equals the ballistic coefficient.
    pub fn case(&self) -> Case {
        let mut case = Case {
            name: format!("{self:?}"),
            ..Case::default()
        };
        for (key, value) in [
            ("entry.altitude_m", 125_000.0),
            ("entry.latitude_deg", 33.0),
            ("entry.longitude_deg", 246.3833),
            ("entry.speed_m_s", self.speed_m_s),
            ("entry.flight_path_angle_deg", self.flight_path_angle_deg),
            ("entry.azimuth_deg", 90.0),
            ("heating.convective_margin", 1.0),
            ("vehicle.mass_kg", self.ballistic_coefficient_kg_m2),
            ("vehicle.reference_area_m2", 1.0),
            ("vehicle.nose_radius_m", self.nose_radius_m),
            ("vehicle.drag_coefficient", 1.0),
        ] {
            set(&mut case, key, value);
        }
        case
    }
}

/// Sets a key to a number.
pub fn set(case: &mut Case, key: &str, value: f64) {
    case.set(key, &format!("{value:?}"));
}

/// Flies a case that must be valid.
///
/// # Panics
/// With all faults, if the case is refused.
pub fn flown(case: &Case, library: &Library) -> Answer {
    flown_with(case, library, Request::Nothing)
}

/// Flies a case that must be valid, with a time history.
///
/// # Panics
/// With all faults, if the case is refused.
pub fn flown_with(case: &Case, library: &Library, request: Request) -> Answer {
    match msape::fly(case, library, request) {
        Ok(answer) => answer,
        Err(faults) => panic!("{}: {faults:?}", case.name),
    }
}

/// Output of an answer by its key; NaN where it did not occur.
///
/// # Panics
/// If there is no such output.
pub fn output(answer: &Answer, key: &str) -> f64 {
    let Some(output) = msape::answer::output::find(key) else {
        panic!("no output is called {key}");
    };
    (output.get)(answer).unwrap_or(f64::NAN)
}
