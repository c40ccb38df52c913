//! Markers, distinguished by their shape.

use crate::figure::Marker;
use crate::scene::{Point, Scene, Shape};
use crate::theme::Rgb;

/// Adds a marker of about `radius_px` to a scene.
pub(crate) fn add(scene: &mut Scene, marker: Marker, (x, y): Point, radius_px: f64, color: Rgb) {
    let r = radius_px;
    let fill = |points: Vec<Point>| Shape::Fill {
        points,
        color,
        opacity: 1.0,
    };
    let stroke = |points: Vec<Point>| Shape::Path {
        points,
        color,
        width_px: 0.55 * r,
    };
    match marker {
        Marker::Circle => scene.shapes.push(Shape::Dot {
            at: (x, y),
            radius_px: r,
            color,
        }),
        Marker::Square => {
            let a = 0.9 * r;
            let corners = vec![
                (x - a, y - a),
                (x + a, y - a),
                (x + a, y + a),
                (x - a, y + a),
            ];
            scene.shapes.push(fill(corners));
        }
        Marker::Triangle => {
            let corners = vec![
                (x, y - 1.2 * r),
                (x + 1.1 * r, y + 0.8 * r),
                (x - 1.1 * r, y + 0.8 * r),
            ];
            scene.shapes.push(fill(corners));
        }
        Marker::Diamond => {
            let a = 1.25 * r;
            scene
                .shapes
                .push(fill(vec![(x, y - a), (x + a, y), (x, y + a), (x - a, y)]));
        }
        Marker::Plus => {
            let a = 1.2 * r;
            scene.shapes.push(stroke(vec![(x - a, y), (x + a, y)]));
            scene.shapes.push(stroke(vec![(x, y - a), (x, y + a)]));
        }
        Marker::Cross => {
            scene
                .shapes
                .push(stroke(vec![(x - r, y - r), (x + r, y + r)]));
            scene
                .shapes
                .push(stroke(vec![(x - r, y + r), (x + r, y - r)]));
        }
    }
}
