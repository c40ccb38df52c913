//! Checks the outline of a rigid body: a preset, dimensions of a sphere-cone, or points.

use crate::case::{Case, InputError, Reader};
use crate::library::{Library, named, names};
use crate::quantity::choice::AftOfCone;
use crate::quantity::input;
use crate::vehicle::body::shape::Aft;
use crate::vehicle::body::{RigidBody, Shape, from_rows};
use numerics::math::RADIANS_PER_DEGREE;

/// Outline of a case with a section `[outline]`; `None` without one.
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

/// Result of the section `[outline]` of a case.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Outline {
    /// The case has no such section.
    Absent,
    /// The section has faults, which are recorded.
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
    if !reader.any_given(input::outline::INPUTS) {
        return Outline::Absent;
    }
    match given_body(reader, library) {
        Some(body) => Outline::Body(Box::new(body)),
        None => Outline::Faulty,
    }
}

fn given_body(reader: &mut Reader, library: &Library) -> Option<RigidBody> {
    if reader.given(&input::outline::FILE) {
        // a fault that the reader has noted
        return None;
    }
    let ways = reader.ways(&input::outline::OUTLINE);
    if let [first, second, ..] = ways.as_slice() {
        let message = format!(
            "given together with {first}; give a preset, dimensions or points, not more than one"
        );
        reader.fault(second, message);
        return None;
    }
    match ways.first() {
        Some(way) if **way == input::outline::POINTS => of_points(reader),
        Some(way) if **way == input::outline::PRESET => of_preset(reader, library),
        _ => of_dimensions(reader),
    }
}

fn of_points(reader: &mut Reader) -> Option<RigidBody> {
    let rows = reader.rows(&input::outline::POINTS)?;
    if reader.given(&input::outline::DIAMETER_M) {
        let points = &input::outline::POINTS;
        let message = format!("given together with {points}, which have their own size");
        reader.fault(&input::outline::DIAMETER_M, message);
    }
    match from_rows("Outline of the case", &rows) {
        Ok(body) => Some(body),
        Err(faults) => {
            for fault in faults {
                reader.fault(&input::outline::POINTS, fault.to_string());
            }
            None
        }
    }
}

fn of_preset(reader: &mut Reader, library: &Library) -> Option<RigidBody> {
    let name = reader.name(&input::outline::PRESET, &names(&library.outlines));
    let diameter_m = reader.number(&input::outline::DIAMETER_M);
    match named(&library.outlines, name?)?.scaled_body(diameter_m) {
        Ok(body) => Some(body),
        Err(message) => {
            reader.fault(&input::outline::PRESET, message);
            None
        }
    }
}

fn of_dimensions(reader: &mut Reader) -> Option<RigidBody> {
    let [diameter_m, angle_deg, nose_radius_m, shoulder_radius_m] = [
        &input::outline::DIAMETER_M,
        &input::outline::CONE_HALF_ANGLE_DEG,
        &input::outline::NOSE_RADIUS_M,
        &input::outline::SHOULDER_RADIUS_M,
    ]
    .map(|input| reader.required_number(input));
    let aft = match reader.given(&input::outline::AFT) {
        true => reader.choice(&input::outline::AFT),
        false => Some(AftOfCone::Flat),
    };
    let shape = Shape {
        diameter_m: diameter_m?,
        nose_radius_m: nose_radius_m?,
        shoulder_radius_m: shoulder_radius_m?,
        cone_half_angle_rad: Some(angle_deg? * RADIANS_PER_DEGREE),
        aft: match aft? {
            AftOfCone::Mmeev => Aft::Mmeev,
            AftOfCone::Flat => Aft::Flat,
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
