//! `cargo bench --package msape-benchmark`: times of a trajectory, a vehicle and a design as ratios to reference
//! kernels measured in the same run, so that results of different machines can be compared.
#![allow(missing_docs, reason = "nothing uses a benchmark")]

mod clock;
mod measure;

use benchmark::{Bench, JOBS, NAMES, extremes, kernel};
use measure::Measurement;
use msape::flight::{self, Request, three_dof};

/// Name of a job, and what does it once.
type Job = (&'static str, fn(&Bench));

/// Jobs that the page has not, each a copy of the integrator: the exact kernel, a fall, and flights in lanes.
const NATIVE: [Job; 5] = [
    (
        "bare kernel, exact: right-hand side of m2 at 1e-6",
        |bench| {
            std::hint::black_box(kernel::exact_flight(&bench.constant, 1e-6));
        },
    ),
    ("fall of m2 below 250 m/s", |bench| {
        let constant = &bench.constant;
        let (mission, body) = (&constant.mission, &constant.body);
        std::hint::black_box(three_dof::extremes(mission, body, bench.fall));
    }),
    (
        "100 entries like m2, alone: peaks, loads, end",
        extremes::<1>,
    ),
    ("the same in 8 lanes", extremes::<8>),
    ("the same in 16 lanes", extremes::<16>),
];

fn main() {
    let bench = Bench::new().unwrap();
    let measurement = |(name, job): (&'static str, fn(&Bench))| {
        let bench = &bench;
        Measurement::new(name, move || job(bench))
    };
    let jobs = NAMES.iter().copied().zip(JOBS.iter().copied());
    let jobs = jobs.chain(NATIVE);
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
