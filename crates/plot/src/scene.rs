//! Scene of shapes in px: the same for every backend, and accessible to tests.

use crate::mapping::Rect;
use crate::text::{Weight, width_px};
use crate::theme::Rgb;

/// Position, px from the upper left corner.
pub(crate) type Point = (f64, f64);

/// Horizontal alignment of text; vertically it is centered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Anchor {
    /// Text begins at the position.
    Start,
    /// Text is centered at the position.
    Middle,
    /// Text ends at the position.
    End,
}

/// A line of text.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Label {
    pub(crate) text: String,
    pub(crate) at: Point,
    pub(crate) anchor: Anchor,
    pub(crate) size_px: f64,
    pub(crate) weight: Weight,
    pub(crate) color: Rgb,
}

impl Label {
    /// Largest extent of the text.
    pub(crate) fn bounds(&self) -> Rect {
        let width = width_px(&self.text, self.size_px, self.weight);
        let left = match self.anchor {
            Anchor::Start => self.at.0,
            Anchor::Middle => self.at.0 - width / 2.0,
            Anchor::End => self.at.0 - width,
        };
        Rect {
            left_px: left,
            top_px: self.at.1 - 0.6 * self.size_px,
            right_px: left + width,
            bottom_px: self.at.1 + 0.6 * self.size_px,
        }
    }
}

/// A shape.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Shape {
    /// Line through points.
    Path {
        points: Vec<Point>,
        color: Rgb,
        width_px: f64,
    },
    /// Filled polygon; opacity from 0 to 1.
    Fill {
        points: Vec<Point>,
        color: Rgb,
        opacity: f64,
    },
    /// Filled circle.
    Dot {
        at: Point,
        radius_px: f64,
        color: Rgb,
    },
    /// Text.
    Text(Label),
}

/// Shapes in the order in which they are painted.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Scene {
    pub(crate) shapes: Vec<Shape>,
}

impl Scene {
    pub(crate) fn path(&mut self, points: Vec<Point>, color: Rgb, width_px: f64) {
        self.shapes.push(Shape::Path {
            points,
            color,
            width_px,
        });
    }

    pub(crate) fn rect(&mut self, rect: Rect, color: Rgb, opacity: f64) {
        let Rect {
            left_px,
            top_px,
            right_px,
            bottom_px,
        } = rect;
        let points = vec![
            (left_px, top_px),
            (right_px, top_px),
            (right_px, bottom_px),
            (left_px, bottom_px),
        ];
        self.shapes.push(Shape::Fill {
            points,
            color,
            opacity,
        });
    }

    pub(crate) fn text(&mut self, label: Label) {
        self.shapes.push(Shape::Text(label));
    }

    /// Labels in the order in which they are painted.
    #[cfg(test)]
    pub(crate) fn labels(&self) -> Vec<&Label> {
        let shapes = self.shapes.iter();
        shapes
            .filter_map(|s| {
                if let Shape::Text(label) = s {
                    Some(label)
                } else {
                    None
                }
            })
            .collect()
    }
}

/// Center of the px that contains a position, where a thin horizontal or vertical line is sharp.
pub(crate) fn sharp(px: f64) -> f64 {
    px.floor() + 0.5
}
