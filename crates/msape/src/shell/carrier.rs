//! The walls of a vehicle as a shell of revolution: position, masses on them, loads.
//!
//! ```text
//! p = p₀ sin² δ (1 + k₁ d)(1 + k₂ d)        pressure of the outer surface, on the middle surface at the depth d
//! a = ∫ p_x dA / M                          deceleration that balances it; every part is loaded by −a times its mass
//! ```
//!
//! with p₀ the peak stagnation pressure in Pa, δ the angle between surface and flow in rad, k the curvatures in 1/m, a in
//! m/s², M the entry mass in kg.
//!
//! Forebody carrier from nose to shoulder, an edge member across the shoulder, aftbody carrier over wing, annulus and lid,
//! and the primary structure from the forebody carrier to the foot of the lid, joined rigidly. Masses are those of the
//! mass tree with margin, spread evenly: heat shields on their carriers; payload, impact foam and shell and body foam,
//! which rest on the forebody carrier, on its part inside the primary structure; wing insulation on its part outside; lid
//! insulation on the lid. The edge member is a second forebody wall without mass.
//!
//! # Valid
//! Pressure at zero angle of attack; none on the aftbody, which is in the shadow of the flow. Fillings are mass only:
//! their stiffness is left out, which is conservative.
//!
//! # References
//! - \[samareh-2014\] sections 3.1.4 and 3.1.6, eq. 10. The distribution of the masses is a choice of this project.

use super::element::{ArealMass, GAUSS_3, station};
use super::mesh::{Meridian, Mesh, length_m};
use super::model::{Model, Wall};
use super::section::{Build, Section};
use crate::vehicle::profile::Profile;
use crate::vehicle::segment::Segment;
use crate::vehicle::structure::{Carrier, Construction};
use crate::vehicle::{ComponentKind, Vehicle, VehicleInput};
use numerics::math::PI;
use serde::{Deserialize, Serialize};

/// Parts of the carrier structure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Part {
    /// Forebody carrier structure inside the primary structure.
    Nose,
    /// Primary structure.
    Primary,
    /// Forebody carrier structure outside the primary structure.
    Cone,
    /// Edge member between both carriers at the shoulder.
    Edge,
    /// Aftbody carrier structure outside the lid.
    Wing,
    /// Aftbody carrier structure of the lid.
    Lid,
}

impl Part {
    /// All, in the order of the model's walls.
    pub const ALL: [Part; 6] = [
        Part::Nose,
        Part::Primary,
        Part::Cone,
        Part::Edge,
        Part::Wing,
        Part::Lid,
    ];

    /// Name in plain words.
    pub fn label(self) -> &'static str {
        match self {
            Self::Nose => "forebody carrier inside the primary structure",
            Self::Primary => "primary structure",
            Self::Cone => "forebody carrier outside the primary structure",
            Self::Edge => "edge member",
            Self::Wing => "aftbody carrier of the wing",
            Self::Lid => "aftbody carrier of the lid",
        }
    }
}

/// A vehicle's walls as a model.
#[derive(Clone, Debug, PartialEq)]
pub struct CarrierModel {
    /// The shell; its walls are those of [`Part::ALL`].
    pub model: Model,
    /// Material of each wall.
    pub carriers: [Carrier; 6],
    /// Node at the foot of the lid, where the attached structure is.
    pub foot: usize,
    /// Depth of the middle surface of the forebody carrier under the outer surface, m.
    pub depth_m: f64,
}

/// Longest element over √(ρ h) of its wall.
const FINENESS: f64 = 1.0;
/// Shortest and longest elements over the diameter.
const ELEMENT_OVER_DIAMETER: [f64; 2] = [0.015, 0.06];

/// A wall as built.
fn section(carrier: &Carrier, thickness_m: f64, face_thickness_m: f64) -> Section {
    let build = match carrier.construction {
        Construction::Solid { .. } => Build::Solid { thickness_m },
        Construction::Sandwich {
            core_shear_modulus_pa,
            ..
        } => Build::Sandwich {
            height_m: thickness_m.max(2.0 * face_thickness_m),
            face_thickness_m,
            core_shear_modulus_pa,
        },
    };
    Section {
        build,
        elastic_modulus_pa: carrier.elastic_modulus_pa,
        poisson_ratio: carrier.poisson_ratio,
    }
}

impl CarrierModel {
    /// The model of a vehicle, its elements `refinement` times finer than usual; `None` when a wall has no thickness or the
    /// meridians do not meet.
    pub fn new(input: &VehicleInput, vehicle: &Vehicle, refinement: f64) -> Option<Self> {
        let (layout, walls) = (&vehicle.layout, &vehicle.structure);
        let (outline, depths) = (&layout.outline, &layout.depths);
        let forebody = &outline.forebody;
        let fore_depth = depths.forebody_tps_m + depths.bond_m + depths.forebody_carrier_m / 2.0;
        let aft_depth = depths.aftbody_tps_m + depths.aftbody_carrier_m / 2.0;
        let joint_r = layout.primary_inner_r_m() + depths.primary_m / 2.0;
        let all = [
            (&input.forebody.carrier, &walls.forebody),
            (&input.primary_carrier, &walls.primary),
            (&input.forebody.carrier, &walls.forebody),
            (&input.forebody.carrier, &walls.forebody),
            (&input.aftbody_carrier, &walls.aftbody),
            (&input.aftbody_carrier, &walls.aftbody),
        ];
        if all.iter().any(|(_, wall)| wall.thickness_m <= 0.0) {
            return None;
        }
        let diameter = forebody.diameter_m;
        let [shortest, longest] = ELEMENT_OVER_DIAMETER.map(|part| part * diameter);
        let target = all.map(|(_, wall)| {
            // radius of curvature of the cone at the joint
            let rho = joint_r / forebody.sin_cos().1;
            (FINENESS * (rho * wall.thickness_m).sqrt()).clamp(shortest, longest) / refinement
        });
        let mut mesh = Mesh::default();
        let mut add = |part: Part, segments: &[Segment], first, last| {
            mesh.add(&Meridian {
                segments,
                wall: part as usize,
                target_m: target[part as usize],
                first,
                last,
            })
        };
        let path = Profile::default;
        let nose = forebody
            .between(path(), fore_depth, [0.0, joint_r])
            .segments;
        let cone = outline.fore_layer(path(), fore_depth, joint_r).segments;
        let wing = outline.aft_layer_to_foot(path(), aft_depth).segments;
        let lid = [outline.lid(aft_depth)];
        let [_, joint] = add(Part::Nose, &nose, None, None)?;
        let line = |start, end| Segment::Line { start, end };
        let primary = [line(nose.last()?.end(), lid.first()?.start())];
        let [_, foot] = add(Part::Primary, &primary, Some(joint), None)?;
        let [_, tip] = add(Part::Cone, &cone, Some(joint), None)?;
        let edge = [line(cone.last()?.end(), wing.first()?.start())];
        let root = add(Part::Edge, &edge, Some(tip), None).map_or(tip, |[_, end]| end);
        add(Part::Wing, &wing, Some(root), Some(foot))?;
        add(Part::Lid, &lid, Some(foot), None)?;
        let mut model = Model {
            mesh,
            walls: all
                .iter()
                .map(|(carrier, wall)| Wall {
                    section: section(carrier, wall.thickness_m, wall.face_thickness_m),
                    areal: ArealMass::default(),
                })
                .collect(),
        };
        let masses = masses(vehicle, &areas_m2(&model));
        for (wall, (mass_kg_m2, (_, built))) in
            model.walls.iter_mut().zip(masses.into_iter().zip(all))
        {
            let h = built.thickness_m;
            wall.areal = ArealMass {
                mass_kg_m2,
                rotary_kg: if mass_kg_m2 > 0.0 {
                    built.density_kg_m3 * h * h * h / 12.0
                } else {
                    0.0
                },
            };
        }
        Some(Self {
            model,
            carriers: all.map(|(carrier, _)| *carrier),
            foot,
            depth_m: fore_depth,
        })
    }

    /// The part to which an element belongs.
    pub fn part(&self, element: usize) -> Part {
        let wall = self.model.mesh.elements.get(element).map(|e| e.wall);
        wall.and_then(|wall| Part::ALL.get(wall).copied())
            .unwrap_or(Part::Nose)
    }

    /// Mass, kg.
    pub fn mass_kg(&self) -> f64 {
        let areas = areas_m2(&self.model);
        let of = |(wall, area): (&Wall, &f64)| wall.areal.mass_kg_m2 * area;
        self.model.walls.iter().zip(&areas).map(of).sum()
    }

    /// Longest element, m.
    pub fn longest_element_m(&self) -> f64 {
        let length = |points: [crate::vehicle::segment::Point; 3]| {
            let [start, _, end] = points;
            length_m(&Segment::Line { start, end })
        };
        let elements = self.model.mesh.elements.iter();
        elements
            .map(|element| length(self.model.mesh.points(element)))
            .fold(0.0, f64::max)
    }
}

/// Area of each wall, m².
fn areas_m2(model: &Model) -> [f64; 6] {
    let mut areas = [0.0; 6];
    for element in &model.mesh.elements {
        let points = model.mesh.points(element);
        for (xi, w) in GAUSS_3 {
            let at = station(&points, xi);
            if let Some(area) = areas.get_mut(element.wall) {
                *area += 2.0 * PI * w * at.scale_m * at.point.r_m;
            }
        }
    }
    areas
}

/// Mass per area of each wall with what lies on it, kg/m².
fn masses(vehicle: &Vehicle, areas: &[f64; 6]) -> [f64; 6] {
    let of = |kinds: &[ComponentKind]| -> f64 {
        let components = vehicle.components.iter();
        components
            .filter(|component| kinds.contains(&component.kind))
            .map(|component| component.mass_with_margin_kg)
            .sum()
    };
    let over = |mass: f64, area: f64| if area > 0.0 { mass / area } else { 0.0 };
    let [nose, primary, cone, _, wing, lid] = *areas;
    use ComponentKind::*;
    let fore = over(of(&[ForebodyTps, Bond, ForebodyCarrier]), nose + cone);
    let aft = over(of(&[AftbodyTps, AftbodyCarrier]), wing + lid);
    [
        fore + over(of(&[ImpactFoam, ImpactShell, BodyFoam, Payload]), nose),
        over(of(&[PrimaryStructure]), primary),
        fore + over(of(&[WingInsulation]), cone),
        0.0,
        aft,
        aft + over(of(&[LidInsulation]), lid),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer::sample::designed;
    use crate::shell::analysis::AnalysisLoads;
    use crate::vehicle::{Concept, PayloadSize, build};

    /// Spreads evenly over 0 to 1, another sequence for each `step`.
    fn spread(i: u32, step: f64) -> f64 {
        ((f64::from(i) + 0.5) * step).fract()
    }

    /// Vehicles over the trade space of the report, both concepts.
    fn vehicles(count: u32) -> impl Iterator<Item = (VehicleInput, Vehicle)> {
        let inputs = ["msr-eev-pica", "galahad"].map(|case| designed(case).0.vehicle);
        (0..count).filter_map(move |i| {
            let mut input = inputs[(i % 2) as usize].clone();
            let at = |step, low: f64, high: f64| low + (high - low) * spread(i, step);
            input.concept = [Concept::Msr, Concept::NonMsr][(i % 2) as usize];
            input.diameter_m = at(0.754_877_666, 0.5, 2.0);
            input.nose_radius_ratio = at(0.569_840_290, 0.25, 0.9);
            input.shoulder_radius_ratio = at(0.430_159_709, 0.02, 0.1);
            input.payload_mass_kg = at(0.324_717_957, 5.0, 30.0);
            input.payload_size = PayloadSize::DensityKgM3(at(0.245_122_333, 1000.0, 6000.0));
            input.forebody.tps_thickness_m = at(0.618_033_988, 0.005, 0.08);
            let vehicle = build(&input).ok()?;
            Some((input, vehicle))
        })
    }

    #[test]
    fn every_vehicle_that_closes_has_a_model_in_balance() {
        let mut count = 0;
        for (input, vehicle) in vehicles(120) {
            let model = CarrierModel::new(&input, &vehicle, 1.0).unwrap();
            assert!((model.mass_kg() / vehicle.mass.mass_kg - 1.0).abs() < 1e-12);
            let found = model.analyze(&AnalysisLoads {
                stagnation_pressure_pa: 1e5,
                deceleration_earth_g: 0.0,
                structure: input.structure_loads,
            });
            let found = found.unwrap();
            assert!(found.imbalance.abs() < 1e-12);
            assert_eq!(found.frequencies.len(), 5);
            for frequency in &found.frequencies {
                // a stiff vehicle of meters: tens to thousands of hertz
                assert!(
                    (5.0..5000.0).contains(&frequency.frequency_hz),
                    "{frequency:?}"
                );
            }
            // a pressure of 1 bar makes tens of MPa in a shell of a meter
            let peak = found
                .entry
                .parts
                .iter()
                .map(|p| p.stress_pa)
                .fold(0.0, f64::max);
            assert!((1e6..2e9).contains(&peak), "{peak}");
            assert!(model.longest_element_m() <= 0.0601 * vehicle.dimensions.diameter_m);
            assert_eq!(model.part(0), Part::Nose);
            count += 1;
        }
        assert!(count > 60, "{count}");
    }

    #[test]
    fn newtonian_pressure_on_the_middle_surface_has_the_force_of_the_outer_surface() {
        let (input, vehicle) = vehicles(1).next().unwrap();
        let model = CarrierModel::new(&input, &vehicle, 4.0).unwrap();
        let found = model.analyze(&AnalysisLoads {
            stagnation_pressure_pa: 1e5,
            deceleration_earth_g: 0.0,
            structure: input.structure_loads,
        });
        // ∫ p₀ sin² δ 2π r dr over nose and cone: sin² δ = 1 − (r/Rₙ)² on the nose, sin² θ on the cone
        let forebody = &vehicle.layout.outline.forebody;
        let (sin, _) = forebody.sin_cos();
        let (nose_r, cone_r) = (
            forebody.nose_tangent(0.0).r_m,
            forebody.shoulder_tangent(0.0).r_m,
        );
        let over = nose_r / forebody.nose_radius_m;
        let nose = PI * nose_r * nose_r * (1.0 - 0.5 * over * over);
        let cone = PI * (cone_r * cone_r - nose_r * nose_r) * sin * sin;
        let rim = PI * (forebody.diameter_m * forebody.diameter_m / 4.0 - cone_r * cone_r);
        let force = found.unwrap().pressure_force_n / 1e5;
        // the shoulder adds less than its area times sin² θ; the part of it that the carrier does not reach is missing
        assert!(
            force > (nose + cone) * 0.93 && force < nose + cone + rim,
            "{force} {nose} {cone} {rim}"
        );
    }
}
