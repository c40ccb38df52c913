//! Table of the documentation: aft shape, center of gravity and rates that lead to a backward entry.

use msape::answer::output;
use msape::flight::six_dof::reorientation::Facing;
use msape::flight::six_dof::turning::{Start, Turn};
use msape::problem::add_turning;
use msape::progress::Unwatched;
use msape::units::number::rounded;
use msape::{Case, Library, Request, library};
use std::fmt::Write;
use std::path::PathBuf;
use std::{env, fs};

const DESIGNS: [&str; 4] = ["msr-eev-pica", "msr-eev-cp", "galahad", "run-page"];

const HEAD: &str = "\
| Design | Lid radius, of the vehicle's | Wing slope, deg | CG, D | Margin, free-molecular and hypersonic, D | Stable trims, hypersonic, deg | Backward at −2 deg/s | at rest | at +2 deg/s |
| --- | --: | --: | --: | --: | --: | --- | --- | --- |
";

/// Starting angles from which the vehicle is backward at peak heating, for one rate.
fn backward_deg(entries: &[Turn], rate_rad_s: f64) -> String {
    let those = entries
        .iter()
        .filter(|e| e.start.pitch_rate_rad_s == rate_rad_s && e.facing == Facing::Backward)
        .map(|e| format!("{:.0}", e.start.alpha_rad.to_degrees()));
    let list = those.collect::<Vec<_>>().join(", ");
    if list.is_empty() {
        "–".to_string()
    } else {
        list
    }
}

fn row(library: &Library, name: &str) -> String {
    let text = library::data_file(&format!("cases/{name}.toml")).unwrap();
    let case = Case::from_text(text).unwrap();
    let mut answer = msape::design(&case, library, Request::Nothing).unwrap();
    add_turning(&case, library, &mut answer, &mut Unwatched).unwrap();
    let number = |key: &str, digits: usize| {
        let value = (output::find(key).unwrap().get)(&answer);
        value.map_or_else(|| "–".to_string(), |x| rounded(x, digits))
    };
    let design = answer.design.as_ref().unwrap();
    let d = &design.vehicle.dimensions;
    let stability = design.stability.as_ref().unwrap();
    let stable = stability.hypersonic.trims.iter().filter(|t| t.is_stable());
    let stable: Vec<String> = stable.map(|t| rounded(t.alpha_deg, 3)).collect();
    let entries = &design.turning.as_ref().unwrap().entries;
    let rates = [0, 1, 2].map(|i| backward_deg(entries, Start::all()[i].pitch_rate_rad_s));
    let mut line = format!("| `{name}` ");
    for cell in [
        rounded(2.0 * d.lid_radius_m / d.diameter_m, 2),
        number("wing_slope_deg", 3),
        rounded(d.cg_from_apex_m / d.diameter_m, 3),
        format!(
            "{}, {}",
            number("free_molecular_static_margin", 2),
            number("hypersonic_static_margin", 2)
        ),
        stable.join(", "),
    ]
    .into_iter()
    .chain(rates)
    {
        write!(line, "| {cell} ").unwrap();
    }
    line.push_str("|\n");
    line
}

#[test]
fn entries_of_the_shipped_designs_are_those_of_the_documentation() {
    let library = Library::builtin().unwrap();
    let rows = DESIGNS.map(|name| row(&library, name));
    let table = format!("{HEAD}{}", rows.concat());
    let file = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../docs/reorientation.md");
    if env::var_os("UPDATE_SNAPSHOTS").is_some() {
        return fs::write(&file, table).unwrap();
    }
    let published = fs::read_to_string(&file).unwrap_or_default();
    assert!(
        table == published,
        "docs/reorientation.md is not what is found now; if that is meant, record anew with UPDATE_SNAPSHOTS=1:\n{table}"
    );
}
