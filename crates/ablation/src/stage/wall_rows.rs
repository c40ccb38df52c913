//! The two equations that are left at the wall of a stage: its energy balance and its place.
//!
//! ```text
//! A (heat of all terms but conduction) − q = 0
//! Y − Y_known − h A ṁ_c / ρ_w = 0
//! ```
//!
//! with the area A over that of the initial wall, q in W per m² of it, Y in m, h in s, ṁ_c in kg/(m² s), ρ_w in kg/m³.
//!
//! # Valid
//! As the balance of the wall.
//!
//! # References
//! - \[amar-2006\], \[pato\].

use super::{Edges, Linear, Stage, Through, Work, add};
use crate::environment::Wall;
use crate::gas::GasValues;
use crate::grid::Grid;
use crate::solid::{Solid, State as SolidState, Values};
use crate::state::State;
use crate::wall::{AtWall, Balance, balance};

/// Largest last correction of a temperature, K: the next would be some thousand times smaller.
const SETTLED_K: f64 = 1e-4;
/// Largest last correction of the wall's place, of the volume of the first layer.
const SETTLED_VOLUME: f64 = 1e-9;

/// What the sweep leaves at the wall, in terms of its temperature.
pub(super) struct WallRows {
    pub through: Through,
    pub gas: (f64, Linear),
    pub z: (f64, Linear),
    pub cell: AtWallCell,
}

/// Solid and gas at the wall's temperature.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct AtWallCell {
    pub values: Values,
    pub gas: GasValues,
    pub k: f64,
    pub k_t: f64,
    pub e: f64,
    pub e_z: f64,
    pub c: f64,
    pub emissivity: f64,
    pub absorptivity: f64,
}

impl AtWallCell {
    pub fn new(stage: &Stage, solid: &Solid, state: &State, z: f64) -> Self {
        let values = solid.at(state.wall_k);
        let tau = solid.virgin_fraction(z);
        let mix = |[v, c]: [f64; 2], share: f64| share * v + (1.0 - share) * c;
        let gas = stage
            .pyrolysis()
            .map(|pyrolysis| pyrolysis.gas.at(stage.pressure_pa(), state.wall_k));
        let of = |f: fn(&SolidState) -> f64| mix([f(&solid.virgin), f(&solid.char)], tau);
        Self {
            gas: gas.unwrap_or_default(),
            k: mix(values.conductivity_w_mk, tau),
            k_t: mix(values.conductivity_slope, tau),
            e: mix(values.enthalpy_j_m3, z),
            e_z: values.enthalpy_j_m3[0] - values.enthalpy_j_m3[1],
            c: mix(values.heat_capacity_j_m3k, z),
            emissivity: of(|state| state.emissivity),
            absorptivity: of(|state| state.absorptivity),
            values,
        }
    }
}

impl Stage<'_> {
    /// Solves the wall's two equations and moves all cells; the size of the largest move.
    pub(super) fn correct_wall(
        &self,
        grid: &Grid,
        state: &mut State,
        work: &mut Work,
        rows: &WallRows,
        mut edges: Edges,
    ) -> (Edges, f64) {
        let area = grid.area[0];
        let solid = &self.stack.layers[0].material.solid;
        let (d_wall, d_y) = match self.wall {
            Wall::Held(held) => {
                // Moves by itself: h dY/dt = h A ṡ.
                let target = self.known.wall_m + self.h * area * held.recession_m_s;
                (0.0, target - state.wall_m)
            }
            Wall::Heated(heating) => {
                let cell = &rows.cell;
                let rho = solid.density_kg_m3(rows.z.0);
                let by_z = solid.virgin.density_kg_m3 - solid.char.density_kg_m3;
                let gas = [0, 1, 2].map(|k| rows.gas.1[k] / area);
                let at = AtWall {
                    t: state.wall_k,
                    gas: rows.gas.0 / area,
                    gas_enthalpy: [cell.gas.enthalpy_j_kg, cell.gas.specific_heat_j_kgk],
                    solid_enthalpy: [cell.e / rho, cell.c / rho],
                    emissivity: cell.emissivity,
                    absorptivity: cell.absorptivity,
                };
                let Balance {
                    heat,
                    char,
                    gas_ratio,
                } = balance(
                    &self.stack.layers[0].material.surface,
                    self.settings,
                    &heating,
                    &at,
                );
                // The energy through the wall's face holds gas and solid that leave; conduction alone is in the balance.
                let m = rows.gas.0;
                let v = (state.wall_m - self.known.wall_m) / self.h;
                let q = rows.through.value + m * cell.gas.enthalpy_j_kg + v * cell.e;
                let mut dq = rows.through.form;
                add(&mut dq, cell.gas.enthalpy_j_kg, &rows.gas.1);
                add(&mut dq, cell.e_z * v, &rows.z.1);
                dq[0] += m * cell.gas.specific_heat_j_kgk + v * cell.c;
                dq[1] += cell.e / self.h;
                let mut first = [0, 1, 2].map(|k| area * heat[2] * gas[k] - dq[k]);
                first[0] += area * heat[1];
                first[2] += area * heat[0] - q;
                // Y − known − h A ṁ_c / ρ_w = 0
                let speed = self.h * area / rho;
                let mut second = [0, 1, 2]
                    .map(|k| -speed * (char[2] * gas[k] - char[0] * by_z * rows.z.1[k] / rho));
                second[0] -= speed * char[1];
                second[1] += 1.0;
                second[2] += state.wall_m - self.known.wall_m - speed * char[0];
                edges.gas_ratio = gas_ratio;
                let determinant = first[0] * second[1] - first[1] * second[0];
                (
                    (first[1] * second[2] - first[2] * second[1]) / determinant,
                    (first[2] * second[0] - first[0] * second[2]) / determinant,
                )
            }
        };
        let limit = |d: f64, t: f64| d.clamp(-0.5 * t, 800.0);
        let d_wall_limited = limit(d_wall, state.wall_k);
        // A wall that would pass the layer is held within what is left of it, until the step is cut.
        let left = grid.first_volume_m - state.wall_m;
        let d_y_limited = d_y.clamp(-0.5 * left, 2.0 * left);
        let mut moved = d_wall.abs() / SETTLED_K;
        moved = moved.max(d_y.abs() / (SETTLED_VOLUME * grid.first_volume_m));
        let reactions = self.weights.len();
        let mut d = d_wall_limited;
        for i in 0..grid.len() {
            let [a, b, c] = work.eliminated[i];
            d = a * d + b * d_y_limited + c;
            if !d.is_finite() {
                return (edges, f64::NAN);
            }
            moved = moved.max(d.abs() / SETTLED_K);
            d = limit(d, state.t[i]);
            state.t[i] += d;
            // Shares and flows over the edges move with the temperatures, so that what is left over is of second order.
            let shares = i * reactions..(i + 1) * reactions;
            if i < grid.first {
                let forms = work.shares.get(shares.clone()).into_iter().flatten();
                let shares = state.share.get_mut(shares).into_iter().flatten();
                for (x, form) in shares.zip(forms) {
                    *x += moved_by(form, d, d_y_limited);
                }
            }
        }
        edges.wall_w_m2 += moved_by(&rows.through.form, d_wall_limited, d_y_limited);
        edges.gas += moved_by(&rows.gas.1, d_wall_limited, d_y_limited);
        let back = work.flows.last().map_or(0.0, |flow| flow.by_first);
        edges.back_w_m2 += back * d;
        state.wall_k += d_wall_limited;
        state.wall_m += d_y_limited;
        let z = rows.z.0 + moved_by(&rows.z.1, d_wall_limited, d_y_limited);
        edges.char = (state.wall_m - self.known.wall_m) / self.h * solid.density_kg_m3(z);
        (
            edges,
            if d_wall.is_finite() && d_y.is_finite() {
                moved
            } else {
                f64::NAN
            },
        )
    }
}

/// Value of a form for corrections of the temperature and of Y.
fn moved_by([t, y, c]: &Linear, d_t: f64, d_y: f64) -> f64 {
    t * d_t + y * d_y + c
}
