//! `cargo bench --package msape-benchmark --bench grid`: designs over a grid, each from the guesses of its case and from the numbers on
//! which its neighbor settled: seconds of the thread's clock, passes, and how far the entry masses are apart. Then designs drawn about
//! the run page and a row of Galahad: the slowest by name.
#![allow(missing_docs, reason = "nothing uses a benchmark")]

#[path = "solve/clock.rs"]
mod clock;

use msape::design::coupling;
use msape::design::start::Start;
use msape::problem::DesignProblem;
use msape::progress::Unwatched;
use msape::quantity::input;
use msape::{Case, Library, Outcome};

/// Of one design: outcome, entry mass in kg, passes.
type Row = (Outcome, Option<f64>, usize);

/// Where the passes of a design begin.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Begin {
    Guesses,
    Neighbor,
}

/// Values of a key, evenly spread.
fn spread(count: usize, [low, high]: [f64; 2]) -> Vec<String> {
    let at = |i: usize| low + (high - low) * i as f64 / (count - 1) as f64;
    (0..count).map(|i| at(i).to_string()).collect()
}

/// Diameters, m, entry speeds, m/s, and entry angles, deg.
type Sides<'a> = [&'a [String]; 3];

/// Designs of a grid in the order in which each is beside the one before; seconds and rows.
fn grid(library: &Library, case: &Case, sides: Sides, begin: Begin) -> (f64, Vec<Row>) {
    let [diameters, mut speeds, mut angles] = sides.map(<[String]>::to_vec);
    let start = clock::now();
    let mut rows = Vec::new();
    let mut from: Option<Start> = None;
    for diameter_m in &diameters {
        for speed_m_s in &speeds {
            for angle_deg in &angles {
                let mut case = case.clone();
                case.set(input::design::DIAMETER_M.key, diameter_m);
                case.set(input::entry::SPEED_M_S.key, speed_m_s);
                case.set(input::entry::FLIGHT_PATH_ANGLE_DEG.key, angle_deg);
                let problem = DesignProblem::check(&case, library).unwrap();
                let coupled = coupling::solve(&problem.input, from.as_ref(), &mut Unwatched);
                if begin == Begin::Neighbor {
                    from = coupled.start().or(from.take());
                }
                let mass_kg = coupled.vehicle().map(|vehicle| vehicle.mass.mass_kg);
                rows.push((coupled.outcome(), mass_kg, coupled.passes().len()));
            }
            angles.reverse();
        }
        speeds.reverse();
    }
    ((clock::now() - start).as_secs_f64(), rows)
}

fn tell(name: &str, begin: Begin, seconds: f64, rows: &[Row], guessed: &[Row]) {
    let passes: usize = rows.iter().map(|(.., passes)| passes).sum();
    let converged = rows
        .iter()
        .filter(|(outcome, ..)| *outcome == Outcome::Converged)
        .count();
    let apart = rows
        .iter()
        .zip(guessed)
        .filter_map(|(a, b)| Some((a.1? - b.1?).abs()));
    let same = rows.iter().zip(guessed).filter(|(a, b)| a.0 == b.0).count();
    println!(
        "{name}, {begin:?}: {seconds:.3} s, {:.0} designs/s, {:.2} passes each, {converged} of {} converged, {same} as from guesses, at most {:.1e} kg apart",
        rows.len() as f64 / seconds,
        passes as f64 / rows.len() as f64,
        rows.len(),
        apart.fold(0.0, f64::max)
    );
}

/// Designs one by one: mean time, and the slowest.
fn slowest(name: &str, library: &Library, cases: impl Iterator<Item = (String, Case)>) {
    let mut all: Vec<(f64, String)> = Vec::new();
    for (told, case) in cases {
        let start = clock::now();
        let Ok(problem) = DesignProblem::check(&case, library) else {
            continue;
        };
        let coupled = coupling::solve(&problem.input, None, &mut Unwatched);
        let ms = 1e3 * (clock::now() - start).as_secs_f64();
        let (outcome, passes) = (coupled.outcome().name(), coupled.passes().len());
        all.push((ms, format!("{told}: {outcome}, {passes} passes")));
    }
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mean = all.iter().map(|(ms, _)| ms).sum::<f64>() / all.len() as f64;
    let median = all.get(all.len() / 2).map_or(0.0, |(ms, _)| *ms);
    println!(
        "{name}: {} designs, mean {mean:.1} ms, median {median:.1} ms",
        all.len()
    );
    for (ms, told) in all.iter().take(8) {
        println!("  {ms:8.1} ms  {told}");
    }
}

/// Cases about the run page, spread evenly.
fn about_the_run_page(count: u32) -> impl Iterator<Item = (String, Case)> {
    (0..count).map(|i| {
        let mut case = Case::run_page();
        let mut told = Vec::new();
        case.set(
            input::design::MSR_MODE.key,
            ["true", "false"][i as usize % 2],
        );
        case.set(input::design::PAYLOAD_DIAMETER_RATIO.key, "");
        for (key, [low, high], step) in [
            (input::entry::SPEED_M_S.key, [10e3, 16e3], 0.754_877_666),
            (
                input::entry::FLIGHT_PATH_ANGLE_DEG.key,
                [-30.0, -5.5],
                0.569_840_290,
            ),
            (input::design::DIAMETER_M.key, [0.5, 2.0], 0.430_159_709),
            (
                input::design::NOSE_RADIUS_RATIO.key,
                [0.25, 0.9],
                0.324_717_957,
            ),
            (
                input::design::SHOULDER_RADIUS_RATIO.key,
                [0.02, 0.1],
                0.245_122_333,
            ),
            (
                input::design::PAYLOAD_MASS_KG.key,
                [5.0, 20.0],
                0.618_033_988,
            ),
            (
                input::design::PAYLOAD_DENSITY_KG_M3.key,
                [500.0, 8000.0],
                0.414_213_562,
            ),
            (input::design::MASS_MARGIN.key, [0.0, 1.0], 0.732_050_808),
            (
                input::design::CRUSH_LOAD_LIMIT_EARTH_G.key,
                [500.0, 5000.0],
                0.236_067_977,
            ),
        ] {
            let part = ((f64::from(i) + 0.5) * step).fract();
            let value = format!("{:.4}", low + (high - low) * part);
            case.set(key, &value);
            told.push(format!("{key}={value}"));
        }
        (told.join(" "), case)
    })
}

fn main() {
    let library = Library::builtin().unwrap();
    let text = msape::library::data_file("cases/msr-eev-pica.toml").unwrap();
    let case = Case::from_text(text).unwrap();
    let (diameters, speeds, angles) = ([0.9, 1.3], [11e3, 13e3], [-10.0, -25.0]);
    let sides = [diameters, speeds, angles].map(|ends| spread(10, ends));
    let mut guessed = Vec::new();
    for begin in [Begin::Guesses, Begin::Neighbor] {
        let (seconds, rows) = grid(&library, &case, sides.each_ref().map(Vec::as_slice), begin);
        if begin == Begin::Guesses {
            guessed.clone_from(&rows);
        }
        tell("10 x 10 x 10", begin, seconds, &rows, &guessed);
    }
    // three panels, half of the speeds for each thread
    let (three, [speeds, angles]) = (
        spread(3, diameters),
        [speeds, angles].map(|ends| spread(21, ends)),
    );
    let halves = speeds.split_at(11);
    let mut guessed: [Vec<Row>; 2] = Default::default();
    for begin in [Begin::Guesses, Begin::Neighbor] {
        let half = |speeds| grid(&library, &case, [&three, speeds, &angles], begin);
        let (first, second) = std::thread::scope(|scope| {
            let other = scope.spawn(|| half(halves.1));
            (half(halves.0), other.join().unwrap())
        });
        for (n, (seconds, rows)) in [first, second].into_iter().enumerate() {
            let name = format!("3 panels of 21 x 21, thread {} of 2", n + 1);
            if begin == Begin::Guesses {
                guessed[n].clone_from(&rows);
            }
            tell(&name, begin, seconds, &rows, &guessed[n]);
        }
    }
    let galahad =
        Case::from_text(msape::library::data_file("cases/galahad.toml").unwrap()).unwrap();
    let row = (0..=30).map(|n| {
        let diameter_m = format!("{:.2}", 1.0 + 0.01 * f64::from(n));
        let mut case = galahad.clone();
        let input = &input::design::DIAMETER_M;
        case.set(input.key, &diameter_m);
        (format!("{input}={diameter_m}"), case)
    });
    slowest("Galahad, 1.00 to 1.30 m", &library, row);
    slowest("about the run page", &library, about_the_run_page(200));
}
