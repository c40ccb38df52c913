//! Designs, outlines and their exports: masses add up, coefficients and files hold finite numbers, files read back.

use super::truths::{finite, mass_adds_up, repeated};
use super::{Tally, hold};
use crate::designs::{LIBRARY, run_page};
use cad::export::{Format, Info, Model};
use msape::aero::polar::{self, Aero, Theory, polar as polar_of};
use msape::case::Value;
use msape::problem::AeroProblem;
use msape::quantity::Job;
use msape::vehicle::body::RigidBody;
use msape::{Case, Outcome, Request, problem};
use proptest::prelude::*;
use proptest::sample::select;

/// Words of a text file that stand for non-finite numbers.
fn no_numbers(text: &str) -> Option<&str> {
    let words = text.split(|c: char| !c.is_ascii_alphanumeric() && c != '-');
    let mut words = words.map(|word| word.trim_start_matches('-'));
    words.find(|word| ["NaN", "nan", "inf", "Infinity"].contains(word))
}

/// Whether all pieces are long enough for the reader of drawings to keep their ends apart.
fn is_coarse(model: &Model) -> bool {
    let size_m = model
        .outline
        .bounds_m()
        .into_iter()
        .fold(0.0, |a: f64, b| a.max(b.abs()));
    let lengths = model.outline.segments.iter().map(|piece| {
        let (start, end) = (piece.start(), piece.end());
        (end.x_m - start.x_m).hypot(end.r_m - start.r_m)
    });
    lengths.into_iter().all(|length_m| length_m > 1e-4 * size_m)
}

/// Every format is complete and finite; drawing and table read back with the volume of the model.
fn exports(model: &Model, tally: &Tally) -> Result<(), TestCaseError> {
    for format in Format::ALL {
        let bytes = format.write(model, &Info::default());
        tally.one("exported files");
        prop_assert!(!bytes.is_empty(), "{}: empty", format.name());
        // base64 in a glTF may contain any word
        if format.is_text() && format != Format::Gltf {
            let text = String::from_utf8(bytes.clone()).unwrap();
            prop_assert_eq!(no_numbers(&text), None, "{}", format.name());
        }
        if format == Format::Gltf {
            prop_assert!(
                serde_json::from_slice::<serde_json::Value>(&bytes).is_ok(),
                "glTF"
            );
        }
    }
    if !is_coarse(model) {
        return Ok(());
    }
    tally.one("read back");
    let volume_m3 = model.outline.solid().volume_m3;
    for (format, name) in [(Format::Csv, "a.csv"), (Format::Dxf, "a.dxf")] {
        let bytes = format.write(model, &Info::default());
        let read = match cad::outline::read(name, &bytes, None) {
            Ok(read) => read,
            Err(faults) => return Err(TestCaseError::fail(format!("{name}: {faults:?}"))),
        };
        let back = msape::vehicle::body::from_rows("x", &read.rows);
        let back = match back {
            Ok(body) => body.outline.solid().volume_m3,
            Err(faults) => return Err(TestCaseError::fail(format!("{name}: {faults:?}"))),
        };
        prop_assert!(
            (back / volume_m3 - 1.0).abs() < 1e-6,
            "{}: {} of {} m3",
            name,
            back,
            volume_m3
        );
    }
    Ok(())
}

/// Checks the coefficients at a Mach number, from nose first to tail first.
fn coefficients(case: &Case, mach: f64, knudsen: f64, tally: &Tally) -> Result<(), TestCaseError> {
    let (body, database) =
        match AeroProblem::check(case, &LIBRARY).and_then(|problem| problem.solve()) {
            Ok(found) => found,
            Err(faults) => {
                prop_assert!(!faults.is_empty());
                return Ok(());
            }
        };
    let angles: Vec<f64> = (0..=12).map(|n| 15.0 * f64::from(n)).collect();
    for theory in [
        Theory::newtonian(Some(mach), 1.4),
        Theory::Blended { mach, knudsen },
    ] {
        let polar = polar_of(&Aero::new(&body, theory, Some(&database)), &angles);
        tally.one("polars");
        for row in &polar.rows {
            let all = [row.ca, row.cn, row.cm_apex, row.cd, row.cl];
            prop_assert!(all.iter().all(|x| x.is_finite()), "{:?}", row);
            prop_assert!(row.cd >= -1e-9, "air pushes: {:?}", row);
        }
        let _ = polar::remarks(&polar, &theory, &database);
    }
    Ok(())
}

fn check_design(case: &Case, tally: &Tally) -> Result<(), TestCaseError> {
    let answer = match repeated(case, Job::Design, Request::Steps)? {
        Ok(answer) => answer,
        Err(faults) => {
            prop_assert!(!faults.is_empty());
            tally.one("refused");
            return Ok(());
        }
    };
    tally.one("answers");
    tally.one(answer.outcome.name());
    finite(&answer, Job::Design)?;
    if mass_adds_up(case, &answer)? {
        tally.one("mass trees");
    }
    if let Some(design) = answer
        .design
        .as_ref()
        .filter(|_| answer.outcome == Outcome::Converged)
    {
        exports(&Model::of_vehicle(&answer.name, &design.vehicle), tally)?;
    }
    Ok(())
}

#[test]
fn designs_with_and_without_an_impact_sphere() {
    let planet = select(vec![
        "earth-msape",
        "earth-msape",
        "earth",
        "mars",
        "venus",
        "titan",
    ]);
    hold(
        "designs",
        30,
        &(run_page(), planet),
        |(case, planet), tally| {
            let mut case = case.clone();
            case.set("entry.planet", planet);
            check_design(&case, tally)
        },
    );
}

/// Outlines by points or by dimensions, plausible or not.
fn outline() -> impl Strategy<Value = Case> {
    let size = || prop_oneof![6 => 0.0..3.0_f64, 1 => -1.0..10.0, 1 => select(vec![0.0, 1e-9, 1e4, 1e-320])];
    let bulge = prop_oneof![4 => Just(0.0), 2 => -1.0..1.0_f64, 1 => -20.0..20.0_f64];
    let points = prop::collection::vec((size(), size(), bulge), 1..12).prop_map(|points| {
        let mut rows: Vec<Vec<f64>> = points
            .into_iter()
            .map(|(x, r, bulge)| vec![x, r, bulge])
            .collect();
        rows.sort_by(|a, b| a[0].total_cmp(&b[0]));
        // most outlines begin and end on the axis
        if rows.len() > 2 {
            let last = rows.len() - 1;
            rows[0][1] = 0.0;
            rows[last][1] = 0.0;
        }
        let mut case = Case::default();
        case.values
            .insert("outline.points".to_string(), Value::Rows(rows));
        case
    });
    let aft = select(vec!["flat", "mmeev", "sphere", "none"]);
    let dimensions = (
        1.0..89.0_f64,
        0.05..5.0_f64,
        0.0..0.7_f64,
        0.0..0.3_f64,
        aft,
    )
        .prop_map(|(angle, diameter, nose, shoulder, aft)| {
            let mut case = Case::default();
            for (key, value) in [
                ("outline.cone_half_angle_deg", angle),
                ("outline.diameter_m", diameter),
                ("outline.nose_radius_m", nose * diameter),
                ("outline.shoulder_radius_m", shoulder * diameter),
            ] {
                case.set(key, &format!("{value:?}"));
            }
            case.set("outline.aft", aft);
            case
        });
    prop_oneof![points, dimensions]
}

fn check_body(body: &RigidBody, tally: &Tally) -> Result<(), TestCaseError> {
    let facts = serde_json::to_value(body.facts()).unwrap();
    prop_assert!(
        facts["volume_m3"].as_f64().is_some_and(|v| v > 0.0),
        "{}",
        facts
    );
    prop_assert!(
        facts["length_m"].as_f64().is_some_and(|l| l > 0.0),
        "{}",
        facts
    );
    exports(&Model::of_body("body", body), tally)
}

#[test]
fn outlines_their_coefficients_and_files() {
    let drawn = (
        outline(),
        0.05..40.0_f64,
        prop_oneof![Just(0.0), 1e-4..100.0_f64],
    );
    hold(
        "outlines of cases",
        120,
        &drawn,
        |(case, mach, knudsen), tally| {
            match problem::rigid_body(case, &LIBRARY) {
                Ok(Some(body)) => {
                    tally.one("bodies");
                    check_body(&body, tally)?;
                }
                Ok(None) => prop_assert!(false, "an outline that is none"),
                Err(faults) => prop_assert!(!faults.is_empty()),
            }
            coefficients(case, *mach, *knudsen, tally)
        },
    );
}
