//! Jobs for measuring speed: `cargo bench` and the benchmark page time the same ones, as ratios to the first, so that
//! results of different machines can be compared. The caller supplies the clock.

pub mod kernel;

use msape::case::{Case, InputError};
use msape::design::structural::Structural;
use msape::design::{Design, coupling};
use msape::flight::batch::extremes_of_all;
use msape::flight::mission::{Body, Start};
use msape::flight::numbers::Numbers;
use msape::flight::three_dof;
use msape::flight::{self, Flight, Request};
use msape::library::{DataError, Library, data_file};
use msape::planet::horizon::Velocity;
use msape::problem::{DesignProblem, FlightProblem};
use msape::progress::Unwatched;
use msape::vehicle;
use numerics::math::RADIANS_PER_DEGREE;
use std::hint::black_box;
use std::ops::ControlFlow;

/// Input of the jobs.
#[derive(Clone, Debug)]
pub struct Bench {
    /// The built-in library.
    pub library: Library,
    /// Flight with constant drag and without radiation.
    pub constant: FlightProblem,
    /// Numbers of the constant-drag flight from the place where it is slower than 250 m/s.
    pub fall: Numbers,
    /// Entries like the constant-drag flight, at 11 to 13 km/s and 8 to 20 deg below the horizon.
    pub entries: Vec<Numbers>,
    /// MSR vehicle with a PICA heat shield, unchecked.
    pub msr_case: Case,
    /// MSR case after the check.
    pub msr: DesignProblem,
    /// MSR vehicle as a body in flight, built from the first guesses of the coupling.
    pub msr_body: Body,
    /// Layout of the MSR vehicle, built from the first guesses of the coupling.
    pub msr_layout: vehicle::layout::Layout,
    /// Converged design of the MSR vehicle, and its flight.
    pub msr_design: (Design, Flight),
    /// Design with another vehicle concept (Galahad).
    pub galahad: DesignProblem,
    /// Spinning entry with six degrees of freedom and the aerodynamic database of its outline.
    pub spinning: FlightProblem,
    /// Case of the spinning entry.
    pub spinning_case: Case,
}

/// Declares the jobs by name and function. Names and functions are two lists, so that a page can show the names without
/// linking the solver.
macro_rules! jobs {
    ($($name:literal => $run:expr,)*) => {
        /// Names of the jobs; the first is the reference.
        pub static NAMES: &[&str] = &[$($name),*];

        /// Functions that run each job once, in the order of [`NAMES`].
        pub static JOBS: &[fn(&Bench)] = &[$($run),*];
    };
}

jobs! {
    "bare kernel: order 5, exponential air, no results" => |bench| {
        black_box(kernel::bare_flight(bench.constant.mission.solver.tolerance));
    },
    "1000 densities of US76, 0 to 125 km" => |bench| {
        let atmosphere = &bench.constant.mission.atmosphere;
        let sum: f64 = (0..1000)
            .map(|i| atmosphere.density_kg_m3(f64::from(i) * 125.0))
            .sum();
        black_box(sum);
    },
    "trajectory, constant drag, no radiation (m2)" => |bench| {
        let FlightProblem { mission, body, .. } = &bench.constant;
        black_box(flight::fly(mission, body, Request::Nothing));
    },
    "the same with its history at the steps" => |bench| {
        let FlightProblem { mission, body, .. } = &bench.constant;
        black_box(flight::fly(mission, body, Request::Steps));
    },
    "trajectory, drag table, radiation (MSR)" => |bench| {
        let mission = &bench.msr.input.mission;
        black_box(flight::fly(mission, &bench.msr_body, Request::Nothing));
    },
    "vehicle: closing, mass, structure (MSR)" => |bench| drop(black_box(vehicle::build(&bench.msr.input.vehicle))),
    "vehicle: closing, mass, structure (Galahad)" => |bench| drop(black_box(vehicle::build(&bench.galahad.input.vehicle))),
    "half-section: profiles, volumes, moments (MSR)" => |bench| {
        let layout = &bench.msr_layout;
        let parts = vehicle::shapes::profiles(vehicle::Concept::Msr, layout);
        let profiles = parts.iter().flat_map(|(_, profiles)| profiles);
        let volume: f64 = profiles.map(|p| p.solid().volume_m3).sum();
        black_box(volume);
    },
    "structure: rules and shell model (MSR)" => |bench| {
        let (design, flight) = &bench.msr_design;
        drop(black_box(Structural::new(&bench.msr.input, design, flight)));
    },
    "converged design (MSR)" => |bench| drop(black_box(bench.msr.solve("", Request::Nothing))),
    "converged design (Galahad)" => |bench| drop(black_box(bench.galahad.solve("", Request::Nothing))),
    "six degrees of freedom (spinning Stardust)" => |bench| {
        let FlightProblem { mission, body, .. } = &bench.spinning;
        black_box(flight::fly(mission, body, Request::Nothing));
    },
    "the same, checked, with its database" => |bench| {
        drop(black_box(FlightProblem::check(
            &bench.spinning_case,
            &bench.library,
        )))
    },
    "checking a case (MSR)" => |bench| {
        drop(black_box(DesignProblem::check(
            &bench.msr_case,
            &bench.library,
        )))
    },
    "built-in library" => |_| drop(black_box(Library::builtin())),
}

impl Bench {
    /// Prepares the input of all jobs.
    ///
    /// # Errors
    /// A shipped file that is invalid, which a test rules out.
    pub fn new() -> Result<Bench, DataError> {
        let library = Library::builtin()?;
        let constant = shipped("cases/msape-ref-m2.toml", |case| {
            FlightProblem::check(&case, &library)
        })?;
        let (fall, entries) = (fall(&constant), entries(&constant));
        let msr_file = "cases/msr-eev-pica.toml";
        let (msr_case, msr) = shipped(msr_file, |case| {
            let msr = DesignProblem::check(&case, &library)?;
            Ok((case, msr))
        })?;
        let galahad = shipped("cases/galahad.toml", |case| {
            DesignProblem::check(&case, &library)
        })?;
        let (spinning_case, spinning) = shipped("cases/stardust-spinning.toml", |case| {
            let spinning = FlightProblem::check(&case, &library)?;
            Ok((case, spinning))
        })?;
        let built =
            vehicle::build(&msr.input.vehicle).map_err(|error| fault(msr_file, error.reason))?;
        let msr_body = msr.input.body(&built, None);
        let answer = coupling::solve(&msr.input, None, &mut Unwatched).solution(Request::Nothing);
        let msr_design = answer
            .design
            .zip(answer.flight)
            .ok_or_else(|| fault(msr_file, "has no design".to_string()))?;
        Ok(Bench {
            library,
            constant,
            fall,
            entries,
            msr_case,
            msr,
            msr_body,
            msr_layout: built.layout,
            msr_design,
            galahad,
            spinning,
            spinning_case,
        })
    }
}

/// Entries of the list, `N` at a time in lanes: peaks, loads, end. Not one of [`JOBS`]: each `N` is a copy of the integrator,
/// which the page would have to fetch.
pub fn extremes<const N: usize>(bench: &Bench) {
    let FlightProblem { mission, body, .. } = &bench.constant;
    let queue = bench.entries.iter().copied();
    let ended = extremes_of_all::<N>(mission, body, queue, |flown| {
        black_box(flown);
        ControlFlow::Continue(())
    });
    let _ = black_box(ended);
}

fn fall(problem: &FlightProblem) -> Numbers {
    let FlightProblem { mission, body, .. } = problem;
    let record = three_dof::integrate(mission, body);
    let slow = record.legs.iter().find(|leg| {
        let [_, _, _, x, y, z, ..] = leg.step.y1;
        x * x + y * y + z * z < 250.0 * 250.0
    });
    let mut numbers = Numbers::of(mission, body);
    if let Some(leg) = slow {
        let [x, y, z, vx, vy, vz, ..] = leg.step.y1;
        let velocity = mission.planet.horizon([x, y, z]).velocity([vx, vy, vz]);
        let place = mission.planet.geodetic([x, y, z]);
        numbers.start = Start::relative(&mission.planet, &place, velocity);
    }
    numbers
}

fn entries(problem: &FlightProblem) -> Vec<Numbers> {
    let FlightProblem { mission, body, .. } = problem;
    let place = mission.planet.geodetic(mission.start.position_m);
    let entry = |i: i32| {
        let velocity = Velocity {
            speed_m_s: 11_000.0 + 20.0 * f64::from(i),
            // Steep and shallow in turn, so that lanes differ.
            flight_path_angle_rad: -RADIANS_PER_DEGREE * (8.0 + 0.12 * f64::from(37 * i % 100)),
            ..mission.start.relative
        };
        let mut numbers = Numbers::of(mission, body);
        numbers.start = Start::relative(&mission.planet, &place, velocity);
        numbers
    };
    (0..100).map(entry).collect()
}

fn fault(file: &str, message: String) -> DataError {
    DataError {
        file: file.to_string(),
        message,
    }
}

fn shipped<T>(
    file: &str,
    check: impl FnOnce(Case) -> Result<T, Vec<InputError>>,
) -> Result<T, DataError> {
    let text = data_file(file).ok_or_else(|| fault(file, "does not ship".to_string()))?;
    Case::from_text(text).and_then(check).map_err(|faults| {
        let messages: Vec<String> = faults.iter().map(InputError::to_string).collect();
        fault(file, messages.join("; "))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use msape::Outcome;

    #[test]
    fn what_is_measured_is_a_flight_to_the_ground_and_designs_that_converge() {
        let bench = Bench::new().unwrap();
        JOBS.iter().for_each(|job| job(&bench));
        let FlightProblem { mission, body, .. } = &bench.constant;
        assert_eq!(
            flight::fly(mission, body, Request::Nothing).1,
            Outcome::Landed
        );
        for design in [&bench.msr, &bench.galahad] {
            assert_eq!(
                design.solve("", Request::Nothing).outcome,
                Outcome::Converged
            );
        }
        // 12 km/s at −8 deg: minutes, not seconds, and some hundred evaluations
        let (time_s, evaluations) = kernel::bare_flight(mission.solver.tolerance);
        assert!(time_s > 60.0 && evaluations > 100);
    }
}
