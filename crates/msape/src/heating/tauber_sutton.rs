//! Radiative heat flux at the stagnation point after Tauber and Sutton.
//!
//! ```text
//! q̇ = C Rₙ^a ρ^b f(V)
//! ```
//!
//! with q̇ in W/cm² (converted), Rₙ in m, ρ in kg/m³, f a table over V in m/s, and the capped exponent a of
//! [`NoseExponent`]. f is 0 below its table and held above it.
//!
//! # Valid
//! Earth: 10 to 16 km/s, 6.66e-5 to 6.31e-4 kg/m³, 0.3 to 3 m. Mars: 6.5 to 9 km/s, 1e-4 to 1e-3 kg/m³.
//! f jumps from 0 to its first value where the table begins ([`TauberSutton::onset_m_s`]).
//!
//! # References
//! - \[tauber-sutton-1991\], Table 1.

use super::nose_exponent::NoseExponent;
use super::{Flow, FlowRange, PER_CM2, PeakConditions};
use crate::data::Data;
use crate::finding::Finding;
use numerics::scalar::{Mask, Scalar};
use serde::Deserialize;

/// The correlation for one planet.
#[derive(Clone, Debug, PartialEq)]
pub struct TauberSutton {
    /// Names of the planets whose gas it is for.
    pub planets: Vec<String>,
    c: f64,
    density_exponent: f64,
    /// Exponent of the nose radius.
    pub exponent: NoseExponent,
    /// Ranges of the correlation.
    pub valid: FlowRange,
    /// Velocity function: speed, m/s; f; slope of f, s/m.
    rows: Vec<[f64; 3]>,
    onset_m_s: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(rename = "source")]
    _source: String,
    #[serde(rename = "place")]
    _place: String,
    #[serde(rename = "note")]
    _note: String,
    planets: Vec<String>,
    c: f64,
    density_exponent: f64,
    exponent: NoseExponent,
    valid: FlowRange,
    velocity_function: VelocityFunction,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct VelocityFunction {
    table: Vec<[f64; 2]>,
}

impl File {
    fn check(&self) -> Result<(), String> {
        let exponent = &self.exponent;
        let caps = exponent
            .caps
            .iter()
            .map(|cap| ("exponent.caps.cap", cap.cap));
        let positive = [
            ("c", self.c),
            ("exponent.coefficient", exponent.coefficient),
        ];
        for (key, value) in positive.into_iter().chain(caps) {
            if !(value > 0.0 && value.is_finite()) {
                return Err(format!("{key}: got {value}, must be above 0"));
            }
        }
        for (key, value) in [
            ("density_exponent", self.density_exponent),
            ("exponent.speed_exponent", exponent.speed_exponent),
            ("exponent.density_exponent", exponent.density_exponent),
        ] {
            if !value.is_finite() {
                return Err(format!("{key}: got {value}, must be a finite number"));
            }
        }
        for [v, f] in &self.velocity_function.table {
            if !(*v > 0.0 && v.is_finite()) {
                return Err(format!(
                    "velocity_function.table: got {v} m/s, must be above 0 m/s"
                ));
            }
            if !(*f >= 0.0 && f.is_finite()) {
                return Err(format!(
                    "velocity_function.table: got f = {f} at {v} m/s, must be 0 or more"
                ));
            }
        }
        Ok(())
    }
}

impl TauberSutton {
    /// Reads the correlation from the text of `heating/tauber-sutton.toml` or its sister for another planet.
    pub fn parse(data: Data) -> Result<Self, String> {
        let file: File = data.read()?;
        file.check()?;
        let table = file.velocity_function.table;
        let mut rows = Vec::with_capacity(table.len());
        for pair in table.windows(2) {
            let [[v0, f0], [v1, f1]] = [pair[0], pair[1]];
            if v1 <= v0 || !(v1 - v0).is_finite() {
                return Err(format!(
                    "velocity_function.table: {v1} m/s must be above {v0} m/s"
                ));
            }
            rows.push([v0, f0, (f1 - f0) / (v1 - v0)]);
        }
        let (Some(first), Some(last)) = (table.first(), table.last()) else {
            return Err("velocity_function.table: at least two rows are needed".into());
        };
        rows.push([last[0], last[1], 0.0]);
        Ok(Self {
            planets: file.planets,
            c: file.c,
            density_exponent: file.density_exponent,
            exponent: file.exponent,
            valid: file.valid,
            rows,
            onset_m_s: first[0],
        })
    }

    /// Speed at which the correlation sets in, m/s.
    pub fn onset_m_s(&self) -> f64 {
        self.onset_m_s
    }

    /// Speeds of the rows of the velocity function, m/s, ascending.
    pub fn table_speeds_m_s(&self) -> impl Iterator<Item = f64> + '_ {
        self.rows.iter().map(|row| row[0])
    }

    /// The row of the velocity function that holds at a speed, m/s; zeros below the first.
    #[inline]
    fn row(&self, v: f64) -> [f64; 3] {
        let above = self.rows.partition_point(|row| row[0] <= v);
        let row = above.checked_sub(1).and_then(|row| self.rows.get(row));
        row.copied().unwrap_or([0.0; 3])
    }

    /// Heat flux, W/m².
    #[inline]
    pub fn heat_flux_w_m2<S: Scalar>(&self, flow: &Flow<S>) -> S {
        let Flow {
            density_kg_m3: rho,
            speed_m_s: v,
            nose_radius_m: r_n,
            chosen_by_m_s,
        } = *flow;
        if chosen_by_m_s.less(S::constant(self.onset_m_s)).all() {
            return S::constant(0.0);
        }
        let [v0, f0, slope] = chosen_by_m_s.lookup(|v| self.row(v));
        let f = f0 + slope * (v - v0);
        let ln_rho = rho.ln();
        let a = self.exponent.value(v.ln(), ln_rho, r_n);
        // q̇ = C Rₙ^a ρ^b f(V)
        (a * r_n.ln() + ln_rho * self.density_exponent).exp() * f * (self.c * PER_CM2)
    }

    /// Findings where the peak is outside the ranges.
    pub fn findings(&self, peak: &PeakConditions) -> Vec<Finding> {
        if peak.speed_m_s < self.onset_m_s {
            return Vec::new();
        }
        self.valid.findings(
            "tauber-sutton",
            "Tauber & Sutton 1991, J. Spacecraft and Rockets 28(1)",
            peak,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn earth() -> TauberSutton {
        TauberSutton::parse(include_str!("../../data/heating/tauber-sutton.toml").into()).unwrap()
    }

    #[test]
    fn velocity_function_is_zero_linear_and_held() {
        // between 359 at 12 km/s and 495 at 12.5 km/s: 427
        let speeds = [8999.9, 9000.0, 12250.0, 16000.0, 17000.0];
        assert_eq!(
            speeds.map(|v| {
                let [v0, f0, slope] = earth().row(v);
                f0 + slope * (v - v0)
            }),
            [0.0, 1.5, 427.0, 2040.0, 2040.0]
        );
    }

    #[test]
    fn one_meter_nose_leaves_c_rho_to_b_f() {
        // 1 m: R^a = 1; 4.736e4 × (1e-4)^1.22 × 35 × 1e4 = 4.736e4 × 10^-4.88 × 3.5e5 = 2.18512e5 W/m²
        let q = earth().heat_flux_w_m2(&Flow::new(1e-4, 1e4, 1.0));
        let by_hand = 4.736e4 * 3.5e5 * 1.318_256_738_556_407e-5;
        assert!((q / by_hand - 1.0).abs() < 1e-12);
    }

    #[test]
    fn ranges_speak_only_where_there_is_radiation() {
        let peak = PeakConditions {
            density_kg_m3: 3e-4,
            speed_m_s: 1.2e4,
            nose_radius_m: 0.35,
        };
        assert!(earth().findings(&peak).is_empty());
        assert_eq!(
            earth()
                .findings(&PeakConditions {
                    nose_radius_m: 0.1125,
                    ..peak
                })
                .len(),
            1
        );
        assert_eq!(
            earth()
                .findings(&PeakConditions {
                    speed_m_s: 1.7e4,
                    density_kg_m3: 1e-3,
                    ..peak
                })
                .len(),
            2
        );
        assert!(
            earth()
                .findings(&PeakConditions {
                    speed_m_s: 8e3,
                    density_kg_m3: 1e-3,
                    ..peak
                })
                .is_empty()
        );
    }

    #[test]
    fn unsorted_table_is_refused() {
        let text =
            include_str!("../../data/heating/tauber-sutton.toml").replace("[9250.0,", "[8250.0,");
        assert!(
            TauberSutton::parse(text.as_str().into())
                .unwrap_err()
                .contains("8250")
        );
    }

    #[test]
    fn a_number_that_makes_no_heat_flux_is_refused() {
        let shipped = include_str!("../../data/heating/tauber-sutton.toml");
        for (was, is, said) in [
            (
                "\nc = 4.736e4",
                "\nc = -4.736e4",
                "c: got -47360, must be above 0",
            ),
            ("\nc = 4.736e4", "\nc = inf", "c: got inf"),
            (
                "density_exponent = 1.22",
                "density_exponent = nan",
                "density_exponent: got NaN",
            ),
            (
                "coefficient = 1.072e6",
                "coefficient = 0.0",
                "exponent.coefficient: got 0",
            ),
            ("cap = 0.6", "cap = -0.6", "exponent.caps.cap: got -0.6"),
            (
                "[9250.0,",
                "[-9250.0,",
                "got -9250 m/s, must be above 0 m/s",
            ),
            (
                "[9000.0, 1.5]",
                "[9000.0, -1.5]",
                "got f = -1.5 at 9000 m/s",
            ),
        ] {
            let text = shipped.replacen(was, is, 1);
            assert_ne!(text, shipped, "{was}");
            let fault = TauberSutton::parse(text.as_str().into()).unwrap_err();
            assert!(fault.contains(said), "{fault}");
        }
    }
}
