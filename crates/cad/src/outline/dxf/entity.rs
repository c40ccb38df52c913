//! Conversion of an entity to curves: LINE, ARC, CIRCLE, ELLIPSE, SPLINE, LWPOLYLINE, POLYLINE.
//!
//! ```text
//! x of an object that is seen from behind (extrusion 0, 0, −1) is −x of the drawing; LINE, ELLIPSE, SPLINE are in the drawing's axes
//! minor axis of an ellipse = extrusion × major axis × ratio
//! ```
//!
//! # Valid
//! Objects in planes z = constant. Frame control points of a smoothed POLYLINE (flag 16) are not drawn.
//!
//! # References
//! - \[autodesk-dxf\] the entities, object coordinates, VERTEX flags (group 70).

use super::affine::Affine;
use super::biarc::Bezier;
use super::curve::Curve;
use super::drawing::Record;
use super::spline;
use crate::outline::ImportFault;
use numerics::math::{PI, RADIANS_PER_DEGREE, hypot};

/// Largest difference of heights above the plane that count as equal, as a fraction of the object's size.
const FLAT: f64 = 1e-6;

/// Whether entities of this type may be part of an outline and are supported.
pub fn is_read(kind: &str) -> bool {
    matches!(
        kind,
        "LINE" | "ARC" | "CIRCLE" | "ELLIPSE" | "SPLINE" | "LWPOLYLINE" | "POLYLINE"
    )
}

/// Curves of an entity; `vertices` are the records that follow a POLYLINE.
pub fn curves(entity: &Record, vertices: &[Record]) -> Result<Vec<Curve>, ImportFault> {
    match entity.kind {
        "LINE" => line(entity).map(|curve| vec![curve]),
        "ARC" | "CIRCLE" => Ok(round(entity)?.moved(&seen(entity)?)),
        "ELLIPSE" => ellipse(entity).map(|curve| vec![curve]),
        "SPLINE" => spline_curve(entity).map(|curve| vec![curve]),
        "LWPOLYLINE" => {
            let points = light_vertices(entity)?;
            Ok(closed(entity, points).moved(&seen(entity)?))
        }
        "POLYLINE" => polyline(entity, vertices),
        _ => Ok(Vec::new()),
    }
}

/// Map from an object's coordinate system to the drawing's.
pub fn seen(entity: &Record) -> Result<Affine, ImportFault> {
    Ok(Affine::scale(side(entity)?, 1.0))
}

/// 1 for an object seen from the front, −1 from behind.
fn side(entity: &Record) -> Result<f64, ImportFault> {
    let [x, y] = [entity.number_or(210, 0.0)?, entity.number_or(220, 0.0)?];
    let z = entity.number_or(230, 1.0)?;
    match hypot(x, y) > FLAT * z.abs() {
        true => Err(entity.fault(format!(
            "{} is drawn in a plane that is turned out of z = 0 (extrusion {x}, {y}, {z})",
            entity.kind
        ))),
        false => Ok(if z < 0.0 { -1.0 } else { 1.0 }),
    }
}

/// Fails where heights above the plane of the drawing differ.
fn flat(entity: &Record, heights: &[f64], size: f64) -> Result<(), ImportFault> {
    let low = heights.iter().copied().fold(f64::INFINITY, f64::min);
    let high = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    match high - low > FLAT * size {
        true => Err(entity.fault(format!(
            "{} leaves the plane of the drawing, from z = {low} to {high}; draw the half-section in x and y",
            entity.kind
        ))),
        false => Ok(()),
    }
}

fn extent(points: &[[f64; 2]]) -> f64 {
    let first = points.first().copied().unwrap_or_default();
    points
        .iter()
        .map(|p| hypot(p[0] - first[0], p[1] - first[1]))
        .fold(0.0, f64::max)
}

fn line(entity: &Record) -> Result<Curve, ImportFault> {
    let ends = [entity.point(10)?, entity.point(11)?];
    let heights = [entity.number_or(30, 0.0)?, entity.number_or(31, 0.0)?];
    flat(entity, &heights, extent(&ends))?;
    Ok(Curve::Chain(ends.map(|[x, y]| [x, y, 0.0]).to_vec()))
}

fn round(entity: &Record) -> Result<Curve, ImportFault> {
    let center = entity.point(10)?;
    let radius = entity.number(40)?;
    if radius <= 0.0 {
        return Err(entity.fault(format!(
            "{}: got the radius {radius}, must be above 0",
            entity.kind
        )));
    }
    let [from, to] = match entity.kind {
        "CIRCLE" => [0.0, 360.0],
        _ => [entity.number(50)?, entity.number(51)?],
    };
    // counter-clockwise from the start angle to the end angle
    let turn = (to - from).rem_euclid(360.0);
    let sweep_deg = if turn == 0.0 { 360.0 } else { turn };
    Ok(Curve::Ellipse {
        center,
        u: [radius, 0.0],
        v: [0.0, radius],
        from: from * RADIANS_PER_DEGREE,
        sweep: sweep_deg * RADIANS_PER_DEGREE,
    })
}

fn ellipse(entity: &Record) -> Result<Curve, ImportFault> {
    let side = side(entity)?;
    let u = entity.point(11)?;
    let size = hypot(u[0], u[1]);
    flat(entity, &[0.0, entity.number_or(31, 0.0)?], size)?;
    let ratio = entity.number(40)?;
    if !(size > 0.0 && ratio.abs() > 0.0) {
        return Err(entity.fault(format!(
            "ELLIPSE: got the half-axes {size} and {}, must be above 0",
            ratio * size
        )));
    }
    let [from, to] = [entity.number_or(41, 0.0)?, entity.number_or(42, 2.0 * PI)?];
    let turn = (to - from).rem_euclid(2.0 * PI);
    Ok(Curve::Ellipse {
        center: entity.point(10)?,
        u,
        v: [-side * ratio * u[1], side * ratio * u[0]],
        from,
        sweep: if turn == 0.0 { 2.0 * PI } else { turn },
    })
}

fn spline_curve(entity: &Record) -> Result<Curve, ImportFault> {
    let points = |code: i32| -> Result<Vec<[f64; 2]>, ImportFault> {
        let [x, y, z] = [0, 10, 20].map(|more| entity.numbers(code + more));
        let (x, y, z) = (x?, y?, z?);
        if x.len() != y.len() {
            let reason = format!("SPLINE: got {} x and {} y of points", x.len(), y.len());
            return Err(entity.fault(reason));
        }
        let points: Vec<[f64; 2]> = x.into_iter().zip(y).map(|(x, y)| [x, y]).collect();
        flat(entity, &z, extent(&points))?;
        Ok(points)
    };
    let control = points(10)?;
    if control.is_empty() {
        let tangent = |code: i32| -> Result<Option<[f64; 2]>, ImportFault> {
            if entity.group(code).is_none() {
                return Ok(None);
            }
            let [x, y] = entity.point(code)?;
            let length = hypot(x, y);
            Ok((length > 0.0).then(|| [x / length, y / length]))
        };
        let curves = spline::through(&points(11)?, [tangent(12)?, tangent(13)?], entity.flag(1));
        return match curves.is_empty() {
            true => {
                Err(entity.fault("SPLINE has neither control points nor two fit points".to_owned()))
            }
            false => Ok(Curve::Smooth(curves)),
        };
    }
    let weights = entity.numbers(41)?;
    if !(weights.is_empty() || weights.len() == control.len()) {
        let reason = format!(
            "SPLINE: got {} weights, must be {}, one a control point",
            weights.len(),
            control.len()
        );
        return Err(entity.fault(reason));
    }
    let weights = weights.into_iter().chain(std::iter::repeat(1.0));
    let weighted: Vec<[f64; 3]> = control
        .iter()
        .zip(weights)
        .map(|([x, y], w)| [x * w, y * w, w])
        .collect();
    let degree = entity.whole(71).unwrap_or(3);
    let degree = usize::try_from(degree).unwrap_or(0);
    let curves = spline::decomposed(degree, &entity.numbers(40)?, &weighted)
        .map_err(|reason| entity.fault(format!("SPLINE: {reason}")))?;
    let ends = [
        curves.first().map(Bezier::start),
        curves.last().map(Bezier::end),
    ];
    if let (true, [Some(start), Some(end)]) = (entity.flag(1), ends)
        && extent(&[start, end]) > FLAT * extent(&control)
    {
        // some programs draw the open curve that the knots define, others a closed one
        return Err(entity.fault(
            "SPLINE is marked as closed, but by its knots its ends do not meet; draw it anew, or as an open one".to_owned(),
        ));
    }
    Ok(Curve::Smooth(curves))
}

/// Vertices of an LWPOLYLINE as x, y, bulge.
fn light_vertices(entity: &Record) -> Result<Vec<[f64; 3]>, ImportFault> {
    let mut vertices: Vec<[f64; 3]> = Vec::new();
    for group in entity.groups() {
        let place = match group.code {
            10 => {
                vertices.push([0.0; 3]);
                0
            }
            20 => 1,
            42 => 2,
            _ => continue,
        };
        let number = group.number()?;
        if let Some(slot) = vertices.last_mut().and_then(|vertex| vertex.get_mut(place)) {
            *slot = number;
        }
    }
    Ok(vertices)
}

fn polyline(entity: &Record, vertices: &[Record]) -> Result<Vec<Curve>, ImportFault> {
    const FRAME: i64 = 16;
    if entity.flag(16) || entity.flag(64) {
        return Err(ImportFault::Entity {
            place: entity.place,
            kind: "POLYLINE that is a mesh".to_owned(),
        });
    }
    // vertices of a 3-D polyline are in the drawing's axes, without bulges
    let solid = entity.flag(8);
    let (mut points, mut heights) = (Vec::new(), Vec::new());
    for vertex in vertices.iter().filter(|vertex| !vertex.flag(FRAME)) {
        let [x, y] = vertex.point(10)?;
        let bulge = if solid {
            0.0
        } else {
            vertex.number_or(42, 0.0)?
        };
        points.push([x, y, bulge]);
        heights.push(vertex.number_or(30, 0.0)?);
    }
    if points.is_empty() && !vertices.is_empty() {
        let reason =
            "POLYLINE is smoothed but holds only the frame of its control points".to_owned();
        return Err(entity.fault(reason));
    }
    if !solid {
        return Ok(closed(entity, points).moved(&seen(entity)?));
    }
    let plane: Vec<[f64; 2]> = points.iter().map(|[x, y, _]| [*x, *y]).collect();
    flat(entity, &heights, extent(&plane))?;
    Ok(vec![closed(entity, points)])
}

/// Chain of a polyline, with its first point repeated where it is closed.
fn closed(entity: &Record, mut points: Vec<[f64; 3]>) -> Curve {
    if entity.flag(1) {
        points.extend(points.first().map(|[x, y, _]| [*x, *y, 0.0]));
    } else if let Some(last) = points.last_mut() {
        last[2] = 0.0;
    }
    Curve::Chain(points)
}
