//! Where a step ends before its time: boundaries of the atmosphere, the ground, the way out, kinks of heating and drag.
//!
//! ```text
//! g(t) = 0 by false position with halving on the dense output, on parts of the step where the altitude only rises or falls
//! ```
//!
//! with g an altitude less a level, m, or a speed less a level, m/s.
//!
//! # Valid
//! Steps in which the vertical speed changes its sign once at most.
//!
//! # References
//! - \[dowell-jarratt-1971\] for the halving (Illinois).

use super::Integration;
use crate::flight::equations::Radiation;
use crate::flight::motion::Motion;
use crate::planet::Gravity;
use numerics::ode::Step;

/// A boundary is met to this height, m.
const BOUNDARY_TOLERANCE_M: f64 = 1e-3;
/// Where a step leaves the piece of the atmosphere, or the flight ends.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Gate {
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
    /// Slows down to a kink of heating or drag.
    Kink,
}

/// A row of the drag table is met to this part of its Mach number.
const MACH_TOLERANCE: f64 = 1e-7;

/// Height, rate of climb and Mach number at an end of a step.
#[derive(Clone, Copy)]
pub(super) struct Place {
    pub(super) altitude_m: f64,
    pub(super) climb_m_s: f64,
    /// Mach number where drag depends on it, else 0.
    pub(super) mach: f64,
}

/// A kink of radiative heating is met to this speed, m/s.
const KINK_TOLERANCE_M_S: f64 = 1e-3;

impl<'a, M: Motion<'a, N>, const N: usize> Integration<M, N> {
    /// The first gate through which a step passes, and when.
    pub(super) fn first_gate(&mut self, step: &Step<N>, there: Place) -> Option<(f64, Gate)> {
        let boundaries = self.motion.point().mission.atmosphere.boundaries_m();
        let layer = self.motion.point().layer;
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
            let climb = |y: &[f64; N]| place(&self.motion, y).climb_m_s;
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
        let kinks = [self.speed_kink(step), self.mach_kink(step, there)];
        kinks
            .into_iter()
            .flatten()
            .fold(found, |first, kink| match first {
                Some(gate) if gate.0 <= kink.0 => Some(gate),
                _ => Some(kink),
            })
    }

    /// Where a step slows down to a row of the drag table.
    fn mach_kink(&self, step: &Step<N>, there: Place) -> Option<(f64, Gate)> {
        let below = self
            .kinks_mach
            .partition_point(|kink| *kink < self.here.mach * (1.0 - 10.0 * MACH_TOLERANCE));
        let level = *self.kinks_mach.get(below.checked_sub(1)?)?;
        if there.mach >= level {
            return None;
        }
        let gap = |y: &[f64; N]| place(&self.motion, y).mach / level - 1.0;
        Some((
            self.when(step, [step.t0, step.t1], gap, MACH_TOLERANCE),
            Gate::Kink,
        ))
    }

    /// Where a step slows down to a kink of a heating relation; with radiation over, takes it up again when the speed rises.
    fn speed_kink(&mut self, step: &Step<N>) -> Option<(f64, Gate)> {
        let onset_m_s = self.onset_m_s.unwrap_or(0.0);
        let (before, after) = (speed_m_s(&step.y0), speed_m_s(&step.y1));
        if self.motion.point().radiation == Radiation::Over
            && after > onset_m_s + 10.0 * KINK_TOLERANCE_M_S
        {
            self.motion.point_mut().radiation = Radiation::Continued(onset_m_s);
            self.integrator.renew();
        }
        let below = self
            .kinks_m_s
            .partition_point(|kink| *kink < before - 10.0 * KINK_TOLERANCE_M_S);
        let radiates = self.motion.point().radiation != Radiation::Over;
        let (level_m_s, gate) = match below
            .checked_sub(1)
            .and_then(|kink| self.kinks_m_s.get(kink))
        {
            Some(kink) if !radiates || *kink > onset_m_s => (*kink, Gate::Kink),
            _ if radiates => (onset_m_s, Gate::Onset),
            _ => return None,
        };
        if after >= level_m_s {
            return None;
        }
        let gap = |y: &[f64; N]| speed_m_s(y) - level_m_s;
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
        step: &Step<N>,
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

    fn reaches(&self, step: &Step<N>, span: [f64; 2], level_m: f64) -> f64 {
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
        step: &Step<N>,
        [mut t0, mut t1]: [f64; 2],
        g: impl Fn(&[f64; N]) -> f64,
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

    fn altitude_m(&self, y: &[f64; N]) -> f64 {
        self.motion
            .point()
            .ellipsoid
            .local([y[0], y[1], y[2]])
            .altitude_m
    }

    /// Energy of the inertial motion over mass, J/kg; negative on a bound orbit.
    pub(super) fn energy_j_kg(&self, y: &[f64; N]) -> f64 {
        let planet = &self.motion.point().mission.planet;
        let Gravity::Zonal { mu_m3_s2, .. } = planet.gravity else {
            return -1.0;
        };
        let omega = planet.rotation_rate_rad_s;
        let (vx, vy, vz) = (y[3] - omega * y[1], y[4] + omega * y[0], y[5]);
        let radius_m = (y[0] * y[0] + y[1] * y[1] + y[2] * y[2]).sqrt();
        0.5 * (vx * vx + vy * vy + vz * vz) - mu_m3_s2 / radius_m
    }
}

pub(super) fn place<'a, const N: usize>(motion: &impl Motion<'a, N>, y: &[f64; N]) -> Place {
    let equations = motion.point();
    let local = equations.ellipsoid.local([y[0], y[1], y[2]]);
    let [u, v, w] = local.up;
    let mach = match motion.drag_table() {
        None => 0.0,
        Some(_) => {
            let atmosphere = &equations.mission.atmosphere;
            speed_m_s(y) / atmosphere.speed_of_sound_in(equations.layer, local.altitude_m)
        }
    };
    Place {
        altitude_m: local.altitude_m,
        climb_m_s: y[3] * u + y[4] * v + y[5] * w,
        mach,
    }
}

pub(super) fn speed_m_s<const N: usize>(y: &[f64; N]) -> f64 {
    (y[3] * y[3] + y[4] * y[4] + y[5] * y[5]).sqrt()
}
