//! Temperatures and shares of the cells, and the amounts that are conserved.

use crate::grid::Grid;
use crate::stack::Stack;

/// Unknowns of the cells.
#[derive(Clone, Debug)]
pub(crate) struct State {
    /// Temperature of the wall, K.
    pub wall_k: f64,
    /// Volume coordinate of the wall, m.
    pub wall_m: f64,
    /// Temperature of each cell, K.
    pub t: Vec<f64>,
    /// Undecomposed share of each reaction, cell by cell of the first layer.
    pub share: Vec<f64>,
    /// Flow of gas through each face of the first layer towards the wall, kg/s per m² of the initial wall.
    pub gas: Vec<f64>,
    /// Pressure at each face of the first layer, Pa.
    pub pressure_pa: Vec<f64>,
}

/// Amounts per area of the initial wall.
#[derive(Clone, Debug, Default)]
pub(crate) struct Content {
    /// Volume coordinate of the wall, m.
    pub wall_m: f64,
    /// Energy of each cell, J/m².
    pub energy: Vec<f64>,
    /// Share of each reaction times volume, m.
    pub share: Vec<f64>,
}

impl Content {
    /// Energy of all cells, J/m².
    pub fn total_j_m2(&self) -> f64 {
        self.energy.iter().fold(0.0, |sum, e| sum + e)
    }
}

/// Undecomposed share of all reactions together, weighted with the density they take.
pub(crate) fn whole_share(weights: &[f64], shares: &[f64]) -> f64 {
    weights
        .iter()
        .zip(shares)
        .fold(0.0, |sum, (w, x)| sum + w * x)
}

impl State {
    pub fn new(grid: &Grid, reactions: usize, temperature_k: f64) -> Self {
        Self {
            wall_k: temperature_k,
            wall_m: 0.0,
            t: vec![temperature_k; grid.len()],
            share: vec![1.0; grid.first * reactions],
            gas: vec![0.0; grid.first + 1],
            pressure_pa: vec![0.0; grid.first + 1],
        }
    }

    /// Undecomposed share of a cell; 1 behind the first layer.
    pub fn whole(&self, weights: &[f64], cell: usize) -> f64 {
        let n = weights.len();
        match self.share.get(cell * n..(cell + 1) * n) {
            Some(shares) if n > 0 => whole_share(weights, shares),
            _ => 1.0,
        }
    }

    /// Writes the amounts that the cells hold; the grid is that of the state.
    pub fn content(&self, stack: &Stack, grid: &Grid, weights: &[f64], content: &mut Content) {
        content.wall_m = self.wall_m;
        content.energy.clear();
        content.share.clear();
        for i in 0..grid.len() {
            let solid = &stack.layers[grid.layer[i]].material.solid;
            let [virgin, char] = solid.at(self.t[i]).enthalpy_j_m3;
            let z = self.whole(weights, i);
            content
                .energy
                .push(grid.volume_m[i] * (z * virgin + (1.0 - z) * char));
        }
        for (j, x) in self.share.iter().enumerate() {
            content
                .share
                .push(x * grid.volume_m[j / weights.len().max(1)]);
        }
    }

    /// Mass of the solid, kg per m² of the initial wall.
    pub fn mass_kg_m2(&self, stack: &Stack, grid: &Grid, weights: &[f64]) -> f64 {
        (0..grid.len()).fold(0.0, |sum, i| {
            let solid = &stack.layers[grid.layer[i]].material.solid;
            sum + grid.volume_m[i] * solid.density_kg_m3(self.whole(weights, i))
        })
    }
}
