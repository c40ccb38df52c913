//! Loose pieces of a drawing joined into one chain from axis to axis.
//!
//! ```text
//! ends closer than 10⁻⁵ of the drawing's size are joined
//! ```
//!
//! Ends are looked up in a grid with cells as wide as that distance, so that the work grows with the number of pieces.
//! Duplicate pieces count once.
//!
//! # Valid
//! One chain whose two free ends are on the axis. Anything else is a fault that names the place.
//!
//! # References
//! - Own convention.

use super::dxf::group::Place;
use super::{ImportFault, MOST_FAULTS};
use msape::units::told;
use msape::vehicle::body::check::At;
use msape::vehicle::crossing::distance_m;
use msape::vehicle::segment::Point;

/// Largest distance of ends that are joined, as a fraction of the drawing's size.
pub const TOLERANCE: f64 = 1e-5;
/// Largest number of points of a drawing, including those of arcs that replace smooth curves.
pub const MOST_POINTS: usize = 100_000;
/// Number of partners searched for at an end: two are already a fault.
const MOST_PARTNERS: usize = 8;

/// Connected lines and arcs.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    /// x and r in m, and the bulge of the segment to the next point.
    pub points: Vec<[f64; 3]>,
    /// Place in the file.
    pub place: Place,
}

impl Path {
    /// The path in the opposite direction.
    pub fn reversed(&self) -> Self {
        let bulges = self.points.iter().rev().skip(1).map(|point| -point[2]);
        let points = self.points.iter().rev().zip(bulges.chain([0.0]));
        Self {
            points: points.map(|([x, r, _], bulge)| [*x, *r, bulge]).collect(),
            place: self.place,
        }
    }

    /// Both end points.
    fn ends(&self) -> [Point; 2] {
        [self.points.first(), self.points.last()].map(|point| point.map_or(Point::default(), at))
    }
}

fn at(point: &[f64; 3]) -> Point {
    Point {
        x_m: point[0],
        r_m: point[1],
    }
}

/// End of a path: position, index of the path, 0 for the first end and 1 for the second.
#[derive(Clone, Copy, Debug, PartialEq)]
struct End {
    at: Point,
    path: usize,
    second: usize,
}

/// Ends of all paths, by grid cell.
struct Ends {
    sorted: Vec<([f64; 2], End)>,
    tolerance_m: f64,
}

impl Ends {
    fn new(paths: &[Path], tolerance_m: f64) -> Self {
        let mut sorted: Vec<([f64; 2], End)> = paths
            .iter()
            .enumerate()
            .flat_map(|(path, p)| {
                let ends = p.ends().into_iter().enumerate();
                ends.map(move |(second, at)| End { at, path, second })
            })
            .map(|end| (cell(end.at, tolerance_m), end))
            .collect();
        sorted.sort_unstable_by(|a, b| {
            let [x, y] = [0, 1].map(|i| a.0[i].total_cmp(&b.0[i]));
            // within a cell in the order of the paths
            let ends = (a.1.path, a.1.second).cmp(&(b.1.path, b.1.second));
            x.then(y).then(ends)
        });
        Self {
            sorted,
            tolerance_m,
        }
    }

    /// Other ends at the position of this one, up to [`MOST_PARTNERS`].
    fn partners(&self, end: &End) -> Vec<End> {
        let [x, r] = cell(end.at, self.tolerance_m);
        let columns = [x - 1.0, x, x + 1.0].into_iter().flat_map(|x| {
            let before = |key: &[f64; 2]| key[0] < x || (key[0] == x && key[1] < r - 1.0);
            let from = self.sorted.partition_point(|(key, _)| before(key));
            let rest = self.sorted.get(from..).unwrap_or(&[]).iter();
            rest.take_while(move |(key, _)| key[0] == x && key[1] <= r + 1.0)
        });
        columns
            .map(|(_, other)| *other)
            .filter(|other| (other.path, other.second) != (end.path, end.second))
            .filter(|other| distance_m(other.at, end.at) <= self.tolerance_m)
            .take(MOST_PARTNERS)
            .collect()
    }
}

/// Column and row of the grid, whole numbers.
fn cell(at: Point, width_m: f64) -> [f64; 2] {
    // adding zero turns −0 into 0
    [at.x_m, at.r_m].map(|length| (length / width_m).floor() + 0.0)
}

/// Paths without duplicates.
fn once(paths: Vec<Path>, tolerance_m: f64) -> Vec<Path> {
    let ends = Ends::new(&paths, tolerance_m);
    let mut again = vec![false; paths.len()];
    for (i, path) in paths.iter().enumerate() {
        let [start, _] = path.ends();
        let end = End {
            at: start,
            path: i,
            second: 0,
        };
        for other in ends.partners(&end) {
            let Some(drawn) = paths.get(other.path).filter(|_| other.path > i) else {
                continue;
            };
            let alike = match other.second {
                0 => same(path, drawn, tolerance_m),
                _ => same(path, &drawn.reversed(), tolerance_m),
            };
            if let (true, Some(slot)) = (alike, again.get_mut(other.path)) {
                *slot = true;
            }
        }
    }
    let marked = paths.into_iter().zip(again);
    marked
        .filter(|(_, again)| !again)
        .map(|(path, _)| path)
        .collect()
}

fn same(one: &Path, other: &Path, tolerance_m: f64) -> bool {
    one.points.len() == other.points.len()
        && one.points.iter().zip(&other.points).all(|(a, b)| {
            distance_m(at(a), at(b)) <= tolerance_m && (a[2] - b[2]).abs() <= TOLERANCE
        })
}

/// The path from axis to axis that the pieces form, nose first, or the reasons why they form none.
pub fn joined(paths: Vec<Path>, tolerance_m: f64) -> Result<Path, Vec<ImportFault>> {
    let on_axis = |p: Point| p.r_m.abs() <= tolerance_m;
    let paths = once(paths, tolerance_m);
    let ends = Ends::new(&paths, tolerance_m);
    let (mut loose, mut faults) = (Vec::new(), Vec::new());
    for (_, end) in &ends.sorted {
        let partners = ends.partners(end);
        match partners.len() {
            0 => loose.push(*end),
            1 => {}
            others if faults.len() < MOST_FAULTS && first_of(end, &partners) => {
                let more = if others == MOST_PARTNERS {
                    " or more"
                } else {
                    ""
                };
                faults.push(ImportFault::Chain(format!(
                    "{} pieces{more} meet at {}, must be two",
                    others + 1,
                    At(end.at)
                )));
            }
            _ => {}
        }
    }
    let stray = loose.iter().filter(|end| !on_axis(end.at));
    for end in stray.take(MOST_FAULTS) {
        faults.push(gap(end, &loose, &paths, tolerance_m));
    }
    faults.truncate(MOST_FAULTS);
    loose.retain(|end| on_axis(end.at));
    if faults.is_empty() && loose.len() != 2 {
        faults.push(ImportFault::Chain(format!(
            "the pieces make {} ends on the axis (y = 0), must be two: nose and aft end",
            loose.len()
        )));
    }
    let first = loose.iter().min_by(|a, b| a.at.x_m.total_cmp(&b.at.x_m));
    match first {
        Some(first) if faults.is_empty() => walk(*first, &ends, &paths),
        _ => Err(faults),
    }
}

fn first_of(end: &End, partners: &[End]) -> bool {
    let before = |p: &End| (p.path, p.second) > (end.path, end.second);
    partners.iter().all(before)
}

fn gap(end: &End, loose: &[End], paths: &[Path], tolerance_m: f64) -> ImportFault {
    let place = paths
        .get(end.path)
        .map_or(Place::Line(0), |path| path.place);
    let nearest = loose
        .iter()
        .filter(|other| (other.path, other.second) != (end.path, end.second))
        .min_by(|a, b| distance_m(a.at, end.at).total_cmp(&distance_m(b.at, end.at)));
    let message = match nearest {
        Some(other) => format!(
            "{place}: the piece ends at {}, off the axis; the nearest other loose end is {} m away at {}, ends closer than {tolerance_m:.1e} m are joined",
            At(end.at),
            told((distance_m(other.at, end.at) * 1e6).round() / 1e6),
            At(other.at)
        ),
        None => format!("{place}: the piece ends at {}, off the axis", At(end.at)),
    };
    ImportFault::Chain(message)
}

fn walk(first: End, ends: &Ends, paths: &[Path]) -> Result<Path, Vec<ImportFault>> {
    let mut points: Vec<[f64; 3]> = Vec::new();
    let mut place = Place::Line(0);
    let mut used = vec![false; paths.len()];
    let mut end = first;
    while let Some(path) = paths.get(end.path).filter(|_| used.contains(&false)) {
        if let Some(used) = used.get_mut(end.path) {
            *used = true;
        }
        place = path.place;
        let path = match end.second {
            0 => path.clone(),
            _ => path.reversed(),
        };
        // where paths meet within the tolerance, the first one's end is kept
        let mut new = path.points.into_iter();
        match (points.last_mut(), new.next()) {
            (Some(last), Some(start)) => last[2] = start[2],
            (None, Some(start)) => points.push(start),
            _ => {}
        }
        points.extend(new);
        let Some(at) = points.last().map(at) else {
            break;
        };
        let far = End {
            at,
            path: end.path,
            second: 1 - end.second,
        };
        match ends.partners(&far).first() {
            Some(next) => end = *next,
            None => break,
        }
    }
    let mut loose = paths.iter().zip(&used).filter(|(_, used)| !**used);
    if let Some((path, _)) = loose.next() {
        let message = format!(
            "{}: {} of {} pieces are not connected with the chain from axis to axis, this one the first; leave in the drawing what belongs to the outline",
            path.place,
            loose.count() + 1,
            paths.len()
        );
        return Err(vec![ImportFault::Chain(message)]);
    }
    if let Some(first) = points.first_mut() {
        first[1] = 0.0;
    }
    if let Some(last) = points.last_mut() {
        last[1] = 0.0;
    }
    Ok(Path { points, place })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(x0: f64, r0: f64, x1: f64, r1: f64) -> Path {
        Path {
            points: vec![[x0, r0, 0.0], [x1, r1, 0.0]],
            place: Place::Line(7),
        }
    }

    #[test]
    fn loose_pieces_are_put_in_order_and_turned() {
        let paths = vec![
            line(2.0, 0.0, 2.0, 1.0),
            line(1.0, 1.000_001, 2.0, 1.0),
            line(1.0, 1.0, 0.0, 0.0),
            line(2.0, 1.0, 1.0, 1.0), // a duplicate in the opposite direction
        ];
        let path = joined(paths, 2e-5).unwrap();
        let x: Vec<f64> = path.points.iter().map(|point| point[0]).collect();
        assert_eq!(x, [0.0, 1.0, 2.0, 2.0]);
        assert_eq!(path.points[1][1], 1.0);
    }

    #[test]
    fn bulges_change_their_sign_with_the_direction() {
        let arc = Path {
            points: vec![[2.0, 0.0, 1.0], [0.0, 0.0, 0.0]],
            place: Place::Line(1),
        };
        let path = joined(vec![arc], 2e-5).unwrap();
        assert_eq!(path.points, [[0.0, 0.0, -1.0], [2.0, 0.0, 0.0]]);
    }

    #[test]
    fn gaps_branches_and_islands_say_where() {
        let said = |paths| joined(paths, 2e-5).unwrap_err()[0].to_string();
        let gap = said(vec![line(0.0, 0.0, 1.0, 1.0), line(1.0, 0.9, 1.0, 0.0)]);
        assert!(
            gap.contains("line 7") && gap.contains("0.1 m away"),
            "{gap}"
        );
        let branch = said(vec![
            line(0.0, 0.0, 1.0, 1.0),
            line(1.0, 1.0, 1.0, 0.0),
            line(1.0, 1.0, 2.0, 0.0),
        ]);
        assert!(
            branch.contains("3 pieces meet at x = 1 m, r = 1 m"),
            "{branch}"
        );
        let island = said(vec![
            line(0.0, 0.0, 1.0, 1.0),
            line(1.0, 1.0, 2.0, 0.0),
            line(5.0, 1.0, 6.0, 1.0),
            line(6.0, 1.0, 6.0, 2.0),
            line(6.0, 2.0, 5.0, 1.0),
        ]);
        assert!(island.contains("line 7: 3 of 5 pieces"), "{island}");
    }

    #[test]
    fn ends_are_found_across_the_borders_of_cells() {
        let near = [[-1e-6, 0.0], [0.0, -1e-6], [1e-6, 1e-6]];
        for [dx, dr] in near {
            let paths = vec![line(-1.0, 0.0, dx, 1.0 + dr), line(0.0, 1.0, 1.0, 0.0)];
            assert_eq!(joined(paths, 1e-5).unwrap().points.len(), 3);
        }
    }
}
