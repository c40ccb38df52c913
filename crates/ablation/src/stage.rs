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

mod look_up;
mod shares;
mod wall_rows;

use crate::contact::Flow;
use crate::environment::Wall;
use crate::gas::GasValues;
use crate::grid::Grid;
use crate::solid::Values;
use crate::stack::{Pyrolysis, Stack};
use crate::state::{Content, State};
use crate::wall::WallSettings;
use wall_rows::{AtWallCell, WallRows};

/// Most corrections of one stage.
const MOST_CORRECTIONS: usize = 14;

/// δ = [0] δT + [1] δY + [2], T being the temperature of a cell.
type Linear = [f64; 3];

/// Adds a form times a factor.
#[inline]
fn add(form: &mut Linear, factor: f64, other: &Linear) {
    for (own, other) in form.iter_mut().zip(other) {
        *own += factor * other;
    }
}

/// The form in terms of the cell before, where δT = a δT_before + b δY + c.
#[inline]
fn before([t, y, c]: Linear, [a, b, d]: Linear) -> Linear {
    [t * a, y + t * b, c + t * d]
}

/// Flows over the edges of the body at the end of a stage, per m² of the initial wall.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
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
    /// Forms of the shares of each cell, by its own temperature.
    shares: Vec<Linear>,
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
        work.shares.resize(state.share.len(), [0.0; 3]);
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

    /// One correction: the flows over the edges before it, and its size over that at which the stage is settled.
    fn correct(&self, grid: &Grid, state: &mut State, work: &mut Work) -> (Edges, f64) {
        self.look_up(grid, state, work);
        let n = grid.len();
        let h = self.h;
        // Volume that the wall passes in the step, m: h dY/dt.
        let passed = state.wall_m - self.known.wall_m;
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
                add(&mut gas_left.1, 1.0, &made.dgas);
                state.gas[i] = gas_left.0;
            }
            if i == 0 {
                let solid = &self.stack.layers[0].material.solid;
                wall_cell = AtWallCell::new(self, solid, state, z_left);
                work.flows[0] = self.wall_flow(grid, state, &wall_cell, &work.cells[0]);
            }
            let flow = work.flows[i];
            let mut through = Through {
                value: flow.q,
                by_before: flow.by_first,
                form: [flow.by_second, 0.0, 0.0],
            };
            if charring {
                let left = Left {
                    z: (z_left, dz_left),
                    gas: gas_left,
                    wall: wall_cell,
                };
                self.carry(grid, (i, passed), work, &left, &mut through);
                through.form[1] += flow.q / (grid.first_volume_m - state.wall_m);
            }
            // V e − known − h (Φ_L − Φ_R) = 0
            let e = z * e_v + (1.0 - z) * e_c;
            let residual = volume * e - self.known.energy[i] - h * (through.value - right.value);
            let mut form = [0.0; 3];
            add(&mut form, volume * (e_v - e_c), &dz);
            add(&mut form, -h, &through.form);
            add(&mut form, h, &right.form);
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

    /// Conduction through the wall.
    fn wall_flow(&self, grid: &Grid, state: &State, wall: &AtWallCell, first: &Cell) -> Flow {
        let length = grid.middle_m[0] - grid.face_m[0];
        let k = 0.5 * (wall.k + first.k);
        let slope = (state.wall_k - state.t[0]) / length;
        let flow = Flow {
            q: k * slope,
            by_first: k / length + 0.5 * wall.k_t * slope,
            by_second: -k / length + 0.5 * first.k_t * slope,
        };
        scaled(flow, grid.area[0])
    }

    /// Adds what gas and solid carry through the left face of a cell of the first layer.
    fn carry(
        &self,
        grid: &Grid,
        (i, passed): (usize, f64),
        work: &Work,
        left: &Left,
        through: &mut Through,
    ) {
        // Values at the face between two neighbors; at the wall those of the wall.
        let (share, other, gas_other) = match i.checked_sub(1).map(|i| &work.cells[i]) {
            Some(cell) => (grid.first_share[i], &cell.values, &cell.gas),
            None => (1.0, &left.wall.values, &left.wall.gas),
        };
        let own = &work.cells[i];
        let mix = |a: f64, b: f64| share * a + (1.0 - share) * b;
        let (z, dz) = left.z;
        let (m, dm) = left.gas;
        let e = [0, 1].map(|k| mix(other.enthalpy_j_m3[k], own.values.enthalpy_j_m3[k]));
        let e_face = z * e[0] + (1.0 - z) * e[1];
        let v = passed * grid.motion[i] / self.h;
        let c = |values: &Values| {
            let [a, b] = values.heat_capacity_j_m3k;
            z * a + (1.0 - z) * b
        };
        let h_g = mix(gas_other.enthalpy_j_kg, own.gas.enthalpy_j_kg);
        through.value -= m * h_g + v * e_face;
        through.by_before -= share * (m * gas_other.specific_heat_j_kgk + v * c(other));
        through.form[0] -= (1.0 - share) * (m * own.gas.specific_heat_j_kgk + v * c(&own.values));
        through.form[1] -= grid.motion[i] * e_face / self.h;
        add(&mut through.form, -h_g, &dm);
        add(&mut through.form, -v * (e[0] - e[1]), &dz);
    }
}

/// Solid and gas at the left face of a cell.
struct Left {
    /// Undecomposed share.
    z: (f64, Linear),
    /// Flow of gas.
    gas: (f64, Linear),
    /// Values at the wall, of the first cell.
    wall: AtWallCell,
}

/// A flow through an area.
fn scaled(flow: Flow, area: f64) -> Flow {
    Flow {
        q: area * flow.q,
        by_first: area * flow.by_first,
        by_second: area * flow.by_second,
    }
}
