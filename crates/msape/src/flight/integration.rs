//! Integrates equations of motion from the entry state to the end of the flight, whatever their degrees of freedom.
//!
//! ```text
//! y' = f(t, y) in one smooth piece of the atmosphere after the other
//! ```
//!
//! with y position, velocity (SI, planet-fixed axes), heat loads and what else a motion has. Steps end where the atmosphere changes its formula,
//! so that the method keeps its order; between the ends of a step the dense output of the method holds.
//!
//! # Valid
//! Steps end within a millimetre of a boundary of the atmosphere.
//!
//! # References
//! - \[samareh-2014\] section 3.2.

mod gate;

use super::equations::{Radiation, STATES};
use super::motion::Motion;
use crate::aero::DragTable;
use crate::outcome::Outcome;
use crate::planet::Gravity;
use crate::progress::{Progress, Unwatched};
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
pub struct Leg<const N: usize> {
    /// The step with its dense output.
    pub step: Step<N>,
    /// Piece of the atmosphere.
    pub layer: usize,
}

/// A flight as integrated.
#[derive(Clone, Debug)]
pub struct Record<const N: usize> {
    /// State at the start.
    pub start: [f64; N],
    /// Piece of the atmosphere at the start.
    pub start_layer: usize,
    /// The steps, in order; none when the flight ends where it starts.
    pub legs: Vec<Leg<N>>,
    /// How it ended.
    pub outcome: Outcome,
    /// Why, where the outcome needs a reason.
    pub reason: Option<String>,
    /// Evaluations of the right-hand side.
    pub evaluations: u64,
}

/// Integrates a motion from a state.
pub fn integrate<'a, M: Motion<'a, N>, const N: usize>(motion: M, start: [f64; N]) -> Record<N> {
    integrate_watched(motion, start, &mut Unwatched)
}

/// The same; who watches hears before each step which part of the fall is done, and may stop it there.
pub fn integrate_watched<'a, M: Motion<'a, N>, const N: usize>(
    motion: M,
    start: [f64; N],
    progress: &mut dyn Progress,
) -> Record<N> {
    let mut flight = Integration::new(motion, start);
    let (outcome, reason) = flight.run(progress);
    Record {
        start,
        start_layer: flight.start_layer,
        legs: flight.legs,
        outcome,
        reason,
        evaluations: flight.integrator.statistics().evaluations,
    }
}

struct Integration<M, const N: usize> {
    motion: M,
    integrator: Integrator<N>,
    start_layer: usize,
    legs: Vec<Leg<N>>,
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

/// Error allowed in a step of a point mass, of which `tolerance` is the relative part.
pub fn point_tolerance(tolerance: f64) -> Tolerance<STATES> {
    let speed = tolerance * SPEED_SCALE_M_S;
    let position = tolerance * POSITION_SCALE_M;
    let load = tolerance * HEAT_LOAD_SCALE_J_M2;
    Tolerance {
        relative: [
            0.0, 0.0, 0.0, tolerance, tolerance, tolerance, tolerance, tolerance,
        ],
        absolute: [
            position, position, position, speed, speed, speed, load, load,
        ],
    }
}

impl<'a, M: Motion<'a, N>, const N: usize> Integration<M, N> {
    fn new(mut motion: M, start: [f64; N]) -> Self {
        let mission = motion.point().mission;
        let altitude_m = mission
            .planet
            .local([start[0], start[1], start[2]])
            .altitude_m;
        let layer = mission.atmosphere.layer(altitude_m);
        let exit_m = match mission.planet.gravity {
            Gravity::Zonal { .. } => Some(mission.planet.entry_interface_m.max(altitude_m)),
            Gravity::Uniform { .. } => None,
        };
        motion.point_mut().layer = layer;
        let mut kinks_m_s = mission.heating.radiative.kinks_m_s();
        kinks_m_s.extend(mission.heating.convective.kink_m_s());
        kinks_m_s.sort_by(f64::total_cmp);
        let onset_m_s = mission.heating.radiative.onset_m_s();
        if let Some(onset_m_s) = onset_m_s {
            motion.point_mut().radiation = match speed_m_s(&start) > onset_m_s {
                true => Radiation::Continued(onset_m_s),
                false => Radiation::Over,
            };
        }
        let rows = motion.drag_table().into_iter().flat_map(DragTable::rows);
        let kinks_mach = rows
            .map(|(mach, _)| mach)
            .filter(|mach| *mach >= KINKS_FROM_MACH)
            .collect();
        Integration {
            here: place(&motion, &start),
            kinks_m_s,
            onset_m_s,
            kinks_mach,
            motion,
            integrator: Integrator::new(mission.solver.method, motion.tolerance(), 0.0, start)
                .with_maximum_steps(MOST_STEPS),
            start_layer: layer,
            legs: Vec::with_capacity(256),
            ground_m: mission.stop.altitude_m.unwrap_or(DEEPEST_M),
            exit_m,
            turned_up: false,
        }
    }

    fn run(&mut self, progress: &mut dyn Progress) -> (Outcome, Option<String>) {
        let mission = self.motion.point().mission;
        let start_m = self.here.altitude_m;
        let fall_m = (start_m - self.ground_m).max(1.0);
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
            let done = ((start_m - self.here.altitude_m) / fall_m).clamp(0.0, 1.0);
            if progress.advance(done).is_break() {
                return (Outcome::Stopped, Some("stopped on request".to_string()));
            }
            let motion = self.motion;
            let layer = motion.point().layer;
            let mut f = |t: f64, y: &[f64; N]| motion.derivative(t, y);
            let step = match self.integrator.step(&mut f, t_end) {
                Ok(step) => step,
                Err(error) => return given_up(&error),
            };
            let there = place(&motion, &step.y1);
            let Some((t, gate)) = self.first_gate(&step, there) else {
                self.here = there;
                self.legs.push(Leg { step, layer });
                continue;
            };
            if t > step.t0 {
                match self.integrator.retake(&mut f, t) {
                    Ok(step) => {
                        self.here = place(&motion, &step.y1);
                        self.legs.push(Leg { step, layer });
                    }
                    Err(error) => return given_up(&error),
                }
            }
            match gate {
                Gate::Ground => return self.grounded(),
                Gate::Exit => return self.left(),
                Gate::Floor => self.motion.point_mut().layer = layer.saturating_sub(1),
                Gate::Ceiling => self.motion.point_mut().layer = layer + 1,
                Gate::Onset => self.motion.point_mut().radiation = Radiation::Over,
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
    fn begin_again(&mut self, t: f64, y: &[f64; N]) {
        self.integrator = self.integrator.clone().at(t, *y);
    }

    fn grounded(&self) -> (Outcome, Option<String>) {
        match self.motion.point().mission.stop.altitude_m {
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
