//! Heat shield and entry mass of flown capsules, predicted from their equipment and entry state.
//!
//! ```text
//! M = M_e + ρ V(t),   t = t(Q(M))            closed on the mass
//! V = 2π (1 − sin θ) [Rₙ³ − (Rₙ − t)³]/3 + 2π L (r̄ t − ½ t² cos θ)
//! ```
//!
//! with M the entry mass and M_e the given one of all but the forebody's heat shield in kg, ρ its density in kg/m³, V its
//! volume in m³, t its thickness in m by the relation of its material for the heat load Q in J/m² of the flight; Rₙ the nose
//! radius, L the slant length and r̄ the mean radius of the cone in m, θ its half-angle.
//!
//! The band is that of the relation's standard deviation on the thickness, and on the masses of this and of the densities
//! found for the material: the least is closed with both at their least, the greatest with both at their greatest.
//!
//! Nothing is fitted: the case is flown with the margins of the report's run page, and the heat shield is sized at its
//! hottest point where a shoulder radius is known. A prediction is a hit when its band meets the flown value or its range. A
//! miss is no fault of the program and does not end `validate` with one.
//!
//! # Valid
//! A heat shield of one thickness on a sphere-cone, without bond and carrier, which count as given. A sharp shoulder has no
//! factor: the heat shield is sized at the stagnation point.
//!
//! # References
//! - \[samareh-2014\] Table 7; those of each file of `data/predictions`.

use crate::case::Case;
use crate::flight::{self, Request};
use crate::library::{DataError, Library, data_folder, named};
use crate::problem::FlightProblem;
use crate::quantity::input;
use crate::tps::environment::OffStagnation;
use crate::tps::material::TpsMaterial;
use crate::tps::mer::{self, Sizing};
use crate::tps::{Environment, JudgedAt, Point};
use crate::vehicle::body::Shape;
use numerics::math;
use serde::{Deserialize, Serialize};

/// Verdict on a prediction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// The predicted band contains the flown value.
    Hit,
    /// The predicted band does not contain the flown value.
    Miss,
    /// No flown value was found.
    NotKnown,
}

impl Verdict {
    /// Name as in files and tables.
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Hit => "hit",
            Verdict::Miss => "miss",
            Verdict::NotKnown => "not known",
        }
    }
}

/// A figure of a flown capsule; where sources differ, their range.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct FlownValue {
    least: f64,
    greatest: f64,
    source: String,
    place: String,
}

/// Flown values, in the units of the rows.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct Flown {
    thickness_cm: Option<FlownValue>,
    heat_shield_mass_kg: Option<FlownValue>,
    entry_mass_kg: Option<FlownValue>,
}

/// Given masses and dimensions: all but the forebody's heat shield.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct Equipment {
    mass_kg: f64,
    source: String,
    place: String,
}

/// A file of `data/predictions`.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct File {
    /// Name for people.
    pub title: String,
    /// Key of the bibliography, of the entry state.
    pub source: String,
    /// Place in the source.
    pub place: String,
    /// Note on the whole comparison.
    pub note: String,
    /// Name of an outline.
    outline: String,
    /// Name of a heat-shield material.
    material: String,
    /// Entry, heating and mass to begin with: a case for `fly`, whose outline is the one named.
    case: String,
    equipment: Equipment,
    #[serde(default)]
    flown: Flown,
}

/// A predicted quantity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Prediction {
    /// Name of the file, such as `stardust`.
    pub capsule: String,
    /// Label of the quantity.
    pub label: String,
    /// Symbol of the unit of the numbers below.
    pub unit: String,
    /// Predicted value.
    pub predicted: f64,
    /// Lower end of the predicted band.
    pub least: f64,
    /// Upper end of the predicted band.
    pub greatest: f64,
    /// Flown value, or the least where sources differ.
    pub flown_least: Option<f64>,
    /// Greatest flown value.
    pub flown_greatest: Option<f64>,
    /// Verdict.
    pub verdict: Verdict,
    /// Source of the flown value.
    pub source: String,
}

/// A capsule and its predictions.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Capsule {
    /// Name of the file.
    pub name: String,
    /// Name for people.
    pub title: String,
    /// Given quantities, with their sources.
    pub given: String,
    /// Note on the predictions.
    pub note: String,
    /// The predictions.
    pub rows: Vec<Prediction>,
}

/// Every capsule of the folder `predictions`.
///
/// # Errors
/// A file that cannot be read or contains an unknown name, which a test excludes.
pub fn capsules(library: &Library) -> Result<Vec<Capsule>, DataError> {
    data_folder("predictions")
        .map(|(path, text)| {
            let file = path.rsplit('/').next().unwrap_or(path);
            let name = file.split('.').next().unwrap_or(file);
            let error = |message: String| DataError {
                file: path.to_string(),
                message,
            };
            let file: File = toml::from_str(text).map_err(|e| error(e.to_string()))?;
            Closing::new(library, &file)
                .map(|closing| closing.capsule(name, &file))
                .map_err(error)
        })
        .collect()
}

/// Largest number of iterations of the closing, and the change of the mass at which it ends, kg.
const TURNS: usize = 50;
const SETTLED_KG: f64 = 1e-9;

/// A capsule that is closed on its mass.
struct Closing<'a> {
    problem: FlightProblem,
    shape: Shape,
    half_angle_rad: f64,
    shoulder_factor: f64,
    material: &'a TpsMaterial,
    equipment_kg: f64,
}

/// A closed capsule.
struct Closed {
    sizing: Sizing,
    thickness_m: f64,
    heat_shield_kg: f64,
    entry_kg: f64,
}

impl<'a> Closing<'a> {
    fn new(library: &'a Library, file: &File) -> Result<Closing<'a>, String> {
        let outline = named(&library.outlines, &file.outline)
            .ok_or_else(|| format!("no outline is called \"{}\"", file.outline))?;
        let material = named(&library.materials, &file.material)
            .ok_or_else(|| format!("no material is called \"{}\"", file.material))?;
        let shape = outline.shape()?;
        let half_angle_rad = shape
            .cone_half_angle_rad
            .ok_or("the outline has no cone, the volume of the heat shield needs one")?;
        let mut case = Case::from_text(&file.case).map_err(|faults| super::joined(&faults))?;
        case.set(input::outline::PRESET.key, &file.outline);
        let problem =
            FlightProblem::check(&case, library).map_err(|faults| super::joined(&faults))?;
        let shoulder_ratio = 2.0 * shape.shoulder_radius_m / shape.diameter_m;
        Ok(Closing {
            problem,
            half_angle_rad,
            // a sharp shoulder has no factor
            shoulder_factor: if shoulder_ratio > 0.0 {
                library.heating.shoulder.ratio(shoulder_ratio)
            } else {
                1.0
            },
            shape,
            material,
            equipment_kg: file.equipment.mass_kg,
        })
    }

    /// Heat shield that a capsule of a mass, kg, requires.
    fn sizing(&self, mass_kg: f64) -> Sizing {
        let FlightProblem { mission, body, .. } = &self.problem;
        let mut body = body.clone();
        body.mass_kg = mass_kg;
        let (flight, ..) = flight::fly(mission, &body, Request::Nothing);
        let stagnation = Environment {
            point: Point::Stagnation,
            peak_heat_flux_w_m2: flight.peak_total_margined_heat_flux_w_m2.value,
            heat_load_j_m2: flight.total_margined_heat_load_j_m2(),
            peak_pressure_pa: flight.peak_stagnation_pressure_pa.value,
            entry_speed_m_s: flight.entry_relative.speed_m_s,
            entry_flight_path_angle_rad: flight.entry_relative.flight_path_angle_rad,
            time_above_limit_s: None,
        };
        let judged = JudgedAt::HottestPoint
            .environment(&stagnation, &OffStagnation::shoulder(self.shoulder_factor));
        mer::size(self.material, &judged)
    }

    /// Closes the mass with the thickness of the relation changed by a number of its standard deviations.
    fn close(&self, deviations: f64, density_kg_m3: f64) -> Closed {
        let mut entry_kg = self.problem.body.mass_kg;
        let mut turn = 0;
        loop {
            let sizing = self.sizing(entry_kg);
            let thickness_m = sizing.thickness_m + deviations * sizing.standard_deviation_m;
            let heat_shield_kg = density_kg_m3 * self.volume_m3(thickness_m);
            let change_kg = self.equipment_kg + heat_shield_kg - entry_kg;
            entry_kg += change_kg;
            turn += 1;
            if change_kg.abs() < SETTLED_KG || turn == TURNS {
                return Closed {
                    sizing,
                    thickness_m,
                    heat_shield_kg,
                    entry_kg,
                };
            }
        }
    }

    fn volume_m3(&self, thickness_m: f64) -> f64 {
        shell_volume_m3(&self.shape, self.half_angle_rad, thickness_m)
    }

    fn capsule(&self, name: &str, file: &File) -> Capsule {
        let density = &self.material.density;
        let nominal = density.density_kg_m3;
        let middle = self.close(0.0, nominal);
        let ends = [
            self.close(-1.0, density.range_kg_m3.min.unwrap_or(nominal)),
            self.close(1.0, density.range_kg_m3.max.unwrap_or(nominal)),
        ];
        // the thickness alone knows no density: its band is that of the relation at the predicted mass
        let deviation_cm = 100.0 * middle.sizing.standard_deviation_m;
        let thickness_cm = 100.0 * middle.thickness_m;
        let masses = |get: fn(&Closed) -> f64| [get(&middle), get(&ends[0]), get(&ends[1])];
        let flown = &file.flown;
        let rows = [
            (
                "Forebody TPS thickness",
                "cm",
                [
                    thickness_cm,
                    thickness_cm - deviation_cm,
                    thickness_cm + deviation_cm,
                ],
                &flown.thickness_cm,
            ),
            (
                "Forebody TPS mass",
                "kg",
                masses(|closed| closed.heat_shield_kg),
                &flown.heat_shield_mass_kg,
            ),
            (
                "Total entry mass",
                "kg",
                masses(|closed| closed.entry_kg),
                &flown.entry_mass_kg,
            ),
        ];
        let Equipment {
            mass_kg,
            source,
            place,
        } = &file.equipment;
        Capsule {
            name: name.to_string(),
            title: file.title.clone(),
            given: format!(
                "{mass_kg} kg without the forebody's heat shield [{source}, {place}]; entry [{}, {}]; heat shield of {}, {} to {} kg/m³, nominal {nominal}",
                file.source,
                file.place,
                self.material.name,
                density.range_kg_m3.min.unwrap_or(nominal),
                density.range_kg_m3.max.unwrap_or(nominal),
            ),
            note: file.note.clone(),
            rows: rows
                .into_iter()
                .map(|(label, unit, band, flown)| row(name, label, unit, band, flown.as_ref()))
                .collect(),
        }
    }
}

fn row(
    capsule: &str,
    label: &str,
    unit: &str,
    [predicted, least, greatest]: [f64; 3],
    flown: Option<&FlownValue>,
) -> Prediction {
    let verdict = match flown {
        None => Verdict::NotKnown,
        Some(flown) if flown.greatest >= least && flown.least <= greatest => Verdict::Hit,
        Some(_) => Verdict::Miss,
    };
    Prediction {
        capsule: capsule.to_string(),
        label: label.to_string(),
        unit: unit.to_string(),
        predicted,
        least,
        greatest,
        flown_least: flown.map(|flown| flown.least),
        flown_greatest: flown.map(|flown| flown.greatest),
        verdict,
        source: flown.map_or_else(String::new, |flown| {
            format!("{}, {}", flown.source, flown.place)
        }),
    }
}

/// Volume of a layer of one thickness, m, inside nose and cone, the cone going on to the largest diameter, m³.
fn shell_volume_m3(shape: &Shape, half_angle_rad: f64, thickness_m: f64) -> f64 {
    let (sin, cos) = math::sin_cos(half_angle_rad);
    let (r_n, t) = (shape.nose_radius_m, thickness_m);
    let inner = (r_n - t).max(0.0);
    let cap = 2.0 * math::PI * (1.0 - sin) * (r_n * r_n * r_n - inner * inner * inner) / 3.0;
    let (from_m, to_m) = (r_n * cos, 0.5 * shape.diameter_m);
    let length = (to_m - from_m) / sin;
    let mean = 0.5 * (from_m + to_m);
    cap + 2.0 * math::PI * length * (mean * t - 0.5 * t * t * cos)
}

#[cfg(test)]
mod tests;
