//! Curves that are neither line nor arc, and objects out of the plane.

use super::*;

#[test]
fn blocks_may_be_mirrored_stretched_and_seen_from_behind() {
    // nose on the right, an arc of bulge b: its mirror image has the nose on the left
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
    // scaled by 6 along x and 5 across: half an ellipsoid of 0.6 by 0.5
    let stretched = sheet("", &quarter, "0 INSERT 8 0 2 Q 10 0 20 0 41 -6 42 5");
    near(taken(&stretched).0, 2.0 / 3.0 * PI * 0.25 * 0.6);
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
    // the same curve raised to degree 3: inner points at two thirds
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
    // a circle of nine control points, with weights cos 45° at the corners
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
    // periodic knots with repeated first points: uniform quadratic spans between the midpoints of a square of 2 m;
    // upper half: r = 1 − x² / 2 up to the middle of a side, mirrored: 2 π ∫ r² dx with parabolic corners
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
    // clamped knots with separate ends, marked as closed, as some programs write what they draw as a closed curve
    let apart = "0 SPLINE 8 0 70 11 71 2 72 6 73 3 40 0 40 0 40 0 40 1 40 1 40 1 10 0 20 0 10 0 20 500 10 500 20 500";
    assert!(refused(&entities(&format!("{apart} {BASE}"))).contains("its ends do not meet"));
    let wrong = circle.replace(" 41 1 ", " 41 -1 ");
    assert!(refused(&entities(&wrong)).contains("weight of zero or less"));
}

#[test]
fn a_spline_of_fit_points_goes_through_them() {
    // any cubic r(u) with x = u would be met exactly; here a line, whatever the length of its tangents
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
    // a 3-D polyline at constant height counts as flat
    let flat =
        "0 POLYLINE 8 0 66 1 70 8 0 VERTEX 10 0 20 0 30 7 0 VERTEX 10 500 20 500 30 7 0 SEQEND";
    near(taken(&entities(&format!("{flat} {BASE}"))).0, CONE_M3);
}
