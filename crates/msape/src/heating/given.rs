//! Heating given from outside: heat fluxes over speed and density, from another program or a test.
//!
//! ```text
//! ln q̇ linear in ln ρ and in ln V      where every flux of the rows beside is above 0, else
//! q̇ linear in ρ, and in V
//! ```
//!
//! with q̇ in W/m², ρ the free-stream density in kg/m³ and V the speed relative to the air in m/s. The form in density is that of the
//! rows of one speed, the form in speed that of two neighboring speeds, so that the flux has no steps. A power law is met
//! everywhere.
//!
//! # Valid
//! The vehicle and the gas for which the fluxes were found. Beyond the ends, by the rule of the case, the last slope
//! continues (below the least speed and density only so that the flux does not grow), or the end values are held, or
//! the flight is ended.
//!
//! # References
//! - Own convention; \[samareh-2014\] section 5 asks for such hooks to higher fidelity.

pub mod body;
mod check;

use super::Flow;
use crate::aero::table::Extrapolation;
use crate::finding::{Finding, Severity};
use numerics::math::ln;
use numerics::scalar::{Mask, Scalar};

/// Source named in findings for numbers given by the user.
pub const USERS: &str = "given by the user";

/// Least speed, m/s, and density, kg/m³, of a logarithm, assumed: below those of any flight, and its logarithm is finite.
const LEAST: f64 = 1e-30;

/// Heat fluxes over speed and density.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenHeating {
    /// Key of the table in the case.
    pub key: &'static str,
    /// Rule beyond its ends.
    pub extrapolation: Extrapolation,
    speeds_m_s: Vec<f64>,
    densities_kg_m3: Vec<f64>,
    convective: Fluxes,
    radiative: Option<Fluxes>,
}

/// One column of the table.
#[derive(Clone, Debug, PartialEq)]
struct Fluxes {
    /// W/m²; density runs fastest.
    values: Vec<f64>,
    /// Whether the rows of a speed go by logarithms.
    logarithmic: Vec<bool>,
}

/// Kind of heat flux in a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Convective, or total where the table has no other.
    Convective,
    /// Radiative.
    Radiative,
}

/// Two neighboring rows of an axis, and a number between them, or beyond where other rows would begin.
#[derive(Clone, Copy)]
struct Between<S> {
    /// Fraction of the interval between them: within 0 to 1, but beyond where only the table goes on.
    part: S,
    /// Distance of the number beyond an end of the table, as far as the rule allows, in intervals of the two rows.
    beyond: S,
}

impl<S: Scalar> Between<S> {
    /// Two rows and a number, by its logarithm or by the number itself, in a table with these ends.
    fn new(
        x: S,
        [from, to]: [S; 2],
        ends: [f64; 2],
        by_log: S::Mask,
        rule: Extrapolation,
    ) -> Between<S> {
        let logarithm = |x: S| x.max(S::constant(LEAST)).ln();
        let [first, last] = ends.map(S::constant);
        let inside = x.clamp(first, last);
        let scaled = |x: S| match by_log.any() {
            true => S::select(by_log, logarithm(x), x),
            false => x,
        };
        let [x, inside, from, to] = [x, inside, from, to].map(scaled);
        let step = to - from;
        Between {
            part: (inside - from) / step,
            beyond: match rule {
                Extrapolation::Extend => (x - inside) / step,
                Extrapolation::Hold | Extrapolation::Refuse => S::constant(0.0),
            },
        }
    }

    /// Change beyond the end with a change from row to row; below the first row it does not grow.
    fn further(&self, change: S) -> S {
        let none = S::constant(0.0);
        let change = S::select(self.beyond.less(none), change.max(none), change);
        change * self.beyond
    }
}

impl Fluxes {
    fn new(values: Vec<f64>, densities: &[f64]) -> Fluxes {
        let dense = densities.iter().all(|density| *density > 0.0);
        let rows = values.chunks(densities.len().max(1));
        let logarithmic = rows.map(|row| dense && row.iter().all(|flux| *flux > 0.0));
        Fluxes {
            logarithmic: logarithmic.collect(),
            values,
        }
    }

    /// Two neighboring fluxes of a speed, or their logarithms, and 1 where it is these.
    fn pair(&self, speed: usize, density: usize, width: usize) -> [f64; 3] {
        let value = |i: usize| self.values.get(speed * width + i).copied();
        let ends = [density, density + 1].map(|i| value(i).unwrap_or_default());
        match self.logarithmic.get(speed) {
            Some(true) => [ln(ends[0]), ln(ends[1]), 1.0],
            _ => [ends[0], ends[1], 0.0],
        }
    }
}

impl GivenHeating {
    /// The four fluxes about a place, or their logarithms, each row with whether it goes by them; ends of speed and density.
    fn cell(&self, fluxes: &Fluxes, speed_m_s: f64, density_kg_m3: f64) -> [f64; 10] {
        let rows = |axis: &[f64], x: f64| {
            let index = axis.partition_point(|node| *node <= x).saturating_sub(1);
            let index = index.min(axis.len().saturating_sub(2));
            let node = |i: usize| axis.get(i).copied().unwrap_or_default();
            (index, node(index), node(index + 1))
        };
        let (i, v_0, v_1) = rows(&self.speeds_m_s, speed_m_s);
        let (j, rho_0, rho_1) = rows(&self.densities_kg_m3, density_kg_m3);
        let [q_00, q_01, log_0] = fluxes.pair(i, j, self.densities_kg_m3.len());
        let [q_10, q_11, log_1] = fluxes.pair(i + 1, j, self.densities_kg_m3.len());
        [q_00, q_01, log_0, q_10, q_11, log_1, v_0, v_1, rho_0, rho_1]
    }

    fn of_fluxes<S: Scalar>(&self, fluxes: &Fluxes, flow: &Flow<S>) -> S {
        let (v, rho) = (flow.speed_m_s, flow.density_kg_m3);
        let cell = (flow.chosen_by_m_s).lookup_pair(rho, |v, rho| self.cell(fluxes, v, rho));
        let [q_00, q_01, log_0, q_10, q_11, log_1, v_0, v_1, rho_0, rho_1] = cell;
        let (none, rule) = (S::constant(0.0), self.extrapolation);
        let [speeds, densities] = self.ends();
        let by_log = [log_0, log_1].map(|log| none.less(log));
        let all = by_log[0].and(by_log[1]).and(none.less(v_0));
        // rows of two speeds at the density: as it is, and held within the table
        let row = |by_log: S::Mask, from: S, to: S| {
            let between = Between::new(rho, [rho_0, rho_1], densities, by_log, rule);
            let inside = from + (to - from) * between.part;
            let values = [inside + between.further(to - from), inside];
            values.map(|value| {
                let of_log = by_log.and(all.not());
                let plain = S::select(by_log, value, value.max(none));
                match of_log.any() {
                    true => S::select(of_log, value.exp(), plain),
                    false => plain,
                }
            })
        };
        let [slow, slow_inside] = row(by_log[0], q_00, q_01);
        let [fast, fast_inside] = row(by_log[1], q_10, q_11);
        let between = Between::new(v, [v_0, v_1], speeds, all, rule);
        let flux = slow + (fast - slow) * between.part + between.further(fast_inside - slow_inside);
        match all.any() {
            true => S::select(all, flux.exp(), flux.max(none)),
            false => flux.max(none),
        }
    }

    /// Heat flux of a flow, W/m²; 0 where the table does not give it.
    #[inline]
    pub fn heat_flux_w_m2<S: Scalar>(&self, part: Part, flow: &Flow<S>) -> S {
        let fluxes = match part {
            Part::Convective => &self.convective,
            Part::Radiative => match &self.radiative {
                Some(fluxes) => fluxes,
                None => return S::constant(0.0),
            },
        };
        self.of_fluxes(fluxes, flow)
    }

    /// Whether the table gives radiative heating, too.
    pub fn has_radiation(&self) -> bool {
        self.radiative.is_some()
    }

    /// Speeds of its rows, m/s, ascending: there its slopes jump.
    pub fn speeds_m_s(&self) -> &[f64] {
        &self.speeds_m_s
    }

    /// First and last speed, m/s, and first and last density, kg/m³.
    pub fn ends(&self) -> [[f64; 2]; 2] {
        [&self.speeds_m_s, &self.densities_kg_m3].map(|axis| {
            let (first, last) = (axis.first(), axis.last());
            [first, last].map(|end| end.copied().unwrap_or_default())
        })
    }

    /// Whether the two rows at each end of speed, and of density, are equal, so that every rule continues with them.
    pub fn level(&self) -> [[bool; 2]; 2] {
        let (speeds, width) = (self.speeds_m_s.len(), self.densities_kg_m3.len());
        let columns = || core::iter::once(&self.convective).chain(&self.radiative);
        let alike = |first: [usize; 2], step: [usize; 2], count: usize| {
            columns().all(|column| {
                let at =
                    |start: usize, stride: usize, i: usize| column.values.get(start + stride * i);
                (0..count).all(|i| at(first[0], step[0], i) == at(first[1], step[1], i))
            })
        };
        let row = |speed: usize| alike([speed * width, (speed + 1) * width], [1, 1], width);
        let column = |density: usize| alike([density, density + 1], [width, width], speeds);
        [
            [row(0), row(speeds.saturating_sub(2))],
            [column(0), column(width.saturating_sub(2))],
        ]
    }

    /// The remark that the heating is the user's.
    pub fn finding(&self, part: Part) -> Finding {
        let [[v_0, v_1], [rho_0, rho_1]] = self.ends();
        let (which, key) = match part {
            Part::Convective => ("Convective", "peak_convective_heat_flux_w_m2"),
            Part::Radiative => ("Radiative", "peak_radiative_heat_flux_w_m2"),
        };
        Finding {
            severity: Severity::Note,
            model: self.key.into(),
            key: key.into(),
            value: None,
            valid: (None, None),
            message: format!(
                "{which} heating is {USERS}: {} heat fluxes over {v_0} to {v_1} m/s and {rho_0:e} to {rho_1:e} kg/m³, whatever the nose radius.",
                self.convective.values.len()
            ),
            source: USERS.into(),
            field: Some(self.key.into()),
        }
    }
}

#[cfg(test)]
mod tests;
