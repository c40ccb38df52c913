//! Conditions at the wall in time.
//!
//! ```text
//! y(t) = yᵢ + (t − tᵢ) (yᵢ₊₁ − yᵢ) / (tᵢ₊₁ − tᵢ)
//! ```
//!
//! of pressure in Pa, transfer coefficient in kg/(m² s), recovery enthalpy in J/kg, radiative flux in W/m², wall temperature in
//! K and recession in m/s. Chemistry is that of the row before.
//!
//! # Valid
//! From the first row on. After the last row of a boundary layer nothing reaches the wall, which only radiates; a held wall stays held.
//!
//! # References
//! - \[pato\]: the columns of its boundary conditions.

use crate::fault::{Fault, check_row};

/// Conditions at one time: those of the boundary layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Heating {
    /// Pressure, Pa.
    pub pressure_pa: f64,
    /// Transfer coefficient C_H without blowing, kg/(m² s).
    pub transfer_kg_m2s: f64,
    /// Recovery enthalpy against the elements at 298.15 K, J/kg.
    pub recovery_j_kg: f64,
    /// Radiative heat flux to the wall, W/m².
    pub radiative_w_m2: f64,
    /// Whether the boundary layer reaches the wall; otherwise it only radiates.
    pub chemistry: bool,
}

/// Conditions at one time: a wall that follows a measurement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held {
    /// Temperature of the wall, K.
    pub temperature_k: f64,
    /// Pressure, Pa.
    pub pressure_pa: f64,
    /// Speed of the wall into the solid, m/s.
    pub recession_m_s: f64,
}

/// Conditions at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Wall {
    /// Heated by a boundary layer.
    Heated(Heating),
    /// Held at a temperature.
    Held(Held),
}

/// Rows in time.
#[derive(Clone, Debug, PartialEq)]
enum Rows {
    Heated(Vec<Heating>),
    Held(Vec<Held>),
}

/// Conditions at the wall in time.
#[derive(Clone, Debug, PartialEq)]
pub struct Environment {
    times_s: Vec<f64>,
    bends_s: Vec<f64>,
    rows: Rows,
}

const OF: &str = "environment";

fn check_times(times: &[f64]) -> Result<(), Fault> {
    if times.is_empty() {
        return Err(Fault::TooFew {
            of: OF,
            key: "t_s",
            rows: 0,
            least: 1,
        });
    }
    for (i, (t, row)) in times.iter().zip(1..).enumerate() {
        if !t.is_finite() {
            return Err(Fault::NotFinite {
                of: OF,
                key: "t_s",
                row,
            });
        }
        if i.checked_sub(1)
            .and_then(|i| times.get(i))
            .is_some_and(|before| t <= before)
        {
            return Err(Fault::Unsorted {
                of: OF,
                key: "t_s",
                row,
            });
        }
    }
    Ok(())
}

/// Distance of a row from the line between its neighbors, as a share of the largest value, from which on it is a bend. Assumed.
const BEND: f64 = 0.02;

/// Times of the first and last row, of the bends of the columns, and of the changes of a switch.
fn bends(times_s: &[f64], columns: &[Vec<f64>], switches: &[bool]) -> Vec<f64> {
    let most: Vec<f64> = columns
        .iter()
        .map(|column| column.iter().fold(0.0, |most: f64, y| most.max(y.abs())))
        .collect();
    let is_bend = |i: usize| {
        let switched = i > 0 && switches.get(i) != switches.get(i - 1);
        let ([Some(t0), Some(t), Some(t1)], false) = (
            [i.checked_sub(1), Some(i), i.checked_add(1)].map(|i| times_s.get(i?)),
            switched,
        ) else {
            return true;
        };
        let share = (t - t0) / (t1 - t0);
        columns.iter().zip(&most).any(|(y, most)| {
            let between = y[i - 1] + share * (y[i + 1] - y[i - 1]);
            (y[i] - between).abs() > BEND * most
        })
    };
    times_s
        .iter()
        .enumerate()
        .filter(|(i, _)| is_bend(*i))
        .map(|(_, t)| *t)
        .collect()
}

impl Environment {
    /// Heating by a boundary layer: rows of time, s, and conditions.
    ///
    /// # Errors
    /// Times that do not ascend; numbers that are not finite; negative pressure, transfer or radiation.
    pub fn heated(rows: &[(f64, Heating)]) -> Result<Self, Fault> {
        let times_s: Vec<f64> = rows.iter().map(|(t, _)| *t).collect();
        check_times(&times_s)?;
        for ((_, heating), row) in rows.iter().zip(1..) {
            check_row(
                OF,
                row,
                &[
                    ("p_Pa", heating.pressure_pa, 0.0),
                    ("CH_kg_m2s", heating.transfer_kg_m2s, 0.0),
                    ("h_r_J_kg", heating.recovery_j_kg, f64::MIN),
                    ("q_rad_W_m2", heating.radiative_w_m2, 0.0),
                ],
            )?;
        }
        let column = |of: fn(&Heating) -> f64| rows.iter().map(|(_, row)| of(row)).collect();
        let columns = [
            column(|row| row.transfer_kg_m2s),
            column(|row| row.transfer_kg_m2s * row.recovery_j_kg),
            column(|row| row.radiative_w_m2),
        ];
        let switches: Vec<bool> = rows.iter().map(|(_, row)| row.chemistry).collect();
        Ok(Self {
            bends_s: bends(&times_s, &columns, &switches),
            times_s,
            rows: Rows::Heated(rows.iter().map(|(_, row)| *row).collect()),
        })
    }

    /// A wall held at temperatures: rows of time, s, and conditions.
    ///
    /// # Errors
    /// Times that do not ascend; numbers that are not finite; a temperature of zero, negative pressure or recession.
    pub fn held(rows: &[(f64, Held)]) -> Result<Self, Fault> {
        let times_s: Vec<f64> = rows.iter().map(|(t, _)| *t).collect();
        check_times(&times_s)?;
        for ((_, held), row) in rows.iter().zip(1..) {
            check_row(
                OF,
                row,
                &[
                    ("T_K", held.temperature_k, f64::MIN_POSITIVE),
                    ("p_Pa", held.pressure_pa, 0.0),
                    ("recession_m_s", held.recession_m_s, 0.0),
                ],
            )?;
        }
        let column = |of: fn(&Held) -> f64| rows.iter().map(|(_, row)| of(row)).collect();
        let columns = [
            column(|row| row.temperature_k),
            column(|row| row.recession_m_s),
        ];
        Ok(Self {
            bends_s: bends(&times_s, &columns, &[]),
            times_s,
            rows: Rows::Held(rows.iter().map(|(_, row)| *row).collect()),
        })
    }

    /// Times of the rows, s.
    pub fn times_s(&self) -> &[f64] {
        &self.times_s
    }

    /// Next time after another at which a step has to end, s: a row that bends by more than the control of the error should
    /// meet unprepared.
    pub(crate) fn next_bend_s(&self, time_s: f64) -> f64 {
        let next = self.bends_s.partition_point(|t| *t <= time_s);
        self.bends_s.get(next).copied().unwrap_or(f64::INFINITY)
    }

    /// Conditions at a time, s, of a step that began at `since_s`, whose chemistry it has.
    pub fn at(&self, time_s: f64, since_s: f64) -> Wall {
        let before = |time: f64| {
            self.times_s
                .partition_point(|t| *t <= time)
                .saturating_sub(1)
        };
        let since = before(since_s);
        let row = before(time_s);
        let next = (row + 1).min(self.times_s.len().saturating_sub(1));
        let (t0, t1) = match (self.times_s.get(row), self.times_s.get(next)) {
            (Some(a), Some(b)) => (*a, *b),
            _ => (0.0, 0.0),
        };
        let share = if t1 > t0 {
            ((time_s - t0) / (t1 - t0)).clamp(0.0, 1.0)
        } else {
            0.0
        };
        let mix = |a: f64, b: f64| a + share * (b - a);
        match &self.rows {
            Rows::Heated(rows) => {
                let radiating = |pressure_pa: f64| {
                    Wall::Heated(Heating {
                        pressure_pa,
                        transfer_kg_m2s: 0.0,
                        recovery_j_kg: 0.0,
                        radiative_w_m2: 0.0,
                        chemistry: false,
                    })
                };
                let (Some(a), Some(b)) = (rows.get(row), rows.get(next)) else {
                    return radiating(0.0);
                };
                if self.times_s.last().is_some_and(|last| since_s >= *last) {
                    return radiating(b.pressure_pa);
                }
                Wall::Heated(Heating {
                    pressure_pa: mix(a.pressure_pa, b.pressure_pa),
                    transfer_kg_m2s: mix(a.transfer_kg_m2s, b.transfer_kg_m2s),
                    recovery_j_kg: mix(a.recovery_j_kg, b.recovery_j_kg),
                    radiative_w_m2: mix(a.radiative_w_m2, b.radiative_w_m2),
                    chemistry: rows.get(since).is_some_and(|row| row.chemistry),
                })
            }
            Rows::Held(rows) => {
                let (Some(a), Some(b)) = (rows.get(row), rows.get(next)) else {
                    return Wall::Held(Held {
                        temperature_k: 0.0,
                        pressure_pa: 0.0,
                        recession_m_s: 0.0,
                    });
                };
                Wall::Held(Held {
                    temperature_k: mix(a.temperature_k, b.temperature_k),
                    pressure_pa: mix(a.pressure_pa, b.pressure_pa),
                    recession_m_s: mix(a.recession_m_s, b.recession_m_s),
                })
            }
        }
    }
}
