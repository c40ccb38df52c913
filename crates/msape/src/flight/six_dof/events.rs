//! Events of the attitude along a flight: largest angles, first time below 10 deg, changes from nose first to backward
//! and back.
//!
//! ```text
//! α(t) on the dense output, five points a step; the largest by Brent's method beside the highest point
//! ```
//!
//! with α the angle between the axis and the velocity relative to the air, rad.
//!
//! # Valid
//! Steps shorter than a quarter of an oscillation, as the accuracy of the integration requires.
//!
//! # References
//! - \[brent-1973\] for the search.

use super::motion::{RATES, RIGID_STATES, RigidMotion};
use crate::flight::integration::{Leg, Record};
use crate::flight::motion::{Motion, head};
use crate::flight::phase::Stage;
use numerics::math::{FRAC_PI_2, RADIANS_PER_DEGREE};
use numerics::root;
use serde::{Deserialize, Serialize};

/// Angle below which a vehicle flies nose forward, rad.
const SMALL_RAD: f64 = 10.0 * RADIANS_PER_DEGREE;
/// Number of parts into which a step is divided.
const PARTS: u32 = 4;
/// A step whose highest point reaches this part of the largest angle so far is searched.
const NEARLY: f64 = 0.97;
/// Tolerance of the time of a largest angle, as a fraction of the step.
const TOLERANCE: f64 = 1e-4;
/// The end of a flight over which the amplitude is taken, s.
const LAST_S: f64 = 10.0;

/// An angle and when it is reached.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct AngleAt {
    /// The angle, rad.
    pub angle_rad: f64,
    /// Time after the start, s.
    pub time_s: f64,
}

/// Attitude along a flight.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AttitudeEvents {
    /// Total angle of attack at the start, rad.
    pub initial_total_alpha_rad: f64,
    /// Largest total angle of attack.
    pub maximum_total_alpha: AngleAt,
    /// Total angle of attack at the largest total heat flux, rad.
    pub total_alpha_at_peak_heating_rad: f64,
    /// Largest total angle of attack from then on.
    pub maximum_total_alpha_after_peak_heating: AngleAt,
    /// Total angle of attack at the largest deceleration, rad.
    pub total_alpha_at_peak_deceleration_rad: f64,
    /// First time at which the total angle of attack is below 10 deg, s.
    pub first_below_10_deg_time_s: Option<f64>,
    /// Knudsen number then.
    pub first_below_10_deg_knudsen: Option<f64>,
    /// Times at which the total angle of attack goes through 90 deg, s.
    pub hemisphere_change_times_s: Vec<f64>,
    /// Knudsen number at the last of them.
    pub last_hemisphere_change_knudsen: Option<f64>,
    /// Total angle of attack at the end, rad.
    pub final_total_alpha_rad: f64,
    /// Largest total angle of attack in the last 10 s, rad.
    pub final_amplitude_rad: f64,
    /// Largest transverse angular rate, rad/s, at the sampled points.
    pub maximum_transverse_rate_rad_s: f64,
}

/// Times of the loads at which the attitude is evaluated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Marks {
    /// Largest total heat flux, s after the start.
    pub peak_heating_time_s: f64,
    /// Largest deceleration, s after the start.
    pub peak_deceleration_time_s: f64,
}

/// The events of the attitude along a flight.
pub fn events(motion: RigidMotion, record: &Record<RIGID_STATES>, marks: Marks) -> AttitudeEvents {
    let course = Course { motion, record };
    let end_s = record.legs.last().map_or(0.0, |leg| leg.step.t1);
    let initial = course.alpha_rad(&record.start, &record.start_stage);
    let mut highest = Highest::from(0.0, initial);
    let heated_s = marks.peak_heating_time_s;
    let mut after_heating = Highest::from(heated_s, course.alpha_at_rad(heated_s));
    let last_s = (end_s - LAST_S).max(0.0);
    let mut last = Highest::from(last_s, course.alpha_at_rad(last_s));
    let mut first_below_s = (initial < SMALL_RAD).then_some(0.0);
    let mut turns = Vec::new();
    let mut turning = 0.0_f64;
    let mut before = initial;
    for leg in &record.legs {
        let motion = course.motion.in_stage(&leg.stage);
        let alpha = |t: f64| motion.total_alpha_in_rad(&leg.step, t);
        let (t0, t1) = (leg.step.t0, leg.step.t1);
        let part = (t1 - t0) / f64::from(PARTS);
        let mut top = (before, t0);
        let mut t_before = t0;
        for i in 1..=PARTS {
            let t = if i == PARTS {
                t1
            } else {
                t0 + f64::from(i) * part
            };
            let here = alpha(t);
            let [q, r] = [RATES + 1, RATES + 2].map(|i| leg.step.component(i, t));
            turning = turning.max((q * q + r * r).sqrt());
            let when = |level: f64| root::brent(|t| alpha(t) - level, t_before, t, 1e-9);
            if first_below_s.is_none() && here < SMALL_RAD {
                first_below_s = when(SMALL_RAD).or(Some(t));
            }
            if (before < FRAC_PI_2) != (here < FRAC_PI_2) {
                turns.push(when(FRAC_PI_2).unwrap_or(t));
            }
            if here > top.0 {
                top = (here, t);
            }
            (before, t_before) = (here, t);
        }
        for of in [&mut highest, &mut after_heating, &mut last] {
            of.look(leg, top, &alpha);
        }
    }
    AttitudeEvents {
        initial_total_alpha_rad: initial,
        maximum_total_alpha: highest.best,
        total_alpha_at_peak_heating_rad: course.alpha_at_rad(heated_s),
        maximum_total_alpha_after_peak_heating: after_heating.best,
        total_alpha_at_peak_deceleration_rad: course.alpha_at_rad(marks.peak_deceleration_time_s),
        first_below_10_deg_time_s: first_below_s,
        first_below_10_deg_knudsen: first_below_s.map(|t| course.knudsen(t)),
        last_hemisphere_change_knudsen: turns.last().map(|t| course.knudsen(*t)),
        hemisphere_change_times_s: turns,
        final_total_alpha_rad: before,
        final_amplitude_rad: last.best.angle_rad,
        maximum_transverse_rate_rad_s: turning,
    }
}

/// The largest angle from a time on.
struct Highest {
    from_s: f64,
    best: AngleAt,
}

impl Highest {
    fn from(from_s: f64, angle_rad: f64) -> Highest {
        let time_s = from_s;
        Highest {
            from_s,
            best: AngleAt { angle_rad, time_s },
        }
    }

    /// Searches for a larger angle near the highest point of a step.
    fn look(
        &mut self,
        leg: &Leg<RIGID_STATES>,
        (top, t_top): (f64, f64),
        alpha: &dyn Fn(f64) -> f64,
    ) {
        let (t0, t1) = (leg.step.t0, leg.step.t1);
        if t1 <= self.from_s || top < NEARLY * self.best.angle_rad {
            return;
        }
        let part = (t1 - t0) / f64::from(PARTS);
        let low = (t_top - part).max(t0).max(self.from_s);
        let high = (t_top + part).min(t1);
        if high <= low {
            return;
        }
        let (time_s, angle_rad) = root::maximum(alpha, low, high, TOLERANCE * (t1 - t0));
        if angle_rad > self.best.angle_rad {
            self.best = AngleAt { angle_rad, time_s };
        }
    }
}

struct Course<'a, 'r> {
    motion: RigidMotion<'a>,
    record: &'r Record<RIGID_STATES>,
}

impl Course<'_, '_> {
    fn alpha_rad(&self, y: &[f64; RIGID_STATES], stage: &Stage) -> f64 {
        self.motion.in_stage(stage).total_alpha_rad(y)
    }

    /// State and piece of the atmosphere at a time, s.
    fn state(&self, t: f64) -> ([f64; RIGID_STATES], Stage) {
        let legs = &self.record.legs;
        let leg = legs.partition_point(|leg| leg.step.t1 < t);
        match legs.get(leg.min(legs.len().saturating_sub(1))) {
            Some(leg) => (leg.step.at(t), leg.stage),
            None => (self.record.start, self.record.start_stage),
        }
    }

    fn alpha_at_rad(&self, t: f64) -> f64 {
        let (y, stage) = self.state(t);
        self.alpha_rad(&y, &stage)
    }

    fn knudsen(&self, t: f64) -> f64 {
        let (y, stage) = self.state(t);
        let motion = self.motion.in_stage(&stage);
        motion.point.knudsen(&motion.point.surroundings(&head(&y)))
    }
}
