//! Checks that a start comes down where only a descent can be flown, and remarks on the closed form.

use super::flight::Angle;
use super::forms::beyond;
use crate::aero::table::Extrapolation;
use crate::case::Reader;
use crate::flight::mission::{Model, Solver, Start, Stop};
use crate::planet::Planet;
use crate::planet::geodetic::Geodetic;
use crate::planet::horizon::Velocity;
use crate::quantity::input::{self, BEYOND_TABLES};
use numerics::math::RADIANS_PER_DEGREE;
use numerics::root;

/// The remark that the closed form ends no flight at the end of a table.
pub(super) fn goes_on(reader: &mut Reader, solver: Option<&Solver>) {
    if solver.is_none_or(|solver| solver.model != Model::AllenEggers) {
        return;
    }
    for input in BEYOND_TABLES {
        if reader.given(input) && beyond(reader, input) == Extrapolation::Refuse {
            let message =
                "The closed form does not end where it leaves a table: \"refuse\" is not used.";
            reader.remark(input, message);
        }
    }
}

/// The fault of a design that begins below the altitude at which it ends.
pub(super) fn above_end(reader: &mut Reader, planet: &Planet, start: &Start, stop: Stop) {
    let start_m = planet.local(start.position_m).altitude_m;
    let ground_m = stop.altitude_m.unwrap_or(0.0);
    if start_m <= ground_m {
        let message = format!(
            "got {start_m:.0} m, must be above the final altitude of {ground_m} m: a design enters"
        );
        reader.fault(&input::entry::ALTITUDE_M, message);
    }
}

/// Faults of a start from which the closed form does not come down: it flies the early passes of a design, too.
pub(super) fn descends(reader: &mut Reader, start: &Start, solver: &Solver, angle: Angle) {
    let who = match (angle, solver.model) {
        (Angle::Descending, _) => "a design enters",
        (Angle::Any, Model::AllenEggers) => "the closed form enters",
        (Angle::Any, _) => return,
    };
    let Velocity {
        speed_m_s,
        flight_path_angle_rad,
        ..
    } = start.relative;
    if speed_m_s == 0.0 {
        let message = format!("got 0 m/s relative to the planet, must be above 0 m/s: {who}");
        reader.fault(&input::entry::SPEED_M_S, message);
    } else if flight_path_angle_rad >= 0.0 && angle == Angle::Any {
        let message = format!(
            "got {:.3} deg relative to the planet, must be below 0 deg: {who}",
            flight_path_angle_rad / RADIANS_PER_DEGREE
        );
        reader.fault(&input::entry::FLIGHT_PATH_ANGLE_DEG, message);
    }
}

/// Geodetic altitude at which a point of given geodetic latitude is at a distance from the center, m.
pub(super) fn altitude_at(planet: &Planet, radius_m: f64, latitude_rad: f64) -> f64 {
    let excess = |altitude_m: f64| {
        let [x, y, z] = planet.cartesian_m(&Geodetic {
            altitude_m,
            latitude_rad,
            longitude_rad: 0.0,
        });
        (x * x + y * y + z * z).sqrt() - radius_m
    };
    // The distance is within the flattening of altitude plus equatorial radius.
    let guess_m = radius_m - planet.equatorial_radius_m;
    let reach_m = 2.0 * (planet.equatorial_radius_m - planet.polar_radius_m) + 1.0;
    root::brent(excess, guess_m - reach_m, guess_m + reach_m, 1e-9).unwrap_or(guess_m)
}
