//! Values under a cursor.

use crate::figure::Figure;
use crate::line::crossings;
use crate::number::significant;

/// Value of a series at the cursor.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// Index of the series.
    pub series: usize,
    /// Name of the series.
    pub name: String,
    /// Interpolated value in the unit of its axis.
    pub value: f64,
    /// Value to five digits, with its unit.
    pub text: String,
}

/// Values of the series at `x`, the first where a line is not single-valued; series that do not reach `x` are left out.
pub fn readings(figure: &Figure, x: f64) -> Vec<Reading> {
    let read = |(index, series): (usize, &crate::figure::Series)| {
        let value = crossings(&series.points, x, 1).first().copied()?;
        let unit = &figure.side_axis(series.side).unit;
        let text = format!("{} {unit}", significant(value, 5))
            .trim_end()
            .to_owned();
        Some(Reading {
            series: index,
            name: series.name.clone(),
            value,
            text,
        })
    };
    figure.series.iter().enumerate().filter_map(read).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::{Axis, Series};

    #[test]
    fn half_way_between_1_and_2_is_1_5() {
        let figure = Figure {
            y: Axis::new("Altitude", "km"),
            series: vec![
                Series::line("a", vec![(0.0, 1.0), (10.0, 2.0)], 0),
                Series::line("b", vec![(20.0, 1.0), (30.0, 2.0)], 1),
            ],
            ..Figure::default()
        };
        let found = readings(&figure, 5.0);
        assert_eq!(found.len(), 1);
        assert_eq!((found[0].value, found[0].text.as_str()), (1.5, "1.5 km"));
    }
}
