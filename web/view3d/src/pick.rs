//! Part under the pointer: the first surface on a line of sight.

use super::camera::Sight;
use super::lathe::Edge;
use super::scene::Part;
use std::f64::consts::TAU;

/// The first part on a line of sight, among those for which `shown` is true.
pub fn part(
    parts: &[Part],
    shown: impl Fn(usize) -> bool,
    sight: &Sight,
    cut_rad: f64,
) -> Option<usize> {
    let shown = parts.iter().enumerate().filter(|(place, _)| shown(*place));
    shown
        .filter_map(|(place, part)| Some((place, distance(part, sight, cut_rad)?)))
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(place, _)| place)
}

fn distance(part: &Part, sight: &Sight, cut_rad: f64) -> Option<f64> {
    let walls = part.curves.iter().flatten().flat_map(|edge| {
        let met = on_wall(edge, sight);
        met.into_iter().flatten()
    });
    let walls = walls.filter(|t| {
        let [across, _, ahead] = at(sight, *t);
        across.atan2(ahead).abs() >= 0.5 * cut_rad
    });
    let faces = [0.5, -0.5]
        .into_iter()
        .filter(|_| cut_rad > 0.0)
        .filter_map(|side| on_face(part, sight, side * cut_rad));
    walls
        .chain(faces)
        .filter(|t| *t > 0.0)
        .min_by(f64::total_cmp)
}

fn at(sight: &Sight, t: f64) -> [f64; 3] {
    [0, 1, 2].map(|i| sight.eye_m[i] + t * sight.direction[i])
}

/// Intersections of a line of sight with a revolved edge: a frustum, a cylinder or a ring.
fn on_wall(edge: &Edge, sight: &Sight) -> [Option<f64>; 2] {
    let (start, end) = (edge.start.at, edge.end.at);
    let (dx, dr) = (end.x_m - start.x_m, end.r_m - start.r_m);
    let ([ox, oy, oz], [vx, vy, vz]) = (sight.eye_m, sight.direction);
    if dx.abs() < 1e-9 * dr.abs() {
        let t = (start.x_m - oy) / vy;
        let [across, _, ahead] = at(sight, t);
        let part = (across.hypot(ahead) - start.r_m) / dr;
        return [(0.0..=1.0).contains(&part).then_some(t), None];
    }
    // X² + Z² = (r₀ + m (Y − x₀))² along the line
    let m = dr / dx;
    let (r, slope) = (start.r_m + m * (oy - start.x_m), m * vy);
    let a = vx * vx + vz * vz - slope * slope;
    let b = 2.0 * (ox * vx + oz * vz - r * slope);
    let c = ox * ox + oz * oz - r * r;
    let root = (b * b - 4.0 * a * c).max(0.0).sqrt();
    let is_met = b * b >= 4.0 * a * c;
    [-1.0, 1.0].map(|sign| {
        let t = (-b + sign * root) / (2.0 * a);
        let part = (at(sight, t)[1] - start.x_m) / dx;
        (is_met && (0.0..=1.0).contains(&part) && r + slope * t >= 0.0).then_some(t)
    })
}

/// Intersection of a line of sight with the cut face at an angle about the axis.
fn on_face(part: &Part, sight: &Sight, angle_rad: f64) -> Option<f64> {
    let (s, c) = angle_rad.rem_euclid(TAU).sin_cos();
    let ([ox, _, oz], [vx, _, vz]) = (sight.eye_m, sight.direction);
    let t = -(ox * c - oz * s) / (vx * c - vz * s);
    let [across, x, ahead] = at(sight, t);
    let r = across * s + ahead * c;
    let crossings = part.curves.iter().flatten().filter(|edge| {
        let (a, b) = (edge.start.at, edge.end.at);
        (a.r_m > r) != (b.r_m > r) && x < a.x_m + (b.x_m - a.x_m) * (r - a.r_m) / (b.r_m - a.r_m)
    });
    (r >= 0.0 && crossings.count() % 2 == 1).then_some(t)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lathe::edges;
    use msape::vehicle::profile::Profile;
    use msape::vehicle::segment::{Point, Segment};
    use std::f64::consts::PI;

    fn ball(radius_m: f64) -> Part {
        let half = Segment::arc(Point::default(), radius_m, PI, -PI);
        let profile = Profile {
            segments: vec![half],
        };
        Part {
            curves: vec![edges(&profile.closed(), 1e-4, |_, _| -1.0)],
            ..Part::default()
        }
    }

    fn from_ahead(across: f64, along: f64) -> Sight {
        Sight {
            eye_m: [across, along, 5.0],
            direction: [0.0, 0.0, -1.0],
        }
    }

    #[test]
    fn the_outer_ball_hides_the_inner_one_until_it_is_cut_or_left_out() {
        let parts = [ball(1.0), ball(0.5)];
        let center = from_ahead(0.01, 0.02);
        assert_eq!(part(&parts, |_| true, &center, 0.0), Some(0));
        assert_eq!(part(&parts, |place| place == 1, &center, 0.0), Some(1));
        // with one half cut away, the face is where the sphere was
        assert_eq!(part(&[ball(1.0)], |_| true, &center, PI), Some(0));
        assert_eq!(part(&parts, |_| true, &from_ahead(0.9, 0.0), PI), Some(0));
        assert_eq!(part(&parts, |_| true, &from_ahead(1.1, 0.0), PI), None);
    }

    #[test]
    fn distances_are_those_of_a_ball_and_of_its_face() {
        let whole = distance(&ball(1.0), &from_ahead(0.0, 0.6), 0.0).unwrap();
        // z = √(1 − 0.36) = 0.8, seen from 5; chords lie slightly inside
        assert!((whole - 4.2).abs() < 3e-4, "{whole}");
        let cut = distance(&ball(1.0), &from_ahead(0.1, 0.6), PI).unwrap();
        assert!((cut - 5.0).abs() < 1e-9, "{cut}");
    }
}
