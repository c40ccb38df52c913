//! Checks planet, atmosphere and wind: by name, or given in the case itself.

use crate::case::Reader;
use crate::finding::{Finding, Severity};
use crate::library::{Library, named};
use crate::planet::atmosphere::Atmosphere;
use crate::planet::atmosphere::exponential::Exponential;
use crate::planet::atmosphere::table::Table;
use crate::planet::wind::{Wind, WindTable};
use crate::planet::{Gravity, Planet};
use crate::quantity::input::inputs;
use std::sync::Arc;

/// Entry interface of a planet given in the case, m; that of the report.
const ENTRY_INTERFACE_M: f64 = 125_000.0;

/// The planet, and the name under which its heating relations are found.
pub(super) fn planet(reader: &mut Reader, library: &Library) -> Option<(Planet, String)> {
    let names: Vec<&str> = library
        .planets
        .iter()
        .map(|(name, _)| name.as_str())
        .collect();
    let name = reader.choice("entry.planet", &names);
    if !section_given(reader, "planet.") {
        let name = name?;
        return Some((named(&library.planets, name)?.clone(), name.to_string()));
    }
    if reader.given("entry.planet") {
        overridden(reader, "entry.planet", "planet");
    }
    let equatorial_radius_m = reader.required_number("planet.equatorial_radius_m");
    let polar_radius_m = reader
        .number("planet.polar_radius_m")
        .or(equatorial_radius_m);
    let rotation_rate_rad_s = reader.number("planet.rotation_rate_rad_s").unwrap_or(0.0);
    let mu_m3_s2 = reader.number("planet.mu_m3_s2");
    let uniform_m_s2 = reader.number("planet.uniform_gravity_m_s2");
    let zonal =
        ["planet.j2", "planet.j3", "planet.j4"].map(|key| reader.number(key).unwrap_or(0.0));
    let reference_radius_m = reader
        .number("planet.j_reference_radius_m")
        .or(equatorial_radius_m);
    let gravity = match (mu_m3_s2, uniform_m_s2) {
        (Some(_), Some(_)) => {
            reader.fault(
                "planet.uniform_gravity_m_s2",
                "given together with planet.mu_m3_s2; give one of them",
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
            if !reader.given("planet.mu_m3_s2") && !reader.given("planet.uniform_gravity_m_s2") {
                reader.fault(
                    "planet.mu_m3_s2",
                    "missing; give it, in m^3/s^2, or planet.uniform_gravity_m_s2, in m/s^2",
                );
            }
            None
        }
    };
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
        entry_interface_m: ENTRY_INTERFACE_M,
        gravity: gravity?,
    };
    let faults = planet.check();
    for fault in &faults {
        reader.fault("planet", fault.to_string());
    }
    faults
        .is_empty()
        .then(|| (planet, "earth-msape".to_string()))
}

/// The atmosphere.
pub(super) fn atmosphere(reader: &mut Reader, library: &Library) -> Option<Atmosphere> {
    let names: Vec<&str> = library
        .atmospheres
        .iter()
        .map(|(name, _)| name.as_str())
        .collect();
    let name = reader.choice("entry.atmosphere", &names);
    let [table, file] = ["atmosphere.table", "atmosphere.file"].map(|key| reader.given(key));
    let exponential = section_given(reader, "atmosphere.exponential.");
    if !(table || file || exponential) {
        return named(&library.atmospheres, name?).map(|(_, atmosphere)| atmosphere.clone());
    }
    if reader.given("entry.atmosphere") {
        overridden(reader, "entry.atmosphere", "atmosphere");
    }
    if usize::from(table) + usize::from(file) + usize::from(exponential) > 1 {
        reader.fault(
            "atmosphere",
            "given in more than one way; give one of table, file and exponential",
        );
        return None;
    }
    let standard = library.us_1976.standard_air();
    if file {
        reader.fault(
            "atmosphere.file",
            "was not read; give its rows as atmosphere.table",
        );
        return None;
    }
    if exponential {
        let density = reader.required_number("atmosphere.exponential.density_kg_m3");
        let height = reader.required_number("atmosphere.exponential.scale_height_m");
        return match Exponential::try_new(density?, height?, standard) {
            Ok(model) => Some(Atmosphere::Exponential(Arc::new(model))),
            Err(faults) => {
                faults
                    .iter()
                    .for_each(|fault| reader.fault("atmosphere.exponential", fault.to_string()));
                None
            }
        };
    }
    let rows = reader.rows("atmosphere.table")?;
    match Table::try_new(&rows, standard) {
        Ok(model) => Some(Atmosphere::Table(Arc::new(model))),
        Err(faults) => {
            faults
                .iter()
                .for_each(|fault| reader.fault("atmosphere.table", fault.to_string()));
            None
        }
    }
}

/// The wind.
pub(super) fn wind(reader: &mut Reader) -> Option<Wind> {
    let eastward_m_s = reader.number("wind.eastward_m_s");
    let northward_m_s = reader.number("wind.northward_m_s");
    let constant = reader.given("wind.eastward_m_s") || reader.given("wind.northward_m_s");
    if !reader.given("wind.table") {
        return Some(match constant {
            false => Wind::Calm,
            true => Wind::Constant {
                eastward_m_s: eastward_m_s.unwrap_or(0.0),
                northward_m_s: northward_m_s.unwrap_or(0.0),
            },
        });
    }
    if constant {
        reader.fault(
            "wind.table",
            "given together with a constant wind; give one of them",
        );
        return None;
    }
    let rows = reader.rows("wind.table")?;
    match WindTable::try_new(&rows) {
        Ok(table) => Some(Wind::Table(table)),
        Err(faults) => {
            faults
                .iter()
                .for_each(|fault| reader.fault("wind.table", fault.to_string()));
            None
        }
    }
}

fn section_given(reader: &Reader, prefix: &str) -> bool {
    inputs().any(|input| input.key.starts_with(prefix) && reader.given(input.key))
}

/// What the case itself brings stands before what it names.
fn overridden(reader: &mut Reader, key: &str, section: &str) {
    reader.findings.push(Finding {
        severity: Severity::Note,
        model: "input".to_string(),
        key: key.to_string(),
        value: None,
        valid: (None, None),
        message: format!(
            "The case brings its own [{section}], which is used in place of the one named."
        ),
        source: "convention of this program".to_string(),
        field: Some(key.to_string()),
    });
}
