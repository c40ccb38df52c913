//! Number densities of the U.S. Standard Atmosphere 1976 above 86 km, where the gases separate.
//!
//! ```text
//! d ln(nᵢ T)/dz = −(fᵢ + vᵢ)
//! f(N₂) = M g / (R* T)
//! fᵢ = g/(R* T) · D/(D + K) · (Mᵢ + M K/D + αᵢ (R*/g) dT/dz)          O, O₂, Ar, He below 115 km
//! fᵢ = g/(R* T) · (Mᵢ + αᵢ (R*/g) dT/dz)                                above
//! D = aᵢ/N (T/273.15)^bᵢ,   K = 120 exp(1 − 400/(400 − (z − 95)²)) above 95 km
//! ```
//!
//! with n in 1/m³, T in K, z in m (km where the data are), g in m/s², M in kg/kmol, R* in J/(kmol K), D and K in
//! m²/s, φ in 1/(m² s). N is N₂ for O and O₂, N₂ + O + O₂ for Ar and He, everything for H. M is that of sea level to
//! 100 km, above it that of the gases in N (the reading that gives the printed Ar and He at 120 km). v has an integral in closed form, and so has g/T above 120 km:
//!
//! ```text
//! ∫ g/(R* T) dz = g₁₀/(R* T∞) · (ξ + ln(T/T₁₀)/λ)
//! ```
//!
//! The range 86 to 120 km is integrated by classical Runge-Kutta in cells of 125 m.
//!
//! # Valid
//! 86 to 1000 km. Atomic hydrogen is present above 150 km only, as defined, so density there steps up by 3e-7.
//!
//! # References
//! - \[coesa-1976\] equations 5 to 7, 10, 32 to 41, Tables 5 to 7.

mod flux;
mod hydrogen;
mod sums;

use crate::Knot;
use crate::definition::Definition;
use crate::temperature::{Segment, Upper, Z10_M};
use flux::{FLUX_TOP_KM, FluxIntegral, flux_per_m};
use numerics::math;
use sums::Sums;

/// Gases that are followed from 86 km: N₂, O, O₂, Ar, He.
const HEAVY: usize = 5;
/// Above this K vanishes, km.
const EDDY_TOP_KM: f64 = 115.0;
/// z₁₁, m.
const Z11_M: f64 = 500_000.0;
/// Cells and Runge-Kutta steps, m; the curvature of ln ρ is largest below 110 km, where the ellipse of T is steep.
const CELL_86_TO_120_M: f64 = 125.0;

/// One smooth piece of the heterosphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Lower end, m.
    pub from_m: f64,
    /// Upper end, m.
    pub to_m: f64,
    /// Formula of the temperature.
    pub segment: Segment,
    /// Distance of the knots, m.
    pub cell_m: f64,
}

/// The smooth pieces, upward.
pub const SPANS: [Span; 7] = [
    Span {
        from_m: 86e3,
        to_m: 91e3,
        segment: Segment::Isothermal,
        cell_m: CELL_86_TO_120_M,
    },
    Span {
        from_m: 91e3,
        to_m: 100e3,
        segment: Segment::Ellipse,
        cell_m: CELL_86_TO_120_M,
    },
    Span {
        from_m: 100e3,
        to_m: 110e3,
        segment: Segment::Ellipse,
        cell_m: CELL_86_TO_120_M,
    },
    Span {
        from_m: 110e3,
        to_m: Z10_M,
        segment: Segment::Linear,
        cell_m: CELL_86_TO_120_M,
    },
    Span {
        from_m: Z10_M,
        to_m: 150e3,
        segment: Segment::Exponential,
        cell_m: 500.0,
    },
    Span {
        from_m: 150e3,
        to_m: Z11_M,
        segment: Segment::Exponential,
        cell_m: 1000.0,
    },
    Span {
        from_m: Z11_M,
        to_m: 1e6,
        segment: Segment::Exponential,
        cell_m: 5000.0,
    },
];

/// ln(nᵢ T), nᵢ in 1/m³ and T in K, without the part of v.
type Logs = [f64; HEAVY];

/// The equations with their data.
pub struct Heterosphere<'a> {
    definition: &'a Definition,
    upper: &'a Upper,
    /// Flux integrals of the gases followed from 86 km.
    fluxes: Vec<FluxIntegral<'a>>,
    r_0: f64,
    start: Logs,
    at_120_km: Logs,
}

/// Terms of the equations at one altitude that do not depend on the densities.
struct Place {
    /// Altitude, m.
    z: f64,
    /// Temperature, K, and dT/dz, K/m.
    t: f64,
    gradient: f64,
    /// Gravity, m/s².
    g: f64,
    /// Eddy diffusion, m²/s.
    eddy: f64,
    /// ∫ v dz.
    transported: Logs,
    /// (T/273.15)^b of the diffusion; left out where nothing mixes.
    diffusion: Logs,
}

/// Density, kg/m³, and molar mass, kg/kmol, at the knots of one span.
pub struct SpanKnots {
    /// ρ and its slope.
    pub density: Vec<Knot>,
    /// M and its slope.
    pub molar_mass: Vec<Knot>,
}

impl<'a> Heterosphere<'a> {
    /// The equations, from the state at 86 km.
    pub fn new(definition: &'a Definition, upper: &'a Upper) -> Self {
        let t_7 = upper.temperature_k(Segment::Isothermal, 86e3);
        let mut start = [0.0; HEAVY];
        for (log, species) in start.iter_mut().zip(&definition.species) {
            *log = math::ln(species.at_86_km_per_m3 * t_7);
        }
        let r_0 = definition.constants.earth_radius_km * 1000.0;
        Self {
            definition,
            upper,
            fluxes: definition
                .species
                .iter()
                .take(HEAVY)
                .map(FluxIntegral::new)
                .collect(),
            r_0,
            start,
            at_120_km: start,
        }
    }

    /// The knots of all spans, upward.
    pub fn knots(&mut self) -> Vec<SpanKnots> {
        self.knots_of(&SPANS)
    }

    /// The knots of spans that follow each other from 86 km.
    pub fn knots_of(&mut self, all: &[Span]) -> Vec<SpanKnots> {
        let mut spans = Vec::with_capacity(all.len());
        let mut logs = self.start;
        for span in all.iter().filter(|s| s.to_m <= Z10_M) {
            spans.push(self.integrate(span, &mut logs));
        }
        self.at_120_km = logs;
        for span in all.iter().filter(|s| s.to_m > Z10_M) {
            spans.push(self.closed_form(span));
        }
        spans
    }

    fn gravity_m_s2(&self, z: f64) -> f64 {
        let ratio = self.r_0 / (self.r_0 + z);
        self.definition.constants.gravity_m_s2 * ratio * ratio
    }

    fn place(&self, span: &Span, z: f64) -> Place {
        let t = self.upper.temperature_k(span.segment, z);
        let eddy = self.eddy_m2_s(z);
        let mut transported = [0.0; HEAVY];
        for (value, flux) in transported.iter_mut().zip(&self.fluxes) {
            *value = flux.at(z);
        }
        let mut diffusion = [0.0; HEAVY];
        if eddy > 0.0 {
            let ln_t = math::ln(t / 273.15);
            for (value, s) in diffusion.iter_mut().zip(&self.definition.species) {
                *value = math::exp(s.diffusion_b * ln_t);
            }
        }
        Place {
            z,
            t,
            gradient: self.upper.gradient_k_m(span.segment, z),
            g: self.gravity_m_s2(z),
            eddy,
            transported,
            diffusion,
        }
    }

    /// d ln(nᵢ T)/dz without v, 1/m.
    fn slopes(&self, span: &Span, place: &Place, logs: &Logs) -> Logs {
        let Place {
            t,
            gradient,
            g,
            eddy: k,
            ..
        } = *place;
        let r_star = self.definition.constants.gas_constant_j_kmol_k;
        let species = &self.definition.species;
        let m_n2 = species.first().map_or(0.0, |s| s.molar_mass_kg_kmol);
        let m = if span.to_m <= 100e3 {
            self.definition.constants.sea_level_molar_mass_kg_kmol
        } else {
            m_n2
        };
        let with_flux = |i: usize| math::exp(logs[i] - place.transported[i]) / t;
        let [mut n_n2, mut n_major, mut m_major] = [0.0, 0.0, m];
        if k > 0.0 {
            let n = [with_flux(0), with_flux(1), with_flux(2)];
            n_n2 = n[0];
            n_major = n[0] + n[1] + n[2];
            if span.from_m >= 100e3 {
                let mass = |i: usize| species.get(i).map_or(0.0, |s| s.molar_mass_kg_kmol);
                m_major = (n[0] * mass(0) + n[1] * mass(1) + n[2] * mass(2)) / n_major;
            }
        }
        let mut slopes = [0.0; HEAVY];
        for (i, (slope, s)) in slopes.iter_mut().zip(species).enumerate() {
            let mass = s.molar_mass_kg_kmol + s.thermal_diffusion * r_star / g * gradient;
            let mean = if i == 0 {
                m
            } else if k > 0.0 {
                let (background, m) = if i < 3 { (n_n2, m) } else { (n_major, m_major) };
                let d = s.diffusion_a_per_m_s / background * place.diffusion[i];
                (mass * d + m * k) / (d + k)
            } else {
                mass
            };
            *slope = -g / (r_star * t) * mean;
        }
        slopes
    }

    fn eddy_m2_s(&self, z: f64) -> f64 {
        let k = self.definition.diffusion.eddy_m2_s;
        let above = z / 1000.0 - 95.0;
        if above <= 0.0 {
            k
        } else if above < EDDY_TOP_KM - 95.0 {
            k * math::exp(1.0 - 400.0 / (400.0 - above * above))
        } else {
            0.0
        }
    }

    /// Runge-Kutta through one span; `logs` goes from its lower to its upper end.
    fn integrate(&self, span: &Span, logs: &mut Logs) -> SpanKnots {
        let h = span.cell_m;
        let cells = ((span.to_m - span.from_m) / h) as usize;
        let mut knots = SpanKnots {
            density: Vec::with_capacity(cells + 1),
            molar_mass: Vec::with_capacity(cells + 1),
        };
        let mut here = self.place(span, span.from_m);
        for i in 0..=cells {
            let z = here.z;
            let k_1 = self.slopes(span, &here, logs);
            self.sums(&here, logs, &k_1)
                .push(self.definition.constants.avogadro_per_kmol, &mut knots);
            if i == cells {
                break;
            }
            let middle = self.place(span, z + h / 2.0);
            let k_2 = self.slopes(span, &middle, &along(logs, &k_1, h / 2.0));
            let k_3 = self.slopes(span, &middle, &along(logs, &k_2, h / 2.0));
            here = self.place(span, span.from_m + (i + 1) as f64 * h);
            let k_4 = self.slopes(span, &here, &along(logs, &k_3, h));
            for (i, log) in logs.iter_mut().enumerate() {
                *log += h / 6.0 * (k_1[i] + 2.0 * k_2[i] + 2.0 * k_3[i] + k_4[i]);
            }
        }
        knots
    }

    /// ∫ g/(R* T) dz from 120 km, kmol/kg.
    fn gravity_integral(&self, z: f64, t: f64) -> f64 {
        let t_10 = self.upper.temperature_k(Segment::Exponential, Z10_M);
        let Upper {
            exosphere_k: t_inf,
            rate_per_m: lambda,
            ..
        } = *self.upper;
        let r_star = self.definition.constants.gas_constant_j_kmol_k;
        self.gravity_m_s2(Z10_M) / (r_star * t_inf)
            * (self.upper.xi_m(z) + math::ln(t / t_10) / lambda)
    }

    /// ln(nᵢ T) above 120 km without v.
    fn logs_above_120_km(&self, z: f64, t: f64) -> Logs {
        let t_10 = self.upper.temperature_k(Segment::Exponential, Z10_M);
        let integral = self.gravity_integral(z, t);
        let mut logs = self.at_120_km;
        for (log, s) in logs.iter_mut().zip(&self.definition.species) {
            *log -= s.molar_mass_kg_kmol * integral + s.thermal_diffusion * math::ln(t / t_10);
        }
        logs
    }

    fn closed_form(&self, span: &Span) -> SpanKnots {
        let cells = ((span.to_m - span.from_m) / span.cell_m) as usize;
        let mut knots = SpanKnots {
            density: Vec::new(),
            molar_mass: Vec::new(),
        };
        let hydrogen = self.hydrogen(span, cells);
        for i in 0..=cells {
            let z = span.from_m + i as f64 * span.cell_m;
            let place = self.place(span, z);
            let logs = self.logs_above_120_km(z, place.t);
            let mut sums = self.sums(&place, &logs, &self.slopes(span, &place, &logs));
            if let Some((n, slope)) = hydrogen.get(i) {
                let m = self
                    .definition
                    .species
                    .get(HEAVY)
                    .map_or(0.0, |s| s.molar_mass_kg_kmol);
                sums.add(*n, *slope, m);
            }
            sums.push(self.definition.constants.avogadro_per_kmol, &mut knots);
        }
        knots
    }

    fn sums(&self, place: &Place, logs: &Logs, slopes: &Logs) -> Sums {
        let ln_t_slope = place.gradient / place.t;
        let mut sums = Sums::default();
        for (i, s) in self.definition.species.iter().take(HEAVY).enumerate() {
            let n = math::exp(logs[i] - place.transported[i]) / place.t;
            sums.add(
                n,
                n * (slopes[i] - flux_per_m(s, place.z) - ln_t_slope),
                s.molar_mass_kg_kmol,
            );
        }
        sums
    }
}

fn along(logs: &Logs, slopes: &Logs, step_m: f64) -> Logs {
    let mut moved = *logs;
    for (log, slope) in moved.iter_mut().zip(slopes) {
        *log += slope * step_m;
    }
    moved
}
