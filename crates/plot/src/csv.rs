//! Plotted data as CSV, in the units of the axes and in full precision.

use crate::figure::Figure;
use crate::summary::heading;
use std::fmt::Write as _;

/// Whether all series have the same x values.
pub(crate) fn shares_x(figure: &Figure) -> bool {
    let xs = |i: usize| {
        figure
            .series
            .get(i)
            .into_iter()
            .flat_map(|s| &s.points)
            .map(|p| p.0.to_bits())
    };
    (1..figure.series.len()).all(|i| xs(i).eq(xs(0)))
}

/// Data with the header "label (unit)". Series with the same x are in adjacent columns; others follow each other, with
/// the name of the series in the first column. A gap is an empty cell.
pub fn csv(figure: &Figure) -> String {
    let mut text = String::new();
    let count = figure.series.len();
    if shares_x(figure) {
        let headings = (0..count).map(|i| heading(figure, i));
        row(&mut text, [figure.x.caption()].into_iter().chain(headings));
        let rows = figure.series.first().map_or(0, |s| s.points.len());
        for i in 0..rows {
            let points: Vec<(f64, f64)> = figure
                .series
                .iter()
                .filter_map(|s| s.points.get(i).copied())
                .collect();
            let x = points.first().map(|p| cell(p.0));
            row(
                &mut text,
                x.into_iter().chain(points.iter().map(|p| cell(p.1))),
            );
        }
        return text;
    }
    let units: Vec<String> = figure
        .series
        .iter()
        .map(|s| figure.side_axis(s.side).caption())
        .collect();
    let same = units.iter().all(|u| Some(u) == units.first());
    let y = if same {
        figure.y.caption()
    } else {
        "Value".to_owned()
    };
    row(
        &mut text,
        ["Series".to_owned(), figure.x.caption(), y].into_iter(),
    );
    for (i, series) in figure.series.iter().enumerate() {
        let name = if same {
            series.name.clone()
        } else {
            heading(figure, i)
        };
        for (x, y) in &series.points {
            row(&mut text, [name.clone(), cell(*x), cell(*y)].into_iter());
        }
    }
    text
}

/// The shortest form that reads back to the same number; empty for a value that is not finite.
fn cell(value: f64) -> String {
    if !value.is_finite() {
        return String::new();
    }
    let mut digits = String::new();
    let size = value.abs();
    // writing to a string cannot fail
    let _ = if size != 0.0 && !(1e-5..1e16).contains(&size) {
        write!(digits, "{value:e}")
    } else {
        write!(digits, "{value}")
    };
    digits
}

fn row(text: &mut String, cells: impl Iterator<Item = String>) {
    for (i, cell) in cells.enumerate() {
        if i > 0 {
            text.push(',');
        }
        if cell.contains([',', '"', '\n', '\r']) {
            text.push('"');
            text.push_str(&cell.replace('"', "\"\""));
            text.push('"');
        } else {
            text.push_str(&cell);
        }
    }
    text.push('\n');
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::{Axis, Series};

    fn figure(series: Vec<Series>) -> Figure {
        Figure {
            x: Axis::new("Time", "s"),
            y: Axis::new("Heat flux", "W/cm²"),
            series,
            ..Figure::default()
        }
    }

    #[test]
    fn same_x_gives_columns() {
        let a = Series::line("Convective", vec![(0.0, 1.5), (0.1, f64::NAN)], 0);
        let b = Series::line("Radiative, \"cold\"", vec![(0.0, 2.0), (0.1, 1e-9)], 1);
        assert_eq!(
            csv(&figure(vec![a, b])),
            "Time (s),Convective (W/cm²),\"Radiative, \"\"cold\"\" (W/cm²)\"\n0,1.5,2\n0.1,,1e-9\n"
        );
    }

    #[test]
    fn different_x_gives_rows() {
        let a = Series::line("a", vec![(0.0, 1.0)], 0);
        let b = Series::line("b", vec![(5.0, 2.0), (6.0, 3.0)], 1);
        assert_eq!(
            csv(&figure(vec![a, b])),
            "Series,Time (s),Heat flux (W/cm²)\na,0,1\nb,5,2\nb,6,3\n"
        );
    }

    #[test]
    fn numbers_survive_the_round_trip() {
        for value in [0.1 + 0.2, 1.0 / 3.0, 6.02e23, -1e-300, 123_456.789] {
            assert_eq!(
                cell(value).parse::<f64>().unwrap().to_bits(),
                value.to_bits()
            );
        }
    }
}
