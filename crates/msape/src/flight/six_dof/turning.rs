//! Whether a vehicle turns nose first: one entry from a small fixed set of attitudes and pitch rates.
//!
//! ```text
//! share = n(α < 90 deg at peak heating)/n
//! ```
//!
//! with α the total angle of attack, n entries: 175, 145 and 120 deg, each with −2, 0 and 2 deg/s of pitch, no yaw, and the roll
//! rate of the case. α and rate are those at the start of the mission.
//!
//! # Valid
//! Rigid bodies. A set, not a probability: nine corners beside which others may turn or not. A flight ends where the vehicle
//! as a point mass, nose first, passes Mach 5; where the largest heat rate is not behind it by then, at its own end.
//!
//! # References
//! - \[samareh-2014\] section 3.3.2 (aft end first, and rates of one to two degrees a second); the attitudes are assumed.

use super::attitude::{Given, at_start};
use super::events::AttitudeEvents;
use super::fly_watched;
use super::reorientation::{Facing, facing};
use super::rigid::Rigid;
use crate::flight::freedom::Freedom;
use crate::flight::mission::{Body, Mission};
use crate::flight::{Flight, Request, fly};
use crate::progress::{Part, Progress};
use nalgebra::Vector3;
use numerics::math::RADIANS_PER_DEGREE;
use serde::{Deserialize, Serialize};
use std::ops::ControlFlow;

/// Total angles of attack at the start, deg: nearly backward, about the trims of shipped vehicles, beyond broadside.
const ALPHAS_DEG: [f64; 3] = [175.0, 145.0, 120.0];
/// Pitch rates at the start, deg/s.
const RATES_DEG_S: [f64; 3] = [-2.0, 0.0, 2.0];
/// Number of entries of the set.
pub const ENTRIES: usize = ALPHAS_DEG.len() * RATES_DEG_S.len();

/// Attitude and rate from which an entry starts.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Start {
    /// Angle of attack, rad.
    pub alpha_rad: f64,
    /// Inertial pitch rate, rad/s.
    pub pitch_rate_rad_s: f64,
}

impl Start {
    /// The starts of the set, by angle, then by rate.
    pub fn all() -> [Start; ENTRIES] {
        core::array::from_fn(|i| {
            let (row, column) = (i / RATES_DEG_S.len(), i % RATES_DEG_S.len());
            let of = |list: &[f64], i: usize| list.get(i).copied().unwrap_or_default();
            Start {
                alpha_rad: of(&ALPHAS_DEG, row) * RADIANS_PER_DEGREE,
                pitch_rate_rad_s: of(&RATES_DEG_S, column) * RADIANS_PER_DEGREE,
            }
        })
    }
}

/// One entry of the set.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Turn {
    /// Attitude and rate at the start.
    pub start: Start,
    /// Orientation from peak heating on.
    pub facing: Facing,
    /// Altitude of the largest total heat flux, m.
    pub peak_heating_altitude_m: f64,
    /// Events of the attitude up to the end of the flight.
    pub attitude: AttitudeEvents,
}

/// The entries that were flown.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Turning {
    /// Entries, in the order of [`Start::all`].
    pub entries: Vec<Turn>,
}

impl Turning {
    /// Entries that are nose first at peak heating.
    pub fn nose_first(&self) -> usize {
        let those = self.entries.iter();
        those.filter(|e| e.facing != Facing::Backward).count()
    }

    /// Share of the flown entries that are nose first at peak heating; `None` where none was flown.
    pub fn nose_first_share(&self) -> Option<f64> {
        let flown = self.entries.len();
        (flown > 0).then(|| self.nose_first() as f64 / flown as f64)
    }
}

/// Flies the set; what is finished when it is stopped is kept. Nothing where the body has no attitude.
pub fn turning(mission: &Mission, body: &Body, progress: &mut dyn Progress) -> Option<Turning> {
    let Freedom::Rigid(_) = &body.freedom else {
        return None;
    };
    let mut entries = Vec::with_capacity(ENTRIES);
    for (i, start) in Start::all().into_iter().enumerate() {
        let part = |i: usize| i as f64 / ENTRIES as f64;
        let (from, to) = (part(i), part(i + 1));
        let whole = &mut *progress;
        match turn(mission, body, start, &mut Part { whole, from, to }) {
            Some(entry) => entries.push(entry),
            None => break,
        }
    }
    Some(Turning { entries })
}

/// Flies one entry; `None` where it was stopped or the body has no attitude.
pub fn turn(
    mission: &Mission,
    body: &Body,
    start: Start,
    progress: &mut dyn Progress,
) -> Option<Turn> {
    let Freedom::Rigid(rigid) = &body.freedom else {
        return None;
    };
    let rigid = Rigid {
        attitude: at_start(
            &Given::AlphaBetaBank([start.alpha_rad, 0.0, 0.0]),
            &mission.start,
            mission,
        ),
        rates_rad_s: Vector3::new(rigid.rates_rad_s.x, start.pitch_rate_rad_s, 0.0),
        ..(**rigid).clone()
    };
    let mut watch = Watch {
        progress,
        stopped: false,
    };
    let mut short = mission.clone();
    let slow_s = slow_s(mission, body);
    short.stop.time_s = earlier(mission.stop.time_s, slow_s);
    let (mut flight, ..) = fly_watched(&short, body, &rigid, Request::Nothing, &mut watch);
    // A backward vehicle may decelerate more slowly: the flight continues while its heat flux still grows.
    if slow_s.is_some() && !watch.stopped && heats_at_its_end(&flight) {
        (flight, ..) = fly_watched(mission, body, &rigid, Request::Nothing, &mut watch);
    }
    let attitude = flight.attitude.filter(|_| !watch.stopped)?;
    Some(Turn {
        start,
        facing: facing(&attitude),
        peak_heating_altitude_m: flight.peak_total_heat_flux_w_m2.altitude_m,
        attitude,
    })
}

/// Time at which the point mass passes Mach 5, s.
fn slow_s(mission: &Mission, body: &Body) -> Option<f64> {
    let point = Body {
        freedom: Freedom::Ballistic,
        ..body.clone()
    };
    let [mach_5_s, ..] = fly(mission, &point, Request::Nothing).0.mach_times_s;
    mach_5_s
}

fn earlier(a: Option<f64>, b: Option<f64>) -> Option<f64> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.min(b)),
        (one, other) => one.or(other),
    }
}

fn heats_at_its_end(flight: &Flight) -> bool {
    flight.peak_total_heat_flux_w_m2.time_s >= flight.time_of_flight_s * (1.0 - 1e-6)
}

/// Remembers whether the work was stopped.
struct Watch<'a> {
    progress: &'a mut dyn Progress,
    stopped: bool,
}

impl Progress for Watch<'_> {
    fn advance(&mut self, done: f64) -> ControlFlow<()> {
        let answer = self.progress.advance(done);
        self.stopped |= answer.is_break();
        answer
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::FlightProblem;
    use crate::progress::Unwatched;
    use crate::{Case, Library, library};

    fn shipped(name: &str) -> FlightProblem {
        let text = library::data_file(name).unwrap();
        FlightProblem::check(
            &Case::from_text(text).unwrap(),
            &Library::builtin().unwrap(),
        )
        .unwrap()
    }

    #[test]
    fn the_set_is_three_angles_by_three_rates() {
        let [first, second, .., last] = Start::all();
        let degrees = |x: f64| x / RADIANS_PER_DEGREE;
        assert!((degrees(first.alpha_rad) - 175.0).abs() < 1e-12);
        assert!((degrees(first.pitch_rate_rad_s) + 2.0).abs() < 1e-12);
        assert!((degrees(second.alpha_rad) - 175.0).abs() < 1e-12);
        assert_eq!(second.pitch_rate_rad_s, 0.0);
        assert!((degrees(last.alpha_rad) - 120.0).abs() < 1e-12);
    }

    #[test]
    fn an_entry_of_the_set_is_the_flight_of_the_case_as_far_as_both_go() {
        // The case starts at 175 deg without rates, as the second entry does.
        let FlightProblem { mission, body, .. } = shipped("cases/backward-entry.toml");
        let entry = turn(&mission, &body, Start::all()[1], &mut Unwatched).unwrap();
        let whole = fly(&mission, &body, Request::Nothing).0.attitude.unwrap();
        let (a, b) = (
            entry.attitude.total_alpha_at_peak_heating_rad,
            whole.total_alpha_at_peak_heating_rad,
        );
        // The angle at a time that is found on the last step may differ where the step is cut.
        assert!((a - b).abs() < 1e-6, "{a} against {b}");
        assert_eq!(
            entry.attitude.hemisphere_change_times_s,
            whole.hemisphere_change_times_s
        );
        assert_eq!(entry.facing, Facing::Forward);
    }

    #[test]
    fn what_is_finished_when_it_is_stopped_is_kept() {
        let FlightProblem { mission, body, .. } = shipped("cases/backward-entry.toml");
        let mut calls = 0_u32;
        let mut watcher = |done: f64| {
            calls += 1;
            match done < 1.5 / ENTRIES as f64 {
                true => ControlFlow::Continue(()),
                false => ControlFlow::Break(()),
            }
        };
        let kept = turning(&mission, &body, &mut watcher).unwrap();
        assert_eq!(kept.entries.len(), 1);
        assert_eq!(kept.nose_first_share(), Some(1.0));
        assert!(calls > 100, "{calls}");
        let mut at_once = |_: f64| ControlFlow::Break(());
        let none = turning(&mission, &body, &mut at_once).unwrap();
        assert_eq!(none.nose_first_share(), None);
        assert_eq!(
            turning(
                &mission,
                &Body {
                    freedom: Freedom::Ballistic,
                    ..body
                },
                &mut Unwatched
            ),
            None
        );
    }
}
