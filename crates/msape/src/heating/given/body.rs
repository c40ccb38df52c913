//! Heating from outside at points of the body.
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

use super::{GivenHeating, USERS};
use crate::aero::table::Extrapolation;
use crate::finding::{Finding, Severity};
use serde::{Deserialize, Serialize};

/// Points of a table, at most: each is integrated along the flight.
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
        let mut sorted: Vec<(f64, &[f64])> = rows
            .iter()
            .filter_map(|row| row.split_first().map(|(fraction, rest)| (*fraction, rest)))
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
            let rows: Vec<Vec<f64>> = same.iter().map(|(_, row)| row.to_vec()).collect();
            let of_point = |fault: String| format!("at the fraction {fraction}: {fault}");
            let table = GivenHeating::try_new(key, &rows, extrapolation)
                .map_err(|faults| faults.into_iter().map(of_point).collect::<Vec<_>>())?;
            if let Some((_, first)) = points.first()
                && (first.ends() != table.ends() || first.has_radiation() != table.has_radiation())
            {
                return Err(vec![of_point(
                    "its speeds, densities and columns must be those of the fraction 0".to_owned(),
                )]);
            }
            points.push((*fraction, table));
        }
        Ok(BodyHeating { along, points })
    }

    /// The table of the stagnation point.
    pub fn stagnation(&self) -> Option<&GivenHeating> {
        self.points.first().map(|(_, table)| table)
    }

    /// What a reader must know: that the heating of the body is the user's, and what it stands for.
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
