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

use super::equations::{Equations, Radiation, STATES};
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
    /// Slows down to where radiative heating ends at once.
    Onset,
    /// Slows down to a kink of radiative heating.
    Kink,
}

/// Height and rate of climb at the ends of a step.
#[derive(Clone, Copy)]
struct Place {
    altitude_m: f64,
    climb_m_s: f64,
}

/// A kink of radiative heating is met to this speed, m/s.
const KINK_TOLERANCE_M_S: f64 = 1e-3;

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
    /// Speeds at which radiative heating has a kink, m/s, ascending; below the first it is nothing.
    kinks_m_s: Vec<f64>,
    /// Where the integration stands.
    here: Place,
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
        let mut equations = Equations::new(mission, body, layer);
        let kinks_m_s = mission.heating.radiative.kinks_m_s();
        if let Some(onset_m_s) = kinks_m_s.first() {
            equations.radiation = match speed_m_s(&start) > *onset_m_s {
                true => Radiation::Continued(*onset_m_s),
                false => Radiation::Over,
            };
        }
        Integration {
            here: place(&equations, &start),
            kinks_m_s,
            equations,
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
        if self.here.altitude_m <= self.ground_m && self.here.climb_m_s < 0.0 {
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
            let there = place(&equations, &step.y1);
            let Some((t, gate)) = self.first_gate(&step, there) else {
                self.here = there;
                self.legs.push(Leg {
                    step,
                    layer: equations.layer,
                });
                continue;
            };
            if t > step.t0 {
                match self.integrator.retake(&mut f, t) {
                    Ok(step) => {
                        self.here = place(&equations, &step.y1);
                        self.legs.push(Leg {
                            step,
                            layer: equations.layer,
                        });
                    }
                    Err(error) => return given_up(&error),
                }
            }
            match gate {
                Gate::Ground => return self.grounded(),
                Gate::Exit => return self.left(),
                Gate::Floor => self.equations.layer = equations.layer.saturating_sub(1),
                Gate::Ceiling => self.equations.layer = equations.layer + 1,
                Gate::Onset => self.equations.radiation = Radiation::Over,
                Gate::Kink => continue,
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
    fn first_gate(&mut self, step: &Step<STATES>, there: Place) -> Option<(f64, Gate)> {
        let boundaries = self.equations.mission.atmosphere.boundaries_m();
        let layer = self.equations.layer;
        let floor_m = layer
            .checked_sub(1)
            .and_then(|below| boundaries.get(below))
            .copied();
        let ceiling_m = boundaries.get(layer).copied();
        let falls = [self.here.climb_m_s < 0.0, there.climb_m_s < 0.0];
        let found = if falls[0] == falls[1] {
            let ends_m = [self.here.altitude_m, there.altitude_m];
            self.gate_in(step, [step.t0, step.t1], ends_m, [floor_m, ceiling_m])
        } else {
            let climb = |y: &[f64; STATES]| place(&self.equations, y).climb_m_s;
            let t_turn = self.when(step, [step.t0, step.t1], climb, 1e-6);
            let turn_m = self.altitude_m(&step.at(t_turn));
            let before = self.gate_in(
                step,
                [step.t0, t_turn],
                [self.here.altitude_m, turn_m],
                [floor_m, ceiling_m],
            );
            self.turned_up |= falls[0];
            before.or_else(|| {
                let ends_m = [turn_m, there.altitude_m];
                self.gate_in(step, [t_turn, step.t1], ends_m, [floor_m, ceiling_m])
            })
        };
        match (found, self.kink(step)) {
            (Some(gate), Some(kink)) if kink.0 < gate.0 => Some(kink),
            (Some(gate), _) => Some(gate),
            (None, kink) => kink,
        }
    }

    /// Where a step slows down to a kink of the radiative relation; with radiation over, takes it up again when the speed
    /// rises.
    fn kink(&mut self, step: &Step<STATES>) -> Option<(f64, Gate)> {
        let onset_m_s = *self.kinks_m_s.first()?;
        let (before, after) = (speed_m_s(&step.y0), speed_m_s(&step.y1));
        if self.equations.radiation == Radiation::Over {
            if after > onset_m_s + 10.0 * KINK_TOLERANCE_M_S {
                self.equations.radiation = Radiation::Continued(onset_m_s);
                self.integrator.renew();
            }
            return None;
        }
        let below = self
            .kinks_m_s
            .partition_point(|kink| *kink < before - 10.0 * KINK_TOLERANCE_M_S);
        let (level_m_s, gate) = match below.checked_sub(1) {
            None | Some(0) => (onset_m_s, Gate::Onset),
            Some(kink) => (self.kinks_m_s[kink], Gate::Kink),
        };
        if after >= level_m_s {
            return None;
        }
        let gap = |y: &[f64; STATES]| speed_m_s(y) - level_m_s;
        let t = if before <= level_m_s {
            step.t0
        } else {
            self.when(step, [step.t0, step.t1], gap, KINK_TOLERANCE_M_S)
        };
        Some((t, gate))
    }

    /// The gate of a part of a step in which the altitude only rises or only falls.
    fn gate_in(
        &self,
        step: &Step<STATES>,
        span: [f64; 2],
        [start_m, end_m]: [f64; 2],
        [floor_m, ceiling_m]: [Option<f64>; 2],
    ) -> Option<(f64, Gate)> {
        if span[0] >= span[1] {
            return None;
        }
        if end_m < start_m {
            let (level_m, gate) = match floor_m {
                Some(floor_m) if floor_m > self.ground_m => (floor_m, Gate::Floor),
                _ => (self.ground_m, Gate::Ground),
            };
            // What begins below the ground was climbing and has not been above it.
            let below = end_m < level_m && (gate == Gate::Floor || start_m >= level_m);
            return below.then(|| (self.reaches(step, span, level_m), gate));
        }
        let leaves =
            |exit_m: &f64| end_m > *exit_m && (self.turned_up || self.energy_j_kg(&step.y1) >= 0.0);
        let exit_m = self.exit_m.filter(leaves);
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
            .ellipsoid
            .local([y[0], y[1], y[2]])
            .altitude_m
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

fn place(equations: &Equations, y: &[f64; STATES]) -> Place {
    let local = equations.ellipsoid.local([y[0], y[1], y[2]]);
    let [u, v, w] = local.up;
    Place {
        altitude_m: local.altitude_m,
        climb_m_s: y[3] * u + y[4] * v + y[5] * w,
    }
}

fn speed_m_s(y: &[f64; STATES]) -> f64 {
    (y[3] * y[3] + y[4] * y[4] + y[5] * y[5]).sqrt()
}

fn given_up(error: &OdeError) -> (Outcome, Option<String>) {
    (
        Outcome::Stopped,
        Some(format!("the integration was given up: {error}")),
    )
}
