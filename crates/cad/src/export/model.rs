//! The exported model: parts with name, material and color, whatever their origin.

use msape::vehicle::ComponentKind;
use msape::vehicle::body::RigidBody;
use msape::vehicle::profile::Profile;
use msape::vehicle::{DensityBasis, Vehicle};
use serde::{Deserialize, Serialize};

/// One or more bodies of revolution in one frame: x along the axis, aft positive.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Model {
    /// Name of the case.
    pub name: String,
    /// Parts, in order.
    pub parts: Vec<Part>,
    /// Outer mold line, closed.
    pub outline: Profile,
    /// Dimensions shown in a drawing.
    pub measures: Measures,
}

/// Part: closed profiles of one material.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Part {
    /// Name for files and layers: lower-case letters, digits and hyphens.
    pub key: String,
    /// Display name.
    pub name: String,
    /// Material, where known.
    pub substance: Option<Substance>,
    /// Red, green, blue.
    pub color: [u8; 3],
    /// Closed profiles, each a separate body.
    pub profiles: Vec<Profile>,
}

/// Material of a part.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Substance {
    /// Name of the material.
    pub material: String,
    /// Density, kg/m³.
    pub density_kg_m3: f64,
    /// Origin of the density.
    pub basis: DensityBasis,
}

/// Dimensions for a drawing; `None` where the model has none.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Measures {
    /// Nose radius, m.
    pub nose_radius_m: Option<f64>,
    /// Shoulder radius, m.
    pub shoulder_radius_m: Option<f64>,
    /// Cone half-angle, rad.
    pub cone_half_angle_rad: Option<f64>,
    /// Lid radius, m.
    pub lid_radius_m: Option<f64>,
    /// Slope of the wing's aft side against the plane normal to the axis, rad.
    pub wing_slope_rad: Option<f64>,
    /// Axial position of the center of gravity, m.
    pub cg_x_m: Option<f64>,
    /// Mass, kg.
    pub mass_kg: Option<f64>,
}

impl Model {
    /// A designed vehicle: one part for each component that has a body.
    pub fn of_vehicle(name: &str, vehicle: &Vehicle) -> Self {
        let with_body = vehicle.components.iter().filter(|c| !c.profiles.is_empty());
        let parts = with_body.map(|c| Part {
            key: key(c.kind.label()),
            name: c.kind.label().to_owned(),
            substance: Some(Substance {
                material: c.material.clone(),
                density_kg_m3: c.density_kg_m3,
                basis: c.density_basis,
            }),
            color: color(c.kind),
            profiles: c.profiles.clone(),
        });
        let d = &vehicle.dimensions;
        Self {
            name: named(name),
            parts: parts.collect(),
            outline: vehicle.outline.clone(),
            measures: Measures {
                nose_radius_m: Some(d.nose_radius_m),
                shoulder_radius_m: Some(d.shoulder_radius_m),
                cone_half_angle_rad: Some(vehicle.layout.outline.forebody.cone_half_angle_rad),
                lid_radius_m: Some(d.lid_radius_m),
                wing_slope_rad: Some(d.wing_slope_rad),
                cg_x_m: Some(vehicle.mass.cg_x_m),
                mass_kg: Some(vehicle.mass.mass_kg),
            },
        }
    }

    /// A rigid body as a single part.
    pub fn of_body(name: &str, body: &RigidBody) -> Self {
        let name = if name.trim().is_empty() {
            &body.name
        } else {
            name
        };
        let measures = Measures {
            nose_radius_m: body.nose_radius_m,
            cone_half_angle_rad: body.cone_half_angle_rad,
            ..Measures::default()
        };
        Self::of_outline(name, &body.outline, measures)
    }

    /// One closed outline as a single part.
    pub fn of_outline(name: &str, outline: &Profile, measures: Measures) -> Self {
        Self {
            name: named(name),
            parts: vec![Part {
                key: "body".to_owned(),
                name: "Body".to_owned(),
                substance: None,
                color: [0x8c, 0x4a, 0x2f],
                profiles: vec![outline.clone()],
            }],
            outline: outline.clone(),
            measures,
        }
    }
}

impl Model {
    /// Least and largest axial position, and largest distance from the axis, m.
    pub fn extent_m(&self) -> [f64; 3] {
        let [nose, aft, _, widest] = self.outline.bounds_m();
        [nose, aft, widest]
    }
}

fn named(name: &str) -> String {
    match name.trim() {
        "" => "vehicle".to_owned(),
        name => name.to_owned(),
    }
}

/// A name reduced to lower-case letters, digits and hyphens.
fn key(name: &str) -> String {
    let plain = |c: char| {
        if c.is_ascii_alphanumeric() {
            c.to_ascii_lowercase()
        } else {
            '-'
        }
    };
    name.chars().map(plain).collect()
}

/// Red, green, blue of a component; adjacent components differ in lightness, too.
pub fn color(kind: ComponentKind) -> [u8; 3] {
    match kind {
        ComponentKind::ForebodyTps => [0x8c, 0x4a, 0x2f],
        ComponentKind::Bond => [0xe3, 0xbd, 0x4d],
        ComponentKind::ForebodyCarrier => [0x6f, 0x7d, 0x8c],
        ComponentKind::AftbodyTps => [0xb8, 0x7a, 0x4b],
        ComponentKind::AftbodyCarrier => [0x8f, 0xa0, 0xb0],
        ComponentKind::PrimaryStructure => [0x4f, 0x62, 0x75],
        ComponentKind::WingInsulation => [0xc9, 0xc2, 0xa5],
        ComponentKind::ImpactFoam => [0xe0, 0xa1, 0x3c],
        ComponentKind::ImpactShell => [0x2f, 0x5d, 0x8a],
        ComponentKind::BodyFoam => [0xe8, 0xd9, 0xa0],
        ComponentKind::LidInsulation => [0xd8, 0xd2, 0xbd],
        ComponentKind::Payload => [0x3f, 0x8f, 0x6b],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_fit_for_layers() {
        assert_eq!(key("Forebody TPS"), "forebody-tps");
        assert_eq!(named("  "), "vehicle");
    }
}
