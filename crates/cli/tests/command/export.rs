//! Exports: files, formats, faults.

use crate::{command, folder, msape, msape_with, path, root};
use std::fs;

const GALAHAD: &str = "cases/galahad.toml";

fn cone(more: &str) -> String {
    format!(
        "schema = \"msape/1\"\n[outline]\npoints = [[0.0, 0.0], [0.5, 0.5], [0.5, 0.0]]\n{more}"
    )
}

#[test]
fn every_format_is_written_by_its_ending_and_by_its_name() {
    let folder = folder("export-every");
    let begins: [(&str, &[u8]); 8] = [
        ("step", b"ISO-10303-21;\n"),
        ("iges", b"Galahad"),
        ("stl", b"Units: mm. "),
        ("gltf", b"{\"asset\":"),
        ("glb", b"glTF\x02\0\0\0"),
        ("dxf", b"0\nSECTION\n2\nHEADER\n"),
        ("csv", b"component,body,segment,"),
        ("svg", b"<svg xmlns="),
    ];
    for (format, begin) in begins {
        let by_ending = folder.join(format!("vehicle.{format}"));
        let by_name = folder.join(format!("{format}-file"));
        let ending = msape(&["export", GALAHAD, "-o", path(&by_ending)]);
        assert_eq!(
            (ending.code, ending.err.as_str(), ending.out.as_str()),
            (Some(0), "", "")
        );
        let name = msape(&["export", GALAHAD, "--format", format, "-o", path(&by_name)]);
        assert_eq!(name.code, Some(0));
        let bytes = fs::read(by_ending).unwrap();
        assert!(bytes.starts_with(begin), "{format}");
        assert_eq!(bytes, fs::read(by_name).unwrap());
    }
}

#[test]
fn text_goes_to_standard_output_and_bytes_do_not() {
    let text = msape(&["export", GALAHAD, "--format", "step"]);
    assert!(text.out.ends_with("END-ISO-10303-21;\n"));
    assert_eq!(
        msape(&["export", GALAHAD, "--format", "step", "-o", "-"]).out,
        text.out
    );
    let bytes = msape(&["export", GALAHAD, "--format", "stl"]);
    assert_eq!((bytes.code, bytes.out.as_str()), (Some(2), ""));
    assert!(bytes.err.contains("stl is not text"), "{}", bytes.err);
}

#[test]
fn a_name_that_ends_in_glb_asks_for_the_binary_kind() {
    let file = folder("export-glb").join("vehicle.glb");
    let done = msape(&["export", GALAHAD, "--format", "gltf", "-o", path(&file)]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert!(fs::read(file).unwrap().starts_with(b"glTF"));
}

#[test]
fn an_unknown_format_is_answered_with_those_there_are() {
    let file = folder("export-unknown").join("vehicle.dwg");
    for arguments in [
        vec!["export", GALAHAD, "--format", "dwg"],
        vec!["export", GALAHAD, "-o", path(&file)],
        vec!["export", GALAHAD],
    ] {
        let done = msape(&arguments);
        assert_eq!((done.code, done.out.as_str()), (Some(2), ""));
        assert!(
            done.err
                .contains("step, iges, stl, gltf, glb, dxf, csv, svg"),
            "{}",
            done.err
        );
    }
    assert!(!file.exists());
}

#[test]
fn a_design_that_does_not_close_leaves_the_file_as_it_was() {
    let file = folder("export-not-closed").join("vehicle.step");
    fs::write(&file, "before").unwrap();
    let payload = "design.payload_mass_kg=900";
    let done = msape(&["export", GALAHAD, "--set", payload, "-o", path(&file)]);
    assert_eq!(done.code, Some(2));
    assert!(
        done.err.contains("there is no vehicle to export"),
        "{}",
        done.err
    );
    assert!(done.err.contains("not-closed"), "{}", done.err);
    assert_eq!(fs::read_to_string(file).unwrap(), "before");
}

#[test]
fn faults_of_the_case_are_all_told() {
    let done = msape(&[
        "export",
        GALAHAD,
        "--format",
        "step",
        "--set",
        "design.diameter_m=-1",
        "--set",
        "design.color=red",
    ]);
    assert_eq!((done.code, done.out.as_str()), (Some(2), ""));
    assert!(
        done.err.contains("design.diameter_m") && done.err.contains("design.color"),
        "{}",
        done.err
    );
}

#[test]
fn an_outline_is_exported_as_it_is() {
    let done = msape_with(&["export", "-", "--format", "csv"], cone("").as_bytes());
    assert_eq!((done.code, done.err.as_str()), (Some(0), ""));
    let rows: Vec<&str> = done.out.lines().skip(1).collect();
    assert_eq!(
        rows,
        [
            "outline,1,1,line,0,0,500,500,,,,",
            "outline,1,2,line,500,500,500,0,,,,",
            "body,1,1,line,0,0,500,500,,,,",
            "body,1,2,line,500,500,500,0,,,,",
        ]
    );
    let crossed = cone("").replace("[0.5, 0.0]", "[0.2, -0.1]");
    let done = msape_with(&["export", "-", "--format", "csv"], crossed.as_bytes());
    assert_eq!((done.code, done.out.as_str()), (Some(2), ""));
    assert!(done.err.contains("outline.points"), "{}", done.err);
}

#[test]
fn the_exported_outline_of_a_vehicle_is_read_again() {
    let folder = folder("export-again");
    let export = |case: &str, format: &str| {
        let done = command(&["export", case, "--format", format])
            .current_dir(root())
            .output()
            .unwrap();
        assert!(
            done.status.success(),
            "{}",
            String::from_utf8_lossy(&done.stderr)
        );
        String::from_utf8(done.stdout).unwrap()
    };
    let outline = |csv: &str| -> Vec<f64> {
        csv.lines()
            .filter(|line| line.starts_with("outline,"))
            .flat_map(|line| line.split(',').skip(4))
            .filter_map(|number| number.parse().ok())
            .collect()
    };
    let first = outline(&export(GALAHAD, "csv"));
    // three arcs of eight numbers, three lines of four
    assert_eq!(first.len(), 36);
    for format in ["dxf", "csv"] {
        let file = folder.join(format!("outline.{format}"));
        fs::write(&file, export(GALAHAD, format)).unwrap();
        let case = folder.join(format!("{format}.toml"));
        fs::write(
            &case,
            format!("schema = \"msape/1\"\n[outline]\nfile = \"outline.{format}\"\n"),
        )
        .unwrap();
        let again = outline(&export(path(&case), "csv"));
        assert_eq!(again.len(), first.len(), "{format}");
        for (is, was) in again.iter().zip(&first) {
            // the importer closes rounding gaps and computes arcs from their bulge: a millionth of a millimeter
            assert!((is - was).abs() < 1e-6, "{format}: {is} was {was}");
        }
    }
}
