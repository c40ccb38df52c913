//! Checks the choice of heating models.

use super::forms::{beyond, together};
use super::planet::SAME_GAS;
use crate::case::Reader;
use crate::heating::StagnationHeating;
use crate::heating::brandis_johnston::BrandisJohnston;
use crate::heating::convective::Convective;
use crate::heating::given::GivenHeating;
use crate::heating::given::body::{Along, BodyHeating};
use crate::heating::pressure::StagnationPressure;
use crate::heating::radiative::Radiative;
use crate::heating::stagnation::ConvectiveOptions;
use crate::heating::wall::{Wall, WallGas};
use crate::library::{Library, World};
use crate::quantity::choice::{ConvectiveModel, RadiativeModel, WallModel};
use crate::quantity::input::{self, Input};
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
    let model = reader.choice(&input::heating::CONVECTIVE)?;
    let of_relation = |reader: &mut Reader| match model {
        ConvectiveModel::BrandisJohnston => {
            brandis_johnston(reader, &input::heating::CONVECTIVE, world)
                .map(|both| Convective::BrandisJohnston(both.convective.clone()))
        }
        ConvectiveModel::SuttonGraves => {
            Some(Convective::SuttonGraves(world.sutton_graves.clone()))
        }
    };
    let convective = match &table {
        Some(table) => Some(Convective::Given(table.clone())),
        None => of_relation(reader),
    };
    let radiating = table.filter(|table| table.has_radiation());
    let model = reader.choice(&input::heating::RADIATIVE)?;
    let of_relation = |reader: &mut Reader| match model {
        RadiativeModel::None => Some(Radiative::None),
        RadiativeModel::BrandisJohnston => {
            brandis_johnston(reader, &input::heating::RADIATIVE, world)
                .map(|both| Radiative::BrandisJohnston(both.radiative.clone()))
        }
        RadiativeModel::TauberSutton => {
            let relation = world.tauber_sutton.clone().map(Radiative::TauberSutton);
            if relation.is_none() {
                let message = format!(
                    "got \"{}\", which has no relation for {name}; choose \"{}\"",
                    model.name(),
                    RadiativeModel::None.name()
                );
                reader.fault(&input::heating::RADIATIVE, message);
            }
            relation
        }
    };
    let radiative = match radiating {
        Some(table) => Some(Radiative::Given(table)),
        None => of_relation(reader),
    };
    let emissivity = reader.number(&input::heating::WALL_EMISSIVITY);
    let wall = reader.choice(&input::heating::WALL);
    let model_factor = match given_fluxes {
        true => no_factor(reader),
        false => reader.number(&input::heating::CONVECTIVE_MODEL_FACTOR),
    };
    let convective_margin = reader.number(&input::heating::CONVECTIVE_MARGIN);
    let radiative_margin = reader.number(&input::heating::RADIATIVE_MARGIN);
    let pressure = reader.choice(&input::heating::STAGNATION_PRESSURE);
    let emissivity = emissivity?;
    let options = ConvectiveOptions {
        model_factor: model_factor?,
        margin: convective_margin?,
        wall: match wall? {
            WallModel::RadiativeEquilibrium => Wall::RadiativeEquilibrium { emissivity },
            WallModel::Cold => Wall::Cold,
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
    let input = &input::heating::CONVECTIVE_MODEL_FACTOR;
    let factor = reader.number(input)?;
    if factor != 1.0 {
        let message = "The model factor is not used: it corrects a relation, and the case gives convective heat fluxes itself.";
        reader.remark(input, message);
    }
    Some(1.0)
}

/// The gas at the wall: that of the planet, or of the air that the case brings.
fn wall_gas(reader: &mut Reader, planets: &WallGas, gas_constant_j_kg_k: Option<f64>) -> WallGas {
    let own = [
        &input::atmosphere::TABLE,
        &input::atmosphere::EXPONENTIAL_DENSITY_KG_M3,
    ];
    let brought = reader.any_given(&own);
    let ratio = &input::atmosphere::HEAT_CAPACITY_RATIO;
    let ratio = reader.given(ratio).then(|| reader.number(ratio)).flatten();
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

/// Heating that the case gives: the table of the stagnation point, and those along the body.
fn given(reader: &mut Reader) -> (Option<Arc<GivenHeating>>, Option<Arc<BodyHeating>>) {
    let rule = beyond(reader, &input::heating::EXTRAPOLATION);
    let way = match reader.ways(&input::heating::TABLES).as_slice() {
        [] => return (None, None),
        [way] => *way,
        [first, second, ..] => {
            together(reader, *second, first);
            return (None, None);
        }
    };
    let Some(rows) = reader.rows(way) else {
        return (None, None);
    };
    let along = if *way == input::heating::RADIUS_TABLE {
        Along::Radius
    } else if *way == input::heating::ARC_TABLE {
        Along::Arc
    } else {
        let table = GivenHeating::try_new(way.key, &rows, rule);
        return (noted(reader, way, table).map(Arc::new), None);
    };
    let body = noted(
        reader,
        way,
        BodyHeating::try_new(way.key, along, &rows, rule),
    );
    let stagnation = body.as_ref().and_then(BodyHeating::stagnation).cloned();
    (stagnation.map(Arc::new), body.map(Arc::new))
}

/// Relation made from rows; `None`, with all faults recorded, if it failed.
fn noted<T>(reader: &mut Reader, input: &'static Input, made: Result<T, Vec<String>>) -> Option<T> {
    let note = |fault: String| reader.fault(input, fault);
    made.map_err(|faults| faults.into_iter().for_each(note))
        .ok()
}

fn brandis_johnston<'l>(
    reader: &mut Reader,
    input: &'static Input,
    world: &'l World,
) -> Option<&'l BrandisJohnston> {
    let both = world.brandis_johnston.as_ref();
    if both.is_none() {
        let name = &world.planet.name;
        let message = "got \"brandis-johnston\", which is for the Earth, not for ";
        reader.fault(input, format!("{message}{name}"));
    }
    both
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
