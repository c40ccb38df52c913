//! Wind: velocity of the air relative to the planet, against altitude.
//!
//! ```text
//! w = wᵢ + (z − zᵢ) (wᵢ₊₁ − wᵢ)/(zᵢ₊₁ − zᵢ)
//! ```
//!
//! with w = (eastward, northward) in m/s and z in m; beyond the ends w is held.
//!
//! # Valid
//! Horizontal winds only.
//!
//! # References
//! - Own convention.

use super::rows::{self, Column, RowFault, Rule, Shape};
use numerics::scalar::Scalar;

/// Columns of a row, in order.
pub const COLUMNS: [Column; 3] = [
    Column {
        name: "altitude_m",
        unit: "m",
        rule: Rule::Ascending,
    },
    Column {
        name: "eastward_m_s",
        unit: "m/s",
        rule: Rule::Finite,
    },
    Column {
        name: "northward_m_s",
        unit: "m/s",
        rule: Rule::Finite,
    },
];

/// Altitude, m, eastward and northward wind there, m/s, and their slopes, 1/s.
pub type Row = [f64; 5];

/// A model of the wind.
#[derive(Clone, Debug, PartialEq)]
pub enum Wind {
    /// No wind: the air rotates with the planet.
    Calm,
    /// Constant wind at every altitude.
    Constant {
        /// Eastward, m/s.
        eastward_m_s: f64,
        /// Northward, m/s.
        northward_m_s: f64,
    },
    /// Rows of altitude.
    Table(WindTable),
}

/// Rows of wind, checked.
#[derive(Clone, Debug, PartialEq)]
pub struct WindTable {
    /// Below the first altitude, between two and above the last.
    rows: Vec<Row>,
    altitudes_m: Vec<f64>,
}

impl WindTable {
    /// The table of rows of altitude, m, eastward, m/s, northward, m/s; or all that is wrong with them.
    pub fn try_new(rows: &[Vec<f64>]) -> Result<Self, Vec<RowFault>> {
        rows::check(
            rows,
            &COLUMNS,
            Shape {
                fewest_rows: 1,
                fewest_columns: COLUMNS.len(),
            },
        )?;
        let points = || {
            rows.iter()
                .filter_map(|row| <[f64; 3]>::try_from(row.as_slice()).ok())
        };
        let level = |[z, east, north]: [f64; 3]| [z, east, north, 0.0, 0.0];
        let between =
            points()
                .zip(points().skip(1))
                .map(|([z, east, north], [z_1, east_1, north_1])| {
                    let dz = z_1 - z;
                    [z, east, north, (east_1 - east) / dz, (north_1 - north) / dz]
                });
        let (first, last) = (points().next(), points().next_back());
        let ends = [first, last].map(|end| end.map(level));
        let [below, above] = ends;
        Ok(Self {
            rows: below.into_iter().chain(between).chain(above).collect(),
            altitudes_m: points().map(|[z, ..]| z).collect(),
        })
    }

    /// First and last altitude, m.
    pub fn ends_m(&self) -> [f64; 2] {
        let ends = [self.altitudes_m.first(), self.altitudes_m.last()];
        ends.map(|altitude_m| altitude_m.copied().unwrap_or_default())
    }

    #[inline]
    fn row(&self, altitude_m: f64) -> Row {
        let below = self.altitudes_m.partition_point(|z| *z <= altitude_m);
        self.rows.get(below).copied().unwrap_or_default()
    }
}

impl Wind {
    /// Greatest speed of the wind, m/s.
    pub fn fastest_m_s(&self) -> f64 {
        let speed = |east: f64, north: f64| (east * east + north * north).sqrt();
        match self {
            Wind::Calm => 0.0,
            Wind::Constant {
                eastward_m_s,
                northward_m_s,
            } => speed(*eastward_m_s, *northward_m_s),
            Wind::Table(table) => {
                let rows = table.altitudes_m.iter();
                let speeds = rows.map(|altitude_m| {
                    let [_, east, north, ..] = table.row(*altitude_m);
                    speed(east, north)
                });
                speeds.fold(0.0, f64::max)
            }
        }
    }

    /// The row that holds at an altitude, m; its first altitude belongs to it.
    #[inline]
    pub fn row(&self, altitude_m: f64) -> Row {
        match self {
            Self::Calm => [0.0; 5],
            Self::Constant {
                eastward_m_s,
                northward_m_s,
            } => [0.0, *eastward_m_s, *northward_m_s, 0.0, 0.0],
            Self::Table(table) => table.row(altitude_m),
        }
    }

    /// Eastward and northward wind, m/s, at an altitude, m, by a row, also beyond its end.
    #[inline]
    pub fn east_north_m_s<S: Scalar>(
        [z, east, north, east_slope, north_slope]: [S; 5],
        altitude_m: S,
    ) -> [S; 2] {
        let above = altitude_m - z;
        [east + above * east_slope, north + above * north_slope]
    }

    /// Altitudes at which the wind has a kink, m, ascending.
    pub fn boundaries_m(&self) -> &[f64] {
        match self {
            Self::Table(table) => &table.altitudes_m,
            Self::Calm | Self::Constant { .. } => &[],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(wind: &Wind, altitude_m: f64) -> [f64; 2] {
        Wind::east_north_m_s(wind.row(altitude_m), altitude_m)
    }

    fn table(rows: &[[f64; 3]]) -> Result<Wind, Vec<RowFault>> {
        let rows: Vec<Vec<f64>> = rows.iter().map(|r| r.to_vec()).collect();
        Ok(Wind::Table(WindTable::try_new(&rows)?))
    }

    #[test]
    fn linear_within_and_held_beyond() {
        let wind = table(&[[0.0, 5.0, 0.0], [1000.0, 15.0, -2.0], [2000.0, 10.0, 0.0]]).unwrap();
        // 250 m: 5 + 10/4, −2/4
        assert_eq!(at(&wind, 250.0), [7.5, -0.5]);
        assert_eq!(at(&wind, 1500.0), [12.5, -1.0]);
        assert_eq!(at(&wind, -100.0), [5.0, 0.0]);
        assert_eq!(at(&wind, 9e4), [10.0, 0.0]);
    }

    #[test]
    fn one_row_is_a_constant_wind() {
        let wind = table(&[[0.0, 5.0, 1.0]]).unwrap();
        assert_eq!(at(&wind, 12345.0), [5.0, 1.0]);
        assert_eq!(at(&Wind::Calm, 0.0), [0.0, 0.0]);
    }

    #[test]
    fn faults_name_row_and_column() {
        let faults = table(&[[1000.0, 5.0, 0.0], [0.0, f64::INFINITY, 0.0]]).unwrap_err();
        let text: Vec<String> = faults.iter().map(ToString::to_string).collect();
        assert_eq!(
            text[0],
            "row 2: altitude_m: got 0 m, must be above 1000 m of the row before"
        );
        assert_eq!(text[1], "row 2: eastward_m_s: got inf m/s, must be finite");
    }
}
