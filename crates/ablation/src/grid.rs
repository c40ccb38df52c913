//! Cells: those of the first layer shrink with it, the others stand.
//!
//! ```text
//! y_f = Y + ξ_f (Y₁ − Y)          first layer: volume coordinate of a face, Y that of the wall
//! x   = x₀ + L (e^(aη) − 1) / (e^a − 1),   η = j/N      initial faces, a = ln(last/first cell)
//! ```
//!
//! with y and Y in m (volume per area of the initial wall), x in m from the initial wall. As the volume of a cell is linear in Y,
//! a solid that only moves through the cells keeps its density exactly, in every geometry.
//!
//! # Valid
//! Until the first layer is gone.
//!
//! # References
//! - \[amar-2006\] for cells that shrink with the wall.

use crate::geometry::Geometry;
use crate::stack::Stack;
use numerics::math;

/// Numbers of cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resolution {
    /// Cells of the first layer.
    pub cells: usize,
    /// Last over first cell of the first layer.
    pub stretch: f64,
    /// Cells of each further layer.
    pub cells_behind: usize,
}

impl Default for Resolution {
    /// The numbers at which case 2.2 of the workshop is within 1 K of a grid of 512 cells.
    fn default() -> Self {
        Self {
            cells: 64,
            stretch: 30.0,
            cells_behind: 8,
        }
    }
}

/// Places of faces and cells for a place of the wall.
#[derive(Clone, Debug)]
pub(crate) struct Grid {
    geometry: Geometry,
    /// Number of cells of the first layer.
    pub first: usize,
    /// Layer of each cell.
    pub layer: Vec<usize>,
    /// Volume of the first layer, m.
    pub first_volume_m: f64,
    /// Share of the wall's motion, 1 − ξ, of each face; none behind the first layer.
    pub motion: Vec<f64>,
    /// Depth of each face, m.
    pub face_m: Vec<f64>,
    /// Area of each face over that of the initial wall.
    pub area: Vec<f64>,
    /// Depth of the middle of each cell, m.
    pub middle_m: Vec<f64>,
    /// Volume of each cell per area of the initial wall, m.
    pub volume_m: Vec<f64>,
    /// Share of the first of two neighbors in the value at each face.
    pub first_share: Vec<f64>,
}

impl Grid {
    pub fn new(stack: &Stack, resolution: &Resolution) -> Self {
        let geometry = stack.geometry;
        let mut face_m = vec![0.0];
        let mut layer = Vec::new();
        let mut start = 0.0;
        for (l, each) in stack.layers.iter().enumerate() {
            let cells = if l == 0 {
                resolution.cells
            } else {
                resolution.cells_behind
            }
            .max(1);
            let a = if l == 0 {
                math::ln(resolution.stretch.max(1.0))
            } else {
                0.0
            };
            for j in 1..=cells {
                let eta = j as f64 / cells as f64;
                let share = if a < 1e-9 {
                    eta
                } else {
                    (math::exp(a * eta) - 1.0) / (math::exp(a) - 1.0)
                };
                face_m.push(start + share * each.thickness_m);
                layer.push(l);
            }
            start += each.thickness_m;
        }
        let first = layer.iter().filter(|l| **l == 0).count();
        let n = layer.len();
        let first_volume_m = geometry.volume_m(face_m[first]);
        let motion = face_m.iter().enumerate().map(|(f, x)| {
            if f >= first {
                0.0
            } else {
                1.0 - geometry.volume_m(*x) / first_volume_m
            }
        });
        let mut grid = Self {
            geometry,
            first,
            motion: motion.collect(),
            layer,
            first_volume_m,
            area: vec![0.0; n + 1],
            middle_m: vec![0.0; n],
            volume_m: vec![0.0; n],
            first_share: vec![0.0; n + 1],
            face_m,
        };
        grid.place(0.0, n);
        grid
    }

    /// Number of cells.
    pub fn len(&self) -> usize {
        self.layer.len()
    }

    /// Moves the wall to a volume coordinate, m.
    pub fn move_wall(&mut self, wall_m: f64) {
        for f in 0..self.first {
            // ξ Y₁ + (1 − ξ) Y
            let y = self.first_volume_m - self.motion[f] * (self.first_volume_m - wall_m);
            self.face_m[f] = self.geometry.depth_m(y);
        }
        self.place(wall_m, self.first);
    }

    /// Areas, middles and volumes of the first `cells` cells.
    fn place(&mut self, wall_m: f64, cells: usize) {
        for i in 0..cells {
            let [a, b] = [self.face_m[i], self.face_m[i + 1]];
            self.middle_m[i] = 0.5 * (a + b);
            self.area[i] = self.geometry.area(a);
            self.area[i + 1] = self.geometry.area(b);
            self.volume_m[i] = if i < self.first {
                (self.motion[i] - self.motion[i + 1]) * (self.first_volume_m - wall_m)
            } else {
                self.geometry.volume_m(b) - self.geometry.volume_m(a)
            };
        }
        for f in 1..cells {
            let [a, b] = [self.middle_m[f - 1], self.middle_m[f]];
            self.first_share[f] = (b - self.face_m[f]) / (b - a);
        }
        self.first_share[0] = 0.0;
    }

    /// Depth of the wall, m.
    pub fn wall_depth_m(&self) -> f64 {
        self.face_m[0]
    }
}
