//! Lines, arcs and polylines, unordered.

use super::*;

fn drawing_of(units: &str, entities: &str) -> String {
    format!(
        "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n{units}\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n{entities}0\nENDSEC\n0\nEOF\n"
    )
}

const CONE: &str = "0\nLINE\n8\n0\n10\n1000\n20\n1000\n11\n0\n21\n0\n0\nLINE\n8\n0\n10\n1000.0\n20\n0.0\n11\n1000.0\n21\n1000.0\n0\nTEXT\n1\ncone\n";

fn volume(text: &str) -> f64 {
    let Imported { rows, .. } = read(text.as_bytes(), None).unwrap();
    from_rows("x", &rows).unwrap().outline.solid().volume_m3
}

#[test]
fn two_loose_lines_in_millimeters_are_a_cone() {
    assert!((volume(&drawing_of("4", CONE)) - PI / 3.0).abs() < 1e-12);
}

#[test]
fn a_half_circle_and_its_diameter_are_a_ball() {
    let arc =
        "0\nARC\n8\n0\n10\n5\n20\n0\n40\n2\n50\n0\n51\n180\n0\nLINE\n10\n3\n20\n0\n11\n7\n21\n0\n";
    assert!((volume(&drawing_of("6", arc)) - 4.0 / 3.0 * PI * 8.0).abs() < 1e-12);
    // the same seen from behind: the center is at x = −5
    let behind = arc
        .replace("40\n2\n", "40\n2\n230\n-1\n")
        .replace("10\n3\n", "10\n-3\n");
    let Imported { rows, .. } = read(drawing_of("6", &behind).as_bytes(), None).unwrap();
    assert!((rows[0][0] + 7.0).abs() < 1e-12 && (rows[0][2] + 1.0).abs() < 1e-12);
}

#[test]
fn polylines_with_bulges_old_and_new() {
    // quarter circle of radius 1 from the axis, then down: half a ball
    let b = tan(PI / 8.0);
    let new = format!(
        "0\nLWPOLYLINE\n90\n3\n70\n1\n10\n0\n20\n0\n42\n-{b}\n10\n1\n20\n1\n10\n1\n20\n0\n"
    );
    let old = format!(
        "0\nPOLYLINE\n66\n1\n70\n0\n0\nVERTEX\n10\n0\n20\n0\n42\n-{b}\n0\nVERTEX\n10\n1\n20\n1\n0\nVERTEX\n10\n1\n20\n0\n0\nSEQEND\n"
    );
    for text in [new, old] {
        assert!((volume(&drawing_of("6", &text)) - 2.0 * PI / 3.0).abs() < 1e-12);
    }
}

#[test]
fn only_the_layer_outline_counts_where_there_is_one() {
    let named = CONE.replace("8\n0\n", "8\nOutline\n");
    let other = "0\nLINE\n8\nfoam\n10\n1\n20\n1\n11\n2\n21\n2\n0\n3DFACE\n8\nfoam\n";
    assert!((volume(&drawing_of("4", &format!("{named}{other}"))) - PI / 3.0).abs() < 1e-12);
}

#[test]
fn what_is_not_read_is_said_with_its_line() {
    let said = |text: &str, unit| {
        let faults = read(text.as_bytes(), unit).unwrap_err();
        faults
            .iter()
            .map(ToString::to_string)
            .collect::<Vec<_>>()
            .join("; ")
    };
    let spline = drawing_of("4", &format!("{CONE}0\n3DFACE\n8\n0\n"));
    assert!(said(&spline, None).contains("3DFACE is not read"));
    assert!(said(&drawing_of("0", CONE), None).contains("no $INSUNITS"));
    assert!(read(drawing_of("0", CONE).as_bytes(), Some(LengthUnit::Meter)).is_ok());
    assert!(said(&drawing_of("13", CONE), None).contains("$INSUNITS: got 13, must be"));
    assert!(said("x,r\n1,2\n", None).starts_with("line 1: got \"x,r\", must be the group code"));
    assert!(
        said(
            &drawing_of("4", &CONE.replace("10\n1000\n", "10\nwide\n")),
            None
        )
        .contains("got \"wide\"")
    );
    assert!(said(&drawing_of("4", ""), None).contains("holds no LINE"));
    assert!(said("", None).contains("holds no DXF"));
}
