//! Pitch damping over angle of attack, Mach number and Knudsen number.
//!
//! ```text
//! M ≤ 0.5:  C_mq = C_mq* [1 + limit ε/(ε + α)] + r² C_Lα                                    equation 7, corrected
//!           C_Lα = (C_Nα − C_A) cos α − (C_N + C_Aα) sin α     C_N = 0.749 sin α     C_A = 0.654 − 0.5 sin² α
//! M ≥ 1.5:  C_mq = C + (C₀(M) − C) e^(−(α/α₀)²)                                             placeholder, assumed
//! between:  linear in M;   Kn > 10⁻³: fades to zero at Kn = 10
//! ```
//!
//! with α the total angle of attack in rad, the coefficients per unit of q D/(2V): pitch rate times diameter over twice the speed.
//! Equation 7 states no normalization; the same is assumed.
//!
//! # Valid
//! The report's capsules. The placeholder takes the place of Viking data that are not public.
//!
//! # References
//! - \[samareh-2014\] section 3.3.7 and equation 7; the placeholder is \[assumed\].

use super::bridging::Bridging;
use super::table::Grid;
use crate::data::Data;
use numerics::math::{RADIANS_PER_DEGREE, exp};
use serde::{Deserialize, Serialize};

/// Radius of gyration used in equation 7.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Reading {
    /// (r/D)² = 0.0625.
    #[default]
    Corrected,
    /// 0.25, as printed.
    Printed,
}

/// Coefficients of equation 7, of the blends and of the placeholder, from `data/aero-models/damping.toml`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DampingData {
    source: String,
    place: String,
    note: String,
    /// Factor of the term that falls with the angle.
    pub limit_coefficient: f64,
    /// Angle by which it falls, rad.
    pub epsilon_coefficient: f64,
    /// C_mq*.
    pub damping_coefficient: f64,
    /// C_N over sin α.
    pub normal_force_coefficient: f64,
    /// C_A nose first.
    pub axial_force_coefficient: f64,
    /// Decrease of C_A per sin² α.
    pub axial_force_loss_coefficient: f64,
    /// r² used.
    pub gyration_ratio: f64,
    /// r² printed.
    pub printed_gyration_ratio: f64,
    blend: Blend,
    viking: Viking,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Blend {
    mach: Ends,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Ends {
    min: f64,
    max: f64,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Viking {
    source: String,
    note: String,
    far_coefficient: f64,
    width_deg: f64,
    rows: Vec<VikingRow>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct VikingRow {
    mach: f64,
    damping_coefficient: f64,
}

impl DampingData {
    /// Reads the data file.
    ///
    /// # Errors
    /// The fault of the file.
    pub fn parse(data: Data) -> Result<DampingData, String> {
        data.read()
    }

    /// Note on the placeholder.
    pub fn placeholder_note(&self) -> &str {
        &self.viking.note
    }

    /// Equation 7 at a total angle of attack given by itself, its sine and its cosine.
    pub fn subsonic(&self, reading: Reading, alpha_rad: f64, sin: f64, cos: f64) -> f64 {
        let c_n = self.normal_force_coefficient * sin;
        let c_n_alpha = self.normal_force_coefficient * cos;
        let c_a = self.axial_force_coefficient - self.axial_force_loss_coefficient * sin * sin;
        let c_a_alpha = -2.0 * self.axial_force_loss_coefficient * sin * cos;
        let c_l_alpha = (c_n_alpha - c_a) * cos - (c_n + c_a_alpha) * sin;
        let epsilon = self.epsilon_coefficient;
        let r2 = match reading {
            Reading::Corrected => self.gyration_ratio,
            Reading::Printed => self.printed_gyration_ratio,
        };
        self.damping_coefficient * (1.0 + self.limit_coefficient * epsilon / (epsilon + alpha_rad))
            + r2 * c_l_alpha
    }

    /// The placeholder for the Viking data.
    pub fn viking(&self, mach: f64, alpha_rad: f64) -> f64 {
        let Viking {
            far_coefficient: far,
            width_deg,
            ref rows,
            ..
        } = self.viking;
        let t = alpha_rad / (width_deg * RADIANS_PER_DEGREE);
        if t > 6.0 {
            return far;
        }
        let after = rows.partition_point(|row| row.mach <= mach);
        let near = match (
            after.checked_sub(1).and_then(|n| rows.get(n)),
            rows.get(after),
        ) {
            (Some(a), Some(b)) => {
                let part = (mach - a.mach) / (b.mach - a.mach);
                a.damping_coefficient + part * (b.damping_coefficient - a.damping_coefficient)
            }
            (Some(only), None) | (None, Some(only)) => only.damping_coefficient,
            (None, None) => far,
        };
        far + (near - far) * exp(-t * t)
    }

    /// Part of the placeholder at a Mach number, 0 to 1.
    pub fn blend(&self, mach: f64) -> f64 {
        let Ends { min, max } = self.blend.mach;
        ((mach - min) / (max - min)).clamp(0.0, 1.0)
    }
}

/// Model of pitch damping.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Damping {
    /// No damping.
    Absent,
    /// Equation 7 and the placeholder, blended.
    Report {
        /// Coefficients.
        data: DampingData,
        /// Radius of gyration.
        reading: Reading,
    },
    /// A table of the user.
    Table(Grid),
}

impl Damping {
    /// Damping coefficient per unit of q D/(2V), at a total angle of attack of 0…π rad with its sine and cosine.
    pub fn coefficient(
        &self,
        [mach, knudsen]: [f64; 2],
        alpha_rad: f64,
        [sin, cos]: [f64; 2],
    ) -> f64 {
        match self {
            Self::Absent => 0.0,
            Self::Table(grid) => grid.damping(mach, knudsen, alpha_rad),
            Self::Report { data, reading } => {
                let part = data.blend(mach);
                let mut sum = 0.0;
                if part < 1.0 {
                    sum += (1.0 - part) * data.subsonic(*reading, alpha_rad, sin, cos);
                }
                if part > 0.0 {
                    sum += part * data.viking(mach, alpha_rad);
                }
                sum * (1.0 - Bridging::SineSquared.weight(knudsen))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use numerics::math::sin_cos;

    fn data() -> DampingData {
        DampingData::parse(include_str!("../../data/aero-models/damping.toml").into()).unwrap()
    }

    fn subsonic(reading: Reading, degrees: f64) -> f64 {
        let alpha = degrees * RADIANS_PER_DEGREE;
        let (s, c) = sin_cos(alpha);
        data().subsonic(reading, alpha, s, c)
    }

    #[test]
    fn equation_7_nose_first() {
        // −0.0468 (1 − 1.7) = 0.03276; C_Lα = 0.749 − 0.654 = 0.095, times 0.0625 or 0.25
        assert!((subsonic(Reading::Corrected, 0.0) - 0.038_697_5).abs() < 1e-12);
        assert!((subsonic(Reading::Printed, 0.0) - 0.056_51).abs() < 1e-12);
        // computed independently at 10, 45 and 90 deg, printed to five decimals
        let rows = [
            (10.0, -0.02256, -0.00301),
            (45.0, -0.03780, -0.02507),
            (90.0, -0.09116, -0.23160),
        ];
        for (degrees, corrected, printed) in rows {
            assert!((subsonic(Reading::Corrected, degrees) - corrected).abs() < 6e-6);
            assert!((subsonic(Reading::Printed, degrees) - printed).abs() < 6e-6);
        }
    }

    #[test]
    fn blends_end_where_the_report_says() {
        let damping = Damping::Report {
            data: data(),
            reading: Reading::Corrected,
        };
        let at = |mach: f64, knudsen: f64, degrees: f64| {
            let alpha = degrees * RADIANS_PER_DEGREE;
            let (s, c) = sin_cos(alpha);
            damping.coefficient([mach, knudsen], alpha, [s, c])
        };
        assert_eq!(at(0.5, 0.0, 10.0), subsonic(Reading::Corrected, 10.0));
        // 0.122 at Mach 1.5 and beyond, zero in free-molecular flow; −0.2 + 0.322 e^(−1) at 5 deg
        assert_eq!(at(1.5, 0.0, 0.0), 0.122);
        assert!((at(30.0, 0.0, 5.0) - (-0.2 + 0.322 * exp(-1.0))).abs() < 1e-15);
        assert_eq!(at(30.0, 10.0, 5.0), 0.0);
        // half of each at Mach 1: C₀(1) = 0.122/3
        let half = 0.5 * (subsonic(Reading::Corrected, 0.0) + 0.122 / 3.0);
        assert!((at(1.0, 0.0, 0.0) - half).abs() < 1e-15);
        assert!((at(30.0, 0.1, 0.0) - 0.061).abs() < 1e-15);
    }
}
