mod blocks;
mod curves;
mod plain;

use super::*;
use msape::vehicle::body::from_rows;
use numerics::math::{PI, tan};

/// Volume of a cone of 0.5 m radius and 0.5 m length, which most drawings below show, m³.
const CONE_M3: f64 = PI * 0.125 / 3.0;
/// Side and base of the cone, mm.
const SIDE: &str = "0 LINE 8 0 10 0 20 0 11 500 21 500";
const BASE: &str = "0 LINE 8 0 10 500 20 500 11 500 21 0";

/// A text with one line per word.
fn lines(words: &str) -> String {
    words
        .split_whitespace()
        .map(|word| format!("{word}\n"))
        .collect()
}

/// A drawing in millimeters with layers, blocks and entities.
fn sheet(layers: &str, blocks: &str, entities: &str) -> String {
    lines(&format!(
        "0 SECTION 2 HEADER 9 $INSUNITS 70 4 0 ENDSEC 0 SECTION 2 TABLES {layers} 0 ENDSEC \
         0 SECTION 2 BLOCKS {blocks} 0 ENDSEC 0 SECTION 2 ENTITIES {entities} 0 ENDSEC 0 EOF"
    ))
}

fn entities(entities: &str) -> String {
    sheet("", "", entities)
}

/// Volume in m³ and messages of a drawing.
fn taken(text: &str) -> (f64, String) {
    match read(text.as_bytes(), None) {
        Ok(Imported { rows, remarks }) => {
            let body = from_rows("x", &rows).unwrap();
            (body.outline.solid().volume_m3, remarks.join("; "))
        }
        Err(faults) => panic!("{faults:?}"),
    }
}

fn refused(text: &str) -> String {
    let faults = read(text.as_bytes(), None).unwrap_err();
    let words: Vec<String> = faults.iter().map(ToString::to_string).collect();
    words.join("; ")
}

fn near(volume_m3: f64, wanted_m3: f64) {
    let off = volume_m3 / wanted_m3 - 1.0;
    assert!(off.abs() < 1e-8, "{volume_m3} against {wanted_m3}: {off:e}");
}

/// The drawing in binary form, with two-byte or one-byte codes.
fn binary(text: &str, wide: bool) -> Vec<u8> {
    let mut bytes = b"AutoCAD Binary DXF\r\n\x1a\0".to_vec();
    let lines: Vec<&str> = text.lines().collect();
    for pair in lines.chunks(2) {
        let (code, value) = (pair[0].parse::<u8>().unwrap(), pair[1]);
        bytes.push(code);
        bytes.extend(wide.then_some(0));
        match code {
            10..=59 => bytes.extend(value.parse::<f64>().unwrap().to_le_bytes()),
            60..=79 => bytes.extend(value.parse::<i16>().unwrap().to_le_bytes()),
            90..=99 => bytes.extend(value.parse::<i32>().unwrap().to_le_bytes()),
            _ => bytes.extend([value.as_bytes(), b"\0"].concat()),
        }
    }
    bytes
}

#[test]
fn binary_drawings_are_read_with_codes_of_one_and_of_two_bytes() {
    let text = entities(&format!("{SIDE} {BASE}"));
    let rows = read(text.as_bytes(), None).unwrap().rows;
    for wide in [false, true] {
        let bytes = binary(&text, wide);
        assert_eq!(read(&bytes, None).unwrap().rows, rows);
        let cut = read(&bytes[..bytes.len() - 20], None);
        let said = format!("{cut:?}");
        assert!(
            said.contains("may be cut off") || said.contains("ends within a group"),
            "{said}"
        );
    }
    let dwg = read(b"AC1032\0\0\0\0", None).unwrap_err()[0].to_string();
    assert_eq!(dwg, "the file is a DWG drawing (AC1032); save it as DXF");
    let large = vec![b' '; MOST_BYTES + 1];
    assert!(
        read(&large, None).unwrap_err()[0]
            .to_string()
            .contains("larger than 32 MiB")
    );
}

#[test]
fn paper_space_and_invisible_entities_are_not_drawn() {
    let border = "0 LINE 67 1 8 0 10 0 20 0 11 0 21 297 0 LINE 67 1 8 0 10 0 20 297 11 420 21 297";
    let unseen = "0 LINE 60 1 8 0 10 0 20 0 11 9 21 297";
    let (volume, said) = taken(&entities(&format!("{SIDE} {border} {unseen} {BASE}")));
    near(volume, CONE_M3);
    assert_eq!(
        said,
        "entities that are not drawn are left out: 2 in paper space, 1 invisible"
    );
    let nothing = refused(&entities(border));
    assert!(
        nothing.contains("shows no line or curve") && nothing.contains("2 in paper space"),
        "{nothing}"
    );
}

#[test]
fn layers_that_are_off_frozen_or_not_plotted_are_not_drawn() {
    let stray = "0 LINE 8 Hilfe 10 0 20 0 11 300 21 900";
    for (layer, why) in [
        ("0 LAYER 2 HILFE 70 0 62 -7", "which is off"),
        ("0 LAYER 2 HILFE 70 1 62 7", "which is frozen"),
        ("0 LAYER 2 HILFE 70 0 62 7 290 0", "which is not plotted"),
    ] {
        let (volume, said) = taken(&sheet(layer, "", &format!("{SIDE} {stray} {BASE}")));
        near(volume, CONE_M3);
        assert!(
            said.contains(&format!("1 on the layer HILFE, {why}")),
            "{said}"
        );
    }
    // locked layers, and layers frozen in new viewports, are drawn
    let drawn = sheet(
        "0 LAYER 2 HILFE 70 6 62 7",
        "",
        &format!("{SIDE} {stray} {BASE}"),
    );
    assert!(refused(&drawn).contains("off the axis"));
}

#[test]
fn the_frame_of_a_smoothed_polyline_is_not_drawn() {
    let frame = ["0 0", "0 400", "500 500"].map(|at| {
        let [x, y] = <[&str; 2]>::try_from(at.split(' ').collect::<Vec<_>>()).unwrap();
        format!("0 VERTEX 8 0 10 {x} 20 {y} 70 16")
    });
    let curve = "0 VERTEX 8 0 10 0 20 0 70 8 0 VERTEX 8 0 10 200 20 300 70 8 0 VERTEX 8 0 10 500 20 500 70 8";
    let text = entities(&format!(
        "0 POLYLINE 8 0 66 1 70 4 {} {curve} 0 SEQEND {BASE}",
        frame.join(" ")
    ));
    // a cone and a frustum: π/3 · 0.2 · 0.09 + π/3 · 0.3 · (0.09 + 0.15 + 0.25)
    near(taken(&text).0, PI / 3.0 * (0.018 + 0.147));
    let only = entities(&format!(
        "0 POLYLINE 8 0 66 1 70 4 {} 0 SEQEND {BASE}",
        frame.join(" ")
    ));
    assert!(refused(&only).contains("only the frame"));
}

#[test]
fn construction_lines_and_annotations_are_named_and_left_out() {
    let more = "0 XLINE 8 0 10 0 20 0 11 1 21 0 0 RAY 8 0 10 0 20 0 11 1 21 1 0 TEXT 8 0 1 nose 0 HATCH 8 0 0 XLINE 8 0";
    let (volume, said) = taken(&entities(&format!("{SIDE} {more} {BASE}")));
    near(volume, CONE_M3);
    assert_eq!(
        said,
        "entities that are no part of an outline are left out: 1 HATCH, 1 RAY, 1 TEXT, 2 XLINE"
    );
}

#[test]
fn the_lower_half_or_both_are_as_good_as_the_upper_one() {
    let lower = "0 LINE 8 0 10 0 20 0 11 500 21 -500 0 LINE 8 0 10 500 20 -500 11 500 21 0";
    let (volume, said) = taken(&entities(lower));
    near(volume, CONE_M3);
    assert_eq!(said, "the half below the axis is drawn; it is mirrored");
    let both = "0 LWPOLYLINE 8 0 90 3 70 1 10 0 20 0 10 500 20 500 10 500 20 -500 0 LINE 8 axis 10 -50 20 0 11 600 21 0";
    near(taken(&entities(both)).0, CONE_M3);
    let unlike = refused(&entities(&both.replace("-500", "-490")));
    assert!(
        unlike.contains("halves above and below the axis differ: at x = 0.5 m"),
        "{unlike}"
    );
    let upright = refused(&entities(
        "0 LINE 8 0 10 0 20 0 11 500 21 500 0 LINE 8 0 10 500 20 500 11 0 21 500",
    ));
    assert!(
        upright.contains("an outline about the line x = 0 m"),
        "{upright}"
    );
}

#[test]
fn the_unit_of_the_user_stands_above_that_of_the_drawing() {
    let text = entities(&format!("{SIDE} {BASE}"));
    for (code, said) in [
        ("6", "is drawn in m ($INSUNITS 6); it is read in mm"),
        ("13", "names another unit ($INSUNITS 13); it is read in mm"),
        ("0", ""),
        ("4", ""),
    ] {
        let text = text.replace("70\n4\n", &format!("70\n{code}\n"));
        let Imported { rows, remarks } =
            read(text.as_bytes(), Some(LengthUnit::Millimeter)).unwrap();
        assert_eq!(rows[1][0], 0.5);
        let remarks = remarks.join("; ");
        assert!(
            remarks.contains(said) && remarks.is_empty() == said.is_empty(),
            "{remarks}"
        );
    }
}

#[test]
fn a_thousand_lines_in_any_order_are_joined() {
    // a paraboloid r² = x / 2 up to x = 0.5 m: V = π/16 minus what its chords cut off
    let at = |k: i32| [0.5 * f64::from(k * k) / 1e6, 0.5 * f64::from(k) / 1e3].map(|m| 1e3 * m);
    let mut list: Vec<String> = (0..1000)
        .map(|k| {
            let [[x0, y0], [x1, y1]] = [at(k), at(k + 1)];
            format!("0 LINE 8 0 10 {x0} 20 {y0} 11 {x1} 21 {y1}")
        })
        .collect();
    list.push(BASE.to_owned());
    // 10 and the number of lines, 1001, have no common factor
    let mixed: Vec<&str> = (0..list.len())
        .map(|i| list[i * 10 % list.len()].as_str())
        .collect();
    let (volume, _) = taken(&entities(&mixed.join(" ")));
    assert!((volume / (PI / 16.0) - 1.0).abs() < 2e-6, "{volume}");
}
