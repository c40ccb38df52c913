//! One smooth piece of the standard atmosphere: its formulas, and the knots of its rows.
//!
//! ```text
//! below 86 km   ρ of the layer, also beyond its ends
//! above         ln ρ continues beyond the ends with its last slope, M with its last
//! a = √(γ R* T / M)
//! ```
//!
//! with z in m, ρ in kg/m³, T in K, M in kg/kmol, a in m/s.
//!
//! # Valid
//! The piece itself; beyond its ends only as far as an integrator looks ahead.
//!
//! # References
//! - \[coesa-1976\].

use super::hermite::{self, Cubic, Curve};
use super::{Gas, LOWER_CELL_M};
use crate::planet::atmosphere::Piece;
use numerics::math;
use numerics::scalar::{Dual, Single};
use us1976::Knot;
use us1976::heterosphere::{Span, SpanKnots};
use us1976::lower::Layer;
use us1976::temperature::{Segment, StandardTemperature};

/// Rows beyond each end of a piece, for the stages of a step that look across.
const ROWS_BEYOND: usize = 16;

/// A smooth piece.
#[derive(Clone, Debug, PartialEq)]
pub struct Stratum {
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

/// Temperature, K, molar mass, kg/kmol, and the gas constant that belongs to them, J/(kmol K).
pub struct State<S> {
    /// Kinetic temperature, K.
    pub temperature_k: S,
    /// Molar mass, kg/kmol.
    pub molar_mass_kg_kmol: S,
    /// R* below 86 km, N_A k above, J/(kmol K).
    pub gas_constant_j_kmol_k: f64,
}

/// Evenly spaced densities within a piece, from its lower to its upper end.
pub struct Knots {
    first_m: f64,
    cell_m: f64,
    density: Vec<Knot>,
}

impl Stratum {
    /// A layer below 86 km between two altitudes, m.
    pub fn lower(layer: &Layer, from_m: f64, to_m: f64) -> (Self, Knots) {
        let cells = ((to_m - from_m) / LOWER_CELL_M) as usize + 1;
        let cell_m = (to_m - from_m) / cells as f64;
        let density = (0..=cells)
            .map(|i| layer.density(from_m + i as f64 * cell_m))
            .collect();
        let stratum = Self {
            kind: Kind::Lower(layer.clone()),
        };
        let knots = Knots {
            first_m: from_m,
            cell_m,
            density,
        };
        (stratum, knots)
    }

    /// A span above 86 km.
    pub fn upper(span: &Span, knots: SpanKnots) -> Option<(Self, Knots)> {
        let end = |altitude_m, density: Option<&Knot>, molar_mass: Option<&Knot>| {
            Some(End {
                altitude_m,
                density: *density?,
                molar_mass: *molar_mass?,
            })
        };
        let low = end(span.from_m, knots.density.first(), knots.molar_mass.first())?;
        let high = end(span.to_m, knots.density.last(), knots.molar_mass.last())?;
        let stratum = Self {
            kind: Kind::Upper {
                segment: span.segment,
                molar_mass: Curve::new(span.from_m, span.cell_m, &knots.molar_mass),
                ends: [low, high],
            },
        };
        let knots = Knots {
            first_m: span.from_m,
            cell_m: span.cell_m,
            density: knots.density,
        };
        Some((stratum, knots))
    }

    /// Continuation above this piece without end: with its last slope of ln ρ and its last molar mass.
    pub fn exosphere(&self) -> Option<Self> {
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
        let kind = Kind::Upper {
            segment: *segment,
            molar_mass: Curve::new(high.altitude_m, 1.0, &[]),
            ends: [end, end],
        };
        Some(Self { kind })
    }

    /// Density, kg/m³, and its slope, kg/m⁴, beyond the ends.
    pub fn density_beyond(&self, altitude_m: f64) -> Knot {
        match &self.kind {
            Kind::Lower(layer) => layer.density(altitude_m),
            Kind::Upper { ends, .. } => {
                let End {
                    altitude_m: z_0,
                    density,
                    ..
                } = nearer(ends, altitude_m);
                let rate = density.slope_per_m / density.value;
                let value = density.value * math::exp(rate * (altitude_m - z_0));
                Knot {
                    value,
                    slope_per_m: value * rate,
                }
            }
        }
    }

    /// Temperature and composition.
    pub fn state<S: Single>(
        &self,
        temperature: &StandardTemperature,
        gas: &Gas,
        altitude_m: S,
    ) -> State<S> {
        match &self.kind {
            Kind::Lower(layer) => {
                let ratio = temperature.lower.ratio.at(altitude_m);
                State {
                    temperature_k: layer.molecular_scale_temperature_k(altitude_m) * ratio,
                    molar_mass_kg_kmol: ratio * gas.sea_level_molar_mass_kg_kmol,
                    gas_constant_j_kmol_k: gas.gas_constant_j_kmol_k,
                }
            }
            Kind::Upper {
                segment,
                molar_mass,
                ends,
            } => {
                let cubic = altitude_m.lookup(|z| {
                    molar_mass.cubic(z).unwrap_or_else(|| {
                        let end = nearer(ends, z);
                        hermite::line(end.altitude_m, end.molar_mass)
                    })
                });
                State {
                    temperature_k: temperature.upper.temperature_k(*segment, altitude_m),
                    molar_mass_kg_kmol: hermite::value(altitude_m, cubic),
                    gas_constant_j_kmol_k: gas.pressure_constant_j_kmol_k,
                }
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

/// Rows of all pieces, one after the other.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cells {
    /// Density, kg/m³.
    pub density: Vec<Cubic>,
    /// Speed of sound, m/s.
    pub sound: Vec<Cubic>,
}

impl Cells {
    /// Adds the rows of one piece.
    pub fn add(
        &mut self,
        layer: usize,
        stratum: &Stratum,
        knots: &Knots,
        sound_m_s: impl Fn(&Stratum, Dual<1>) -> Dual<1>,
    ) -> Piece<f64> {
        let Knots {
            first_m,
            cell_m,
            density,
        } = knots;
        let first_row = self.density.len();
        let lowest_m = first_m - ROWS_BEYOND as f64 * cell_m;
        let last = density.len().saturating_sub(1);
        let altitude_m = |i: usize| first_m + (i as f64 - ROWS_BEYOND as f64) * cell_m;
        let number = density.len() + 2 * ROWS_BEYOND;
        let densities: Vec<Knot> = (0..number)
            .map(|i| {
                let within = i.checked_sub(ROWS_BEYOND).filter(|i| *i <= last);
                let given = within.and_then(|i| density.get(i)).copied();
                given.unwrap_or_else(|| stratum.density_beyond(altitude_m(i)))
            })
            .collect();
        let sounds: Vec<Knot> = (0..number)
            .map(|i| {
                let sound = sound_m_s(stratum, Dual::variable(altitude_m(i), 0));
                Knot {
                    value: sound.value,
                    slope_per_m: sound.slope[0],
                }
            })
            .collect();
        self.density
            .extend(Curve::new(lowest_m, *cell_m, &densities).into_cells());
        self.sound
            .extend(Curve::new(lowest_m, *cell_m, &sounds).into_cells());
        let rows = self.density.len() - first_row;
        Piece::new(layer, [lowest_m, *cell_m], first_row, rows)
    }
}
