//! Three degrees of freedom: integrates the equations of motion from the entry state to the end of the flight.
//!
//! ```text
//! y' = f(y) in one smooth piece of the atmosphere after the other
//! ```
//!
//! with y position, velocity (SI, planet-fixed axes) and heat loads. Steps end where the atmosphere changes its formula,
//! so that the method keeps its order; between the ends of a step the dense output of the method holds.
//!
//! # Valid
//! Ballistic flight. Steps end within a millimetre of a boundary of the atmosphere.
//!
//! # References
//! - \[samareh-2014\] section 3.2.

use super::equations::{Equations, STATES};
use super::mission::{Body, Mission};
use crate::answer::Outcome;
use crate::planet::Gravity;
use numerics::ode::{Integrator, OdeError, Step, Tolerance};

/// Longest flight, s: 30 days.
const LONGEST_FLIGHT_S: f64 = 30.0 * 86_400.0;
/// Trials of steps after which a flight is given up.
const MOST_STEPS: u64 = 200_000;
/// Nothing falls deeper, m.
const DEEPEST_M: f64 = -5_000.0;
/// A boundary is met to this height, m.
const BOUNDARY_TOLERANCE_M: f64 = 1e-3;
/// Height over which the air changes and to which the error of a step is compared, m.
const POSITION_SCALE_M: f64 = 1_000.0;
/// Speed below which the error of a step does not shrink any more, m/s.
const SPEED_SCALE_M_S: f64 = 10.0;
/// Heat load below which the error of a step does not shrink any more, J/m².
const HEAT_LOAD_SCALE_J_M2: f64 = 1e6;

/// A step of a flight, and the piece of the atmosphere in which it was taken.
#[derive(Clone, Debug)]
pub struct Leg {
    /// The step with its dense output.
    pub step: Step<STATES>,
    /// Piece of the atmosphere.
    pub layer: usize,
}

/// A flight as integrated.
#[derive(Clone, Debug)]
pub struct Record {
    /// State at the start.
    pub start: [f64; STATES],
    /// Piece of the atmosphere at the start.
    pub start_layer: usize,
    /// The steps, in order; none when the flight ends where it starts.
    pub legs: Vec<Leg>,
    /// How it ended.
    pub outcome: Outcome,
    /// Why, where the outcome needs a reason.
    pub reason: Option<String>,
    /// Evaluations of the right-hand side.
    pub evaluations: u64,
}

/// Integrates a flight.
pub fn integrate(mission: &Mission, body: &Body) -> Record {
    let [x, y, z] = mission.start.position_m;
    let [vx, vy, vz] = mission.start.velocity_m_s;
    let start = [x, y, z, vx, vy, vz, 0.0, 0.0];
    let mut flight = Integration::new(mission, body, start);
    let (outcome, reason) = flight.run();
    Record {
        start,
        start_layer: flight.start_layer,
        legs: flight.legs,
        outcome,
        reason,
        evaluations: flight.integrator.statistics().evaluations,
    }
}

/// Where a step leaves the piece of the atmosphere, or the flight ends.
#[derive(Clone, Copy, PartialEq)]
enum Gate {
    /// Falls into the piece below.
    Floor,
    /// Rises into the piece above.
    Ceiling,
    /// Falls through the altitude that ends the flight.
    Ground,
    /// Rises out of the atmosphere.
    Exit,
}

struct Integration<'a> {
    equations: Equations<'a>,
    integrator: Integrator<STATES>,
    start_layer: usize,
    legs: Vec<Leg>,
    /// Altitude that ends a fall, m.
    ground_m: f64,
    /// Altitude above which the vehicle has left, m; none where gravity always brings it back.
    exit_m: Option<f64>,
    /// Whether the flight has turned from falling to rising.
    turned_up: bool,
}

impl<'a> Integration<'a> {
    fn new(mission: &'a Mission, body: &'a Body, start: [f64; STATES]) -> Self {
        let tolerance = mission.solver.tolerance;
        let speed = tolerance * SPEED_SCALE_M_S;
        let position = tolerance * POSITION_SCALE_M;
        let load = tolerance * HEAT_LOAD_SCALE_J_M2;
        let tolerance = Tolerance {
            relative: [
                0.0, 0.0, 0.0, tolerance, tolerance, tolerance, tolerance, tolerance,
            ],
            absolute: [
                position, position, position, speed, speed, speed, load, load,
            ],
        };
        let altitude_m = mission
            .planet
            .local([start[0], start[1], start[2]])
            .altitude_m;
        let layer = mission.atmosphere.layer(altitude_m);
        let exit_m = match mission.planet.gravity {
            Gravity::Zonal { .. } => Some(mission.planet.entry_interface_m.max(altitude_m)),
            Gravity::Uniform { .. } => None,
        };
        Integration {
            equations: Equations {
                mission,
                body,
                layer,
            },
            integrator: Integrator::new(mission.solver.method, tolerance, 0.0, start)
                .with_maximum_steps(MOST_STEPS),
            start_layer: layer,
            legs: Vec::with_capacity(256),
            ground_m: mission.stop.altitude_m.unwrap_or(DEEPEST_M),
            exit_m,
            turned_up: false,
        }
    }

    fn run(&mut self) -> (Outcome, Option<String>) {
        let mission = self.equations.mission;
        let t_end = mission.stop.time_s.unwrap_or(LONGEST_FLIGHT_S);
        if self.altitude_m(self.integrator.y()) <= self.ground_m
            && self.vertical_speed_m_s(self.integrator.y()) < 0.0
        {
            return self.grounded();
        }
        loop {
            if self.integrator.t() >= t_end {
                let reason = (mission.stop.time_s.is_none())
                    .then(|| "still in flight after 30 days".to_string());
                return (Outcome::Stopped, reason);
            }
            let equations = self.equations;
            let mut f = |_: f64, y: &[f64; STATES]| equations.derivative(y);
            let step = match self.integrator.step(&mut f, t_end) {
                Ok(step) => step,
                Err(error) => return given_up(&error),
            };
            let Some((t, gate)) = self.first_gate(&step) else {
                self.legs.push(Leg {
                    step,
                    layer: equations.layer,
                });
                continue;
            };
            if t > step.t0 {
                match self.integrator.retake(&mut f, t) {
                    Ok(step) => self.legs.push(Leg {
                        step,
                        layer: equations.layer,
                    }),
                    Err(error) => return given_up(&error),
                }
            }
            match gate {
                Gate::Ground => return self.grounded(),
                Gate::Exit => return self.left(),
                Gate::Floor => self.equations.layer = equations.layer.saturating_sub(1),
                Gate::Ceiling => self.equations.layer = equations.layer + 1,
            }
            if t <= step.t0 {
                // The step began on the boundary: it is taken anew from there, in the other piece.
                self.begin_again(step.t0, &step.y0);
            }
            self.integrator.renew();
        }
    }

    /// Puts the integration back to the beginning of a step.
    fn begin_again(&mut self, t: f64, y: &[f64; STATES]) {
        self.integrator = self.integrator.clone().at(t, *y);
    }

    /// The first gate through which a step passes, and when.
    fn first_gate(&mut self, step: &Step<STATES>) -> Option<(f64, Gate)> {
        let boundaries = self.equations.mission.atmosphere.boundaries_m();
        let layer = self.equations.layer;
        let floor_m = layer
            .checked_sub(1)
            .and_then(|below| boundaries.get(below))
            .copied();
        let ceiling_m = boundaries.get(layer).copied();
        let (w0, w1) = (
            self.vertical_speed_m_s(&step.y0),
            self.vertical_speed_m_s(&step.y1),
        );
        let t_turn = if (w0 < 0.0) == (w1 < 0.0) {
            step.t1
        } else {
            self.when(
                step,
                [step.t0, step.t1],
                |y| self.vertical_speed_m_s(y),
                1e-6,
            )
        };
        for (span, falling) in [([step.t0, t_turn], w0 < 0.0), ([t_turn, step.t1], w1 < 0.0)] {
            if span[0] >= span[1] {
                continue;
            }
            if !falling && span[0] > 0.0 && span[0] == t_turn {
                self.turned_up = true;
            }
            if let Some(found) = self.gate_in(step, span, falling, [floor_m, ceiling_m]) {
                return Some(found);
            }
        }
        None
    }

    fn gate_in(
        &self,
        step: &Step<STATES>,
        span: [f64; 2],
        falling: bool,
        [floor_m, ceiling_m]: [Option<f64>; 2],
    ) -> Option<(f64, Gate)> {
        let end_m = self.altitude_m(&step.at(span[1]));
        if falling {
            let (level_m, gate) = match floor_m {
                Some(floor_m) if floor_m > self.ground_m => (floor_m, Gate::Floor),
                _ => (self.ground_m, Gate::Ground),
            };
            // What begins below the ground was climbing and has not been above it.
            let below = end_m < level_m
                && (gate == Gate::Floor || self.altitude_m(&step.at(span[0])) >= level_m);
            return below.then(|| (self.reaches(step, span, level_m), gate));
        }
        let exit_m = self
            .exit_m
            .filter(|_| self.turned_up || self.energy_j_kg(&step.y1) >= 0.0);
        let (level_m, gate) = match (ceiling_m, exit_m) {
            (Some(ceiling_m), Some(exit_m)) if ceiling_m < exit_m => (ceiling_m, Gate::Ceiling),
            (_, Some(exit_m)) => (exit_m, Gate::Exit),
            (Some(ceiling_m), None) => (ceiling_m, Gate::Ceiling),
            (None, None) => return None,
        };
        (end_m > level_m).then(|| (self.reaches(step, span, level_m), gate))
    }

    fn reaches(&self, step: &Step<STATES>, span: [f64; 2], level_m: f64) -> f64 {
        self.when(
            step,
            span,
            |y| self.altitude_m(y) - level_m,
            BOUNDARY_TOLERANCE_M,
        )
    }

    /// When `g` is zero to within `tolerance` along a step, by false position with halving (Illinois).
    fn when(
        &self,
        step: &Step<STATES>,
        [mut t0, mut t1]: [f64; 2],
        g: impl Fn(&[f64; STATES]) -> f64,
        tolerance: f64,
    ) -> f64 {
        let (mut g0, mut g1) = (g(&step.at(t0)), g(&step.at(t1)));
        for _ in 0..60 {
            if g0.abs() <= tolerance || g1 == g0 {
                return t0;
            }
            if g1.abs() <= tolerance {
                return t1;
            }
            let t = t1 - g1 * (t1 - t0) / (g1 - g0);
            let here = g(&step.at(t));
            if (here < 0.0) == (g1 < 0.0) {
                g0 *= 0.5;
            } else {
                (t0, g0) = (t1, g1);
            }
            (t1, g1) = (t, here);
        }
        t1
    }

    fn altitude_m(&self, y: &[f64; STATES]) -> f64 {
        self.equations
            .mission
            .planet
            .local([y[0], y[1], y[2]])
            .altitude_m
    }

    fn vertical_speed_m_s(&self, y: &[f64; STATES]) -> f64 {
        let [u, v, w] = self.equations.mission.planet.local([y[0], y[1], y[2]]).up;
        y[3] * u + y[4] * v + y[5] * w
    }

    /// Energy of the inertial motion over mass, J/kg; negative on a bound orbit.
    fn energy_j_kg(&self, y: &[f64; STATES]) -> f64 {
        let planet = &self.equations.mission.planet;
        let Gravity::Zonal { mu_m3_s2, .. } = planet.gravity else {
            return -1.0;
        };
        let omega = planet.rotation_rate_rad_s;
        let (vx, vy, vz) = (y[3] - omega * y[1], y[4] + omega * y[0], y[5]);
        let radius_m = (y[0] * y[0] + y[1] * y[1] + y[2] * y[2]).sqrt();
        0.5 * (vx * vx + vy * vy + vz * vz) - mu_m3_s2 / radius_m
    }

    fn grounded(&self) -> (Outcome, Option<String>) {
        match self.equations.mission.stop.altitude_m {
            Some(altitude_m) if altitude_m > 0.0 => (Outcome::Stopped, None),
            Some(_) => (Outcome::Landed, None),
            None => (
                Outcome::Landed,
                Some(format!("fell to {DEEPEST_M} m, below any ground")),
            ),
        }
    }

    fn left(&self) -> (Outcome, Option<String>) {
        let exit_km = self.exit_m.unwrap_or_default() / 1e3;
        if self.energy_j_kg(self.integrator.y()) < 0.0 {
            let reason = format!("rose through {exit_km:.0} km again, on a bound orbit");
            (Outcome::Captured, Some(reason))
        } else {
            let reason = format!("rose through {exit_km:.0} km again, faster than escape speed");
            (Outcome::SkippedOut, Some(reason))
        }
    }
}

fn given_up(error: &OdeError) -> (Outcome, Option<String>) {
    (
        Outcome::Stopped,
        Some(format!("the integration was given up: {error}")),
    )
}

impl Leg {
    /// Time at the end of the leg, s.
    pub fn t1(&self) -> f64 {
        self.step.t1
    }
}
