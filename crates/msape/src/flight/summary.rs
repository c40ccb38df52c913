//! Peaks, loads and end of an integrated flight, and its time history.

use super::equations::{CONVECTIVE, RADIATIVE};
use super::integration::{Leg, Record};
use super::mission::{Body, Mission, Model};
use super::motion::{Motion, head};
use super::peaks::Peaks;
use super::phase::{Begun, Stage};
use super::points;
use super::reach::{Passed, axes, of_atmosphere, passed};
use super::sample::{self, Sample};
use super::trajectory::{Request, Trajectory};
use super::{Flight, Peak};
use numerics::ode::event::root_between;
use numerics::scalar::Single;

/// Mach numbers whose downward crossing is reported.
pub const MACH_MARKS: [f64; 4] = [5.0, 2.0, 1.4, 0.8];

/// A crossing of a Mach number is met within this time, s.
const MACH_TIME_TOLERANCE_S: f64 = 1e-9;

/// Summarizes a record of a motion.
pub fn summarize<'a, M: Motion<'a, N, S>, const N: usize, S: Single>(
    motion: M,
    record: &Record<N, S>,
    request: Request,
) -> Flight<S> {
    let flight = Reading { motion, record };
    let point = motion.point();
    let (mission, numbers) = (point.mission, point.numbers());
    let peaks = Peaks::new(motion, record);
    let deceleration = peaks.of(|l| l.deceleration_earth_g);
    let dynamic_pressure = peaks.of(|l| l.dynamic_pressure_pa);
    let radiative = peaks.of(|l| l.heat_flux.radiative_w_m2);
    let margined = peaks.of(|l| mission.heating.margined(&l.heat_flux).total_w_m2());
    let (t_end, y_end, stage_end) = flight.end();
    let start = sample::position(mission, &head(&record.start));
    let end = sample::position(mission, &head(&y_end));
    let (at_peak, [mass_kg, area_m2]) = flight.around(deceleration.time_s);
    Flight {
        model: Model::ThreeDof,
        entry_relative: numbers.start.relative,
        entry_inertial: numbers.start.inertial,
        peak_deceleration_earth_g: deceleration,
        peak_stagnation_pressure_pa: peaks.of_stagnation_pressure(&dynamic_pressure),
        peak_dynamic_pressure_pa: dynamic_pressure,
        peak_convective_heat_flux_w_m2: peaks.of(|l| l.heat_flux.convective_w_m2),
        peak_radiative_heat_flux_w_m2: (radiative.value.value() > 0.0).then_some(radiative),
        peak_total_heat_flux_w_m2: peaks.of(|l| l.heat_flux.total_w_m2()),
        peak_total_margined_heat_flux_w_m2: margined,
        convective_heat_load_j_m2: y_end[CONVECTIVE],
        radiative_heat_load_j_m2: y_end[RADIATIVE],
        convective_margin: mission.heating.options.margin,
        radiative_margin: mission.heating.radiative_margin,
        peak_wall_temperature_k: flight.wall_temperature_k(margined.time_s),
        ballistic_coefficient_kg_m2: mass_kg / (at_peak * area_m2),
        time_of_flight_s: t_end,
        final_altitude_m: end.altitude_m,
        final_speed_m_s: (y_end[3] * y_end[3] + y_end[4] * y_end[4] + y_end[5] * y_end[5]).sqrt(),
        final_flight_path_angle_rad: sample::flight_path_angle_rad(mission, &head(&y_end)),
        final_latitude_rad: end.latitude_rad,
        final_longitude_rad: end.longitude_rad,
        final_density_kg_m3: (motion.in_stage(&stage_end).point())
            .surroundings(&head(&y_end))
            .density_kg_m3,
        downrange_m: mission.planet.distance_m(&start, &end),
        mach_times_s: flight.mach_times_s(deceleration.time_s.value()),
        trajectory: flight.trajectory(request),
        passed: passed_ends(mission, point.body, record),
        pushed: record.pushed,
        altitudes_m: record.altitudes.ends(),
        phases: flight.phases(),
        points: points::of(motion, record, &peaks),
        exits: record.exits,
        attitude: None,
        evaluations: record.evaluations,
    }
}

/// The ends of tables that a flight passed; the altitudes of the atmosphere are known without looking it up.
fn passed_ends<const N: usize, S>(
    mission: &Mission,
    body: &Body,
    record: &Record<N, S>,
) -> Vec<Passed> {
    let axes = axes(mission, body);
    let mut ends = passed(&axes, &record.spans, record.refused);
    let air = of_atmosphere(mission).filter(|air| !axes.contains(air));
    if let Some(air) = air {
        let of_air = passed(&[air], &[record.altitudes], None);
        ends.splice(0..0, of_air);
    }
    ends
}

/// The few results that sizing a vehicle needs, at a fraction of the cost of a whole [`Flight`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremes<S = f64> {
    /// Aerodynamic force over mass over 9.80665 m/s².
    pub peak_deceleration_earth_g: Peak<S>,
    /// Stagnation pressure about the largest dynamic pressure, Pa.
    pub peak_stagnation_pressure_pa: Peak<S>,
    /// Sum of both heat fluxes with their margins, W/m².
    pub peak_total_margined_heat_flux_w_m2: Peak<S>,
    /// Convective heat load without margin, J/m².
    pub convective_heat_load_j_m2: S,
    /// Radiative heat load without margin, J/m².
    pub radiative_heat_load_j_m2: S,
    /// Time from the start to the end, s.
    pub time_of_flight_s: S,
    /// Speed relative to the planet at the end, m/s.
    pub final_speed_m_s: S,
}

/// The extremes of a record of a motion; the same numbers as [`summarize`] gives.
pub fn extremes<'a, M: Motion<'a, N, S>, const N: usize, S: Single>(
    motion: M,
    record: &Record<N, S>,
) -> Extremes<S> {
    let heating = &motion.point().mission.heating;
    let peaks = Peaks::new(motion, record);
    let dynamic_pressure = peaks.of(|l| l.dynamic_pressure_pa);
    let (t_end, y_end, _) = Reading { motion, record }.end();
    Extremes {
        peak_deceleration_earth_g: peaks.of(|l| l.deceleration_earth_g),
        peak_stagnation_pressure_pa: peaks.of_stagnation_pressure(&dynamic_pressure),
        peak_total_margined_heat_flux_w_m2: peaks
            .of(|l| heating.margined(&l.heat_flux).total_w_m2()),
        convective_heat_load_j_m2: y_end[CONVECTIVE],
        radiative_heat_load_j_m2: y_end[RADIATIVE],
        time_of_flight_s: t_end,
        final_speed_m_s: (y_end[3] * y_end[3] + y_end[4] * y_end[4] + y_end[5] * y_end[5]).sqrt(),
    }
}

struct Reading<'r, M, const N: usize, S> {
    motion: M,
    record: &'r Record<N, S>,
}

impl<'a, M: Motion<'a, N, S>, const N: usize, S: Single> Reading<'_, M, N, S> {
    fn end(&self) -> (S, [S; N], Stage<S>) {
        match self.record.legs.last() {
            Some(leg) => (leg.step.t1, leg.step.y1, leg.stage),
            None => (S::constant(0.0), self.record.start, self.record.start_stage),
        }
    }

    /// The leg that contains an instant.
    fn leg(&self, t: f64) -> Option<&Leg<N, S>> {
        let legs = &self.record.legs;
        let before = legs.partition_point(|leg| leg.step.t1.value() < t);
        legs.get(before.min(legs.len().saturating_sub(1)))
    }

    fn state(&self, t: S) -> ([S; N], Stage<S>) {
        match self.leg(t.value()) {
            Some(leg) => (leg.step.at(t), leg.stage),
            None => (self.record.start, self.record.start_stage),
        }
    }

    /// Drag coefficient at an instant, never zero, so that it may divide; mass, kg, and reference area, m².
    fn around(&self, t: S) -> (S, [S; 2]) {
        let (y, stage) = self.state(t);
        let motion = self.motion.in_stage(&stage);
        let numbers = motion.point().numbers();
        let drag_coefficient = motion.drag_coefficient(t, &y);
        (
            drag_coefficient.max(S::constant(f64::MIN_POSITIVE)),
            [numbers.mass_kg, numbers.reference_area_m2],
        )
    }

    /// The phases that began.
    fn phases(&self) -> Vec<Begun<S>> {
        let begun = &self.record.begun;
        let of = |(i, (t, y, stage)): (usize, &(S, [S; N], Stage<S>))| {
            let motion = self.motion.in_stage(stage);
            let point = motion.point();
            let around = point.surroundings(&head(y));
            let loads = motion.loads(*t, y);
            let name = point.mission.phases.get(i).map(|phase| phase.name.clone());
            let during = |leg: &&Leg<N, S>| leg.stage.phases == i + 1;
            let largest = self
                .record
                .legs
                .iter()
                .filter(during)
                .fold(loads.deceleration_earth_g, |largest, leg| {
                    largest.max(leg.loads.deceleration_earth_g)
                });
            Begun {
                name: name.unwrap_or_default(),
                time_s: *t,
                altitude_m: around.altitude_m,
                speed_m_s: (y[3] * y[3] + y[4] * y[4] + y[5] * y[5]).sqrt(),
                mach: around.air_speed_m_s / point.sound_m_s(around.altitude_m),
                dynamic_pressure_pa: loads.dynamic_pressure_pa,
                peak_deceleration_earth_g: largest,
            }
        };
        begun.iter().enumerate().map(of).collect()
    }

    fn wall_temperature_k(&self, t: S) -> S {
        let (y, stage) = self.state(t);
        let motion = self.motion.in_stage(&stage);
        let mission = motion.point().mission;
        let around = motion.around(&y);
        let loads = motion.loads_in(t, &y, &around);
        let margined = mission.heating.margined(&loads.heat_flux);
        sample::wall_temperature_k(mission, &margined, around.air_speed_m_s)
    }

    /// Downward crossings of [`MACH_MARKS`] after `t_peak`.
    fn mach_times_s(&self, t_peak: f64) -> [Option<S>; 4] {
        let mut times = [None; 4];
        let legs = &self.record.legs;
        let first = legs.partition_point(|leg| leg.step.t1.value() < t_peak);
        let mut before: Option<f64> = None;
        for leg in legs.iter().skip(first) {
            let motion = self.motion.in_stage(&leg.stage);
            let step = &leg.step;
            let span = [step.t0.value().max(t_peak), step.t1.value()];
            let mach = |t: S| sample::mach(motion.point(), &head(&step.at(t)));
            let ends = span.map(|t| step.time(t));
            let start = before.unwrap_or_else(|| mach(ends[0]).value());
            let end = mach(ends[1]).value();
            for (time, mark) in times.iter_mut().zip(MACH_MARKS) {
                if time.is_none() && start > mark && end <= mark {
                    *time = root_between(step, |t| mach(t) - mark, span, MACH_TIME_TOLERANCE_S);
                }
            }
            if times.iter().all(Option::is_some) {
                break;
            }
            before = Some(end);
        }
        times
    }

    fn trajectory(&self, request: Request) -> Option<Trajectory> {
        let mission = self.motion.point().mission;
        let start = sample::position(mission, &head(&self.record.start));
        let mut history = Trajectory::new();
        let mut coarsened_s = None;
        let mut add = |t: S, y: &[S; N], stage: &Stage<S>| {
            history.push(&Sample::new(&self.motion.in_stage(stage), t, y, &start));
        };
        match request {
            Request::Nothing => return None,
            Request::Steps => {
                let zero = S::constant(0.0);
                add(zero, &self.record.start, &self.record.start_stage);
                for leg in &self.record.legs {
                    add(leg.step.t1, &leg.step.y1, &leg.stage);
                }
            }
            Request::Uniform(step_s) => {
                let (t_end, y_end, stage_end) = self.end();
                let asked_s = step_s;
                let step_s = asked_s.max(t_end.value() / MOST_ROWS);
                coarsened_s = (step_s > asked_s).then_some([asked_s, step_s]);
                let rows = (t_end.value() / step_s) as u64;
                for i in 0..=rows {
                    let t = i as f64 * step_s;
                    if t < t_end.value() {
                        let t = S::constant(t);
                        let (y, stage) = self.state(t);
                        add(t, &y, &stage);
                    }
                }
                add(t_end, &y_end, &stage_end);
            }
        }
        history.coarsened_s = coarsened_s;
        if !mission.phases.is_empty() {
            let names = mission.phases.iter().map(|phase| phase.name.clone());
            history.phases = core::iter::once("entry".to_string()).chain(names).collect();
        }
        Some(history)
    }
}

/// Largest number of rows of a time history at a uniform step.
const MOST_ROWS: f64 = 1e6;
