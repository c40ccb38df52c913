//! Conditions at the wall: from the tables of a case, or from its flight.
//!
//! ```text
//! C_H = 2 q̇ / V²        h_r = V²/2 + h(T∞)
//! ```
//!
//! with q̇ the convective heat flux to a cold wall in W/m², V the speed in m/s, h the enthalpy of the planet's gas in J/kg against
//! 298.15 K. A cold wall has nearly the enthalpy of the air before the shock, so that h_r − h_w is V²/2 there and the ratio stays
//! finite at rest.
//!
//! # Valid
//! Hypersonic; chemistry ends where the convective heat flux falls below 1e-4 of its maximum (assumed), then the wall only radiates.
//!
//! # References
//! - \[samareh-2014\] section 3.4.

use crate::case::{Case, Reader};
use crate::flight::{Request, Trajectory};
use crate::library::{Library, named};
use crate::problem::{design, fly};
use crate::quantity::input;
use crate::quantity::input::{Input, tps};
use ::ablation::environment::{Environment, Heating, Held};
use ::ablation::fault::Fault;
use ::ablation::solid::REFERENCE_TEMPERATURE_K;

/// Share of the largest convective heat flux below which the boundary layer no longer reaches the wall. Assumed.
const ENDS_AT: f64 = 1e-4;

/// A flight for the heat shield in depth.
pub(super) struct Flown {
    rows: Vec<(f64, Heating)>,
    /// Name of the card of the designed heat shield, and its thickness, m.
    pub heat_shield: Option<(String, f64)>,
}

/// The flight or design of a case without an environment; `None` where it has one, or is at fault.
pub(super) fn flown(reader: &mut Reader, case: &Case, library: &Library) -> Option<Flown> {
    if reader.any_given(&[
        &tps::ENVIRONMENT_TABLE,
        &tps::SURFACE_TEMPERATURE_TABLE,
        &tps::ENVIRONMENT,
        &tps::SURFACE_TEMPERATURE,
    ]) {
        return None;
    }
    if !reader.any_given(input::entry::INPUTS) {
        reader.fault(
            &tps::ENVIRONMENT,
            format!(
                "missing; give {}, {}, or a flight",
                tps::ENVIRONMENT,
                tps::SURFACE_TEMPERATURE
            ),
        );
        return None;
    }
    let designs = case.gives_any(input::design::INPUTS);
    let answer = match designs {
        true => design(case, library, Request::Steps),
        false => fly(case, library, Request::Steps),
    };
    let answer = match answer {
        Ok(answer) => answer,
        Err(faults) => {
            reader.faults.extend(faults);
            return None;
        }
    };
    let names: Vec<&str> = library
        .planets
        .iter()
        .map(|(name, _)| name.as_str())
        .collect();
    let planet = reader
        .name(&input::entry::PLANET, &names)
        .unwrap_or("earth");
    let world = named(&library.planets, planet);
    let trajectory = answer
        .flight
        .as_ref()
        .and_then(|flight| flight.trajectory.as_ref());
    let rows = trajectory.zip(world).and_then(|(trajectory, world)| {
        let h = |t: f64| {
            world.wall_gas.enthalpy_j_kg(t) - world.wall_gas.enthalpy_j_kg(REFERENCE_TEMPERATURE_K)
        };
        rows(trajectory, h)
    });
    let Some(rows) = rows else {
        reader.fault(
            &tps::ENVIRONMENT,
            format!(
                "missing, and the case has no flight: it is {}",
                answer.outcome.name()
            ),
        );
        return None;
    };
    let heat_shield = answer.design.as_ref().and_then(|design| {
        let concept = reader.text(&input::design::FOREBODY_TPS);
        let concept = concept
            .as_deref()
            .or(match input::design::FOREBODY_TPS.preset {
                input::Preset::Name(name) => Some(name),
                _ => None,
            })?;
        let stack = named(&library.concepts, concept)?;
        Some((
            stack.concept.tps.clone(),
            design.vehicle.layout.depths.forebody_tps_m,
        ))
    });
    Some(Flown { rows, heat_shield })
}

/// Rows of a trajectory as conditions at the wall.
fn rows(trajectory: &Trajectory, enthalpy: impl Fn(f64) -> f64) -> Option<Vec<(f64, Heating)>> {
    let column = |key: &str| trajectory.column(key);
    let [time, speed, pressure, convective, radiative, temperature] = [
        column("time_s")?,
        column("speed_m_s")?,
        column("stagnation_pressure_pa")?,
        column("convective_heat_flux_w_m2")?,
        column("radiative_heat_flux_w_m2")?,
        column("temperature_k")?,
    ];
    let most = convective.iter().copied().fold(0.0, f64::max);
    let peak = convective.iter().position(|q| *q == most)?;
    let mut rows: Vec<(f64, Heating)> = Vec::with_capacity(time.len());
    for i in 0..time.len() {
        if rows.last().is_some_and(|(before, _)| *before >= time[i]) {
            continue;
        }
        let v2 = speed[i] * speed[i];
        let chemistry = i <= peak || convective[i] >= ENDS_AT * most;
        let heating = Heating {
            pressure_pa: pressure[i],
            transfer_kg_m2s: if v2 > 0.0 {
                2.0 * convective[i] / v2
            } else {
                0.0
            },
            recovery_j_kg: 0.5 * v2 + enthalpy(temperature[i]),
            radiative_w_m2: radiative[i],
            chemistry,
        };
        rows.push((time[i], heating));
    }
    Some(rows)
}

/// Conditions at the wall with a margin on heating; `None` where they are at fault.
pub(super) fn environment(
    reader: &mut Reader,
    flown: Option<&Flown>,
    margin: f64,
) -> Option<Environment> {
    if let Some(flown) = flown {
        let rows: Vec<_> = flown
            .rows
            .iter()
            .map(|(t, heating)| (*t, margined(*heating, margin)))
            .collect();
        return made(reader, &tps::ENVIRONMENT, Environment::heated(&rows));
    }
    let [environment, surface] =
        [&tps::ENVIRONMENT_TABLE, &tps::SURFACE_TEMPERATURE_TABLE].map(|input| reader.given(input));
    match (environment, surface) {
        (true, true) => {
            reader.fault(
                &tps::SURFACE_TEMPERATURE_TABLE,
                format!(
                    "given together with {}; give one of them",
                    tps::ENVIRONMENT_TABLE
                ),
            );
            None
        }
        (true, false) => {
            let rows = reader.rows(&tps::ENVIRONMENT_TABLE)?;
            let rows: Vec<_> = rows
                .iter()
                .map(|row| (cell(row, 0, 0.0), margined(heating(row), margin)))
                .collect();
            made(reader, &tps::ENVIRONMENT_TABLE, Environment::heated(&rows))
        }
        (false, true) => {
            let rows = reader.rows(&tps::SURFACE_TEMPERATURE_TABLE)?;
            let held = |row: &Vec<f64>| Held {
                temperature_k: cell(row, 1, 0.0),
                pressure_pa: cell(row, 2, 0.0),
                recession_m_s: cell(row, 3, 0.0),
            };
            let rows: Vec<_> = rows
                .iter()
                .map(|row| (cell(row, 0, 0.0), held(row)))
                .collect();
            made(
                reader,
                &tps::SURFACE_TEMPERATURE_TABLE,
                Environment::held(&rows),
            )
        }
        (false, false) => None,
    }
}

fn cell(row: &[f64], i: usize, otherwise: f64) -> f64 {
    row.get(i).copied().unwrap_or(otherwise)
}

fn heating(row: &[f64]) -> Heating {
    Heating {
        pressure_pa: cell(row, 1, 0.0),
        transfer_kg_m2s: cell(row, 2, 0.0),
        recovery_j_kg: cell(row, 3, 0.0),
        radiative_w_m2: cell(row, 4, 0.0),
        chemistry: cell(row, 5, 1.0) != 0.0,
    }
}

fn margined(heating: Heating, margin: f64) -> Heating {
    Heating {
        transfer_kg_m2s: margin * heating.transfer_kg_m2s,
        radiative_w_m2: margin * heating.radiative_w_m2,
        ..heating
    }
}

fn made(
    reader: &mut Reader,
    input: &'static Input,
    made: Result<Environment, Fault>,
) -> Option<Environment> {
    match made {
        Ok(environment) => Some(environment),
        Err(fault) => {
            reader.fault(input, fault.to_string());
            None
        }
    }
}
