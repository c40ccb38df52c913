//! Ranges of axes that follow the data.

use crate::figure::{Aspect, Figure, Kind, Scale, Side};
use crate::number::{decade, scaled};

/// Range of an axis before rounding to ticks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Range {
    pub(crate) from: f64,
    pub(crate) to: f64,
    /// Whether the figure prescribes exactly this range.
    pub(crate) fixed: bool,
}

/// Smallest and largest of the values that the scale can show.
fn extent(values: impl Iterator<Item = f64>, scale: Scale) -> Option<(f64, f64)> {
    values
        .filter(|v| v.is_finite() && (scale == Scale::Linear || *v > 0.0))
        .fold(None, |range, v| match range {
            None => Some((v, v)),
            Some((low, high)) => Some((v.min(low), v.max(high))),
        })
}

fn asked(range: Option<(f64, f64)>, scale: Scale) -> Option<Range> {
    let (from, to) = range?;
    let usable = from.is_finite() && to.is_finite() && from != to;
    let shown = scale == Scale::Linear || (from > 0.0 && to > 0.0);
    (usable && shown).then_some(Range {
        from,
        to,
        fixed: true,
    })
}

/// Fraction of the largest value below which a value on the other side of 0 counts as 0.
const ROUNDING: f64 = 1e-6;

/// A range of nonzero length, which starts at 0 where the data nearly do.
fn widened((low, high): (f64, f64), scale: Scale, margin: f64) -> Range {
    let (from, to) = match scale {
        Scale::Log if high <= low * (1.0 + 1e-9) => (low / 2.0, high * 2.0),
        Scale::Log => (low, high),
        Scale::Linear => {
            // an end may miss 0 by rounding, which must not give a negative range
            let noise = ROUNDING * low.abs().max(high.abs());
            let low = if low < 0.0 && low >= -noise { 0.0 } else { low };
            let high = if high > 0.0 && high <= noise {
                0.0
            } else {
                high
            };
            let span = high - low;
            // differences lost in rounding do not make a range
            if span <= 1e-12 * low.abs().max(high.abs()) || span == 0.0 {
                let half = if low == 0.0 { 1.0 } else { 0.05 * low.abs() };
                (low - half, high + half)
            } else {
                let from = if low >= 0.0 && low < 0.3 * high {
                    0.0
                } else {
                    low - margin * span
                };
                let to = if high <= 0.0 && high > 0.3 * low {
                    0.0
                } else {
                    high + margin * span
                };
                (from, to)
            }
        }
    };
    Range {
        from,
        to,
        fixed: false,
    }
}

/// Range of the horizontal axis, or `None` if nothing can be shown.
pub(crate) fn horizontal(figure: &Figure) -> Option<Range> {
    let scale = figure.x.scale;
    let shown = figure.series.iter().flat_map(|s| {
        let y = figure.side_axis(s.side).scale;
        s.points
            .iter()
            .filter(move |p| p.1.is_finite() && (y == Scale::Linear || p.1 > 0.0))
            .map(|p| p.0)
    });
    asked(figure.x.range, scale).or_else(|| {
        let (low, high) = extent(shown, scale)?;
        let lines_only = figure.series.iter().all(|s| s.style.kind == Kind::Line);
        let near_zero = low >= 0.0 && low < 0.05 * high;
        if lines_only && scale == Scale::Linear && !near_zero && high > low {
            // a line may touch both ends of its axis
            return Some(Range {
                from: low,
                to: high,
                fixed: false,
            });
        }
        Some(widened(
            (low, high),
            scale,
            if lines_only { 0.0 } else { 0.03 },
        ))
    })
}

/// Range of a vertical axis, or `None` if nothing can be shown on it.
pub(crate) fn vertical(figure: &Figure, side: Side, x: Range) -> Option<Range> {
    let axis = figure.side_axis(side);
    let (x_low, x_high) = (x.from.min(x.to), x.from.max(x.to));
    let on_right = side == Side::Right;
    let points = figure
        .series
        .iter()
        .filter(|s| figure.is_right(s) == on_right)
        .flat_map(|s| &s.points)
        .filter(|p| p.0 >= x_low && p.0 <= x_high)
        .map(|p| p.1);
    asked(axis.range, axis.scale).or_else(|| {
        let data = extent(points, axis.scale)?;
        // keep limits off the edge of the plot
        let limits = figure
            .limits
            .iter()
            .filter(|_| !on_right)
            .map(|l| 1.05 * l.y);
        let all = extent([data.0, data.1].into_iter().chain(limits), axis.scale)?;
        // a drawing to scale is not extended to ticks, which gives other figures their margin
        let margin = if figure.aspect == Aspect::Equal {
            0.04
        } else {
            0.0
        };
        Some(widened(all, axis.scale, margin))
    })
}

/// The range extended to 1, 2 or 5 times a power of ten, by about a third of a decade at most.
pub(crate) fn around_decades((low, high): (f64, f64)) -> (f64, f64) {
    let (below, above) = (decade(low), decade(high));
    let mantissas = [1.0, 2.0, 5.0, 10.0];
    let from = mantissas
        .iter()
        .map(|m| scaled(*m, below))
        .rfind(|v| *v <= low * (1.0 + 1e-9));
    let to = mantissas
        .iter()
        .map(|m| scaled(*m, above))
        .find(|v| *v >= high * (1.0 - 1e-9));
    (from.unwrap_or(low), to.unwrap_or(high))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::{Axis, LimitLine, Series};

    fn figure(points: Vec<(f64, f64)>) -> Figure {
        Figure {
            series: vec![Series::line("a", points, 0)],
            ..Figure::default()
        }
    }

    #[test]
    fn limits_belong_to_the_range_and_small_positive_data_start_at_zero() {
        let mut figure = figure(vec![(0.0, 10.0), (1.0, 50.0)]);
        figure.limits.push(LimitLine {
            y: 100.0,
            label: "limit".into(),
        });
        let x = horizontal(&figure).unwrap();
        let y = vertical(&figure, Side::Left, x).unwrap();
        assert_eq!(y.from, 0.0);
        assert!(y.to >= 100.0);
    }

    #[test]
    fn one_value_gets_a_range_around_it() {
        let figure = figure(vec![(3.0, 20.0)]);
        let x = horizontal(&figure).unwrap();
        assert!(x.from < 3.0 && x.to > 3.0);
        let y = vertical(&figure, Side::Left, x).unwrap();
        assert_eq!((y.from, y.to), (19.0, 21.0));
    }

    #[test]
    fn logarithmic_range_ignores_what_it_cannot_show() {
        let mut figure = figure(vec![(0.0, -1.0), (1.0, 0.3), (2.0, 70.0), (3.0, f64::NAN)]);
        figure.y = Axis::new("", "").with_scale(Scale::Log);
        let y = vertical(&figure, Side::Left, horizontal(&figure).unwrap()).unwrap();
        assert_eq!((y.from, y.to), (0.3, 70.0));
        assert_eq!(around_decades((0.3, 70.0)), (0.2, 100.0));
    }

    #[test]
    fn nothing_to_show_has_no_range() {
        assert!(horizontal(&figure(vec![(f64::NAN, 1.0), (1.0, f64::INFINITY)])).is_none());
        assert!(horizontal(&Figure::default()).is_none());
    }

    #[test]
    fn an_end_a_tenth_of_a_millimeter_below_ground_does_not_open_a_negative_range() {
        let range = widened((-1e-4, 125_000.0), Scale::Linear, 0.05);
        assert_eq!(range.from, 0.0);
    }
}
