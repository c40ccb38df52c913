//! Heating and pressure at the stagnation point, and what follows from them for the rest of the surface.
//!
//! - [`convective`]: [`sutton_graves`] and [`brandis_johnston`], cold wall.
//! - [`radiative`]: [`tauber_sutton`] and [`brandis_johnston`], with the capped [`nose_exponent`].
//! - [`given`]: heat fluxes from outside, in place of both.
//! - [`stagnation`]: both together, with model factor, margins and the hot [`wall`].
//! - [`pressure`]: stagnation pressure, by one of three models.
//! - [`shoulder`], [`distribution`], [`afterbody`]: away from the stagnation point.
//!
//! The per-step models are generic over [`numerics::scalar::Scalar`].
//!
//! Deliberately absent: momentum-thickness Reynolds number and transition. The report reads them off Navier-Stokes
//! solutions and prints no relation; none with a source was found that gives them at the shoulder of such a body.

pub mod afterbody;
pub mod brandis_johnston;
pub mod convective;
pub mod distribution;
pub mod given;
pub mod nose_exponent;
pub mod pressure;
pub mod radiative;
pub mod shoulder;
pub mod stagnation;
pub mod sutton_graves;
pub mod tauber_sutton;
pub mod wall;

use crate::finding::range::{Check, Range};
use crate::finding::{Finding, Severity};
use crate::quantity::input;
use serde::{Deserialize, Serialize};

pub use stagnation::{HeatFlux, StagnationHeating};

/// W/m² in one W/cm², and J/m² in one J/cm².
pub const PER_CM2: f64 = 1e4;

/// The flow that a blunt nose meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flow<S> {
    /// Free-stream density, kg/m³.
    pub density_kg_m3: S,
    /// Speed relative to the air, m/s.
    pub speed_m_s: S,
    /// Nose radius, m.
    pub nose_radius_m: S,
    /// Speed by which rows and branches of a relation are chosen, m/s: that of the flow, or one for a whole step of a flight, so
    /// that the relation goes on smoothly beyond a kink at which the step ends.
    pub chosen_by_m_s: S,
}

impl<S: Copy> Flow<S> {
    /// A flow of a density, kg/m³, and a speed, m/s, against a nose of a radius, m.
    #[inline]
    pub fn new(density_kg_m3: S, speed_m_s: S, nose_radius_m: S) -> Self {
        Flow {
            density_kg_m3,
            speed_m_s,
            nose_radius_m,
            chosen_by_m_s: speed_m_s,
        }
    }
}

/// Flow at the instant of peak heating, at which the range of a correlation is checked.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PeakConditions {
    /// Free-stream density, kg/m³.
    pub density_kg_m3: f64,
    /// Speed relative to the air, m/s.
    pub speed_m_s: f64,
    /// Nose radius, m.
    pub nose_radius_m: f64,
}

/// The item that belongs to a planet, of items that belong to some planets each.
fn of_planet<T>(all: Vec<(Vec<String>, T)>, planet: &str) -> Option<T> {
    let mut all = all.into_iter();
    all.find(|(planets, _)| planets.iter().any(|name| name == planet))
        .map(|(_, thing)| thing)
}

/// Ranges of a stagnation-point correlation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FlowRange {
    /// Speed, m/s.
    #[serde(default)]
    pub speed_m_s: Range,
    /// Density, kg/m³.
    #[serde(default)]
    pub density_kg_m3: Range,
    /// Nose radius, m.
    #[serde(default)]
    pub nose_radius_m: Range,
}

impl FlowRange {
    /// A finding for each of speed, density and nose radius that is outside at peak heating.
    pub fn findings(&self, model: &str, source: &str, peak: &PeakConditions) -> Vec<Finding> {
        let check = Check {
            severity: Severity::Extrapolated,
            model,
            key: "peak_total_heat_flux_speed_m_s",
            quantity: "Speed at peak heating",
            value: peak.speed_m_s,
            range: self.speed_m_s,
            unit: "m/s",
            si_per_unit: 1.0,
            meaning: "the correlation is used beyond its data",
            source,
            field: Some(input::entry::SPEED_M_S.key),
        };
        let density = Check {
            key: "peak_total_heat_flux_density_kg_m3",
            quantity: "Density at peak heating",
            value: peak.density_kg_m3,
            range: self.density_kg_m3,
            unit: "kg/m³",
            field: Some(input::entry::FLIGHT_PATH_ANGLE_DEG.key),
            ..check
        };
        let nose = Check {
            key: "nose_radius_m",
            quantity: "Nose radius",
            value: peak.nose_radius_m,
            range: self.nose_radius_m,
            unit: "m",
            field: Some(input::design::NOSE_RADIUS_RATIO.key),
            ..check
        };
        [check, density, nose]
            .iter()
            .filter_map(Check::finding)
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::brandis_johnston::BrandisJohnston;
    use super::sutton_graves::SuttonGraves;
    use super::tauber_sutton::TauberSutton;
    use super::*;
    use numerics::math;

    #[derive(Deserialize)]
    #[expect(non_snake_case, reason = "columns of the file")]
    struct Row {
        planet: String,
        rho_kgm3: f64,
        Rn_m: f64,
        V_ms: f64,
        q_sg: f64,
        q_ts: f64,
        a_ts: f64,
        q_bj_conv: f64,
        q_bj_rad: f64,
    }

    /// Seven printed digits: half of the last is 5e-7 at worst; a_ts carries five decimals.
    fn near(ours: f64, theirs: f64, tolerance: f64) -> bool {
        theirs.is_nan() || (ours - theirs).abs() <= tolerance * theirs.abs()
    }

    #[test]
    fn all_46_independent_vectors_are_met_to_their_printed_digits() {
        let graves = include_str!("../data/heating/sutton-graves.toml");
        let earth =
            TauberSutton::parse(include_str!("../data/heating/tauber-sutton.toml").into()).unwrap();
        let mars =
            TauberSutton::parse(include_str!("../data/heating/tauber-sutton-mars.toml").into())
                .unwrap();
        let brandis =
            BrandisJohnston::parse(include_str!("../data/heating/brandis-johnston.toml").into())
                .unwrap();
        let text = include_str!("../../../tests/data/heating_test_vectors.csv");
        let mut reader = csv::ReaderBuilder::new()
            .comment(Some(b'#'))
            .from_reader(text.as_bytes());
        let mut rows = 0;
        for row in reader.deserialize::<Row>() {
            let row = row.unwrap();
            let flow = Flow::new(row.rho_kgm3, row.V_ms, row.Rn_m);
            let convective = SuttonGraves::parse(graves.into(), &row.planet).unwrap();
            let radiative = if row.planet == "mars" { &mars } else { &earth };
            let a: f64 =
                radiative
                    .exponent
                    .value(math::ln(row.V_ms), math::ln(row.rho_kgm3), row.Rn_m);
            assert!(
                near(convective.heat_flux_w_m2(&flow), row.q_sg, 1e-6),
                "sg {flow:?}"
            );
            assert!(
                near(radiative.heat_flux_w_m2(&flow), row.q_ts, 1e-6),
                "ts {flow:?}"
            );
            assert!((a - row.a_ts).abs() <= 5.1e-6, "a_ts {flow:?}: {a}");
            assert!(
                near(
                    brandis.convective.heat_flux_w_m2(&flow),
                    row.q_bj_conv,
                    1e-6
                ),
                "bj conv {flow:?}"
            );
            assert!(
                near(brandis.radiative.heat_flux_w_m2(&flow), row.q_bj_rad, 1e-6),
                "bj rad {flow:?}"
            );
            rows += 1;
        }
        assert_eq!(rows, 46);
    }
}
