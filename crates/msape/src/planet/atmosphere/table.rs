//! Atmosphere that a user brings as a table.
//!
//! ```text
//! ln ρ = ln ρᵢ + (z − zᵢ) (ln ρᵢ₊₁ − ln ρᵢ)/(zᵢ₊₁ − zᵢ)        ln p the same, T linear in z
//! p = ρ R T                                                    where no pressure is given
//! ```
//!
//! with ρ in kg/m³, p in Pa, T in K, z in m, R of air in J/(kg K).
//! Beyond the ends ln ρ and ln p go on with their last slope, T is held. Without temperatures those of the
//! U.S. Standard Atmosphere 1976 are taken.
//!
//! # Valid
//! Between the first and the last altitude. Speed of sound and mean free path are those of air at sea level.
//!
//! # References
//! - Own convention; temperature \[coesa-1976\].

use super::{Air, Piece, StandardAir};
use crate::planet::rows::{self, Column, RowFault};
use numerics::math;
use numerics::scalar::Scalar;

/// Columns of a row, in order; a table has the first two, three or four.
pub const COLUMNS: [Column; 4] = [
    Column {
        name: "altitude_m",
        unit: "m",
        rule: rows::Rule::Ascending,
    },
    Column {
        name: "density_kg_m3",
        unit: "kg/m³",
        rule: rows::Rule::Positive,
    },
    Column {
        name: "temperature_K",
        unit: "K",
        rule: rows::Rule::Positive,
    },
    Column {
        name: "pressure_Pa",
        unit: "Pa",
        rule: rows::Rule::Positive,
    },
];

/// The atmosphere; each interval of the table is a piece of its own.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    intervals: Vec<Interval>,
    boundaries_m: Vec<f64>,
    valid_m: (f64, f64),
    standard: StandardAir,
}

#[derive(Clone, Debug, PartialEq)]
struct Interval {
    from_m: f64,
    ln_density: Line,
    temperature_k: Option<Line>,
    ln_pressure: Option<Line>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Line {
    value: f64,
    slope_per_m: f64,
}

impl Line {
    fn new(dz: f64, from: f64, to: f64) -> Self {
        Self {
            value: from,
            slope_per_m: (to - from) / dz,
        }
    }
}

impl Table {
    /// The atmosphere of rows of altitude, m, density, kg/m³, temperature, K (optional), pressure, Pa (optional); or
    /// all that is wrong with them.
    pub fn try_new(rows: &[Vec<f64>], standard: StandardAir) -> Result<Self, Vec<RowFault>> {
        rows::check(
            rows,
            &COLUMNS,
            rows::Shape {
                fewest_rows: 2,
                fewest_columns: 2,
            },
        )?;
        let column = |row: &[f64], i: usize| row.get(i).copied();
        let logarithm = |row: &[f64], i: usize| column(row, i).map(math::ln);
        let line = |dz: f64, a: Option<f64>, b: Option<f64>| Some(Line::new(dz, a?, b?));
        let mut intervals = Vec::with_capacity(rows.len());
        for pair in rows.windows(2) {
            let [a, b] = pair else { continue };
            let (Some(from_m), Some(to_m)) = (column(a, 0), column(b, 0)) else {
                continue;
            };
            let dz = to_m - from_m;
            let Some(ln_density) = line(dz, logarithm(a, 1), logarithm(b, 1)) else {
                continue;
            };
            intervals.push(Interval {
                from_m,
                ln_density,
                temperature_k: line(dz, column(a, 2), column(b, 2)),
                ln_pressure: line(dz, logarithm(a, 3), logarithm(b, 3)),
            });
        }
        let altitude = |row: Option<&Vec<f64>>| row.and_then(|r| column(r, 0)).unwrap_or(0.0);
        Ok(Self {
            boundaries_m: intervals.iter().skip(1).map(|i| i.from_m).collect(),
            intervals,
            valid_m: (altitude(rows.first()), altitude(rows.last())),
            standard,
        })
    }

    /// Altitudes of the rows within, m.
    pub fn boundaries_m(&self) -> &[f64] {
        &self.boundaries_m
    }

    /// First and last altitude of the table, m.
    pub fn valid_m(&self) -> (f64, f64) {
        self.valid_m
    }

    /// A number of the interval in which each lane is.
    #[inline]
    fn of_interval<S: Scalar, const K: usize>(
        &self,
        piece: &Piece<S::Value>,
        numbers: impl Fn(&Interval) -> [f64; K],
    ) -> [S; K] {
        let last = self.intervals.len().saturating_sub(1);
        let of = |layer: f64| {
            let interval = self.intervals.get((layer as usize).min(last));
            interval.map_or([0.0; K], &numbers)
        };
        piece.layers().lookup(of).map(S::from_value)
    }

    /// Density of one interval, kg/m³.
    #[inline]
    pub fn density_in<S: Scalar>(&self, piece: &Piece<S::Value>, altitude_m: S) -> S {
        let [from_m, value, slope_per_m]: [S; 3] = self.of_interval(piece, |i| {
            let Line { value, slope_per_m } = i.ln_density;
            [i.from_m, value, slope_per_m]
        });
        ((altitude_m - from_m) * slope_per_m + value).exp()
    }

    /// Everything of one interval.
    #[inline]
    pub fn air_in<S: Scalar>(&self, piece: &Piece<S::Value>, altitude_m: S) -> Air<S> {
        let density_kg_m3 = self.density_in(piece, altitude_m);
        let (first_m, last_m) = self.valid_m;
        let held_m = altitude_m
            .max(S::constant(first_m))
            .min(S::constant(last_m));
        // All rows have the same columns.
        let first = self.intervals.first();
        let line_at = |of: fn(&Interval) -> Option<Line>, altitude_m: S| {
            first.and_then(of)?;
            let [from_m, value, slope_per_m]: [S; 3] = self.of_interval(piece, |i| {
                let [value, slope] = of(i).map_or([0.0; 2], |l| [l.value, l.slope_per_m]);
                [i.from_m, value, slope]
            });
            Some((altitude_m - from_m) * slope_per_m + value)
        };
        let temperature_k = line_at(|i| i.temperature_k, held_m)
            .unwrap_or_else(|| self.standard.temperature.kinetic_k(altitude_m));
        let pressure_pa = line_at(|i| i.ln_pressure, altitude_m).map(S::exp);
        self.standard.of(density_kg_m3, temperature_k, pressure_pa)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planet::atmosphere::{Atmosphere, us_1976::UsStandard1976};
    use std::sync::Arc;

    fn standard() -> StandardAir {
        UsStandard1976::parse(include_str!("../../../data/atmospheres/us-1976.toml"))
            .unwrap()
            .standard_air()
    }

    fn table(rows: &[&[f64]]) -> Result<Atmosphere, Vec<RowFault>> {
        let rows: Vec<Vec<f64>> = rows.iter().map(|r| r.to_vec()).collect();
        Ok(Atmosphere::Table(Arc::new(Table::try_new(
            &rows,
            standard(),
        )?)))
    }

    #[test]
    fn half_way_the_density_is_the_geometric_mean_and_the_temperature_the_mean() {
        let air = table(&[
            &[0.0, 1.0, 300.0],
            &[1000.0, 0.25, 280.0],
            &[3000.0, 0.01, 270.0],
        ])
        .unwrap();
        let middle = air.air(500.0);
        assert!((middle.density_kg_m3 - 0.5).abs() < 1e-14);
        assert!((middle.temperature_k - 290.0).abs() < 1e-12);
        // p = 0.5 × 287.0529 × 290
        assert!(
            (middle.pressure_pa - 41622.67).abs() < 0.1,
            "{}",
            middle.pressure_pa
        );
    }

    #[test]
    fn beyond_the_ends_density_keeps_its_slope_and_temperature_is_held() {
        let air = table(&[
            &[0.0, 1.0, 300.0],
            &[1000.0, 0.25, 280.0],
            &[3000.0, 0.01, 270.0],
        ])
        .unwrap();
        // below: × 4 per 1000 m; above: × 0.04 per 2000 m
        assert!((air.density_kg_m3(-1000.0) - 4.0).abs() < 1e-12);
        assert!((air.density_kg_m3(5000.0) - 0.0004).abs() < 1e-15);
        assert_eq!(air.air(-1000.0).temperature_k, 300.0);
        assert_eq!(air.air(5000.0).temperature_k, 270.0);
        assert_eq!(air.boundaries_m(), [1000.0]);
    }

    #[test]
    fn without_temperature_that_of_the_standard_is_taken_and_a_given_pressure_is_kept() {
        let air = table(&[&[0.0, 1.0], &[11000.0, 0.3]]).unwrap();
        assert!((air.air(0.0).temperature_k - 288.15).abs() < 1e-9);
        let air = table(&[&[0.0, 1.0, 300.0, 90000.0], &[1000.0, 0.9, 290.0, 40000.0]]).unwrap();
        assert!((air.air(500.0).pressure_pa - 60000.0).abs() < 1e-6);
    }

    #[test]
    fn every_fault_is_named_with_its_row() {
        let faults = table(&[
            &[0.0, 1.0],
            &[2000.0, -0.5],
            &[1000.0, 0.2, 280.0],
            &[3000.0, f64::NAN],
        ])
        .unwrap_err();
        let text: Vec<String> = faults.iter().map(ToString::to_string).collect();
        assert_eq!(faults.len(), 4, "{text:?}");
        assert!(
            text.iter()
                .any(|t| t.starts_with("row 2: density_kg_m3: got -0.5 kg/m³")),
            "{text:?}"
        );
        assert!(
            text.iter()
                .any(|t| t.starts_with("row 3: altitude_m: got 1000 m")),
            "{text:?}"
        );
        assert!(table(&[&[0.0, 1.0]]).is_err());
        assert!(table(&[]).is_err());
    }
}
