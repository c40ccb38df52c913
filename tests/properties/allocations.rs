//! Number of allocations of a vehicle: the search for its diameter reuses its memory.

use allocation_counter::measure;
use msape::library::data_file;
use msape::problem::DesignProblem;
use msape::vehicle;
use msape::{Case, Library};

/// Allocations of a vehicle that closes as asked, and of one that is grown: parts, names and remarks of the answer, with room.
const MOST: u64 = 200;

#[test]
fn a_vehicle_asks_for_memory_for_its_answer_and_not_for_its_search() {
    let library = Library::builtin().unwrap();
    for path in [
        "cases/msr-eev-pica.toml",
        "cases/msr-eev-cp.toml",
        "cases/galahad.toml",
        "cases/run-page.toml",
    ] {
        let case = Case::from_text(data_file(path).unwrap()).unwrap();
        let problem = DesignProblem::check(&case, &library).unwrap();
        let mut built = None;
        let count = measure(|| built = Some(vehicle::build(&problem.input.vehicle))).count_total;
        assert!(built.is_some_and(|built| built.is_ok()), "{path}");
        println!("{path}: {count} allocations");
        assert!(count <= MOST, "{path}: {count} allocations");
    }
}
