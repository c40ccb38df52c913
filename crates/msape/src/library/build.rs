//! Builds a library: references between data files are resolved here, once, so that a checked case cannot contain an unknown
//! name.

use super::read::{Files, RELATIONS, Relation};
use super::{DataError, HeatingModels, Library, Named, Stack, World, named};
use crate::aero::AxialForce;
use crate::aero::damping::DampingData;
use crate::aero::euler::EulerCorrection;
use crate::heating::afterbody::Afterbody;
use crate::heating::brandis_johnston::BrandisJohnston;
use crate::heating::pressure::PressureFit;
use crate::heating::shoulder::Shoulder;
use crate::heating::sutton_graves::SuttonGraves;
use crate::heating::tauber_sutton::TauberSutton;
use crate::heating::wall::WallGas;
use crate::planet::Planet;
use crate::planet::atmosphere::Atmosphere;
use crate::soak::SoakCorrelation;
use crate::tps::Side;
use crate::tps::concept::Concept;
use crate::tps::fit_space::FitSpace;
use crate::tps::material::TpsMaterial;
use crate::vehicle::body::OutlineData;
use crate::vehicle::impact::Ground;
use crate::vehicle::impact::foam::FoamKind;
use crate::vehicle::rules::VehicleData;

/// The library of these files, or every fault of them.
pub(super) fn library(mut files: Files) -> Result<Library, Vec<DataError>> {
    let atmospheres = files.folder("atmospheres", Atmosphere::parse);
    let materials = files.folder("materials", TpsMaterial::parse);
    let planets = planets(&mut files, &atmospheres);
    let vehicle = files.one("vehicles/mmeev.toml", VehicleData::parse);
    let concepts = concepts(&mut files, &materials, vehicle.as_ref());
    let heating = heating(&mut files);
    let grounds = files.folder("grounds", Ground::parse);
    let aerodynamics = files.folder("aerodynamics", AxialForce::parse);
    let outlines = files.folder("outlines", OutlineData::parse);
    let fit_space = files.one("tps/mer-fit-space.toml", FitSpace::parse);
    let impact_foam = files.one("foams/pmi.toml", FoamKind::parse);
    let damping = files.one("aero-models/damping.toml", DampingData::parse);
    let euler = files.one("aero-models/euler-correction.toml", EulerCorrection::parse);
    let ablators = files.own_texts("ablators");
    let whole = || {
        Some(Library {
            ablators,
            planets,
            atmospheres,
            heating: heating?,
            materials,
            concepts,
            fit_space: fit_space?,
            vehicle: vehicle?,
            grounds,
            impact_foam: impact_foam?,
            aerodynamics,
            damping: damping?,
            euler: euler?,
            outlines,
        })
    };
    match files.faults.is_empty() {
        true => whole().ok_or_else(Vec::new),
        false => Err(files.faults),
    }
}

fn heating(files: &mut Files) -> Option<HeatingModels> {
    let afterbody = files.one("heating/afterbody.toml", Afterbody::parse);
    let shoulder = files.one("heating/shoulder.toml", Shoulder::parse);
    let pressure_fit = files.one("heating/stagnation-pressure.toml", PressureFit::parse);
    Some(HeatingModels {
        afterbody: afterbody?,
        shoulder: shoulder?,
        pressure_fit: pressure_fit?,
    })
}

fn planets(files: &mut Files, atmospheres: &Named<(String, Atmosphere)>) -> Named<World> {
    let planets = files.folder("planets", Planet::parse);
    let [graves, wall, tauber] = RELATIONS;
    let sutton_graves = files.relations(graves, SuttonGraves::all);
    let wall_gas = files.relations(wall, WallGas::all);
    let tauber_sutton = files.relations(tauber, |data| {
        TauberSutton::parse(data).map(|relation| vec![(relation.planets.clone(), relation)])
    });
    let brandis_johnston = files.one("heating/brandis-johnston.toml", BrandisJohnston::parse);
    planets_exist(files, &planets, &sutton_graves);
    planets_exist(files, &planets, &wall_gas);
    planets_exist(files, &planets, &tauber_sutton);
    let mut worlds = Vec::new();
    for (name, planet) in &planets {
        let file = format!("planets/{name}.toml");
        if planet.name != *name {
            let message = format!("name: got \"{}\", must be that of the file", planet.name);
            files.fault(&file, message);
        }
        let gas = planet.heating_as.as_ref().unwrap_or(name);
        let atmosphere = find(files, &file, "atmosphere", atmospheres, &planet.atmosphere);
        if planet.heating_as.is_some() {
            let lender = find(files, &file, "heating_as", &planets, gas);
            if let Some(other) = lender.and_then(|planet| planet.heating_as.as_ref()) {
                let message = format!(
                    "heating_as: got \"{gas}\", which has no relations of its own but heating_as = \"{other}\"; must be a planet with its own"
                );
                files.fault(&file, message);
                continue;
            }
        }
        let constant = of_planet(files, &file, graves, &sutton_graves, gas);
        let at_wall = of_planet(files, &file, wall, &wall_gas, gas);
        let (Some((title, atmosphere)), Some(constant), Some(at_wall)) =
            (atmosphere, constant, at_wall)
        else {
            continue;
        };
        let both = brandis_johnston.as_ref();
        let world = World {
            planet: planet.clone(),
            atmosphere_title: title.clone(),
            atmosphere: atmosphere.clone(),
            sutton_graves: constant.clone(),
            tauber_sutton: tauber_sutton
                .iter()
                .find(|relation| relation.planets.contains(gas))
                .map(|relation| relation.thing.clone()),
            brandis_johnston: both.filter(|both| both.planets.contains(gas)).cloned(),
            wall_gas: at_wall.clone(),
        };
        worlds.push((name.clone(), world));
    }
    for (name, _) in atmospheres {
        if !planets.iter().any(|(_, planet)| planet.atmosphere == *name) {
            let message = "name: no planet has it as its atmosphere, and it is flown on no other";
            files.fault(&format!("atmospheres/{name}.toml"), message.to_string());
        }
    }
    worlds
}

/// Faults of relations for planets that do not exist.
fn planets_exist<T>(files: &mut Files, planets: &Named<Planet>, relations: &[Relation<T>]) {
    for Relation {
        file, planets: of, ..
    } in relations
    {
        for name in of {
            find(files, file, "planets", planets, name);
        }
    }
}

/// The relation for a planet, or a fault of the planet's file.
fn of_planet<'r, T>(
    files: &mut Files,
    file: &str,
    start: &str,
    relations: &'r [Relation<T>],
    planet: &str,
) -> Option<&'r T> {
    let found = relations
        .iter()
        .find(|r| r.planets.iter().any(|name| name == planet));
    if found.is_none() {
        let known: Vec<&str> = relations
            .iter()
            .flat_map(|relation| relation.planets.iter().map(String::as_str))
            .collect();
        let message = format!(
            "heating_as: missing, and no {start}*.toml names \"{planet}\"; must be one of {}, or give a relation for it in {start}-NAME.toml",
            known.join(", ")
        );
        files.fault(file, message);
    }
    found.map(|relation| &relation.thing)
}

fn concepts(
    files: &mut Files,
    materials: &Named<TpsMaterial>,
    vehicle: Option<&VehicleData>,
) -> Named<Stack> {
    let soak = files.folder("soak", SoakCorrelation::parse);
    let carriers: Named<_> = vehicle.map_or(Vec::new(), |vehicle| {
        let carriers = vehicle.carrier.iter();
        carriers
            .map(|(name, c)| (name.clone(), c.clone()))
            .collect()
    });
    let mut stacks = Vec::new();
    for (name, concept) in files.folder("concepts", Concept::parse) {
        let file = format!("concepts/{name}.toml");
        let fore =
            |(_, material): &&(String, TpsMaterial)| material.sides.contains(&Side::Forebody);
        let fore: Named<_> = materials.iter().filter(fore).cloned().collect();
        let tps = find(files, &file, "tps", &fore, &concept.tps).cloned();
        let soak = find(files, &file, "soak", &soak, &concept.soak).cloned();
        let carrier = find(files, &file, "carrier", &carriers, &concept.carrier).cloned();
        if let (Some(tps), Some(soak), Some(carrier)) = (tps, soak, carrier) {
            let stack = Stack {
                concept,
                tps,
                soak,
                carrier,
            };
            stacks.push((name, stack));
        }
    }
    stacks
}

/// Item of a list that a file names; otherwise a fault that lists the names there are.
fn find<'l, T>(
    files: &mut Files,
    file: &str,
    key: &str,
    list: &'l Named<T>,
    name: &str,
) -> Option<&'l T> {
    let found = named(list, name);
    if found.is_none() {
        let known: Vec<&str> = list.iter().map(|(known, _)| known.as_str()).collect();
        let known = known.join(", ");
        files.fault(
            file,
            format!("{key}: got \"{name}\", must be one of {known}"),
        );
    }
    found
}

#[cfg(test)]
mod tests;
