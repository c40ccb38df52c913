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
use crate::grid::Grid;
use crate::history::{History, Sample};
use crate::settings::{Account, Outcome, Settings, Until};
use crate::stack::Stack;
use crate::stage::{Edges, Stage, StageFault, Work};
use crate::state::{Content, State};
use core::ops::ControlFlow;

/// γ of the two implicit stages, 1 − 1/√2.
const GAMMA: f64 = 1.0 - core::f64::consts::FRAC_1_SQRT_2;
/// Twice the error constant of the method, for the divided difference of F.
const ERROR: f64 = 0.0808;
/// Share of the rise of the first stage that the guess of the second goes on with.
const PREDICTED: f64 = 0.8;
/// First step, s. Assumed.
const FIRST_STEP_S: f64 = 1e-3;
/// Step, s, below which a wall that would pass its layer has passed it. Assumed.
const GONE_S: f64 = 1e-6;
/// Shortest step, s. Assumed, as the following.
const SHORTEST_S: f64 = 1e-13;
/// Share of the first layer that counts as gone.
const GONE: f64 = 1e-3;
/// Error of the wall's place, as a share of the first layer, that counts as an error of one kelvin. Assumed.
const WALL_FOR_KELVIN: f64 = 1e-5;
/// Share of the step by which its error would just be allowed that is taken. Assumed, as the following.
const CAUTION: f64 = 0.9;
/// Least and greatest change of a step by its error.
const CHANGE: [f64; 2] = [0.2, 3.0];

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

/// Amounts of a step.
#[derive(Clone, Debug, Default)]
struct Amounts {
    /// At its start.
    start: Content,
    /// At the first stage.
    first: Content,
    /// From which the second stage goes on.
    known: Content,
    /// At its end.
    end: Content,
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
        let times_s = self.environment.times_s();
        let [start_s, last_s] =
            [times_s.first(), times_s.last()].map(|t| t.copied().unwrap_or(0.0));
        let (end_s, cooled) = match self.settings.until {
            Until::Time(t) => (t, None),
            Until::Cooled { layer, at_most_s } => (at_most_s, Some(layer)),
        };
        let mut time = start_s;
        let mut account = Account::default();
        let mut amounts = Amounts::default();
        self.content(&mut amounts.start);
        let energy_0 = amounts.start.total_j_m2();
        let mass_0 = self.mass_kg_m2();
        let mut history = History::new(self.stack.layers.len());
        history.keep(self.sample(time, &Edges::default()));
        let mut rates = Rates {
            energy: vec![0.0; self.grid.len()],
            wall_m: 0.0,
        };
        let mut next_rates = rates.clone();
        let mut saved = self.state.clone();
        let mut step = FIRST_STEP_S;
        let mut outputs = 1_u64;
        let mut last_edges = Edges::default();
        let mut outcome = Outcome::Finished;
        while time < end_s {
            if account.steps + account.taken_back >= self.settings.most_steps {
                outcome = Outcome::OutOfWork;
                break;
            }
            let every = self.settings.output_step_s;
            let output = every.map_or(end_s, |every| start_s + every * outputs as f64);
            let stop = self.environment.next_bend_s(time).min(output).min(end_s);
            let left = stop - time;
            let dt = match step / left {
                share if share >= 0.999 => left,
                share if share > 0.5 => 0.5 * left,
                _ => step,
            };
            let arrives = dt == left;
            saved.clone_from(&self.state);
            let stages = self.step([time, dt], rates.wall_m, &mut amounts);
            let error = match &stages {
                Ok(_) => self.error(dt, &amounts, &rates, &mut next_rates),
                Err(_) => f64::INFINITY,
            };
            let (Ok(edges), true) = (stages, error <= 1.0) else {
                account.taken_back += 1;
                self.state.clone_from(&saved);
                self.grid.move_wall(self.state.wall_m);
                step = match error.is_finite() {
                    true => dt * shrink(error),
                    false => 0.25 * dt,
                };
                let gone = stages == Err(StageFault::BurntThrough) && step < GONE_S;
                if gone || self.remaining() < GONE {
                    outcome = Outcome::BurntThrough;
                    break;
                }
                if step < SHORTEST_S.max(1e-14 * time.abs()) {
                    outcome = Outcome::NotSettled;
                    break;
                }
                continue;
            };
            account.add([(1.0 - GAMMA) * dt, GAMMA * dt], &edges);
            last_edges = edges[1];
            time = if arrives { stop } else { time + dt };
            core::mem::swap(&mut amounts.start, &mut amounts.end);
            core::mem::swap(&mut rates, &mut next_rates);
            // A step cut short by a stop says nothing about the next one.
            step = match arrives {
                true => step.max(dt * shrink(error)),
                false => dt * shrink(error),
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
            if self.remaining() < GONE {
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
        self.content(&mut amounts.end);
        account.stored_j_m2 = amounts.end.total_j_m2() - energy_0;
        account.stored_kg_m2 = self.mass_kg_m2() - mass_0;
        Response {
            outcome,
            end_s: time,
            history,
            account,
        }
    }

    /// Share of the first layer that is left.
    fn remaining(&self) -> f64 {
        1.0 - self.state.wall_m / self.grid.first_volume_m
    }

    fn mass_kg_m2(&self) -> f64 {
        self.state.mass_kg_m2(self.stack, &self.grid, &self.weights)
    }

    /// Both stages of a step from the amounts at its start and the speed of the wall there, m/s.
    fn step(
        &mut self,
        [time, dt]: [f64; 2],
        wall_speed: f64,
        amounts: &mut Amounts,
    ) -> Result<[Edges; 2], StageFault> {
        let Amounts {
            start,
            first,
            known,
            end,
        } = amounts;
        let h = GAMMA * dt;
        let wall = self.environment.at(time + h, time);
        let at_start = self.state.t.clone();
        let [wall_k, wall_m] = [self.state.wall_k, self.state.wall_m];
        let left = self.grid.first_volume_m - wall_m;
        self.state.wall_m += (h * wall_speed).min(0.5 * left);
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
        self.state.wall_k = (self.state.wall_k + ratio * PREDICTED * (self.state.wall_k - wall_k))
            .max(0.5 * self.state.wall_k);
        let left = self.grid.first_volume_m - self.state.wall_m;
        let passed = ratio * (self.state.wall_m - wall_m);
        self.state.wall_m += passed.clamp(0.0, 0.5 * left);
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
    fn error(&self, dt: f64, amounts: &Amounts, rates: &Rates, next: &mut Rates) -> f64 {
        let Amounts {
            start,
            first,
            known,
            end,
        } = amounts;
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
        let length = WALL_FOR_KELVIN * self.grid.first_volume_m;
        worst.max(bend(rates.wall_m, f1, f2).abs() / (length * self.settings.tolerance_k))
    }
}

/// Change of the step for an error over the tolerance.
fn shrink(error: f64) -> f64 {
    (CAUTION / numerics::math::cbrt(error.max(1e-6))).clamp(CHANGE[0], CHANGE[1])
}
