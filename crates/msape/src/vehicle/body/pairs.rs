//! Pairs of pieces of a chain that come near each other, found by a tree of boxes over runs of the chain.
//!
//! ```text
//! runs apart by more than a tolerance, in x or in r, hold no such pair; else their halves are compared
//! ```
//!
//! Lengths in m. Neighbors along a chain are neighbors in the plane: the work grows little faster than the number of pieces.
//!
//! # Valid
//! Any boxes; the search ends after [`MOST_PAIRS`].
//!
//! # References
//! - Own arrangement of bounding boxes.

/// Largest number of pairs examined.
pub const MOST_PAIRS: usize = 5_000_000;

/// Least and largest x, least and largest r, m.
type Box = [f64; 4];

/// A tree of boxes: node 1 is the whole chain, the halves of node k are 2 k and 2 k + 1.
struct Tree<'b, F> {
    nodes: Vec<Box>,
    leaves: &'b [Box],
    near_m: f64,
    left: usize,
    visit: F,
}

/// A node and the pieces that it spans.
#[derive(Clone, Copy)]
struct Run {
    node: usize,
    from: usize,
    to: usize,
}

impl Run {
    fn halves(self) -> Option<[Run; 2]> {
        let middle = self.from.midpoint(self.to);
        (middle > self.from).then(|| {
            [
                Run {
                    node: 2 * self.node,
                    to: middle,
                    ..self
                },
                Run {
                    node: 2 * self.node + 1,
                    from: middle,
                    ..self
                },
            ]
        })
    }
}

/// Calls `visit` with each pair of boxes that are no more than `near_m` apart, the first before the second, until it says stop;
/// false where there are more pairs than are examined.
pub fn near_pairs(boxes: &[Box], near_m: f64, visit: impl FnMut(usize, usize) -> bool) -> bool {
    let mut tree = Tree {
        nodes: vec![[0.0; 4]; 4 * boxes.len().max(1)],
        leaves: boxes,
        near_m,
        left: MOST_PAIRS,
        visit,
    };
    let whole = Run {
        node: 1,
        from: 0,
        to: boxes.len(),
    };
    tree.bound(whole);
    tree.within(whole);
    tree.left > 0
}

impl<F: FnMut(usize, usize) -> bool> Tree<'_, F> {
    fn bound(&mut self, run: Run) -> Box {
        let bounds = match run.halves() {
            Some(halves) => {
                let [a, b] = halves.map(|half| self.bound(half));
                [
                    a[0].min(b[0]),
                    a[1].max(b[1]),
                    a[2].min(b[2]),
                    a[3].max(b[3]),
                ]
            }
            None => self.leaves.get(run.from).copied().unwrap_or_default(),
        };
        if let Some(node) = self.nodes.get_mut(run.node) {
            *node = bounds;
        }
        bounds
    }

    /// Pairs of one run; false to stop.
    fn within(&mut self, run: Run) -> bool {
        match run.halves() {
            Some([a, b]) => self.within(a) && self.within(b) && self.between(a, b),
            None => true,
        }
    }

    /// Pairs of two runs; false to stop.
    fn between(&mut self, a: Run, b: Run) -> bool {
        let bounds = |run: Run| self.nodes.get(run.node).copied().unwrap_or_default();
        let ([al, ar, ad, au], [bl, br, bd, bu]) = (bounds(a), bounds(b));
        let near = self.near_m;
        if al > br + near || bl > ar + near || ad > bu + near || bd > au + near {
            return true;
        }
        match (a.halves(), b.halves()) {
            (Some([one, other]), _) if a.to - a.from >= b.to - b.from => {
                self.between(one, b) && self.between(other, b)
            }
            (_, Some([one, other])) => self.between(a, one) && self.between(a, other),
            _ => {
                self.left -= 1;
                self.left > 0 && (self.visit)(a.from, b.from)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_near_pair_is_found_once() {
        // intervals [k, k + 1.5] on a line, one of them moved aside: each meets the next one, or two
        let boxes: Vec<Box> = (0..40)
            .map(|k| {
                let r = if k == 7 { 9.0 } else { 0.0 };
                [f64::from(k), f64::from(k) + 1.5, r, r]
            })
            .collect();
        let mut found = Vec::new();
        assert!(near_pairs(&boxes, 0.1, |i, j| {
            found.push((i, j));
            true
        }));
        found.sort_unstable();
        let touch = |a: &Box, b: &Box| b[0] <= a[1] + 0.1 && a[2] == b[2];
        let mut wanted = Vec::new();
        for (i, a) in boxes.iter().enumerate() {
            let after = boxes.iter().enumerate().skip(i + 1);
            wanted.extend(after.filter(|(_, b)| touch(a, b)).map(|(j, _)| (i, j)));
        }
        assert_eq!(found, wanted);
    }

    #[test]
    fn the_search_ends() {
        let boxes = vec![[0.0, 1.0, 0.0, 1.0]; 4000];
        let mut count = 0;
        assert!(!near_pairs(&boxes, 0.0, |_, _| {
            count += 1;
            true
        }));
        assert_eq!(count, MOST_PAIRS - 1);
        assert!(near_pairs(&[], 0.0, |_, _| true));
    }
}
