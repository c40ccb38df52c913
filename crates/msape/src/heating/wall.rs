//! Temperature of the wall and its effect on convective heating.
//!
//! ```text
//! q̇ = q̇ᶜ (1 − h_w/h₀) + q̇ʳ = ε σ T_w⁴        h₀ = V²/2 + h(T∞)
//! h(T) = R [c₀ T + Σ xᵢ θᵢ / (exp(θᵢ/T) − 1)]
//! ```
//!
//! with q̇ᶜ cold-wall convective and q̇ʳ radiative heat flux in W/m², h in J/kg, T in K, V in m/s, ε the emissivity,
//! σ = 5.670374419e-8 W/(m² K⁴), R in J/(kg K), c₀ the heat capacity of the rigid molecules over R, xᵢ and θᵢ number a molecule and temperature (K)
//! of each vibration of the planet's gas.
//!
//! # Valid
//! A gas that does not dissociate at the wall (air below about 2500 K at an atmosphere; a hotter wall understates h_w, which
//! is conservative). The wall emits all it receives: no conduction, no ablation. A flux below 0 (a wall hotter than
//! the flow) is given as 0.
//!
//! # References
//! - \[samareh-2014\] section 3.4.2 (radiative-equilibrium wall, emissivity 0.85); \[sutton-graves-1972\].

use crate::data::Data;
use numerics::scalar::Scalar;
use serde::{Deserialize, Serialize};

/// Stefan-Boltzmann constant, W/(m² K⁴).
pub const STEFAN_BOLTZMANN_W_M2_K4: f64 = 5.670_374_419e-8;

/// Newton steps of the radiative-equilibrium temperature; each gains more than a factor of twenty.
const STEPS: usize = 8;

/// Wall in convective heating.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Wall {
    /// Cold wall: h_w = 0, as the correlations and the mass-estimating relations have it.
    #[default]
    Cold,
    /// A wall of given temperature.
    Hot {
        /// Wall temperature, K.
        temperature_k: f64,
    },
    /// A wall that radiates what it receives.
    RadiativeEquilibrium {
        /// Emissivity of the wall.
        emissivity: f64,
    },
}

/// The file `heating/hot-wall.toml`.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(rename = "source")]
    _source: String,
    #[serde(rename = "place")]
    _place: String,
    #[serde(rename = "note")]
    _note: String,
    wall_emissivity: f64,
    gas: Vec<Gas>,
}

/// The gas at the wall, and before the shock, on some planets.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct Gas {
    planets: Vec<String>,
    gas_constant_j_kg_k: f64,
    /// Heat capacity at constant pressure without vibration over the gas constant.
    rigid_heat_capacity_ratio: f64,
    /// Temperature before the shock, K.
    free_stream_temperature_k: f64,
    vibration: Vec<Vibration>,
}

impl Gas {
    fn check(&self) -> Result<(), String> {
        let modes = self.vibration.iter().map(|mode| mode.temperature_k);
        let positive = [
            ("gas_constant_j_kg_k", self.gas_constant_j_kg_k),
            ("rigid_heat_capacity_ratio", self.rigid_heat_capacity_ratio),
            ("free_stream_temperature_k", self.free_stream_temperature_k),
        ];
        let modes = modes.map(|temperature_k| ("vibration.temperature_k", temperature_k));
        let fractions = self.vibration.iter().map(|mode| mode.fraction);
        let fractions = fractions.map(|fraction| ("vibration.fraction", fraction));
        match positive
            .into_iter()
            .chain(modes)
            .chain(fractions)
            .find(|(_, value)| !(*value > 0.0 && value.is_finite()))
        {
            Some((key, value)) => Err(format!("{key}: got {value}, must be above 0")),
            None => Ok(()),
        }
    }
}

/// The gas at the wall of a planet.
#[derive(Clone, Debug, PartialEq)]
pub struct WallGas {
    /// Emissivity of the wall where none is given.
    pub wall_emissivity: f64,
    gas: Gas,
}

/// Molecular vibration, weighted by its fraction per mole of the gas.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct Vibration {
    fraction: f64,
    temperature_k: f64,
}

/// Stagnation-point heating on a cold wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColdWall<S> {
    /// Convective heat flux, W/m².
    pub convective_w_m2: S,
    /// Radiative heat flux, W/m².
    pub radiative_w_m2: S,
    /// Speed relative to the air, m/s.
    pub speed_m_s: S,
}

/// Temperature at which a wall of `emissivity` radiates `heat_flux_w_m2`, K.
#[inline]
pub fn radiating_temperature_k<S: Scalar>(heat_flux_w_m2: S, emissivity: f64) -> S {
    (heat_flux_w_m2 / (emissivity * STEFAN_BOLTZMANN_W_M2_K4))
        .sqrt()
        .sqrt()
}

impl WallGas {
    /// Reads the gas of `planet` from the text of `heating/hot-wall.toml`.
    pub fn parse(data: Data, planet: &str) -> Result<Self, String> {
        super::of_planet(Self::all(data)?, planet)
            .ok_or_else(|| format!("no gas at the wall for planet `{planet}`"))
    }

    /// Reads all gases of such a file, each with the names of its planets.
    pub fn all(data: Data) -> Result<Vec<(Vec<String>, Self)>, String> {
        let file: File = data.read()?;
        let wall_emissivity = file.wall_emissivity;
        if !(wall_emissivity > 0.0 && wall_emissivity <= 1.0) {
            return Err(format!(
                "wall_emissivity: got {wall_emissivity}, must be above 0 and at most 1"
            ));
        }
        file.gas
            .into_iter()
            .map(|gas| {
                gas.check()?;
                let planets = gas.planets.clone();
                Ok((
                    planets,
                    Self {
                        wall_emissivity,
                        gas,
                    },
                ))
            })
            .collect()
    }

    /// The hot wall in the air of a case: with another gas constant, J/(kg K), and, where given, another ratio of heat
    /// capacities, which then holds at every temperature.
    pub fn in_air(mut self, gas_constant_j_kg_k: f64, heat_capacity_ratio: Option<f64>) -> Self {
        self.gas.gas_constant_j_kg_k = gas_constant_j_kg_k;
        if let Some(gamma) = heat_capacity_ratio {
            // c_p/R = γ/(γ − 1)
            self.gas.rigid_heat_capacity_ratio = gamma / (gamma - 1.0);
            self.gas.vibration.clear();
        }
        self
    }

    /// Gas constant, J/(kg K).
    pub fn gas_constant_j_kg_k(&self) -> f64 {
        self.gas.gas_constant_j_kg_k
    }

    /// Enthalpy at a temperature in K, J/kg.
    #[inline]
    pub fn enthalpy_j_kg<S: Scalar>(&self, temperature_k: S) -> S {
        let t = temperature_k;
        let mut sum = t * self.gas.rigid_heat_capacity_ratio;
        for mode in &self.gas.vibration {
            let theta = S::constant(mode.temperature_k);
            sum += theta * mode.fraction / ((theta / t).exp() - 1.0);
        }
        sum * self.gas.gas_constant_j_kg_k
    }

    /// Total enthalpy of the flow at a speed in m/s, J/kg.
    #[inline]
    pub fn total_enthalpy_j_kg<S: Scalar>(&self, speed_m_s: S) -> S {
        speed_m_s * speed_m_s * 0.5
            + self.enthalpy_j_kg(S::constant(self.gas.free_stream_temperature_k))
    }

    /// Temperature of a wall that radiates what it receives, K; 1 K where it receives nothing.
    pub fn radiative_equilibrium_temperature_k<S: Scalar>(
        &self,
        heating: &ColdWall<S>,
        emissivity: f64,
    ) -> S {
        let ColdWall {
            convective_w_m2: q_c,
            radiative_w_m2: q_r,
            speed_m_s,
        } = *heating;
        let h_0 = self.total_enthalpy_j_kg(speed_m_s);
        let emission = emissivity * STEFAN_BOLTZMANN_W_M2_K4;
        let floor = S::constant(1.0);
        let vibrations: f64 = self.gas.vibration.iter().map(|mode| mode.fraction).sum();
        let most = self.gas.rigid_heat_capacity_ratio + vibrations;
        let mut t = radiating_temperature_k(q_c + q_r, emissivity).max(floor);
        for _ in 0..STEPS {
            // F(T) = ε σ T⁴ + q̇ᶜ h_w/h₀ − q̇ᶜ − q̇ʳ, with R (c₀ + Σ xᵢ) ≥ dh/dT for its slope: descends to the root from above
            let cubed = t * t * t;
            let excess = cubed * t * emission + q_c * (self.enthalpy_j_kg(t) / h_0) - q_c - q_r;
            let slope =
                cubed * (4.0 * emission) + q_c * (most * self.gas.gas_constant_j_kg_k) / h_0;
            t = (t - excess / slope).max(floor);
        }
        t
    }

    /// Convective heat flux to the wall, W/m².
    #[inline]
    pub fn convective_w_m2<S: Scalar>(&self, wall: Wall, heating: &ColdWall<S>) -> S {
        let t_w = match wall {
            Wall::Cold => return heating.convective_w_m2,
            Wall::Hot { temperature_k } => S::constant(temperature_k),
            Wall::RadiativeEquilibrium { emissivity } => {
                self.radiative_equilibrium_temperature_k(heating, emissivity)
            }
        };
        // q̇ᶜ (1 − h_w/h₀)
        let ratio = self.enthalpy_j_kg(t_w) / self.total_enthalpy_j_kg(heating.speed_m_s);
        heating.convective_w_m2 * (S::constant(1.0) - ratio).max(S::constant(0.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn air() -> WallGas {
        WallGas::parse(
            include_str!("../../data/heating/hot-wall.toml").into(),
            "earth",
        )
        .unwrap()
    }

    #[test]
    fn black_wall_at_1000_k_radiates_56704_w_m2() {
        assert!((radiating_temperature_k(56_703.744_19, 1.0) - 1000.0_f64).abs() < 1e-9);
    }

    #[test]
    fn enthalpy_of_air_is_that_of_the_gas_tables() {
        // Keenan & Kaye: 300 K 300.19 kJ/kg, 1000 K 1046.04 kJ/kg, 2000 K 2252.1 kJ/kg; 0.5 % is the harmonic oscillator's
        for (t, h) in [(300.0, 300.19e3), (1000.0, 1046.04e3), (2000.0, 2252.1e3)] {
            let ours: f64 = air().enthalpy_j_kg(t);
            assert!((ours / h - 1.0).abs() < 5e-3, "{t} K: {ours} against {h}");
        }
    }

    #[test]
    fn enthalpy_of_carbon_dioxide_and_of_hydrogen_is_that_of_the_gas_tables() {
        // A harmonic oscillator is within 1 %. JANAF, h(1000 K) − h(298.15 K): CO2 33.397 kJ/mol, N2 21.463; H2 20.680; He 5/2 R 701.85 K = 14.588.
        // Venus: (0.965 · 33.397 + 0.035 · 21.463)/43.45 g; Saturn: (0.94 · 20.680 + 0.06 · 14.588)/2.1352 g
        for (planet, rise_mj_kg) in [("venus", 0.759_0), ("saturn", 9.514)] {
            let text = include_str!("../../data/heating/hot-wall.toml");
            let gas = WallGas::parse(text.into(), planet).unwrap();
            let rise: f64 = gas.enthalpy_j_kg(1000.0) - gas.enthalpy_j_kg(298.15);
            assert!(
                (rise / 1e6 / rise_mj_kg - 1.0).abs() < 1e-2,
                "{planet}: {rise}"
            );
        }
        assert!(
            WallGas::parse(
                include_str!("../../data/heating/hot-wall.toml").into(),
                "pluto"
            )
            .is_err()
        );
    }

    #[test]
    fn a_number_that_is_of_no_gas_is_refused() {
        let shipped = include_str!("../../data/heating/hot-wall.toml");
        for (was, is, said) in [
            (
                "wall_emissivity = 0.85",
                "wall_emissivity = 1.85",
                "wall_emissivity: got 1.85",
            ),
            (
                "fraction = 0.79",
                "fraction = -0.79",
                "vibration.fraction: got -0.79",
            ),
            (
                "temperature_k = 3390.0",
                "temperature_k = nan",
                "vibration.temperature_k: got NaN",
            ),
        ] {
            let fault = WallGas::all(shipped.replacen(was, is, 1).as_str().into()).unwrap_err();
            assert!(fault.contains(said), "{fault}");
        }
    }

    #[test]
    fn another_air_has_its_own_enthalpy() {
        // argon: R = 208.13 J/(kg K), γ = 5/3, c_p = 2.5 R: 1000 K are 520.3 kJ/kg
        let argon: f64 = air().in_air(208.13, Some(5.0 / 3.0)).enthalpy_j_kg(1000.0);
        assert!((argon / 520.325e3 - 1.0).abs() < 1e-12, "{argon}");
        // the same molecules, twice as heavy
        let heavy: f64 = air().in_air(0.5 * 287.053, None).enthalpy_j_kg(1000.0);
        assert!((heavy / (0.5 * air().enthalpy_j_kg(1000.0)) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn equilibrium_wall_emits_what_it_receives() {
        for (q_c, q_r, v) in [
            (1e7, 2e6, 12e3),
            (5e5, 0.0, 4e3),
            (1e4, 0.0, 1.5e3),
            (6e7, 5e7, 16e3),
        ] {
            let heating = ColdWall {
                convective_w_m2: q_c,
                radiative_w_m2: q_r,
                speed_m_s: v,
            };
            let t: f64 = air().radiative_equilibrium_temperature_k(&heating, 0.85);
            let received = air()
                .convective_w_m2(Wall::RadiativeEquilibrium { emissivity: 0.85 }, &heating)
                + q_r;
            let emitted = 0.85 * STEFAN_BOLTZMANN_W_M2_K4 * t * t * t * t;
            assert!(
                (emitted / received - 1.0).abs() < 1e-10,
                "{v} m/s: {emitted} against {received}"
            );
        }
    }

    #[test]
    fn a_wall_without_heating_is_at_the_floor_and_a_hotter_wall_takes_nothing() {
        let none = ColdWall {
            convective_w_m2: 0.0,
            radiative_w_m2: 0.0,
            speed_m_s: 0.0,
        };
        assert_eq!(air().radiative_equilibrium_temperature_k(&none, 0.85), 1.0);
        let slow = ColdWall {
            convective_w_m2: 100.0,
            radiative_w_m2: 0.0,
            speed_m_s: 300.0,
        };
        assert_eq!(
            air().convective_w_m2(
                Wall::Hot {
                    temperature_k: 2000.0
                },
                &slow
            ),
            0.0
        );
    }

    #[test]
    fn wall_of_300_k_at_10_km_s_takes_a_little_over_half_a_percent_off() {
        // h_w = 0.3012 MJ/kg, h₀ = 50 + 0.251 = 50.251 MJ/kg: factor 1 − 0.00599
        let heating = ColdWall {
            convective_w_m2: 1.0,
            radiative_w_m2: 0.0,
            speed_m_s: 1e4,
        };
        let factor: f64 = air().convective_w_m2(
            Wall::Hot {
                temperature_k: 300.0,
            },
            &heating,
        );
        assert!((1.0 - factor - 0.005_995).abs() < 1e-5, "{factor}");
    }
}
