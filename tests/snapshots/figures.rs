//! Figures of the documentation, drawn from solver results and compared with the published files.

use msape::flight::six_dof::reorientation::study;
use msape::problem::FlightProblem;
use msape::{Case, Library, library};
use msape_plot::{Axis, Figure, Scale, Series, Theme, svg};
use std::path::PathBuf;
use std::{env, fs};

/// Diameter of the vehicle of `cases/backward-entry.toml`, m.
const DIAMETER_M: f64 = 1.1;
/// Axial positions of the center of gravity in diameters aft of the virtual apex.
const PLACES: [f64; 5] = [0.10, 0.20, 0.25, 0.27, 0.30];

/// Smallest Knudsen number drawn: below it the oscillations continue unchanged.
const LEAST_KNUDSEN: f64 = 0.01;

/// Total angle of attack of a backward entry against Knudsen number, as in Figure 27 of the report.
#[test]
fn backward_entries_are_those_of_the_documentation() {
    let text = library::data_file("cases/backward-entry.toml").unwrap();
    let case = Case::from_text(text).unwrap();
    let problem = FlightProblem::check(&case, &Library::builtin().unwrap()).unwrap();
    let entries = study(
        &problem.mission,
        &problem.body,
        &PLACES.map(|place| place * DIAMETER_M),
    );
    assert_eq!(entries.len(), PLACES.len());
    let series = entries
        .iter()
        .zip(PLACES)
        .enumerate()
        .map(|(i, (entry, place))| {
            let degrees = entry.total_alpha_rad.iter().map(|alpha| alpha.to_degrees());
            let points = entry.knudsen.iter().copied().zip(degrees);
            let points = points
                .filter(|(knudsen, _)| *knudsen >= LEAST_KNUDSEN)
                .collect();
            Series::line(format!("CG at {place:.2} D"), points, i)
        });
    let figure = Figure {
        title: Some(
            "Backward entry: total angle of attack as the air gets denser (from right to left)"
                .to_string(),
        ),
        x: Axis::new("Knudsen number", "").with_scale(Scale::Log),
        y: Axis::new("Total angle of attack", "deg").with_range(0.0, 180.0),
        series: series.collect(),
        ..Figure::default()
    };
    let drawn = svg(&figure, &Theme::light(), 900, 480);
    let file = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../docs/backward-entry.svg");
    if env::var_os("UPDATE_SNAPSHOTS").is_some() {
        return fs::write(&file, drawn).unwrap();
    }
    let published = fs::read_to_string(&file).unwrap_or_default();
    assert!(
        drawn == published,
        "docs/backward-entry.svg is not what is drawn now; if that is meant, record anew with UPDATE_SNAPSHOTS=1"
    );
}
