//! Heat capacity, enthalpy and conductivity of a solid between virgin and char, over temperature.
//!
//! ```text
//! e(z, T) = z ρᵥ hᵥ(T) + (1 − z) ρ_c h_c(T)          z = (ρ − ρ_c) / (ρᵥ − ρ_c)
//! h(T)    = h(298.15 K) + ∫ c_p dT
//! k(z, T) = τ kᵥ(T) + (1 − τ) k_c(T)                 τ = z ρᵥ / ρ
//! ```
//!
//! with e in J/m³, ρ in kg/m³, h in J/kg, c_p in J/(kg K), k in W/(m K); z is the undecomposed share, τ the virgin mass
//! fraction. The enthalpy per volume is linear in density, so that the heat of pyrolysis is (ρᵥ hᵥ − ρ_c h_c) / (ρᵥ − ρ_c).
//!
//! # Valid
//! Between the first and last temperature of the tables; beyond, heat capacity and conductivity are held.
//!
//! # References
//! - \[pato\], \[covington-2008\].

use crate::fault::{Fault, column};

/// Temperature at which the elements have no enthalpy, K.
pub const REFERENCE_TEMPERATURE_K: f64 = 298.15;

/// One state of a solid: its density, enthalpy of formation and tables.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// Density, kg/m³.
    pub density_kg_m3: f64,
    /// Enthalpy at 298.15 K against the elements, J/kg.
    pub formation_j_kg: f64,
    /// Rows of temperature, K, and heat capacity, J/(kg K).
    pub specific_heat: Vec<[f64; 2]>,
    /// Rows of temperature, K, and conductivity, W/(m K).
    pub conductivity: Vec<[f64; 2]>,
    /// Emissivity.
    pub emissivity: f64,
    /// Absorptivity for radiation of the shock layer.
    pub absorptivity: f64,
}

impl State {
    fn check(&self, of: &'static str) -> Result<(), Fault> {
        column(of, "specific_heat", &self.specific_heat, f64::MIN_POSITIVE)?;
        column(of, "conductivity", &self.conductivity, f64::MIN_POSITIVE)?;
        for (key, value, most) in [
            ("density_kg_m3", self.density_kg_m3, f64::MAX),
            ("emissivity", self.emissivity, 1.0),
            ("absorptivity", self.absorptivity, 1.0),
        ] {
            let least = if key == "density_kg_m3" {
                f64::MIN_POSITIVE
            } else {
                0.0
            };
            if !(least..=most).contains(&value) {
                return Err(Fault::Range {
                    of,
                    key,
                    value,
                    least,
                    most,
                });
            }
        }
        if !self.formation_j_kg.is_finite() {
            return Err(Fault::NotFinite {
                of,
                key: "formation_j_kg",
                row: 0,
            });
        }
        Ok(())
    }
}

/// Values of both states between two temperatures, per volume where they are enthalpies.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Row {
    /// Temperature at which the row begins, K.
    t: f64,
    /// Virgin and char: enthalpy, J/m³, heat capacity, J/(m³ K), and its slope.
    enthalpy: [[f64; 3]; 2],
    /// Virgin and char: conductivity, W/(m K), and its slope.
    conductivity: [[f64; 2]; 2],
}

/// Values at a temperature, virgin and char.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Values {
    /// Enthalpy per volume, J/m³.
    pub enthalpy_j_m3: [f64; 2],
    /// Heat capacity per volume, J/(m³ K).
    pub heat_capacity_j_m3k: [f64; 2],
    /// Conductivity, W/(m K).
    pub conductivity_w_mk: [f64; 2],
    /// Slope of the conductivity, W/(m K²).
    pub conductivity_slope: [f64; 2],
}

/// A solid between two states.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    /// Virgin state.
    pub virgin: State,
    /// Char; the virgin state of a solid that does not react.
    pub char: State,
    rows: Vec<Row>,
}

/// Value and slope of a table of rows at a temperature, held beyond its ends.
fn linear(rows: &[[f64; 2]], t: f64) -> [f64; 2] {
    let after = rows.partition_point(|row| row[0] <= t);
    match (
        after.checked_sub(1).and_then(|i| rows.get(i)),
        rows.get(after),
    ) {
        (Some([t0, y0]), Some([t1, y1])) => {
            let slope = (y1 - y0) / (t1 - t0);
            [y0 + slope * (t - t0), slope]
        }
        (Some([_, y]), None) | (None, Some([_, y])) => [*y, 0.0],
        (None, None) => [0.0; 2],
    }
}

impl Solid {
    /// A solid that decomposes from one state to the other.
    ///
    /// # Errors
    /// A table that is empty, not ascending or not finite, and values beyond their range.
    pub fn try_new(virgin: State, char: State) -> Result<Self, Fault> {
        virgin.check("virgin")?;
        char.check("char")?;
        if char.density_kg_m3 > virgin.density_kg_m3 {
            return Err(Fault::Range {
                of: "char",
                key: "density_kg_m3",
                value: char.density_kg_m3,
                least: f64::MIN_POSITIVE,
                most: virgin.density_kg_m3,
            });
        }
        let tables = [
            &virgin.specific_heat,
            &virgin.conductivity,
            &char.specific_heat,
            &char.conductivity,
        ];
        let mut knots: Vec<f64> = tables
            .iter()
            .flat_map(|rows| rows.iter().map(|row| row[0]))
            .collect();
        knots.push(REFERENCE_TEMPERATURE_K);
        knots.sort_by(f64::total_cmp);
        knots.dedup();
        // A row before the first knot, in which everything is held.
        knots.insert(0, 0.0);
        let states = [&virgin, &char];
        let mut rows: Vec<Row> = Vec::with_capacity(knots.len());
        for &t in &knots {
            let mut row = Row {
                t,
                ..Row::default()
            };
            for (i, state) in states.into_iter().enumerate() {
                let [c, slope] = linear(&state.specific_heat, t);
                let rho = state.density_kg_m3;
                let h = rows.last().map_or(0.0, |before| {
                    let [h, c, slope] = before.enthalpy[i];
                    let dt = t - before.t;
                    h + dt * (c + 0.5 * slope * dt)
                });
                row.enthalpy[i] = [h, rho * c, rho * slope];
                row.conductivity[i] = linear(&state.conductivity, t);
            }
            rows.push(row);
        }
        let mut solid = Self { virgin, char, rows };
        let at = solid.at(REFERENCE_TEMPERATURE_K).enthalpy_j_m3;
        let formation =
            [&solid.virgin, &solid.char].map(|state| state.density_kg_m3 * state.formation_j_kg);
        for row in &mut solid.rows {
            for i in 0..2 {
                row.enthalpy[i][0] += formation[i] - at[i];
            }
        }
        Ok(solid)
    }

    /// A solid that does not react.
    ///
    /// # Errors
    /// As [`Solid::try_new`].
    pub fn inert(state: State) -> Result<Self, Fault> {
        Self::try_new(state.clone(), state)
    }

    /// Values of both states at a temperature, K.
    #[inline]
    pub fn at(&self, temperature_k: f64) -> Values {
        let after = self.rows.partition_point(|row| row.t <= temperature_k);
        let Some(row) = self.rows.get(after.saturating_sub(1)) else {
            return Values::default();
        };
        let dt = temperature_k - row.t;
        Values {
            enthalpy_j_m3: row
                .enthalpy
                .map(|[h, c, slope]| h + dt * (c + 0.5 * slope * dt)),
            heat_capacity_j_m3k: row.enthalpy.map(|[_, c, slope]| c + slope * dt),
            conductivity_w_mk: row.conductivity.map(|[k, slope]| k + slope * dt),
            conductivity_slope: row.conductivity.map(|[_, slope]| slope),
        }
    }

    /// Density at an undecomposed share, kg/m³.
    #[inline]
    pub fn density_kg_m3(&self, share: f64) -> f64 {
        let [v, c] = [self.virgin.density_kg_m3, self.char.density_kg_m3];
        c + share * (v - c)
    }

    /// Virgin mass fraction at an undecomposed share.
    #[inline]
    pub fn virgin_fraction(&self, share: f64) -> f64 {
        share * self.virgin.density_kg_m3 / self.density_kg_m3(share)
    }

    /// Lowest and highest temperature that every table covers, K.
    pub fn covered_k(&self) -> [f64; 2] {
        let states = [&self.virgin, &self.char];
        let tables = states
            .iter()
            .flat_map(|state| [&state.specific_heat, &state.conductivity]);
        tables.fold([0.0, f64::INFINITY], |[low, high], rows| {
            // One row is a constant, not a range.
            match rows.as_slice() {
                [first, .., last] => [low.max(first[0]), high.min(last[0])],
                _ => [low, high],
            }
        })
    }
}
