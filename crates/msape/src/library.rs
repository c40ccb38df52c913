//! Planets, atmospheres, materials, vehicles, grounds and aerodynamic databases: built-in, plus what the user adds.
//!
//! A library is always passed, never global.

mod files;

use crate::aero::AxialForce;
use crate::aero::damping::DampingData;
use crate::aero::euler::EulerCorrection;
use crate::aero::standard::{AxialForces, Standard};
use crate::heating::afterbody::Afterbody;
use crate::heating::brandis_johnston::BrandisJohnston;
use crate::heating::pressure::PressureFit;
use crate::heating::shoulder::Shoulder;
use crate::heating::sutton_graves::SuttonGraves;
use crate::heating::tauber_sutton::TauberSutton;
use crate::heating::wall::WallGas;
use crate::planet::Planet;
use crate::planet::atmosphere::Atmosphere;
use crate::quantity::input::{Choices, OWN_ATMOSPHERE, OWN_OUTLINE};
use crate::soak::SoakCorrelation;
use crate::tps::Side;
use crate::tps::concept::Concept;
use crate::tps::fit_space::FitSpace;
use crate::tps::material::TpsMaterial;
use crate::vehicle::body::OutlineData;
use crate::vehicle::impact::Ground;
use crate::vehicle::impact::foam::FoamKind;
use crate::vehicle::rules::VehicleData;
use thiserror::Error;

pub use files::{case_file, cases, data_file, data_folder};

/// A data file that cannot be read.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("{file}: {message}")]
pub struct DataError {
    /// Path of the file below `data`.
    pub file: String,
    /// What is wrong with it.
    pub message: String,
}

/// A thing of the library and the name by which a case calls it.
pub type Named<T> = Vec<(String, T)>;

/// Heating models and what goes with them.
#[derive(Clone, Debug)]
pub struct HeatingModels {
    /// Sutton-Graves constants by planet.
    pub sutton_graves: Named<SuttonGraves>,
    /// Tauber-Sutton relations by planet.
    pub tauber_sutton: Named<TauberSutton>,
    /// Brandis-Johnston relations, for the Earth.
    pub brandis_johnston: BrandisJohnston,
    /// Gas at a hot wall by planet.
    pub wall_gas: Named<WallGas>,
    /// Fractions of the aftbody.
    pub afterbody: Afterbody,
    /// Shoulder factor.
    pub shoulder: Shoulder,
    /// Stagnation pressure by equation 9.
    pub pressure_fit: PressureFit,
}

/// Everything a case may name.
#[derive(Clone, Debug)]
pub struct Library {
    /// Planets by name.
    pub planets: Named<Planet>,
    /// Atmospheres by name, with a title.
    pub atmospheres: Named<(String, Atmosphere)>,
    /// Heating models.
    pub heating: HeatingModels,
    /// Heat-shield materials by name.
    pub materials: Named<TpsMaterial>,
    /// Forebody concepts by name.
    pub concepts: Named<Concept>,
    /// Soak correlations by the name of the heat-shield material.
    pub soak: Named<SoakCorrelation>,
    /// Trajectory space of the mass-estimating relations.
    pub fit_space: FitSpace,
    /// Rules, densities, carriers and foams of the vehicle family.
    pub vehicle: VehicleData,
    /// Grounds by name.
    pub grounds: Named<Ground>,
    /// How impact foam crushes.
    pub impact_foam: FoamKind,
    /// Aerodynamic databases by name.
    pub aerodynamics: Named<AxialForce>,
    /// Pitch damping of the report.
    pub damping: DampingData,
    /// Axial force by solutions of the Euler equations.
    pub euler: EulerCorrection,
    /// Outlines of rigid bodies by name.
    pub outlines: Named<OutlineData>,
}

impl Library {
    /// The library that ships with the program.
    ///
    /// # Errors
    /// A data file that cannot be read, which a test excludes.
    ///
    /// ```
    /// let library = msape::Library::builtin().unwrap();
    /// assert!(library.planets.iter().any(|(name, _)| name == "earth-msape"));
    /// ```
    pub fn builtin() -> Result<Library, DataError> {
        let planets = folder("planets", Planet::parse)?;
        let earth = parsed("heating/tauber-sutton.toml", TauberSutton::parse)?;
        Ok(Library {
            atmospheres: folder("atmospheres", Atmosphere::parse)?,
            heating: HeatingModels {
                sutton_graves: of_planets(
                    "heating/sutton-graves.toml",
                    &planets,
                    SuttonGraves::parse,
                )?,
                tauber_sutton: vec![
                    ("earth".to_string(), earth.clone()),
                    ("earth-msape".to_string(), earth),
                    (
                        "mars".to_string(),
                        parsed("heating/tauber-sutton-mars.toml", TauberSutton::parse)?,
                    ),
                ],
                brandis_johnston: parsed("heating/brandis-johnston.toml", BrandisJohnston::parse)?,
                wall_gas: of_planets("heating/hot-wall.toml", &planets, WallGas::parse)?,
                afterbody: parsed("heating/afterbody.toml", Afterbody::parse)?,
                shoulder: parsed("heating/shoulder.toml", Shoulder::parse)?,
                pressure_fit: parsed("heating/stagnation-pressure.toml", PressureFit::parse)?,
            },
            materials: folder("materials", TpsMaterial::parse)?,
            concepts: folder("concepts", Concept::parse)?,
            planets,
            soak: folder("soak", SoakCorrelation::parse)?,
            fit_space: parsed("tps/mer-fit-space.toml", FitSpace::parse)?,
            vehicle: parsed("vehicles/mmeev.toml", VehicleData::parse)?,
            grounds: folder("grounds", Ground::parse)?,
            impact_foam: parsed("foams/pmi.toml", FoamKind::parse)?,
            aerodynamics: folder("aerodynamics", AxialForce::parse)?,
            damping: parsed("aero-models/damping.toml", DampingData::parse)?,
            euler: parsed("aero-models/euler-correction.toml", EulerCorrection::parse)?,
            outlines: folder("outlines", OutlineData::parse)?,
        })
    }

    /// Data from which the axial force of an outline is computed.
    pub fn axial_forces(&self) -> AxialForces {
        let tables = self.aerodynamics.iter();
        AxialForces::new(
            tables
                .map(|(_, force)| (force.cone_half_angle_deg, force.table.clone()))
                .collect(),
            self.euler.clone(),
        )
    }

    /// Data from which the aerodynamic database of an outline is computed.
    pub fn aero_standard(&self) -> Standard {
        Standard {
            forces: self.axial_forces(),
            damping: self.damping.clone(),
        }
    }

    /// Heat-shield materials that are made for the aftbody.
    pub fn aftbody_materials(&self) -> impl Iterator<Item = &(String, TpsMaterial)> {
        self.materials
            .iter()
            .filter(|(_, material)| material.sides.contains(&Side::Aftbody))
    }

    /// Names and titles of what can be chosen.
    pub fn choices(&self, choices: Choices) -> Vec<(String, String)> {
        fn titles<T>(list: &Named<T>, title: impl Fn(&T) -> &str) -> Vec<(String, String)> {
            list.iter()
                .map(|(name, thing)| (name.clone(), title(thing).to_string()))
                .collect()
        }
        match choices {
            Choices::Fixed(fixed) => fixed
                .iter()
                .map(|(name, label)| (name.to_string(), label.to_string()))
                .collect(),
            Choices::Planets => titles(&self.planets, |planet| &planet.title),
            Choices::Atmospheres => {
                let mut all = vec![(OWN_ATMOSPHERE.to_string(), "Of the planet".to_string())];
                all.extend(titles(&self.atmospheres, |(title, _)| title));
                all
            }
            Choices::ForebodyConcepts => titles(&self.concepts, |concept| &concept.name),
            Choices::AftbodyMaterials => self
                .aftbody_materials()
                .map(|(name, material)| (name.clone(), material.name.clone()))
                .collect(),
            Choices::Grounds => titles(&self.grounds, |ground| &ground.name),
            Choices::Aerodynamics => titles(&self.aerodynamics, |database| &database.title),
            Choices::DesignAerodynamics => {
                let mut all = vec![(
                    OWN_OUTLINE.to_string(),
                    "Of the outline itself, computed".to_string(),
                )];
                all.extend(titles(&self.aerodynamics, |database| &database.title));
                all
            }
            Choices::Outlines => titles(&self.outlines, |outline| &outline.title),
        }
    }
}

/// The thing with this name.
pub fn named<'a, T>(list: &'a Named<T>, name: &str) -> Option<&'a T> {
    list.iter()
        .find(|(known, _)| known == name)
        .map(|(_, thing)| thing)
}

fn text(path: &str) -> Result<&'static str, DataError> {
    let file = files::LIBRARY.iter().find(|(name, _)| *name == path);
    file.map(|(_, text)| *text).ok_or_else(|| DataError {
        file: path.to_string(),
        message: "is not there".to_string(),
    })
}

fn parsed<T>(path: &str, parse: impl Fn(&str) -> Result<T, String>) -> Result<T, DataError> {
    parse(text(path)?).map_err(|message| DataError {
        file: path.to_string(),
        message,
    })
}

/// A file that holds something for each planet.
fn of_planets<T>(
    file: &str,
    planets: &Named<Planet>,
    parse: impl Fn(&str, &str) -> Result<T, String>,
) -> Result<Named<T>, DataError> {
    planets
        .iter()
        .map(|(name, _)| Ok((name.clone(), parsed(file, |text| parse(text, name))?)))
        .collect()
}

/// Every file of a folder, by its name without the ending.
fn folder<T>(name: &str, parse: impl Fn(&str) -> Result<T, String>) -> Result<Named<T>, DataError> {
    files::within(files::LIBRARY, name)
        .map(|(path, _)| {
            let file = path.rsplit('/').next().unwrap_or(path);
            let stem = file.split('.').next().unwrap_or(file);
            Ok((stem.to_string(), parsed(path, &parse)?))
        })
        .collect()
}
