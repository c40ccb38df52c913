//! Flat faces where a body is cut: its half-section triangulated by ear clipping.

use super::Mesh;
use super::revolve::{Run, Turn, position_m};
use msape::vehicle::segment::Point;

/// Adds the faces at both ends of the revolution. The chains of one profile follow each other along the axis.
pub fn faces(mesh: &mut Mesh, runs: &[Run], turn: &Turn) {
    let mut polygon: Vec<Point> = Vec::new();
    for station in runs.iter().flatten().flatten() {
        if polygon.last() != Some(&station.at) {
            polygon.push(station.at);
        }
    }
    while polygon.len() > 1 && polygon.last() == polygon.first() {
        polygon.pop();
    }
    // chains run with the inside on the right, a counter-clockwise polygon has it on the left
    polygon.reverse();
    let triangles = triangulated(&polygon);
    let (Some(&from), Some(&to)) = (turn.columns.first(), turn.columns.last()) else {
        return;
    };
    for (column, side) in [(from, -1.0), (to, 1.0)] {
        let first = mesh.positions_m.len() as u32;
        let (sine, cosine) = column;
        for &at in &polygon {
            mesh.positions_m.push(position_m(at, column));
            mesh.normals
                .push([0.0, -side * sine, side * cosine].map(|v| v as f32));
            mesh.section_m.push([at.x_m as f32, at.r_m as f32]);
        }
        for &[a, b, c] in &triangles {
            let turned = if side > 0.0 { [a, b, c] } else { [a, c, b] };
            mesh.triangles.push(turned.map(|i| first + i));
        }
    }
}

/// Twice the area of a triangle, positive when counter-clockwise.
fn area(a: Point, b: Point, c: Point) -> f64 {
    (b.x_m - a.x_m) * (c.r_m - a.r_m) - (b.r_m - a.r_m) * (c.x_m - a.x_m)
}

/// Triangulation of a counter-clockwise polygon: two triangles fewer than corners. Where the polygon touches itself or,
/// because of its chords, crosses itself, triangles may overlap, but their edges still meet in pairs.
pub fn triangulated(polygon: &[Point]) -> Vec<[u32; 3]> {
    let mut left: Vec<(u32, Point)> = (0..).zip(polygon.iter().copied()).collect();
    let mut triangles = Vec::with_capacity(polygon.len().saturating_sub(2));
    let mut at = 0;
    while left.len() > 2 {
        let n = left.len();
        let corner = |i: usize| {
            let get = |k: usize| left.get((i + k) % n).copied().unwrap_or_default();
            [get(n - 1), get(0), get(1)]
        };
        let is_ear = |i: &usize| {
            let [(_, a), (_, b), (_, c)] = corner(i % n);
            let inside = |p: Point| {
                p != a
                    && p != b
                    && p != c
                    && area(a, b, p) >= 0.0
                    && area(b, c, p) >= 0.0
                    && area(c, a, p) >= 0.0
            };
            area(a, b, c) > 0.0 && !left.iter().any(|&(_, p)| inside(p))
        };
        let convex = |i: &usize| {
            let [(_, a), (_, b), (_, c)] = corner(i % n);
            area(a, b, c) >= 0.0
        };
        let ear = (at..at + n)
            .find(is_ear)
            .or_else(|| (at..at + n).find(convex))
            .unwrap_or(at)
            % n;
        triangles.push(corner(ear).map(|(i, _)| i));
        left.remove(ear);
        // move on by one corner, so that the triangles do not all share one
        at = ear + 1;
    }
    triangles
}
