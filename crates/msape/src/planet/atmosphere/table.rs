//! Atmosphere as a table: of a data file, or of a user.
//!
//! ```text
//! ln ρ = ln ρᵢ + (z − zᵢ) (ln ρᵢ₊₁ − ln ρᵢ)/(zᵢ₊₁ − zᵢ)        ln (p/ρ) the same, T and γ linear in z
//! p = ρ R T, γ = γ(T)                                           where none is given; R and γ of the planet's gas
//! ```
//!
//! with ρ in kg/m³, p in Pa, T in K, z in m, R in J/(kg K), γ the ratio of the heat capacities.
//! Beyond the ends ln ρ continues with its last slope, but is held where density would grow with height; p/ρ, T and γ
//! are held.
//! Without temperatures, those of the planet's own atmosphere are used.
//!
//! # Valid
//! Between the first and the last altitude. Mean free path, and γ where it is not given, are those of the planet's gas.
//!
//! # References
//! - Own convention; each data file names its own.

mod file;
mod row;

use super::{Air, OwnTemperature, Piece, PlanetAir};
use crate::planet::gas::{GAS_CONSTANT_J_KMOL_K, Gas};
use crate::planet::rows::{self, Column, RowFault};
use numerics::math;
use numerics::scalar::Scalar;
use row::Row;

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

/// Molar masses that a gas can have, kg/kmol. The least is that of atomic hydrogen, 1.008 rounded down. The greatest is assumed:
/// sulfur hexafluoride, among the heaviest gases by which facilities replace air, has 146, and none of a planet comes near; what
/// is beyond is a wrong unit, which is a factor of ten or more.
const POSSIBLE_KG_KMOL: [f64; 2] = [1.0, 200.0];

/// The atmosphere; each interval of the table is a piece of its own.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    intervals: Vec<Interval>,
    boundaries_m: Vec<f64>,
    valid_m: (f64, f64),
    assumed_above_m: Option<f64>,
    /// Whether density is held below and above.
    held: [bool; 2],
    gas: Gas,
    /// Temperature model, where the rows give no temperature.
    temperature: Option<OwnTemperature>,
    /// Altitude, m, and standard deviation of density over density, where the source gives it.
    density_sigma: Vec<[f64; 2]>,
}

#[derive(Clone, Debug, PartialEq)]
struct Interval {
    from_m: f64,
    ln_density: Line,
    temperature_k: Option<Line>,
    ln_pressure_over_density: Option<Line>,
    heat_capacity_ratio: Option<Line>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Line {
    value: f64,
    slope_per_m: f64,
}

impl Line {
    fn between(dz: f64, from: f64, to: f64) -> Self {
        Self {
            value: from,
            slope_per_m: (to - from) / dz,
        }
    }
}

impl Table {
    /// The atmosphere of rows of altitude, m, density, kg/m³, temperature, K, pressure, Pa, the last two optional, with the air of
    /// the planet for what is not given; or all that is wrong with them. Of density, temperature and pressure one may be 0 in
    /// every row: it is that of the other two in the planet's gas.
    pub fn try_new(rows: &[Vec<f64>], air: PlanetAir) -> Result<Self, Vec<RowFault>> {
        let given = |column: usize| {
            rows.iter()
                .any(|row| row.get(column).is_some_and(|x| *x != 0.0))
        };
        let given = [given(1), given(2), given(3)];
        let mut columns = COLUMNS;
        let two = given.iter().filter(|given| **given).count() >= 2;
        for (column, given) in columns.iter_mut().skip(1).zip(given) {
            if !given && two {
                column.rule = rows::Rule::Finite;
            }
        }
        let shape = rows::Shape {
            fewest_rows: 2,
            fewest_columns: 2,
        };
        rows::check(rows, &columns, shape)?;
        let PlanetAir { gas, temperature } = air;
        let rows: Vec<Row> = rows
            .iter()
            .filter_map(|cells| Row::of_cells(cells, given, gas.gas_constant_j_kg_k))
            .collect();
        let molar_masses = rows.iter().map(Row::molar_mass_kg_kmol).enumerate();
        let [lightest, heaviest] = POSSIBLE_KG_KMOL;
        let faults: Vec<RowFault> = molar_masses
            .filter_map(|(index, mass)| {
                let molar_mass_kg_kmol = mass.filter(|m| !(lightest..=heaviest).contains(m))?;
                Some(RowFault::ImpossibleGas {
                    row: index + 1,
                    molar_mass_kg_kmol,
                    lightest,
                    heaviest,
                })
            })
            .take(rows::MOST_FAULTS)
            .collect();
        if !faults.is_empty() {
            return Err(faults);
        }
        Ok(Self::of_rows(&rows, gas, Some(temperature)))
    }

    fn of_rows(rows: &[Row], gas: Gas, temperature: Option<OwnTemperature>) -> Self {
        let mut intervals: Vec<Interval> = rows
            .windows(2)
            .filter_map(|pair| match pair {
                [a, b] => Some(Interval::between(a, b)),
                _ => None,
            })
            .collect();
        let valid_m = match rows {
            [first, .., last] => (first.altitude_m, last.altitude_m),
            _ => (0.0, 0.0),
        };
        let rises = |interval: Option<&Interval>| {
            interval.is_some_and(|interval| interval.ln_density.slope_per_m > 0.0)
        };
        let held = [rises(intervals.first()), rises(intervals.last())];
        // A level interval beyond the ends of a table that rises there.
        if let (true, Some(last), Some(row)) = (held[1], intervals.last().cloned(), rows.last()) {
            intervals.push(last.level_at(row));
        }
        let mut boundaries_m: Vec<f64> = intervals.iter().skip(1).map(|i| i.from_m).collect();
        if let (true, Some(first), Some(row)) = (held[0], intervals.first().cloned(), rows.first())
        {
            intervals.insert(0, first.level_at(row));
            boundaries_m.insert(0, row.altitude_m);
        }
        Self {
            boundaries_m,
            intervals,
            valid_m,
            held,
            gas,
            temperature,
            density_sigma: Vec::new(),
            assumed_above_m: None,
        }
    }

    /// Altitudes of the rows within, m.
    pub fn boundaries_m(&self) -> &[f64] {
        &self.boundaries_m
    }

    /// First and last altitude of the table, m.
    pub fn valid_m(&self) -> (f64, f64) {
        self.valid_m
    }

    /// Whether density is held below and above the table, where it would else grow with height.
    pub fn is_held(&self) -> [bool; 2] {
        self.held
    }

    /// Altitude above which the rows are assumed, m, where a part is.
    pub fn assumed_above_m(&self) -> Option<f64> {
        self.assumed_above_m
    }

    /// The gas of what the rows leave open.
    pub fn gas(&self) -> &Gas {
        &self.gas
    }

    /// Whether the rows give the temperature.
    pub fn has_temperature(&self) -> bool {
        self.intervals.iter().all(|i| i.temperature_k.is_some())
    }

    /// Least and largest molar mass from density, temperature and pressure, kg/kmol; `None` where one is not given.
    pub fn molar_masses_kg_kmol(&self) -> Option<[f64; 2]> {
        let of = |interval: &Interval| {
            let quotient = math::exp(interval.ln_pressure_over_density?.value);
            Some(GAS_CONSTANT_J_KMOL_K * interval.temperature_k?.value / quotient)
        };
        let all: Option<Vec<f64>> = self.intervals.iter().map(of).collect();
        let all = all?;
        let least = all.iter().copied().fold(f64::INFINITY, f64::min);
        Some([least, all.iter().copied().fold(0.0, f64::max)])
    }

    /// Standard deviation of density over density at an altitude, m, linear between rows and held beyond them; `None` where the
    /// source gives none.
    pub fn density_sigma(&self, altitude_m: f64) -> Option<f64> {
        let rows = &self.density_sigma;
        let above = rows.partition_point(|[z, _]| *z <= altitude_m);
        match (
            above.checked_sub(1).and_then(|n| rows.get(n)),
            rows.get(above),
        ) {
            (Some([z_a, a]), Some([z_b, b])) => {
                Some(a + (altitude_m - z_a) / (z_b - z_a) * (b - a))
            }
            (Some([_, only]), None) | (None, Some([_, only])) => Some(*only),
            (None, None) => None,
        }
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

    /// An altitude, m, kept within the table.
    #[inline]
    fn held_m<S: Scalar>(&self, altitude_m: S) -> S {
        let (first_m, last_m) = self.valid_m;
        altitude_m.clamp(S::constant(first_m), S::constant(last_m))
    }

    /// A column of one interval at an altitude within the table, m; all rows have the same columns.
    #[inline]
    fn line_at<S: Scalar>(
        &self,
        piece: &Piece<S::Value>,
        held_m: S,
        of: fn(&Interval) -> Option<Line>,
    ) -> Option<S> {
        self.intervals.first().and_then(of)?;
        let [from_m, value, slope_per_m]: [S; 3] = self.of_interval(piece, |i| {
            let [value, slope] = of(i).map_or([0.0; 2], |l| [l.value, l.slope_per_m]);
            [i.from_m, value, slope]
        });
        Some((held_m - from_m) * slope_per_m + value)
    }

    /// Everything of one interval.
    #[inline]
    pub fn air_in<S: Scalar>(&self, piece: &Piece<S::Value>, altitude_m: S) -> Air<S> {
        let held_m = self.held_m(altitude_m);
        let line = |of| self.line_at(piece, held_m, of);
        let temperature_k = line(|i| i.temperature_k).unwrap_or_else(|| self.lent_k(altitude_m));
        self.gas.air(
            self.density_in(piece, altitude_m),
            temperature_k,
            line(|i| i.ln_pressure_over_density).map(S::exp),
            line(|i| i.heat_capacity_ratio),
        )
    }

    /// Speed of sound of one interval, m/s.
    #[inline]
    pub fn speed_of_sound_in<S: Scalar>(&self, piece: &Piece<S::Value>, altitude_m: S) -> S {
        self.air_in(piece, altitude_m).speed_of_sound_m_s
    }

    /// Temperature of the planet's own atmosphere, K, where the rows give none.
    #[inline]
    fn lent_k<S: Scalar>(&self, altitude_m: S) -> S {
        match &self.temperature {
            Some(own) => own.kinetic_k(altitude_m),
            None => S::constant(0.0),
        }
    }

    /// Temperature at an altitude, m, the interval chosen by it, in K.
    pub fn temperature_k<S: Scalar>(&self, altitude_m: S) -> S {
        if !self.has_temperature() {
            return self.lent_k(altitude_m);
        }
        let held_m = self.held_m(altitude_m);
        let [from_m, value, slope_per_m] = held_m.lookup(|z| {
            let layer = self.boundaries_m.partition_point(|boundary| *boundary <= z);
            let interval = self.intervals.get(layer).or(self.intervals.last());
            let line = interval.and_then(|i| Some((i.from_m, i.temperature_k?)));
            line.map_or([0.0; 3], |(from_m, line)| {
                [from_m, line.value, line.slope_per_m]
            })
        });
        (held_m - from_m) * slope_per_m + value
    }
}

impl Interval {
    fn between(a: &Row, b: &Row) -> Self {
        let dz = b.altitude_m - a.altitude_m;
        let line = |a: Option<f64>, b: Option<f64>| Some(Line::between(dz, a?, b?));
        let quotient = |row: &Row| Some(math::ln(row.pressure_pa?) - math::ln(row.density_kg_m3));
        Self {
            from_m: a.altitude_m,
            ln_density: Line::between(dz, math::ln(a.density_kg_m3), math::ln(b.density_kg_m3)),
            temperature_k: line(a.temperature_k, b.temperature_k),
            ln_pressure_over_density: line(quotient(a), quotient(b)),
            heat_capacity_ratio: line(a.heat_capacity_ratio, b.heat_capacity_ratio),
        }
    }

    /// Constant columns: the values at one row, at every altitude.
    fn level_at(&self, row: &Row) -> Self {
        let level = |line: Line| Line {
            value: line.value + (row.altitude_m - self.from_m) * line.slope_per_m,
            slope_per_m: 0.0,
        };
        Self {
            from_m: row.altitude_m,
            ln_density: level(self.ln_density),
            temperature_k: self.temperature_k.map(level),
            ln_pressure_over_density: self.ln_pressure_over_density.map(level),
            heat_capacity_ratio: self.heat_capacity_ratio.map(level),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planet::atmosphere::{Atmosphere, us_1976::UsStandard1976};
    use std::sync::Arc;

    fn standard() -> PlanetAir {
        UsStandard1976::parse(include_str!("../../../data/atmospheres/us-1976.toml").into())
            .unwrap()
            .1
            .planet_air()
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
