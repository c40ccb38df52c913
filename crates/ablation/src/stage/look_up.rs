//! Solid, gas and conduction at the present temperatures of a stage.
//!
//! ```text
//! q_f = [w kᵢ₋₁ + (1 − w) kᵢ] (Tᵢ₋₁ − Tᵢ) / (xᵢ − xᵢ₋₁)       within a layer, w the share of the first neighbor at the face
//! p²  = p_w² + ∫ 2 μ R T ṁ / (M K) dx                          from the wall inwards
//! ```
//!
//! with k in W/(m K), T in K, x in m, p in Pa, μ in Pa s, M in kg/mol, ṁ in kg/(m² s), K in m².
//!
//! # Valid
//! Darcy flow of an ideal gas.
//!
//! # References
//! - \[pato\], \[amar-2006\].

use super::{Stage, Work, scaled};
use crate::contact::{Flow, Joint};
use crate::gas::GAS_CONSTANT_J_MOLK;
use crate::grid::Grid;
use crate::stack::{Back, Pyrolysis};
use crate::state::State;

impl Stage<'_> {
    /// Solid, gas and conduction at the present temperatures.
    pub(super) fn look_up(&self, grid: &Grid, state: &mut State, work: &mut Work) {
        let n = grid.len();
        for i in 0..n {
            let solid = &self.stack.layers[grid.layer[i]].material.solid;
            let values = solid.at(state.t[i]);
            let z = state.whole(self.weights, i);
            let tau = solid.virgin_fraction(z);
            let mix = |[v, c]: [f64; 2]| tau * v + (1.0 - tau) * c;
            let cell = &mut work.cells[i];
            cell.k = mix(values.conductivity_w_mk);
            cell.k_t = mix(values.conductivity_slope);
            cell.values = values;
        }
        if let Some(place) = state.pressure_pa.first_mut() {
            *place = self.pressure_pa();
        }
        if let Some(pyrolysis) = self.pyrolysis() {
            self.look_up_gas(grid, pyrolysis, state, work);
        }
        for f in 1..n {
            let (l, r) = (grid.layer[f - 1], grid.layer[f]);
            let [a, b] = [&work.cells[f - 1], &work.cells[f]];
            let (t1, t2) = (state.t[f - 1], state.t[f]);
            let flow = if l == r {
                let share = grid.first_share[f];
                let length = grid.middle_m[f] - grid.middle_m[f - 1];
                let g = (share * a.k + (1.0 - share) * b.k) / length;
                let slope = (t1 - t2) / length;
                Flow {
                    q: g * (t1 - t2),
                    by_first: g + share * a.k_t * slope,
                    by_second: -g + (1.0 - share) * b.k_t * slope,
                }
            } else {
                let r1 = (grid.face_m[f] - grid.middle_m[f - 1]) / a.k;
                let r2 = (grid.middle_m[f] - grid.face_m[f]) / b.k;
                self.stack.layers[r].joint.flow(t1, r1, t2, r2)
            };
            work.flows[f] = scaled(flow, grid.area[f]);
        }
        let last = n - 1;
        let resistance = (grid.face_m[n] - grid.middle_m[last]) / work.cells[last].k;
        work.flows[n] = scaled(
            back_flow(self.stack.back, state.t[last], resistance),
            grid.area[n],
        );
    }

    /// Pressure from the wall inwards, and the gas of each cell there.
    fn look_up_gas(&self, grid: &Grid, pyrolysis: &Pyrolysis, state: &mut State, work: &mut Work) {
        let solid = &self.stack.layers[0].material.solid;
        let [k_v, k_c] = pyrolysis.permeability_m2;
        for i in 0..grid.first {
            let p = state.pressure_pa[i];
            let gas = pyrolysis.gas.at(p, state.t[i]);
            let tau = solid.virgin_fraction(state.whole(self.weights, i));
            let permeability = tau * k_v + (1.0 - tau) * k_c;
            // d(p²)/dx = 2 μ R T ṁ / (M K)
            let flow = 0.5
                * (state.gas[i] / grid.area[i] + state.gas[i + 1] / grid.area[i + 1].max(1e-12));
            let slope =
                2.0 * gas.viscosity_per_molar_mass * GAS_CONSTANT_J_MOLK * state.t[i] * flow
                    / permeability;
            let length = grid.face_m[i + 1] - grid.face_m[i];
            state.pressure_pa[i + 1] = (p * p + (slope * length).max(0.0)).sqrt();
            work.cells[i].gas = gas;
        }
    }
}

/// Flow out of the last cell, with its slope over the cell's temperature.
fn back_flow(back: Back, t: f64, resistance: f64) -> Flow {
    match back {
        Back::Adiabatic => Flow::default(),
        Back::Held { temperature_k } => Joint::Perfect.flow(t, resistance, temperature_k, 0.0),
        Back::Exposed {
            temperature_k,
            emissivity,
            film_w_m2k,
        } => {
            let gap = Joint::Gap {
                conductance_w_m2k: film_w_m2k,
                emissivity,
            };
            gap.flow(t, resistance, temperature_k, 0.0)
        }
    }
}
