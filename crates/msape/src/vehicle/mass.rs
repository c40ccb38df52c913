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
//! Homogeneous components; centre of gravity on the axis.
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
use crate::vehicle::segment::{Point, Segment};
use crate::vehicle::structure::Structure;
use crate::vehicle::{msr, non_msr};
use numerics::math::PI;
use serde::{Deserialize, Serialize};

/// One part: closed profiles, density, mass.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Component {
    /// Which part.
    pub kind: ComponentKind,
    /// Its closed profiles (the body foam may be in two pieces).
    pub profiles: Vec<Profile>,
    /// Volume, m³.
    pub volume_m3: f64,
    /// Density, kg/m³.
    pub density_kg_m3: f64,
    /// Name of its material.
    pub material: String,
    /// Where its density comes from.
    pub density_basis: DensityBasis,
    /// Area of its closed surface, m².
    pub surface_area_m2: f64,
    /// Area of the part of it that the outer air touches, m².
    pub wetted_area_m2: f64,
    /// Mass without margin, kg.
    pub mass_kg: f64,
    /// Mass with margin, kg.
    pub mass_with_margin_kg: f64,
    /// Axial position of its centre of gravity from the virtual apex, m.
    pub cg_x_m: f64,
    /// Moment of inertia about the axis, with margin, kg m².
    pub ixx_kg_m2: f64,
    /// Moment of inertia about a transverse axis through its own centre of gravity, with margin, kg m².
    pub iyy_kg_m2: f64,
    /// Volume and moments.
    pub solid: SolidProperties,
}

/// Mass, centre of gravity and inertia of the whole, margin included.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct MassProperties {
    /// Mass, kg.
    pub mass_kg: f64,
    /// Mass without any margin, kg.
    pub mass_without_margin_kg: f64,
    /// Axial position of the centre of gravity from the virtual apex, m.
    pub cg_x_m: f64,
    /// Moment of inertia about the axis, kg m².
    pub ixx_kg_m2: f64,
    /// Moment of inertia about a transverse axis through the centre of gravity, kg m².
    pub iyy_kg_m2: f64,
    /// The same about the other transverse axis, kg m².
    pub izz_kg_m2: f64,
    /// Volume of all components, m³.
    pub volume_m3: f64,
}

/// Draws every component, in the order in which they are summed.
fn draw(concept: Concept, layout: &Layout, draft: &mut Draft) {
    let (d, outline) = (&layout.depths, &layout.outline);
    draft.layers(
        [
            ComponentKind::ForebodyTps,
            ComponentKind::Bond,
            ComponentKind::ForebodyCarrier,
        ],
        [d.forebody_tps_m, d.forebody_tps_m + d.bond_m, d.fore_m()],
        |path, depth_m| outline.fore_layer(path, depth_m, 0.0),
    );
    draft.layers(
        [ComponentKind::AftbodyTps, ComponentKind::AftbodyCarrier],
        [d.aftbody_tps_m, d.aft_m()],
        |path, depth_m| outline.aft_layer(path, depth_m),
    );
    draft.part(ComponentKind::PrimaryStructure, |path| {
        if d.primary_m > 0.0 {
            primary(path, layout)
        } else {
            path
        }
    });
    draft.part(ComponentKind::WingInsulation, |path| wing(path, layout));
    match concept {
        Concept::Msr => msr::filling(layout, draft),
        Concept::NonMsr => non_msr::filling(layout, draft),
    }
    draft.part(ComponentKind::Payload, |path| {
        let center = Point::on_axis(layout.payload_x_m);
        path.and(Segment::arc(center, layout.payload_radius_m, PI, -PI))
    });
}

/// The profiles of every component, in the order in which they are summed.
pub fn profiles(concept: Concept, layout: &Layout) -> Vec<(ComponentKind, Vec<Profile>)> {
    let mut all: Vec<(ComponentKind, Vec<Profile>)> = Vec::with_capacity(ComponentKind::COUNT);
    let mut keep = |kind, profile: &Profile| {
        if all.last().is_none_or(|(last, _)| *last != kind) {
            all.push((kind, Vec::new()));
        }
        if let Some((_, profiles)) = all.last_mut()
            && !profile.segments.is_empty()
        {
            profiles.push(profile.clone());
        }
    };
    let mut memory = Memory::default();
    draw(concept, layout, &mut Draft::new(&mut memory, &mut keep));
    all
}

fn primary(path: Profile, layout: &Layout) -> Profile {
    let (inner, outer) = (layout.primary_inner_r_m(), layout.primary_outer_r_m());
    let x_m = layout.outline.attached_structure_x_m - layout.depths.aft_m();
    let forebody = &layout.outline.forebody;
    let foot = forebody.between(path, layout.depths.fore_m(), [inner, outer]);
    foot.line_to(Point { x_m, r_m: outer })
        .line_to(Point { x_m, r_m: inner })
}

fn wing(path: Profile, layout: &Layout) -> Profile {
    let (fore, aft) = (layout.depths.fore_m(), layout.depths.aft_m());
    let outline = &layout.outline;
    let wall_r = layout.primary_outer_r_m();
    let x_m = outline.attached_structure_x_m - aft;
    outline
        .fore_layer(path, fore, wall_r)
        .line_to(outline.on_tip_line(outline.forebody.shoulder_radius_m - aft))
        .line_to(Point {
            x_m,
            r_m: outline.annulus_outer_r_m(aft),
        })
        .line_to(Point { x_m, r_m: wall_r })
}

/// Densities that are found and not given.
#[derive(Clone, Copy, Debug)]
pub struct Densities<'a> {
    /// Walls.
    pub structure: &'a Structure,
    /// Impact foam.
    pub foam: Foam,
}

/// Mass and centre of gravity alone, margin included.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Masses {
    /// Each component, with margin, kg: zero where the concept does not have it.
    parts_kg: [f64; ComponentKind::COUNT],
    /// Their sum, kg.
    pub mass_kg: f64,
    /// Axial position of the centre of gravity from the virtual apex, m.
    pub cg_x_m: f64,
}

impl Masses {
    /// Those of components and of their sum.
    pub fn of(components: &[Component], mass: &MassProperties) -> Self {
        let mut all = Self {
            mass_kg: mass.mass_kg,
            cg_x_m: mass.cg_x_m,
            ..Self::default()
        };
        for component in components {
            all.parts_kg[component.kind as usize] = component.mass_with_margin_kg;
        }
        all
    }

    /// Sum over the components of some kinds, with margin, kg.
    pub fn sum_kg(&self, of: impl Fn(ComponentKind) -> bool) -> f64 {
        let those = ComponentKind::ALL.iter().filter(|kind| of(**kind));
        those.map(|kind| self.parts_kg[*kind as usize]).sum()
    }
}

/// The factor of the margin on a component.
fn margin_factor(kind: ComponentKind, input: &VehicleInput) -> f64 {
    match kind {
        ComponentKind::Payload => 1.0,
        _ => 1.0 + input.mass_margin,
    }
}

/// What the closing loop reads of [`components`] and [`total`], with the same bits.
pub fn masses(
    input: &VehicleInput,
    layout: &Layout,
    found: &Densities,
    memory: &mut Memory,
) -> Masses {
    let mut volumes = [(0.0, 0.0); ComponentKind::COUNT];
    let mut measure = |kind: ComponentKind, profile: &Profile| {
        let (volume_m3, moment_m4) = profile.volume_and_moment();
        let sum = &mut volumes[kind as usize];
        *sum = (sum.0 + volume_m3, sum.1 + moment_m4);
    };
    draw(input.concept, layout, &mut Draft::new(memory, &mut measure));
    let mut all = Masses::default();
    let mut moment = 0.0;
    for (kind, (volume_m3, volume_moment_m4)) in ComponentKind::ALL.into_iter().zip(volumes) {
        let mass_kg = density_kg_m3(kind, input, found, volume_m3) * volume_m3;
        let with_margin_kg = margin_factor(kind, input) * mass_kg;
        if volume_m3 > 0.0 {
            moment += with_margin_kg * (volume_moment_m4 / volume_m3);
        }
        all.mass_kg += with_margin_kg;
        all.parts_kg[kind as usize] = with_margin_kg;
    }
    if all.mass_kg > 0.0 {
        all.cg_x_m = moment / all.mass_kg;
    }
    all
}

/// Density of a component of a volume, m³; that of the mass that the user gives, where one is given.
fn density_kg_m3(
    kind: ComponentKind,
    input: &VehicleInput,
    found: &Densities,
    volume_m3: f64,
) -> f64 {
    if let Some(mass_kg) = input.given_mass_kg(kind)
        && volume_m3 > 0.0
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
        ComponentKind::Payload => {
            let diameter = input.payload_diameter_m();
            input.payload_mass_kg / (PI / 6.0 * diameter * diameter * diameter)
        }
    }
}

/// Area swept by closed profiles, and by those of their segments that are part of the outer mould line, m².
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
            let solid = profiles
                .iter()
                .fold(SolidProperties::default(), |sum, p| sum.plus(p.solid()));
            let density = density_kg_m3(kind, input, found, solid.volume_m3);
            let factor = margin_factor(kind, input);
            let (mass_kg, cg_x_m) = (density * solid.volume_m3, solid.centroid_x_m());
            let about_apex = factor * density * solid.transverse_second_moment_m5;
            Component {
                kind,
                profiles,
                volume_m3: solid.volume_m3,
                density_kg_m3: density,
                material: material.name.clone(),
                density_basis: match input.given_mass_kg(kind) {
                    Some(_) => DensityBasis::Given,
                    None => material.density_basis,
                },
                surface_area_m2: areas[0],
                wetted_area_m2: areas[1],
                mass_kg,
                mass_with_margin_kg: factor * mass_kg,
                cg_x_m,
                ixx_kg_m2: factor * density * solid.axial_second_moment_m5,
                iyy_kg_m2: about_apex - factor * mass_kg * cg_x_m * cg_x_m,
                solid,
            }
        })
        .collect()
}

/// What the sum reads of a component.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// Volume, m³.
    pub volume_m3: f64,
    /// Mass without margin, kg.
    pub mass_kg: f64,
    /// Mass with margin, kg.
    pub mass_with_margin_kg: f64,
    /// Axial position of its centre of gravity from the virtual apex, m.
    pub cg_x_m: f64,
    /// Moment of inertia about the axis, with margin, kg m².
    pub ixx_kg_m2: f64,
    /// Moment of inertia about a transverse axis through its own centre of gravity, with margin, kg m².
    pub iyy_kg_m2: f64,
}

impl Component {
    /// What the sum reads of it.
    pub fn part(&self) -> Part {
        Part {
            volume_m3: self.volume_m3,
            mass_kg: self.mass_kg,
            mass_with_margin_kg: self.mass_with_margin_kg,
            cg_x_m: self.cg_x_m,
            ixx_kg_m2: self.ixx_kg_m2,
            iyy_kg_m2: self.iyy_kg_m2,
        }
    }
}

/// The sum of all components.
pub fn total(parts: impl Iterator<Item = Part>) -> MassProperties {
    let mut sum = MassProperties::default();
    let mut moment = 0.0;
    let mut about_apex = 0.0;
    for c in parts {
        sum.mass_kg += c.mass_with_margin_kg;
        sum.mass_without_margin_kg += c.mass_kg;
        sum.volume_m3 += c.volume_m3;
        sum.ixx_kg_m2 += c.ixx_kg_m2;
        moment += c.mass_with_margin_kg * c.cg_x_m;
        about_apex += c.iyy_kg_m2 + c.mass_with_margin_kg * c.cg_x_m * c.cg_x_m;
    }
    if sum.mass_kg > 0.0 {
        sum.cg_x_m = moment / sum.mass_kg;
    }
    sum.iyy_kg_m2 = about_apex - sum.mass_kg * sum.cg_x_m * sum.cg_x_m;
    sum.izz_kg_m2 = sum.iyy_kg_m2;
    sum
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
