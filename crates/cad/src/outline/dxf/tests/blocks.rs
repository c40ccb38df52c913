//! Inserted blocks.

use super::*;

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
fn blocks_are_drawn_where_they_are_inserted() {
    let cone = format!("0 BLOCK 2 Cone 70 0 10 100 20 0 {SIDE} {BASE} 0 ENDBLK");
    near(
        taken(&sheet("", &cone, "0 INSERT 8 0 2 CONE 10 7 20 0")).0,
        CONE_M3,
    );
    let (volume, said) = taken(&sheet("", &cone, "0 INSERT 8 0 2 cone 10 0 20 0 42 -1"));
    near(volume, CONE_M3);
    assert!(said.contains("below the axis"), "{said}");
    // the point p at 2 (p − base) rotated by 90°, shifted by (10, 20); rotated back (20, −10): raised by 10
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
    // an array of the side and its mirror image in steps of 0: duplicates
    let twice = "0 INSERT 8 0 2 cone 10 0 20 0 70 2 71 1 44 0";
    near(taken(&sheet("", &cone, twice)).0, CONE_M3);
    // an array that makes a row of two: not one outline
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
