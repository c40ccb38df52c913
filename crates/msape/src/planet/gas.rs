//! Gas of an atmosphere: properties that density and temperature do not determine.
//!
//! ```text
//! p = ρ R T,   R = R*/M,   a = √(γ p/ρ)
//! L = 16 μ / (5 ρ √(2π R T)),   μ = μᵣ (T/Tᵣ)^ω      or      L = M / (√2 π σ² N_A ρ)
//! ```
//!
//! with p in Pa, ρ in kg/m³, T in K, M in kg/kmol, R in J/(kg K), R* in J/(kmol K), a in m/s, γ the ratio of the heat capacities at
//! T, L the mean free path in m, μ the viscosity in Pa s, σ a collision diameter in m, N_A in 1/kmol.
//!
//! # Valid
//! A perfect gas without reactions. γ is held beyond its first and last temperature.
//!
//! # References
//! - \[bird-1994\] sections 3.5 (viscosity and mean free path of hard spheres) and appendix A; \[coesa-1976\] equation 29.

use super::atmosphere::Air;
use numerics::math::PI;
use numerics::scalar::Scalar;
use serde::Deserialize;

/// Gas constant of the International System, J/(kmol K).
pub const GAS_CONSTANT_J_KMOL_K: f64 = 8_314.462_618_153_24;

/// A gas.
#[derive(Clone, Debug, PartialEq)]
pub struct Gas {
    /// Gas constant, J/(kg K).
    pub gas_constant_j_kg_k: f64,
    /// Ratio of the heat capacities.
    pub heat_capacity_ratio: HeatCapacityRatio,
    /// Mean free path.
    pub free_path: FreePath,
}

/// Ratio of the heat capacities.
#[derive(Clone, Debug, PartialEq)]
pub enum HeatCapacityRatio {
    /// Constant ratio.
    Constant(f64),
    /// Linear in temperature between rows, held beyond them.
    Table(Vec<Row>),
}

/// Row of the table: lower temperature, ratio there and slope above it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    temperature_k: f64,
    ratio: f64,
    slope_per_k: f64,
}

/// Mean free path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FreePath {
    /// Mean free path from a collision diameter: mean free path times density, kg/m².
    Diameter {
        /// Mean free path times density, kg/m².
        times_density_kg_m2: f64,
    },
    /// Mean free path from a viscosity that is a power of temperature.
    Viscosity {
        /// Viscosity at the reference temperature, Pa s.
        viscosity_pa_s: f64,
        /// Reference temperature, K.
        temperature_k: f64,
        /// Exponent of the temperature.
        exponent: f64,
    },
}

/// A gas as data files have it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct GasData {
    #[serde(rename = "source")]
    _source: String,
    #[serde(rename = "place")]
    _place: String,
    #[serde(rename = "note")]
    _note: String,
    molar_mass_kg_kmol: f64,
    /// Pairs of temperature, K, and ratio.
    heat_capacity_ratio: Vec<[f64; 2]>,
    viscosity_pa_s: f64,
    viscosity_temperature_k: f64,
    viscosity_exponent: f64,
}

impl GasData {
    /// The gas, or the fault.
    pub(super) fn gas(&self) -> Result<Gas, String> {
        let positive = [
            self.molar_mass_kg_kmol,
            self.viscosity_pa_s,
            self.viscosity_temperature_k,
        ];
        if positive.iter().any(|x| !(*x > 0.0 && x.is_finite())) {
            return Err("gas: molar mass and viscosity must be above 0".to_string());
        }
        Ok(Gas {
            gas_constant_j_kg_k: GAS_CONSTANT_J_KMOL_K / self.molar_mass_kg_kmol,
            heat_capacity_ratio: HeatCapacityRatio::try_new(&self.heat_capacity_ratio)?,
            free_path: FreePath::Viscosity {
                viscosity_pa_s: self.viscosity_pa_s,
                temperature_k: self.viscosity_temperature_k,
                exponent: self.viscosity_exponent,
            },
        })
    }
}

impl HeatCapacityRatio {
    /// The ratio over pairs of temperature, K, ascending, and ratio; or the fault.
    pub fn try_new(pairs: &[[f64; 2]]) -> Result<Self, String> {
        let ascending = pairs.windows(2).all(|pair| match pair {
            [[a, _], [b, _]] => a < b,
            _ => false,
        });
        let possible = pairs
            .iter()
            .all(|[t, ratio]| *t > 0.0 && t.is_finite() && (1.0..2.0).contains(ratio));
        match pairs {
            [] => Err("heat_capacity_ratio: got no pair".to_string()),
            _ if !ascending || !possible => Err(
                "heat_capacity_ratio: temperatures must ascend above 0 K, ratios be 1 to 2"
                    .to_string(),
            ),
            [[_, only]] => Ok(Self::Constant(*only)),
            _ => {
                let slopes = pairs.windows(2).map(|pair| match pair {
                    [[a, from], [b, to]] => (to - from) / (b - a),
                    _ => 0.0,
                });
                let rows = pairs.iter().zip(slopes.chain([0.0]));
                let rows = rows.map(|(&[temperature_k, ratio], slope_per_k)| Row {
                    temperature_k,
                    ratio,
                    slope_per_k,
                });
                Ok(Self::Table(rows.collect()))
            }
        }
    }

    /// The ratio at a temperature, K.
    #[inline]
    pub fn at<S: Scalar>(&self, temperature_k: S) -> S {
        let rows = match self {
            Self::Constant(ratio) => return S::constant(*ratio),
            Self::Table(rows) => rows,
        };
        let [from_k, ratio, slope_per_k] = temperature_k.lookup(|t| {
            let above = rows.partition_point(|row| row.temperature_k <= t);
            match (above.checked_sub(1).and_then(|n| rows.get(n)), rows.first()) {
                (Some(row), _) => [row.temperature_k, row.ratio, row.slope_per_k],
                (None, Some(first)) => [first.temperature_k, first.ratio, 0.0],
                (None, None) => [0.0; 3],
            }
        });
        (temperature_k - from_k) * slope_per_k + ratio
    }
}

impl Gas {
    /// Molar mass, kg/kmol.
    pub fn molar_mass_kg_kmol(&self) -> f64 {
        GAS_CONSTANT_J_KMOL_K / self.gas_constant_j_kg_k
    }

    /// Air of a density, kg/m³, and a temperature, K; where they are given, with its own pressure over density, J/kg, and ratio
    /// of the heat capacities.
    #[inline]
    pub fn air<S: Scalar>(
        &self,
        density_kg_m3: S,
        temperature_k: S,
        pressure_over_density_j_kg: Option<S>,
        heat_capacity_ratio: Option<S>,
    ) -> Air<S> {
        let r = self.gas_constant_j_kg_k;
        let ratio =
            heat_capacity_ratio.unwrap_or_else(|| self.heat_capacity_ratio.at(temperature_k));
        Air {
            density_kg_m3,
            pressure_pa: match pressure_over_density_j_kg {
                Some(quotient) => density_kg_m3 * quotient,
                None => density_kg_m3 * temperature_k * r,
            },
            temperature_k,
            speed_of_sound_m_s: match pressure_over_density_j_kg {
                Some(quotient) => (quotient * ratio).sqrt(),
                None => (temperature_k * (ratio * r)).sqrt(),
            },
            heat_capacity_ratio: ratio,
            mean_free_path_m: self.free_path.times_density_kg_m2(temperature_k, r) / density_kg_m3,
        }
    }
}

impl FreePath {
    /// Mean free path times density, kg/m², at a temperature, K, in a gas of a gas constant, J/(kg K).
    #[inline]
    pub fn times_density_kg_m2<S: Scalar>(&self, temperature_k: S, gas_constant_j_kg_k: f64) -> S {
        match *self {
            Self::Diameter {
                times_density_kg_m2,
            } => S::constant(times_density_kg_m2),
            Self::Viscosity {
                viscosity_pa_s,
                temperature_k: at_k,
                exponent,
            } => {
                let viscosity = (temperature_k / at_k).pow(S::constant(exponent)) * viscosity_pa_s;
                viscosity * 3.2 / (temperature_k * (2.0 * PI * gas_constant_j_kg_k)).sqrt()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn carbon_dioxide() -> Gas {
        GasData {
            _source: String::new(),
            _place: String::new(),
            _note: String::new(),
            molar_mass_kg_kmol: 44.01,
            heat_capacity_ratio: vec![[200.0, 1.35], [300.0, 1.29]],
            viscosity_pa_s: 1.38e-5,
            viscosity_temperature_k: 273.0,
            viscosity_exponent: 0.93,
        }
        .gas()
        .unwrap()
    }

    #[test]
    fn sound_in_carbon_dioxide_at_250_k() {
        // R = 8314.46/44.01 = 188.92; √(1.32 · 188.92 · 250) = 249.69
        let air: crate::planet::atmosphere::Air<f64> =
            carbon_dioxide().air(0.02, 250.0, None, None);
        assert!((air.speed_of_sound_m_s - 249.69).abs() < 0.01, "{air:?}");
        // p = 0.02 · 188.92 · 250
        assert!((air.pressure_pa - 944.6).abs() < 0.1);
    }

    #[test]
    fn mean_free_path_of_a_viscosity_is_that_of_its_hard_sphere() {
        // σ² = 5 √(π m k T)/(16 π μ): m = 7.3079e-26 kg, 273 K: 5 · 2.9417e-23/(16 · π · 1.38e-5) = 2.1204e-19 m²,
        // L ρ = m/(√2 π σ²) = 7.757e-8 kg/m²
        let gas = carbon_dioxide();
        let got: f64 = gas
            .free_path
            .times_density_kg_m2(273.0, gas.gas_constant_j_kg_k);
        assert!((got / 7.757e-8 - 1.0).abs() < 1e-3, "{got}");
    }

    #[test]
    fn the_ratio_is_linear_and_held_beyond_its_ends() {
        let ratio = carbon_dioxide().heat_capacity_ratio;
        for (t, expected) in [
            (100.0, 1.35),
            (200.0, 1.35),
            (225.0, 1.335),
            (300.0, 1.29),
            (900.0, 1.29),
        ] {
            let got: f64 = ratio.at(t);
            assert!((got - expected).abs() < 1e-12, "{t}: {got}");
        }
        for wrong in [vec![], vec![[200.0, 0.9]], vec![[300.0, 1.3], [200.0, 1.3]]] {
            assert!(HeatCapacityRatio::try_new(&wrong).is_err());
        }
        assert_eq!(
            HeatCapacityRatio::try_new(&[[300.0, 1.4]]),
            Ok(HeatCapacityRatio::Constant(1.4))
        );
    }
}
