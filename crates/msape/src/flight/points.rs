//! Heating along a flight at points of the body for which a case gives heat fluxes.
//!
//! ```text
//! Q = ∫ (mᶜ q̇ᶜ + mʳ q̇ʳ) dt        by Gauss over each step, three nodes
//! ```
//!
//! with Q in J/m², q̇ in W/m², m the margins, t in s.
//!
//! # Valid
//! Steps along which the heat load of the stagnation point is integrated to the tolerance of the solver.
//!
//! # References
//! - Gauss-Legendre quadrature of degree 5.

use super::Peak;
use super::integration::Record;
use super::motion::{Motion, head};
use super::peaks::Peaks;
use crate::finding::range::short;
use crate::finding::{Finding, Severity};
use crate::heating::given::body::BodyHeating;
use crate::heating::given::{GivenHeating, USERS};
use crate::heating::{Flow, HeatFlux};
use numerics::scalar::Single;
use serde::{Deserialize, Serialize};

/// Nodes, as parts of a step, and weights.
const GAUSS: [[f64; 2]; 3] = [
    [0.112_701_665_379_258_3, 5.0 / 18.0],
    [0.5, 8.0 / 18.0],
    [0.887_298_334_620_741_7, 5.0 / 18.0],
];

/// Heating at a point of the body, margins included.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PointHeat<S = f64> {
    /// Place of the point, as the table of the case counts it.
    pub fraction: f64,
    /// Sum of both heat fluxes, W/m².
    pub peak_heat_flux_w_m2: S,
    /// Sum of both heat loads, J/m².
    pub heat_load_j_m2: S,
}

/// The points of the case, the stagnation point first; none where it gives none.
pub(super) fn of<'a, M: Motion<'a, N, S>, const N: usize, S: Single>(
    motion: M,
    record: &Record<N, S>,
    peaks: &Peaks<M, N, S>,
) -> Vec<PointHeat<S>> {
    let heating = &motion.point().mission.heating;
    let Some(body) = &heating.body else {
        return Vec::new();
    };
    let none = S::constant(0.0);
    let mut loads = vec![none; body.points.len()];
    for leg in &record.legs {
        let motion = motion.in_stage(&leg.stage);
        let duration_s = leg.step.t1 - leg.step.t0;
        for [part, weight] in GAUSS {
            let y = leg.step.at(leg.step.t0 + duration_s * part);
            let flow = flow(&motion, &y);
            for ((_, table), load) in body.points.iter().zip(&mut loads) {
                let nominal = with_factors(&motion, heating.heat_flux_of(table, &flow));
                *load = *load + heating.margined(&nominal).total_w_m2() * duration_s * weight;
            }
        }
    }
    let peak = |(fraction, table): &(f64, GivenHeating)| {
        let peak: Peak<S> = peaks.of_motion(|motion, _, y| {
            let nominal = with_factors(motion, heating.heat_flux_of(table, &flow(motion, y)));
            heating.margined(&nominal).total_w_m2()
        });
        (*fraction, peak.value)
    };
    let found = body.points.iter().map(peak).zip(loads);
    let found = found.map(
        |((fraction, peak_heat_flux_w_m2), heat_load_j_m2)| PointHeat {
            fraction,
            peak_heat_flux_w_m2,
            heat_load_j_m2,
        },
    );
    found.collect()
}

fn flow<'a, M: Motion<'a, N, S>, const N: usize, S: Single>(motion: &M, y: &[S; N]) -> Flow<S> {
    let around = motion.point().surroundings(&head(y));
    Flow {
        density_kg_m3: around.density_kg_m3,
        speed_m_s: around.air_speed_m_s,
        nose_radius_m: motion.point().numbers().nose_radius_m,
    }
}

fn with_factors<'a, M: Motion<'a, N, S>, const N: usize, S: Single>(
    motion: &M,
    flux: HeatFlux<S>,
) -> HeatFlux<S> {
    let numbers = motion.point().numbers();
    HeatFlux {
        convective_w_m2: flux.convective_w_m2 * numbers.convective_factor,
        radiative_w_m2: flux.radiative_w_m2 * numbers.radiative_factor,
    }
}

/// The hottest points.
pub(super) fn finding(body: &BodyHeating, points: &[PointHeat]) -> Option<Finding> {
    let largest =
        |value: fn(&PointHeat) -> f64| points.iter().max_by(|a, b| value(a).total_cmp(&value(b)));
    let flux = largest(|point| point.peak_heat_flux_w_m2)?;
    let load = largest(|point| point.heat_load_j_m2)?;
    let name = body.along.name();
    let key = body.stagnation()?.key;
    Some(Finding {
        severity: Severity::Note,
        model: key.into(),
        key: "peak_total_margined_heat_flux_w_m2".into(),
        value: Some(flux.peak_heat_flux_w_m2),
        valid: (None, None),
        message: format!(
            "Of the points given by the user {name} {} has the largest heat flux, {} W/m², and {name} {} the largest heat load, {} J/m², margins included.",
            flux.fraction,
            short(flux.peak_heat_flux_w_m2),
            load.fraction,
            short(load.heat_load_j_m2)
        ),
        source: USERS.into(),
        field: Some(key.into()),
    })
}
