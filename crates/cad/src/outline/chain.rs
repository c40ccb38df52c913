//! Loose pieces of a drawing put into one chain from axis to axis.
//!
//! ```text
//! ends closer than 10⁻⁵ of the drawing's size are joined; pieces along the axis are left out
//! ```
//!
//! # Valid
//! One chain whose two loose ends are on the axis. Anything else is a fault that says where.
//!
//! # References
//! - Own convention.

use super::{ImportFault, MOST_FAULTS};
use msape::vehicle::body::check::At;
use msape::vehicle::crossing::distance_m;
use msape::vehicle::segment::Point;

/// Ends closer than this part of the drawing's size are joined.
pub const TOLERANCE: f64 = 1e-5;

/// A line or an arc of a drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// Where it starts.
    pub start: Point,
    /// Where it ends.
    pub end: Point,
    /// Tangent of a quarter of its angle.
    pub bulge: f64,
    /// Line of the file at which it stands.
    pub line: u64,
}

impl Piece {
    fn reversed(&self) -> Self {
        Self {
            start: self.end,
            end: self.start,
            bulge: -self.bulge,
            line: self.line,
        }
    }
}

/// An end of a piece: where it is, its piece, whether it is the second of it.
#[derive(Clone, Copy)]
struct End {
    at: Point,
    piece: usize,
    second: usize,
}

/// The ends of all pieces, by x.
struct Ends {
    sorted: Vec<End>,
    tolerance_m: f64,
}

impl Ends {
    fn new(pieces: &[Piece], tolerance_m: f64) -> Self {
        let mut sorted: Vec<End> = pieces
            .iter()
            .enumerate()
            .flat_map(|(piece, p)| {
                [p.start, p.end]
                    .into_iter()
                    .enumerate()
                    .map(move |(second, at)| End { at, piece, second })
            })
            .collect();
        sorted.sort_by(|a, b| a.at.x_m.total_cmp(&b.at.x_m));
        Self {
            sorted,
            tolerance_m,
        }
    }

    /// Other ends at the place of this one.
    fn partners(&self, end: &End) -> Vec<End> {
        let (low, high) = (end.at.x_m - self.tolerance_m, end.at.x_m + self.tolerance_m);
        let from = self.sorted.partition_point(|other| other.at.x_m < low);
        self.sorted
            .iter()
            .skip(from)
            .take_while(|other| other.at.x_m <= high)
            .filter(|other| (other.piece, other.second) != (end.piece, end.second))
            .filter(|other| distance_m(other.at, end.at) <= self.tolerance_m)
            .copied()
            .collect()
    }
}

/// Rows of x, r and bulge of the chain that the pieces make, or what keeps them from making one.
pub fn rows(pieces: Vec<Piece>) -> Result<Vec<Vec<f64>>, Vec<ImportFault>> {
    let size = pieces
        .iter()
        .flat_map(|p| [p.start, p.end])
        .fold([f64::INFINITY, f64::NEG_INFINITY, 0.0], |[a, b, r], p| {
            [a.min(p.x_m), b.max(p.x_m), p.r_m.abs().max(r)]
        });
    let tolerance_m = TOLERANCE * (size[1] - size[0]).max(size[2]);
    let on_axis = |p: Point| p.r_m.abs() <= tolerance_m;
    // the axis itself, drawn to close the section, and what has no length
    let pieces: Vec<Piece> = pieces
        .into_iter()
        .filter(|p| !(p.bulge == 0.0 && on_axis(p.start) && on_axis(p.end)))
        .filter(|p| distance_m(p.start, p.end) > tolerance_m)
        .collect();
    if pieces.is_empty() {
        return Err(vec![ImportFault::Empty("line or arc off the axis")]);
    }
    let ends = Ends::new(&pieces, tolerance_m);
    let (mut loose, mut faults) = (Vec::new(), Vec::new());
    for end in &ends.sorted {
        let partners = ends.partners(end);
        match partners.len() {
            0 => loose.push(*end),
            1 => {}
            others
                if partners
                    .iter()
                    .all(|p| (p.piece, p.second) > (end.piece, end.second)) =>
            {
                faults.push(ImportFault::Chain(format!(
                    "{} pieces meet at {}, must be two",
                    others + 1,
                    At(end.at)
                )));
            }
            _ => {}
        }
    }
    let stray: Vec<&End> = loose.iter().filter(|end| !on_axis(end.at)).collect();
    for end in &stray {
        faults.push(gap(end, &loose, &pieces, tolerance_m));
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
        Some(first) if faults.is_empty() => walk(*first, &ends, &pieces),
        _ => Err(faults),
    }
}

fn gap(end: &End, loose: &[End], pieces: &[Piece], tolerance_m: f64) -> ImportFault {
    let line = pieces.get(end.piece).map_or(0, |p| p.line);
    let nearest = loose
        .iter()
        .filter(|other| (other.piece, other.second) != (end.piece, end.second))
        .min_by(|a, b| distance_m(a.at, end.at).total_cmp(&distance_m(b.at, end.at)));
    let message = match nearest {
        Some(other) => format!(
            "line {line}: the piece ends at {}, off the axis; the nearest other loose end is {:.6} m away at {}, ends closer than {tolerance_m:.1e} m are joined",
            At(end.at),
            distance_m(other.at, end.at),
            At(other.at)
        ),
        None => format!(
            "line {line}: the piece ends at {}, off the axis",
            At(end.at)
        ),
    };
    ImportFault::Chain(message)
}

fn walk(first: End, ends: &Ends, pieces: &[Piece]) -> Result<Vec<Vec<f64>>, Vec<ImportFault>> {
    let mut rows: Vec<Vec<f64>> = Vec::with_capacity(pieces.len() + 1);
    let mut at = first;
    while let Some(piece) = pieces.get(at.piece) {
        let piece = if at.second == 0 {
            piece.clone()
        } else {
            piece.reversed()
        };
        // where pieces meet within the tolerance, the first one's end stands
        let start = rows
            .pop()
            .map_or([piece.start.x_m, piece.start.r_m], |row| {
                [
                    row.first().copied().unwrap_or(0.0),
                    row.get(1).copied().unwrap_or(0.0),
                ]
            });
        rows.push(vec![start[0], start[1], piece.bulge]);
        rows.push(vec![piece.end.x_m, piece.end.r_m, 0.0]);
        let far = End {
            at: piece.end,
            piece: at.piece,
            second: 1 - at.second,
        };
        match ends.partners(&far).first() {
            Some(next) if rows.len() <= pieces.len() + 1 => at = *next,
            _ => break,
        }
    }
    let used = rows.len().saturating_sub(1);
    if used < pieces.len() {
        let message = format!(
            "{} of {} pieces are not connected with the chain from axis to axis",
            pieces.len() - used,
            pieces.len()
        );
        return Err(vec![ImportFault::Chain(message)]);
    }
    for row in [0, used] {
        if let Some(r) = rows.get_mut(row).and_then(|row| row.get_mut(1)) {
            *r = 0.0;
        }
    }
    Ok(rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn piece(x0: f64, r0: f64, x1: f64, r1: f64) -> Piece {
        Piece {
            start: Point { x_m: x0, r_m: r0 },
            end: Point { x_m: x1, r_m: r1 },
            bulge: 0.0,
            line: 7,
        }
    }

    #[test]
    fn loose_pieces_are_put_in_order_and_turned() {
        let pieces = vec![
            piece(2.0, 0.0, 2.0, 1.0),
            piece(0.0, 0.0, 2.0, 0.0), // the axis
            piece(1.0, 1.000_001, 2.0, 1.0),
            piece(1.0, 1.0, 0.0, 0.0),
        ];
        let rows = rows(pieces).unwrap();
        let x: Vec<f64> = rows.iter().map(|row| row[0]).collect();
        assert_eq!(x, [0.0, 1.0, 2.0, 2.0]);
        assert_eq!(rows[1][1], 1.0);
    }

    #[test]
    fn gaps_branches_and_islands_say_where() {
        let said = |pieces| rows(pieces).unwrap_err()[0].to_string();
        let gap = said(vec![piece(0.0, 0.0, 1.0, 1.0), piece(1.0, 0.9, 1.0, 0.0)]);
        assert!(
            gap.contains("line 7") && gap.contains("0.100000 m away"),
            "{gap}"
        );
        let branch = said(vec![
            piece(0.0, 0.0, 1.0, 1.0),
            piece(1.0, 1.0, 1.0, 0.0),
            piece(1.0, 1.0, 2.0, 0.0),
        ]);
        assert!(
            branch.contains("3 pieces meet at x = 1 m, r = 1 m"),
            "{branch}"
        );
        let island = said(vec![
            piece(0.0, 0.0, 1.0, 1.0),
            piece(1.0, 1.0, 2.0, 0.0),
            piece(5.0, 1.0, 6.0, 1.0),
            piece(6.0, 1.0, 6.0, 2.0),
            piece(6.0, 2.0, 5.0, 1.0),
        ]);
        assert!(island.contains("3 of 5 pieces"), "{island}");
        assert!(said(vec![piece(0.0, 0.0, 1.0, 0.0)]).contains("off the axis"));
    }
}
