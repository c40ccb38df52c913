//! Shares of the reactions in one cell of a stage, and the gas that they set free.
//!
//! ```text
//! V X + h V k(T) X^ψ + h v_L X_L(X, X_behind) = (V X)_known + h v_R X_R
//! X_L = X + r (X − X_behind),   within 0 and 1
//! ```
//!
//! with V in m, k in 1/s, v in m/s, r the distance of the left face over that of the cell behind.
//!
//! # Valid
//! Solid that comes from behind.
//!
//! # References
//! - \[amar-2006\].

use super::{Linear, Stage, Work, add};
use crate::grid::Grid;
use crate::state::State;

/// What a cell's reactions make.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Made {
    pub z: f64,
    pub dz: Linear,
    pub z_left: f64,
    pub dz_left: Linear,
    pub gas: f64,
    pub dgas: Linear,
}

impl Stage<'_> {
    /// Shares of a cell for its temperature, those at its left face, and the gas that it sets free.
    pub(super) fn shares(
        &self,
        grid: &Grid,
        state: &mut State,
        work: &mut Work,
        i: usize,
        passed: f64,
    ) -> Made {
        let mut made = Made::default();
        let Some(pyrolysis) = self.pyrolysis() else {
            return made;
        };
        let solid = &self.stack.layers[0].material.solid;
        let loss = solid.virgin.density_kg_m3 - solid.char.density_kg_m3;
        let reactions = self.weights.len();
        let volume = grid.volume_m[i];
        let [m_l, m_r] = [grid.motion[i], grid.motion[i + 1]];
        // Slope of the share carried to the left face: second order, where there is a cell behind.
        let reach = if i + 1 < grid.first {
            (grid.middle_m[i] - grid.face_m[i]) / (grid.middle_m[i + 1] - grid.middle_m[i])
        } else {
            0.0
        };
        for (j, reaction) in pyrolysis.reactions.iter().enumerate() {
            let index = i * reactions + j;
            let (x_right, dx_right) = work.right[j];
            let (x_behind, dx_behind) = work.behind[j];
            let [k, k_t] = reaction.factor(state.t[i]);
            let known = self.known.share[index] + passed * m_r * x_right;
            let (vl, hk) = (passed * m_l, self.h * volume * k);
            let face = |x: f64| {
                let carried = x + reach * (x - x_behind);
                if (0.0..=1.0).contains(&carried) {
                    (carried, 1.0 + reach, -reach)
                } else {
                    (carried.clamp(0.0, 1.0), 0.0, 0.0)
                }
            };
            // V X + h V k X^ψ + h v_L X_L = known + h v_R X_R
            let mut x = state.share[index];
            let (mut at, mut rate, mut slope) = (face(x), reaction.of_share(x), volume);
            for _ in 0..40 {
                at = face(x);
                rate = reaction.of_share(x);
                slope = volume + hk * rate.by_share + vl * at.1;
                let step = (volume * x + hk * rate.value + vl * at.0 - known) / slope;
                x -= step;
                if step.abs() <= 1e-15 + 1e-14 * x.abs() {
                    break;
                }
            }
            state.share[index] = x;
            let by_y = (m_r - m_l) * (x + self.h * k * rate.value) + m_l * at.0 - m_r * x_right;
            let by_t = self.h * volume * k_t * rate.value;
            let mut dx = [-by_t / slope, -by_y / slope, 0.0];
            add(&mut dx, -vl * at.2 / slope, &dx_behind);
            add(&mut dx, passed * m_r / slope, &dx_right);
            let mut dx_left = [0.0; 3];
            add(&mut dx_left, at.1, &dx);
            add(&mut dx_left, at.2, &dx_behind);
            let w = self.weights[j];
            let scale = loss * w * volume;
            add(&mut made.dz, w, &dx);
            add(&mut made.dz_left, w, &dx_left);
            add(&mut made.dgas, scale * k * rate.by_share, &dx);
            made.z += w * x;
            made.z_left += w * at.0;
            made.gas += scale * k * rate.value;
            made.dgas[0] += scale * k_t * rate.value;
            made.dgas[1] += loss * w * (m_r - m_l) * k * rate.value;
            work.shares[index] = dx;
            work.right[j] = (at.0, dx_left);
            work.behind[j] = (x, dx);
        }
        made
    }
}
