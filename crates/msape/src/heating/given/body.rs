//! Heating given from outside at points of the body.
//!
//! ```text
//! q̇(f, ρ, V) at each fraction f        f = r/R or s/S
//! ```
//!
//! with q̇ in W/m², r the distance from the axis and R the largest radius, s the length along the outline from the nose tip and S that
//! to the largest radius, all in m. The table of f = 0 is that of the stagnation point.
//!
//! # Valid
//! Forebody, zero angle of attack.
//!
//! # References
//! - Own convention.

use super::check::Numbered;
use super::{GivenHeating, USERS};
use crate::aero::table::Extrapolation;
use crate::finding::{Finding, Severity};
use crate::quantity::input;
use crate::units::told;
use serde::{Deserialize, Serialize};

/// Points of a table, at most, assumed: each is integrated along the flight, and a profile of a forebody has a few dozen.
const MOST_POINTS: usize = 100;

/// Along what the points of a body are counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Along {
    /// Distance from the axis over the largest radius.
    Radius,
    /// Length along the outline over that to the largest radius.
    Arc,
}

impl Along {
    /// Name of the fraction in a sentence.
    pub fn name(self) -> &'static str {
        match self {
            Along::Radius => "r/R",
            Along::Arc => "s/S",
        }
    }
}

/// First difference between the rows of a point and those of the stagnation point: one integration meets the kinks of
/// all.
fn difference(first: &GivenHeating, table: &GivenHeating) -> Option<String> {
    let axes = [
        ("speed", &first.speeds_m_s, &table.speeds_m_s, "m/s"),
        (
            "density",
            &first.densities_kg_m3,
            &table.densities_kg_m3,
            "kg/m^3",
        ),
    ];
    for (name, of_first, own, unit) in axes {
        if let Some(more) = own.iter().find(|x| !of_first.contains(x)) {
            let more = told(*more);
            return Some(format!(
                "got the {name} {more} {unit}, must be one of those of the fraction 0"
            ));
        }
        if let Some(lacking) = of_first.iter().find(|x| !own.contains(x)) {
            let lacking = told(*lacking);
            return Some(format!(
                "no rows of the {name} {lacking} {unit}, which the fraction 0 has"
            ));
        }
    }
    (first.has_radiation() != table.has_radiation())
        .then(|| "its columns must be those of the fraction 0".to_owned())
}

/// Heat fluxes at points of the body, the stagnation point first.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyHeating {
    /// Along what the points are counted.
    pub along: Along,
    /// Fraction and heat fluxes of each point, ascending from 0; all have the same rows.
    pub points: Vec<(f64, GivenHeating)>,
}

impl BodyHeating {
    /// Rows of fraction and of what [`GivenHeating::try_new`] takes, in any order.
    ///
    /// # Errors
    /// The faults of the rows, of the first point that has some.
    pub fn try_new(
        key: &'static str,
        along: Along,
        rows: &[Vec<f64>],
        extrapolation: Extrapolation,
    ) -> Result<BodyHeating, Vec<String>> {
        let mut sorted: Vec<(f64, Numbered)> = rows
            .iter()
            .zip(1..)
            .filter_map(|(row, number)| {
                let (fraction, rest) = row.split_first()?;
                Some((*fraction, (number, rest)))
            })
            .collect();
        sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
        match sorted.first() {
            Some((first, _)) if *first == 0.0 => {}
            _ => {
                return Err(vec![
                    "no rows of the fraction 0, the stagnation point".to_owned(),
                ]);
            }
        }
        let mut points: Vec<(f64, GivenHeating)> = Vec::new();
        for same in sorted.chunk_by(|a, b| a.0 == b.0) {
            let Some((fraction, _)) = same.first() else {
                continue;
            };
            if points.len() == MOST_POINTS {
                return Err(vec![format!(
                    "more than {MOST_POINTS} points, must be {MOST_POINTS} or fewer"
                )]);
            }
            let rows: Vec<Numbered> = same.iter().map(|(_, row)| *row).collect();
            let of_point = |fault: String| format!("at the fraction {}: {fault}", told(*fraction));
            let table = GivenHeating::of_rows(key, &rows, extrapolation)
                .map_err(|faults| faults.into_iter().map(of_point).collect::<Vec<_>>())?;
            let other = points
                .first()
                .and_then(|(_, first)| difference(first, &table));
            if let Some(other) = other {
                return Err(vec![of_point(other)]);
            }
            points.push((*fraction, table));
        }
        if points.len() < 2 {
            return Err(vec![format!(
                "got the fraction 0 alone, must be 2 fractions or more; for the stagnation point alone give {}",
                input::heating::TABLE
            )]);
        }
        Ok(BodyHeating { along, points })
    }

    /// The table of the stagnation point.
    pub fn stagnation(&self) -> Option<&GivenHeating> {
        self.points.first().map(|(_, table)| table)
    }

    /// The remark that the heating of the body is the user's, and where it is used.
    pub fn finding(&self) -> Finding {
        let name = self.along.name();
        let last = self.points.last().map_or(0.0, |(fraction, _)| *fraction);
        let key = self.stagnation().map_or("", |table| table.key);
        Finding {
            severity: Severity::Note,
            model: key.into(),
            key: "shoulder_peak_heat_flux_w_m2".into(),
            value: None,
            valid: (None, None),
            message: format!(
                "Heating along the forebody is {USERS}: {} points of {name} 0 to {last}, each integrated along the flight; the largest heat flux and the largest heat load off the stagnation point stand in the place of the shoulder's. The aftbody keeps its share of the stagnation point.",
                self.points.len()
            ),
            source: USERS.into(),
            field: Some(key.into()),
        }
    }
}
