//! Steps in time, by error, between the bends of the environment.
//!
//! ```text
//! U₁ = Uₙ + γ Δt F(U₁)
//! Uₙ₊₁ = Uₙ + (1 − γ) Δt F(U₁) + γ Δt F(Uₙ₊₁)         γ = 1 − 1/√2
//! error ≈ 0.0404 Δt³ F''                               F'' through Fₙ, F(U₁), F(Uₙ₊₁)
//! ```
//!
//! of second order, L-stable, in the conserved amounts U: energy and shares times volume, and the volume coordinate of the wall.
//! 0.0404 is what the stability function (1 + (1 − 2γ) z) / (1 − γ z)² lacks of eᶻ at z³.
//!
//! # Valid
//! Any environment; the work is bounded.
//!
//! # References
//! - \[alexander-1977\].

use crate::environment::{Environment, Wall};
use crate::fault::Fault;
use crate::grid::{Grid, Resolution};
use crate::history::{History, Sample};
use crate::stack::Stack;
use crate::stage::{Edges, Stage, StageFault, Work};
use crate::state::{Content, State};
use crate::wall::WallSettings;
use core::ops::ControlFlow;

/// γ of the two implicit stages, 1 − 1/√2.
const GAMMA: f64 = 1.0 - core::f64::consts::FRAC_1_SQRT_2;
/// Twice the error constant of the method, for the divided difference of F.
const ERROR: f64 = 0.0808;
/// Share of the rise of the first stage that the guess of the second goes on with.
const PREDICTED: f64 = 0.8;
/// Shortest step, s.
const SHORTEST_S: f64 = 1e-13;
/// Share of the first layer that counts as gone.
const GONE: f64 = 1e-3;

/// Way in which a run ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// At the time asked for.
    Finished,
    /// When the joint's temperature had passed its maximum and no heat came any more.
    Cooled,
    /// The first layer was gone.
    BurntThrough,
    /// At the limit of work.
    OutOfWork,
    /// No step was short enough.
    NotSettled,
    /// By whoever watched.
    Stopped,
}

/// End of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Until {
    /// A time, s.
    Time(f64),
    /// The fall of the temperature behind a layer after the last row of the environment, or a time, s, at the latest.
    Cooled {
        /// Layer, from 0.
        layer: usize,
        /// Latest time, s.
        at_most_s: f64,
    },
}

/// Settings of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Temperature of all layers at the start, K.
    pub initial_temperature_k: f64,
    /// Wall.
    pub wall: WallSettings,
    /// End.
    pub until: Until,
    /// Interval of the rows of the history, s; none keeps the first and the last.
    pub output_step_s: Option<f64>,
    /// Depths from the initial wall at which temperatures are kept, m; beyond the back there is none.
    pub depths_m: Vec<f64>,
    /// Cells.
    pub resolution: Resolution,
    /// Error of a step, K.
    pub tolerance_k: f64,
    /// Most steps, those that were taken back included.
    pub most_steps: usize,
}

impl Settings {
    fn check(&self, stack: &Stack) -> Result<(), Fault> {
        const OF: &str = "settings";
        let end = match self.until {
            Until::Time(t) | Until::Cooled { at_most_s: t, .. } => t,
        };
        let step = self.output_step_s.unwrap_or(1.0);
        for (key, value, least, most) in [
            (
                "initial_temperature_k",
                self.initial_temperature_k,
                1.0,
                5000.0,
            ),
            (
                "sink_temperature_k",
                self.wall.sink_temperature_k,
                0.0,
                5000.0,
            ),
            ("blowing", self.wall.blowing, 0.0, 2.0),
            ("until_s", end, -1e9, 1e9),
            ("output_step_s", step, 1e-6, 1e9),
            ("tolerance_k", self.tolerance_k, 1e-9, 1e3),
            ("cells", self.resolution.cells as f64, 3.0, 20_000.0),
            (
                "cells_behind",
                self.resolution.cells_behind as f64,
                1.0,
                20_000.0,
            ),
            ("stretch", self.resolution.stretch, 1.0, 1e6),
        ] {
            if !(least..=most).contains(&value) {
                return Err(Fault::Range {
                    of: OF,
                    key,
                    value,
                    least,
                    most,
                });
            }
        }
        for &value in &self.depths_m {
            if !(0.0..=f64::MAX).contains(&value) {
                return Err(Fault::Range {
                    of: OF,
                    key: "depths_m",
                    value,
                    least: 0.0,
                    most: f64::MAX,
                });
            }
        }
        if let Until::Cooled { layer, .. } = self.until
            && layer >= stack.layers.len()
        {
            let (value, most) = (layer as f64, stack.layers.len() as f64 - 1.0);
            return Err(Fault::Range {
                of: OF,
                key: "layer",
                value,
                least: 0.0,
                most,
            });
        }
        Ok(())
    }
}

/// Account of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Account {
    /// Steps taken.
    pub steps: usize,
    /// Steps taken back.
    pub taken_back: usize,
    /// Corrections in all stages.
    pub corrections: usize,
    /// Energy in through the wall, gas and char that leave counted, J per m² of the initial wall.
    pub wall_j_m2: f64,
    /// Energy out through the back, J/m².
    pub back_j_m2: f64,
    /// Gas that left, kg/m².
    pub gas_kg_m2: f64,
    /// Char that left, kg/m².
    pub char_kg_m2: f64,
    /// Energy of all layers less that at the start, J/m².
    pub stored_j_m2: f64,
    /// Mass of all layers less that at the start, kg/m².
    pub stored_kg_m2: f64,
    /// Sum of the sizes of all flows of energy over the edges, J/m²: the scale of the balance.
    pub turned_over_j_m2: f64,
}

impl Account {
    /// Energy that is missing over the energy that went over the edges.
    pub fn energy_imbalance(&self) -> f64 {
        (self.stored_j_m2 - self.wall_j_m2 + self.back_j_m2)
            / self.turned_over_j_m2.max(f64::MIN_POSITIVE)
    }

    /// Mass that is missing over the mass that left.
    pub fn mass_imbalance(&self) -> f64 {
        let left = self.gas_kg_m2 + self.char_kg_m2;
        (self.stored_kg_m2 + left) / left.max(f64::MIN_POSITIVE)
    }
}

/// Result of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Response {
    /// How it ended.
    pub outcome: Outcome,
    /// When it ended, s.
    pub end_s: f64,
    /// History.
    pub history: History,
    /// Balances and work.
    pub account: Account,
}

/// A stack in its environment.
pub struct Run<'a> {
    stack: &'a Stack,
    environment: &'a Environment,
    settings: &'a Settings,
    weights: Vec<f64>,
    grid: Grid,
    state: State,
    work: Work,
    /// Slope of each cell's temperature over the last step, K/s, for the first guess of the next.
    slope: Vec<f64>,
}

/// Rates of the amounts at the end of a step.
#[derive(Clone, Debug, Default)]
struct Rates {
    energy: Vec<f64>,
    wall_m: f64,
}

impl<'a> Run<'a> {
    /// A run, checked.
    ///
    /// # Errors
    /// Settings beyond their ranges.
    pub fn try_new(
        stack: &'a Stack,
        environment: &'a Environment,
        settings: &'a Settings,
    ) -> Result<Self, Fault> {
        settings.check(stack)?;
        let pyrolysis = stack
            .layers
            .first()
            .and_then(|layer| layer.material.pyrolysis.as_ref());
        let reactions = pyrolysis.map_or(&[][..], |pyrolysis| &pyrolysis.reactions);
        let total = reactions
            .iter()
            .fold(0.0, |sum, reaction| sum + reaction.loss_kg_m3);
        let weights: Vec<f64> = reactions
            .iter()
            .map(|reaction| reaction.loss_kg_m3 / total)
            .collect();
        let grid = Grid::new(stack, &settings.resolution);
        let state = State::new(&grid, weights.len(), settings.initial_temperature_k);
        Ok(Self {
            stack,
            environment,
            settings,
            weights,
            grid,
            state,
            work: Work::default(),
            slope: Vec::new(),
        })
    }

    fn stage(&mut self, known: &Content, h: f64, wall: Wall) -> Result<Edges, StageFault> {
        let stage = Stage {
            stack: self.stack,
            settings: &self.settings.wall,
            weights: &self.weights,
            known,
            h,
            wall,
        };
        stage.solve(&mut self.grid, &mut self.state, &mut self.work)
    }

    fn content(&self, content: &mut Content) {
        self.state
            .content(self.stack, &self.grid, &self.weights, content);
    }

    fn sample(&self, time_s: f64, edges: &Edges) -> Sample {
        Sample::new(
            self.stack,
            &self.grid,
            &self.state,
            &self.weights,
            &self.settings.depths_m,
            time_s,
            edges,
        )
    }

    /// Runs to the end; `watch` hears of the time after each step, s, and may stop it.
    pub fn response(mut self, mut watch: impl FnMut(f64) -> ControlFlow<()>) -> Response {
        let start_s = self
            .environment
            .times_s()
            .first()
            .copied()
            .unwrap_or_default();
        let last_s = self
            .environment
            .times_s()
            .last()
            .copied()
            .unwrap_or_default();
        let (end_s, cooled) = match self.settings.until {
            Until::Time(t) => (t, None),
            Until::Cooled { layer, at_most_s } => (at_most_s, Some(layer)),
        };
        let mut time = start_s;
        let mut account = Account::default();
        let [mut start, mut first, mut known, mut end] =
            [const { None }; 4].map(|none: Option<Content>| none.unwrap_or_default());
        self.content(&mut start);
        let energy_0 = start.energy.iter().fold(0.0, |sum, e| sum + e);
        let mass_0 = self.state.mass_kg_m2(self.stack, &self.grid, &self.weights);
        let mut history = History::new(self.stack.layers.len());
        history.keep(self.sample(time, &Edges::default()));
        let mut rates = Rates {
            energy: vec![0.0; self.grid.len()],
            wall_m: 0.0,
        };
        let mut next_rates = rates.clone();
        let mut saved = self.state.clone();
        let mut step: f64 = 1e-3;
        let mut outputs = 1_u64;
        let mut last_edges = Edges::default();
        let mut outcome = Outcome::Finished;
        while time < end_s {
            if account.steps + account.taken_back >= self.settings.most_steps {
                outcome = Outcome::OutOfWork;
                break;
            }
            // A row of the environment, an output or the end: the next place at which a step has to end.
            let output = self
                .settings
                .output_step_s
                .map_or(end_s, |every| start_s + every * outputs as f64);
            let stop = output.min(end_s);
            let row = self
                .environment
                .bends_s()
                .iter()
                .copied()
                .find(|t| *t > time);
            let stop = row.map_or(stop, |t| t.min(stop));
            let left = stop - time;
            let dt = if step >= left * 0.999 {
                left
            } else if step > 0.5 * left {
                0.5 * left
            } else {
                step
            };
            let arrives = dt == left;
            saved.clone_from(&self.state);
            let stages: Result<[Edges; 2], StageFault> =
                self.step([time, dt], &start, [&mut first, &mut known, &mut end]);
            let (error, edges) = match stages {
                Ok(edges) => (
                    self.error(dt, &start, &first, &end, &known, &rates, &mut next_rates),
                    edges,
                ),
                Err(_) => (f64::INFINITY, [Edges::default(); 2]),
            };
            if !(error <= 1.0) {
                account.taken_back += 1;
                let gone = matches!(stages, Err(StageFault::BurntThrough));
                self.state.clone_from(&saved);
                self.grid.move_wall(self.state.wall_m);
                step = if error.is_finite() {
                    dt * shrink(error)
                } else {
                    0.25 * dt
                };
                let remaining = 1.0 - self.state.wall_m / self.grid.first_volume_m;
                if remaining < GONE || gone && step < 1e-6 {
                    outcome = Outcome::BurntThrough;
                    break;
                }
                if step < SHORTEST_S.max(1e-14 * time.abs()) {
                    outcome = Outcome::NotSettled;
                    break;
                }
                continue;
            }
            account.steps += 1;
            for (edges, h) in edges.iter().zip([(1.0 - GAMMA) * dt, GAMMA * dt]) {
                account.wall_j_m2 += h * edges.wall_w_m2;
                account.back_j_m2 += h * edges.back_w_m2;
                account.gas_kg_m2 += h * edges.gas;
                account.char_kg_m2 += h * edges.char;
                account.turned_over_j_m2 += h * (edges.wall_w_m2.abs() + edges.back_w_m2.abs());
            }
            last_edges = edges[1];
            time = if arrives { stop } else { time + dt };
            core::mem::swap(&mut start, &mut end);
            core::mem::swap(&mut rates, &mut next_rates);
            // A step cut short by a stop says nothing about the next one.
            step = if arrives {
                step.max(dt * shrink(error))
            } else {
                dt * shrink(error)
            };
            let sample = self.sample(time, &last_edges);
            let falls = cooled.is_some_and(|layer| time >= last_s && history.falls(layer, &sample));
            history.follow(&sample);
            if arrives && stop == output && output < end_s {
                history.keep(sample);
                outputs += 1;
            }
            if falls {
                outcome = Outcome::Cooled;
                break;
            }
            if 1.0 - self.state.wall_m / self.grid.first_volume_m < GONE {
                outcome = Outcome::BurntThrough;
                break;
            }
            if watch(time).is_break() {
                outcome = Outcome::Stopped;
                break;
            }
        }
        history.keep(self.sample(time, &last_edges));
        account.corrections = self.work.corrections;
        self.content(&mut end);
        account.stored_j_m2 = end.energy.iter().fold(0.0, |sum, e| sum + e) - energy_0;
        account.stored_kg_m2 =
            self.state.mass_kg_m2(self.stack, &self.grid, &self.weights) - mass_0;
        Response {
            outcome,
            end_s: time,
            history,
            account,
        }
    }

    /// Both stages of a step from the amounts at its start; leaves those of the first, those from which the second goes on, and the end's.
    fn step(
        &mut self,
        [time, dt]: [f64; 2],
        start: &Content,
        [first, known, end]: [&mut Content; 3],
    ) -> Result<[Edges; 2], StageFault> {
        let h = GAMMA * dt;
        let wall = self.environment.at(time + h, time);
        let at_start = self.state.t.clone();
        for (t, slope) in self.state.t.iter_mut().zip(&self.slope) {
            *t = (*t + h * slope).max(0.5 * *t);
        }
        let at_first = self.stage(start, h, wall)?;
        self.content(first);
        // Uₙ + (1 − γ) Δt F₁ = Uₙ + (1 − γ)/γ (U₁ − Uₙ)
        let ratio = (1.0 - GAMMA) / GAMMA;
        let on = |start: &[f64], first: &[f64], known: &mut Vec<f64>| {
            known.clear();
            known.extend(start.iter().zip(first).map(|(a, b)| a + ratio * (b - a)));
        };
        on(&start.energy, &first.energy, &mut known.energy);
        on(&start.share, &first.share, &mut known.share);
        known.wall_m = start.wall_m + ratio * (first.wall_m - start.wall_m);
        for (t, before) in self.state.t.iter_mut().zip(&at_start) {
            *t = (*t + ratio * PREDICTED * (*t - before)).max(0.5 * *t);
        }
        let wall = self.environment.at(time + dt, time);
        let at_end = self.stage(known, h, wall)?;
        self.content(end);
        self.slope.clear();
        let slope = self
            .state
            .t
            .iter()
            .zip(&at_start)
            .map(|(end, start)| (end - start) / dt);
        self.slope.extend(slope);
        Ok([at_first, at_end])
    }

    /// Error of a step over the tolerance, and the rates at its end.
    #[allow(clippy::too_many_arguments, reason = "amounts of one step")]
    fn error(
        &self,
        dt: f64,
        start: &Content,
        first: &Content,
        end: &Content,
        known: &Content,
        rates: &Rates,
        next: &mut Rates,
    ) -> f64 {
        let h = GAMMA * dt;
        // Second difference of F over the step.
        let bend = |f0: f64, f1: f64, f2: f64| {
            ERROR * dt * ((f2 - f1) / (1.0 - GAMMA) - (f1 - f0) / GAMMA)
        };
        next.energy.clear();
        let mut worst: f64 = 0.0;
        for i in 0..self.grid.len() {
            let f1 = (first.energy[i] - start.energy[i]) / h;
            let f2 = (end.energy[i] - known.energy[i]) / h;
            next.energy.push(f2);
            let solid = &self.stack.layers[self.grid.layer[i]].material.solid;
            let [c, c_char] = solid.at(self.state.t[i]).heat_capacity_j_m3k;
            let capacity = self.grid.volume_m[i] * c.min(c_char);
            worst = worst
                .max(bend(rates.energy[i], f1, f2).abs() / (capacity * self.settings.tolerance_k));
        }
        let f1 = (first.wall_m - start.wall_m) / h;
        let f2 = (end.wall_m - known.wall_m) / h;
        next.wall_m = f2;
        // A millionth of the first layer for each kelvin.
        let length = 1e-5 * self.grid.first_volume_m;
        worst.max(bend(rates.wall_m, f1, f2).abs() / (length * self.settings.tolerance_k))
    }
}

/// Change of the step for an error over the tolerance.
fn shrink(error: f64) -> f64 {
    (0.9 / numerics::math::cbrt(error.max(1e-6))).clamp(0.2, 3.0)
}
