//! How often a design asks for memory: counted, not timed. The bounds are generous; what is counted is printed.

use benchmark::Bench;
use msape::Request;
use msape::design::coupling;
use msape::progress::Unwatched;

#[test]
fn a_design_asks_for_memory_a_bounded_number_of_times() {
    let bench = Bench::new().unwrap();
    let count = |work: &dyn Fn()| allocation_counter::measure(work).count_total;
    for (name, problem, most) in [
        ("MSR", &bench.msr, [2_500, 4_000]),
        ("Galahad", &bench.galahad, [12_000, 13_000]),
    ] {
        let passes = count(&|| drop(coupling::solve(&problem.input, None, &mut Unwatched)));
        let answer = count(&|| drop(problem.solve("", Request::Nothing)));
        println!("{name}: {passes} in the passes, {answer} with the answer");
        assert!(
            passes <= most[0] && answer <= most[1],
            "{name}: {passes}, {answer}"
        );
    }
}
