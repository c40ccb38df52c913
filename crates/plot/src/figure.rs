//! Content of a figure: axes, series, event lines and limits, independent of drawing.

/// A two-dimensional figure.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    /// Heading above the plot; `None` where the page has a heading.
    pub title: Option<String>,
    /// Description for readers who cannot see the figure; if empty, [`crate::summary`] is used.
    pub description: String,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis on the left.
    pub y: Axis,
    /// Vertical axis on the right, for series on [`Side::Right`].
    pub y2: Option<Axis>,
    /// Lines, point clouds and areas, drawn in this order.
    pub series: Vec<Series>,
    /// Vertical dashed lines with a label above the plot, most important first: the first get a label where there is
    /// not room for all.
    pub events: Vec<EventLine>,
    /// Horizontal dashed lines on the left axis.
    pub limits: Vec<LimitLine>,
    /// Cursor linked with other figures.
    pub cursor: Option<Cursor>,
    /// Whether both axes have the same scale.
    pub aspect: Aspect,
}

/// Axis: caption, scale and, unless it follows the data, range.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Axis {
    /// Quantity, such as "Altitude".
    pub label: String,
    /// Unit symbol, empty where there is none.
    pub unit: String,
    /// Linear or logarithmic.
    pub scale: Scale,
    /// First and last value shown; the first may be the greater. `None` follows the data.
    pub range: Option<(f64, f64)>,
}

/// Scale of an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scale {
    /// Linear.
    #[default]
    Linear,
    /// Logarithmic; values that are not positive are not drawn.
    Log,
}

/// Ratio of the scales of the two axes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Aspect {
    /// Independent: each axis fills the plot.
    #[default]
    Free,
    /// Equal, as in a drawing to scale. Needs two linear axes.
    Equal,
}

/// Named set of points.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Series {
    /// Name in the legend.
    pub name: String,
    /// Points (x, y); a non-finite point breaks the line.
    pub points: Vec<(f64, f64)>,
    /// Style.
    pub style: Style,
    /// Vertical axis of the series.
    pub side: Side,
}

/// Vertical axis of a series.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Side {
    /// The axis [`Figure::y`].
    #[default]
    Left,
    /// The axis [`Figure::y2`].
    Right,
}

/// Style of a series. Color is never the only distinction: see [`Style::nth`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Style {
    /// Index into the palette of the theme, taken modulo its length.
    pub color: usize,
    /// Dash pattern of the line.
    pub dash: Dash,
    /// Marker at points, spaced along a line.
    pub marker: Option<Marker>,
    /// Line, point cloud or area.
    pub kind: Kind,
}

/// Representation of the points of a series.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Kind {
    /// Straight lines between the points.
    #[default]
    Line,
    /// A marker at each point, without lines.
    Points,
    /// A closed outline with a light filling.
    Area,
}

/// Dash pattern of a line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Dash {
    #[default]
    Solid,
    Dash,
    Dot,
    DashDot,
    LongDash,
}

/// Marker shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Marker {
    Circle,
    Square,
    Triangle,
    Diamond,
    Plus,
    Cross,
}

/// Vertical line at an event.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EventLine {
    /// Position on the horizontal axis.
    pub x: f64,
    /// Short label.
    pub label: String,
}

/// Horizontal line at a limit.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LimitLine {
    /// Position on the left axis.
    pub y: f64,
    /// Short label.
    pub label: String,
}

/// Cursor of a figure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cursor {
    /// Vertical line, with a dot where it crosses each series.
    X(f64),
    /// Cross-hair at a point of the left axis, for figures whose lines are not single-valued in x.
    Point(f64, f64),
}

impl Axis {
    /// A linear axis that follows the data.
    pub fn new(label: impl Into<String>, unit: impl Into<String>) -> Self {
        Self {
            label: label.into(),
            unit: unit.into(),
            ..Self::default()
        }
    }

    /// The axis with another scale.
    #[must_use]
    pub fn with_scale(self, scale: Scale) -> Self {
        Self { scale, ..self }
    }

    /// The axis with a fixed range.
    #[must_use]
    pub fn with_range(self, from: f64, to: f64) -> Self {
        Self {
            range: Some((from, to)),
            ..self
        }
    }

    /// Label with the unit: "Altitude (km)".
    pub fn caption(&self) -> String {
        with_unit(&self.label, &self.unit)
    }
}

/// `label (unit)`, or the label alone where there is no unit.
pub(crate) fn with_unit(label: &str, unit: &str) -> String {
    if unit.is_empty() {
        label.to_owned()
    } else {
        format!("{label} ({unit})")
    }
}

impl Series {
    /// A line on the left axis in the `index`-th style.
    pub fn line(name: impl Into<String>, points: Vec<(f64, f64)>, index: usize) -> Self {
        Self {
            name: name.into(),
            points,
            style: Style::nth(index),
            side: Side::Left,
        }
    }
}

impl Style {
    /// Style of the `index`-th series: color and dashes change together, then markers are added.
    pub fn nth(index: usize) -> Self {
        const DASHES: [Dash; 5] = [
            Dash::Solid,
            Dash::Dash,
            Dash::DashDot,
            Dash::Dot,
            Dash::LongDash,
        ];
        let dash = DASHES
            .get(index % DASHES.len())
            .copied()
            .unwrap_or_default();
        let marker = index.checked_sub(DASHES.len()).map(Marker::nth);
        Self {
            color: index,
            dash,
            marker,
            kind: Kind::Line,
        }
    }
}

impl Marker {
    /// The `index`-th marker, cycling through all of them.
    pub fn nth(index: usize) -> Self {
        match index % 6 {
            0 => Self::Circle,
            1 => Self::Square,
            2 => Self::Triangle,
            3 => Self::Diamond,
            4 => Self::Plus,
            _ => Self::Cross,
        }
    }
}

impl Figure {
    /// Axis of a series: the right one only where it exists.
    pub(crate) fn side_axis(&self, side: Side) -> &Axis {
        match (side, &self.y2) {
            (Side::Right, Some(axis)) => axis,
            _ => &self.y,
        }
    }

    /// Whether a series uses an existing right axis.
    pub(crate) fn is_right(&self, series: &Series) -> bool {
        series.side == Side::Right && self.y2.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn caption_has_the_unit_in_parentheses_where_there_is_one() {
        assert_eq!(Axis::new("Altitude", "km").caption(), "Altitude (km)");
        assert_eq!(Axis::new("Mach number", "").caption(), "Mach number");
    }

    #[test]
    fn first_thirty_styles_differ_without_their_color() {
        let signs: Vec<_> = (0..30)
            .map(Style::nth)
            .map(|s| (s.dash, s.marker))
            .collect();
        for (i, a) in signs.iter().enumerate() {
            assert!(
                !signs[i + 1..].iter().take(4).any(|b| a == b),
                "style {i} repeats"
            );
        }
    }
}
