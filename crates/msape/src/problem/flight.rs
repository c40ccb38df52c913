//! Checks the mission, and the vehicle that is flown as it is.

use super::aerodynamics::{Medium, database, fitted_in_air, table_database, table_drag};
use super::entering::{above_end, altitude_at, descends, goes_on};
use super::forms::{beyond, choice, extrapolation};
use super::freedom::{CONSTANTS, Degrees, Known, degrees, drag_of_constants, freedom, length_m};
use super::heating::heating;
use super::outline::Outline;
use super::planet::{atmosphere, deep_enough, planet, reaching, wind};
use crate::aero::standard::AeroBody;
use crate::aero::{Drag, DragTable, Own};
use crate::case::Reader;
use crate::flight::mission::{
    Beyond, Body, DEFAULT_TOLERANCE, Mission, Model, Solver, Start, Stop,
};
use crate::flight::six_dof::aerodynamics::OfOutline;
use crate::library::{Library, named};
use crate::planet::Planet;
use crate::planet::geodetic::Geodetic;
use crate::planet::horizon::Velocity;
use numerics::math::{PI, RADIANS_PER_DEGREE};
use numerics::ode::Method;

/// Which flight-path angles a command takes.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Angle {
    /// Any.
    Any,
    /// Below the horizon: a design enters.
    Descending,
}

/// Everything about a flight but the vehicle.
pub(super) fn mission(reader: &mut Reader, library: &Library, angle: Angle) -> Option<Mission> {
    let planet = planet(reader, library);
    let atmosphere = atmosphere(reader, library, &planet);
    let planet = planet.map(|(planet, world)| (reaching(planet, atmosphere.as_ref()), world));
    let known = planet.as_ref().map(|(planet, _)| planet);
    let wind = wind(reader);
    let start = start(reader, known, angle);
    let stop = stop(reader, known);
    // Heating of a case whose planet is at fault is checked all the same.
    let default = library.planets.first().map(|(_, world)| world);
    let world = planet.as_ref().map(|(_, world)| *world).or(default);
    // where the vehicle is slowed, as for the ratio of heat capacities
    let gas_constant = known.zip(atmosphere.as_ref()).map(|(planet, atmosphere)| {
        let air = atmosphere.air(planet.exponential_fit_m[0]);
        air.pressure_pa / (air.density_kg_m3 * air.temperature_k)
    });
    let heating = world.and_then(|world| heating(reader, library, world, gas_constant));
    let solver = solver(reader);
    goes_on(reader, solver.as_ref());
    let (heating, wall_emissivity) = heating?;
    if let (Some(start), Some(solver)) = (&start, &solver) {
        descends(reader, start, solver, angle);
        if let (Angle::Descending, Some(planet)) =
            (angle, planet.as_ref().map(|(planet, _)| planet))
        {
            above_end(reader, planet, start, stop);
        }
    }
    Some(Mission {
        planet: planet?.0,
        atmosphere: atmosphere?,
        wind: wind?,
        start: start?,
        heating,
        wall_emissivity,
        phases: Vec::new(),
        stop,
        beyond: Beyond {
            atmosphere: beyond(reader, "atmosphere.extrapolation"),
            wind: beyond(reader, "wind.extrapolation"),
        },
        solver: solver?,
    })
}

fn start(reader: &mut Reader, planet: Option<&Planet>, angle: Angle) -> Option<Start> {
    let [altitude, radius] = ["entry.altitude_m", "entry.radius_m"].map(|key| reader.given(key));
    let altitude_m = altitude.then(|| reader.number("entry.altitude_m"));
    let radius_m = radius.then(|| reader.number("entry.radius_m"));
    match (altitude, radius) {
        (true, true) => reader.fault(
            "entry.radius_m",
            "given together with entry.altitude_m; give one of them",
        ),
        (false, false) => reader.missing("entry.altitude_m"),
        _ => {}
    }
    let mut angle_of = |key: &str| Some(reader.required_number(key)? * RADIANS_PER_DEGREE);
    let latitude_rad = angle_of("entry.latitude_deg");
    let longitude_rad = angle_of("entry.longitude_deg");
    let flight_path_angle_rad = angle_of("entry.flight_path_angle_deg");
    let azimuth_rad = angle_of("entry.azimuth_deg");
    let speed_m_s = reader.required_number("entry.speed_m_s");
    let frame = choice(reader, "entry.frame");
    if let (Angle::Descending, Some(gamma)) = (angle, flight_path_angle_rad)
        && gamma >= 0.0
    {
        let got = gamma / RADIANS_PER_DEGREE;
        let message = format!(
            "got {got} deg, must be -90 to below 0 deg: a design enters, so its angle points below the horizon"
        );
        reader.fault("entry.flight_path_angle_deg", message);
    }
    let planet = planet?;
    let (latitude_rad, longitude_rad) = (latitude_rad?, longitude_rad?);
    let altitude_m = match (altitude_m.flatten(), radius_m.flatten()) {
        (Some(altitude_m), _) => altitude_m,
        (None, Some(radius_m)) => altitude_at(planet, radius_m, latitude_rad),
        (None, None) => return None,
    };
    let key = match radius {
        true => "entry.radius_m",
        false => "entry.altitude_m",
    };
    deep_enough(reader, key, altitude_m, planet);
    let place = Geodetic {
        altitude_m,
        latitude_rad,
        longitude_rad,
    };
    let position_m = planet.cartesian_m(&place);
    let horizon = planet.horizon(position_m);
    let given = Velocity {
        speed_m_s: speed_m_s?,
        flight_path_angle_rad: flight_path_angle_rad?,
        azimuth_rad: azimuth_rad?.rem_euclid(2.0 * PI),
    };
    let (relative, inertial) = match frame? {
        "inertial" => (planet.relative_from_inertial(position_m, &given), given),
        _ => (given, planet.inertial_from_relative(position_m, &given)),
    };
    Some(Start {
        position_m,
        velocity_m_s: horizon.cartesian_m_s(&relative),
        relative,
        inertial,
    })
}

fn stop(reader: &mut Reader, planet: Option<&Planet>) -> Stop {
    let altitude_m = reader.number("stop.altitude_m");
    if let (Some(altitude_m), Some(planet)) = (altitude_m, planet) {
        deep_enough(reader, "stop.altitude_m", altitude_m, planet);
    }
    let time_s = reader.number("stop.time_s");
    let passes = reader.number("stop.passes");
    let nothing_given = !reader.given("stop.altitude_m") && !reader.given("stop.time_s");
    Stop {
        altitude_m: if nothing_given { Some(0.0) } else { altitude_m },
        time_s,
        passes: passes.map(|passes| passes as u32),
    }
}

fn solver(reader: &mut Reader) -> Option<Solver> {
    let tolerance = reader
        .number("solver.tolerance")
        .unwrap_or(DEFAULT_TOLERANCE);
    let step = reader.number("solver.step_s");
    let method = match choice(reader, "solver.method")? {
        "dormand-prince-853" => Method::DormandPrince853,
        "rk4" => Method::Rk4 { step: step? },
        _ => Method::DormandPrince54,
    };
    let model = match choice(reader, "solver.flight_model")? {
        "allen-eggers" => Model::AllenEggers,
        _ => Model::ThreeDof,
    };
    Some(Solver {
        model,
        method,
        tolerance,
    })
}

/// The vehicle that is flown as it is.
pub(super) fn body(
    reader: &mut Reader,
    library: &Library,
    mission: Option<&Mission>,
    outline: &Outline,
) -> Option<Body> {
    let degrees = degrees(reader);
    let mass_kg = reader.required_number("vehicle.mass_kg");
    let nose_radius_m = match (reader.given("vehicle.nose_radius_m"), outline) {
        (false, Outline::Faulty) => None,
        (false, Outline::Body(body)) if body.nose_radius_m.is_some() => body.nose_radius_m,
        _ => reader.required_number("vehicle.nose_radius_m"),
    };
    let area_of_outline_m2 = match outline {
        Outline::Body(body) => Some(body.reference_area_m2()),
        _ => None,
    };
    let area_m2 = reader.number("vehicle.reference_area_m2");
    let diameter_m = reader.number("vehicle.diameter_m");
    let given = ["vehicle.reference_area_m2", "vehicle.diameter_m"].map(|key| reader.given(key));
    match given {
        [true, true] => reader.fault(
            "vehicle.diameter_m",
            "given together with vehicle.reference_area_m2; give one of them",
        ),
        [false, false] if *outline == Outline::Absent => reader.fault(
            "vehicle.reference_area_m2",
            "missing; give it, in m^2, or vehicle.diameter_m, in m",
        ),
        _ => {}
    }
    let medium = Medium::of(mission, library);
    let mut drag = drag(reader, library, medium.as_ref(), degrees, outline);
    let mut database = None;
    let at_trim = reader.flag("vehicle.trim") == Some(true) && degrees == Some(Degrees::Three);
    if at_trim && !by_database(reader, outline) {
        let message = "got true, which needs coefficients over the angle of attack; give an [outline] or vehicle.aerodynamics.table";
        reader.fault("vehicle.trim", message);
    }
    if (degrees == Some(Degrees::Six) || at_trim) && by_database(reader, outline) {
        database = of_outline(
            reader,
            library,
            medium.as_ref(),
            outline,
            drag.as_ref(),
            diameter_m,
        );
        // Attitude tells the drag; that of Mach 25 nose first is for what has no attitude.
        drag = match (drag, &database) {
            (Some(Drag::Table(table)), Some(_)) => Some(Drag::Constant(table.at(25.0))),
            (drag, Some(_)) => drag,
            (_, None) => None,
        };
    }
    let area_m2 = area_m2
        .or(diameter_m.map(|d| 0.25 * PI * d * d))
        .or(area_of_outline_m2);
    let length_m = length_m(reader, diameter_m, area_m2);
    let known = Known {
        degrees: degrees?,
        mission,
        area_m2,
        length_m,
        database,
        outline,
        at_trim,
    };
    let freedom = freedom(reader, known);
    Some(Body {
        mass_kg: mass_kg?,
        reference_area_m2: area_m2?,
        nose_radius_m: nose_radius_m?,
        drag: drag?,
        reference_length_m: length_m?,
        freedom: freedom?,
    })
}

/// Whether force and moment of a rigid body come from a database: where it has an outline, a name or a table.
fn by_database(reader: &Reader, outline: &Outline) -> bool {
    let constants = CONSTANTS.iter().any(|key| reader.given(key));
    let named = ["vehicle.aerodynamics", "vehicle.aerodynamics.table"];
    let named = named.iter().any(|key| reader.given(key));
    !constants && (named || *outline != Outline::Absent)
}

/// The database of a rigid body, from its outline or from a table.
fn of_outline(
    reader: &mut Reader,
    library: &Library,
    medium: Option<&Medium>,
    outline: &Outline,
    drag: Option<&Drag>,
    diameter_m: Option<f64>,
) -> Option<OfOutline> {
    let database = match outline {
        Outline::Body(body) => database(
            reader,
            library,
            medium?,
            &AeroBody::of_rigid(body, None),
            Some(drag?),
        ),
        Outline::Faulty => None,
        Outline::Absent if reader.given("vehicle.aerodynamics.table") => {
            let key = "vehicle.diameter_m";
            if !reader.given(key) {
                reader.fault(key, "missing; with vehicle.dof = 6 the moments of a table have it as their length, in m");
            }
            table_database(reader, library, medium?, diameter_m?)
        }
        Outline::Absent => {
            reader.fault("vehicle.aerodynamics", "has axial force alone; with vehicle.dof = 6 give an [outline] from which the rest is computed, or constants in [vehicle.aerodynamics]");
            None
        }
    }?;
    Some(OfOutline {
        database,
        axial_force: match drag {
            Some(Drag::Table(table)) => Some(table.clone()),
            _ => None,
        },
    })
}

fn drag(
    reader: &mut Reader,
    library: &Library,
    medium: Option<&Medium>,
    degrees: Option<Degrees>,
    outline: &Outline,
) -> Option<Drag> {
    let constants = CONSTANTS.into_iter().find(|key| reader.given(key));
    let keys = [
        "vehicle.drag_coefficient",
        "vehicle.drag_table",
        "vehicle.aerodynamics",
        "vehicle.aerodynamics.table",
    ];
    let given: Vec<&str> = keys.into_iter().filter(|key| reader.given(key)).collect();
    match given.as_slice() {
        [] if constants.is_some() => drag_of_constants(reader),
        [] => match outline {
            Outline::Body(body) => {
                let heat_capacity_ratio = medium?.heat_capacity_ratio;
                fitted_in_air(reader, heat_capacity_ratio, None);
                let forces = library.axial_forces().in_gas(heat_capacity_ratio);
                Some(Drag::Table(
                    forces.of_outline(&AeroBody::of_rigid(body, None)),
                ))
            }
            Outline::Faulty => None,
            // A body on which the air does not act.
            Outline::Absent if degrees != Some(Degrees::Three) => Some(Drag::Constant(0.0)),
            Outline::Absent => {
                let message = "missing; give it, or vehicle.drag_table, or vehicle.aerodynamics, or [outline]";
                reader.fault("vehicle.drag_coefficient", message);
                None
            }
        },
        [first, ..] if constants.is_some() => {
            let message = format!("given together with {first}; give one of them");
            reader.fault(constants.unwrap_or_default(), message);
            None
        }
        [only] if *only == keys[0] => reader
            .number("vehicle.drag_coefficient")
            .map(Drag::Constant),
        [only] if *only == keys[3] => {
            let diameter_m = match outline {
                Outline::Body(body) => body.diameter_m,
                _ => reader.number("vehicle.diameter_m").unwrap_or(1.0),
            };
            table_drag(reader, medium?, diameter_m)
        }
        [only] if *only == keys[1] => {
            let rows: Vec<(f64, f64)> = reader
                .rows("vehicle.drag_table")?
                .iter()
                .filter_map(|row| Some((*row.first()?, *row.get(1)?)))
                .collect();
            let own = Own {
                key: "vehicle.drag_table",
                extrapolation: extrapolation(reader),
            };
            match DragTable::try_new(&rows) {
                Ok(table) => Some(Drag::Table(table.of_case(own))),
                Err(faults) => {
                    faults
                        .iter()
                        .for_each(|fault| reader.fault("vehicle.drag_table", fault.as_str()));
                    None
                }
            }
        }
        [_] => {
            let names: Vec<&str> = library
                .aerodynamics
                .iter()
                .map(|(name, _)| name.as_str())
                .collect();
            let name = reader.choice("vehicle.aerodynamics", &names)?;
            let force = named(&library.aerodynamics, name)?;
            if let Outline::Body(body) = outline {
                let finding =
                    force.other_cone(name, body.cone_half_angle_rad, "vehicle.aerodynamics");
                reader.findings.extend(finding);
            }
            fitted_in_air(reader, medium?.heat_capacity_ratio, Some(name));
            Some(Drag::Table(force.table.clone()))
        }
        [_, second, ..] => {
            reader.fault(second, "drag is given in more than one way; give one of drag_coefficient, drag_table, aerodynamics");
            None
        }
    }
}
