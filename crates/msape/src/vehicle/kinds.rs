//! The kinds of which a vehicle is made: concept, components, walls, foams.

pub use crate::quantity::choice::{CrushingMass, FoamStrength};
use crate::quantity::input::{Input, design};
use serde::{Deserialize, Serialize};

/// Standard gravity, m/s².
pub const EARTH_G_M_S2: f64 = 9.80665;

/// The two concepts of section 3.1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Concept {
    /// Payload in a foam-filled impact sphere with a shell.
    Msr,
    /// Payload nested in impact foam.
    NonMsr,
}

impl Concept {
    /// Name as the report has it.
    pub fn label(self) -> &'static str {
        match self {
            Self::Msr => "MSR",
            Self::NonMsr => "non-MSR",
        }
    }
}

/// The parts of a vehicle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ComponentKind {
    /// Heat shield of the forebody.
    ForebodyTps,
    /// Bond under it.
    Bond,
    /// Carrier structure of the forebody.
    ForebodyCarrier,
    /// Heat shield of the aftbody.
    AftbodyTps,
    /// Carrier structure of the aftbody.
    AftbodyCarrier,
    /// Cylinder wall from forebody carrier to attached structure.
    PrimaryStructure,
    /// Filling of the wing.
    WingInsulation,
    /// Foam around or under the payload.
    ImpactFoam,
    /// Shell of the impact sphere.
    ImpactShell,
    /// Foam around the impact sphere.
    BodyFoam,
    /// Filling of the lid.
    LidInsulation,
    /// Payload.
    Payload,
}

impl ComponentKind {
    /// Number of kinds.
    pub const COUNT: usize = 12;

    /// All, in the order in which they are summed.
    pub const ALL: [ComponentKind; Self::COUNT] = [
        Self::ForebodyTps,
        Self::Bond,
        Self::ForebodyCarrier,
        Self::AftbodyTps,
        Self::AftbodyCarrier,
        Self::PrimaryStructure,
        Self::WingInsulation,
        Self::ImpactFoam,
        Self::ImpactShell,
        Self::BodyFoam,
        Self::LidInsulation,
        Self::Payload,
    ];

    /// All whose mass the user may give instead of a density.
    pub const MADE: [ComponentKind; 11] = [
        Self::ForebodyTps,
        Self::Bond,
        Self::ForebodyCarrier,
        Self::AftbodyTps,
        Self::AftbodyCarrier,
        Self::PrimaryStructure,
        Self::WingInsulation,
        Self::ImpactFoam,
        Self::ImpactShell,
        Self::BodyFoam,
        Self::LidInsulation,
    ];

    /// Name in the keys of a case.
    pub fn key(self) -> &'static str {
        match self {
            Self::ForebodyTps => "forebody_tps",
            Self::Bond => "bond",
            Self::ForebodyCarrier => "forebody_carrier_structure",
            Self::AftbodyTps => "aftbody_tps",
            Self::AftbodyCarrier => "aftbody_carrier_structure",
            Self::PrimaryStructure => "primary_structure",
            Self::WingInsulation => "wing_insulation",
            Self::ImpactFoam => "impact_foam",
            Self::ImpactShell => "impact_shell",
            Self::BodyFoam => "body_foam",
            Self::LidInsulation => "lid_insulation",
            Self::Payload => "payload",
        }
    }

    /// Input of the mass of a component; none of the payload's, which is required.
    pub fn mass_input(self) -> Option<&'static Input> {
        Some(match self {
            Self::ForebodyTps => &design::COMPONENT_MASS_KG_FOREBODY_TPS,
            Self::Bond => &design::COMPONENT_MASS_KG_BOND,
            Self::ForebodyCarrier => &design::COMPONENT_MASS_KG_FOREBODY_CARRIER_STRUCTURE,
            Self::AftbodyTps => &design::COMPONENT_MASS_KG_AFTBODY_TPS,
            Self::AftbodyCarrier => &design::COMPONENT_MASS_KG_AFTBODY_CARRIER_STRUCTURE,
            Self::PrimaryStructure => &design::COMPONENT_MASS_KG_PRIMARY_STRUCTURE,
            Self::WingInsulation => &design::COMPONENT_MASS_KG_WING_INSULATION,
            Self::ImpactFoam => &design::COMPONENT_MASS_KG_IMPACT_FOAM,
            Self::ImpactShell => &design::COMPONENT_MASS_KG_IMPACT_SHELL,
            Self::BodyFoam => &design::COMPONENT_MASS_KG_BODY_FOAM,
            Self::LidInsulation => &design::COMPONENT_MASS_KG_LID_INSULATION,
            Self::Payload => return None,
        })
    }

    /// Name in plain words.
    pub fn label(self) -> &'static str {
        match self {
            Self::ForebodyTps => "Forebody TPS",
            Self::Bond => "Bond",
            Self::ForebodyCarrier => "Forebody carrier structure",
            Self::AftbodyTps => "Aftbody TPS",
            Self::AftbodyCarrier => "Aftbody carrier structure",
            Self::PrimaryStructure => "Primary structure",
            Self::WingInsulation => "Wing insulation",
            Self::ImpactFoam => "Impact foam",
            Self::ImpactShell => "Impact shell",
            Self::BodyFoam => "Body foam",
            Self::LidInsulation => "Lid insulation",
            Self::Payload => "Payload",
        }
    }
}

/// The three walls that a [`CarrierMaterial`] can make.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum WallPlace {
    /// Under the forebody's heat shield.
    Forebody,
    /// Under the aftbody's heat shield.
    Aftbody,
    /// Between forebody and attached structure.
    Primary,
}

impl WallPlace {
    /// All, in the order of tables.
    pub const ALL: [WallPlace; 3] = [Self::Forebody, Self::Aftbody, Self::Primary];

    /// Name in plain words.
    pub fn label(self) -> &'static str {
        match self {
            Self::Forebody => "Forebody carrier",
            Self::Aftbody => "Aftbody carrier",
            Self::Primary => "Primary structure",
        }
    }
}

/// Impact foam that the landing requires.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Foam<S = f64> {
    /// Thickness, m.
    pub thickness_m: S,
    /// Density, kg/m³.
    pub density_kg_m3: S,
    /// Requested compressive strength, Pa.
    pub strength_pa: S,
}

/// A foam and its strength.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FoamGrade {
    /// Name.
    pub name: String,
    /// Density, kg/m³.
    pub density_kg_m3: f64,
    /// Compressive strength, Pa.
    pub compressive_strength_pa: f64,
    /// Key in the list of references.
    pub source: String,
}

/// Densities of the fillings.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ComponentDensities<S = f64> {
    /// Impact foam with its panels, kg/m³; `None` takes the grade that has the requested strength, and adds the panels.
    pub impact_foam_kg_m3: Option<S>,
    /// Composite panels of the MSR impact sphere, smeared over its foam, kg/m³; part of the density of the foam.
    pub impact_panels_kg_m3: S,
    /// Impact shell, kg/m³.
    pub impact_shell_kg_m3: S,
    /// Body foam, kg/m³.
    pub body_foam_kg_m3: S,
    /// Lid insulation, kg/m³.
    pub lid_insulation_kg_m3: S,
    /// Wing insulation, kg/m³.
    pub wing_insulation_kg_m3: S,
}
