//! Components as closed profiles with densities, and the mass tree that they add up to.
//!
//! ```text
//! M = Σ (1 + margin) ρ V + M_PL      x_cg = Σ m x̄ / M      I_yy = Σ ρ J_yy − M x_cg²
//! ```
//!
//! with masses in kg, x from the virtual apex in m, J second moments of volume about x = 0 in m⁵; the margin on everything but the
//! payload. Sums run in the order of the components.
//!
//! # Valid
//! Homogeneous components; center of gravity on the axis.
//!
//! # References
//! - \[samareh-2014\] section 3.1.4 and Table 1.

use crate::vehicle::draft::{Draft, Memory};
use crate::vehicle::input::VehicleInput;
use crate::vehicle::kinds::ComponentKind;
use crate::vehicle::kinds::Concept;
use crate::vehicle::kinds::Foam;
use crate::vehicle::layout::Layout;
use crate::vehicle::material::{DensityBasis, Material};
use crate::vehicle::profile::{Profile, SolidProperties};
use crate::vehicle::shapes::{draw, profiles};
use crate::vehicle::structure::Structure;
use numerics::scalar::Single;
use serde::{Deserialize, Serialize};

/// A component: closed profiles, density, mass.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Component {
    /// Kind of component.
    pub kind: ComponentKind,
    /// Closed profiles (the body foam may be in two pieces).
    pub profiles: Vec<Profile>,
    /// Volume, m³.
    pub volume_m3: f64,
    /// Density, kg/m³.
    pub density_kg_m3: f64,
    /// Name of its material.
    pub material: String,
    /// Basis of the density.
    pub density_basis: DensityBasis,
    /// Area of its closed surface, m².
    pub surface_area_m2: f64,
    /// Area of the part of it that the outer air touches, m².
    pub wetted_area_m2: f64,
    /// Mass without margin, kg.
    pub mass_kg: f64,
    /// Mass with margin, kg.
    pub mass_with_margin_kg: f64,
    /// Axial position of its center of gravity from the virtual apex, m.
    pub cg_x_m: f64,
    /// Moment of inertia about the axis, with margin, kg m².
    pub ixx_kg_m2: f64,
    /// Moment of inertia about a transverse axis through its own center of gravity, with margin, kg m².
    pub iyy_kg_m2: f64,
    /// Volume and moments.
    pub solid: SolidProperties,
}

/// Mass, center of gravity and inertia of the whole, margin included.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct MassProperties<S = f64> {
    /// Mass, kg.
    pub mass_kg: S,
    /// Mass without any margin, kg.
    pub mass_without_margin_kg: S,
    /// Axial position of the center of gravity from the virtual apex, m.
    pub cg_x_m: S,
    /// Moment of inertia about the axis, kg m².
    pub ixx_kg_m2: S,
    /// Moment of inertia about a transverse axis through the center of gravity, kg m².
    pub iyy_kg_m2: S,
    /// Moment of inertia about the other transverse axis through the center of gravity, kg m².
    pub izz_kg_m2: S,
    /// Volume of all components, m³.
    pub volume_m3: S,
}

/// Densities that are computed and not given.
#[derive(Clone, Copy, Debug)]
pub struct Densities<'a, S = f64> {
    /// Walls.
    pub structure: &'a Structure<S>,
    /// Impact foam.
    pub foam: Foam<S>,
}

/// Mass and center of gravity alone, margin included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Masses<S = f64> {
    /// Each component, with margin, kg: zero where the concept does not have it.
    parts_kg: [S; ComponentKind::COUNT],
    /// Sum of the components, kg.
    pub mass_kg: S,
    /// Axial position of the center of gravity from the virtual apex, m.
    pub cg_x_m: S,
}

impl<S: Single> Masses<S> {
    /// Masses from the parts and from their sum.
    pub fn of(
        parts: impl Iterator<Item = (ComponentKind, Part<S>)>,
        mass: &MassProperties<S>,
    ) -> Self {
        let mut parts_kg = [S::constant(0.0); ComponentKind::COUNT];
        for (kind, part) in parts {
            parts_kg[kind as usize] = part.mass_with_margin_kg;
        }
        Self {
            parts_kg,
            mass_kg: mass.mass_kg,
            cg_x_m: mass.cg_x_m,
        }
    }

    /// Sum over the components of some kinds, with margin, kg.
    pub fn sum_kg(&self, of: impl Fn(ComponentKind) -> bool) -> S {
        let those = ComponentKind::ALL.iter().filter(|kind| of(**kind));
        let each_kg = those.map(|kind| self.parts_kg[*kind as usize]);
        each_kg.fold(S::constant(0.0), |sum, kg| sum + kg)
    }
}

/// The factor of the margin on a component.
fn margin_factor<S: Single>(kind: ComponentKind, input: &VehicleInput<S>) -> S {
    match kind {
        ComponentKind::Payload => S::constant(1.0),
        _ => input.mass_margin + 1.0,
    }
}

/// Results of [`parts`] and [`total`] that the closing loop needs, with the same bits.
pub fn masses<S: Single>(
    input: &VehicleInput<S>,
    layout: &Layout<S>,
    found: &Densities<S>,
    memory: &mut Memory<S>,
) -> Masses<S> {
    let none = S::constant(0.0);
    let mut volumes = [(none, none); ComponentKind::COUNT];
    let mut measure = |kind: ComponentKind, profile: &Profile<S>| {
        let (volume_m3, moment_m4) = profile.volume_and_moment();
        let sum = &mut volumes[kind as usize];
        *sum = (sum.0 + volume_m3, sum.1 + moment_m4);
    };
    draw(input.concept, layout, &mut Draft::new(memory, &mut measure));
    let (mut parts_kg, mut sum_kg, mut moment) = ([none; ComponentKind::COUNT], none, none);
    for (kind, (volume_m3, volume_moment_m4)) in ComponentKind::ALL.into_iter().zip(volumes) {
        let mass_kg = density_kg_m3(kind, input, found, volume_m3) * volume_m3;
        let with_margin_kg = margin_factor(kind, input) * mass_kg;
        if volume_m3.value() > 0.0 {
            moment += with_margin_kg * (volume_moment_m4 / volume_m3);
        }
        sum_kg += with_margin_kg;
        parts_kg[kind as usize] = with_margin_kg;
    }
    let cg_x_m = if sum_kg.value() > 0.0 {
        moment / sum_kg
    } else {
        none
    };
    Masses {
        parts_kg,
        mass_kg: sum_kg,
        cg_x_m,
    }
}

/// Density of a component of a volume, m³; that of the mass that the user gives, where one is given.
fn density_kg_m3<S: Single>(
    kind: ComponentKind,
    input: &VehicleInput<S>,
    found: &Densities<S>,
    volume_m3: S,
) -> S {
    if let Some(mass_kg) = input.given_mass_kg(kind)
        && volume_m3.value() > 0.0
    {
        return mass_kg / volume_m3;
    }
    let (d, structure) = (&input.densities, found.structure);
    match kind {
        ComponentKind::ForebodyTps => input.forebody.tps_density_kg_m3,
        ComponentKind::Bond => input.forebody.bond_density_kg_m3,
        ComponentKind::ForebodyCarrier => structure.forebody.density_kg_m3,
        ComponentKind::AftbodyTps => input.aftbody_tps_density_kg_m3,
        ComponentKind::AftbodyCarrier => structure.aftbody.density_kg_m3,
        ComponentKind::PrimaryStructure => structure.primary.density_kg_m3,
        ComponentKind::WingInsulation => d.wing_insulation_kg_m3,
        ComponentKind::ImpactFoam => found.foam.density_kg_m3,
        ComponentKind::ImpactShell => d.impact_shell_kg_m3,
        ComponentKind::BodyFoam => d.body_foam_kg_m3,
        ComponentKind::LidInsulation => d.lid_insulation_kg_m3,
        ComponentKind::Payload => input.payload_density_kg_m3(),
    }
}

/// A component of this shape.
fn part<S: Single>(
    kind: ComponentKind,
    input: &VehicleInput<S>,
    found: &Densities<S>,
    solid: &SolidProperties<S>,
) -> Part<S> {
    let density_kg_m3 = density_kg_m3(kind, input, found, solid.volume_m3);
    let factor = margin_factor(kind, input);
    let (mass_kg, cg_x_m) = (density_kg_m3 * solid.volume_m3, solid.centroid_x_m());
    let about_apex = factor * density_kg_m3 * solid.transverse_second_moment_m5;
    Part {
        volume_m3: solid.volume_m3,
        density_kg_m3,
        mass_kg,
        mass_with_margin_kg: factor * mass_kg,
        cg_x_m,
        ixx_kg_m2: factor * density_kg_m3 * solid.axial_second_moment_m5,
        iyy_kg_m2: about_apex - factor * mass_kg * cg_x_m * cg_x_m,
    }
}

/// Every component, in the order of the kinds; empty where the concept does not have it.
pub fn parts<S: Single>(
    input: &VehicleInput<S>,
    layout: &Layout<S>,
    found: &Densities<S>,
) -> [(ComponentKind, Part<S>); ComponentKind::COUNT] {
    let mut solids = [SolidProperties::empty(); ComponentKind::COUNT];
    let mut measure = |kind: ComponentKind, profile: &Profile<S>| {
        let sum = &mut solids[kind as usize];
        *sum = sum.plus(profile.solid());
    };
    let mut memory = Memory::default();
    draw(
        input.concept,
        layout,
        &mut Draft::new(&mut memory, &mut measure),
    );
    ComponentKind::ALL.map(|kind| (kind, part(kind, input, found, &solids[kind as usize])))
}

/// Area swept by closed profiles, and by those of their segments that are part of the outer mold line, m².
fn areas_m2(profiles: &[Profile], outside: &Profile) -> [f64; 2] {
    let (mut all, mut wetted) = (0.0, 0.0);
    for segment in profiles.iter().flat_map(|profile| &profile.segments) {
        let area = segment.swept_area_m2();
        all += area;
        if outside.segments.contains(segment) {
            wetted += area;
        }
    }
    [all, wetted]
}

/// Every component with its mass.
pub fn components(input: &VehicleInput, layout: &Layout, found: &Densities) -> Vec<Component> {
    let foam_material = found_foam(input, found.foam);
    let outside = layout.outline.profile();
    profiles(input.concept, layout)
        .into_iter()
        .map(|(kind, profiles)| {
            let areas = areas_m2(&profiles, &outside);
            let material = input.materials.of(kind, &foam_material);
            let solids = profiles.iter().map(Profile::solid);
            let solid = solids.fold(SolidProperties::empty(), SolidProperties::plus);
            let part = part(kind, input, found, &solid);
            Component {
                kind,
                profiles,
                volume_m3: part.volume_m3,
                density_kg_m3: part.density_kg_m3,
                material: material.name.clone(),
                density_basis: match input.given_mass_kg(kind) {
                    Some(_) => DensityBasis::Given,
                    None => material.density_basis,
                },
                surface_area_m2: areas[0],
                wetted_area_m2: areas[1],
                mass_kg: part.mass_kg,
                mass_with_margin_kg: part.mass_with_margin_kg,
                cg_x_m: part.cg_x_m,
                ixx_kg_m2: part.ixx_kg_m2,
                iyy_kg_m2: part.iyy_kg_m2,
                solid,
            }
        })
        .collect()
}

/// Properties of a component that the sum over components needs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part<S = f64> {
    /// Volume, m³.
    pub volume_m3: S,
    /// Density, kg/m³.
    pub density_kg_m3: S,
    /// Mass without margin, kg.
    pub mass_kg: S,
    /// Mass with margin, kg.
    pub mass_with_margin_kg: S,
    /// Axial position of its center of gravity from the virtual apex, m.
    pub cg_x_m: S,
    /// Moment of inertia about the axis, with margin, kg m².
    pub ixx_kg_m2: S,
    /// Moment of inertia about a transverse axis through its own center of gravity, with margin, kg m².
    pub iyy_kg_m2: S,
}

impl Component {
    /// Kind and properties of the component that the sum over components needs.
    pub fn part(&self) -> (ComponentKind, Part) {
        let part = Part {
            volume_m3: self.volume_m3,
            density_kg_m3: self.density_kg_m3,
            mass_kg: self.mass_kg,
            mass_with_margin_kg: self.mass_with_margin_kg,
            cg_x_m: self.cg_x_m,
            ixx_kg_m2: self.ixx_kg_m2,
            iyy_kg_m2: self.iyy_kg_m2,
        };
        (self.kind, part)
    }
}

/// The sum of all components.
pub fn total<S: Single>(
    parts: impl Iterator<Item = (ComponentKind, Part<S>)>,
) -> MassProperties<S> {
    let none = S::constant(0.0);
    let [
        mut mass_kg,
        mut without_margin_kg,
        mut volume_m3,
        mut ixx_kg_m2,
    ] = [none; 4];
    let [mut moment, mut about_apex] = [none; 2];
    for (_, c) in parts {
        mass_kg += c.mass_with_margin_kg;
        without_margin_kg += c.mass_kg;
        volume_m3 += c.volume_m3;
        ixx_kg_m2 += c.ixx_kg_m2;
        moment += c.mass_with_margin_kg * c.cg_x_m;
        about_apex += c.iyy_kg_m2 + c.mass_with_margin_kg * c.cg_x_m * c.cg_x_m;
    }
    let cg_x_m = if mass_kg.value() > 0.0 {
        moment / mass_kg
    } else {
        none
    };
    let iyy_kg_m2 = about_apex - mass_kg * cg_x_m * cg_x_m;
    MassProperties {
        mass_kg,
        mass_without_margin_kg: without_margin_kg,
        cg_x_m,
        ixx_kg_m2,
        iyy_kg_m2,
        izz_kg_m2: iyy_kg_m2,
        volume_m3,
    }
}

/// Impact foam of a density: the grade, or the two between which it lies, and the panels in it.
fn found_foam(input: &VehicleInput, foam: Foam) -> Material {
    let panels_kg_m3 = match input.concept {
        Concept::Msr => input.densities.impact_panels_kg_m3,
        Concept::NonMsr => 0.0,
    };
    let density = foam.density_kg_m3 - panels_kg_m3;
    let below = input
        .foam_grades
        .iter()
        .rfind(|grade| grade.density_kg_m3 <= density);
    let above = input
        .foam_grades
        .iter()
        .find(|grade| grade.density_kg_m3 >= density);
    let grade = match (below, above) {
        (Some(one), Some(other)) if one == other => one.name.clone(),
        (Some(one), Some(other)) => format!("Foam between {} and {}", one.name, other.name),
        (Some(last), None) => format!("Foam beyond {}", last.name),
        (None, Some(first)) => format!("Foam below {}", first.name),
        (None, None) => "Foam".to_owned(),
    };
    if panels_kg_m3 > 0.0 {
        let name = format!("{grade}, with composite panels");
        Material::new(name, DensityBasis::DerivedFromAssumed)
    } else {
        Material::new(grade, DensityBasis::Published)
    }
}
