//! Cards of materials: TOML, with tables of gas and wall as CSV beside it.
//!
//! ```text
//! h(T) = h(298.15 K) + ∫ c_p dT
//! ```
//!
//! with h in J/kg against the elements at 298.15 K. A card without `[char]` and `[pyrolysis]` is of a solid that does not react;
//! one without `[wall]` keeps its surface.
//!
//! # Valid
//! Between the ends of the tables; a run beyond them has a finding.
//!
//! # References
//! - \[pato\] for the form; each card names its own.

use super::table;
use crate::library::data_file;
use ::ablation::fault::Fault;
use ::ablation::gas::{Gas, GasRow};
use ::ablation::reaction::Reaction;
use ::ablation::solid::{Solid, State};
use ::ablation::stack::{Material, Pyrolysis};
use ::ablation::surface::{Surface, WallRow, WallTable};
use serde::Deserialize;

/// Folder of the cards below `data`.
const FOLDER: &str = "ablators";

/// A card as its file has it.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    name: String,
    #[serde(rename = "source")]
    _source: String,
    #[serde(rename = "place")]
    _place: String,
    note: String,
    r#virgin: OfState,
    char: Option<OfState>,
    pyrolysis: Option<OfPyrolysis>,
    wall: Option<OfWall>,
}

#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct OfState {
    density_kg_m3: f64,
    formation_j_kg: Option<f64>,
    emissivity: f64,
    absorptivity: Option<f64>,
    specific_heat: SpecificHeat,
    conductivity: Conductivity,
}

#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct SpecificHeat {
    temperature_k: Vec<f64>,
    specific_heat_j_kg_k: Vec<f64>,
}

#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct Conductivity {
    temperature_k: Vec<f64>,
    conductivity_w_m_k: Vec<f64>,
}

#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct OfPyrolysis {
    gas: String,
    permeability_m2: Permeability,
    #[serde(rename = "provenance")]
    _provenance: String,
    reaction: Vec<OfReaction>,
}

#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct Permeability {
    r#virgin: f64,
    char: f64,
}

#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct OfReaction {
    #[serde(rename = "name")]
    _name: String,
    virgin_kg_m3: f64,
    char_kg_m3: f64,
    rate_per_s: f64,
    activation_k: f64,
    order_exponent: f64,
    start_k: f64,
}

#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct OfWall {
    table: String,
    #[serde(rename = "provenance")]
    _provenance: String,
}

/// Rows of two columns of one length.
fn pairs(key: &str, temperature_k: &[f64], values: &[f64]) -> Result<Vec<[f64; 2]>, String> {
    if temperature_k.len() != values.len() {
        let (a, b) = (temperature_k.len(), values.len());
        return Err(format!("{key}: {a} temperatures, but {b} values"));
    }
    Ok(temperature_k
        .iter()
        .zip(values)
        .map(|(t, y)| [*t, *y])
        .collect())
}

impl OfState {
    fn state(&self, of: &str) -> Result<State, String> {
        let heat = &self.specific_heat;
        let conduction = &self.conductivity;
        Ok(State {
            density_kg_m3: self.density_kg_m3,
            formation_j_kg: self.formation_j_kg.unwrap_or_default(),
            specific_heat: pairs(
                &format!("{of}.specific_heat"),
                &heat.temperature_k,
                &heat.specific_heat_j_kg_k,
            )?,
            conductivity: pairs(
                &format!("{of}.conductivity"),
                &conduction.temperature_k,
                &conduction.conductivity_w_m_k,
            )?,
            emissivity: self.emissivity,
            absorptivity: self.absorptivity.unwrap_or(self.emissivity),
        })
    }
}

/// A material and the notes of its card.
#[derive(Clone, Debug, PartialEq)]
pub struct Card {
    /// Material.
    pub material: Material,
    /// Doubts about its numbers, assumptions included.
    pub note: String,
}

/// Cards: the shipped ones, and those of the user.
#[derive(Clone, Copy, Debug)]
pub struct Cards<'a> {
    /// Paths below a folder laid out as `data`, and texts, of the user.
    pub own: &'a [(String, String)],
    /// Enthalpy of the air at a wall that does not react: rows of temperature, K, and J/kg against 298.15 K.
    pub air: &'a [[f64; 2]],
}

impl Cards<'_> {
    fn text(&self, path: &str) -> Option<&str> {
        let own = self.own.iter().find(|(known, _)| known == path);
        own.map(|(_, text)| text.as_str())
            .or_else(|| data_file(path))
    }

    /// Names of all cards, in order.
    pub fn names(&self) -> Vec<String> {
        let shipped = crate::library::data_folder(FOLDER).map(|(path, _)| path);
        let own = self.own.iter().map(|(path, _)| path.as_str());
        let name = |path: &str| {
            let name = path
                .strip_prefix(FOLDER)?
                .strip_prefix('/')?
                .strip_suffix(".toml")?;
            Some(name.to_string())
        };
        let mut names: Vec<String> = shipped.chain(own).filter_map(name).collect();
        names.sort();
        names.dedup();
        names
    }

    /// The card of a name; an error names file, key, value and range.
    ///
    /// # Errors
    /// A name that no card has, and every reason for which a card cannot be used.
    pub fn card(&self, name: &str) -> Result<Card, String> {
        let path = format!("{FOLDER}/{name}.toml");
        let Some(text) = self.text(&path) else {
            return Err(format!(
                "got \"{name}\", must be one of {}",
                self.names().join(", ")
            ));
        };
        let of = |message: String| format!("{path}: {message}");
        let file: File = toml::from_str(text).map_err(|error| of(error.to_string()))?;
        self.material(file).map_err(of)
    }

    fn material(&self, file: File) -> Result<Card, String> {
        let said = |fault: Fault| fault.to_string();
        let formation = |of: &str, state: &OfState| match (state.formation_j_kg, &file.pyrolysis) {
            (None, Some(_)) => Err(format!(
                "{of}.formation_j_kg: missing; the enthalpy at 298.15 K against the elements, J/kg"
            )),
            _ => Ok(()),
        };
        formation("virgin", &file.r#virgin)?;
        let virgin = file.r#virgin.state("virgin")?;
        let solid = match &file.char {
            Some(char) => {
                formation("char", char)?;
                Solid::try_new(virgin, char.state("char")?).map_err(said)?
            }
            None => Solid::inert(virgin).map_err(said)?,
        };
        let pyrolysis = match &file.pyrolysis {
            Some(_) if file.char.is_none() => {
                return Err("char: missing; what chars has a char".to_string());
            }
            None if file.char.is_some() => {
                return Err("pyrolysis: missing; a char comes of a pyrolysis".to_string());
            }
            Some(pyrolysis) => Some(self.pyrolysis(pyrolysis)?),
            None => None,
        };
        let surface = match &file.wall {
            Some(wall) => self.surface(&wall.table)?,
            None => Surface::Inert(self.air.to_vec()),
        };
        let material = Material::try_new(file.name, solid, pyrolysis, surface).map_err(said)?;
        Ok(Card {
            material,
            note: file.note,
        })
    }

    /// Rows of a table beside the card.
    fn rows<const N: usize>(&self, file: &str, names: [&str; N]) -> Result<Vec<[f64; N]>, String> {
        let path = format!("{FOLDER}/{file}");
        let text = self
            .text(&path)
            .ok_or_else(|| format!("{path}: is not there"))?;
        table::rows(text, names).map_err(|message| format!("{path}: {message}"))
    }

    fn pyrolysis(&self, file: &OfPyrolysis) -> Result<Pyrolysis, String> {
        let columns = [
            "pressure_pa",
            "temperature_k",
            "molar_mass_kg_mol",
            "enthalpy_j_kg",
            "viscosity_pa_s",
        ];
        let row = |[
            pressure_pa,
            temperature_k,
            molar_mass_kg_mol,
            enthalpy_j_kg,
            viscosity_pa_s,
        ]: [f64; 5]| GasRow {
            pressure_pa,
            temperature_k,
            molar_mass_kg_mol,
            enthalpy_j_kg,
            viscosity_pa_s,
        };
        let rows = self.rows(&file.gas, columns)?;
        let gas = Gas::try_new(rows.into_iter().map(row).collect());
        let reaction = |of: &OfReaction| {
            let densities = [of.virgin_kg_m3, of.char_kg_m3];
            Reaction::of_component(
                densities,
                of.rate_per_s,
                of.activation_k,
                of.order_exponent,
                of.start_k,
            )
        };
        Ok(Pyrolysis {
            reactions: file.reaction.iter().map(reaction).collect(),
            gas: gas.map_err(|fault| format!("{}: {fault}", file.gas))?,
            permeability_m2: [file.permeability_m2.r#virgin, file.permeability_m2.char],
        })
    }

    fn surface(&self, file: &str) -> Result<Surface, String> {
        let columns = [
            "pressure_pa",
            "gas_ratio",
            "char_ratio",
            "temperature_k",
            "enthalpy_j_kg",
        ];
        let row = |[
            pressure_pa,
            gas_rate,
            char_rate,
            temperature_k,
            enthalpy_j_kg,
        ]: [f64; 5]| WallRow {
            pressure_pa,
            gas_rate,
            char_rate,
            temperature_k,
            enthalpy_j_kg,
        };
        let rows = self.rows(file, columns)?;
        let table = WallTable::try_new(rows.into_iter().map(row).collect());
        Ok(Surface::Reacting(
            table.map_err(|fault| format!("{file}: {fault}"))?,
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const AIR: [[f64; 2]; 2] = [[0.0, 0.0], [4000.0, 4e6]];

    fn with(own: &[(String, String)], name: &str) -> Result<Card, String> {
        Cards { own, air: &AIR }.card(name)
    }

    #[test]
    fn every_shipped_card_is_read() {
        let cards = Cards {
            own: &[],
            air: &AIR,
        };
        let names = cards.names();
        assert!(names.len() >= 10, "{names:?}");
        for name in names {
            let card = cards.card(&name).unwrap();
            assert!(!card.note.is_empty(), "{name}");
        }
    }

    #[test]
    fn heat_of_pyrolysis_is_four_megajoules_per_kilogram_of_gas() {
        for name in ["tacot", "pica"] {
            let solid = with(&[], name).unwrap().material.solid;
            let [v, c] = solid.at(298.15).enthalpy_j_m3;
            let loss = solid.virgin.density_kg_m3 - solid.char.density_kg_m3;
            assert!(((v - c) / loss + 4e6).abs() < 10.0, "{name}");
        }
    }

    #[test]
    fn enthalpy_of_the_printed_table_is_that_of_its_heat_capacity() {
        // TACOT prints 2.583e6 J/kg virgin and 3.422e6 J/kg char at 2222 K.
        let solid = with(&[], "tacot").unwrap().material.solid;
        let [v, c] = solid.at(2222.0).enthalpy_j_m3;
        assert!((v / 280.0 - 2.583e6).abs() < 3e3, "{}", v / 280.0);
        assert!((c / 220.0 - 3.422e6).abs() < 3e3, "{}", c / 220.0);
    }

    #[test]
    fn faults_of_a_card_name_file_key_and_value() {
        let shipped = data_file("ablators/tacot.toml").unwrap();
        let of = |from: &str, to: &str| {
            assert!(shipped.contains(from), "{from}");
            let own = [(
                "ablators/mine.toml".to_string(),
                shipped.replacen(from, to, 1),
            )];
            with(&own, "mine").unwrap_err()
        };
        for (from, to, said) in [
            (
                "specific_heat_j_kg_k",
                "specific_heat_cal_g_k",
                "unknown field `specific_heat_cal_g_k`",
            ),
            (
                "density_kg_m3 = 280.0",
                "density_kg_m3 = -1.0",
                "virgin: density_kg_m3: got -1, must be",
            ),
            (
                "emissivity = 0.8",
                "emissivity = 1.8",
                "virgin: emissivity: got 1.8, must be 0 to 1",
            ),
            (
                "formation_j_kg = -857142.857\n",
                "",
                "virgin.formation_j_kg: missing",
            ),
            (
                "[255.6, 298.0",
                "[298.0, 255.6",
                "virgin: specific_heat: row 2 is not above",
            ),
            (
                "[255.6, 298.0",
                "[298.0",
                "virgin.specific_heat: 12 temperatures, but 13 values",
            ),
            (
                "virgin_kg_m3 = 30.0",
                "virgin_kg_m3 = 31.0",
                "reactions: density_kg_m3: got 61, must be 60 to 60",
            ),
            (
                "tacot-gas.csv",
                "none.csv",
                "ablators/none.csv: is not there",
            ),
        ] {
            let fault = of(from, to);
            assert!(
                fault.starts_with("ablators/mine.toml: ") && fault.contains(said),
                "{fault}"
            );
        }
        assert!(
            with(&[], "tacos")
                .unwrap_err()
                .starts_with("got \"tacos\", must be one of acc, aluminum")
        );
    }
}
