//! Outline of a DXF drawing: x of the drawing is the axis, y the distance from it.
//!
//! ```text
//! groups -> layers, blocks, entities -> curves in meters -> lines and arcs -> one chain from axis to axis
//! ```
//!
//! LINE, ARC, CIRCLE, LWPOLYLINE and POLYLINE are kept as lines and arcs. ELLIPSE, SPLINE and arcs in non-uniformly
//! scaled blocks become arcs that deviate by at most [`TOLERANCE`] of the largest distance from the axis. The half
//! below the axis serves as well as the one above it. Text and binary files are read; a unit given by the user
//! overrides that of the drawing.
//!
//! # Valid
//! Drawings in x and y, with $INSUNITS or a unit from the user, up to [`MOST_BYTES`] and [`drawn::MOST_ENTITIES`].
//!
//! # References
//! - \[autodesk-dxf\] ENTITIES, BLOCKS and TABLES sections, $INSUNITS.

pub mod affine;
pub mod biarc;
pub mod curve;
pub mod drawing;
pub mod drawn;
pub mod entity;
pub mod group;
pub mod spline;

use super::chain::{MOST_POINTS, Path};
use super::halves::rows;
use super::{ImportFault, Imported, LengthUnit, MOST_FAULTS, meters, shown};
use drawing::drawing;
use drawn::{Found, drawn};
use group::{Group, groups};
use msape::quantity::input;

/// Largest deviation of arcs from a smooth curve, as a fraction of the largest distance from the axis. The error of the
/// volume is less than this times surface over volume: relative 10⁻⁶ for a cone that is a third of its radius long.
pub const TOLERANCE: f64 = 5e-8;
/// Largest file size, bytes.
pub const MOST_BYTES: usize = 32 << 20;

/// The outline of a drawing, or all of its faults.
pub fn read(bytes: &[u8], unit: Option<LengthUnit>) -> Result<Imported, Vec<ImportFault>> {
    if bytes.len() > MOST_BYTES {
        return Err(vec![ImportFault::TooLarge(MOST_BYTES >> 20)]);
    }
    if let Some(version) = dwg(bytes) {
        return Err(vec![ImportFault::Dwg(version)]);
    }
    let groups = groups(bytes).map_err(|fault| vec![fault])?;
    let drawing = drawing(&groups).map_err(|fault| vec![fault])?;
    let mut remarks = Vec::new();
    let unit = match (unit, drawing.unit.map(drawn_unit)) {
        (Some(unit), drawn) => {
            remarks.extend(contradiction(unit, drawn, drawing.unit));
            Ok(unit)
        }
        (None, Some(Ok(Some(unit)))) => Ok(unit),
        (None, Some(Err(fault))) => Err(fault),
        (None, _) => Err(ImportFault::NoUnitInDrawing),
    };
    let scale = unit.as_ref().map_or(1.0, |unit| meters(*unit));
    let (found, left_out) = drawn(&drawing, scale).counted();
    remarks.extend(left_out);
    if !groups.last().is_some_and(|group| group.is(0, "EOF")) {
        remarks.push("the file does not end with EOF; it may be cut off".to_owned());
    }
    let mut faults = found.faults.clone();
    faults.extend(unit.err());
    if found.curves.is_empty() && faults.is_empty() {
        faults.push(nothing(&remarks));
    }
    faults.truncate(MOST_FAULTS);
    match faults.is_empty() {
        true => rows(paths(&found)?, remarks),
        false => Err(faults),
    }
}

/// Version of a DWG file, which is not supported.
fn dwg(bytes: &[u8]) -> Option<String> {
    let version = bytes.get(..6).filter(|start| start.starts_with(b"AC"))?;
    let digits = version.iter().skip(2).all(u8::is_ascii_digit);
    digits.then(|| String::from_utf8_lossy(version).into_owned())
}

/// Unit of $INSUNITS; 0 means that the drawing has none.
fn drawn_unit(group: &Group) -> Result<Option<LengthUnit>, ImportFault> {
    match group.whole() {
        Some(0) => Ok(None),
        Some(1) => Ok(Some(LengthUnit::Inch)),
        Some(2) => Ok(Some(LengthUnit::Foot)),
        Some(4) => Ok(Some(LengthUnit::Millimeter)),
        Some(5) => Ok(Some(LengthUnit::Centimeter)),
        Some(6) => Ok(Some(LengthUnit::Meter)),
        _ => Err(ImportFault::Drawing {
            place: group.place,
            reason: format!(
                "$INSUNITS: got {}, must be 1 (in), 2 (ft), 4 (mm), 5 (cm) or 6 (m); else name the unit with {}",
                shown(&group.name()),
                input::outline::FILE_UNIT
            ),
        }),
    }
}

/// Message where the user's unit differs from the drawing's.
fn contradiction(
    unit: LengthUnit,
    drawn: Option<Result<Option<LengthUnit>, ImportFault>>,
    group: Option<&Group>,
) -> Option<String> {
    let says = match drawn? {
        Ok(None) => return None,
        Ok(Some(same)) if same == unit => return None,
        Ok(Some(other)) => format!("is drawn in {}", other.name()),
        Err(_) => "names another unit".to_owned(),
    };
    let code = shown(&group.map(Group::name).unwrap_or_default());
    Some(format!(
        "the file {says} ($INSUNITS {code}); it is read in {}, as you say",
        unit.name()
    ))
}

fn nothing(remarks: &[String]) -> ImportFault {
    match remarks.is_empty() {
        true => ImportFault::Empty("LINE, ARC or polyline"),
        false => ImportFault::Chain(format!(
            "the drawing shows no line or curve; {}",
            remarks.join("; ")
        )),
    }
}

/// The curves converted to lines and arcs.
fn paths(found: &Found) -> Result<Vec<Path>, Vec<ImportFault>> {
    let reach = found.curves.iter().map(|(curve, _)| curve.reach());
    let tolerance = TOLERANCE * reach.fold(0.0, f64::max);
    let mut paths = Vec::with_capacity(found.curves.len());
    let mut room = MOST_POINTS;
    for (curve, place) in &found.curves {
        let points = curve.flattened(tolerance, room);
        let Some(left) = room.checked_sub(points.len()) else {
            return Err(vec![ImportFault::Chain(format!(
                "{place}: the drawing has more than {MOST_POINTS} points"
            ))]);
        };
        room = left;
        let place = *place;
        paths.push(Path { points, place });
    }
    Ok(paths)
}

#[cfg(test)]
mod tests;
