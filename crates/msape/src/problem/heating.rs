//! Checks the choice of heating models.

use crate::case::Reader;
use crate::heating::StagnationHeating;
use crate::heating::brandis_johnston::BrandisJohnston;
use crate::heating::convective::Convective;
use crate::heating::pressure::{PressureModel, StagnationPressure};
use crate::heating::radiative::Radiative;
use crate::heating::stagnation::ConvectiveOptions;
use crate::heating::wall::Wall;
use crate::library::{Library, World};
use crate::quantity::input::{self, Choices, Kind};

/// Heating at the stagnation point on a planet, and the emissivity of the wall.
pub(super) fn heating(
    reader: &mut Reader,
    library: &Library,
    world: &World,
) -> Option<(StagnationHeating, f64)> {
    let name = &world.planet.name;
    let convective = match choice(reader, "heating.convective")? {
        "brandis-johnston" => brandis_johnston(reader, "heating.convective", world)
            .map(|both| Convective::BrandisJohnston(both.convective.clone())),
        "sutton-graves" => Some(Convective::SuttonGraves(world.sutton_graves.clone())),
        other => unknown(reader, "heating.convective", other),
    };
    let radiative = match choice(reader, "heating.radiative")? {
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
    let model_factor = reader.number("heating.convective_model_factor");
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
        gas: world.wall_gas.clone(),
        pressure: StagnationPressure {
            model: pressure?,
            fit: library.heating.pressure_fit.clone(),
        },
    };
    Some((heating, emissivity))
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

/// One of the fixed choices of an input.
pub(super) fn choice(reader: &mut Reader, key: &str) -> Option<&'static str> {
    let Some(Kind::Choice(Choices::Fixed(fixed))) = input::find(key).map(|input| input.kind) else {
        return None;
    };
    let names: Vec<&'static str> = fixed.iter().map(|(name, _)| *name).collect();
    reader.choice(key, &names)
}
