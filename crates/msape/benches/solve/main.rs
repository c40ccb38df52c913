//! `cargo bench --package msape`: how long a trajectory, a vehicle and a design take, as ratios to bare kernels measured
//! in the same run, so that figures of different machines can be compared.
#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_macros,
    missing_docs,
    reason = "a measurement is not the core: it reads the clock and prints"
)]

mod kernel;
mod measure;

use measure::Measurement;
use msape::flight::{self, Request};
use msape::library::data_file;
use msape::problem::{DesignProblem, FlightProblem};
use msape::{Case, Library, vehicle};
use std::hint::black_box;

fn case(name: &str) -> Case {
    Case::from_text(data_file(&format!("cases/{name}.toml")).unwrap()).unwrap()
}

fn main() {
    let library = Library::builtin().unwrap();
    let constant = FlightProblem::check(&case("msape-ref-m2"), &library).unwrap();
    let msr_case = case("msr-eev-pica");
    let msr = DesignProblem::check(&msr_case, &library).unwrap();
    let built = vehicle::build(&msr.input.vehicle).unwrap();
    let body = msr.input.body(&built);
    let atmosphere = &constant.mission.atmosphere;
    let fly = |problem: &FlightProblem, request| {
        black_box(flight::fly(&problem.mission, &problem.body, request));
    };
    measure::report(&mut [
        Measurement::new("bare kernel: order 5, exponential air, no results", || {
            black_box(kernel::bare_flight(constant.mission.solver.tolerance));
        }),
        Measurement::new("1000 densities of US76, 0 to 125 km", || {
            let sum: f64 = (0..1000)
                .map(|i| atmosphere.density_kg_m3(f64::from(i) * 125.0))
                .sum();
            black_box(sum);
        }),
        Measurement::new("trajectory, constant drag, no radiation (m2)", || {
            fly(&constant, Request::Nothing);
        }),
        Measurement::new("the same with its history at the steps", || {
            fly(&constant, Request::Steps);
        }),
        Measurement::new("trajectory, drag table, radiation (MSR)", || {
            black_box(flight::fly(&msr.input.mission, &body, Request::Nothing));
        }),
        Measurement::new("vehicle: closing, mass, structure (MSR)", || {
            black_box(vehicle::build(&msr.input.vehicle).unwrap());
        }),
        Measurement::new("converged design (MSR)", || {
            black_box(msr.solve("", Request::Nothing));
        }),
        Measurement::new("checking a case (MSR)", || {
            black_box(DesignProblem::check(&msr_case, &library).unwrap());
        }),
        Measurement::new("built-in library", || {
            black_box(Library::builtin().unwrap());
        }),
    ]);
    let evaluations = |flown: &flight::Flight| flown.evaluations;
    let m2 = flight::fly(&constant.mission, &constant.body, Request::Nothing).0;
    let msr_flight = flight::fly(&msr.input.mission, &body, Request::Nothing).0;
    println!(
        "\nEvaluations of the right-hand side: bare {}, m2 {}, MSR {}; passes of the MSR design: {}",
        kernel::bare_flight(constant.mission.solver.tolerance).1,
        evaluations(&m2),
        evaluations(&msr_flight),
        msr.solve("", Request::Nothing).passes.len(),
    );
}
