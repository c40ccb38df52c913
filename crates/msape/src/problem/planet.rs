//! Checks planet, atmosphere and wind: by name, or given in the case itself.

use super::forms::together;
use crate::case::Reader;
use crate::library::{Library, World, named, names};
use crate::planet::atmosphere::Atmosphere;
use crate::planet::atmosphere::exponential::Exponential;
use crate::planet::atmosphere::table::Table;
use crate::planet::gas::{GAS_CONSTANT_J_KMOL_K, Gas, HeatCapacityRatio};
use crate::planet::wind::{Wind, WindTable};
use crate::planet::{Gravity, Planet};
use crate::quantity::input::{self, Input, OWN_ATMOSPHERE};
use std::fmt::Display;
use std::sync::Arc;

/// Molar mass of a table over that of the planet's gas within which it is not remarked on, either way: assumed. Three digits of
/// density, temperature and pressure, as tables print them, are within 0.5 % each, and moist air differs from dry by up to 2.5 % (4 % of
/// water by volume, 18.0 for 29.0 kg/kmol) on the Earth; air over carbon dioxide is 0.66.
pub(super) const SAME_GAS: f64 = 1.05;

/// Planet of the case, and the planet of the library whose heating relations are used.
pub(super) fn planet<'l>(reader: &mut Reader, library: &'l Library) -> Option<(Planet, &'l World)> {
    let name = reader.name(&input::entry::PLANET, &names(&library.planets));
    if !is_own(reader) {
        let world = named(&library.planets, name?)?;
        return Some((world.planet.clone(), world));
    }
    if reader.given(&input::entry::PLANET) {
        let message = "The case brings its own [planet]; of the one named only the atmosphere, the gas, the limits and the heating relations are used.";
        reader.remark(&input::entry::PLANET, message);
    }
    let equatorial_radius_m = reader.required_number(&input::planet::EQUATORIAL_RADIUS_M);
    let polar_radius_m = reader
        .number(&input::planet::POLAR_RADIUS_M)
        .or(equatorial_radius_m);
    let rotation_rate_rad_s = reader
        .number(&input::planet::ROTATION_RATE_RAD_S)
        .unwrap_or(0.0);
    let gravity = gravity(reader, equatorial_radius_m);
    let world = base(reader, library, name)?;
    let base = &world.planet;
    let planet = Planet {
        name: "case".to_string(),
        title: "Planet of the case".to_string(),
        source: String::new(),
        place: String::new(),
        gravity_source: String::new(),
        note: String::new(),
        equatorial_radius_m: equatorial_radius_m?,
        polar_radius_m: polar_radius_m?,
        rotation_rate_rad_s,
        gravity: gravity?,
        downrange_sphere_radius_m: None,
        kml_target: base
            .kml_target
            .clone()
            .filter(|_| reader.given(&input::entry::PLANET)),
        ..base.clone()
    };
    let faults = planet.check();
    for fault in &faults {
        reader.fault(&"planet", fault.to_string());
    }
    faults.is_empty().then_some((planet, world))
}

/// The planet, whose flights may end as deep as a table of the case reaches.
pub(super) fn reaching(planet: Planet, atmosphere: Option<&Atmosphere>) -> Planet {
    let deepest_m = match atmosphere {
        Some(Atmosphere::Table(table)) => table.valid_m().0,
        _ => f64::INFINITY,
    };
    Planet {
        lowest_altitude_m: planet.lowest_altitude_m.min(deepest_m),
        ..planet
    }
}

/// A fault of an altitude below the lowest of the planet.
pub(super) fn deep_enough(
    reader: &mut Reader,
    input: &'static Input,
    altitude_m: f64,
    planet: &Planet,
) {
    let (lowest_m, title) = (planet.lowest_altitude_m, &planet.title);
    if altitude_m < lowest_m {
        let message = format!(
            "got an altitude of {altitude_m} m, must be at least {lowest_m} m, the lowest of {title}"
        );
        reader.fault(input, message);
    }
}

/// Whether the case defines its own planet.
fn is_own(reader: &Reader) -> bool {
    reader.any_given(input::planet::INPUTS)
}

/// Planet of the library that provides the air for one of the case: the one named, else the one whose atmosphere is named, else the
/// default.
fn base<'l>(reader: &Reader, library: &'l Library, name: Option<&str>) -> Option<&'l World> {
    let named = named(&library.planets, name?)?;
    if reader.given(&input::entry::PLANET) {
        return Some(named);
    }
    let atmosphere = reader.text(&input::entry::ATMOSPHERE);
    let owns = |planet: &Planet| {
        atmosphere
            .as_ref()
            .is_none_or(|wanted| planet.atmosphere == *wanted)
    };
    if owns(&named.planet) {
        return Some(named);
    }
    let mut worlds = library.planets.iter().map(|(_, world)| world);
    worlds.find(|world| owns(&world.planet)).or(Some(named))
}

fn gravity(reader: &mut Reader, equatorial_radius_m: Option<f64>) -> Option<Gravity> {
    let mu_m3_s2 = reader.number(&input::planet::MU_M3_S2);
    let uniform_m_s2 = reader.number(&input::planet::UNIFORM_GRAVITY_M_S2);
    let zonal = [&input::planet::J2, &input::planet::J3, &input::planet::J4]
        .map(|key| reader.number(key).unwrap_or(0.0));
    let reference_radius_m = reader
        .number(&input::planet::J_REFERENCE_RADIUS_M)
        .or(equatorial_radius_m);
    match (mu_m3_s2, uniform_m_s2) {
        (Some(_), Some(_)) => {
            together(
                reader,
                &input::planet::UNIFORM_GRAVITY_M_S2,
                &input::planet::MU_M3_S2,
            );
            None
        }
        (None, Some(acceleration_m_s2)) => Some(Gravity::Uniform { acceleration_m_s2 }),
        (Some(mu_m3_s2), None) => reference_radius_m.map(|reference_radius_m| Gravity::Zonal {
            mu_m3_s2,
            j2: zonal[0],
            j3: zonal[1],
            j4: zonal[2],
            reference_radius_m,
        }),
        (None, None) => {
            if reader.ways(&input::planet::GRAVITY).is_empty() {
                let uniform = &input::planet::UNIFORM_GRAVITY_M_S2;
                let message = format!("missing; give it, in m^3/s^2, or {uniform}, in m/s^2");
                reader.fault(&input::planet::MU_M3_S2, message);
            }
            None
        }
    }
}

/// The atmosphere: the planet's own, or one that the case brings.
pub(super) fn atmosphere(
    reader: &mut Reader,
    library: &Library,
    planet: &Option<(Planet, &World)>,
) -> Option<Atmosphere> {
    let known = names(&library.atmospheres);
    let known: Vec<&str> = [OWN_ATMOSPHERE].into_iter().chain(known).collect();
    let name = reader.name(&input::entry::ATMOSPHERE, &known);
    let ways = reader.ways(&input::atmosphere::AIR);
    let Some(&way) = ways.first() else {
        for key in GAS {
            if reader.given(key) {
                reader.fault(
                    key,
                    "is for an atmosphere of the case; the named one has its gas",
                );
            }
        }
        return own_atmosphere(reader, library, planet.as_ref()?, name?);
    };
    if reader.given(&input::entry::ATMOSPHERE) {
        let message =
            "The case brings its own [atmosphere], which is used in place of the one named.";
        reader.remark(&input::entry::ATMOSPHERE, message);
    }
    if ways.len() > 1 {
        reader.fault(
            &"atmosphere",
            "given in more than one way; give one of table, file and exponential",
        );
        return None;
    }
    if *way == input::atmosphere::FILE {
        // a fault that the reader has noted
        return None;
    }
    // The rows of a case whose planet is at fault are checked all the same.
    let (lender, world) = match planet {
        Some((planet, world)) => (planet, *world),
        None => library
            .planets
            .first()
            .map(|(_, world)| (&world.planet, world))?,
    };
    let title = &world.atmosphere_title;
    let mut air = world.atmosphere.planet_air();
    given_gas(reader, &mut air.gas)?;
    let table = &input::atmosphere::TABLE;
    let model = if way == table {
        let rows = reader.rows(table)?;
        let model = Table::try_new(&rows, air.clone());
        all_faults(reader, table, model).map(|model| Atmosphere::Table(Arc::new(model)))
    } else {
        let density = reader.required_number(&input::atmosphere::EXPONENTIAL_DENSITY_KG_M3);
        let height = reader.required_number(&input::atmosphere::EXPONENTIAL_SCALE_HEIGHT_M);
        let model = Exponential::try_new(density?, height?, air.clone());
        all_faults(reader, &"atmosphere.exponential", model)
            .map(|model| Atmosphere::Exponential(Arc::new(model)))
    }?;
    let input = match way == table {
        true => table,
        false => &input::atmosphere::EXPONENTIAL_DENSITY_KG_M3,
    };
    for message in assumed(reader, &model, &air.gas, lender, title) {
        reader.remark(input, message);
    }
    Some(model)
}

/// Inputs of the gas of an atmosphere that the case brings.
const GAS: [&Input; 2] = [
    &input::atmosphere::MOLAR_MASS_KG_KMOL,
    &input::atmosphere::HEAT_CAPACITY_RATIO,
];

/// The planet's own atmosphere by its name, or as that of the planet.
fn own_atmosphere(
    reader: &mut Reader,
    library: &Library,
    (planet, world): &(Planet, &World),
    name: &str,
) -> Option<Atmosphere> {
    let own = planet.atmosphere.as_str();
    if name != OWN_ATMOSPHERE && name != own {
        let owners = library
            .planets
            .iter()
            .filter(|(_, other)| other.planet.atmosphere == name);
        let owners: Vec<&str> = owners.map(|(name, _)| name.as_str()).collect();
        let message = format!(
            "got \"{name}\", the air of {}, not of {}; must be \"{OWN_ATMOSPHERE}\" or \"{own}\", or a table of the case",
            owners.join(" and "),
            planet.title
        );
        reader.fault(&input::entry::ATMOSPHERE, message);
        return None;
    }
    Some(world.atmosphere.clone())
}

/// The gas, with the properties that the case gives; `None` at a fault.
fn given_gas(reader: &mut Reader, gas: &mut Gas) -> Option<()> {
    let [molar_mass, ratio] = GAS.map(|key| (reader.given(key), reader.number(key)));
    if let (true, mass) = molar_mass {
        gas.gas_constant_j_kg_k = GAS_CONSTANT_J_KMOL_K / mass?;
    }
    if let (true, ratio) = ratio {
        gas.heat_capacity_ratio = HeatCapacityRatio::Constant(ratio?);
    }
    Some(())
}

/// Messages on properties that an atmosphere given in the case does not contain, and on a gas that is not the planet's.
fn assumed(
    reader: &Reader,
    model: &Atmosphere,
    gas: &Gas,
    planet: &Planet,
    title: &str,
) -> Vec<String> {
    let mut messages = Vec::new();
    let unnamed = is_own(reader) && !reader.given(&input::entry::PLANET);
    let gas_given = GAS.into_iter().all(|input| reader.given(input));
    let has_temperature = match model {
        Atmosphere::Table(table) => table.has_temperature(),
        _ => false,
    };
    let taken = match (has_temperature, gas_given) {
        (false, true) => "Temperature is",
        (false, false) => "Temperature and gas are",
        (true, _) => "The gas is",
    };
    if !has_temperature || (unnamed && !gas_given) {
        let mass = gas.molar_mass_kg_kmol();
        let why = match unnamed {
            true => format!(
                "; with {} it takes those of another planet",
                input::entry::PLANET
            ),
            false => String::new(),
        };
        messages.push(format!(
            "{taken} assumed: of {title}, {mass:.2} kg/kmol; the case brings none{why}."
        ));
    }
    let masses = match model {
        Atmosphere::Table(table) => table.molar_masses_kg_kmol(),
        _ => None,
    };
    if let Some([least, most]) = masses {
        let mass = gas.molar_mass_kg_kmol();
        if least * SAME_GAS < mass || most > mass * SAME_GAS {
            messages.push(format!(
                "Density, temperature and pressure make a gas of {least:.2} to {most:.2} kg/kmol, that of {} has {mass:.2}: the table's is used for the speed of sound, the ratio of heat capacities and the mean free path are the planet's.",
                planet.title
            ));
        }
    }
    messages
}

/// A model, or `None` with all its faults noted.
fn all_faults<T, F: Display>(
    reader: &mut Reader,
    key: &dyn Display,
    model: Result<T, Vec<F>>,
) -> Option<T> {
    match model {
        Ok(model) => Some(model),
        Err(faults) => {
            for fault in faults {
                reader.fault(key, fault.to_string());
            }
            None
        }
    }
}

/// The wind.
pub(super) fn wind(reader: &mut Reader) -> Option<Wind> {
    let eastward_m_s = reader.number(&input::wind::EASTWARD_M_S);
    let northward_m_s = reader.number(&input::wind::NORTHWARD_M_S);
    let table = &input::wind::TABLE;
    match reader.ways(&input::wind::WIND).as_slice() {
        [] => Some(Wind::Calm),
        [way] if *way == table => {
            let rows = reader.rows(table)?;
            all_faults(reader, table, WindTable::try_new(&rows)).map(Wind::Table)
        }
        [_] => Some(Wind::Constant {
            eastward_m_s: eastward_m_s.unwrap_or(0.0),
            northward_m_s: northward_m_s.unwrap_or(0.0),
        }),
        _ => {
            reader.fault(
                table,
                "given together with a constant wind; give one of them",
            );
            None
        }
    }
}
