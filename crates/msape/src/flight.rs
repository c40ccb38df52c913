//! Flight of a vehicle from the entry state to the ground.
//!
//! - [`three_dof`]: three degrees of freedom over the rotating oblate planet, the high-fidelity model.
//! - [`six_dof`]: six degrees of freedom over the same planet, for attitude.
//! - [`allen_eggers`]: the closed form for steep ballistic entry, the low-fidelity twin.
//! - [`mission`]: what is flown, through what, from where, until when.
//! - [`summary`]: peaks, loads and end of a flight.
//! - [`trajectory`], [`columns`]: the time history.

use crate::finding::range::short;
use crate::finding::{Finding, Severity};
use crate::heating::PeakConditions;
use crate::outcome::Outcome;
use crate::planet::atmosphere::Atmosphere;
use crate::planet::horizon::Velocity;
use crate::quantity::input;
use freedom::Freedom;
use mission::{Body, Mission, Model};
use numerics::scalar::Scalar;
use phase::Begun;
use points::PointHeat;
use reach::{Passed, Push};
use serde::{Deserialize, Serialize};

pub use six_dof::events::AttitudeEvents;
pub use trajectory::{Request, Trajectory};

pub mod accuracy;
pub mod allen_eggers;
pub mod batch;
pub mod columns;
pub mod equations;
pub mod freedom;
pub mod held;
pub mod integration;
pub mod lift;
pub mod mission;
pub mod motion;
pub mod numbers;
pub mod peaks;
pub mod phase;
pub mod points;
pub mod reach;
pub mod sample;
pub mod six_dof;
pub mod summary;
pub mod three_dof;
pub mod trajectory;
pub mod trim;
pub mod within;

/// A largest value and where it occurs.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Peak<S = f64> {
    /// The largest value, in the SI unit of the quantity.
    pub value: S,
    /// Time after the start, s.
    pub time_s: S,
    /// Geodetic altitude, m.
    pub altitude_m: S,
    /// Speed relative to the planet, m/s.
    pub speed_m_s: S,
    /// Density of the air, kg/m³.
    pub density_kg_m3: S,
}

/// A flight: its peaks, loads and end.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Flight<S = f64> {
    /// Model that flew it.
    pub model: Model,
    /// Entry state relative to the planet.
    pub entry_relative: Velocity<S>,
    /// Inertial entry state.
    pub entry_inertial: Velocity<S>,
    /// Aerodynamic force over mass over 9.80665 m/s².
    pub peak_deceleration_earth_g: Peak<S>,
    /// Dynamic pressure, Pa.
    pub peak_dynamic_pressure_pa: Peak<S>,
    /// Stagnation pressure about the largest dynamic pressure, Pa.
    pub peak_stagnation_pressure_pa: Peak<S>,
    /// Convective heat flux at the stagnation point without margin, W/m².
    pub peak_convective_heat_flux_w_m2: Peak<S>,
    /// Radiative heat flux at the stagnation point without margin, W/m²; absent where there is none.
    pub peak_radiative_heat_flux_w_m2: Option<Peak<S>>,
    /// Sum of both without margin, W/m².
    pub peak_total_heat_flux_w_m2: Peak<S>,
    /// Sum of both with their margins, W/m².
    pub peak_total_margined_heat_flux_w_m2: Peak<S>,
    /// Convective heat load without margin, J/m².
    pub convective_heat_load_j_m2: S,
    /// Radiative heat load without margin, J/m².
    pub radiative_heat_load_j_m2: S,
    /// Margin on convective heating.
    pub convective_margin: f64,
    /// Margin on radiative heating.
    pub radiative_margin: f64,
    /// Largest radiative-equilibrium temperature of the stagnation point under the heating with margins, K.
    pub peak_wall_temperature_k: S,
    /// Ballistic coefficient at peak deceleration, kg/m².
    pub ballistic_coefficient_kg_m2: S,
    /// Time from the start to the end, s.
    pub time_of_flight_s: S,
    /// Altitude at the end, m.
    pub final_altitude_m: S,
    /// Speed relative to the planet at the end, m/s.
    pub final_speed_m_s: S,
    /// Angle of that velocity against the geodetic horizon, negative down, rad.
    pub final_flight_path_angle_rad: S,
    /// Geodetic latitude at the end, rad.
    pub final_latitude_rad: S,
    /// Longitude at the end, rad.
    pub final_longitude_rad: S,
    /// Density of the air at the end, kg/m³.
    pub final_density_kg_m3: S,
    /// Distance from start to end over the figure of the planet, m.
    pub downrange_m: S,
    /// Downward crossings of Mach 5, 2, 1.4 and 0.8 after peak deceleration, s.
    pub mach_times_s: [Option<S>; 4],
    /// Time history, where requested.
    pub trajectory: Option<Trajectory>,
    /// Ends of tables of the case that it passed.
    pub passed: Vec<Passed>,
    /// Place where the air pushed the vehicle, as air cannot.
    pub pushed: Option<Push>,
    /// Lowest and highest altitude between two steps, m.
    pub altitudes_m: [f64; 2],
    /// Phases that began.
    pub phases: Vec<Begun<S>>,
    /// Heating at the points of the body for which the case gives it.
    pub points: Vec<PointHeat<S>>,
    /// Number of times it left the atmosphere and flew on.
    pub exits: u32,
    /// Attitude along the flight, in six degrees of freedom.
    pub attitude: Option<AttitudeEvents>,
    /// Evaluations of the right-hand side.
    pub evaluations: u64,
}

impl<S: Scalar> Flight<S> {
    /// Sum of both heat loads, each with its margin, J/m².
    pub fn total_margined_heat_load_j_m2(&self) -> S {
        self.convective_heat_load_j_m2 * self.convective_margin
            + self.radiative_heat_load_j_m2 * self.radiative_margin
    }
}

/// Flies a vehicle: the flight, how it ended, and why.
pub fn fly(mission: &Mission, body: &Body, request: Request) -> (Flight, Outcome, Option<String>) {
    let (flight, outcome, reason) = match &body.freedom {
        _ if mission.solver.model == Model::AllenEggers => {
            let flight = allen_eggers::fly(mission, body, request);
            let (outcome, reason) = allen_eggers::ending(mission, &flight);
            (flight, outcome, reason)
        }
        Freedom::Rigid(rigid) => six_dof::fly(mission, body, rigid, request),
        Freedom::Ballistic | Freedom::Lifting(_) => {
            let record = three_dof::integrate(mission, body);
            let flight = summary::summarize(three_dof::motion(mission, body), &record, request);
            (flight, record.outcome, record.reason)
        }
    };
    let (outcome, reason) = flight.ending(outcome, reason);
    (flight, outcome, reason)
}

impl Flight {
    /// Outcome and reason; a flight whose results are not all finite numbers is given up.
    pub fn ending(&self, outcome: Outcome, reason: Option<String>) -> (Outcome, Option<String>) {
        match self.not_finite() {
            Some(name) => (
                Outcome::GaveUp,
                Some(format!("the {name} is not a finite number")),
            ),
            None => (outcome, reason),
        }
    }

    /// A result that is not a finite number, by its name; such a flight is not to be used.
    pub fn not_finite(&self) -> Option<&'static str> {
        let peak = |name: &'static str, peak: &Peak| {
            let values = [peak.value, peak.time_s, peak.altitude_m, peak.speed_m_s];
            (name, values.iter().sum::<f64>())
        };
        let named = [
            peak("peak deceleration", &self.peak_deceleration_earth_g),
            peak("peak dynamic pressure", &self.peak_dynamic_pressure_pa),
            peak(
                "peak stagnation pressure",
                &self.peak_stagnation_pressure_pa,
            ),
            peak("peak heat flux", &self.peak_total_margined_heat_flux_w_m2),
            ("convective heat load", self.convective_heat_load_j_m2),
            ("radiative heat load", self.radiative_heat_load_j_m2),
            ("peak wall temperature", self.peak_wall_temperature_k),
            ("time of flight", self.time_of_flight_s),
            ("final altitude", self.final_altitude_m),
            ("final speed", self.final_speed_m_s),
            ("final latitude", self.final_latitude_rad),
            ("final longitude", self.final_longitude_rad),
            ("downrange", self.downrange_m),
        ];
        let mut wild = named.into_iter().filter(|(_, value)| !value.is_finite());
        wild.next().map(|(name, _)| name)
    }
}

/// Findings of a flight: use outside the ranges of the heating models and of the atmosphere.
pub fn findings(mission: &Mission, body: &Body, flight: &Flight) -> Vec<Finding> {
    let peak = flight.peak_total_heat_flux_w_m2;
    let mut findings = mission.heating.findings(&PeakConditions {
        density_kg_m3: peak.density_kg_m3,
        speed_m_s: peak.speed_m_s,
        nose_radius_m: body.nose_radius_m,
    });
    let pressure_pa = flight.peak_stagnation_pressure_pa.value;
    findings.extend(mission.heating.pressure.findings(pressure_pa));
    if let (Freedom::Rigid(rigid), Some(attitude)) = (&body.freedom, &flight.attitude) {
        findings.extend(six_dof::remarks::findings(rigid, attitude));
    }
    findings.extend(assumed_air(mission, flight));
    if let Some(body) = &mission.heating.body {
        findings.extend(points::finding(body, &flight.points));
    }
    findings.extend(flight.passed.iter().map(Passed::finding));
    findings.extend(flight.pushed.as_ref().map(Push::finding));
    findings.extend(flight.trajectory.as_ref().and_then(Trajectory::finding));
    findings.extend(came_back(flight));
    findings.extend(phase::findings(mission, &flight.phases));
    findings.extend(accuracy::finding(mission, body, flight));
    findings
}

/// Distance from an altitude at which a flight is there, m.
pub const LANDED_WITHIN_M: f64 = 1e-3;

/// Finding of a flight through a part of the atmosphere that is assumed; `None` where there is none.
fn assumed_air(mission: &Mission, flight: &Flight) -> Option<Finding> {
    let Atmosphere::Table(table) = &mission.atmosphere else {
        return None;
    };
    let above_m = table.assumed_above_m()?;
    let [_, highest_m] = flight.altitudes_m;
    let peak_m = flight.peak_deceleration_earth_g.altitude_m;
    let there = match peak_m > above_m {
        true => "lies there, too",
        false => "lies below",
    };
    (highest_m > above_m).then(|| Finding {
        severity: Severity::Extrapolated,
        model: "atmosphere".to_string(),
        key: input::entry::ALTITUDE_M.to_string(),
        value: Some(highest_m),
        valid: (None, Some(above_m)),
        message: format!(
            "Above {} km the air is assumed: nothing is measured there, and the last temperature is continued in hydrostatic balance. The flight goes up to {} km; its peak deceleration, at {} km, {there}.",
            short(above_m / 1e3),
            short(highest_m / 1e3),
            short(peak_m / 1e3)
        ),
        source: "the data file of the atmosphere".to_string(),
        field: Some(input::entry::ATMOSPHERE.to_string()),
    })
}

/// Finding of a flight that left the atmosphere and came back; `None` for any other.
fn came_back(flight: &Flight) -> Option<Finding> {
    let exits = flight.exits;
    let times = if exits == 1 { "once" } else { "more than once" };
    (exits > 0).then(|| Finding {
        severity: Severity::Note,
        model: "passes".to_string(),
        key: input::stop::PASSES.to_string(),
        value: Some(f64::from(exits)),
        valid: (None, None),
        message: format!(
            "The vehicle left the atmosphere {times}; peaks and loads are over all its passes."
        ),
        source: "convention of this program".to_string(),
        field: Some(input::stop::PASSES.to_string()),
    })
}

#[cfg(test)]
mod tests;
