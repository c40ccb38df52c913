//! Checks the choice of heating models.

use super::forms::{beyond, choice};
use super::planet::{SAME_GAS, remark};
use crate::case::Reader;
use crate::heating::StagnationHeating;
use crate::heating::brandis_johnston::BrandisJohnston;
use crate::heating::convective::Convective;
use crate::heating::given::GivenHeating;
use crate::heating::given::body::{Along, BodyHeating};
use crate::heating::pressure::{PressureModel, StagnationPressure};
use crate::heating::radiative::Radiative;
use crate::heating::stagnation::ConvectiveOptions;
use crate::heating::wall::{Wall, WallGas};
use crate::library::{Library, World};
use std::sync::Arc;

/// Heating at the stagnation point on a planet, and the emissivity of the wall.
pub(super) fn heating(
    reader: &mut Reader,
    library: &Library,
    world: &World,
    gas_constant_j_kg_k: Option<f64>,
) -> Option<(StagnationHeating, f64)> {
    let name = &world.planet.name;
    let (table, body) = given(reader);
    let given_fluxes = table.is_some();
    let convective = match choice(reader, "heating.convective")? {
        _ if table.is_some() => table.clone().map(Convective::Given),
        "brandis-johnston" => brandis_johnston(reader, "heating.convective", world)
            .map(|both| Convective::BrandisJohnston(both.convective.clone())),
        "sutton-graves" => Some(Convective::SuttonGraves(world.sutton_graves.clone())),
        other => unknown(reader, "heating.convective", other),
    };
    let radiating = table.filter(|table| table.has_radiation());
    let radiative = match choice(reader, "heating.radiative")? {
        _ if radiating.is_some() => radiating.map(Radiative::Given),
        "none" => Some(Radiative::None),
        "brandis-johnston" => brandis_johnston(reader, "heating.radiative", world)
            .map(|both| Radiative::BrandisJohnston(both.radiative.clone())),
        "tauber-sutton" => {
            let relation = world.tauber_sutton.clone().map(Radiative::TauberSutton);
            if relation.is_none() {
                let message = format!(
                    "got \"tauber-sutton\", which has no relation for {name}; choose \"none\""
                );
                reader.fault("heating.radiative", message);
            }
            relation
        }
        other => unknown(reader, "heating.radiative", other),
    };
    let emissivity = reader.number("heating.wall_emissivity");
    let wall = choice(reader, "heating.wall");
    let model_factor = match given_fluxes {
        true => no_factor(reader),
        false => reader.number("heating.convective_model_factor"),
    };
    let convective_margin = reader.number("heating.convective_margin");
    let radiative_margin = reader.number("heating.radiative_margin");
    let pressure = choice(reader, "heating.stagnation_pressure").and_then(PressureModel::named);
    let emissivity = emissivity?;
    let options = ConvectiveOptions {
        model_factor: model_factor?,
        margin: convective_margin?,
        wall: match wall? {
            "radiative-equilibrium" => Wall::RadiativeEquilibrium { emissivity },
            _ => Wall::Cold,
        },
    };
    let heating = StagnationHeating {
        convective: convective?,
        options,
        radiative: radiative?,
        radiative_margin: radiative_margin?,
        body,
        gas: wall_gas(reader, &world.wall_gas, gas_constant_j_kg_k),
        pressure: StagnationPressure {
            model: pressure?,
            fit: library.heating.pressure_fit.clone(),
        },
    };
    Some((heating, emissivity))
}

/// The factor on heat fluxes that the case gives: none, as it corrects a relation.
fn no_factor(reader: &mut Reader) -> Option<f64> {
    let key = "heating.convective_model_factor";
    let factor = reader.number(key)?;
    if factor != 1.0 {
        let message = "The model factor is not used: it corrects a relation, and the case gives convective heat fluxes itself.";
        remark(reader, key, message.to_string());
    }
    Some(1.0)
}

/// The gas at the wall: that of the planet, or of the air that the case brings.
fn wall_gas(reader: &mut Reader, planets: &WallGas, gas_constant_j_kg_k: Option<f64>) -> WallGas {
    let own = ["atmosphere.table", "atmosphere.exponential.density_kg_m3"];
    let brought = own.iter().any(|key| reader.given(key));
    let key = "atmosphere.heat_capacity_ratio";
    let ratio = reader.given(key).then(|| reader.number(key)).flatten();
    let Some(gas_constant) = gas_constant_j_kg_k.filter(|_| brought) else {
        return planets.clone();
    };
    let over = gas_constant / planets.gas_constant_j_kg_k();
    // rounded columns make no other gas
    if ratio.is_none() && over < SAME_GAS && over * SAME_GAS > 1.0 {
        return planets.clone();
    }
    planets.clone().in_air(gas_constant, ratio)
}

/// Keys of the tables of heating.
const TABLES: [&str; 3] = ["heating.table", "heating.radius_table", "heating.arc_table"];

/// Heating that the case gives: the table of the stagnation point, and those along the body.
fn given(reader: &mut Reader) -> (Option<Arc<GivenHeating>>, Option<Arc<BodyHeating>>) {
    let rule = beyond(reader, "heating.extrapolation");
    let keys: Vec<&'static str> = TABLES.into_iter().filter(|key| reader.given(key)).collect();
    let key = match keys.as_slice() {
        [] => return (None, None),
        [key] => *key,
        [first, second, ..] => {
            reader.fault(
                second,
                format!("given together with {first}; give one of them"),
            );
            return (None, None);
        }
    };
    let Some(rows) = reader.rows(key) else {
        return (None, None);
    };
    let along = match key {
        "heating.radius_table" => Along::Radius,
        "heating.arc_table" => Along::Arc,
        _ => {
            let table = GivenHeating::try_new(key, &rows, rule);
            return (noted(reader, key, table).map(Arc::new), None);
        }
    };
    let body = noted(reader, key, BodyHeating::try_new(key, along, &rows, rule));
    let stagnation = body.as_ref().and_then(BodyHeating::stagnation).cloned();
    (stagnation.map(Arc::new), body.map(Arc::new))
}

/// What was made of rows, or `None` with all their faults noted.
fn noted<T>(reader: &mut Reader, key: &str, made: Result<T, Vec<String>>) -> Option<T> {
    let note = |fault: String| reader.fault(key, fault);
    made.map_err(|faults| faults.into_iter().for_each(note))
        .ok()
}

fn brandis_johnston<'l>(
    reader: &mut Reader,
    key: &str,
    world: &'l World,
) -> Option<&'l BrandisJohnston> {
    let both = world.brandis_johnston.as_ref();
    if both.is_none() {
        let name = &world.planet.name;
        reader.fault(
            key,
            format!("got \"brandis-johnston\", which is for the Earth, not for {name}"),
        );
    }
    both
}

/// The fault of a name that is among the choices of an input and of which nothing is known here.
fn unknown<T>(reader: &mut Reader, key: &str, name: &str) -> Option<T> {
    reader.fault(key, format!("got \"{name}\", a model that is not there"));
    None
}

#[cfg(test)]
mod tests {
    use crate::problem::FlightProblem;
    use crate::{Case, Library};

    #[test]
    fn a_hot_wall_has_the_gas_of_the_table_that_the_case_brings() {
        let text = crate::library::data_file("cases/stardust.toml").unwrap();
        let library = Library::builtin().unwrap();
        // p = ρ R T at two altitudes
        let gas_constant = |r: f64| {
            let row = |h: f64, rho: f64, t: f64| format!("[{h}, {rho:e}, {t}, {:e}]", rho * r * t);
            let rows = [row(0.0, 1.2, 280.0), row(2e5, 1e-9, 280.0)].join(", ");
            let mut case = Case::from_text(text).unwrap();
            case.set("heating.wall", "radiative-equilibrium");
            case.set("atmosphere.table", &format!("[{rows}]"));
            let problem = FlightProblem::check(&case, &library).unwrap();
            problem.mission.heating.gas.gas_constant_j_kg_k()
        };
        // carbon dioxide: 188.92 J/(kg K); air with a little rounding stays that of the planet
        assert!((gas_constant(188.92) / 188.92 - 1.0).abs() < 1e-6);
        let air = gas_constant(287.05);
        assert!(air == gas_constant(288.5) && (air / 287.05 - 1.0).abs() < 1e-3);
    }
}
