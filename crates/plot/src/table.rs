//! Table of a figure: the same data for readers who cannot see it.

use crate::csv::shares_x;
use crate::figure::Figure;
use crate::number::significant;
use crate::summary::heading;
use std::collections::BTreeSet;

/// Number of significant digits.
const DIGITS: usize = 5;

/// Rows of text under a header.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Table {
    /// Headings of the columns, with units.
    pub header: Vec<String>,
    /// Rows, each as long as the header.
    pub rows: Vec<Vec<String>>,
    /// Number of data rows, from which `rows` may be a selection.
    pub total: usize,
}

/// At most about `most_rows` rows: evenly spaced, with the ends and the extremes of each series.
///
/// Series with different x are listed one after the other, with their name first.
pub fn table(figure: &Figure, most_rows: usize) -> Table {
    let number = |v: f64| significant(v, DIGITS);
    if shares_x(figure) {
        let total = figure.series.first().map_or(0, |s| s.points.len());
        let chosen = chosen(
            figure.series.iter().map(|s| s.points.as_slice()),
            total,
            most_rows,
        );
        let row = |i: &usize| -> Vec<String> {
            let points: Vec<_> = figure
                .series
                .iter()
                .filter_map(|s| s.points.get(*i))
                .collect();
            let x = points.first().map(|p| number(p.0));
            x.into_iter()
                .chain(points.iter().map(|p| number(p.1)))
                .collect()
        };
        let headings = (0..figure.series.len()).map(|i| heading(figure, i));
        return Table {
            header: [figure.x.caption()].into_iter().chain(headings).collect(),
            rows: chosen.iter().map(row).collect(),
            total,
        };
    }
    let share = (most_rows / figure.series.len().max(1)).max(2);
    let mut table = Table {
        header: vec!["Series".to_owned(), figure.x.caption(), "Value".to_owned()],
        ..Table::default()
    };
    for (i, series) in figure.series.iter().enumerate() {
        let count = series.points.len();
        table.total += count;
        for index in chosen([series.points.as_slice()].into_iter(), count, share) {
            if let Some((x, y)) = series.points.get(index) {
                table
                    .rows
                    .push(vec![heading(figure, i), number(*x), number(*y)]);
            }
        }
    }
    table
}

fn chosen<'a>(
    lines: impl Iterator<Item = &'a [(f64, f64)]>,
    total: usize,
    most: usize,
) -> BTreeSet<usize> {
    if total <= most {
        return (0..total).collect();
    }
    let most = most.max(2);
    let mut rows: BTreeSet<usize> = (0..most).map(|i| i * (total - 1) / (most - 1)).collect();
    for line in lines {
        let finite = || {
            line.iter()
                .map(|p| p.1)
                .enumerate()
                .filter(|(_, y)| y.is_finite())
        };
        rows.extend(finite().max_by(|a, b| a.1.total_cmp(&b.1)).map(|(i, _)| i));
        rows.extend(finite().min_by(|a, b| a.1.total_cmp(&b.1)).map(|(i, _)| i));
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::{Axis, Series};

    #[test]
    fn ends_and_peak_are_among_the_rows() {
        let points = (0..1000)
            .map(|i| (f64::from(i), if i == 777 { 9.0 } else { 1.0 }))
            .collect();
        let figure = Figure {
            x: Axis::new("Time", "s"),
            y: Axis::new("Load", "g"),
            series: vec![Series::line("", points, 0)],
            ..Figure::default()
        };
        let table = table(&figure, 10);
        assert_eq!(table.header, ["Time (s)", "Load (g)"]);
        assert_eq!(
            table.rows.first(),
            Some(&vec!["0".to_owned(), "1".to_owned()])
        );
        assert!(table.rows.contains(&vec!["777".to_owned(), "9".to_owned()]));
        assert_eq!(
            table.rows.last(),
            Some(&vec!["999".to_owned(), "1".to_owned()])
        );
        assert!(table.rows.len() <= 12 && table.total == 1000);
    }

    #[test]
    fn few_points_are_all_listed() {
        let figure = Figure {
            series: vec![Series::line("a", vec![(0.0, 1.0), (1.0, f64::NAN)], 0)],
            ..Figure::default()
        };
        assert_eq!(table(&figure, 10).rows, [["0", "1"], ["1", "–"]]);
    }
}
