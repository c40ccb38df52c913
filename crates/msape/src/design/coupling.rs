//! The answer of a design: the vehicle to which the passes converge, or the reason why there is none.
//!
//! # Valid
//! Always ends: converged, not converged after the last pass, not closed, with a flight that leaves the atmosphere, or a table
//! beyond which the case does not allow extrapolation, or given up at a limit of work or where a number is not finite.
//!
//! # References
//! - \[samareh-2014\] section 2.2, steps 4 to 12.

use super::flown::with_history;
use super::given;
use super::inputs::DesignInput;
use super::lighter::{self, Searched};
use super::passes::{self, Cut, End, MOST_WORK, Made, Run, Way, Work};
use super::start::Start;
use super::{Design, Pass, Solution, misfit};
use crate::finding::Finding;
use crate::flight::mission::Model;
use crate::flight::{self, Request};
use crate::outcome::Outcome;
use crate::progress::Progress;
use crate::tps::limits;
use crate::vehicle::impact::landing::{Landing, TouchdownVelocity};
use crate::vehicle::impact::remarks;
use crate::vehicle::{NotClosed, Vehicle, VehicleInput};
use numerics::math::FRAC_PI_2;

/// A design whose passes have ended: its numbers, of which [`Coupled::solution`] makes a solution with remarks and landing.
#[derive(Debug)]
pub struct Coupled<'a> {
    searched: Searched<'a>,
    cut: Option<Cut>,
}

/// Designs a vehicle, from the numbers of another design where they are given.
///
/// With a start the passes end at the same vehicle to within the criterion; where they do not converge from it, they restart from
/// the guesses of the input, unless they were stopped or have used up the work. The observer is called after each pass and may stop
/// the passes there.
pub fn solve<'a>(
    input: &'a DesignInput,
    start: Option<&Start>,
    progress: &mut dyn Progress,
) -> Coupled<'a> {
    let mut work = Work::up_to(MOST_WORK, progress);
    let begin = |start: Option<&Start>, work: &mut Work| {
        let way = Way {
            from: start.map(|start| start.numbers),
            taught: start.map(|start| &start.memories),
            ..Way::default()
        };
        passes::run(input, way, work)
    };
    let mut first = begin(start, &mut work);
    if start.is_some() && first.converged().is_none() && work.end().is_none() {
        first = begin(None, &mut work);
    }
    let searched = lighter::than(input, first, &mut work);
    Coupled {
        searched,
        cut: work.end(),
    }
}

impl Coupled<'_> {
    fn made(&self) -> Option<&Made> {
        match &self.searched.run.end {
            End::Vehicle(made) => Some(made),
            _ => None,
        }
    }

    /// Outcome: how the passes ended.
    pub fn outcome(&self) -> Outcome {
        match &self.searched.run.end {
            End::Vehicle(made) => made.outcome,
            End::Departed { flown, .. } => flown.outcome,
            End::Unclosed(..) => Outcome::NotClosed,
        }
    }

    /// The vehicle of the last pass.
    pub fn vehicle(&self) -> Option<&Vehicle> {
        self.made().map(|made| &made.vehicle)
    }

    /// The passes.
    pub fn passes(&self) -> &[Pass] {
        &self.searched.run.passes
    }

    /// Start for the passes of a neighbor; `None` if these passes did not converge.
    pub fn start(&self) -> Option<Start> {
        self.searched.run.start()
    }

    /// The solution: remarks, landing, and the time history of the flight if requested.
    pub fn solution(self, request: Request) -> Solution {
        let remark = self.searched.remark();
        let Searched { run, heavier, .. } = self.searched;
        let Run {
            input, passes, end, ..
        } = run;
        let mut solution = match end {
            End::Vehicle(mut made) => {
                if let Some(heavier) = heavier {
                    heavier.explain(&mut made.vehicle);
                }
                Finished {
                    input: &input,
                    request,
                    made: *made,
                    passes,
                    cut: self.cut,
                }
                .solution()
            }
            End::Departed { body, flown } => flown.departed(&input, request, &body, passes),
            End::Unclosed(not_closed, vehicle) => unclosed(not_closed, &vehicle, passes),
        };
        solution.findings.extend(remark);
        solution
    }
}

fn unclosed(not_closed: NotClosed, input: &VehicleInput, passes: Vec<Pass>) -> Solution {
    let mut reason = not_closed.reason.clone();
    if let [first, .., last] = passes.as_slice() {
        // a vehicle closed before: the loads and heat shields that the passes asked for since have outgrown every diameter
        reason.push_str(&format!(
            " Pass 1 closed with {:.2} kg, pass {} with {:.2} kg: each vehicle asks for a heavier one, up to here.",
            first.mass_kg, last.number, last.mass_kg
        ));
    }
    Solution {
        outcome: Outcome::NotClosed,
        findings: misfit::findings(&not_closed, input),
        reason: Some(reason),
        flight: None,
        design: None,
        adjustments: Vec::new(),
        passes,
    }
}

/// The last pass, made into a solution.
struct Finished<'a> {
    input: &'a DesignInput,
    request: Request,
    made: Made,
    passes: Vec<Pass>,
    cut: Option<Cut>,
}

impl Finished<'_> {
    fn solution(self) -> Solution {
        let mut findings = self.findings();
        let landing = self.landing();
        findings.extend(remarks::findings(
            &self.made.vehicle,
            &landing,
            &self.input.vehicle.impact.ground,
        ));
        let Finished {
            input,
            request,
            made,
            passes,
            cut,
        } = self;
        let Made {
            vehicle,
            body,
            flown,
            sized,
            outcome,
        } = made;
        let flight = with_history(input, request, &body, flown.flight);
        let adjustments = vehicle.adjustments.clone();
        let last = passes.last();
        let reason = match outcome {
            Outcome::NotConverged | Outcome::GaveUp => {
                let which = cut.filter(|_| outcome == Outcome::GaveUp);
                let which = which.map_or("the last one allowed".to_string(), |cut| {
                    format!("after which {}", cut.reason())
                });
                let far = last.map_or(String::new(), |pass| match pass.mass_distance_kg {
                    Some(kg) => format!(", an estimated {kg:.3e} kg from where it settles"),
                    None => String::new(),
                });
                Some(format!(
                    "the mass had not settled in pass {}, {which}{far}",
                    passes.len()
                ))
            }
            _ => flown.reason,
        };
        let design = Design {
            forebody_tps: sized.forebody,
            aftbody_tps: sized.aftbody,
            forebody_tps_density_kg_m3: input.vehicle.forebody.tps_density_kg_m3,
            aftbody_tps_density_kg_m3: input.vehicle.aftbody_tps_density_kg_m3,
            aftbody_heat_flux_w_m2: sized.aft_environment.peak_heat_flux_w_m2,
            aftbody_heat_load_j_m2: sized.aft_environment.heat_load_j_m2,
            shoulder_heat_flux_w_m2: sized.stagnation.peak_heat_flux_w_m2
                * sized.off.heat_flux_ratio,
            shoulder_heat_load_j_m2: sized.stagnation.heat_load_j_m2 * sized.off.heat_load_ratio,
            shoulder_heat_flux_ratio: sized.off.heat_flux_ratio,
            forebody_judged: sized.environment,
            aftbody_pressure_pa: sized.aft_environment.peak_pressure_pa,
            payload_temperature_k: sized.payload_temperature_k,
            impact_drag_coefficient: input.drag.subsonic(),
            terminal_speed_m_s: flown.terminal_speed_m_s,
            cone_half_angle_rad: input.vehicle.cone_half_angle_rad,
            payload_mass_kg: input.vehicle.payload_mass_kg,
            structural: None,
            stability: None,
            turning: None,
            passes: passes.len() as u32,
            mass_residual_kg: last.and_then(|pass| pass.mass_distance_kg),
            landing,
            vehicle,
        };
        Solution {
            outcome,
            reason,
            flight: Some(flight),
            design: Some(design),
            adjustments,
            findings,
            passes,
        }
    }

    fn landing(&self) -> Landing {
        let flown = &self.made.flown;
        // the closed form keeps its angle to the ground: only the integrated flight knows where it comes down from
        let integrated = flown.flight.model == Model::ThreeDof;
        let angle_rad = match flown.outcome {
            Outcome::Landed | Outcome::Stopped if integrated => {
                flown.flight.final_flight_path_angle_rad
            }
            _ => -FRAC_PI_2,
        };
        let velocity = TouchdownVelocity::new(flown.impact_speed_m_s, angle_rad);
        Landing::new(&self.input.vehicle, &self.made.vehicle, velocity)
    }

    fn findings(&self) -> Vec<Finding> {
        let input = self.input;
        let Made {
            vehicle,
            body,
            flown,
            sized,
            ..
        } = &self.made;
        let shoulder_ratio =
            2.0 * vehicle.dimensions.shoulder_radius_m / vehicle.dimensions.diameter_m;
        let mut findings = limits::findings(
            &input.forebody_material,
            &sized.environment,
            &sized.forebody,
        );
        findings.extend(limits::findings(
            &input.aftbody_material,
            &sized.aft_environment,
            &sized.aftbody,
        ));
        findings.extend(
            input
                .fit_space
                .findings(&sized.environment, flown.flight.ballistic_coefficient_kg_m2),
        );
        findings.extend(flight::findings(&input.mission, body, &flown.flight));
        if input.mission.heating.body.is_none() {
            findings.extend(input.shoulder.findings(shoulder_ratio));
        }
        findings.push(sized.environment.judged(input.judged_at, &sized.off));
        if input.given.payload_temperature_k.is_none() {
            findings.extend(input.soak.findings(&sized.soak));
        }
        findings.extend(flown.ended_in_time(&input.mission));
        findings.extend(given::findings(input, vehicle, sized));
        findings.extend(vehicle.findings.iter().cloned());
        findings
    }
}

#[cfg(test)]
mod tests {
    use super::{Start, solve};
    use crate::problem::DesignProblem;
    use crate::progress::Unwatched;
    use crate::{Case, Library, Outcome, Request, design};
    use std::ops::ControlFlow;

    /// The Stardust-like vehicle of Table 15 with some keys changed.
    fn designed(changes: &[(&str, &str)]) -> crate::Answer {
        let text = crate::library::data_file("cases/msr-eev-pica.toml").unwrap();
        let mut case = Case::from_text(text).unwrap();
        for (key, value) in changes {
            case.set(key, value);
        }
        design(&case, &Library::builtin().unwrap(), Request::Nothing).unwrap()
    }

    #[test]
    fn a_flight_that_is_ended_by_a_table_is_never_sized() {
        let wind = "[[0.0, 5.0, 0.0], [20000.0, 10.0, 0.0], [60000.0, 0.0, 0.0]]";
        let air = "[[2000.0, 1.0, 275.0], [80000.0, 2e-5, 200.0], [130000.0, 1e-8, 500.0]]";
        for (table, rows) in [("wind", wind), ("atmosphere", air)] {
            let (key, rule) = (format!("{table}.table"), format!("{table}.extrapolation"));
            let answer = designed(&[(&key, rows), (&rule, "refuse")]);
            assert_eq!(answer.outcome, Outcome::Stopped, "{table}");
            assert!(answer.design.is_none() && answer.flight.is_some());
            let reason = answer.reason.unwrap();
            assert!(reason.contains(&format!("left {table}")), "{reason}");
            let mut said = answer.findings.iter().map(|finding| &finding.message);
            assert!(
                said.any(|message| message.contains("where it leaves a table, on this flight"))
            );
            assert_ne!(designed(&[(&key, rows)]).outcome, Outcome::Stopped);
        }
    }

    #[test]
    fn a_vehicle_for_a_flight_that_ends_in_time_says_so() {
        let said = |answer: &crate::Answer| {
            let mut findings = answer.findings.iter();
            findings.any(|finding| finding.message.contains("The flight ends in time at"))
        };
        assert!(said(&designed(&[("stop.time_s", "300")])));
        let down = designed(&[("stop.altitude_m", "1000"), ("stop.time_s", "1e5")]);
        assert!(down.outcome == Outcome::Converged && !said(&down));
    }
    #[test]
    fn started_from_a_neighbor_it_settles_on_the_same_vehicle_in_fewer_passes() {
        let library = Library::builtin().unwrap();
        let text = crate::library::data_file("cases/msr-eev-pica.toml").unwrap();
        let mut start: Option<Start> = None;
        let (mut with, mut without) = (0, 0);
        // each beside the one before
        for (speed, angles) in [
            ("11.50 km/s", ["-24.0", "-24.5", "-25.0", "-25.5"]),
            ("11.55 km/s", ["-25.5", "-25.0", "-24.5", "-24.0"]),
            ("11.60 km/s", ["-24.0", "-24.5", "-25.0", "-25.5"]),
        ] {
            for angle in angles {
                let mut case = Case::from_text(text).unwrap();
                case.set("entry.speed_m_s", speed);
                case.set("entry.flight_path_angle_deg", angle);
                let input = DesignProblem::check(&case, &library).unwrap().input;
                let alone = solve(&input, None, &mut Unwatched);
                let started = solve(&input, start.as_ref(), &mut Unwatched);
                assert_eq!(started.outcome(), alone.outcome());
                let [a, b] = [&alone, &started].map(|c| c.vehicle().unwrap().mass.mass_kg);
                assert!(
                    (a - b).abs() < input.mass_criterion_kg,
                    "{speed} {angle}: {a} {b}"
                );
                (with, without) = (
                    with + started.passes().len(),
                    without + alone.passes().len(),
                );
                start = started.start();
            }
        }
        assert!(4 * with < 3 * without, "{with} of {without}");
    }

    #[test]
    fn stopped_on_the_way_from_a_neighbor_it_does_not_begin_again() {
        let text = crate::library::data_file("cases/msr-eev-pica.toml").unwrap();
        let case = Case::from_text(text).unwrap();
        let library = Library::builtin().unwrap();
        let input = DesignProblem::check(&case, &library).unwrap().input;
        let start = solve(&input, None, &mut Unwatched).start().unwrap();
        let mut heard = 0;
        let mut stop = |_| {
            heard += 1;
            ControlFlow::Break(())
        };
        let stopped = solve(&input, Some(&start), &mut stop);
        assert_eq!(stopped.outcome(), Outcome::GaveUp);
        assert_eq!(stopped.passes().len(), 1);
        assert_eq!(heard, 1);
    }

    #[test]
    fn who_watches_may_end_it_after_a_pass_and_keeps_that() {
        let text = crate::library::data_file("cases/msr-eev-pica.toml").unwrap();
        let case = Case::from_text(text).unwrap();
        let problem = DesignProblem::check(&case, &Library::builtin().unwrap()).unwrap();
        let mut heard = 0;
        let mut watcher = |_| {
            heard += 1;
            match heard < 3 {
                true => ControlFlow::Continue(()),
                false => ControlFlow::Break(()),
            }
        };
        let answer = problem.solve_watched("", Request::Nothing, &mut watcher);
        assert_eq!(answer.outcome, Outcome::GaveUp);
        assert_eq!((answer.passes.len(), answer.design.is_some()), (3, true));
        assert!(
            answer
                .reason
                .unwrap()
                .contains("after which it was stopped")
        );
    }
}
