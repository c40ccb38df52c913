//! Heating along a flight at points of the body for which a case gives heat fluxes.
//!
//! ```text
//! Q = ∫ (mᶜ q̇ᶜ + mʳ q̇ʳ) dt        by Gauss over each step, five nodes
//! ```
//!
//! with Q in J/m², q̇ in W/m², m the margins, t in s.
//!
//! # Valid
//! Steps along which the heat load of the stagnation point is integrated to the tolerance of the solver.
//!
//! # References
//! - [`numerics::quadrature`].

use super::Peak;
use super::equations::Equations;
use super::integration::Record;
use super::mission::Mission;
use super::motion::Motion;
use super::peaks::Peaks;
use crate::finding::range::short;
use crate::finding::{Finding, Severity};
use crate::heating::Flow;
use crate::heating::given::body::{Along, BodyHeating};
use crate::heating::given::{GivenHeating, USERS};
use numerics::quadrature::Rule;
use numerics::scalar::Single;
use serde::{Deserialize, Serialize};

/// Heating at a point of the body, margins included.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PointHeat<S = f64> {
    /// Along what the points are counted.
    pub along: Along,
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
    let Some(body) = &motion.point().mission.heating.body else {
        return Vec::new();
    };
    let none = S::constant(0.0);
    let mut loads = vec![none; body.points.len()];
    for leg in &record.legs {
        let motion = motion.in_stage(&leg.stage);
        let duration_s = leg.step.t1 - leg.step.t0;
        for (part, weight) in Rule::Gauss5.points([0.0, 1.0]) {
            let y = leg.step.at(leg.step.t0 + duration_s * part);
            let flow = flow(&motion, &y);
            for ((_, table), load) in body.points.iter().zip(&mut loads) {
                *load += margined_w_m2(motion.point(), table, &flow) * duration_s * weight;
            }
        }
    }
    let peak = |(fraction, table): &(f64, GivenHeating)| {
        let peak: Peak<S> =
            peaks.of_motion(|motion, _, y| margined_w_m2(motion.point(), table, &flow(motion, y)));
        (*fraction, peak.value)
    };
    let found = body.points.iter().map(peak).zip(loads);
    let found = found.map(
        |((fraction, peak_heat_flux_w_m2), heat_load_j_m2)| PointHeat {
            along: body.along,
            fraction,
            peak_heat_flux_w_m2,
            heat_load_j_m2,
        },
    );
    found.collect()
}

/// The points of the case before a flight, each with its heat flux, W/m².
pub(super) fn none_yet(mission: &Mission) -> Vec<(PointHeat, f64)> {
    let body = mission.heating.body.as_ref();
    let of = |body: &BodyHeating| {
        let point = |(fraction, _): &(f64, GivenHeating)| PointHeat {
            along: body.along,
            fraction: *fraction,
            peak_heat_flux_w_m2: 0.0,
            heat_load_j_m2: 0.0,
        };
        let points = body.points.iter().map(point);
        points.map(|point| (point, 0.0)).collect()
    };
    body.map_or(Vec::new(), |body| of(body))
}

/// Adds the heating by a flow met a time, s, after the one before, by the trapezoidal rule.
pub(super) fn add(
    points: &mut [(PointHeat, f64)],
    mission: &Mission,
    flow: &Flow<f64>,
    time_s: f64,
) {
    let tables = mission.heating.body.iter().flat_map(|body| &body.points);
    for ((point, before_w_m2), (_, table)) in points.iter_mut().zip(tables) {
        let nominal = mission.heating.heat_flux_of(table, flow);
        let now_w_m2 = mission.heating.margined(&nominal).total_w_m2();
        point.heat_load_j_m2 += 0.5 * (*before_w_m2 + now_w_m2) * time_s;
        point.peak_heat_flux_w_m2 = point.peak_heat_flux_w_m2.max(now_w_m2);
        *before_w_m2 = now_w_m2;
    }
}

/// The flow about a motion, with rows of heating chosen by those that hold.
fn flow<'a, M: Motion<'a, N, S>, const N: usize, S: Single>(motion: &M, y: &[S; N]) -> Flow<S> {
    motion.point().flow(&motion.around(y))
}

/// Heat flux at a point of the body, margins included, W/m².
fn margined_w_m2<S: Single>(equations: &Equations<S>, table: &GivenHeating, flow: &Flow<S>) -> S {
    let heating = &equations.mission.heating;
    let nominal = equations.with_factors(heating.heat_flux_of(table, flow));
    heating.margined(&nominal).total_w_m2()
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

#[cfg(test)]
mod tests {
    use crate::{Answer, Case, Library, Outcome, Request, fly};

    fn flown(more: &str) -> Answer {
        let text = crate::library::data_file("cases/stardust.toml").unwrap();
        let (before, after) = text.split_once("[stop]").unwrap();
        let case = Case::from_text(&format!("{before}{more}\n[stop]{after}")).unwrap();
        fly(&case, &Library::builtin().unwrap(), Request::Nothing).unwrap()
    }

    /// Sutton and Graves of the report for a nose radius of 0.2286 m, times a factor: 1.74153e-4 √(ρ/Rₙ) V³.
    fn rows(prefix: &str, factor: f64) -> String {
        let mut rows = String::new();
        for v in [2e3, 6e3, 10e3, 14e3] {
            for rho in [1e-6_f64, 1e-4, 1e-2] {
                let flux = factor * 1.74153e-4 * (rho / 0.2286).sqrt() * v * v * v;
                rows.push_str(&format!("[{prefix}{v:e}, {rho:e}, {flux:e}, 0.0],\n"));
            }
        }
        rows
    }

    #[test]
    fn a_table_of_a_relation_gives_the_heat_of_the_relation() {
        let of = |answer: Answer| {
            let flight = answer.flight.unwrap();
            let peak = flight.peak_convective_heat_flux_w_m2;
            (peak.value, flight.convective_heat_load_j_m2)
        };
        let relation = of(flown(""));
        let table = of(flown(&format!("table = [\n{}]", rows("", 1.0))));
        // a power law is met everywhere
        assert!(
            (table.0 / relation.0 - 1.0).abs() < 1e-4,
            "{table:?} {relation:?}"
        );
        assert!(
            (table.1 / relation.1 - 1.0).abs() < 1e-4,
            "{table:?} {relation:?}"
        );
    }

    #[test]
    fn each_point_is_integrated_and_the_stagnation_point_as_in_the_flight() {
        let table = format!(
            "radius_table = [\n{}{}]",
            rows("0.0, ", 1.0),
            rows("1.0, ", 1.5)
        );
        let answer = flown(&table);
        assert_eq!(answer.outcome, Outcome::Landed);
        let flight = answer.flight.unwrap();
        let [nose, edge] = &flight.points[..] else {
            panic!("two points")
        };
        let load = flight.total_margined_heat_load_j_m2();
        assert!(
            (nose.heat_load_j_m2 / load - 1.0).abs() < 1e-5,
            "{nose:?} {load}"
        );
        let peak = flight.peak_total_margined_heat_flux_w_m2.value;
        assert!((nose.peak_heat_flux_w_m2 / peak - 1.0).abs() < 1e-9);
        assert!((edge.heat_load_j_m2 / nose.heat_load_j_m2 - 1.5).abs() < 1e-12);
        assert!((edge.peak_heat_flux_w_m2 / nose.peak_heat_flux_w_m2 - 1.5).abs() < 1e-9);
    }

    #[test]
    fn the_model_factor_is_of_a_relation_and_not_of_given_fluxes() {
        let table = format!("table = [\n{}]", rows("", 1.0));
        let factor = "convective_model_factor = 1.33\n";
        let peak = |answer: &Answer| {
            let flight = answer.flight.as_ref().unwrap();
            flight.peak_convective_heat_flux_w_m2.value
        };
        let (plain, with) = (flown(&table), flown(&format!("{factor}{table}")));
        assert_eq!(peak(&plain), peak(&with));
        let said = |answer: &Answer| {
            let mut findings = answer.findings.iter();
            findings.any(|f| f.message.contains("The model factor is not used"))
        };
        assert!(said(&with) && !said(&plain));
        assert!((peak(&flown(factor)) / peak(&flown("")) - 1.33).abs() < 1e-5);
    }

    #[test]
    fn the_users_table_is_told_and_its_ends_are() {
        let answer = flown(&format!("table = [\n{}]", rows("", 1.0)));
        let said: Vec<&str> = answer.findings.iter().map(|f| f.message.as_str()).collect();
        let has = |part: &str| said.iter().any(|message| message.contains(part));
        assert!(has("Convective heating is given by the user"), "{said:?}");
        assert!(has("Radiative heating is given by the user"), "{said:?}");
        assert!(has("The density reaches"), "{said:?}");
        assert!(has("the last slope goes on"), "{said:?}");
        let refused = flown(&format!(
            "extrapolation = \"refuse\"\ntable = [\n{}]",
            rows("", 1.0)
        ));
        assert_eq!(refused.outcome, Outcome::Stopped);
        assert!(refused.reason.unwrap().contains("heating.table"));
    }
}
