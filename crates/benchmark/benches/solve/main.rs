//! `cargo bench --package msape-benchmark`: times of a trajectory, a vehicle and a design as ratios to reference
//! kernels measured in the same run, so that results of different machines can be compared.
#![allow(missing_docs, reason = "nothing uses a benchmark")]

mod clock;
mod measure;

use benchmark::{Bench, JOBS, NAMES, kernel};
use measure::Measurement;
use msape::flight::{self, Request};

fn main() {
    let bench = Bench::new().unwrap();
    let measurement = |(name, job): (&&'static str, &'static fn(&Bench))| {
        let bench = &bench;
        Measurement::new(name, move || job(bench))
    };
    let jobs = NAMES.iter().zip(JOBS);
    measure::report(&mut jobs.map(measurement).collect::<Vec<_>>());
    let constant = &bench.constant;
    let m2 = flight::fly(&constant.mission, &constant.body, Request::Nothing).0;
    let msr_mission = &bench.msr.input.mission;
    let msr = flight::fly(msr_mission, &bench.msr_body, Request::Nothing).0;
    println!(
        "\nEvaluations of the right-hand side: bare {}, m2 {}, MSR {}; passes of the MSR design: {}",
        kernel::bare_flight(constant.mission.solver.tolerance).1,
        m2.evaluations,
        msr.evaluations,
        bench.msr.solve("", Request::Nothing).passes.len(),
    );
}
