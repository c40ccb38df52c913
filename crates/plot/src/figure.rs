//! What a figure shows: axes, series, event lines and limits, free of any drawing.

/// A two-dimensional figure.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    /// Heading above the plot, where there is room for one on the page.
    pub title: Option<String>,
    /// What a reader who does not see the figure should know; if empty, [`crate::summary`] is used.
    pub description: String,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis on the left.
    pub y: Axis,
    /// Vertical axis on the right, for series on [`Side::Right`].
    pub y2: Option<Axis>,
    /// Lines, point clouds and areas, drawn in this order.
    pub series: Vec<Series>,
    /// Vertical dashed lines with a label above the plot, the most important first: it is theirs where
    /// there is not room for all labels.
    pub events: Vec<EventLine>,
    /// Horizontal dashed lines of the left axis.
    pub limits: Vec<LimitLine>,
    /// Cursor linked with other figures.
    pub cursor: Option<Cursor>,
    /// Whether a unit has the same length on both axes.
    pub aspect: Aspect,
}

/// An axis: its caption, scale and, if it is not to follow the data, range.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Axis {
    /// Quantity, such as "Altitude".
    pub label: String,
    /// Unit symbol, empty where there is none.
    pub unit: String,
    /// Linear or logarithmic.
    pub scale: Scale,
    /// First and last value shown; the first may be the greater. Follows the data if absent.
    pub range: Option<(f64, f64)>,
}

/// Scale of an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scale {
    /// Equal steps for equal differences.
    #[default]
    Linear,
    /// Equal steps for equal ratios; values that are not positive are not drawn.
    Log,
}

/// Length of a unit on the two axes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Aspect {
    /// Each axis fills the plot.
    #[default]
    Free,
    /// The same on both axes, as in a drawing to scale. Needs two linear axes.
    Equal,
}

/// Points of one name.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Series {
    /// Name in the legend.
    pub name: String,
    /// Points (x, y); a point that is not finite breaks the line.
    pub points: Vec<(f64, f64)>,
    /// Look.
    pub style: Style,
    /// Vertical axis that the series is read on.
    pub side: Side,
}

/// Vertical axis that a series is read on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Side {
    /// The axis [`Figure::y`].
    #[default]
    Left,
    /// The axis [`Figure::y2`].
    Right,
}

/// Look of a series. Colour is never its only sign: see [`Style::nth`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Style {
    /// Index into the palette of the theme, taken modulo its length.
    pub colour: usize,
    /// Dashes of the line.
    pub dash: Dash,
    /// Sign at points, thinned out along a line.
    pub marker: Option<Marker>,
    /// Line, point cloud or area.
    pub kind: Kind,
}

/// How the points of a series are joined.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Kind {
    /// By straight lines.
    #[default]
    Line,
    /// Not at all: a marker at each.
    Points,
    /// Into a closed outline with a light filling.
    Area,
}

/// Dashes of a line.
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

/// Sign at a point.
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
    /// Vertical line, with a dot where it meets each line.
    X(f64),
    /// Cross-hair at a point of the left axis, for figures whose line turns back in x.
    Point(f64, f64),
}

impl Axis {
    /// Linear axis that follows the data.
    pub fn new(label: impl Into<String>, unit: impl Into<String>) -> Self {
        Self {
            label: label.into(),
            unit: unit.into(),
            ..Self::default()
        }
    }

    /// The same axis with another scale.
    #[must_use]
    pub fn with_scale(self, scale: Scale) -> Self {
        Self { scale, ..self }
    }

    /// The same axis with a fixed range.
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
    /// Line on the left axis, in the look that is the `index`-th to be used.
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
    /// Look of the `index`-th series: colour and dashes change together, then markers are added.
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
            colour: index,
            dash,
            marker,
            kind: Kind::Line,
        }
    }
}

impl Marker {
    /// The `index`-th marker, starting over after the last.
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
    /// Axis that a series is read on: the right one only where there is one.
    pub(crate) fn side_axis(&self, side: Side) -> &Axis {
        match (side, &self.y2) {
            (Side::Right, Some(axis)) => axis,
            _ => &self.y,
        }
    }

    /// Whether the series is read on an existing right axis.
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
    fn first_thirty_styles_differ_without_their_colour() {
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
