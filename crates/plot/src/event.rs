//! Labels of event lines, in rows above the plot, placed so that no label covers another or is crossed by a line.

use crate::text::{Weight, width_px};

/// Space between a line and its label, px.
const BESIDE_PX: f64 = 3.0;
/// Space between two labels, px.
const BETWEEN_PX: f64 = 6.0;

/// Placed label.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Placed {
    /// Index of the event.
    pub(crate) index: usize,
    /// Row; 0 is next to the plot.
    pub(crate) row: usize,
    /// Left edge of the text, px.
    pub(crate) left_px: f64,
    /// Right edge of the text, px.
    pub(crate) right_px: f64,
    /// Position of the line, px.
    pub(crate) line_px: f64,
}

/// Space available for labels.
pub(crate) struct Room {
    /// Left edge, px.
    pub(crate) left_px: f64,
    /// Right edge, px.
    pub(crate) right_px: f64,
    /// Number of rows.
    pub(crate) rows: usize,
    /// Size of the text, px.
    pub(crate) size_px: f64,
}

/// Largest number of events considered for a label.
const MOST_LABELS: usize = 32;

/// Places the labels of `lines` (index, position in px, label), most important first: a label that does not fit beside
/// more important ones is left out.
pub(crate) fn place(lines: &[(usize, f64, &str)], room: &Room) -> Vec<Placed> {
    let mut kept: Vec<(usize, f64, &str)> = Vec::new();
    let mut best = Vec::new();
    for line in lines.iter().filter(|l| !l.2.is_empty()).take(MOST_LABELS) {
        kept.push(*line);
        match place_all(&kept, room) {
            Some(placed) => best = placed,
            None => {
                kept.pop();
            }
        }
    }
    best
}

/// Places all labels from right to left, each in the lowest free row: to the right of its line, else to the left. A
/// line extends up to its own row only. `None` if not all labels fit.
fn place_all(lines: &[(usize, f64, &str)], room: &Room) -> Option<Vec<Placed>> {
    let mut order: Vec<&(usize, f64, &str)> = lines.iter().collect();
    order.sort_unstable_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
    let mut placed: Vec<Placed> = Vec::new();
    for &(index, line_px, label) in order {
        let width = width_px(label, room.size_px, Weight::Normal);
        let lefts = [line_px + BESIDE_PX, line_px - BESIDE_PX - width];
        let candidates = lefts.into_iter().flat_map(|left_px| {
            (0..room.rows).map(move |row| Placed {
                index,
                row,
                left_px,
                right_px: left_px + width,
                line_px,
            })
        });
        let inside = |c: &Placed| c.left_px >= room.left_px && c.right_px <= room.right_px;
        let mut free = candidates.filter(inside);
        placed.push(free.find(|c| placed.iter().all(|p| !disturbs(p, c)))?);
    }
    Some(placed)
}

fn disturbs(a: &Placed, b: &Placed) -> bool {
    let cuts = |line: &Placed, label: &Placed| {
        line.row > label.row
            && line.line_px > label.left_px - 1.0
            && line.line_px < label.right_px + 1.0
    };
    let shares = a.row == b.row
        && a.left_px < b.right_px + BETWEEN_PX
        && b.left_px < a.right_px + BETWEEN_PX;
    // in the same row, the line of one label must not cross another label
    let strikes = |line: &Placed, label: &Placed| {
        line.row == label.row && line.line_px > label.left_px && line.line_px < label.right_px
    };
    shares || cuts(a, b) || cuts(b, a) || strikes(a, b) || strikes(b, a)
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROOM: Room = Room {
        left_px: 0.0,
        right_px: 300.0,
        rows: 3,
        size_px: 10.0,
    };

    fn check(placed: &[Placed]) {
        for (i, a) in placed.iter().enumerate() {
            assert!(a.left_px >= ROOM.left_px && a.right_px <= ROOM.right_px);
            for b in &placed[i + 1..] {
                assert!(!disturbs(a, b), "{a:?} {b:?}");
            }
        }
    }

    #[test]
    fn distant_labels_share_the_lowest_row() {
        let placed = place(&[(0, 20.0, "peak heat"), (1, 180.0, "Mach 5")], &ROOM);
        assert_eq!(placed.len(), 2);
        assert!(placed.iter().all(|p| p.row == 0));
    }

    #[test]
    fn close_labels_are_staggered() {
        let placed = place(
            &[
                (0, 100.0, "peak heat"),
                (1, 110.0, "peak g"),
                (2, 118.0, "Mach 5"),
            ],
            &ROOM,
        );
        assert_eq!(placed.len(), 3);
        check(&placed);
        let rows: Vec<_> = placed.iter().map(|p| p.row).collect();
        assert!(rows.contains(&0) && rows.contains(&1));
    }

    #[test]
    fn labels_at_the_right_edge_turn_to_the_left() {
        let placed = place(&[(0, 295.0, "ground")], &ROOM);
        assert!(placed[0].right_px < 295.0);
    }

    #[test]
    fn what_finds_no_room_is_left_out() {
        let many: Vec<_> = (0..40).map(|i| (i, 100.0 + i as f64, "an event")).collect();
        let placed = place(&many, &ROOM);
        // three rows with a label on either side of its line
        assert!((3..=6).contains(&placed.len()), "{}", placed.len());
        assert!(placed.iter().any(|p| p.index == 0));
        check(&placed);
    }
}
