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

mod gate;

use super::equations::{Equations, Radiation, STATES};
use super::mission::{Body, Mission};
use crate::aero::Drag;
use crate::answer::Outcome;
use crate::planet::Gravity;
use gate::{Gate, Place, place, speed_m_s};
use numerics::ode::{Integrator, OdeError, Step, Tolerance};

/// Longest flight, s: 30 days.
const LONGEST_FLIGHT_S: f64 = 30.0 * 86_400.0;
/// Trials of steps after which a flight is given up.
const MOST_STEPS: u64 = 200_000;
/// Nothing falls deeper, m.
const DEEPEST_M: f64 = -5_000.0;
/// Height over which the air changes and to which the error of a step is compared, m.
const POSITION_SCALE_M: f64 = 1_000.0;
/// Speed below which the error of a step does not shrink any more, m/s.
const SPEED_SCALE_M_S: f64 = 10.0;
/// Heat load below which the error of a step does not shrink any more, J/m².
const HEAT_LOAD_SCALE_J_M2: f64 = 1e6;

/// Below this Mach number the rows of a drag table no longer matter to peaks and heat loads.
const KINKS_FROM_MACH: f64 = 3.0;

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
    /// Speeds at which a heating relation has a kink, m/s, ascending.
    kinks_m_s: Vec<f64>,
    /// Speed below which radiative heating is nothing, m/s.
    onset_m_s: Option<f64>,
    /// Mach numbers of the rows of the drag table, ascending, from [`KINKS_FROM_MACH`] on.
    kinks_mach: Vec<f64>,
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
        let mut kinks_m_s = mission.heating.radiative.kinks_m_s();
        kinks_m_s.extend(mission.heating.convective.kink_m_s());
        kinks_m_s.sort_by(f64::total_cmp);
        let onset_m_s = mission.heating.radiative.onset_m_s();
        if let Some(onset_m_s) = onset_m_s {
            equations.radiation = match speed_m_s(&start) > onset_m_s {
                true => Radiation::Continued(onset_m_s),
                false => Radiation::Over,
            };
        }
        let kinks_mach = match &body.drag {
            Drag::Constant(_) => Vec::new(),
            Drag::Table(table) => {
                let rows = table.rows().map(|(mach, _)| mach);
                rows.filter(|mach| *mach >= KINKS_FROM_MACH).collect()
            }
        };
        Integration {
            here: place(&equations, &start),
            kinks_m_s,
            onset_m_s,
            kinks_mach,
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
