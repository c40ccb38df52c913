//! Mapping from data to px and back, by which a page places a linked cursor on a drawn figure.

use crate::figure::Scale;
use numerics::math::{exp, ln};

/// Rectangle, px from the upper left corner of the figure.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rect {
    /// Left edge, px.
    pub left_px: f64,
    /// Upper edge, px.
    pub top_px: f64,
    /// Right edge, px.
    pub right_px: f64,
    /// Lower edge, px.
    pub bottom_px: f64,
}

impl Rect {
    /// Width, px.
    pub fn width_px(&self) -> f64 {
        self.right_px - self.left_px
    }

    /// Height, px.
    pub fn height_px(&self) -> f64 {
        self.bottom_px - self.top_px
    }

    /// Whether a point is inside or on the edge.
    pub fn contains(&self, (x_px, y_px): (f64, f64)) -> bool {
        x_px >= self.left_px
            && x_px <= self.right_px
            && y_px >= self.top_px
            && y_px <= self.bottom_px
    }

    /// The rectangle enlarged by the same amount on each side.
    pub(crate) fn grown(&self, by_px: f64) -> Self {
        Self {
            left_px: self.left_px - by_px,
            top_px: self.top_px - by_px,
            right_px: self.right_px + by_px,
            bottom_px: self.bottom_px + by_px,
        }
    }

    /// Whether two rectangles share an area.
    pub(crate) fn overlaps(&self, other: &Self) -> bool {
        self.left_px < other.right_px
            && other.left_px < self.right_px
            && self.top_px < other.bottom_px
            && other.top_px < self.bottom_px
    }
}

/// Axis as drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisMap {
    /// Linear or logarithmic.
    pub scale: Scale,
    /// Value at the left or lower end.
    pub from: f64,
    /// Value at the right or upper end.
    pub to: f64,
    /// Position of the left or lower end, px.
    pub from_px: f64,
    /// Position of the right or upper end, px.
    pub to_px: f64,
}

impl AxisMap {
    /// Position of a value, px; `None` for a value that the axis cannot show.
    pub fn px(&self, value: f64) -> Option<f64> {
        let part = match self.scale {
            Scale::Linear => (value - self.from) / (self.to - self.from),
            Scale::Log if value > 0.0 => ln(value / self.from) / ln(self.to / self.from),
            Scale::Log => return None,
        };
        let px = self.from_px + part * (self.to_px - self.from_px);
        px.is_finite().then_some(px)
    }

    /// Value at a position.
    pub fn value(&self, px: f64) -> f64 {
        let part = (px - self.from_px) / (self.to_px - self.from_px);
        match self.scale {
            Scale::Linear => self.from + part * (self.to - self.from),
            Scale::Log => self.from * exp(part * ln(self.to / self.from)),
        }
    }
}

/// Figure as drawn, in CSS px from its upper left corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mapping {
    /// Plot area without labels.
    pub plot: Rect,
    /// Horizontal axis.
    pub x: AxisMap,
    /// Left axis.
    pub y: AxisMap,
    /// Right axis.
    pub y2: Option<AxisMap>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn middle_of_a_linear_axis_is_its_mean() {
        let axis = AxisMap {
            scale: Scale::Linear,
            from: 0.0,
            to: 8.0,
            from_px: 50.0,
            to_px: 150.0,
        };
        assert_eq!(axis.px(4.0), Some(100.0));
        assert_eq!(axis.value(100.0), 4.0);
    }

    #[test]
    fn middle_of_a_logarithmic_axis_is_its_geometric_mean() {
        let axis = AxisMap {
            scale: Scale::Log,
            from: 0.01,
            to: 100.0,
            from_px: 200.0,
            to_px: 0.0,
        };
        assert!((axis.px(1.0).unwrap() - 100.0).abs() < 1e-9);
        assert!((axis.value(50.0) - 10.0).abs() < 1e-9);
        assert_eq!(axis.px(0.0), None);
        assert_eq!(axis.px(-1.0), None);
    }
}
