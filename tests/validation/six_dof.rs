//! Six degrees of freedom: the report's statements on backward entries, and the accuracy of a spinning entry.

use msape::flight::six_dof::reorientation::{Facing, Reorientation, study};
use msape::problem::{FlightProblem, add_turning};
use msape::progress::Unwatched;
use msape::{Case, Library, Request};
use msape_tests::entry::{flown, output, set};

fn shipped(name: &str) -> Case {
    Case::from_text(msape::library::data_file(name).unwrap()).unwrap()
}

fn studied(case: &Case, cg_x_m: &[f64]) -> Vec<Reorientation> {
    let library = Library::builtin().unwrap();
    let problem = FlightProblem::check(case, &library).unwrap();
    study(&problem.mission, &problem.body, cg_x_m)
}

/// Section 3.3.2, Figure 27: with the center of gravity at 0.2 diameters a vehicle that enters backward without rates
/// turns around before continuum flow (Knudsen number 0.001), and the position of the center of gravity is a driver:
/// the farther aft, the later.
#[test]
fn backward_entry_without_rates_turns_round_before_continuum_flow() {
    let case = shipped("cases/backward-entry.toml");
    let diameter_m = 1.1;
    let places = [0.15, 0.2, 0.25].map(|x| x * diameter_m);
    let entries = studied(&case, &places);
    let first_turn =
        |entry: &Reorientation| entry.attitude.hemisphere_change_times_s.first().copied();
    for entry in &entries {
        println!(
            "x_cg/D {:.3}: {:?}, first turn {:?} s, below 10 deg at Kn {:?}, at peak heating {:.1} deg",
            entry.cg_x_m / diameter_m,
            entry.facing,
            first_turn(entry),
            entry.attitude.first_below_10_deg_knudsen,
            entry.attitude.total_alpha_at_peak_heating_rad.to_degrees(),
        );
        assert_eq!(entry.facing, Facing::Forward);
        assert!(entry.attitude.last_hemisphere_change_knudsen.unwrap() > 1e-3);
    }
    let times: Vec<f64> = entries.iter().filter_map(first_turn).collect();
    assert!(times[0] < times[1] && times[1] < times[2], "{times:?}");
}

/// Default accuracy compared with a tight integration: the largest angle after peak heating to 1e-4.
#[test]
fn largest_angles_of_a_spinning_entry_are_good_to_1e_4() {
    let library = Library::builtin().unwrap();
    let case = shipped("cases/stardust-spinning.toml");
    let mut tight = case.clone();
    set(&mut tight, "solver.tolerance", 1e-12);
    let (ours, reference) = (flown(&case, &library), flown(&tight, &library));
    for key in [
        "maximum_total_alpha_deg",
        "maximum_total_alpha_after_peak_heating_deg",
        "total_alpha_at_peak_heating_deg",
    ] {
        let (a, b) = (output(&ours, key), output(&reference, key));
        println!("{key}: {a} against {b}");
        assert!((a / b - 1.0).abs() < 1e-4, "{key}: {a} against {b}");
    }
}

/// Nine entries of each shipped design: only one that trims backward in hypersonic flow is backward at peak heating.
#[test]
fn designs_with_a_backward_trim_meet_the_heat_backwards_in_part_of_nine_entries() {
    let library = Library::builtin().unwrap();
    for (name, backward) in [
        ("cases/msr-eev-cp.toml", 1),
        ("cases/run-page.toml", 0),
        ("cases/galahad.toml", 0),
        ("cases/msr-eev-pica.toml", 0),
    ] {
        let case = shipped(name);
        let mut answer = msape::design(&case, &library, Request::Nothing).unwrap();
        add_turning(&case, &library, &mut answer, &mut Unwatched).unwrap();
        let turning = answer
            .design
            .as_ref()
            .and_then(|d| d.turning.as_ref())
            .unwrap();
        let facing = |want: Facing| turning.entries.iter().filter(|e| e.facing == want).count();
        println!("{name}: {}", msape::answer::turning::sentence(turning));
        assert_eq!(turning.entries.len(), 9);
        assert_eq!(facing(Facing::Backward), backward, "{name}");
        let share = output(&answer, "nose_first_share");
        assert!((share - (9 - backward) as f64 / 9.0).abs() < 1e-12);
        let trim = output(&answer, "hypersonic_stable_trim_deg");
        assert!(backward == 0 || trim > 90.0, "{name}: {trim}");
    }
}
