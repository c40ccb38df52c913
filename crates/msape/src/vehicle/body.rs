//! A rigid body of revolution: an outline that is flown, or exported, as it is.
//!
//! ```text
//! S = π D² / 4        D = 2 max r
//! ```
//!
//! with the area S that coefficients refer to in m², D in m, x along the axis in m, aft positive. x = 0 is the virtual apex of the
//! cone where the shape has one, the tip of the nose for a spherical segment, and as in the file for points.
//!
//! # Valid
//! Closed outlines of lines and arcs that touch the axis at both ends only.
//!
//! # References
//! - \[samareh-2014\] section 3.1.4 (bodies of revolution about the virtual apex's axis).

pub mod check;
pub mod facts;
pub mod pairs;
pub mod points;
pub mod preset;
pub mod shape;

pub use points::from_rows;
pub use preset::OutlineData;
pub use shape::Shape;

use crate::vehicle::profile::Profile;
use crate::vehicle::segment::Segment;
use numerics::math::{FRAC_PI_2, PI, atan2, hypot};
use serde::{Deserialize, Serialize};

/// An outline as a rigid body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RigidBody {
    /// Name.
    pub name: String,
    /// Outline from the nose over the shoulder to the aft end, closed along the axis.
    pub outline: Profile,
    /// Largest diameter, m.
    pub diameter_m: f64,
    /// Radius of the nose, m; absent where the outline is blunt, pointed or has no recognizable sphere.
    pub nose_radius_m: Option<f64>,
    /// Angle between the axis and the forebody's cone, rad; absent without a cone.
    pub cone_half_angle_rad: Option<f64>,
    /// Axial position of the cone's virtual apex, m; absent without a cone.
    pub virtual_apex_x_m: Option<f64>,
    /// Sources and processing of the numbers.
    pub notes: Vec<String>,
}

impl RigidBody {
    /// A body from its open outline, nose first, in which nose and cone are recognized.
    pub fn from_outline(name: &str, open: Profile, notes: Vec<String>) -> Self {
        let [.., largest_r_m] = open.bounds_m();
        let diameter_m = 2.0 * largest_r_m.max(0.0);
        let cone = cone(&open, diameter_m);
        let mut body = Self {
            name: name.to_owned(),
            nose_radius_m: nose_radius_m(&open),
            cone_half_angle_rad: cone.map(|(angle, _)| angle),
            virtual_apex_x_m: cone.map(|(_, apex)| apex),
            outline: open.closed(),
            diameter_m,
            notes,
        };
        if let Some(radius) = body.nose_radius_m {
            let note = format!("Nose radius {radius} m, read off the outline.");
            body.notes.push(note);
        }
        body
    }

    /// Area that coefficients refer to, m².
    pub fn reference_area_m2(&self) -> f64 {
        PI * self.diameter_m * self.diameter_m / 4.0
    }

    /// Axial position of the tip of the nose, m.
    pub fn nose_tip_x_m(&self) -> f64 {
        self.outline.start().map_or(0.0, |point| point.x_m)
    }

    /// Least and largest axial position of any point of it, m.
    pub fn extent_m(&self) -> [f64; 2] {
        let [from, to, ..] = self.outline.bounds_m();
        [from, to]
    }

    /// Extent along the axis, m.
    pub fn length_m(&self) -> f64 {
        let [from, to] = self.extent_m();
        to - from
    }
}

/// Largest relative difference between the radii from points on a nose sphere.
const NOSE_TOLERANCE: f64 = 1e-3;
/// Number of points, in addition to the tip, that define a nose sphere.
const NOSE_POINTS: usize = 3;
/// A nose sphere cut by this or less by the axis is centered on it.
const CENTER_TOLERANCE: f64 = 1e-6;

/// Radius of the nose: of an arc about a point of the axis, or of the sphere on which the first points lie.
fn nose_radius_m(open: &Profile) -> Option<f64> {
    let first = open.segments.first()?;
    if let Segment::Arc {
        center, radius_m, ..
    } = *first
    {
        return (center.r_m.abs() <= CENTER_TOLERANCE * radius_m).then_some(radius_m);
    }
    let tip = first.start();
    // sphere about the axis through tip and point: R = (Δx² + r²) / 2 Δx
    let mut radii = open
        .segments
        .iter()
        .take_while(|segment| matches!(segment, Segment::Line { .. }))
        .map(|segment| {
            let (dx, r) = (segment.end().x_m - tip.x_m, segment.end().r_m);
            (dx * dx + r * r) / (2.0 * dx)
        });
    let radius = radii.next().filter(|r| r.is_finite() && *r > 0.0)?;
    let alike = radii
        .take_while(|r| (r / radius - 1.0).abs() <= NOSE_TOLERANCE)
        .count();
    (alike + 1 >= NOSE_POINTS).then_some(radius)
}

/// Least fraction of the radius that a line of the forebody spans to count as its cone.
const CONE_SPAN: f64 = 0.2;

/// Half-angle and apex of the forebody's cone: its longest line up to the largest diameter.
fn cone(open: &Profile, diameter_m: f64) -> Option<(f64, f64)> {
    let mut longest: Option<(f64, f64, f64)> = None;
    for segment in &open.segments {
        if let Segment::Line { start, end } = *segment {
            let (dx, dr) = (end.x_m - start.x_m, end.r_m - start.r_m);
            let length = hypot(dx, dr);
            let angle = atan2(dr, dx);
            let opens = dx > 0.0 && dr > 0.0 && angle < FRAC_PI_2;
            if opens && dr >= CONE_SPAN * diameter_m / 2.0 && longest.is_none_or(|l| length > l.0) {
                longest = Some((length, angle, start.x_m - start.r_m * dx / dr));
            }
        }
        if segment.bounds_m()[3] >= 0.5 * diameter_m * (1.0 - 1e-12) {
            break;
        }
    }
    longest.map(|(_, angle, apex)| (angle, apex))
}
