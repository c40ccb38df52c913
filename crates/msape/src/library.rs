//! Planets, atmospheres, materials, vehicles, grounds and aerodynamic databases: built-in, and files of the user.
//!
//! A library is always passed, never global.

mod build;
mod files;
mod read;

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
use crate::vehicle::rules::{CarrierMaterial, VehicleData};
use thiserror::Error;

use read::Files;

pub use files::{case_file, cases, data_file, data_folder};

/// A data file that cannot be used.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{file}: {message}")]
pub struct DataError {
    /// Path of the file below `data`.
    pub file: String,
    /// Fault of the file: key, value, and the values allowed.
    pub message: String,
}

/// Items of the library, with the names by which a case refers to them.
pub type Named<T> = Vec<(String, T)>;

/// A planet with its air and its heating relations.
#[derive(Clone, Debug)]
pub struct World {
    /// The planet.
    pub planet: Planet,
    /// Title of the planet's own atmosphere.
    pub atmosphere_title: String,
    /// The planet's own atmosphere.
    pub atmosphere: Atmosphere,
    /// Sutton-Graves constant.
    pub sutton_graves: SuttonGraves,
    /// Tauber-Sutton relation, if there is one for the gas.
    pub tauber_sutton: Option<TauberSutton>,
    /// Brandis-Johnston relations, if they apply to the gas.
    pub brandis_johnston: Option<BrandisJohnston>,
    /// Gas at a hot wall.
    pub wall_gas: WallGas,
}

/// A forebody concept with its materials and correlations.
#[derive(Clone, Debug)]
pub struct Stack {
    /// The concept.
    pub concept: Concept,
    /// Material of its heat shield.
    pub tps: TpsMaterial,
    /// Soak correlation behind it.
    pub soak: SoakCorrelation,
    /// Carrier structure below it.
    pub carrier: CarrierMaterial,
}

/// Heating models that are the same on all planets.
#[derive(Clone, Debug)]
pub struct HeatingModels {
    /// Fractions of the aftbody.
    pub afterbody: Afterbody,
    /// Shoulder factor.
    pub shoulder: Shoulder,
    /// Stagnation pressure by equation 9.
    pub pressure_fit: PressureFit,
}

/// Everything a case may refer to; references between data files are resolved.
#[derive(Clone, Debug)]
pub struct Library {
    /// Planets by name; one at least.
    pub planets: Named<World>,
    /// Atmospheres by name, with a title.
    pub atmospheres: Named<(String, Atmosphere)>,
    /// Heating models.
    pub heating: HeatingModels,
    /// Heat-shield materials by name.
    pub materials: Named<TpsMaterial>,
    /// Forebody concepts by name.
    pub concepts: Named<Stack>,
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
    /// Cards of materials in depth of the user, and tables beside them: paths and texts.
    pub ablators: Vec<(String, String)>,
}

impl Library {
    /// The library that ships with the program.
    ///
    /// # Errors
    /// A data file that cannot be used, which a test excludes.
    ///
    /// ```
    /// let library = msape::Library::builtin().unwrap();
    /// assert!(library.planets.iter().any(|(name, _)| name == "earth-msape"));
    /// ```
    pub fn builtin() -> Result<Library, DataError> {
        build::library(Files::shipped()).map_err(|faults| {
            let nameless = DataError {
                file: String::new(),
                message: "the library cannot be built".to_string(),
            };
            faults.into_iter().next().unwrap_or(nameless)
        })
    }

    /// The library of the program with files of the user: path below a folder laid out as `data`, and text. Their
    /// names must be new ones; what they name may be shipped or their own.
    ///
    /// ```
    /// use msape::Library;
    ///
    /// let text = msape::library::data_file("planets/mars.toml").unwrap();
    /// let own = text.replace("\"mars\"\ntitle", "\"dusty\"\ntitle") + "\n";
    /// let own = own.replace("\natmosphere", "\nheating_as = \"mars\"\natmosphere");
    /// let library = Library::with_files(&[("planets/dusty.toml".to_string(), own.clone())]).unwrap();
    /// assert!(library.planets.iter().any(|(name, _)| name == "dusty"));
    ///
    /// let dangling = own.replace("atmosphere = \"mars\"", "atmosphere = \"mrs\"");
    /// let faults = Library::with_files(&[("planets/dusty.toml".to_string(), dangling)]).unwrap_err();
    /// assert!(faults[0].to_string().starts_with("planets/dusty.toml: atmosphere: got \"mrs\", must be one of jupiter, mars"));
    /// ```
    ///
    /// # Errors
    /// Every file that cannot be used, and every unknown name in a file.
    #[cfg(feature = "own-data")]
    pub fn with_files(own: &[(String, String)]) -> Result<Library, Vec<DataError>> {
        build::library(Files::shipped().with(own))
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
            Choices::Planets => titles(&self.planets, |world| &world.planet.title),
            Choices::Atmospheres => {
                let mut all = vec![(OWN_ATMOSPHERE.to_string(), "Of the planet".to_string())];
                all.extend(titles(&self.atmospheres, |(title, _)| title));
                all
            }
            Choices::ForebodyConcepts => titles(&self.concepts, |stack| &stack.concept.name),
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

/// The names of a list.
pub fn names<T>(list: &Named<T>) -> Vec<&str> {
    list.iter().map(|(name, _)| name.as_str()).collect()
}

/// The item with this name.
pub fn named<'a, T>(list: &'a Named<T>, name: &str) -> Option<&'a T> {
    list.iter()
        .find(|(known, _)| known == name)
        .map(|(_, thing)| thing)
}
