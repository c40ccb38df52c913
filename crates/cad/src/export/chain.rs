//! A profile prepared for export: segments on the axis and those shorter than a nanometer are removed, adjacent pieces
//! of the same line or circle are merged, and parts where the profile doubles back over itself are cut off. The result
//! is a list of chains, each of which makes one shell when revolved about the axis.
//!
//! ```text
//! outwards = (−dr, dx) / ds
//! ```
//!
//! with x along the axis and r from it in m. Closed profiles are oriented so that the inside is on the right.

use msape::vehicle::profile::Profile;
use msape::vehicle::segment::{Point, Segment};
use numerics::math::hypot;

/// Lengths up to this count as zero, m.
pub const NOTHING_M: f64 = 1e-9;

/// Topology of a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends {
    /// Both ends on the axis.
    OnAxis,
    /// Closed off the axis: the end meets the start.
    Loop,
    /// Open: gives a surface, not a body.
    Open,
}

/// Segments off the axis, each starting exactly at the end of the previous one.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    /// Segments in order.
    pub segments: Vec<Segment>,
    /// Topology.
    pub ends: Ends,
}

/// Chains of a profile. Where a closed profile reaches the axis in several places, each chain is a shell: the one with
/// the largest volume is the outer shell, the others are voids.
pub fn chains(profile: &Profile) -> Vec<Chain> {
    let mut segments = joined(profile);
    let (Some(first), Some(last)) = (segments.first(), segments.last()) else {
        return Vec::new();
    };
    let (start, closed) = (first.start(), near(first.start(), last.end()));
    let swept: f64 = segments.iter().map(|s| s.integrals().r_dx).sum();
    let whole = closed || (start.r_m == 0.0 && last.end().r_m == 0.0);
    if closed && let Some(last) = segments.last_mut() {
        *last = between(last, last.start(), start);
    }
    // ∫ r dx is positive where the inside is on the right
    if whole && swept < 0.0 {
        segments = segments.iter().rev().map(Segment::reversed).collect();
    }
    let on_axis = |s: &Segment| {
        matches!(s, Segment::Line { .. }) && s.start().r_m == 0.0 && s.end().r_m == 0.0
    };
    // start at the beginning of a chain: after a piece of the axis, or at a point on it
    let begins = (0..segments.len()).find(|&i| {
        segments
            .get(i)
            .is_some_and(|s| s.start().r_m == 0.0 && !on_axis(s))
    });
    if closed && let Some(at) = begins {
        segments.rotate_left(at);
    }
    let mut list: Vec<Vec<Segment>> = Vec::new();
    let mut fresh = true;
    for segment in segments {
        if on_axis(&segment) {
            fresh = true;
            continue;
        }
        match list.last_mut() {
            Some(chain) if !fresh => chain.push(segment),
            _ => list.push(vec![segment]),
        }
        fresh = segment.end().r_m == 0.0;
    }
    list.into_iter().filter_map(chain).collect()
}

fn chain(segments: Vec<Segment>) -> Option<Chain> {
    let (start, end) = (segments.first()?.start(), segments.last()?.end());
    let ends = if start.r_m == 0.0 && end.r_m == 0.0 {
        Ends::OnAxis
    } else if near(start, end) {
        Ends::Loop
    } else {
        Ends::Open
    };
    let mut merged: Vec<Segment> = Vec::with_capacity(segments.len());
    for segment in segments {
        add(&mut merged, segment);
    }
    if ends == Ends::Loop {
        corner_first(&mut merged);
    }
    (!merged.is_empty()).then_some(Chain {
        segments: merged,
        ends,
    })
}

/// Appends a segment, merged with the last one where both lie on the same line or circle.
fn add(list: &mut Vec<Segment>, mut segment: Segment) {
    while let Some(both) = list.last().and_then(|last| together(last, &segment)) {
        list.pop();
        if length_m(&both) <= NOTHING_M {
            return;
        }
        segment = both;
    }
    // removing a doubled-back pair can leave a gap within the tolerance
    if let Some(last) = list.last() {
        segment = between(&segment, last.end(), segment.end());
    }
    list.push(segment);
}

/// Rotates a loop to start at a corner, if it has one.
fn corner_first(segments: &mut Vec<Segment>) {
    while segments.len() > 1
        && let (Some(first), Some(last)) = (segments.first(), segments.last())
        && together(last, first).is_some()
    {
        let first = segments.remove(0);
        add(segments, first);
    }
}

/// Segments of nonzero length, each start moved to the end of the previous segment.
fn joined(profile: &Profile) -> Vec<Segment> {
    let mut list: Vec<Segment> = Vec::with_capacity(profile.segments.len());
    let snapped = |p: Point| {
        if p.r_m.abs() <= NOTHING_M {
            Point::on_axis(p.x_m)
        } else {
            p
        }
    };
    for segment in &profile.segments {
        if length_m(segment) <= NOTHING_M {
            continue;
        }
        let (start, end) = (snapped(segment.start()), snapped(segment.end()));
        match list.last().map(Segment::end) {
            Some(at) if near(at, start) => list.push(between(segment, at, end)),
            Some(at) => {
                list.push(Segment::Line {
                    start: at,
                    end: start,
                });
                list.push(between(segment, start, end));
            }
            None => list.push(between(segment, start, end)),
        }
    }
    list
}

/// Length of a segment, m.
pub fn length_m(segment: &Segment) -> f64 {
    match *segment {
        Segment::Line { start, end } => hypot(end.x_m - start.x_m, end.r_m - start.r_m),
        Segment::Arc {
            radius_m,
            sweep_rad,
            ..
        } => radius_m * sweep_rad.abs(),
    }
}

fn near(a: Point, b: Point) -> bool {
    (a.x_m - b.x_m).abs() <= NOTHING_M && (a.r_m - b.r_m).abs() <= NOTHING_M
}

/// The segment with its ends moved to the given points, which differ by no more than the tolerance.
fn between(segment: &Segment, start: Point, end: Point) -> Segment {
    match *segment {
        Segment::Line { .. } => Segment::Line { start, end },
        Segment::Arc {
            center,
            radius_m,
            start_angle_rad,
            sweep_rad,
            ..
        } => Segment::Arc {
            start,
            end,
            center,
            radius_m,
            start_angle_rad,
            sweep_rad,
        },
    }
}

/// Two adjacent segments merged into one if they lie on the same line or circle; a segment that doubles back shortens
/// the other.
fn together(a: &Segment, b: &Segment) -> Option<Segment> {
    match (*a, *b) {
        (Segment::Line { start, end }, Segment::Line { end: far, .. }) => {
            let (ux, ur) = (end.x_m - start.x_m, end.r_m - start.r_m);
            let (vx, vr) = (far.x_m - end.x_m, far.r_m - end.r_m);
            let across = (ux * vr - ur * vx).abs();
            let longest = hypot(ux, ur).max(hypot(vx, vr));
            (across <= NOTHING_M * longest).then_some(Segment::Line { start, end: far })
        }
        (
            Segment::Arc {
                start,
                center,
                radius_m,
                start_angle_rad,
                sweep_rad,
                ..
            },
            Segment::Arc {
                end,
                center: other,
                radius_m: radius,
                sweep_rad: more,
                ..
            },
        ) => {
            let same = near(center, other) && (radius_m - radius).abs() <= NOTHING_M;
            let turn = sweep_rad + more;
            let full = 2.0 * numerics::math::PI;
            (same && turn.abs() < full).then_some(Segment::Arc {
                start,
                end,
                center,
                radius_m,
                start_angle_rad,
                sweep_rad: turn,
            })
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use numerics::math::PI;

    fn arc(radius_m: f64, from: f64, sweep: f64) -> Profile {
        Profile {
            segments: vec![Segment::arc(Point::on_axis(0.0), radius_m, from, sweep)],
        }
    }

    #[test]
    fn a_hollow_ball_is_two_chains() {
        let hollow = arc(2.0, PI, -PI).then(&arc(1.0, 0.0, PI)).closed();
        for profile in [hollow.clone(), hollow.reversed()] {
            let list = chains(&profile);
            assert_eq!(list.len(), 2);
            assert!(
                list.iter()
                    .all(|c| c.ends == Ends::OnAxis && c.segments.len() == 1)
            );
            // the outer chain runs aft, the inner one forward
            let ends = |i: usize| {
                (
                    list[i].segments[0].start().x_m,
                    list[i].segments[0].end().x_m,
                )
            };
            let mut both = [ends(0), ends(1)];
            both.sort_by(|a, b| a.0.total_cmp(&b.0));
            assert_eq!(both, [(-2.0, 2.0), (1.0, -1.0)]);
        }
    }

    #[test]
    fn a_square_off_the_axis_is_a_loop_of_four() {
        let p = |x_m, r_m| Point { x_m, r_m };
        let line = |start, end| Segment::Line { start, end };
        // started in the middle of a side, with a step within the tolerance at a corner
        let corner = p(1.0 + 1e-13, 2.0);
        let square = Profile {
            segments: vec![line(p(0.5, 2.0), p(1.0, 2.0)), line(p(1.0, 2.0), corner)],
        }
        .line_to(p(1.0, 1.0))
        .line_to(p(0.0, 1.0))
        .line_to(p(0.0, 2.0))
        .closed();
        let list = chains(&square);
        assert_eq!(
            (list.len(), list[0].ends, list[0].segments.len()),
            (1, Ends::Loop, 4)
        );
        for pair in list[0].segments.windows(2) {
            assert_eq!(pair[0].end(), pair[1].start());
        }
        assert_eq!(list[0].segments[0].start(), list[0].segments[3].end());
        assert!(
            (Profile {
                segments: list[0].segments.clone()
            }
            .solid()
            .volume_m3
                - 3.0 * PI)
                .abs()
                < 1e-12
        );
    }

    #[test]
    fn a_spike_is_cut_off() {
        let p = |x_m, r_m| Point { x_m, r_m };
        let start = Profile {
            segments: vec![Segment::Line {
                start: p(0.0, 1.0),
                end: p(0.0, 2.0),
            }],
        };
        // a spike out to x = 3 and back to x = 1: once within the loop, once at its start
        let square = start
            .line_to(p(3.0, 2.0))
            .line_to(p(1.0, 2.0 + 1e-12))
            .line_to(p(1.0, 1.0))
            .line_to(p(-0.5, 1.0))
            .closed();
        let list = chains(&square);
        let loops: Vec<_> = list.iter().map(|c| (c.ends, c.segments.len())).collect();
        assert_eq!(loops, [(Ends::Loop, 4)]);
        for (a, b) in list[0]
            .segments
            .iter()
            .zip(list[0].segments.iter().cycle().skip(1))
        {
            assert_eq!(a.end(), b.start());
        }
    }

    #[test]
    fn pieces_of_one_circle_are_one_arc() {
        let halves = arc(1.0, PI, -2.0)
            .then(&arc(1.0, PI - 2.0, 2.0 - PI))
            .closed();
        let list = chains(&halves);
        assert_eq!(
            (list.len(), list[0].segments.len(), list[0].ends),
            (1, 1, Ends::OnAxis)
        );
    }
}
