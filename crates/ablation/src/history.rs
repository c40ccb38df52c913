//! History of a run: rows at the times asked for, and extremes over all steps.
//!
//! ```text
//! T(x) through the middles of the cells, their layer's ends and the wall: cubic through four neighbors
//! ```
//!
//! with T in K, x in m from the initial wall; 0 K where the solid is gone.
//!
//! # Valid
//! Within the stack.
//!
//! # References
//! - \[assumed\]: interpolation.

use crate::grid::Grid;
use crate::stack::Stack;
use crate::stage::Edges;
use crate::state::State;

/// Values at one time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sample {
    /// Time, s.
    pub time_s: f64,
    /// Temperature of the wall, K.
    pub wall_k: f64,
    /// Temperature at each depth, K; 0 where the solid is gone.
    pub depths_k: Vec<f64>,
    /// Pyrolysis gas at the wall, kg/(m² s).
    pub gas_kg_m2s: f64,
    /// Char taken away, kg/(m² s).
    pub char_kg_m2s: f64,
    /// Depth of the wall, m.
    pub recession_m: f64,
    /// Temperature behind each layer, K.
    pub behind_k: Vec<f64>,
    /// Highest pressure of the gas in the solid, Pa.
    pub pressure_pa: f64,
    /// Pressure at the wall where it reacts, Pa, and B'_g there.
    pub exposed: Option<[f64; 2]>,
    /// Depth to which less than 98 % is virgin, m.
    pub pyrolysis_depth_m: f64,
}

impl Sample {
    pub(crate) fn new(
        stack: &Stack,
        grid: &Grid,
        state: &State,
        weights: &[f64],
        depths_m: &[f64],
        time_s: f64,
        edges: &Edges,
    ) -> Self {
        let n = grid.len();
        let area = grid.area[0];
        let mut behind_k = Vec::with_capacity(stack.layers.len());
        for i in 0..n {
            if i + 1 == n || grid.layer[i + 1] != grid.layer[i] {
                // Extrapolated to the face from two cells and more.
                behind_k.push(at_face(grid, state, i));
            }
        }
        Self {
            time_s,
            wall_k: state.wall_k,
            depths_k: depths_m
                .iter()
                .map(|x| temperature_k(grid, state, &behind_k, *x))
                .collect(),
            gas_kg_m2s: edges.gas / area,
            char_kg_m2s: edges.char / area,
            recession_m: grid.wall_depth_m(),
            behind_k,
            pressure_pa: state.pressure_pa.iter().copied().fold(0.0, f64::max),
            exposed: edges.gas_ratio.map(|ratio| [state.pressure_pa[0], ratio]),
            pyrolysis_depth_m: (0..grid.first)
                .rev()
                .find(|i| state.whole(weights, *i) < 0.98)
                .map_or(0.0, |i| grid.face_m[i + 1]),
        }
    }
}

/// Temperature at the back face of a cell that ends its layer: the parabola through it and the two before.
fn at_face(grid: &Grid, state: &State, i: usize) -> f64 {
    let layer = grid.layer[i];
    let x = grid.face_m[i + 1];
    let from = i.saturating_sub(2);
    let points: Vec<[f64; 2]> = (from..=i)
        .filter(|j| grid.layer[*j] == layer)
        .map(|j| [grid.middle_m[j], state.t[j]])
        .collect();
    lagrange(&points, x)
}

/// Value at x of the polynomial through points.
fn lagrange(points: &[[f64; 2]], x: f64) -> f64 {
    // Above the first, so that equal values stay equal.
    let base = points.first().map_or(0.0, |[_, y]| *y);
    points.iter().enumerate().fold(base, |sum, (i, [xi, yi])| {
        let others = points.iter().enumerate().filter(|(j, _)| *j != i);
        sum + others.fold(yi - base, |product, (_, [xj, _])| {
            product * (x - xj) / (xi - xj)
        })
    })
}

/// Temperature at a depth, K; 0 where there is no solid.
fn temperature_k(grid: &Grid, state: &State, behind_k: &[f64], x: f64) -> f64 {
    let n = grid.len();
    // a depth at the last face is within, whatever the sum of the cells
    if x < grid.wall_depth_m() || x > grid.face_m[n] * (1.0 + 1e-9) {
        return 0.0;
    }
    let cell = grid
        .face_m
        .iter()
        .skip(1)
        .position(|face| x <= *face)
        .unwrap_or(n - 1);
    let layer = grid.layer[cell];
    let begin = grid
        .layer
        .iter()
        .position(|l| *l == layer)
        .unwrap_or_default();
    let end = begin + grid.layer.iter().filter(|l| **l == layer).count();
    let mut points = Vec::with_capacity(end - begin + 2);
    if begin == 0 {
        points.push([grid.face_m[0], state.wall_k]);
    }
    points.extend((begin..end).map(|i| [grid.middle_m[i], state.t[i]]));
    points.push([
        grid.face_m[end],
        behind_k.get(layer).copied().unwrap_or_default(),
    ]);
    let after = points
        .iter()
        .position(|[at, _]| *at >= x)
        .unwrap_or(points.len() - 1);
    let first = after.saturating_sub(2).min(points.len().saturating_sub(4));
    lagrange(
        points
            .get(first..(first + 4).min(points.len()))
            .unwrap_or(&points),
        x,
    )
}

/// Highest temperature at a place, and when.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Peak {
    /// Temperature, K.
    pub temperature_k: f64,
    /// Time, s.
    pub time_s: f64,
}

/// Rows and extremes of a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct History {
    /// Rows: the start, each output, the end.
    pub rows: Vec<Sample>,
    /// Highest temperature of the wall.
    pub wall: Peak,
    /// Highest temperature behind each layer.
    pub behind: Vec<Peak>,
    /// Highest pressure of the gas in the solid, Pa.
    pub pressure_pa: f64,
    /// Greatest depth to which less than 98 % was virgin, m.
    pub pyrolysis_depth_m: f64,
    /// Lowest and highest pressure at which the wall reacted, Pa; from above to below where it never did.
    pub exposed_pa: [f64; 2],
    /// Highest B'_g.
    pub gas_ratio: f64,
}

impl History {
    pub(crate) fn new(layers: usize) -> Self {
        Self {
            behind: vec![Peak::default(); layers],
            exposed_pa: [f64::INFINITY, f64::NEG_INFINITY],
            ..Self::default()
        }
    }

    pub(crate) fn keep(&mut self, sample: Sample) {
        self.follow(&sample);
        self.rows.push(sample);
    }

    /// Takes the extremes.
    pub(crate) fn follow(&mut self, sample: &Sample) {
        let rise = |peak: &mut Peak, temperature_k: f64| {
            if temperature_k > peak.temperature_k {
                *peak = Peak {
                    temperature_k,
                    time_s: sample.time_s,
                };
            }
        };
        rise(&mut self.wall, sample.wall_k);
        for (peak, t) in self.behind.iter_mut().zip(&sample.behind_k) {
            rise(peak, *t);
        }
        if let Some([pressure_pa, ratio]) = sample.exposed {
            let [least, most] = self.exposed_pa;
            self.exposed_pa = [least.min(pressure_pa), most.max(pressure_pa)];
            self.gas_ratio = self.gas_ratio.max(ratio);
        }
        self.pressure_pa = self.pressure_pa.max(sample.pressure_pa);
        self.pyrolysis_depth_m = self.pyrolysis_depth_m.max(sample.pyrolysis_depth_m);
    }

    /// Whether the temperature behind a layer is below its maximum by more than rounding.
    pub(crate) fn falls(&self, layer: usize, sample: &Sample) -> bool {
        let peak = self
            .behind
            .get(layer)
            .map_or(0.0, |peak| peak.temperature_k);
        sample.behind_k.get(layer).is_some_and(|t| *t < peak - 0.05)
    }
}
