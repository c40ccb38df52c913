//! A chain revolved about the axis as a closed shell: each segment gives two half-turn faces on one analytic surface.
//!
//! ```text
//! ∂S/∂φ × ∂S/∂s points outwards: round a face the first circle forwards, the far meridian forwards, the second circle
//! backwards, the near meridian backwards
//! ```
//!
//! with S the surface, φ the angle about the axis, s the length along the chain. Faces cover half a turn, so that none
//! meets itself in a seam; where the chain ends on the axis the meridians meet in a vertex.

use super::part21::{Id, Instances, list, of, real, reals};
use crate::export::chain::{Chain, Ends, NOTHING_M};
use msape::vehicle::segment::{Point, Segment};
use numerics::math::{atan2, sin_cos};

/// Lengths in the file are in millimeters.
const MM_PER_M: f64 = 1000.0;

/// Largest sweep of an arc that is not split, rad: a half-turn with a margin for rounding.
const WHOLE_RAD: f64 = 3.2;

/// The two meridians that bound the faces: direction of r, (y, z) = (±1, 0).
const SIDES: [f64; 2] = [1.0, -1.0];

/// Joint of two segments.
#[derive(Clone, Copy)]
enum Joint {
    /// On the axis: one vertex.
    Pole(Id),
    /// On a circle: one vertex per meridian, one edge per half.
    Circle { vertices: [Id; 2], halves: [Id; 2] },
}

impl Joint {
    fn vertex(self, side: usize) -> Id {
        match self {
            Joint::Pole(vertex) => vertex,
            Joint::Circle {
                vertices: [near, far],
                ..
            } => {
                if side == 0 {
                    near
                } else {
                    far
                }
            }
        }
    }

    fn half(self, half: usize) -> Option<Id> {
        match self {
            Joint::Pole(_) => None,
            Joint::Circle {
                halves: [first, second],
                ..
            } => Some(if half == 0 { first } else { second }),
        }
    }
}

/// Adds the closed shell of a chain, oriented outward; lengths become millimeters.
pub fn closed_shell(instances: &mut Instances, chain: &Chain) -> Id {
    let segments: Vec<Segment> = chain.segments.iter().flat_map(halved).collect();
    let starts: Vec<Joint> = segments
        .iter()
        .map(|s| joint(instances, s.start()))
        .collect();
    let last = match (chain.ends, segments.last()) {
        (Ends::OnAxis, Some(segment)) => Some(joint(instances, segment.end())),
        _ => starts.first().copied(),
    };
    let ends = starts.iter().copied().skip(1).chain(last);
    let mut shell = Vec::with_capacity(2 * segments.len());
    for (segment, (start, end)) in segments.iter().zip(starts.iter().copied().zip(ends)) {
        shell.extend(faces(instances, segment, start, end));
    }
    instances.add(&format!("CLOSED_SHELL('',{})", list(&shell)))
}

/// Arcs of more than a half-turn split into equal pieces, so that a loop has at least two joints.
fn halved(segment: &Segment) -> Vec<Segment> {
    match *segment {
        Segment::Arc {
            start,
            end,
            center,
            radius_m,
            start_angle_rad,
            sweep_rad,
        } if sweep_rad.abs() > WHOLE_RAD => {
            let half = sweep_rad / 2.0;
            let middle = Segment::arc(center, radius_m, start_angle_rad, half).end();
            let piece = |start, end, start_angle_rad| Segment::Arc {
                start,
                end,
                center,
                radius_m,
                start_angle_rad,
                sweep_rad: half,
            };
            vec![
                piece(start, middle, start_angle_rad),
                piece(middle, end, start_angle_rad + half),
            ]
        }
        segment => vec![segment],
    }
}

fn point(instances: &mut Instances, at_mm: [f64; 3]) -> Id {
    instances.add(&format!("CARTESIAN_POINT('',{})", reals(&at_mm)))
}

fn direction(instances: &mut Instances, along: [f64; 3]) -> Id {
    instances.add(&format!("DIRECTION('',{})", reals(&along)))
}

/// An axis placement: location in mm, axis, reference direction.
pub fn placement(
    instances: &mut Instances,
    at_mm: [f64; 3],
    [axis, reference]: [[f64; 3]; 2],
) -> Id {
    let at = point(instances, at_mm);
    let [axis, reference] = [axis, reference].map(|d| direction(instances, d));
    instances.add(&format!(
        "AXIS2_PLACEMENT_3D('',#{at},#{axis},#{reference})"
    ))
}

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];

/// Position on a meridian, mm.
fn on_meridian_mm(at: Point, side: f64) -> [f64; 3] {
    [at.x_m * MM_PER_M, side * at.r_m * MM_PER_M, 0.0]
}

fn joint(instances: &mut Instances, at: Point) -> Joint {
    let vertex = |instances: &mut Instances, side| {
        let point = point(instances, on_meridian_mm(at, side));
        instances.add(&format!("VERTEX_POINT('',#{point})"))
    };
    if at.r_m == 0.0 {
        return Joint::Pole(vertex(instances, 1.0));
    }
    let vertices = SIDES.map(|side| vertex(instances, side));
    let placed = placement(instances, [at.x_m * MM_PER_M, 0.0, 0.0], [X, Y]);
    let circle = instances.put(
        "CIRCLE",
        &["''".to_owned(), of(placed), real(at.r_m * MM_PER_M)],
    );
    let [near, far] = vertices;
    let halves = [(near, far), (far, near)]
        .map(|(from, to)| instances.add(&format!("EDGE_CURVE('',#{from},#{to},#{circle},.T.)")));
    Joint::Circle { vertices, halves }
}

fn faces(instances: &mut Instances, segment: &Segment, start: Joint, end: Joint) -> [Id; 2] {
    let meridians = [0, 1].map(|side| {
        let curve = meridian(instances, segment, if side == 0 { 1.0 } else { -1.0 });
        let (from, to) = (start.vertex(side), end.vertex(side));
        instances.add(&format!("EDGE_CURVE('',#{from},#{to},#{curve},.T.)"))
    });
    let (surface, sense) = surface(instances, segment);
    let [near, far] = meridians;
    [(0, near, far), (1, far, near)].map(|(half, backwards, forwards)| {
        let mut round = Vec::with_capacity(4);
        let mut edge = |instances: &mut Instances, edge: Id, way: &str| {
            round.push(instances.add(&format!("ORIENTED_EDGE('',*,*,#{edge},{way})")));
        };
        if let Some(circle) = start.half(half) {
            edge(instances, circle, ".T.");
        }
        edge(instances, forwards, ".T.");
        if let Some(circle) = end.half(half) {
            edge(instances, circle, ".F.");
        }
        edge(instances, backwards, ".F.");
        let edge_loop = instances.add(&format!("EDGE_LOOP('',{})", list(&round)));
        let bound = instances.add(&format!("FACE_OUTER_BOUND('',#{edge_loop},.T.)"));
        instances.add(&format!("ADVANCED_FACE('',(#{bound}),#{surface},{sense})"))
    })
}

/// Curve of a segment on one meridian, in the direction of the segment.
fn meridian(instances: &mut Instances, segment: &Segment, side: f64) -> Id {
    match *segment {
        Segment::Line { start, end } => {
            let (dx, dr) = (end.x_m - start.x_m, end.r_m - start.r_m);
            let length = (dx * dx + dr * dr).sqrt();
            let at = point(instances, on_meridian_mm(start, side));
            let along = direction(instances, [dx / length, side * dr / length, 0.0]);
            let vector = instances.add(&format!("VECTOR('',#{along},1.)"));
            instances.add(&format!("LINE('',#{at},#{vector})"))
        }
        Segment::Arc {
            center,
            radius_m,
            sweep_rad,
            ..
        } => {
            // the arc turns from x towards r when the sweep is positive: about +z on the side of +y
            let axis = [0.0, 0.0, side * if sweep_rad < 0.0 { -1.0 } else { 1.0 }];
            let placed = placement(instances, on_meridian_mm(center, side), [axis, X]);
            instances.put(
                "CIRCLE",
                &["''".to_owned(), of(placed), real(radius_m * MM_PER_M)],
            )
        }
    }
}

/// Surface of a segment, and whether its own normal points outward.
fn surface(instances: &mut Instances, segment: &Segment) -> (Id, &'static str) {
    let sense = |same: bool| if same { ".T." } else { ".F." };
    match *segment {
        Segment::Line { start, end } => {
            let (dx, dr) = (end.x_m - start.x_m, end.r_m - start.r_m);
            if dx.abs() <= NOTHING_M {
                // outward is (−dr, dx)
                let axis = [if dr < 0.0 { 1.0 } else { -1.0 }, 0.0, 0.0];
                let placed = placement(instances, [start.x_m * MM_PER_M, 0.0, 0.0], [axis, Y]);
                return (instances.add(&format!("PLANE('',#{placed})")), ".T.");
            }
            let outwards = sense(dx > 0.0);
            if dr.abs() <= NOTHING_M {
                let placed = placement(instances, [start.x_m * MM_PER_M, 0.0, 0.0], [X, Y]);
                let radius = real(start.r_m * MM_PER_M);
                return (
                    instances.add(&format!("CYLINDRICAL_SURFACE('',#{placed},{radius})")),
                    outwards,
                );
            }
            // placed at the wide end, opening along its axis
            let widest = if dr > 0.0 { end } else { start };
            let opening = if (dr > 0.0) == (dx > 0.0) { 1.0 } else { -1.0 };
            let axis = [opening, 0.0, 0.0];
            let placed = placement(instances, [widest.x_m * MM_PER_M, 0.0, 0.0], [axis, Y]);
            let (radius, angle) = (real(widest.r_m * MM_PER_M), real(atan2(dr.abs(), dx.abs())));
            (
                instances.add(&format!("CONICAL_SURFACE('',#{placed},{radius},{angle})")),
                outwards,
            )
        }
        Segment::Arc {
            center,
            radius_m,
            start_angle_rad,
            sweep_rad,
            ..
        } => {
            let placed = placement(instances, [center.x_m * MM_PER_M, 0.0, 0.0], [X, Y]);
            let radius = real(radius_m * MM_PER_M);
            let outwards = sense(sweep_rad < 0.0);
            if center.r_m.abs() <= NOTHING_M {
                let sphere = format!("SPHERICAL_SURFACE('',#{placed},{radius})");
                return (instances.add(&sphere), outwards);
            }
            let major = real(center.r_m.abs() * MM_PER_M);
            if center.r_m >= radius_m {
                let torus = format!("TOROIDAL_SURFACE('',#{placed},{major},{radius})");
                return (instances.add(&torus), outwards);
            }
            // the circle crosses the axis: find which of its two parts is revolved
            let middle_r = center.r_m + radius_m * sin_cos(start_angle_rad + sweep_rad / 2.0).0;
            let outer = sense(center.r_m > 0.0 && middle_r > 0.0);
            let torus =
                format!("DEGENERATE_TOROIDAL_SURFACE('',#{placed},{major},{radius},{outer})");
            (instances.add(&torus), outwards)
        }
    }
}
