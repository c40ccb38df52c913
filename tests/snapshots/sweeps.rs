//! Sweeps of one input at a time through two shipped designs, plotted beside version 0.1 and checked for jumps.

use msape::answer::output;
use msape::{Answer, Case, Library, Outcome, Request, design, library};
use msape_plot::{Axis, Figure, Series, Theme, svg};
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::{env, fs};

/// Quantities plotted: key, label, unit.
const DRAWN: [(&str, &str, &str); 2] = [
    ("total_entry_mass_kg", "Entry mass", "kg"),
    ("rigid_surface_peak_load_earth_g", "Rigid surface", "g"),
];
/// Width and height of one panel, px.
const PANEL_PX: [u32; 2] = [450, 190];

/// Ratio of a step to its neighbors above which it is a jump.
const JUMP: f64 = 6.0;
/// Relative size below which a step is ignored.
const SMALL: f64 = 0.004;

/// Variation of one input of one case.
struct Sweep {
    case: String,
    input: String,
    values: Vec<f64>,
    /// Answers of version 0.1, in the order of [`DRAWN`].
    before: Vec<[f64; 2]>,
}

fn recorded() -> Vec<Sweep> {
    let file = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("data/sweeps_0_1.csv");
    let text = fs::read_to_string(file).unwrap();
    let mut sweeps: Vec<Sweep> = Vec::new();
    let mut places: BTreeMap<(String, String), usize> = BTreeMap::new();
    for line in text.lines().filter(|line| !line.starts_with('#')).skip(1) {
        let fields: Vec<&str> = line.split(',').collect();
        let number = |i: usize| fields[i].parse::<f64>().unwrap_or(f64::NAN);
        let key = (fields[0].to_string(), fields[1].to_string());
        let place = *places.entry(key.clone()).or_insert_with(|| {
            sweeps.push(Sweep {
                case: key.0,
                input: key.1,
                values: Vec::new(),
                before: Vec::new(),
            });
            sweeps.len() - 1
        });
        sweeps[place].values.push(number(2));
        sweeps[place].before.push([number(4), number(6)]);
    }
    sweeps
}

/// Current answers; NaN for a design that did not converge.
fn now(sweep: &Sweep, library: &Library) -> Vec<[f64; 2]> {
    let file = format!("cases/{}.toml", sweep.case);
    let case = Case::from_text(library::data_file(&file).unwrap()).unwrap();
    let at = |value: &f64| {
        let mut case = case.clone();
        case.set(&sweep.input, &value.to_string());
        let answer: Answer = design(&case, library, Request::Nothing).unwrap();
        DRAWN.map(|(key, ..)| match answer.outcome {
            Outcome::Converged => (output::find(key).unwrap().get)(&answer).unwrap(),
            _ => f64::NAN,
        })
    };
    sweep.values.iter().map(at).collect()
}

/// Indices of the steps at which a curve jumps.
fn jumps(values: &[f64]) -> Vec<usize> {
    let step = |i: usize| (values[i + 1] - values[i]).abs();
    (0..values.len().saturating_sub(1))
        .filter(|i| {
            let around = [
                i.checked_sub(1),
                Some(i + 1).filter(|j| j + 1 < values.len()),
            ];
            let largest = around.into_iter().flatten().map(step).fold(0.0, f64::max);
            step(*i) > JUMP * largest && step(*i) > SMALL * values[*i].abs()
        })
        .collect()
}

#[test]
fn a_step_among_slopes_is_a_jump_and_a_kink_is_none() {
    assert_eq!(jumps(&[1.0, 1.01, 1.02, 1.5, 1.51]), [2]);
    assert_eq!(jumps(&[1.0, 1.0, 1.0, 1.1, 1.2, 1.3]), [] as [usize; 0]);
}

#[test]
fn no_sweep_jumps_and_the_picture_is_that_of_the_documentation() {
    let library = Library::builtin().unwrap();
    let mut faults = Vec::new();
    let mut panels: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for sweep in recorded() {
        let after = now(&sweep, &library);
        let label = msape::quantity::input::find(&sweep.input).unwrap();
        for (q, (key, name, unit)) in DRAWN.into_iter().enumerate() {
            let line = |list: &[[f64; 2]]| -> Vec<(f64, f64)> {
                let y = list.iter().map(|row| row[q]);
                sweep.values.iter().copied().zip(y).collect()
            };
            let curve: Vec<f64> = after.iter().map(|row| row[q]).collect();
            for i in jumps(&curve) {
                faults.push(format!(
                    "{} {} {} -> {}: {key} {} -> {}",
                    sweep.case,
                    sweep.input,
                    sweep.values[i],
                    sweep.values[i + 1],
                    curve[i],
                    curve[i + 1]
                ));
            }
            let figure = Figure {
                x: Axis::new(label.label, label.unit),
                y: Axis::new(name, unit),
                series: vec![
                    Series::line("Version 0.1", line(&sweep.before), 1),
                    Series::line("Now", line(&after), 0),
                ],
                ..Figure::default()
            };
            let drawn = svg(&figure, &Theme::light(), PANEL_PX[0], PANEL_PX[1]);
            panels.entry(sweep.case.clone()).or_default().push(drawn);
        }
    }
    let mut stale = Vec::new();
    for (case, panels) in panels {
        let sheet = sheet(&panels);
        let name = format!("docs/sweeps-{case}.svg");
        let file = PathBuf::from(env!("CARGO_MANIFEST_DIR"))
            .join("..")
            .join(&name);
        if env::var_os("UPDATE_SNAPSHOTS").is_some() {
            fs::write(&file, sheet).unwrap();
        } else if fs::read_to_string(&file).unwrap_or_default() != sheet {
            stale.push(format!(
                "{name} is not what is drawn now; if that is meant, record anew with UPDATE_SNAPSHOTS=1"
            ));
        }
    }
    assert!(faults.is_empty(), "jumps:\n{}", faults.join("\n"));
    assert!(stale.is_empty(), "{}", stale.join("\n"));
}

/// Panels in two columns on one sheet.
fn sheet(panels: &[String]) -> String {
    let [width, height] = PANEL_PX;
    let rows = panels.len().div_ceil(2) as u32;
    let mut sheet = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\">\n",
        2 * width,
        rows * height
    );
    for (i, panel) in panels.iter().enumerate() {
        let (x, y) = (i as u32 % 2 * width, i as u32 / 2 * height);
        sheet.push_str(&panel.replacen("<svg ", &format!("<svg x=\"{x}\" y=\"{y}\" "), 1));
    }
    sheet.push_str("</svg>\n");
    sheet
}
