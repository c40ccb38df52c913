//! Chemistry of the wall: the char that the boundary layer takes away, the enthalpy of the wall's gas, and blowing.
//!
//! ```text
//! B'_g = ṁ_g / C_H'      B'_c = ṁ_c / C_H' = f(p, B'_g, T_w)      h_w = f(p, B'_g, T_w)
//! C_H' = C_H ln(1 + 2 λ B') / (2 λ B'),   B' = B'_g + B'_c
//!      = C_H x / (eˣ − 1),                x  = 2 λ (ṁ_g + ṁ_c) / C_H
//! ```
//!
//! with C_H in kg/(m² s), h_w in J per kilogram of wall gas, char included. Between the sheets of pressure the share of char in
//! the wall's gas, B'_c / (1 + B'_g + B'_c), and h_w are linear in 1/p, because the vapor pressure depends on T alone.
//!
//! # Valid
//! Equilibrium at the wall, equal diffusion of all species. Beyond the table its ends hold.
//!
//! # References
//! - \[pato\]; the blowing of \[covington-2008\].

use crate::fault::{Fault, check_row};
use crate::gas::{distinct, place};
use numerics::math;

/// A row of the table of the wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallRow {
    /// Pressure, Pa.
    pub pressure_pa: f64,
    /// Pyrolysis gas over the transfer coefficient, B'_g.
    pub gas_rate: f64,
    /// Char over the transfer coefficient, B'_c.
    pub char_rate: f64,
    /// Temperature, K.
    pub temperature_k: f64,
    /// Enthalpy of the wall's gas, J/kg.
    pub enthalpy_j_kg: f64,
}

/// Table of the wall: every pressure at every B'_g and temperature.
#[derive(Clone, Debug, PartialEq)]
pub struct WallTable {
    inverse_p: Vec<f64>,
    b_g: Vec<f64>,
    t: Vec<f64>,
    /// B'_c and h_w; temperature by temperature within a B'_g within a pressure, the highest pressure first.
    values: Vec<[f64; 2]>,
}

/// B'_c and h_w, each with its slopes over B'_g and T.
type Looked = [[f64; 3]; 2];

impl WallTable {
    /// The table of the rows, in any order.
    ///
    /// # Errors
    /// Numbers that are not finite or negative, combinations that are missing or twice, fewer than two temperatures.
    pub fn try_new(mut rows: Vec<WallRow>) -> Result<Self, Fault> {
        const OF: &str = "wall";
        for (row, n) in rows.iter().zip(1..) {
            check_row(
                OF,
                n,
                &[
                    ("p_Pa", row.pressure_pa, f64::MIN_POSITIVE),
                    ("Bg", row.gas_rate, 0.0),
                    ("Bc", row.char_rate, 0.0),
                    ("T_K", row.temperature_k, f64::MIN_POSITIVE),
                    ("hw_J_kg", row.enthalpy_j_kg, f64::MIN),
                ],
            )?;
        }
        rows.sort_by(|a, b| {
            let pressure = b.pressure_pa.total_cmp(&a.pressure_pa);
            let gas = a.gas_rate.total_cmp(&b.gas_rate);
            pressure
                .then(gas)
                .then(a.temperature_k.total_cmp(&b.temperature_k))
        });
        let inverse_p = distinct(rows.iter().map(|row| 1.0 / row.pressure_pa));
        let b_g = distinct(rows.iter().map(|row| row.gas_rate));
        let t = distinct(rows.iter().map(|row| row.temperature_k));
        if t.len() < 2 {
            return Err(Fault::TooFew {
                of: OF,
                key: "T_K",
                rows: t.len(),
                least: 2,
            });
        }
        let sheet = b_g.len() * t.len();
        let fits = |(i, row): (usize, &WallRow)| {
            b_g.get(i % sheet / t.len()) == Some(&row.gas_rate)
                && t.get(i % t.len()) == Some(&row.temperature_k)
        };
        if rows.len() != inverse_p.len() * sheet || !rows.iter().enumerate().all(fits) {
            return Err(Fault::Irregular { of: OF, key: "T_K" });
        }
        let values = rows
            .iter()
            .map(|row| [row.char_rate, row.enthalpy_j_kg])
            .collect();
        Ok(Self {
            inverse_p,
            b_g,
            t,
            values,
        })
    }

    /// Lowest and highest pressure, Pa, B'_g and temperature, K.
    pub fn covered(&self) -> [[f64; 2]; 3] {
        let ends =
            |knots: &[f64]| [knots.first(), knots.last()].map(|x| x.copied().unwrap_or_default());
        let [most, least] = ends(&self.inverse_p).map(|inverse| 1.0 / inverse);
        [[least, most], ends(&self.b_g), ends(&self.t)]
    }

    fn sheet(
        &self,
        sheet: usize,
        (j, share_g, per_g): (usize, f64, f64),
        (i, share_t, per_t): (usize, f64, f64),
    ) -> Looked {
        let n = self.t.len();
        let at = |j: usize, i: usize| {
            let found = self.values.get((sheet * self.b_g.len() + j) * n + i);
            found.copied().unwrap_or_default()
        };
        let (a, b) = (at(j, i), at(j, i + 1));
        let next = if self.b_g.len() > 1 { j + 1 } else { j };
        let (c, d) = (at(next, i), at(next, i + 1));
        [0, 1].map(|k| {
            let low = a[k] + share_t * (b[k] - a[k]);
            let high = c[k] + share_t * (d[k] - c[k]);
            let slope = (1.0 - share_g) * (b[k] - a[k]) + share_g * (d[k] - c[k]);
            [
                low + share_g * (high - low),
                (high - low) * per_g,
                slope * per_t,
            ]
        })
    }

    /// B'_c and h_w, J/kg, with their slopes over B'_g and temperature.
    fn at(&self, pressure_pa: f64, gas_rate: f64, temperature_k: f64) -> Looked {
        // Slope of the share, which is none where the end holds.
        let spot = |knots: &[f64], x: f64| {
            let (i, share) = place(knots, x);
            let per = match (knots.get(i), knots.get(i + 1)) {
                (Some(a), Some(b)) if (*a..*b).contains(&x) => 1.0 / (b - a),
                _ => 0.0,
            };
            (i, share, per)
        };
        let (g, t) = (spot(&self.b_g, gas_rate), spot(&self.t, temperature_k));
        let (sheet, share) = place(&self.inverse_p, 1.0 / pressure_pa.max(f64::MIN_POSITIVE));
        if share == 0.0 || self.inverse_p.len() < 2 {
            return self.sheet(sheet, g, t);
        }
        if share == 1.0 {
            return self.sheet(sheet + 1, g, t);
        }
        let [low, high] = [sheet, sheet + 1].map(|sheet| self.sheet(sheet, g, t));
        // y = B'_c / n with n = 1 + B'_g + B'_c, and back: B'_c = (1 + B'_g) y / (1 − y).
        let one = 1.0 + gas_rate.clamp(0.0, self.b_g.last().copied().unwrap_or_default());
        let moving = if g.2 > 0.0 { 1.0 } else { 0.0 };
        let fraction = |[b, b_g, b_t]: [f64; 3]| {
            let n = one + b;
            [
                b / n,
                (one * b_g - b * moving) / (n * n),
                one * b_t / (n * n),
            ]
        };
        let blend = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|i| a[i] + share * (b[i] - a[i]));
        let [y, y_g, y_t] = blend(fraction(low[0]), fraction(high[0]));
        let rest = 1.0 - y;
        let b_c = one * y / rest;
        let per = one / (rest * rest);
        [
            [b_c, moving * y / rest + per * y_g, per * y_t],
            blend(low[1], high[1]),
        ]
    }
}

/// Kind of chemistry at the wall.
#[derive(Clone, Debug, PartialEq)]
pub enum Surface {
    /// Char reacts with the gas of the boundary layer.
    Reacting(WallTable),
    /// Nothing is taken away; rows of temperature, K, and enthalpy of the gas at the wall, J/kg.
    Inert(Vec<[f64; 2]>),
}

/// Chemistry of the wall at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blown {
    /// Transfer coefficient with blowing, kg/(m² s), and its slopes over T and ṁ_g.
    pub transfer: [f64; 3],
    /// Char taken away, kg/(m² s), and its slopes.
    pub char: [f64; 3],
    /// Enthalpy of the wall's gas, J/kg, and its slopes.
    pub enthalpy: [f64; 3],
}

/// Conditions under which the wall reacts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exposure {
    /// Pressure, Pa.
    pub pressure_pa: f64,
    /// Transfer coefficient without blowing, kg/(m² s), above zero.
    pub transfer_kg_m2s: f64,
    /// Blowing parameter λ.
    pub blowing: f64,
    /// Whether char is taken away.
    pub recession: bool,
}

impl Surface {
    /// B'_c and h_w with slopes over B'_g and T.
    fn at(&self, exposure: &Exposure, gas_rate: f64, temperature_k: f64) -> Looked {
        match self {
            Self::Reacting(table) => {
                let mut looked = table.at(exposure.pressure_pa, gas_rate, temperature_k);
                if !exposure.recession {
                    looked[0] = [0.0; 3];
                }
                looked
            }
            Self::Inert(rows) => {
                let i = rows
                    .partition_point(|row| row[0] <= temperature_k)
                    .saturating_sub(1);
                let i = i.min(rows.len().saturating_sub(2));
                let slope = match (rows.get(i), rows.get(i + 1)) {
                    (Some([t0, h0]), Some([t1, h1])) => (h1 - h0) / (t1 - t0),
                    _ => 0.0,
                };
                let [t, h] = rows.get(i).copied().unwrap_or_default();
                [[0.0; 3], [h + slope * (temperature_k - t), 0.0, slope]]
            }
        }
    }

    /// Transfer with blowing, char and enthalpy at a wall temperature, K, and a flow of pyrolysis gas, kg/(m² s).
    pub fn blown(&self, exposure: &Exposure, temperature_k: f64, gas_kg_m2s: f64) -> Blown {
        let c_h = exposure.transfer_kg_m2s;
        let m_g = gas_kg_m2s.max(0.0);
        let two_lambda = 2.0 * exposure.blowing;
        let mut u = c_h * blowing(two_lambda * m_g / c_h)[0];
        let mut looked = self.at(exposure, m_g / u, temperature_k);
        let mut psi = [1.0, 0.0];
        // f(u) = u − C_H ψ(x) rises at least as fast as u where B'_c falls with B'_g: Newton from the other side of no char.
        for _ in 0..30 {
            let b_g = m_g / u;
            looked = self.at(exposure, b_g, temperature_k);
            let [b_c, b_c_g, _] = looked[0];
            psi = blowing(two_lambda * (m_g + u * b_c) / c_h);
            let f = u - c_h * psi[0];
            let slope = (1.0 - two_lambda * psi[1] * (b_c - b_g * b_c_g)).max(0.5);
            let next = (u - f / slope).clamp(0.1 * u, c_h);
            let moved = (next - u).abs();
            u = next;
            if moved <= 1e-13 * u {
                break;
            }
        }
        let b_g = m_g / u;
        let [[b_c, b_c_g, b_c_t], [h, h_g, h_t]] = looked;
        let k = two_lambda * psi[1];
        let free = 1.0 - k * (b_c - b_g * b_c_g);
        let u_t = k * u * b_c_t / free;
        let u_m = k * (1.0 + b_c_g) / free;
        let char =
            |du: f64, dm: f64, dt: f64| (b_c - b_g * b_c_g) * du + b_c_g * dm + u * b_c_t * dt;
        let gas_rate = [-b_g * u_t / u, (1.0 - b_g * u_m) / u];
        Blown {
            transfer: [u, u_t, u_m],
            char: [u * b_c, char(u_t, 0.0, 1.0), char(u_m, 1.0, 0.0)],
            enthalpy: [h, h_t + h_g * gas_rate[0], h_g * gas_rate[1]],
        }
    }
}

/// ψ = x / (eˣ − 1) and its slope.
fn blowing(x: f64) -> [f64; 2] {
    if x.abs() < 1e-4 {
        // 1 − x/2 + x²/12
        return [1.0 - 0.5 * x + x * x / 12.0, -0.5 + x / 6.0];
    }
    // Beyond, nothing of the boundary layer reaches the wall: 1e-12 of its transfer.
    let x = x.min(30.0);
    let e = math::exp(x);
    [x / (e - 1.0), (e - 1.0 - x * e) / ((e - 1.0) * (e - 1.0))]
}
