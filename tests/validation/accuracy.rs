//! Flights compared with the same flights at tighter tolerances.

use msape::{Answer, Case, Library};
use msape_tests::entry::{Entry, flown, output, set};

/// Source of drag.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Drag {
    Constant,
    Table,
}

/// Entries spread evenly over speed, angle, ballistic coefficient and nose radius, by multiples of irrational numbers.
fn sampled(count: u32) -> impl Iterator<Item = Entry> {
    (0..count).map(|i| {
        let spread = |step: f64, low: f64, high: f64| {
            low + (high - low) * ((f64::from(i) + 0.5) * step).fract()
        };
        Entry {
            speed_m_s: spread(0.856_674_883_854_502_9, 10_000.0, 16_000.0),
            flight_path_angle_deg: -spread(0.733_891_856_627_126, 5.5, 90.0),
            ballistic_coefficient_kg_m2: spread(0.628_706_721_036_892_5, 20.0, 300.0),
            nose_radius_m: spread(0.538_597_253_903_615_1, 0.1, 1.0),
        }
    })
}

/// Radiative heating model.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Radiation {
    None,
    TauberSutton,
    BrandisJohnston,
}

fn case_of(entry: &Entry, drag: Drag, radiation: Radiation) -> Case {
    let mut case = entry.case();
    let radiative = match radiation {
        Radiation::None => "none",
        Radiation::TauberSutton => "tauber-sutton",
        Radiation::BrandisJohnston => "brandis-johnston",
    };
    case.set("heating.radiative", radiative);
    if drag == Drag::Table {
        case.set("vehicle.drag_coefficient", "");
        case.set("vehicle.aerodynamics", "mmeev-60");
        // the drag coefficient of the table is near 1.5 where it matters
        set(&mut case, "vehicle.reference_area_m2", 2.0 / 3.0);
    }
    case
}

fn solved(case: &Case, library: &Library, method: &str, tolerance: f64) -> Answer {
    let mut case = case.clone();
    case.set("solver.method", method);
    set(&mut case, "solver.tolerance", tolerance);
    flown(&case, library)
}

/// Largest relative difference of some outputs from the reference, with its place.
#[derive(Default)]
struct Worst {
    difference: f64,
    place: String,
}

impl Worst {
    fn note(&mut self, answer: &Answer, reference: &Answer, keys: &[&str]) {
        for key in keys {
            let difference = (output(answer, key) / output(reference, key) - 1.0).abs();
            if difference.is_nan() || difference > self.difference {
                self.difference = difference;
                self.place = format!("{key} of {}", answer.name);
            }
        }
    }

    fn assert_below(&self, allowed: f64, what: &str) {
        println!("{what}: {:.1e} in {}", self.difference, self.place);
        assert!(
            self.difference < allowed,
            "{what}: {:.2e}, allowed {allowed:.0e}, in {}",
            self.difference,
            self.place
        );
    }
}

const LOADS: [&str; 3] = [
    "peak_deceleration_earth_g",
    "peak_dynamic_pressure_pa",
    "total_heat_load_j_m2",
];
const END: [&str; 4] = [
    "time_of_flight_s",
    "final_speed_m_s",
    "final_latitude_deg",
    "final_longitude_deg",
];

/// Three methods, one flight. Loads: the difference is the error of order 5 at 1e-10 and of the fixed step of 0.02 s.
/// End: the ground is met within a millimeter, at 30 m/s 3e-5 s of a flight of 300 s or more.
#[test]
fn three_methods_agree_where_the_models_are_smooth() {
    let library = Library::builtin().unwrap();
    let mut loads = [Worst::default(), Worst::default(), Worst::default()];
    let mut end = [Worst::default(), Worst::default(), Worst::default()];
    for entry in sampled(20) {
        let case = case_of(&entry, Drag::Constant, Radiation::None);
        let reference = solved(&case, &library, "dormand-prince-853", 1e-12);
        let mut fixed = case.clone();
        fixed.set("solver.method", "rk4");
        set(&mut fixed, "solver.step_s", 0.02);
        let ours = [
            solved(&case, &library, "dormand-prince-54", 1e-10),
            solved(&case, &library, "dormand-prince-853", 1e-10),
            flown(&fixed, &library),
        ];
        for (i, answer) in ours.iter().enumerate() {
            assert_eq!(answer.outcome, reference.outcome, "{entry:?}");
            loads[i].note(answer, &reference, &LOADS);
            end[i].note(answer, &reference, &END);
        }
    }
    for (i, method) in ["order 5", "order 8", "fixed step"].iter().enumerate() {
        loads[i].assert_below(5e-9, method);
        end[i].assert_below(2e-7, method);
    }
}

/// Accuracy of the default tolerance.
#[test]
fn default_accuracy_is_1e_5() {
    default_accuracy(60, Drag::Constant, Radiation::None);
    default_accuracy(60, Drag::Constant, Radiation::TauberSutton);
}

#[test]
fn default_accuracy_is_1e_5_with_the_radiation_of_brandis_and_johnston() {
    default_accuracy(60, Drag::Constant, Radiation::BrandisJohnston);
}

/// Default accuracy with drag that is linear between rows, which has kinks within steps.
#[test]
fn default_accuracy_is_1e_5_with_a_table_of_drag() {
    default_accuracy(60, Drag::Table, Radiation::None);
    default_accuracy(60, Drag::Table, Radiation::TauberSutton);
}

/// Sutton–Graves heating may peak on both sides of a layer boundary of the atmosphere; the higher one is the peak.
#[test]
fn the_peak_of_heating_is_the_highest() {
    let library = Library::builtin().unwrap();
    let mut worst = Worst::default();
    for entry in sampled(60) {
        let case = case_of(&entry, Drag::Constant, Radiation::None);
        let mut fine = case.clone();
        fine.set("solver.method", "rk4");
        set(&mut fine, "solver.step_s", 0.02);
        let keys = ["peak_convective_heat_flux_w_m2"];
        let reference = flown(&fine, &library);
        worst.note(&flown(&case, &library), &reference, &keys);
        for tolerance in [1e-7, 1e-9, 1e-11] {
            for method in ["dormand-prince-54", "dormand-prince-853"] {
                let ours = solved(&case, &library, method, tolerance);
                worst.note(&ours, &reference, &keys);
            }
        }
    }
    worst.assert_below(1e-5, "peak of heating");
}

fn default_accuracy(count: u32, drag: Drag, radiation: Radiation) {
    let library = Library::builtin().unwrap();
    let mut worst = Worst::default();
    for entry in sampled(count) {
        let case = case_of(&entry, drag, radiation);
        let reference = solved(&case, &library, "dormand-prince-853", 1e-12);
        let ours = flown(&case, &library);
        assert_eq!(ours.outcome, reference.outcome, "{entry:?}");
        worst.note(
            &ours,
            &reference,
            &["peak_deceleration_earth_g", "total_heat_load_j_m2"],
        );
    }
    worst.assert_below(1e-5, &format!("drag {drag:?}, radiation {radiation:?}"));
}
