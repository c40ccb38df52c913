//! Checks the outline of a rigid body: a preset, dimensions of a sphere-cone, or points.

use super::forms::choice;
use crate::case::{Case, InputError, Reader};
use crate::library::{Library, named};
use crate::quantity::input::inputs;
use crate::vehicle::body::shape::Aft;
use crate::vehicle::body::{RigidBody, Shape, from_rows};
use numerics::math::RADIANS_PER_DEGREE;

/// The outline of a case that has a section `[outline]`; `None` where it has none.
///
/// # Errors
/// Every fault of the section at once.
pub fn rigid_body(case: &Case, library: &Library) -> Result<Option<RigidBody>, Vec<InputError>> {
    let mut reader = Reader::new(case);
    reader
        .faults
        .retain(|fault| fault.key.starts_with("outline"));
    let body = outline(&mut reader, library).body();
    if reader.faults.is_empty() {
        Ok(body)
    } else {
        Err(reader.into_faults())
    }
}

/// Keys that give a sphere-cone by its dimensions.
const DIMENSIONS: [&str; 4] = [
    "outline.cone_half_angle_deg",
    "outline.nose_radius_m",
    "outline.shoulder_radius_m",
    "outline.aft",
];

/// What the section `[outline]` of a case makes.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Outline {
    /// The case has no such section.
    Absent,
    /// It has faults, which are noted.
    Faulty,
    /// An outline.
    Body(Box<RigidBody>),
}

impl Outline {
    /// The body, if there is one.
    pub(super) fn body(self) -> Option<RigidBody> {
        match self {
            Self::Body(body) => Some(*body),
            _ => None,
        }
    }
}

/// The outline of the case.
pub(super) fn outline(reader: &mut Reader, library: &Library) -> Outline {
    let mut keys = inputs().filter(|input| input.key.starts_with("outline."));
    if !keys.any(|input| reader.given(input.key)) {
        return Outline::Absent;
    }
    match given_body(reader, library) {
        Some(body) => Outline::Body(Box::new(body)),
        None => Outline::Faulty,
    }
}

fn given_body(reader: &mut Reader, library: &Library) -> Option<RigidBody> {
    let given = |reader: &Reader, key: &str| reader.given(key);
    if given(reader, "outline.file") {
        let message = "was not read; give its rows as outline.points";
        reader.fault("outline.file", message);
        return None;
    }
    let preset = given(reader, "outline.preset");
    let points = given(reader, "outline.points");
    let dimension = DIMENSIONS.into_iter().find(|key| reader.given(key));
    let ways: Vec<&str> = [
        preset.then_some("outline.preset"),
        points.then_some("outline.points"),
        dimension,
    ]
    .into_iter()
    .flatten()
    .collect();
    if let [first, second, ..] = ways.as_slice() {
        let message = format!(
            "given together with {first}; give a preset, dimensions or points, not more than one"
        );
        reader.fault(second, message);
        return None;
    }
    if points {
        return of_points(reader);
    }
    if preset {
        of_preset(reader, library)
    } else {
        of_dimensions(reader)
    }
}

fn of_points(reader: &mut Reader) -> Option<RigidBody> {
    let rows = reader.rows("outline.points")?;
    if reader.given("outline.diameter_m") {
        let message = "given together with outline.points, which have their own size";
        reader.fault("outline.diameter_m", message);
    }
    match from_rows("Outline of the case", &rows) {
        Ok(body) => Some(body),
        Err(faults) => {
            for fault in faults {
                reader.fault("outline.points", fault.to_string());
            }
            None
        }
    }
}

fn of_preset(reader: &mut Reader, library: &Library) -> Option<RigidBody> {
    let names: Vec<&str> = library
        .outlines
        .iter()
        .map(|(name, _)| name.as_str())
        .collect();
    let name = reader.choice("outline.preset", &names);
    let diameter_m = reader.number("outline.diameter_m");
    match named(&library.outlines, name?)?.scaled_body(diameter_m) {
        Ok(body) => Some(body),
        Err(message) => {
            reader.fault("outline.preset", message);
            None
        }
    }
}

fn of_dimensions(reader: &mut Reader) -> Option<RigidBody> {
    let [diameter_m, angle_deg, nose_radius_m, shoulder_radius_m] = [
        "outline.diameter_m",
        "outline.cone_half_angle_deg",
        "outline.nose_radius_m",
        "outline.shoulder_radius_m",
    ]
    .map(|key| reader.required_number(key));
    let aft = match reader.given("outline.aft") {
        true => choice(reader, "outline.aft"),
        false => Some("flat"),
    };
    let shape = Shape {
        diameter_m: diameter_m?,
        nose_radius_m: nose_radius_m?,
        shoulder_radius_m: shoulder_radius_m?,
        cone_half_angle_rad: Some(angle_deg? * RADIANS_PER_DEGREE),
        aft: match aft? {
            "mmeev" => Aft::Mmeev,
            _ => Aft::Flat,
        },
    };
    match shape.body("Sphere-cone of the case") {
        Ok(body) => Some(body),
        Err(faults) => {
            for (key, message) in faults {
                reader.fault(&format!("outline.{key}"), message);
            }
            None
        }
    }
}
