//! The U.S. Standard Atmosphere 1976, from its definition: closed forms to 86 km, integrated gases to 1000 km.
//!
//! ```text
//! to 86 km       ρ(z) of layers of linear temperature
//! 86–1000 km     ρ(z), M(z) of the integrated gases
//! above          ln ρ continued with its last slope
//! p = ρ R* T / M
//! a = √(γ R* T / M),   L = M / (√2 π σ² N_A ρ)
//! ```
//!
//! Density and speed of sound are looked up in cubic Hermite cells through knots of the definition (relative error
//! below 2e-10 to 86 km, 3e-7 above), so that no elementary function is called per step; beyond its ends a piece
//! continues by its own formula.
//!
//! with z in m, ρ in kg/m³, p in Pa, T in K, M in kg/kmol, a in m/s, mean free path L in m.
//!
//! # Valid
//! −5 to 1000 km. The document gives a speed of sound to 86 km only; above it is formal.
//!
//! # References
//! - \[coesa-1976\].

pub mod hermite;
mod stratum;

use super::{Air, Piece};
use crate::data::Data;
use crate::planet::gas::{FreePath, HeatCapacityRatio};
use hermite::Cubic;
use numerics::scalar::{Dual, Mask, Scalar};
use stratum::{Cells, State, Stratum};
use us1976::definition::Definition;
use us1976::heterosphere::{Heterosphere, SPANS, SpanKnots};
use us1976::lower::{self, Lower};
use us1976::temperature::{StandardTemperature, Upper};

/// Gases above 86 km of the shipped definition as the build integrated them, one list for each of [`SPANS`]; `None` for
/// any other definition.
#[cfg(feature = "prepared-air")]
fn prepared_gases(data: Data) -> Option<Vec<SpanKnots>> {
    // The definition, and at each knot density, kg/m³, and its slope, molar mass, kg/kmol, and its slope.
    static SHIPPED: (&str, &[&[[f64; 4]]]) = include!(concat!(env!("OUT_DIR"), "/us_1976.rs"));
    let (definition, spans) = SHIPPED;
    let knot = |value, slope_per_m| us1976::Knot { value, slope_per_m };
    let of_span = |knots: &&[[f64; 4]]| SpanKnots {
        density: knots
            .iter()
            .map(|[rho, slope, ..]| knot(*rho, *slope))
            .collect(),
        molar_mass: knots
            .iter()
            .map(|[.., m, slope]| knot(*m, *slope))
            .collect(),
    };
    let is_this = matches!(data, Data::Shipped(text) if text == definition);
    is_this.then(|| spans.iter().map(of_span).collect())
}

/// No prepared gases: they are integrated at the start.
#[cfg(not(feature = "prepared-air"))]
fn prepared_gases(_: Data) -> Option<Vec<SpanKnots>> {
    None
}

/// Distance of the knots below 86 km, m.
const LOWER_CELL_M: f64 = 100.0;

/// The standard atmosphere, ready for use.
#[derive(Clone, Debug, PartialEq)]
pub struct UsStandard1976 {
    temperature: StandardTemperature,
    strata: Vec<Stratum>,
    /// Rows of each stratum.
    pieces: Vec<Piece<f64>>,
    cells: Cells,
    boundaries_m: Vec<f64>,
    gas: Gas,
}

/// Constants of the equation of state.
#[derive(Clone, Debug, PartialEq)]
struct Gas {
    heat_capacity_ratio: f64,
    gas_constant_j_kmol_k: f64,
    /// N_A k, J/(kmol K).
    pressure_constant_j_kmol_k: f64,
    sea_level_molar_mass_kg_kmol: f64,
    /// 1/(√2 π σ² N_A), kmol/m².
    mean_free_path_constant: f64,
}

impl Gas {
    /// Speed of sound, m/s.
    #[inline]
    fn sound_m_s<S: Scalar>(&self, state: &State<S>) -> S {
        let r = self.heat_capacity_ratio * self.gas_constant_j_kmol_k;
        (state.temperature_k / state.molar_mass_kg_kmol * r).sqrt()
    }
}

impl UsStandard1976 {
    /// Lowest and highest altitude of the definition, m.
    pub const VALID_M: (f64, f64) = (-5_000.0, 1_000_000.0);

    /// Title and atmosphere of a data file such as `us-1976.toml`.
    ///
    /// # Errors
    /// Place and key of what cannot be read, lists that do not fit each other.
    pub fn parse(data: Data) -> Result<(String, Self), String> {
        let definition: Definition = data.read()?;
        let definition = definition.checked()?;
        let upper = Upper::new(&definition);
        let gases =
            prepared_gases(data).unwrap_or_else(|| Heterosphere::new(&definition, &upper).knots());
        let atmosphere = Self::new(&definition, upper, gases);
        Ok((definition.title, atmosphere))
    }

    /// The atmosphere of a definition and of its gases above 86 km, one list of knots for each of [`SPANS`].
    fn new(definition: &Definition, upper: Upper, gases: Vec<SpanKnots>) -> Self {
        let c = &definition.constants;
        let lower = Lower::new(definition);
        let temperature = StandardTemperature { lower, upper };
        let gas = Gas {
            heat_capacity_ratio: c.heat_capacity_ratio,
            gas_constant_j_kmol_k: c.gas_constant_j_kmol_k,
            pressure_constant_j_kmol_k: c.avogadro_per_kmol * c.boltzmann_j_k,
            sea_level_molar_mass_kg_kmol: c.sea_level_molar_mass_kg_kmol,
            mean_free_path_constant: lower::mean_free_path_constant(definition),
        };
        let mut boundaries_m: Vec<f64> = Vec::new();
        let mut strata = Vec::new();
        for (layer, top_m) in temperature
            .lower
            .layers
            .iter()
            .zip(&temperature.lower.tops_m)
        {
            let from_m = boundaries_m.last().copied().unwrap_or(Self::VALID_M.0);
            strata.push(Stratum::lower(layer, from_m, *top_m));
            boundaries_m.push(*top_m);
        }
        for (span, knots) in SPANS.iter().zip(gases) {
            strata.extend(Stratum::upper(span, knots));
            boundaries_m.push(span.to_m);
        }
        let mut cells = Cells::default();
        let sound_m_s = |stratum: &Stratum, altitude_m: Dual<1>| {
            gas.sound_m_s(&stratum.state(&temperature, &gas, altitude_m))
        };
        let mut pieces: Vec<Piece<f64>> = (strata.iter().enumerate())
            .map(|(layer, (stratum, knots))| cells.add(layer, stratum, knots, sound_m_s))
            .collect();
        let mut strata: Vec<Stratum> = strata.into_iter().map(|(stratum, _)| stratum).collect();
        let exosphere = strata.last().and_then(Stratum::exosphere);
        pieces.push(Piece::bare(strata.len()));
        strata.extend(exosphere);
        Self {
            temperature,
            strata,
            pieces,
            cells,
            boundaries_m,
            gas,
        }
    }

    /// Air of the composition at sea level with the temperature of this atmosphere, for models that give less.
    pub fn planet_air(&self) -> super::PlanetAir {
        let molar_mass_kg_kmol = self.gas.sea_level_molar_mass_kg_kmol;
        super::PlanetAir {
            temperature: super::OwnTemperature::Standard(self.temperature.clone()),
            gas: crate::planet::gas::Gas {
                heat_capacity_ratio: HeatCapacityRatio::Constant(self.gas.heat_capacity_ratio),
                gas_constant_j_kg_k: self.gas.gas_constant_j_kmol_k / molar_mass_kg_kmol,
                free_path: FreePath::Diameter {
                    times_density_kg_m2: self.gas.mean_free_path_constant * molar_mass_kg_kmol,
                },
            },
        }
    }

    /// Altitudes between the smooth pieces, m, ascending.
    pub fn boundaries_m(&self) -> &[f64] {
        &self.boundaries_m
    }

    /// The piece with an index; the last beyond it.
    pub fn piece(&self, layer: usize) -> Piece<f64> {
        let piece = self.pieces.get(layer).or(self.pieces.last());
        piece.copied().unwrap_or_else(|| Piece::bare(layer))
    }

    fn stratum(&self, layer: usize) -> Option<&Stratum> {
        self.strata.get(layer).or(self.strata.last())
    }

    /// The value by rows; in the lanes beyond the rows that of the formula.
    #[inline]
    fn by_rows<S: Scalar>(
        &self,
        rows: &[Cubic],
        piece: &Piece<S::Value>,
        altitude_m: S,
        beyond: impl Fn(&Stratum, S::Lane) -> S::Lane,
    ) -> S {
        let place = piece.place(altitude_m.value());
        let cubic = place.row.gather(rows).map(S::from_value);
        let value = hermite::value(altitude_m, cubic);
        if place.inside.all() {
            return value;
        }
        self.beyond_rows(value, place.inside, piece, altitude_m, beyond)
    }

    #[cold]
    fn beyond_rows<S: Scalar>(
        &self,
        mut value: S,
        inside: S::Mask,
        piece: &Piece<S::Value>,
        altitude_m: S,
        beyond: impl Fn(&Stratum, S::Lane) -> S::Lane,
    ) -> S {
        for lane in (0..S::LANES).filter(|lane| !inside.lane(*lane)) {
            if let Some(stratum) = self.stratum(piece.lane(lane).layer()) {
                value.set_lane(lane, beyond(stratum, altitude_m.lane(lane)));
            }
        }
        value
    }

    /// Density of one piece, kg/m³.
    #[inline]
    pub fn density_in<S: Scalar>(&self, piece: &Piece<S::Value>, altitude_m: S) -> S {
        self.by_rows(&self.cells.density, piece, altitude_m, |stratum, z| {
            let knot = stratum.density_beyond(z.value());
            (z - z.value()) * knot.slope_per_m + knot.value
        })
    }

    /// Speed of sound of one piece, m/s.
    #[inline]
    pub fn speed_of_sound_in<S: Scalar>(&self, piece: &Piece<S::Value>, altitude_m: S) -> S {
        self.by_rows(&self.cells.sound, piece, altitude_m, |stratum, z| {
            self.gas
                .sound_m_s(&stratum.state(&self.temperature, &self.gas, z))
        })
    }

    /// Everything of one piece.
    pub fn air_in<S: Scalar>(&self, piece: &Piece<S::Value>, altitude_m: S) -> Air<S> {
        let density_kg_m3 = self.density_in(piece, altitude_m);
        let mut air = Air {
            density_kg_m3,
            pressure_pa: density_kg_m3,
            temperature_k: density_kg_m3,
            speed_of_sound_m_s: density_kg_m3,
            heat_capacity_ratio: S::constant(self.gas.heat_capacity_ratio),
            mean_free_path_m: density_kg_m3,
        };
        for lane in 0..S::LANES {
            let Some(stratum) = self.stratum(piece.lane(lane).layer()) else {
                continue;
            };
            let density = density_kg_m3.lane(lane);
            let state = stratum.state(&self.temperature, &self.gas, altitude_m.lane(lane));
            let (temperature, m) = (state.temperature_k, state.molar_mass_kg_kmol);
            let pressure = density * temperature / m * state.gas_constant_j_kmol_k;
            let free_path = lower::mean_free_path_m(self.gas.mean_free_path_constant, m, density);
            air.temperature_k.set_lane(lane, temperature);
            air.pressure_pa.set_lane(lane, pressure);
            air.speed_of_sound_m_s
                .set_lane(lane, self.gas.sound_m_s(&state));
            air.mean_free_path_m.set_lane(lane, free_path);
        }
        air
    }
}

#[cfg(test)]
mod tests;
