//! One implicit stage: energy, mass and wall together by Newton's method.
//!
//! ```text
//! d(V e)/dt   = Φ_L − Φ_R,     Φ = q − ṁ_g h_g − v e          through a face, inwards positive
//! d(V Xⱼ)/dt  = v_R Xⱼ_R − v_L Xⱼ_L − V kⱼ(T) Xⱼ^ψ
//! M_L         = M_R + V (ρᵥ − ρ_c) Σ wⱼ kⱼ(T) Xⱼ^ψ
//! dY/dt       = A_w ṁ_c / ρ_w                                  v = (1 − ξ) dY/dt
//! ```
//!
//! with V in m, e in J/m³, q in W/m², the flow of gas M in kg/s per m² of the initial wall, v in m/s; each is stepped as
//! U = U_known + h F(U). The solid comes from the back and the gas goes to the wall, so that one sweep from the back solves
//! the shares of every cell for given temperatures and eliminates each cell's temperature, share and flow as linear in the
//! temperature before it and in Y; two equations are left at the wall.
//!
//! # Valid
//! Gas in a quasi-steady state, in equilibrium with the solid's temperature.
//!
//! # References
//! - \[amar-2006\], \[pato\].

use crate::contact::{Flow, Joint};
use crate::environment::Wall;
use crate::gas::{GAS_CONSTANT_J_MOLK, GasValues};
use crate::grid::Grid;
use crate::solid::Values;
use crate::stack::{Back, Pyrolysis, Stack};
use crate::state::{Content, State};
use crate::wall::{AtWall, Balance, WallSettings, balance};

/// Most corrections of one stage.
const MOST_CORRECTIONS: usize = 14;
/// Largest last correction of a temperature, K.
const SETTLED_K: f64 = 1e-7;

/// δ = [0] δT + [1] δY + [2], T being the temperature of a cell.
type Linear = [f64; 3];

/// The form in terms of the cell before, where δT = a δT_before + b δY + c.
#[inline]
fn before([t, y, c]: Linear, [a, b, d]: Linear) -> Linear {
    [t * a, y + t * b, c + t * d]
}

/// Flows over the edges of the body at the end of a stage, per m² of the initial wall.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Edges {
    /// Energy into the body through the wall, W/m².
    pub wall_w_m2: f64,
    /// Energy out of the body through the back, W/m².
    pub back_w_m2: f64,
    /// Pyrolysis gas out of the wall, kg/s.
    pub gas: f64,
    /// Char out of the wall, kg/s.
    pub char: f64,
    /// Pyrolysis gas over the transfer coefficient with blowing; none without chemistry.
    pub gas_ratio: Option<f64>,
}

/// Way in which a stage failed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum StageFault {
    /// The corrections do not vanish, or are no numbers.
    NotSettled,
    /// The wall passes the end of the first layer.
    BurntThrough,
}

/// Values of one cell in a correction.
#[derive(Clone, Copy, Debug, Default)]
struct Cell {
    values: Values,
    gas: GasValues,
    k: f64,
    k_t: f64,
}

/// Arrays of the solution that last over the stages.
#[derive(Clone, Debug, Default)]
pub(crate) struct Work {
    cells: Vec<Cell>,
    flows: Vec<Flow>,
    /// Each cell's temperature by that before.
    eliminated: Vec<Linear>,
    /// Shares at the right face of a cell, with their forms.
    right: Vec<(f64, Linear)>,
    /// Shares of the cell behind, with their forms.
    behind: Vec<(f64, Linear)>,
    /// Corrections in all stages.
    pub corrections: usize,
}

/// The problem of a stage.
pub(crate) struct Stage<'a> {
    pub stack: &'a Stack,
    pub settings: &'a WallSettings,
    /// Share of each reaction in the loss of density.
    pub weights: &'a [f64],
    /// Amounts from which the step goes on.
    pub known: &'a Content,
    /// Length of the implicit part of the step, s.
    pub h: f64,
    pub wall: Wall,
}

/// A flow of energy through a face with its forms: by the temperature before, that behind, and the rest.
#[derive(Clone, Copy, Debug, Default)]
struct Through {
    value: f64,
    by_before: f64,
    form: Linear,
}

impl Stage<'_> {
    fn pyrolysis(&self) -> Option<&Pyrolysis> {
        self.stack
            .layers
            .first()
            .and_then(|layer| layer.material.pyrolysis.as_ref())
    }

    fn pressure_pa(&self) -> f64 {
        match self.wall {
            Wall::Heated(heating) => heating.pressure_pa,
            Wall::Held(held) => held.pressure_pa,
        }
    }

    /// Solves the stage, from the state as a first guess.
    pub fn solve(
        &self,
        grid: &mut Grid,
        state: &mut State,
        work: &mut Work,
    ) -> Result<Edges, StageFault> {
        let n = grid.len();
        work.cells.resize(n, Cell::default());
        work.flows.resize(n + 1, Flow::default());
        work.eliminated.resize(n, [0.0; 3]);
        if let Wall::Held(held) = self.wall {
            state.wall_k = held.temperature_k;
        }
        for _ in 0..MOST_CORRECTIONS {
            work.corrections += 1;
            if state.wall_m >= grid.first_volume_m {
                return Err(StageFault::BurntThrough);
            }
            grid.move_wall(state.wall_m);
            let (edges, moved) = self.correct(grid, state, work);
            if !moved.is_finite() {
                return Err(StageFault::NotSettled);
            }
            if moved <= 1.0 {
                grid.move_wall(state.wall_m);
                return Ok(edges);
            }
        }
        Err(StageFault::NotSettled)
    }

    /// Solid, gas and conduction at the present temperatures.
    fn look_up(&self, grid: &Grid, state: &mut State, work: &mut Work) {
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

    /// One correction: the flows over the edges before it, and its size over that at which the stage is settled.
    fn correct(&self, grid: &Grid, state: &mut State, work: &mut Work) -> (Edges, f64) {
        self.look_up(grid, state, work);
        let n = grid.len();
        let h = self.h;
        // Volume that the wall passes in the step, m: h dY/dt.
        let passed = state.wall_m - self.known.wall_m;
        let left = grid.first_volume_m - state.wall_m;
        let back = work.flows[n];
        let mut right = Through {
            value: back.q,
            by_before: 0.0,
            form: [back.by_first, 0.0, 0.0],
        };
        let mut gas_right = (0.0, [0.0; 3]);
        let reactions = self.weights.len();
        work.right.clear();
        work.right.resize(reactions, (1.0, [0.0; 3]));
        work.behind.clear();
        work.behind.resize(reactions, (1.0, [0.0; 3]));
        let mut z_wall = (1.0, [0.0; 3]);
        let mut wall_cell = AtWallCell::default();
        for i in (0..n).rev() {
            let volume = grid.volume_m[i];
            let [e_v, e_c] = work.cells[i].values.enthalpy_j_m3;
            let [c_v, c_c] = work.cells[i].values.heat_capacity_j_m3k;
            let charring = i < grid.first;
            let (mut z, mut dz) = (1.0, [0.0; 3]);
            let (mut z_left, mut dz_left) = (1.0, [0.0; 3]);
            let mut gas_left = gas_right;
            let by_y = if charring {
                grid.motion[i + 1] - grid.motion[i]
            } else {
                0.0
            };
            if charring && reactions > 0 {
                let made = self.shares(grid, state, work, i, passed);
                (z, dz, z_left, dz_left) = (made.z, made.dz, made.z_left, made.dz_left);
                gas_left.0 += made.gas;
                for k in 0..3 {
                    gas_left.1[k] += made.dgas[k];
                }
                state.gas[i] = gas_left.0;
            }
            // Energy through the left face.
            let flow = if i == 0 {
                let solid = &self.stack.layers[0].material.solid;
                wall_cell = AtWallCell::new(self, solid, state, z_left);
                let length = grid.middle_m[0] - grid.face_m[0];
                let k = 0.5 * (wall_cell.k + work.cells[0].k);
                let slope = (state.wall_k - state.t[0]) / length;
                let flow = Flow {
                    q: k * slope,
                    by_first: k / length + 0.5 * wall_cell.k_t * slope,
                    by_second: -k / length + 0.5 * work.cells[0].k_t * slope,
                };
                scaled(flow, grid.area[0])
            } else {
                work.flows[i]
            };
            let mut through = Through {
                value: flow.q,
                by_before: flow.by_first,
                form: [flow.by_second, 0.0, 0.0],
            };
            if charring {
                // Values at the face between two neighbors; at the wall those of the wall.
                let share = if i == 0 { 1.0 } else { grid.first_share[i] };
                let (other, gas_other) = if i == 0 {
                    (wall_cell.values, wall_cell.gas)
                } else {
                    (work.cells[i - 1].values, work.cells[i - 1].gas)
                };
                let own = &work.cells[i];
                let mix = |a: f64, b: f64| share * a + (1.0 - share) * b;
                let e = [0, 1].map(|k| mix(other.enthalpy_j_m3[k], own.values.enthalpy_j_m3[k]));
                let e_left = z_left * e[0] + (1.0 - z_left) * e[1];
                let by_z = e[0] - e[1];
                let v = passed * grid.motion[i] / h;
                let c = |values: &Values| {
                    let [a, b] = values.heat_capacity_j_m3k;
                    z_left * a + (1.0 - z_left) * b
                };
                let m = gas_left.0;
                let h_g = mix(gas_other.enthalpy_j_kg, own.gas.enthalpy_j_kg);
                through.value -= m * h_g + v * e_left;
                through.by_before -= share * (m * gas_other.specific_heat_j_kgk + v * c(&other));
                through.form[0] -=
                    (1.0 - share) * (m * own.gas.specific_heat_j_kgk + v * c(&own.values));
                through.form[1] += flow.q / left - grid.motion[i] * e_left / h;
                for k in 0..3 {
                    through.form[k] -= h_g * gas_left.1[k] + v * by_z * dz_left[k];
                }
            }
            // V e − known − h (Φ_L − Φ_R) = 0
            let e = z * e_v + (1.0 - z) * e_c;
            let residual = volume * e - self.known.energy[i] - h * (through.value - right.value);
            let mut form = [0.0; 3];
            for k in 0..3 {
                form[k] = volume * (e_v - e_c) * dz[k] - h * (through.form[k] - right.form[k]);
            }
            form[0] += volume * (z * c_v + (1.0 - z) * c_c);
            form[1] += by_y * e;
            form[2] += residual;
            let solved = [
                h * through.by_before / form[0],
                -form[1] / form[0],
                -form[2] / form[0],
            ];
            work.eliminated[i] = solved;
            // What goes on to the cell before, in its terms.
            right = Through {
                value: through.value,
                by_before: 0.0,
                form: before(through.form, solved),
            };
            right.form[0] += through.by_before;
            gas_right = (gas_left.0, before(gas_left.1, solved));
            z_wall = (z_left, before(dz_left, solved));
            for entry in work.right.iter_mut().chain(&mut work.behind) {
                entry.1 = before(entry.1, solved);
            }
        }
        let edges = Edges {
            wall_w_m2: right.value,
            back_w_m2: work.flows[n].q,
            gas: gas_right.0,
            char: 0.0,
            gas_ratio: None,
        };
        self.correct_wall(
            grid,
            state,
            work,
            &WallRows {
                through: right,
                gas: gas_right,
                z: z_wall,
                cell: wall_cell,
            },
            edges,
        )
    }

    /// Shares of a cell for its temperature, those at its left face, and the gas that it sets free.
    fn shares(
        &self,
        grid: &Grid,
        state: &mut State,
        work: &mut Work,
        i: usize,
        passed: f64,
    ) -> Made {
        let mut made = Made::default();
        let Some(pyrolysis) = self.pyrolysis() else {
            return made;
        };
        let solid = &self.stack.layers[0].material.solid;
        let loss = solid.virgin.density_kg_m3 - solid.char.density_kg_m3;
        let reactions = self.weights.len();
        let volume = grid.volume_m[i];
        let [m_l, m_r] = [grid.motion[i], grid.motion[i + 1]];
        // Slope of the share carried to the left face: second order, where there is a cell behind.
        let reach = if i + 1 < grid.first {
            (grid.middle_m[i] - grid.face_m[i]) / (grid.middle_m[i + 1] - grid.middle_m[i])
        } else {
            0.0
        };
        for (j, reaction) in pyrolysis.reactions.iter().enumerate() {
            let index = i * reactions + j;
            let (x_right, dx_right) = work.right[j];
            let (x_behind, dx_behind) = work.behind[j];
            let [k, k_t] = reaction.factor(state.t[i]);
            let known = self.known.share[index] + passed * m_r * x_right;
            let (vl, hk) = (passed * m_l, self.h * volume * k);
            let face = |x: f64| {
                let carried = x + reach * (x - x_behind);
                if (0.0..=1.0).contains(&carried) {
                    (carried, 1.0 + reach, -reach)
                } else {
                    (carried.clamp(0.0, 1.0), 0.0, 0.0)
                }
            };
            // V X + h V k X^ψ + h v_L X_L = known + h v_R X_R
            let mut x = state.share[index];
            let (mut at, mut rate, mut slope) = (face(x), reaction.of_share(x), volume);
            for _ in 0..40 {
                at = face(x);
                rate = reaction.of_share(x);
                slope = volume + hk * rate.by_share + vl * at.1;
                let step = (volume * x + hk * rate.value + vl * at.0 - known) / slope;
                x -= step;
                if step.abs() <= 1e-15 + 1e-14 * x.abs() {
                    break;
                }
            }
            state.share[index] = x;
            let by_y = (m_r - m_l) * (x + self.h * k * rate.value) + m_l * at.0 - m_r * x_right;
            let by_t = self.h * volume * k_t * rate.value;
            let mut dx = [0.0; 3];
            let mut dx_left = [0.0; 3];
            let w = self.weights[j];
            for k in 0..3 {
                dx[k] = -(vl * at.2 * dx_behind[k] - passed * m_r * dx_right[k]) / slope;
            }
            dx[0] -= by_t / slope;
            dx[1] -= by_y / slope;
            let scale = loss * w * volume;
            for n in 0..3 {
                dx_left[n] = at.1 * dx[n] + at.2 * dx_behind[n];
                made.dz[n] += w * dx[n];
                made.dz_left[n] += w * dx_left[n];
                made.dgas[n] += scale * k * rate.by_share * dx[n];
            }
            made.z += w * x;
            made.z_left += w * at.0;
            made.gas += scale * k * rate.value;
            made.dgas[0] += scale * k_t * rate.value;
            made.dgas[1] += loss * w * (m_r - m_l) * k * rate.value;
            work.right[j] = (at.0, dx_left);
            work.behind[j] = (x, dx);
        }
        made
    }

    /// Solves the wall's two equations and moves all cells; the size of the largest move.
    fn correct_wall(
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
                edges.char = held.recession_m_s * area * solid.density_kg_m3(rows.z.0);
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
                let by_share = cell.e_z * v;
                for k in 0..3 {
                    dq[k] += cell.gas.enthalpy_j_kg * rows.gas.1[k] + by_share * rows.z.1[k];
                }
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
                edges.char = area * char[0];
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
        moved = moved.max(d_y.abs() / (1e-12 * grid.first_volume_m));
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
        }
        state.wall_k += d_wall_limited;
        state.wall_m += d_y_limited;
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

/// What a cell's reactions make.
#[derive(Clone, Copy, Debug, Default)]
struct Made {
    z: f64,
    dz: Linear,
    z_left: f64,
    dz_left: Linear,
    gas: f64,
    dgas: Linear,
}

/// What the sweep leaves at the wall, in terms of its temperature.
struct WallRows {
    through: Through,
    gas: (f64, Linear),
    z: (f64, Linear),
    cell: AtWallCell,
}

/// Solid and gas at the wall's temperature.
#[derive(Clone, Copy, Debug, Default)]
struct AtWallCell {
    values: Values,
    gas: GasValues,
    k: f64,
    k_t: f64,
    e: f64,
    e_z: f64,
    c: f64,
    emissivity: f64,
    absorptivity: f64,
}

impl AtWallCell {
    fn new(stage: &Stage, solid: &crate::solid::Solid, state: &State, z: f64) -> Self {
        let values = solid.at(state.wall_k);
        let tau = solid.virgin_fraction(z);
        let mix = |[v, c]: [f64; 2], share: f64| share * v + (1.0 - share) * c;
        let gas = stage
            .pyrolysis()
            .map(|pyrolysis| pyrolysis.gas.at(stage.pressure_pa(), state.wall_k));
        let of = |f: fn(&crate::solid::State) -> f64| mix([f(&solid.virgin), f(&solid.char)], tau);
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

fn scaled(flow: Flow, area: f64) -> Flow {
    Flow {
        q: area * flow.q,
        by_first: area * flow.by_first,
        by_second: area * flow.by_second,
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
