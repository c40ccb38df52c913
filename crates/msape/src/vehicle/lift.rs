//! The inputs of a vehicle as numbers of another kind: with derivatives, or without.
//!
//! Inputs of the case are lifted; data of foams, grounds and rules remain plain numbers.

use crate::vehicle::input::{ImpactInput, LayerStack, Loads, PayloadSize, VehicleInput};
use crate::vehicle::kinds::ComponentDensities;
use crate::vehicle::structure::{Carrier, Construction, LaunchLoad, StructureLoads};
use numerics::scalar::Single;

impl<S: Single> VehicleInput<S> {
    /// The inputs with `f` applied to each continuous one, in a fixed order.
    pub fn lift<T: Single>(&self, mut f: impl FnMut(S) -> T) -> VehicleInput<T> {
        let f: &mut dyn FnMut(S) -> T = &mut f;
        VehicleInput {
            concept: self.concept,
            diameter_m: f(self.diameter_m),
            nose_radius_ratio: f(self.nose_radius_ratio),
            shoulder_radius_ratio: f(self.shoulder_radius_ratio),
            cone_half_angle_rad: f(self.cone_half_angle_rad),
            payload_mass_kg: f(self.payload_mass_kg),
            payload_size: match self.payload_size {
                PayloadSize::DensityKgM3(density) => PayloadSize::DensityKgM3(f(density)),
                PayloadSize::DiameterM(diameter) => PayloadSize::DiameterM(f(diameter)),
                PayloadSize::DiameterRatio(ratio) => PayloadSize::DiameterRatio(f(ratio)),
            },
            mass_margin: f(self.mass_margin),
            forebody: LayerStack {
                tps_thickness_m: f(self.forebody.tps_thickness_m),
                tps_density_kg_m3: f(self.forebody.tps_density_kg_m3),
                bond_thickness_m: f(self.forebody.bond_thickness_m),
                bond_density_kg_m3: f(self.forebody.bond_density_kg_m3),
                carrier_thickness_m: self.forebody.carrier_thickness_m.map(&mut *f),
                carrier: carrier(&self.forebody.carrier, f),
            },
            aftbody_tps_thickness_m: f(self.aftbody_tps_thickness_m),
            aftbody_tps_density_kg_m3: f(self.aftbody_tps_density_kg_m3),
            aftbody_carrier: carrier(&self.aftbody_carrier, f),
            primary_carrier: carrier(&self.primary_carrier, f),
            densities: ComponentDensities {
                impact_foam_kg_m3: self.densities.impact_foam_kg_m3.map(&mut *f),
                impact_panels_kg_m3: f(self.densities.impact_panels_kg_m3),
                impact_shell_kg_m3: f(self.densities.impact_shell_kg_m3),
                body_foam_kg_m3: f(self.densities.body_foam_kg_m3),
                lid_insulation_kg_m3: f(self.densities.lid_insulation_kg_m3),
                wing_insulation_kg_m3: f(self.densities.wing_insulation_kg_m3),
            },
            given_masses: (self.given_masses.iter())
                .map(|(kind, mass_kg)| (*kind, f(*mass_kg)))
                .collect(),
            materials: self.materials.clone(),
            loads: Loads {
                entry_load_earth_g: f(self.loads.entry_load_earth_g),
                peak_stagnation_pressure_pa: f(self.loads.peak_stagnation_pressure_pa),
                terminal_speed_m_s: f(self.loads.terminal_speed_m_s),
            },
            structure_loads: StructureLoads {
                safety_factor: f(self.structure_loads.safety_factor),
                launch: self.structure_loads.launch.map(|corner| LaunchLoad {
                    lateral_earth_g: f(corner.lateral_earth_g),
                    axial_earth_g: f(corner.axial_earth_g),
                }),
                aftbody_pressure_fraction: f(self.structure_loads.aftbody_pressure_fraction),
            },
            impact: ImpactInput {
                crush_load_limit_earth_g: f(self.impact.crush_load_limit_earth_g),
                stroke_efficiency: self.impact.stroke_efficiency.map(&mut *f),
                ground: self.impact.ground.clone(),
                foam_strength: self.impact.foam_strength,
                foam: self.impact.foam.clone(),
                crushing_mass: self.impact.crushing_mass,
            },
            foam_grades: self.foam_grades.clone(),
            rules: self.rules,
        }
    }
}

fn carrier<S: Single, T>(of: &Carrier<S>, f: &mut dyn FnMut(S) -> T) -> Carrier<T> {
    Carrier {
        construction: match of.construction {
            Construction::Solid { density_kg_m3 } => Construction::Solid {
                density_kg_m3: f(density_kg_m3),
            },
            Construction::Sandwich {
                face_thickness_m,
                face_density_kg_m3,
                core_density_kg_m3,
                core_elastic_modulus_pa,
                core_shear_modulus_pa,
                core_shear_strength_pa,
                cell_size_m,
            } => Construction::Sandwich {
                face_thickness_m: f(face_thickness_m),
                face_density_kg_m3: f(face_density_kg_m3),
                core_density_kg_m3: f(core_density_kg_m3),
                core_elastic_modulus_pa: f(core_elastic_modulus_pa),
                core_shear_modulus_pa: f(core_shear_modulus_pa),
                core_shear_strength_pa: f(core_shear_strength_pa),
                cell_size_m: f(cell_size_m),
            },
        },
        elastic_modulus_pa: f(of.elastic_modulus_pa),
        poisson_ratio: f(of.poisson_ratio),
        strength_pa: f(of.strength_pa),
        minimum_gauge_m: f(of.minimum_gauge_m),
    }
}
