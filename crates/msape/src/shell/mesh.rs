//! Elements along meridians: lines and arcs cut into equal pieces, joined where meridians meet.
//!
//! ```text
//! pieces = ⌈length / target⌉      target = (ρ h)^½      about the length over which bending at an edge dies away
//! ```
//!
//! with lengths in m. Where two walls meet at an angle they share displacements and the rotation about the circle of the
//! joint, and each keeps its own rotation about the meridian: along the circle that one follows from the displacements.
//!
//! # Valid
//! Meridians that start or end on the axis, or at a joint, or free.
//!
//! # References
//! - \[zienkiewicz-1977\] branched shells of revolution.

use super::element::station;
use crate::vehicle::segment::{Point, Segment};
use numerics::math::sin_cos;

/// An element: ends and middle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Element {
    /// Nodes: first, middle, last.
    pub nodes: [usize; 3],
    /// Numbers of the rotation φ at these nodes: two walls that meet at an angle have each their own.
    pub twists: [usize; 3],
    /// Number of its wall.
    pub wall: usize,
}

/// Nodes and elements.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Nodes.
    pub nodes: Vec<Point>,
    /// Node of each rotation φ.
    pub twists: Vec<usize>,
    /// Elements.
    pub elements: Vec<Element>,
}

/// A meridian to be cut into elements.
#[derive(Clone, Copy, Debug)]
pub struct Meridian<'a> {
    /// Lines and arcs, each starting where the one before it ends.
    pub segments: &'a [Segment],
    /// Number of its wall.
    pub wall: usize,
    /// Longest element, m.
    pub target_m: f64,
    /// Node with which it starts; `None` makes one.
    pub first: Option<usize>,
    /// Node with which it ends; `None` makes one.
    pub last: Option<usize>,
}

/// Most elements of one segment.
const MOST_PIECES: f64 = 400.0;
/// Segments shorter than this are left out, m.
const SHORTEST_M: f64 = 1e-7;
/// Directions that differ by more than this are an angle, rad.
const ANGLE_RAD: f64 = 0.02;

/// Length of a segment, m.
pub fn length_m(segment: &Segment) -> f64 {
    match *segment {
        Segment::Line { start, end } => {
            let (dx, dr) = (end.x_m - start.x_m, end.r_m - start.r_m);
            (dx * dx + dr * dr).sqrt()
        }
        Segment::Arc {
            radius_m,
            sweep_rad,
            ..
        } => radius_m * sweep_rad.abs(),
    }
}

/// The point at a part, 0 to 1, of a segment.
pub fn point_at(segment: &Segment, part: f64) -> Point {
    if part <= 0.0 {
        return segment.start();
    }
    if part >= 1.0 {
        return segment.end();
    }
    match *segment {
        Segment::Line { start, end } => Point {
            x_m: start.x_m + part * (end.x_m - start.x_m),
            r_m: start.r_m + part * (end.r_m - start.r_m),
        },
        Segment::Arc {
            center,
            radius_m,
            start_angle_rad,
            sweep_rad,
            ..
        } => {
            let (s, c) = sin_cos(start_angle_rad + part * sweep_rad);
            Point {
                x_m: center.x_m + radius_m * c,
                r_m: center.r_m + radius_m * s,
            }
        }
    }
}

impl Mesh {
    /// Cuts a meridian into elements; returns the nodes at its ends, `None` when it has no length.
    pub fn add(&mut self, meridian: &Meridian) -> Option<[usize; 2]> {
        let long: Vec<&Segment> = meridian
            .segments
            .iter()
            .filter(|segment| length_m(segment) > SHORTEST_M)
            .collect();
        let start = long.first()?.start();
        let first = match meridian.first {
            Some(node) => node,
            None => self.node(start),
        };
        let mut at = first;
        let mut twist = self.twist(at);
        for (number, segment) in long.iter().enumerate() {
            let pieces = (length_m(segment) / meridian.target_m)
                .ceil()
                .clamp(1.0, MOST_PIECES) as usize;
            for piece in 0..pieces {
                let part = |halves: usize| halves as f64 / (2 * pieces) as f64;
                let middle = self.node(point_at(segment, part(2 * piece + 1)));
                let ends_here = number + 1 == long.len() && piece + 1 == pieces;
                let end = match meridian.last.filter(|_| ends_here) {
                    Some(node) => node,
                    None => self.node(point_at(segment, part(2 * piece + 2))),
                };
                let nodes = [at, middle, end];
                if number + piece > 0 && self.turns(nodes) {
                    twist = self.twist(at);
                }
                let twists = [twist, self.twist(middle), self.twist(end)];
                self.elements.push(Element {
                    nodes,
                    twists,
                    wall: meridian.wall,
                });
                (at, twist) = (end, twists[2]);
            }
        }
        Some([first, at])
    }

    fn node(&mut self, point: Point) -> usize {
        self.nodes.push(point);
        self.nodes.len() - 1
    }

    fn twist(&mut self, node: usize) -> usize {
        self.twists.push(node);
        self.twists.len() - 1
    }

    /// Whether an element that is about to be added starts in another direction than the last one of its meridian ended.
    fn turns(&self, nodes: [usize; 3]) -> bool {
        let Some(before) = self.elements.last().filter(|e| e.nodes[2] == nodes[0]) else {
            return false;
        };
        let direction =
            |nodes: [usize; 3], xi| station(&nodes.map(|node| self.point(node)), xi).direction;
        let ([a, b], [c, d]) = (direction(before.nodes, 1.0), direction(nodes, -1.0));
        (a * d - b * c).abs() > ANGLE_RAD || a * c + b * d < 0.0
    }

    /// Position of a node; the origin for one that is not there.
    #[inline]
    pub fn point(&self, node: usize) -> Point {
        self.nodes.get(node).copied().unwrap_or_default()
    }

    /// The three points of an element.
    #[inline]
    pub fn points(&self, element: &Element) -> [Point; 3] {
        element.nodes.map(|node| self.point(node))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(from: [f64; 2], to: [f64; 2]) -> Segment {
        let point = |[x_m, r_m]: [f64; 2]| Point { x_m, r_m };
        Segment::Line {
            start: point(from),
            end: point(to),
        }
    }

    #[test]
    fn angle_of_two_lines_has_one_node_and_two_twists() {
        let mut mesh = Mesh::default();
        let segments = [line([0.0, 1.0], [1.0, 1.0]), line([1.0, 1.0], [1.0, 2.0])];
        let ends = mesh.add(&Meridian {
            segments: &segments,
            wall: 0,
            target_m: 0.5,
            first: None,
            last: None,
        });
        // two elements each: nine nodes, and one more twist at the angle
        assert_eq!((mesh.nodes.len(), mesh.twists.len()), (9, 10));
        assert_eq!(ends, Some([0, 8]));
        assert_eq!(mesh.elements.len(), 4);
    }

    #[test]
    fn branch_starts_at_the_node_it_is_given() {
        let mut mesh = Mesh::default();
        let trunk = [line([0.0, 1.0], [1.0, 1.0])];
        let meridian = |segments, first| Meridian {
            segments,
            wall: 0,
            target_m: 3.0,
            first,
            last: None,
        };
        let [_, joint] = mesh.add(&meridian(&trunk, None)).unwrap();
        let branch = [line([1.0, 1.0], [2.0, 3.0])];
        assert_eq!(mesh.add(&meridian(&branch, Some(joint))), Some([2, 4]));
        assert_eq!((mesh.nodes.len(), mesh.twists.len()), (5, 6));
        assert_eq!(mesh.add(&meridian(&[], None)), None);
    }
}
