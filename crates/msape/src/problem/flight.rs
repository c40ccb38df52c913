//! Checks the mission, and the vehicle that is flown as it is.

use super::aerodynamics::{Coefficients, Medium, OwnTable, noted_database, table_drag};
use super::entering::{above_end, altitude_at, descends, goes_on};
use super::fitted_in_air::fitted_in_air;
use super::forms::{beyond, together};
use super::freedom::{Degrees, Known, degrees, drag_of_constants, freedom, length_m};
use super::heating::heating;
use super::outline::Outline;
use super::planet::{atmosphere, deep_enough, planet, reaching, wind};
use crate::aero::standard::AeroBody;
use crate::aero::{Drag, DragTable, Own};
use crate::case::Reader;
use crate::flight::mission::{Beyond, Body, DEFAULT_TOLERANCE, Mission, Solver, Start, Stop};
use crate::flight::six_dof::aerodynamics::OfOutline;
use crate::library::{Library, named, names};
use crate::planet::Planet;
use crate::planet::geodetic::Geodetic;
use crate::planet::horizon::Velocity;
use crate::quantity::choice::{Frame, MethodName};
use crate::quantity::input::vehicle::CONSTANTS;
use crate::quantity::input::{self, Input};
use numerics::math::{PI, RADIANS_PER_DEGREE};
use numerics::ode::Method;

/// Flight-path angles that a command accepts.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Angle {
    /// Any.
    Any,
    /// Below the horizon: a design enters.
    Descending,
}

/// Checks all of a flight but the vehicle.
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
            atmosphere: beyond(reader, &input::atmosphere::EXTRAPOLATION),
            wind: beyond(reader, &input::wind::EXTRAPOLATION),
        },
        solver: solver?,
    })
}

fn start(reader: &mut Reader, planet: Option<&Planet>, angle: Angle) -> Option<Start> {
    let [altitude, radius] = [&input::entry::ALTITUDE_M, &input::entry::RADIUS_M];
    let of = |reader: &mut Reader, input| reader.given(input).then(|| reader.number(input));
    let altitude_m = of(reader, altitude);
    let radius_m = of(reader, radius);
    let ways = reader.ways(&input::entry::START);
    match ways.as_slice() {
        [] => reader.missing(altitude),
        [_] => {}
        [first, second, ..] => together(reader, *second, first),
    }
    let mut angle_of = |input| Some(reader.required_number(input)? * RADIANS_PER_DEGREE);
    let latitude_rad = angle_of(&input::entry::LATITUDE_DEG);
    let longitude_rad = angle_of(&input::entry::LONGITUDE_DEG);
    let flight_path_angle_rad = angle_of(&input::entry::FLIGHT_PATH_ANGLE_DEG);
    let azimuth_rad = angle_of(&input::entry::AZIMUTH_DEG);
    let speed_m_s = reader.required_number(&input::entry::SPEED_M_S);
    let frame = reader.choice(&input::entry::FRAME);
    if let (Angle::Descending, Some(gamma)) = (angle, flight_path_angle_rad)
        && gamma >= 0.0
    {
        let got = gamma / RADIANS_PER_DEGREE;
        let message = format!(
            "got {got} deg, must be -90 to below 0 deg: a design enters, so its angle points below the horizon"
        );
        reader.fault(&input::entry::FLIGHT_PATH_ANGLE_DEG, message);
    }
    let planet = planet?;
    let (latitude_rad, longitude_rad) = (latitude_rad?, longitude_rad?);
    let altitude_m = match (altitude_m.flatten(), radius_m.flatten()) {
        (Some(altitude_m), _) => altitude_m,
        (None, Some(radius_m)) => altitude_at(planet, radius_m, latitude_rad),
        (None, None) => return None,
    };
    deep_enough(reader, ways.last()?, altitude_m, planet);
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
        Frame::Inertial => (planet.relative_from_inertial(position_m, &given), given),
        Frame::Relative => (given, planet.inertial_from_relative(position_m, &given)),
    };
    Some(Start {
        position_m,
        velocity_m_s: horizon.cartesian_m_s(&relative),
        relative,
        inertial,
    })
}

fn stop(reader: &mut Reader, planet: Option<&Planet>) -> Stop {
    let altitude_m = reader.number(&input::stop::ALTITUDE_M);
    if let (Some(altitude_m), Some(planet)) = (altitude_m, planet) {
        deep_enough(reader, &input::stop::ALTITUDE_M, altitude_m, planet);
    }
    let time_s = reader.number(&input::stop::TIME_S);
    let passes = reader.number(&input::stop::PASSES);
    let nothing_given =
        !reader.given(&input::stop::ALTITUDE_M) && !reader.given(&input::stop::TIME_S);
    Stop {
        altitude_m: if nothing_given { Some(0.0) } else { altitude_m },
        time_s,
        passes: passes.map(|passes| passes as u32),
    }
}

fn solver(reader: &mut Reader) -> Option<Solver> {
    let tolerance = reader
        .number(&input::solver::TOLERANCE)
        .unwrap_or(DEFAULT_TOLERANCE);
    let step = reader.number(&input::solver::STEP_S);
    let method = match reader.choice(&input::solver::METHOD)? {
        MethodName::DormandPrince54 => Method::DormandPrince54,
        MethodName::DormandPrince853 => Method::DormandPrince853,
        MethodName::Rk4 => Method::Rk4 { step: step? },
    };
    Some(Solver {
        model: reader.choice(&input::solver::FLIGHT_MODEL)?,
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
    let mass_kg = reader.required_number(&input::vehicle::MASS_KG);
    let nose_radius_m = match (reader.given(&input::vehicle::NOSE_RADIUS_M), outline) {
        (false, Outline::Faulty) => None,
        (false, Outline::Body(body)) if body.nose_radius_m.is_some() => body.nose_radius_m,
        _ => reader.required_number(&input::vehicle::NOSE_RADIUS_M),
    };
    let area_of_outline_m2 = match outline {
        Outline::Body(body) => Some(body.reference_area_m2()),
        _ => None,
    };
    let area_m2 = reader.number(&input::vehicle::REFERENCE_AREA_M2);
    let diameter_m = reader.number(&input::vehicle::DIAMETER_M);
    match reader.ways(&input::vehicle::AREA).as_slice() {
        [first, second, ..] => together(reader, *second, first),
        [] if *outline == Outline::Absent => {
            let diameter = &input::vehicle::DIAMETER_M;
            let message = format!("missing; give it, in m^2, or {diameter}, in m");
            reader.fault(&input::vehicle::REFERENCE_AREA_M2, message);
        }
        _ => {}
    }
    let medium = Medium::of(mission, library);
    let mut drag = drag(reader, library, medium.as_ref(), degrees, outline);
    let mut database = None;
    let at_trim =
        reader.flag(&input::vehicle::TRIM) == Some(true) && degrees == Some(Degrees::Three);
    if at_trim && !by_database(reader, outline) {
        let message = format!(
            "got true, which needs coefficients over the angle of attack; give an [outline] or {}",
            input::vehicle::AERODYNAMICS_TABLE
        );
        reader.fault(&input::vehicle::TRIM, message);
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
        // with attitude, drag follows from it; the drag at Mach 25, nose first, serves computations without attitude
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
    let named = [
        &input::vehicle::AERODYNAMICS,
        &input::vehicle::AERODYNAMICS_TABLE,
    ];
    !reader.any_given(CONSTANTS) && (reader.any_given(&named) || *outline != Outline::Absent)
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
        Outline::Body(body) => {
            let body = AeroBody::of_rigid(body, None);
            let diameter_m = body.surface.diameter_m();
            let drag = Some(drag?);
            let read = Coefficients::read(reader, library, medium?, diameter_m, drag)?;
            read.noted(reader, &body)
        }
        Outline::Faulty => None,
        Outline::Absent if reader.given(&input::vehicle::AERODYNAMICS_TABLE) => {
            let diameter = &input::vehicle::DIAMETER_M;
            if !reader.given(diameter) {
                let dof = &input::vehicle::DOF;
                let message = format!(
                    "missing; with {dof} = 6 the moments of a table have it as their length, in m"
                );
                reader.fault(diameter, message);
            }
            let diameter_m = diameter_m?;
            let table = OwnTable::read(reader, library, medium?, diameter_m)?;
            noted_database(reader, table.database(diameter_m))
        }
        Outline::Absent => {
            let (named, dof) = (&input::vehicle::AERODYNAMICS, &input::vehicle::DOF);
            let message = format!(
                "has axial force alone; with {dof} = 6 give an [outline] from which the rest is computed, or constants in [{named}]"
            );
            reader.fault(named, message);
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
    let ways = reader.ways(&input::vehicle::DRAG);
    // the constants are the last way
    let constants = ways.last().filter(|last| CONSTANTS.contains(*last));
    match ways.as_slice() {
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
                let [table, named] = [&input::vehicle::DRAG_TABLE, &input::vehicle::AERODYNAMICS];
                let message = format!("missing; give it, or {table}, or {named}, or [outline]");
                reader.fault(&input::vehicle::DRAG_COEFFICIENT, message);
                None
            }
        },
        [_] if constants.is_some() => drag_of_constants(reader),
        [only] => drag_of(reader, library, medium, outline, only),
        [first, second, ..] => {
            match constants {
                Some(constant) => together(reader, *constant, first),
                None => reader.fault(second, "drag is given in more than one way; give one of drag_coefficient, drag_table, aerodynamics"),
            }
            None
        }
    }
}

/// Drag in the way in which the case gives it.
fn drag_of(
    reader: &mut Reader,
    library: &Library,
    medium: Option<&Medium>,
    outline: &Outline,
    way: &'static Input,
) -> Option<Drag> {
    if *way == input::vehicle::DRAG_COEFFICIENT {
        return reader.number(way).map(Drag::Constant);
    }
    if *way == input::vehicle::AERODYNAMICS_TABLE {
        let diameter_m = match outline {
            Outline::Body(body) => body.diameter_m,
            _ => reader.number(&input::vehicle::DIAMETER_M).unwrap_or(1.0),
        };
        return table_drag(reader, medium?, diameter_m);
    }
    if *way == input::vehicle::DRAG_TABLE {
        let rows: Vec<(f64, f64)> = reader
            .rows(way)?
            .iter()
            .filter_map(|row| Some((*row.first()?, *row.get(1)?)))
            .collect();
        let own = Own {
            key: way.key,
            extrapolation: beyond(reader, &input::vehicle::AERODYNAMICS_EXTRAPOLATION),
        };
        return match DragTable::try_new(&rows) {
            Ok(table) => Some(Drag::Table(table.of_case(own))),
            Err(faults) => {
                faults
                    .iter()
                    .for_each(|fault| reader.fault(way, fault.as_str()));
                None
            }
        };
    }
    let name = reader.name(way, &names(&library.aerodynamics))?;
    let force = named(&library.aerodynamics, name)?;
    if let Outline::Body(body) = outline {
        let finding = force.other_cone(name, body.cone_half_angle_rad, way.key);
        reader.findings.extend(finding);
    }
    fitted_in_air(reader, medium?.heat_capacity_ratio, Some(name));
    Some(Drag::Table(force.table.clone()))
}
