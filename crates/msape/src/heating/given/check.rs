//! Checks the rows of a case and builds the table of heat fluxes.
//!
//! ```text
//! rows (V, ρ, q) → q[i, j] at V[i], ρ[j]
//! ```
//!
//! with the speed V in m/s, the density ρ in kg/m³ and the heat flux q in W/m².
//!
//! # Valid
//! A whole grid: each speed with each density, once.
//!
//! # References
//! - Own convention.

use super::{Fluxes, GivenHeating};
use crate::aero::table::Extrapolation;
use crate::units::told;

/// Largest number of reported faults of one table, assumed: as many as a person reads.
const MOST_FAULTS: usize = 20;

/// A row of a table of the case: its number there, from 1, and its numbers.
pub(super) type Numbered<'a> = (usize, &'a [f64]);

impl GivenHeating {
    /// Rows of speed, m/s, density, kg/m³, convective and, in all rows or in none, radiative heat flux, W/m², in any order; the key
    /// is that of the table in the case.
    ///
    /// # Errors
    /// Every fault of the rows, up to twenty.
    pub fn try_new(
        key: &'static str,
        rows: &[Vec<f64>],
        extrapolation: Extrapolation,
    ) -> Result<GivenHeating, Vec<String>> {
        let numbered = rows.iter().enumerate();
        let rows: Vec<Numbered> = numbered.map(|(i, row)| (i + 1, row.as_slice())).collect();
        GivenHeating::of_rows(key, &rows, extrapolation)
    }

    /// Heating by some of the rows of the case, each with its number there.
    pub(super) fn of_rows(
        key: &'static str,
        rows: &[Numbered],
        extrapolation: Extrapolation,
    ) -> Result<GivenHeating, Vec<String>> {
        let column = |i: usize| rows.iter().filter_map(move |(_, row)| row.get(i).copied());
        let axis = |i: usize| {
            let mut axis: Vec<f64> = column(i).collect();
            axis.sort_unstable_by(f64::total_cmp);
            axis.dedup();
            axis
        };
        let (speeds_m_s, densities_kg_m3) = (axis(0), axis(1));
        let mut faults = Vec::new();
        for (one, more, axis, unit) in [
            ("speed", "speeds", &speeds_m_s, "m/s"),
            ("density", "densities", &densities_kg_m3, "kg/m^3"),
        ] {
            let got = match axis.as_slice() {
                [] => "no rows".to_owned(),
                [only] => format!("one {one}, {} {unit}", told(*only)),
                _ => continue,
            };
            faults.push(format!(
                "got {got}, must be 2 {more} or more: heat fluxes are interpolated over both"
            ));
        }
        let radiation = column(3).count();
        if radiation != 0 && radiation != rows.len() {
            faults.push(format!(
                "radiative_w_m2 stands in {radiation} of {} rows, must stand in all or in none",
                rows.len()
            ));
        }
        if !faults.is_empty() {
            return Err(faults);
        }
        let (wide, long) = (densities_kg_m3.len(), speeds_m_s.len());
        // a grid that the rows cannot fill is not laid out
        if wide.saturating_mul(long) > rows.len() {
            faults.extend(hole(rows, &speeds_m_s, &densities_kg_m3));
            return Err(faults);
        }
        let place = |row: &[f64]| {
            let of = |axis: &[f64], i: usize| {
                let wanted = row.get(i).copied().unwrap_or_default();
                axis.partition_point(|node| *node < wanted)
            };
            of(&speeds_m_s, 0) * wide + of(&densities_kg_m3, 1)
        };
        let mut filled = vec![false; wide * long];
        let mut columns = [vec![0.0; wide * long], vec![0.0; wide * long]];
        for (number, row) in rows {
            let place = place(row);
            match filled.get_mut(place) {
                Some(before) if !*before => *before = true,
                _ if faults.len() < MOST_FAULTS => {
                    let at = row.iter().take(2).map(|x| told(*x)).collect::<Vec<_>>();
                    faults.push(format!(
                        "row {number}: the speed and density {} kg/m^3 stand twice",
                        at.join(" m/s, ")
                    ));
                }
                _ => {}
            }
            for (column, flux) in columns.iter_mut().zip(row.iter().skip(2)) {
                if let Some(cell) = column.get_mut(place) {
                    *cell = *flux;
                }
            }
        }
        if !faults.is_empty() {
            return Err(faults);
        }
        let [convective, radiative] = columns.map(|values| Fluxes::new(values, &densities_kg_m3));
        Ok(GivenHeating {
            key,
            extrapolation,
            convective,
            radiative: (radiation > 0).then_some(radiative),
            speeds_m_s,
            densities_kg_m3,
        })
    }
}

/// The first place of the grid that has no row.
fn hole(rows: &[Numbered], speeds: &[f64], densities: &[f64]) -> Option<String> {
    let mut pairs: Vec<[f64; 2]> = rows
        .iter()
        .filter_map(|(_, row)| Some([*row.first()?, *row.get(1)?]))
        .collect();
    pairs.sort_unstable_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    pairs.dedup();
    let mut grid = speeds
        .iter()
        .flat_map(|speed| densities.iter().map(move |density| [*speed, *density]));
    let mut pairs = pairs.into_iter();
    let [speed, density] = grid.find(|wanted| pairs.next().as_ref() != Some(wanted))?;
    Some(format!(
        "no row for {} m/s and {} kg/m^3: each of the {} speeds needs each of the {} densities",
        told(speed),
        told(density),
        speeds.len(),
        densities.len()
    ))
}
