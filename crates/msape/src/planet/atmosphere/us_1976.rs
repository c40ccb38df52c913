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
//! Density is looked up in cubic Hermite cells through knots of the definition (relative error below 2e-10 to 86 km,
//! 3e-7 above), so that no elementary function is called per step; beyond its ends a piece goes on by its own formula.
//!
//! with z in m, ρ in kg/m³, p in Pa, T in K, M in kg/kmol, a in m/s, mean free path L in m.
//!
//! # Valid
//! −5 to 1000 km. The document gives a speed of sound to 86 km only; above it is formal.
//!
//! # References
//! - \[coesa-1976\].

pub mod definition;
pub mod hermite;
pub mod heterosphere;
pub mod lower;
pub mod temperature;

use super::Air;
use definition::Definition;
use hermite::{Cubic, Curve, Knot};
use heterosphere::{Heterosphere, SPANS, Span, SpanKnots};
use lower::{Layer, Lower};
use numerics::math;
use numerics::scalar::Scalar;
use temperature::{Segment, StandardTemperature, Upper};

/// Distance of the knots below 86 km, m.
const LOWER_CELL_M: f64 = 100.0;

/// The standard atmosphere, ready for use.
#[derive(Clone, Debug, PartialEq)]
pub struct UsStandard1976 {
    temperature: StandardTemperature,
    pieces: Vec<Piece>,
    boundaries_m: Vec<f64>,
    gas: Gas,
}

/// One smooth piece.
#[derive(Clone, Debug, PartialEq)]
struct Piece {
    density: Curve,
    kind: Kind,
}

#[derive(Clone, Debug, PartialEq)]
enum Kind {
    Lower(Layer),
    Upper {
        segment: Segment,
        molar_mass: Curve,
        ends: [End; 2],
    },
}

/// The state at one end of an upper piece.
#[derive(Clone, Copy, Debug, PartialEq)]
struct End {
    altitude_m: f64,
    density: Knot,
    molar_mass: Knot,
}

/// What the equation of state needs.
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

impl Piece {
    fn lower(layer: &Layer, from_m: f64, to_m: f64) -> Self {
        let cells = ((to_m - from_m) / LOWER_CELL_M) as usize + 1;
        let cell_m = (to_m - from_m) / cells as f64;
        let knots: Vec<Knot> = (0..=cells)
            .map(|i| layer.density(from_m + i as f64 * cell_m))
            .collect();
        Self {
            density: Curve::new(from_m, cell_m, &knots),
            kind: Kind::Lower(layer.clone()),
        }
    }

    fn upper(span: &Span, knots: &SpanKnots) -> Option<Self> {
        let end = |altitude_m, density: Option<&Knot>, molar_mass: Option<&Knot>| {
            Some(End {
                altitude_m,
                density: *density?,
                molar_mass: *molar_mass?,
            })
        };
        let low = end(span.from_m, knots.density.first(), knots.molar_mass.first())?;
        let high = end(span.to_m, knots.density.last(), knots.molar_mass.last())?;
        Some(Self {
            density: Curve::new(span.from_m, span.cell_m, &knots.density),
            kind: Kind::Upper {
                segment: span.segment,
                molar_mass: Curve::new(span.from_m, span.cell_m, &knots.molar_mass),
                ends: [low, high],
            },
        })
    }

    /// What goes on above this piece for ever: its last slope of ln ρ and its last molar mass.
    fn exosphere(&self) -> Option<Self> {
        let Kind::Upper {
            segment,
            ends: [_, high],
            ..
        } = &self.kind
        else {
            return None;
        };
        let end = End {
            molar_mass: Knot {
                slope_per_m: 0.0,
                ..high.molar_mass
            },
            ..*high
        };
        let nothing = Curve::new(high.altitude_m, 1.0, &[]);
        let kind = Kind::Upper {
            segment: *segment,
            molar_mass: nothing.clone(),
            ends: [end, end],
        };
        Some(Self {
            density: nothing,
            kind,
        })
    }

    /// Density, kg/m³.
    #[inline]
    fn density_kg_m3<S: Scalar>(&self, altitude_m: S) -> S {
        let cubic = altitude_m.lookup(|z| {
            self.density
                .cubic(z)
                .unwrap_or_else(|| self.density_beyond(z))
        });
        hermite::value(altitude_m, cubic)
    }

    /// The line through the density beyond the ends: the layer's own formula, or the last slope of ln ρ.
    #[cold]
    fn density_beyond(&self, altitude_m: f64) -> Cubic {
        match &self.kind {
            Kind::Lower(layer) => hermite::line(altitude_m, layer.density(altitude_m)),
            Kind::Upper { ends, .. } => {
                let End {
                    altitude_m: z_0,
                    density,
                    ..
                } = nearer(ends, altitude_m);
                let rate = density.slope_per_m / density.value;
                let value = density.value * math::exp(rate * (altitude_m - z_0));
                hermite::line(
                    altitude_m,
                    Knot {
                        value,
                        slope_per_m: value * rate,
                    },
                )
            }
        }
    }
}

fn nearer(ends: &[End; 2], altitude_m: f64) -> End {
    let [low, high] = *ends;
    if altitude_m < high.altitude_m {
        low
    } else {
        high
    }
}

impl UsStandard1976 {
    /// Lowest and highest altitude of the definition, m.
    pub const VALID_M: (f64, f64) = (-5_000.0, 1_000_000.0);

    /// The atmosphere of the data file `us-1976.toml`.
    pub fn parse(text: &str) -> Result<Self, String> {
        Ok(Self::new(&Definition::parse(text)?))
    }

    /// The atmosphere of a definition; integrates the heterosphere.
    pub fn new(definition: &Definition) -> Self {
        let c = &definition.constants;
        let temperature = StandardTemperature {
            lower: Lower::new(definition),
            upper: Upper::new(definition),
        };
        let mut boundaries_m: Vec<f64> = Vec::new();
        let mut pieces = Vec::new();
        for (layer, top_m) in temperature
            .lower
            .layers
            .iter()
            .zip(&temperature.lower.tops_m)
        {
            let from_m = boundaries_m.last().copied().unwrap_or(Self::VALID_M.0);
            pieces.push(Piece::lower(layer, from_m, *top_m));
            boundaries_m.push(*top_m);
        }
        for (span, knots) in SPANS
            .iter()
            .zip(Heterosphere::new(definition, &temperature.upper).knots())
        {
            pieces.extend(Piece::upper(span, &knots));
            boundaries_m.push(span.to_m);
        }
        let exosphere = pieces.last().and_then(Piece::exosphere);
        pieces.extend(exosphere);
        let gas = Gas {
            heat_capacity_ratio: c.heat_capacity_ratio,
            gas_constant_j_kmol_k: c.gas_constant_j_kmol_k,
            pressure_constant_j_kmol_k: c.avogadro_per_kmol * c.boltzmann_j_k,
            sea_level_molar_mass_kg_kmol: c.sea_level_molar_mass_kg_kmol,
            mean_free_path_constant: lower::mean_free_path_constant(definition),
        };
        Self {
            temperature,
            pieces,
            boundaries_m,
            gas,
        }
    }

    /// Temperature of this atmosphere by altitude, for models that bring a density only.
    pub fn standard_air(&self) -> super::StandardAir {
        super::StandardAir {
            temperature: self.temperature.clone(),
            heat_capacity_ratio: self.gas.heat_capacity_ratio,
            gas_constant_j_kg_k: self.gas.gas_constant_j_kmol_k
                / self.gas.sea_level_molar_mass_kg_kmol,
            mean_free_path_kg_m2: self.gas.mean_free_path_constant
                * self.gas.sea_level_molar_mass_kg_kmol,
        }
    }

    /// Altitudes between the smooth pieces, m, ascending.
    pub fn boundaries_m(&self) -> &[f64] {
        &self.boundaries_m
    }

    #[inline]
    fn piece(&self, layer: usize) -> Option<&Piece> {
        self.pieces.get(layer).or(self.pieces.last())
    }

    /// Density of one piece, kg/m³.
    #[inline]
    pub fn density_in<S: Scalar>(&self, layer: usize, altitude_m: S) -> S {
        self.piece(layer)
            .map_or(S::constant(0.0), |piece| piece.density_kg_m3(altitude_m))
    }

    /// Everything of one piece.
    #[inline]
    pub fn air_in<S: Scalar>(&self, layer: usize, altitude_m: S) -> Air<S> {
        let Gas {
            heat_capacity_ratio,
            gas_constant_j_kmol_k,
            sea_level_molar_mass_kg_kmol: m_0,
            ..
        } = self.gas;
        let density_kg_m3 = self.density_in(layer, altitude_m);
        let (temperature_k, m, r) = match self.piece(layer).map(|piece| &piece.kind) {
            Some(Kind::Lower(layer)) => {
                let ratio = self.temperature.lower.ratio.at(altitude_m);
                (
                    layer.molecular_scale_temperature_k(altitude_m) * ratio,
                    ratio * m_0,
                    gas_constant_j_kmol_k,
                )
            }
            Some(Kind::Upper {
                segment,
                molar_mass,
                ends,
            }) => {
                let cubic = altitude_m.lookup(|z| {
                    molar_mass.cubic(z).unwrap_or_else(|| {
                        let end = nearer(ends, z);
                        hermite::line(end.altitude_m, end.molar_mass)
                    })
                });
                let t = self.temperature.upper.temperature_k(*segment, altitude_m);
                (
                    t,
                    hermite::value(altitude_m, cubic),
                    self.gas.pressure_constant_j_kmol_k,
                )
            }
            None => (S::constant(0.0), S::constant(m_0), gas_constant_j_kmol_k),
        };
        let pressure_pa = density_kg_m3 * temperature_k / m * r;
        Air {
            density_kg_m3,
            pressure_pa,
            temperature_k,
            speed_of_sound_m_s: (temperature_k / m * (heat_capacity_ratio * gas_constant_j_kmol_k))
                .sqrt(),
            mean_free_path_m: lower::mean_free_path_m(
                self.gas.mean_free_path_constant,
                m,
                density_kg_m3,
            ),
        }
    }
}

#[cfg(test)]
mod tests;
