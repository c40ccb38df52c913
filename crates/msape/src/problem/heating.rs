//! Checks the choice of heating models.

use crate::case::Reader;
use crate::heating::StagnationHeating;
use crate::heating::convective::Convective;
use crate::heating::pressure::{PressureModel, StagnationPressure};
use crate::heating::radiative::Radiative;
use crate::heating::stagnation::ConvectiveOptions;
use crate::heating::wall::Wall;
use crate::library::{Library, named};
use crate::quantity::input::{self, Choices, Kind};

/// Heating at the stagnation point on a planet, and the emissivity of the wall.
pub(super) fn heating(
    reader: &mut Reader,
    library: &Library,
    planet: &str,
) -> Option<(StagnationHeating, f64)> {
    let models = &library.heating;
    let convective = match choice(reader, "heating.convective")? {
        "brandis-johnston" => earth_only(reader, "heating.convective", planet)
            .then(|| Convective::BrandisJohnston(models.brandis_johnston.convective.clone())),
        _ => named(&models.sutton_graves, planet)
            .cloned()
            .map(Convective::SuttonGraves),
    };
    let radiative = match choice(reader, "heating.radiative")? {
        "none" => Some(Radiative::None),
        "brandis-johnston" => earth_only(reader, "heating.radiative", planet)
            .then(|| Radiative::BrandisJohnston(models.brandis_johnston.radiative.clone())),
        _ => {
            let relation = named(&models.tauber_sutton, planet)
                .cloned()
                .map(Radiative::TauberSutton);
            if relation.is_none() {
                let message = format!(
                    "got \"tauber-sutton\", which has no relation for {planet}; choose \"none\""
                );
                reader.fault("heating.radiative", message);
            }
            relation
        }
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
        gas: named(&models.wall_gas, planet)?.clone(),
        pressure: StagnationPressure {
            model: pressure?,
            fit: models.pressure_fit.clone(),
        },
    };
    Some((heating, emissivity))
}

fn earth_only(reader: &mut Reader, key: &str, planet: &str) -> bool {
    let on_earth = planet.starts_with("earth");
    if !on_earth {
        reader.fault(
            key,
            format!("got \"brandis-johnston\", which is for the Earth, not for {planet}"),
        );
    }
    on_earth
}

/// One of the fixed choices of an input.
pub(super) fn choice(reader: &mut Reader, key: &str) -> Option<&'static str> {
    let Some(Kind::Choice(Choices::Fixed(fixed))) = input::find(key).map(|input| input.kind) else {
        return None;
    };
    let names: Vec<&'static str> = fixed.iter().map(|(name, _)| *name).collect();
    reader.choice(key, &names)
}
