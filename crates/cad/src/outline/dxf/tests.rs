use super::*;
use msape::vehicle::body::from_rows;
use numerics::math::{PI, tan};

/// Volume of the cone of 0.5 m by 0.5 m that most drawings below are of, m³.
const CONE_M3: f64 = PI * 0.125 / 3.0;
/// Its side and its base, in millimetres.
const SIDE: &str = "0 LINE 8 0 10 0 20 0 11 500 21 500";
const BASE: &str = "0 LINE 8 0 10 500 20 500 11 500 21 0";

/// A text with a line for each word.
fn lines(words: &str) -> String {
    words
        .split_whitespace()
        .map(|word| format!("{word}\n"))
        .collect()
}

/// A drawing in millimetres with layers, blocks and entities.
fn sheet(layers: &str, blocks: &str, entities: &str) -> String {
    lines(&format!(
        "0 SECTION 2 HEADER 9 $INSUNITS 70 4 0 ENDSEC 0 SECTION 2 TABLES {layers} 0 ENDSEC \
         0 SECTION 2 BLOCKS {blocks} 0 ENDSEC 0 SECTION 2 ENTITIES {entities} 0 ENDSEC 0 EOF"
    ))
}

fn entities(entities: &str) -> String {
    sheet("", "", entities)
}

/// Volume in m³ and what is remarked.
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

/// The same drawing in binary, with codes of two bytes or of one.
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
    // locked, and frozen in new viewports: drawn
    let drawn = sheet(
        "0 LAYER 2 HILFE 70 6 62 7",
        "",
        &format!("{SIDE} {stray} {BASE}"),
    );
    assert!(refused(&drawn).contains("off the axis"));
}

#[test]
fn a_layer_that_hides_an_insertion_hides_what_the_block_has_on_layer_0() {
    let blocks = "0 BLOCK 2 B 70 0 10 0 20 0 0 LINE 8 0 10 0 20 0 11 9 21 400 0 LINE 8 side 10 0 20 0 11 500 21 500 0 ENDBLK";
    let insert = "0 INSERT 8 aids 2 B 10 0 20 0";
    for (flags, drawn) in [
        ("70 0 62 -1", true),
        ("70 0 62 1 290 0", true),
        ("70 1 62 1", false),
    ] {
        let text = sheet(
            &format!("0 LAYER 2 aids {flags}"),
            blocks,
            &format!("{insert} {BASE}"),
        );
        if drawn {
            near(taken(&text).0, CONE_M3);
        } else {
            assert!(refused(&text).contains("off the axis"));
        }
    }
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
fn blocks_are_drawn_where_they_are_inserted() {
    let cone = format!("0 BLOCK 2 Cone 70 0 10 100 20 0 {SIDE} {BASE} 0 ENDBLK");
    near(
        taken(&sheet("", &cone, "0 INSERT 8 0 2 CONE 10 7 20 0")).0,
        CONE_M3,
    );
    let (volume, said) = taken(&sheet("", &cone, "0 INSERT 8 0 2 cone 10 0 20 0 42 -1"));
    near(volume, CONE_M3);
    assert!(said.contains("below the axis"), "{said}");
    // the point p at 2 (p − base) turned by 90°, moved by (10, 20); turned back (20, −10): lifted by 10
    let nested = format!(
        "{cone} 0 BLOCK 2 turned 70 0 10 0 20 0 0 INSERT 8 0 2 cone 10 10 20 20 41 2 42 2 50 90 0 ENDBLK"
    );
    near(
        taken(&sheet(
            "",
            &nested,
            "0 INSERT 8 0 2 turned 10 200 20 10 50 -90",
        ))
        .0,
        8.0 * CONE_M3,
    );
    // an array of the side and its mirror image in steps of 0, both drawn twice
    let twice = "0 INSERT 8 0 2 cone 10 0 20 0 70 2 71 1 44 0";
    near(taken(&sheet("", &cone, twice)).0, CONE_M3);
    // and one that makes a row of two: not one outline
    assert!(
        refused(&sheet(
            "",
            &cone,
            "0 INSERT 8 0 2 cone 10 0 20 0 70 2 44 1000"
        ))
        .contains("4 ends on the axis")
    );
}

#[test]
fn blocks_may_be_mirrored_stretched_and_seen_from_behind() {
    // nose to the right, an arc of bulge b: its mirror image has the nose to the left
    let b = tan(PI / 8.0);
    let quarter = format!(
        "0 BLOCK 2 Q 70 0 10 0 20 0 0 LWPOLYLINE 8 0 90 3 70 0 10 100 20 0 42 {b} 10 0 20 100 10 0 20 0 0 ENDBLK"
    );
    let half_ball = 2.0 / 3.0 * PI * 0.001;
    for insert in ["41 -1", "41 1", "42 -1", "230 -1", "41 -1 42 -1", "50 180"] {
        near(
            taken(&sheet(
                "",
                &quarter,
                &format!("0 INSERT 8 0 2 Q 10 0 20 0 {insert}"),
            ))
            .0,
            half_ball,
        );
    }
    // stretched by 6 along x and 5 across: half an ellipsoid of 0.6 by 0.5
    let stretched = sheet("", &quarter, "0 INSERT 8 0 2 Q 10 0 20 0 41 -6 42 5");
    near(taken(&stretched).0, 2.0 / 3.0 * PI * 0.25 * 0.6);
}

#[test]
fn blocks_in_themselves_and_numbers_without_end_are_refused() {
    let own = format!("0 BLOCK 2 A 70 0 10 0 20 0 {SIDE} 0 INSERT 8 0 2 A 10 0 20 0 0 ENDBLK");
    assert!(
        refused(&sheet("", &own, "0 INSERT 8 0 2 A 10 0 20 0"))
            .contains("deeper than 32; does \"a\" hold itself?")
    );
    let mut blocks = format!("0 BLOCK 2 L0 70 0 10 0 20 0 {SIDE} 0 ENDBLK");
    for k in 1..20 {
        let inside = format!(" 0 INSERT 8 0 2 L{} 10 0 20 0", k - 1).repeat(10);
        blocks.push_str(&format!(" 0 BLOCK 2 L{k} 70 0 10 0 20 0{inside} 0 ENDBLK"));
    }
    let laughs = sheet("", &blocks, "0 INSERT 8 0 2 L19 10 0 20 0");
    assert!(refused(&laughs).contains("more than 200000 entities"));
    let array = sheet(
        "",
        "0 BLOCK 2 E 70 0 10 0 20 0 0 ENDBLK",
        "0 INSERT 8 0 2 E 10 0 20 0 70 32767 71 32767",
    );
    assert!(refused(&array).contains("more than 200000 entities"));
    assert!(refused(&entities("0 INSERT 8 0 2 gone 10 0 20 0")).contains("has no block \"gone\""));
    let xref = sheet(
        "",
        "0 BLOCK 2 X 70 4 10 0 20 0 1 other.dwg 0 ENDBLK",
        "0 INSERT 8 0 2 X 10 0 20 0",
    );
    assert!(refused(&xref).contains("is another file"));
    let insert = format!("0 BLOCK 2 C 70 0 10 0 20 0 {SIDE} {BASE} 0 ENDBLK");
    let clipped = sheet(
        "",
        &insert,
        "0 INSERT 102 {ACAD_XDICTIONARY 360 5F 102 } 8 0 2 C 10 0 20 0",
    );
    near(taken(&clipped).0, CONE_M3);
    let clipped = clipped.replace(
        "0\nEOF\n",
        "0\nSECTION\n2\nOBJECTS\n0\nSPATIAL_FILTER\n0\nENDSEC\n0\nEOF\n",
    );
    assert!(refused(&clipped).contains("may be clipped"));
}

#[test]
fn a_circle_and_an_ellipse_are_bodies() {
    let ball = 4.0 / 3.0 * PI * 0.125;
    let (volume, said) = taken(&entities("0 CIRCLE 8 0 10 500 20 0 40 500"));
    near(volume, ball);
    assert!(said.contains("both halves"), "{said}");
    near(
        taken(&entities("0 CIRCLE 8 0 10 -500 20 0 40 500 230 -1")).0,
        ball,
    );
    near(
        taken(&entities("0 ARC 8 0 10 500 20 0 40 500 50 30 51 30")).0,
        ball,
    );
    // ten times as long as wide
    near(
        taken(&entities(
            "0 ELLIPSE 8 0 10 5000 20 0 11 5000 21 0 40 0.1 41 0 42 6.283185307179586",
        ))
        .0,
        10.0 * ball,
    );
    // a quarter of an ellipse of 0.6 by 0.5, from the front and from behind
    let base = "0 LINE 8 0 10 600 20 500 11 600 21 0";
    let quarter = format!("0 ELLIPSE 8 0 10 600 20 0 11 -600 21 0 40 {}", 5.0 / 6.0);
    for part in [
        format!("41 {} 42 {}", 1.5 * PI, 2.0 * PI),
        format!("41 0 42 {} 230 -1", 0.5 * PI),
    ] {
        near(
            taken(&entities(&format!("{quarter} {part} {base}"))).0,
            2.0 / 3.0 * PI * 0.25 * 0.6,
        );
    }
    assert!(refused(&entities("0 CIRCLE 8 0 10 5 20 0 40 0")).contains("got the radius 0"));
    assert!(
        refused(&entities("0 ELLIPSE 8 0 10 5 20 0 11 5 21 0 40 0")).contains("must be above 0")
    );
}

#[test]
fn splines_of_any_degree_are_followed() {
    // one quadratic span from (0, 0) over (0, 500) to (500, 500): x = t² / 2, r = t − t² / 2 in m
    // ∫ r² dx = ∫ (t − t²/2)² t dt = 1/4 − 1/5 + 1/24 = 11/120
    let parabola = "0 SPLINE 8 0 70 8 71 2 72 6 73 3 40 0 40 0 40 0 40 1 40 1 40 1 10 0 20 0 10 0 20 500 10 500 20 500";
    near(
        taken(&entities(&format!("{parabola} {BASE}"))).0,
        PI * 11.0 / 120.0,
    );
    // the same raised to degree 3: inner points at two thirds
    let p = 1000.0 / 3.0;
    let cubic = format!(
        "0 SPLINE 8 0 70 8 71 3 72 8 73 4 40 0 40 0 40 0 40 0 40 1 40 1 40 1 40 1 10 0 20 0 10 0 20 {p} 10 {} 20 500 10 500 20 500",
        500.0 / 3.0
    );
    near(
        taken(&entities(&format!("{cubic} {BASE}"))).0,
        PI * 11.0 / 120.0,
    );
    let straight = "0 SPLINE 8 0 70 8 71 1 72 4 73 2 40 0 40 0 40 1 40 1 10 0 20 0 10 500 20 500";
    near(taken(&entities(&format!("{straight} {BASE}"))).0, CONE_M3);
}

#[test]
fn rational_and_closed_splines_are_followed() {
    let ball = 4.0 / 3.0 * PI * 0.125;
    // the circle of nine control points, the weights of the corners cos 45°
    let corners = [
        (1, 0),
        (1, 1),
        (0, 1),
        (-1, 1),
        (-1, 0),
        (-1, -1),
        (0, -1),
        (1, -1),
        (1, 0),
    ];
    let points: String = corners
        .iter()
        .map(|(x, y)| format!(" 10 {} 20 {}", 500 + 500 * x, 500 * y))
        .collect();
    let weights: String = (0..9)
        .map(|i| format!(" 41 {}", if i % 2 == 0 { 1.0 } else { 0.5_f64.sqrt() }))
        .collect();
    let knots = " 40 0 40 0 40 0 40 1 40 1 40 2 40 2 40 3 40 3 40 4 40 4 40 4";
    let circle = format!("0 SPLINE 8 0 70 13 71 2 72 12 73 9{knots}{weights}{points}");
    near(taken(&entities(&circle)).0, ball);
    // periodic knots, its first points repeated: uniform quadratic spans from middle to middle of the corners of a square of 2 m
    // upper half: r = 1 − x² / 2 up to the middle of a side, mirrored: 2 π ∫ r² dx with corners of parabolas
    let square = [(-1, 1), (1, 1), (1, -1), (-1, -1), (-1, 1), (1, 1)];
    let points: String = square
        .iter()
        .map(|(x, y)| format!(" 10 {} 20 {}", 1000 * x, 1000 * y))
        .collect();
    let knots: String = (0..9).map(|k| format!(" 40 {k}")).collect();
    let closed = format!("0 SPLINE 8 0 70 11 71 2 72 9 73 6{knots}{points}");
    // a span from (0, 1) over (1, 1) to (1, 0): x = 2 t − t², r = 1 − t²; ∫ r² dx = 2 ∫ (1 − t²)² (1 − t) dt
    // = 2 (8/15 − 1/6) = 11/15, and as much on the other side
    near(taken(&entities(&closed)).0, 2.0 * PI * 11.0 / 15.0);
    let wrong = circle.replace(" 41 1 ", " 41 -1 ");
    assert!(refused(&entities(&wrong)).contains("weight of zero or less"));
}

#[test]
fn a_spline_of_fit_points_goes_through_them() {
    // x = u, r = a cubic of u would be met exactly; here a line, whatever its tangents say along it
    let fit = "0 SPLINE 8 0 70 8 71 3 74 3 11 0 21 0 11 100 21 100 11 500 21 500";
    near(taken(&entities(&format!("{fit} {BASE}"))).0, CONE_M3);
    let along = format!("{fit} 12 1 22 1 13 2 23 2");
    near(taken(&entities(&format!("{along} {BASE}"))).0, CONE_M3);
    assert!(
        refused(&entities(&format!("0 SPLINE 8 0 70 8 71 3 {BASE}")))
            .contains("neither control points nor two fit points")
    );
}

#[test]
fn what_leaves_the_plane_is_refused() {
    for (what, said) in [
        (
            "0 LINE 8 0 10 0 20 0 30 0 11 500 21 500 31 100",
            "from z = 0 to 100",
        ),
        (
            "0 ARC 8 0 10 5 20 0 40 2 50 0 51 90 210 0 220 1 230 0",
            "extrusion 0, 1, 0",
        ),
        (
            "0 POLYLINE 8 0 66 1 70 8 0 VERTEX 10 0 20 0 30 0 0 VERTEX 10 500 20 0 30 500 0 SEQEND",
            "from z = 0 to 500",
        ),
        (
            "0 POLYLINE 8 0 66 1 70 16 0 VERTEX 10 0 20 0 30 0 0 SEQEND",
            "POLYLINE that is a mesh is not read",
        ),
    ] {
        let found = refused(&entities(&format!("{what} {BASE}")));
        assert!(found.contains(said), "{found}");
    }
    // a polyline in space at a constant height is as good as flat
    let flat =
        "0 POLYLINE 8 0 66 1 70 8 0 VERTEX 10 0 20 0 30 7 0 VERTEX 10 500 20 500 30 7 0 SEQEND";
    near(taken(&entities(&format!("{flat} {BASE}"))).0, CONE_M3);
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
            read(text.as_bytes(), Some(LengthUnit::Millimetre)).unwrap();
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
    // a paraboloid r² = x / 2 up to x = 0.5 m: V = π/16 less what its chords cut off
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
fn two_loose_lines_in_millimetres_are_a_cone() {
    assert!((volume(&drawing_of("4", CONE)) - PI / 3.0).abs() < 1e-12);
}

#[test]
fn a_half_circle_and_its_diameter_are_a_ball() {
    let arc =
        "0\nARC\n8\n0\n10\n5\n20\n0\n40\n2\n50\n0\n51\n180\n0\nLINE\n10\n3\n20\n0\n11\n7\n21\n0\n";
    assert!((volume(&drawing_of("6", arc)) - 4.0 / 3.0 * PI * 8.0).abs() < 1e-12);
    // the same seen from behind: the centre is at x = −5
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
    assert!(read(drawing_of("0", CONE).as_bytes(), Some(LengthUnit::Metre)).is_ok());
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
