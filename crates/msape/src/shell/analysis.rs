//! Stress, displacement and frequencies of a vehicle's carrier structure at entry and at launch.
//!
//! ```text
//! margin of safety = strength / (factor · stress) − 1
//! entry   pressure and the inertia that balances it, free in space; p₀ ← p₀ max(1, M a_flight / F(p₀))
//! launch  each corner (lateral, axial) of the load factors, held at the foot of the lid
//! ```
//!
//! with stress after von Mises in Pa, at the limit load; in the core of a sandwich the transverse shear stress. Where the
//! flight decelerates the mass M more than Newtonian pressure does, the pressure is raised to it. The foot of
//! the lid is where the attached structure holds the vehicle during launch; the frequencies are those of the vehicle
//! held there, as a launcher specifies them.
//!
//! # Valid
//! Same as [`super::carrier`].
//!
//! # References
//! - \[samareh-2014\] section 3.1.6; \[spacex-falcon-guide\] load factors; \[nasa-std-5001\] factors of safety.

use super::carrier::{CarrierModel, Part};
use super::element::{FREEDOMS, NODE_FREEDOMS, Station};
use super::mesh::Element;
use super::model::{Freedoms, Held};
use super::modes::{Frequency, first_frequency};
use super::section::Resultants;
use super::statics::{SAMPLES, Sample, Solution, load, solve};
use crate::vehicle::EARTH_G_M_S2;
use crate::vehicle::segment::Point;
use crate::vehicle::structure::{Construction, LaunchLoad, StructureLoads};
use numerics::math::PI;
use serde::{Deserialize, Serialize};

/// The largest stress of a part.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PartStress {
    /// Part.
    pub part: Part,
    /// Largest equivalent stress in laminate or faces, Pa.
    pub stress_pa: f64,
    /// Place of this stress.
    pub at: Point,
    /// Margin of safety against the strength of laminate or faces.
    pub margin: f64,
    /// Largest transverse shear stress, Pa.
    pub shear_pa: f64,
    /// Place of this stress.
    pub shear_at: Point,
    /// Margin of safety of the core of a sandwich.
    pub core_margin: Option<f64>,
}

/// A load case.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CaseStress {
    /// Stresses of the parts, without the edge member, which is a stand-in.
    pub parts: Vec<PartStress>,
    /// Largest displacement relative to the foot of the lid, m.
    pub largest_displacement_m: f64,
}

/// Values along the meridians, at entry unless the name contains `launch`; one for each Gauss point, in the order of the parts.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Distributions {
    /// Part.
    pub part: Vec<Part>,
    /// Axial position, m.
    pub x_m: Vec<f64>,
    /// Distance from the axis, m.
    pub r_m: Vec<f64>,
    /// Displacement along the axis relative to the foot of the lid, m.
    pub axial_displacement_m: Vec<f64>,
    /// Displacement away from the axis, m.
    pub radial_displacement_m: Vec<f64>,
    /// Equivalent stress, Pa.
    pub stress_pa: Vec<f64>,
    /// Transverse shear stress, Pa.
    pub shear_pa: Vec<f64>,
    /// Equivalent stress at launch, the largest of all corners and round the circle, Pa.
    pub launch_stress_pa: Vec<f64>,
    /// Displacement at launch, the largest of all corners and round the circle, m.
    pub launch_displacement_m: Vec<f64>,
}

/// Results of the shell model of a vehicle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CarrierAnalysis {
    /// Number of elements.
    pub elements: u32,
    /// Factor by which Newtonian pressure was raised to the deceleration of the flight.
    pub pressure_factor: f64,
    /// Force of the pressure along the axis, N.
    pub pressure_force_n: f64,
    /// Deceleration that balances the pressure force, Earth g.
    pub deceleration_earth_g: f64,
    /// Remaining force at the foot of the lid over the pressure force: zero within rounding.
    pub imbalance: f64,
    /// Entry.
    pub entry: CaseStress,
    /// Launch, the worst of its corners for each part.
    pub launch: CaseStress,
    /// First frequency of each number of waves round the axis.
    pub frequencies: Vec<Frequency>,
    /// Values along the meridians.
    pub distributions: Distributions,
}

impl CarrierAnalysis {
    /// The lowest frequency of all.
    pub fn first_frequency(&self) -> Option<Frequency> {
        let all = self.frequencies.iter().copied();
        all.reduce(|a, b| {
            if b.frequency_hz < a.frequency_hz {
                b
            } else {
                a
            }
        })
    }
}

/// Loads of the analysis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AnalysisLoads {
    /// Peak stagnation pressure, Pa.
    pub stagnation_pressure_pa: f64,
    /// Peak deceleration, Earth g.
    pub deceleration_earth_g: f64,
    /// Factor of safety and launch load factors.
    pub structure: StructureLoads,
}

/// Stress at a place.
#[derive(Clone, Copy, Debug)]
struct Stressed {
    part: Part,
    at: Point,
    stress_pa: f64,
    shear_pa: f64,
    moved_m: f64,
}

/// Sum of the axial forces of all elements.
fn axial(by_element: &[[f64; FREEDOMS]]) -> f64 {
    let of = |forces: &[f64; FREEDOMS]| forces.iter().step_by(NODE_FREEDOMS).sum::<f64>();
    by_element.iter().map(of).sum()
}

/// Columns over the Gauss points.
fn distributions(entry: &[Sample], stress: &[Stressed], launch: &[Stressed]) -> Distributions {
    let mut all = Distributions::default();
    let places = entry.iter().zip(stress.iter().zip(launch));
    for (place, (sample, (at_entry, at_launch))) in places.enumerate() {
        let inside = |xi: &f64| xi.abs() < 1.0;
        if !SAMPLES.get(place % SAMPLES.len()).is_some_and(inside) {
            continue;
        }
        let [axial_m, radial_m, _] = sample.displacement_m;
        all.part.push(at_entry.part);
        all.x_m.push(sample.point.x_m);
        all.r_m.push(sample.point.r_m);
        all.axial_displacement_m.push(axial_m);
        all.radial_displacement_m.push(radial_m);
        all.stress_pa.push(at_entry.stress_pa);
        all.shear_pa.push(at_entry.shear_pa);
        all.launch_stress_pa.push(at_launch.stress_pa);
        all.launch_displacement_m.push(at_launch.moved_m);
    }
    all
}

/// Largest number of waves round the axis.
const MOST_WAVES: u32 = 4;

/// Places round the circle at which launch loads are evaluated, as (cos θ, sin θ): both ends of the lateral load, and across.
const AROUND: [[f64; 2]; 3] = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]];

impl CarrierModel {
    /// Pressure of the flow on an element, as p_x, p_r, Pa.
    fn flow(&self, element: &Element, at: &Station, stagnation_pa: f64) -> [f64; 2] {
        let fore = [Part::Nose, Part::Cone].map(|part| part as usize);
        let [c, s] = at.direction;
        if !fore.contains(&element.wall) || s <= 0.0 {
            return [0.0; 2];
        }
        // p = p₀ sin² δ (1 + k₁ d)(1 + k₂ d), along −n = (s, −c)
        let d = self.depth_m;
        let spread =
            (1.0 + d * at.meridional_curvature_per_m) * (1.0 + d * at.hoop_curvature_per_m);
        let p = stagnation_pa * s * s * spread;
        [s * p, -c * p]
    }

    fn areal_mass_kg_m2(&self, element: &Element) -> f64 {
        self.model
            .wall(element)
            .map_or(0.0, |wall| wall.areal.mass_kg_m2)
    }

    /// Stress, displacement, frequencies; `None` when the model cannot be solved.
    pub fn analyze(&self, loads: &AnalysisLoads) -> Option<CarrierAnalysis> {
        let free = Freedoms::new(&self.model, 0, &[(self.foot, Held::Axially)]);
        let newtonian = load(&self.model, &free, |element, at| {
            let [p_x, _] = self.flow(element, at, loads.stagnation_pressure_pa);
            [p_x, 0.0, 0.0]
        });
        // Σ of the consistent forces is the whole force, per radian
        let newtonian_n = 2.0 * PI * axial(&newtonian.by_element);
        let mass_kg = self.mass_kg();
        let flown_n = mass_kg * loads.deceleration_earth_g * EARTH_G_M_S2;
        let pressure_factor = (flown_n / newtonian_n.max(f64::MIN_POSITIVE)).max(1.0);
        let stagnation_pa = pressure_factor * loads.stagnation_pressure_pa;
        let force_n = pressure_factor * newtonian_n;
        let acceleration_m_s2 = force_n / mass_kg;
        let entry_loads = load(&self.model, &free, |element, at| {
            let [p_x, p_r] = self.flow(element, at, stagnation_pa);
            [
                p_x - self.areal_mass_kg_m2(element) * acceleration_m_s2,
                p_r,
                0.0,
            ]
        });
        let imbalance = 2.0 * PI * axial(&entry_loads.by_element) / force_n.max(f64::MIN_POSITIVE);
        let stiffness = self.model.stiffness();
        let entry = solve(&free, &stiffness.over(&free).factor()?, entry_loads);

        let held = [(self.foot, Held::Clamped)];
        let mut frequencies = Vec::new();
        let mut launch: Vec<Solution> = Vec::new();
        for harmonic in 0..=MOST_WAVES {
            let freedoms = Freedoms::new(&self.model, harmonic, &held);
            let stiffness = stiffness.over(&freedoms).factor()?;
            frequencies.extend(first_frequency(&self.model, &freedoms, &stiffness));
            if harmonic <= 1 {
                let unit = load(&self.model, &freedoms, |element, _| {
                    let weight = self.areal_mass_kg_m2(element) * EARTH_G_M_S2;
                    match harmonic {
                        0 => [-weight, 0.0, 0.0],
                        _ => [0.0, weight, -weight],
                    }
                });
                launch.push(solve(&freedoms, &stiffness, unit));
            }
        }
        let [axial_g, lateral_g] = launch.as_slice() else {
            return None;
        };
        let entry = entry.samples(&self.model);
        let launch = self.launch(
            &loads.structure.launch,
            [
                &axial_g.samples(&self.model),
                &lateral_g.samples(&self.model),
            ],
        );
        let factor = loads.structure.safety_factor;
        let entry_stress: Vec<Stressed> =
            entry.iter().map(|sample| self.stressed(sample)).collect();
        Some(CarrierAnalysis {
            elements: self.model.mesh.elements.len() as u32,
            pressure_factor,
            pressure_force_n: force_n,
            deceleration_earth_g: acceleration_m_s2 / EARTH_G_M_S2,
            imbalance,
            distributions: distributions(&entry, &entry_stress, &launch),
            entry: self.case(&entry_stress, factor),
            launch: self.case(&launch, factor),
            frequencies,
        })
    }

    fn stress(&self, sample: &Sample, forces: &Resultants, moved_m: f64) -> Stressed {
        let part = self.part(sample.element);
        let wall = self.model.walls.get(part as usize);
        let stress = wall
            .map(|wall| wall.section.stress(forces))
            .unwrap_or_default();
        Stressed {
            part,
            at: sample.point,
            stress_pa: stress.equivalent_pa,
            shear_pa: stress.transverse_shear_pa,
            moved_m,
        }
    }

    fn stressed(&self, sample: &Sample) -> Stressed {
        let [x, r, _] = sample.displacement_m;
        self.stress(sample, &sample.forces, (x * x + r * r).sqrt())
    }

    /// The worst of all corners at each place.
    fn launch(&self, corners: &[LaunchLoad], [axial, lateral]: [&[Sample]; 2]) -> Vec<Stressed> {
        let both = axial.iter().zip(lateral);
        both.map(|(a, l)| {
            let mut worst = self.stress(a, &Resultants::default(), 0.0);
            for corner in corners {
                let (g_a, g_l) = (corner.axial_earth_g, corner.lateral_earth_g);
                for [cos, sin] in AROUND {
                    let forces = Resultants::at_angle([
                        (&a.forces, [g_a, 0.0]),
                        (&l.forces, [g_l * cos, g_l * sin]),
                    ]);
                    let [x, r, v] = [cos, cos, sin].map(|f| g_l * f);
                    let [a_x, a_r, _] = a.displacement_m;
                    let [l_x, l_r, l_v] = l.displacement_m;
                    let (x, r, v) = (g_a * a_x + x * l_x, g_a * a_r + r * l_r, v * l_v);
                    let here = self.stress(a, &forces, (x * x + r * r + v * v).sqrt());
                    worst.stress_pa = worst.stress_pa.max(here.stress_pa);
                    worst.shear_pa = worst.shear_pa.max(here.shear_pa);
                    worst.moved_m = worst.moved_m.max(here.moved_m);
                }
            }
            worst
        })
        .collect()
    }

    fn case(&self, places: &[Stressed], factor: f64) -> CaseStress {
        let walls = Part::ALL.into_iter().zip(&self.carriers);
        let parts = walls
            .filter(|(part, _)| *part != Part::Edge)
            .map(|(part, carrier)| {
                let here = || places.iter().filter(|place| place.part == part);
                let most = |value: fn(&Stressed) -> f64| {
                    here().fold((0.0, Point::default()), |(most, at), place| {
                        match value(place) {
                            v if v > most => (v, place.at),
                            _ => (most, at),
                        }
                    })
                };
                let (stress_pa, at) = most(|place| place.stress_pa);
                let (shear_pa, shear_at) = most(|place| place.shear_pa);
                let margin =
                    |strength: f64, stress: f64| strength / (factor * stress).max(1.0) - 1.0;
                PartStress {
                    part,
                    stress_pa,
                    at,
                    margin: margin(carrier.strength_pa, stress_pa),
                    shear_pa,
                    shear_at,
                    core_margin: match carrier.construction {
                        Construction::Solid { .. } => None,
                        Construction::Sandwich {
                            core_shear_strength_pa,
                            ..
                        } => Some(margin(core_shear_strength_pa, shear_pa)),
                    },
                }
            });
        CaseStress {
            parts: parts.collect(),
            largest_displacement_m: places.iter().map(|place| place.moved_m).fold(0.0, f64::max),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer::sample::designed;
    use crate::vehicle::{Loads, VehicleInput};

    /// The shipped MSR vehicle, its elements so much finer, its materials so much stiffer.
    fn msr(refinement: f64, stiffer: f64) -> (CarrierModel, AnalysisLoads, f64) {
        let (input, design, flight) = designed("msr-eev-pica");
        let mut input: VehicleInput = input.vehicle;
        input.loads = Loads {
            entry_load_earth_g: flight.peak_deceleration_earth_g.value,
            ..input.loads
        };
        for carrier in [
            &mut input.forebody.carrier,
            &mut input.aftbody_carrier,
            &mut input.primary_carrier,
        ] {
            carrier.elastic_modulus_pa *= stiffer;
            if let Construction::Sandwich {
                core_shear_modulus_pa,
                ..
            } = &mut carrier.construction
            {
                *core_shear_modulus_pa *= stiffer;
            }
        }
        let loads = AnalysisLoads {
            stagnation_pressure_pa: flight.peak_stagnation_pressure_pa.value,
            deceleration_earth_g: flight.peak_deceleration_earth_g.value,
            structure: input.structure_loads,
        };
        let model = CarrierModel::new(&input, &design.vehicle, refinement).unwrap();
        (model, loads, design.vehicle.mass.mass_kg)
    }

    #[test]
    fn model_weighs_what_the_vehicle_weighs_and_its_loads_are_in_balance() {
        let (model, loads, mass_kg) = msr(1.0, 1.0);
        assert!((model.mass_kg() / mass_kg - 1.0).abs() < 1e-12);
        let found = model.analyze(&loads).unwrap();
        assert!(found.imbalance.abs() < 1e-12, "{}", found.imbalance);
        let force = mass_kg * found.deceleration_earth_g * EARTH_G_M_S2;
        assert!((found.pressure_force_n / force - 1.0).abs() < 1e-12);
        assert!(found.deceleration_earth_g >= loads.deceleration_earth_g * (1.0 - 1e-12));
    }

    #[test]
    fn four_times_finer_elements_change_little() {
        let [usual, fine] = [1.0, 4.0].map(|refinement| {
            let (model, loads, _) = msr(refinement, 1.0);
            model.analyze(&loads).unwrap()
        });
        assert!(fine.elements > 3 * usual.elements);
        for (a, b) in usual.frequencies.iter().zip(&fine.frequencies) {
            let off = a.frequency_hz / b.frequency_hz - 1.0;
            assert!(off.abs() < 5e-3, "n = {}: {off:+.1e}", a.harmonic);
        }
        let cases = |found: &CarrierAnalysis| [found.entry.clone(), found.launch.clone()];
        for (a, b) in cases(&usual).iter().zip(&cases(&fine)) {
            for (a, b) in a.parts.iter().zip(&b.parts) {
                let off = a.stress_pa / b.stress_pa - 1.0;
                // peaks are where walls meet, at the ends of elements
                assert!(off.abs() < 0.03, "{:?}: {off:+.1e}", b.part);
            }
            let off = a.largest_displacement_m / b.largest_displacement_m - 1.0;
            assert!(off.abs() < 5e-3, "{off}");
        }
    }

    #[test]
    fn four_times_stiffer_walls_vibrate_twice_as_fast_and_move_a_quarter() {
        let [soft, stiff] = [1.0, 4.0].map(|stiffer| {
            let (model, loads, _) = msr(1.0, stiffer);
            model.analyze(&loads).unwrap()
        });
        for (a, b) in soft.frequencies.iter().zip(&stiff.frequencies) {
            assert!((b.frequency_hz / a.frequency_hz / 2.0 - 1.0).abs() < 1e-6);
        }
        let ratio = soft.entry.largest_displacement_m / stiff.entry.largest_displacement_m;
        assert!((ratio / 4.0 - 1.0).abs() < 1e-6, "{ratio}");
        let stress = |found: &CarrierAnalysis| found.entry.parts[2].stress_pa;
        assert!((stress(&soft) / stress(&stiff) - 1.0).abs() < 1e-6);
    }

    #[test]
    fn half_of_the_loads_make_half_of_the_stress() {
        let (model, loads, _) = msr(1.0, 1.0);
        let half = AnalysisLoads {
            stagnation_pressure_pa: 0.5 * loads.stagnation_pressure_pa,
            deceleration_earth_g: 0.5 * loads.deceleration_earth_g,
            ..loads
        };
        let [whole, half] = [loads, half].map(|loads| model.analyze(&loads).unwrap());
        for (a, b) in whole.entry.parts.iter().zip(&half.entry.parts) {
            assert!((a.stress_pa / b.stress_pa / 2.0 - 1.0).abs() < 1e-9);
            // strength / (1.4 stress) − 1
            assert!(((b.margin + 1.0) / (a.margin + 1.0) / 2.0 - 1.0).abs() < 1e-9);
        }
        assert_eq!(whole.launch, half.launch);
    }
}
