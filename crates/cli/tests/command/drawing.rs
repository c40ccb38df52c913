//! Outlines from drawings.

use super::{folder, msape, path};
use std::fs;

/// Side and base of a cone of 0.5 m by 0.5 m, below the axis, in a drawing in meters.
const DRAWING: &str = "0 SECTION 2 HEADER 9 $INSUNITS 70 6 0 ENDSEC 0 SECTION 2 ENTITIES \
    0 LINE 8 0 10 0 20 0 11 500 21 -500 0 XLINE 8 0 10 0 20 0 11 1 21 0 \
    0 LINE 8 0 10 500 20 -500 11 500 21 0 0 ENDSEC 0 EOF";

fn case(name: &str, drawing: &[u8]) -> (String, String) {
    let here = folder(name);
    let file = here.join("case.toml");
    fs::write(here.join("cone.dxf"), drawing).unwrap();
    let text = "schema = \"msape/1\"\n[outline]\nfile = \"cone.dxf\"\nfile_unit = \"mm\"\n";
    fs::write(&file, text).unwrap();
    let done = msape(&["outline", path(&file), "--json"]);
    (done.out, done.err)
}

#[test]
fn what_was_made_of_a_drawing_is_said_beside_the_answer() {
    let lines: String = DRAWING
        .split_whitespace()
        .map(|word| format!("{word}\n"))
        .collect();
    let (out, err) = case("drawing", lines.as_bytes());
    for part in [
        "cone.dxf: the file is drawn in m ($INSUNITS 6); it is read in mm, as you say",
        "left out: 1 XLINE",
        "the half below the axis is drawn; it is mirrored",
    ] {
        assert!(err.contains(part), "{err}");
    }
    let answer: serde_json::Value = serde_json::from_str(&out).unwrap();
    let volume_m3 = answer["outline"]["volume_m3"].as_f64().unwrap();
    // π r² h / 3
    assert!((volume_m3 - std::f64::consts::PI * 0.125 / 3.0).abs() < 1e-15);
}

#[test]
fn a_file_of_another_kind_is_named() {
    let (out, err) = case("no-drawing", b"AC1027\0\0\xff");
    assert!(
        out.is_empty() && err.contains("is a DWG drawing (AC1027); save it as DXF"),
        "{err}"
    );
}
