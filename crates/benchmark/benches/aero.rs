//! `cargo bench --package msape-benchmark --bench aero`: time to build the database of a new outline and time of one
//! look-up.
#![allow(missing_docs, reason = "nothing uses a benchmark")]

#[path = "solve/clock.rs"]
mod clock;
#[path = "solve/measure.rs"]
mod measure;

use benchmark::kernel;
use measure::Measurement;
use msape::Library;
use msape::aero::standard::AeroBody;
use msape::problem::AeroProblem;
use std::hint::black_box;

fn main() {
    let library = Library::builtin().unwrap();
    let of = |name: &str| {
        let (_, data) = library
            .outlines
            .iter()
            .find(|(known, _)| known == name)
            .unwrap();
        AeroBody::of_rigid(&data.scaled_body(None).unwrap(), None)
    };
    let stardust = of("stardust");
    let case = msape::library::data_file("cases/msr-eev-cp.toml").unwrap();
    let case = msape::Case::from_text(case).unwrap();
    let (design, _) = AeroProblem::check(&case, &library)
        .unwrap()
        .solve()
        .unwrap();
    let database = stardust.database(&library.aero_standard(), None);
    let mut alpha = 0.0;
    let mut look_up = |mach: f64, knudsen: f64| {
        alpha = (alpha + 0.0137) % 3.0;
        black_box(database.coefficients(mach, knudsen, alpha));
    };
    let mut again = 0.0;
    let mut transonic = |mach: f64| {
        again = (again + 0.0137) % 3.0;
        black_box(database.coefficients(mach, 0.0, again));
    };
    measure::report(&mut [
        Measurement::new("bare kernel: order 5, exponential air, no results", || {
            black_box(kernel::bare_flight(3e-6));
        }),
        Measurement::new("database of an outline (Stardust)", || {
            black_box(stardust.database(&library.aero_standard(), None));
        }),
        Measurement::new(
            "database of a designed vehicle, re-entrant back (MSR)",
            || {
                black_box(design.database(&library.aero_standard(), None));
            },
        ),
        Measurement::new("one look-up, transitional", move || look_up(25.0, 0.1)),
        Measurement::new("one look-up, transonic", move || transonic(1.1)),
    ]);
}
