//! Radii and angles written beside the section.

use super::path::widest;
use crate::export::chain::{chains, length_m};
use crate::export::model::Model;
use msape::vehicle::segment::{Point, Segment};
use numerics::math::{PI, RADIANS_PER_DEGREE, atan2, sin_cos};

/// Side of the section on which a text is placed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Ahead of the nose.
    Fore,
    /// Behind the aft end.
    Aft,
}

/// Text that refers to a point of the outline.
#[derive(Clone, Debug, PartialEq)]
pub struct Callout {
    /// Point of the outline.
    pub at: Point,
    /// Text.
    pub words: String,
    /// Side.
    pub side: Side,
}

/// Shortest line that gets a callout, as a fraction of the largest radius.
const LEAST_LINE: f64 = 0.1;

/// Every radius of the outline, and the angle of every line that is neither parallel nor normal to the axis.
pub fn callouts(model: &Model) -> Vec<Callout> {
    let widest = widest(&model.outline);
    let shown = |s: &&Segment| length_m(s) > LEAST_LINE * widest.r_m || is_arc(s);
    let chains = chains(&model.outline);
    let segments = chains.iter().flat_map(|c| &c.segments).filter(shown);
    segments
        .filter_map(|segment| {
            let at = middle(segment);
            // a segment that runs outward faces forward, even where the wing lies ahead of the shoulder
            let side = if segment.end().r_m > segment.start().r_m {
                Side::Fore
            } else {
                Side::Aft
            };
            words(segment).map(|words| Callout { at, words, side })
        })
        .collect()
}

fn is_arc(segment: &Segment) -> bool {
    matches!(segment, Segment::Arc { .. })
}

fn words(segment: &Segment) -> Option<String> {
    match *segment {
        Segment::Arc { radius_m, .. } => Some(format!("R {:.1}", radius_m * 1000.0)),
        Segment::Line { start, end } => {
            // angle to the axis, 0 to 90 deg
            let angle = atan2((end.r_m - start.r_m).abs(), (end.x_m - start.x_m).abs());
            let angle_deg = angle / RADIANS_PER_DEGREE;
            (0.01..89.99)
                .contains(&angle_deg)
                .then(|| format!("{angle_deg:.1}° to the axis"))
        }
    }
}

fn middle(segment: &Segment) -> Point {
    match *segment {
        Segment::Line { start, end } => Point {
            x_m: 0.5 * (start.x_m + end.x_m),
            r_m: 0.5 * (start.r_m + end.r_m),
        },
        Segment::Arc {
            center,
            radius_m,
            start_angle_rad,
            sweep_rad,
            ..
        } => {
            let (s, c) = sin_cos(start_angle_rad + 0.5 * sweep_rad.clamp(-PI, PI));
            Point {
                x_m: center.x_m + radius_m * c,
                r_m: center.r_m + radius_m * s,
            }
        }
    }
}
