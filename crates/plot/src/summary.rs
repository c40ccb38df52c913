//! Description of a figure in words, for readers who cannot see it.

use crate::figure::{Figure, with_unit};
use crate::number::significant;

/// One sentence per series, with its ends and extremes, then limits and events.
pub fn summary(figure: &Figure) -> String {
    let mut text = format!("{} over {}.", figure.y.caption(), figure.x.caption());
    let x_unit = &figure.x.unit;
    let number = |v: f64, unit: &str| match unit {
        "" => significant(v, 4),
        unit => format!("{} {unit}", significant(v, 4)),
    };
    for series in &figure.series {
        let unit = &figure.side_axis(series.side).unit;
        let finite = || {
            series
                .points
                .iter()
                .filter(|p| p.0.is_finite() && p.1.is_finite())
        };
        let (Some(first), Some(last)) = (finite().next(), finite().next_back()) else {
            text.push_str(&format!(" {}: no data.", series.name));
            continue;
        };
        let order = |a: &&(f64, f64), b: &&(f64, f64)| a.1.total_cmp(&b.1);
        let highest = finite().rev().max_by(order).unwrap_or(first);
        let lowest = finite().min_by(order).unwrap_or(first);
        let at = |p: &(f64, f64)| format!("{} at {}", number(p.1, unit), number(p.0, x_unit));
        let name = if series.name.is_empty() {
            "The series"
        } else {
            &series.name
        };
        text.push_str(&format!(
            " {name}: from {} to {}, highest {}, lowest {}.",
            at(first),
            at(last),
            at(highest),
            at(lowest)
        ));
    }
    for limit in &figure.limits {
        text.push_str(&format!(
            " Limit {}: {}.",
            limit.label,
            number(limit.y, &figure.y.unit)
        ));
    }
    for event in figure.events.iter().filter(|e| e.x.is_finite()) {
        text.push_str(&format!(" {} at {}.", event.label, number(event.x, x_unit)));
    }
    text
}

/// Heading of a series in CSV and table: its name with the unit of its axis.
pub(crate) fn heading(figure: &Figure, index: usize) -> String {
    let Some(series) = figure.series.get(index) else {
        return String::new();
    };
    let axis = figure.side_axis(series.side);
    let name = if series.name.is_empty() {
        &axis.label
    } else {
        &series.name
    };
    with_unit(name, &axis.unit)
}
