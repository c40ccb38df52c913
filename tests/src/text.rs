//! Cases written as text in tests.

use msape::{Answer, Case, Library, Outcome, Request};

/// A planet with the figure of WGS84 and an exponential atmosphere, eastward entry over the equator.
pub const PLAIN: &str = "
schema = 'msape/1'
version = '0.2'
[planet]
equatorial_radius_m = 6378137.0
polar_radius_m = 6356752.3142
mu_m3_s2 = 3.986004418e14
j2 = 1.082626684e-3
rotation_rate_rad_s = 7.292115e-5
[atmosphere]
exponential = { density_kg_m3 = 1.225, scale_height_m = 7200.0 }
[heating]
radiative = 'none'
convective_margin = 1.0
[entry]
altitude_m = 125000.0
latitude_deg = 0.0
longitude_deg = 0.0
speed_m_s = 7800.0
flight_path_angle_deg = -6.0
azimuth_deg = 90.0
[stop]
altitude_m = 0.0
[vehicle]
mass_kg = 100.0
reference_area_m2 = 1.0
nose_radius_m = 0.5
drag_coefficient = 1.0
";

/// Case of a text with changed values for some keys.
///
/// # Panics
/// If the text is not a case.
pub fn case(text: &str, edits: &[(&str, &str)]) -> Case {
    let mut case = match Case::from_text(text) {
        Ok(case) => case,
        Err(faults) => panic!("{faults:?}"),
    };
    for (key, value) in edits {
        case.set(key, value);
    }
    case
}

/// Answer to a case, or all of its faults.
///
/// # Errors
/// All faults, one per line.
pub fn answer(case: &Case, request: Request) -> Result<Answer, String> {
    let library = match Library::builtin() {
        Ok(library) => library,
        Err(fault) => panic!("{fault}"),
    };
    msape::fly(case, &library, request).map_err(|faults| {
        let lines: Vec<String> = faults.iter().map(ToString::to_string).collect();
        lines.join("\n")
    })
}

/// Messages of all findings of a model.
pub fn said(answer: &Answer, model: &str) -> Vec<String> {
    let findings = answer
        .findings
        .iter()
        .filter(|finding| finding.model == model);
    findings.map(|finding| finding.message.clone()).collect()
}

/// Outcome and reason of an answer.
pub fn ended(answer: &Answer) -> (Outcome, String) {
    (answer.outcome, answer.reason.clone().unwrap_or_default())
}
