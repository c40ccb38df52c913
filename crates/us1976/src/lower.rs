//! The homosphere of the U.S. Standard Atmosphere 1976: layers of linear temperature in hydrostatic balance.
//!
//! ```text
//! h   = r₀ z / (r₀ + z)
//! T_M = T_Mb + L (h − h_b)
//! P   = P_b (T_Mb / T_M)^(g₀ M₀ / (R* L))            L ≠ 0
//! P   = P_b exp(−g₀ M₀ (h − h_b) / (R* T_Mb))        L = 0
//! ρ   = P M₀ / (R* T_M)
//! T   = T_M (M / M₀)
//! ```
//!
//! with z geometric and h geopotential altitude in m, T_M the molecular-scale and T the kinetic temperature in K,
//! L in K/m, P in Pa, ρ in kg/m³, g₀ in m/s², M in kg/kmol, R* in J/(kmol K).
//!
//! # Valid
//! −5 km to 86 km; each layer's formula is smooth beyond its ends.
//!
//! # References
//! - \[coesa-1976\] equations 18, 23, 33a, 33b, 42 and Tables 4 and 8.

use crate::Knot;
use crate::definition::Definition;
use numerics::math;
use numerics::scalar::Scalar;

/// One layer of linear molecular-scale temperature.
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    /// Lower end, geopotential m.
    pub base_geopotential_m: f64,
    /// Molecular-scale temperature at the lower end, K.
    pub base_temperature_k: f64,
    /// Gradient of the molecular-scale temperature, K/m.
    pub gradient_k_m: f64,
    /// Pressure at the lower end, Pa.
    pub base_pressure_pa: f64,
    /// Density at the lower end, kg/m³.
    pub base_density_kg_m3: f64,
    /// g₀ M₀ / R*, K/m.
    pub hydrostatic_k_m: f64,
    /// Effective radius of the Earth, m.
    pub earth_radius_m: f64,
}

/// Geopotential altitude, m.
#[inline]
pub fn geopotential_m<S: Scalar>(earth_radius_m: f64, altitude_m: S) -> S {
    altitude_m * earth_radius_m / (altitude_m + earth_radius_m)
}

impl Layer {
    /// Molecular-scale temperature, K.
    #[inline]
    pub fn molecular_scale_temperature_k<S: Scalar>(&self, altitude_m: S) -> S {
        let h = geopotential_m(self.earth_radius_m, altitude_m);
        (h - self.base_geopotential_m) * self.gradient_k_m + self.base_temperature_k
    }

    /// Density, kg/m³, and its slope, kg/m⁴.
    pub fn density(&self, altitude_m: f64) -> Knot {
        let Self {
            base_temperature_k: t_b,
            gradient_k_m: l,
            hydrostatic_k_m: g_m_r,
            ..
        } = *self;
        let above = geopotential_m(self.earth_radius_m, altitude_m) - self.base_geopotential_m;
        let t = t_b + l * above;
        let pressure_ratio = if l == 0.0 {
            math::exp(-g_m_r * above / t_b)
        } else {
            math::exp(-g_m_r / l * math::ln(t / t_b))
        };
        let rho = self.base_density_kg_m3 * pressure_ratio * t_b / t;
        // dh/dz = (r₀/(r₀ + z))²
        let stretch = self.earth_radius_m / (self.earth_radius_m + altitude_m);
        Knot {
            value: rho,
            slope_per_m: -rho * (g_m_r + l) / t * stretch * stretch,
        }
    }
}

/// Molar mass over that at sea level: one below 80 km, linear in the table to 86 km.
#[derive(Clone, Debug, PartialEq)]
pub struct MolarMassRatio {
    first_m: f64,
    step_m: f64,
    values: Vec<f64>,
}

impl MolarMassRatio {
    /// The ratio M / M₀.
    #[inline]
    pub fn at<S: Scalar>(&self, altitude_m: S) -> S {
        let [z, ratio, slope_per_m] = altitude_m.lookup(|z| self.row(z));
        (altitude_m - z) * slope_per_m + ratio
    }

    fn row(&self, altitude_m: f64) -> [f64; 3] {
        let steps = (altitude_m - self.first_m) / self.step_m;
        if steps <= 0.0 {
            return [self.first_m, 1.0, 0.0];
        }
        let i = (steps as usize).min(self.values.len().saturating_sub(2));
        let (Some(a), Some(b)) = (self.values.get(i), self.values.get(i + 1)) else {
            return [self.first_m, 1.0, 0.0];
        };
        [
            self.first_m + i as f64 * self.step_m,
            *a,
            (b - a) / self.step_m,
        ]
    }
}

/// The layers below 86 km and the molar mass in the last of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Lower {
    /// Layers, upward.
    pub layers: Vec<Layer>,
    /// Upper ends of the layers, geometric m.
    pub tops_m: Vec<f64>,
    /// Molar mass over that at sea level.
    pub ratio: MolarMassRatio,
}

impl Lower {
    /// The layers, their pressures from the balance of the layer below.
    pub fn new(definition: &Definition) -> Self {
        let c = &definition.constants;
        let d = &definition.lower;
        let r_0 = c.earth_radius_km * 1000.0;
        let per_k = c.sea_level_molar_mass_kg_kmol / c.gas_constant_j_kmol_k;
        let geometric = |h: f64| r_0 * h / (r_0 - h);
        let (mut p, mut t) = (c.sea_level_pressure_pa, d.sea_level_temperature_k);
        let (mut layers, mut tops_m) = (Vec::new(), Vec::new());
        for (i, (base, gradient)) in d
            .base_geopotential_km
            .iter()
            .zip(&d.gradient_k_km)
            .enumerate()
        {
            let layer = Layer {
                base_geopotential_m: base * 1000.0,
                base_temperature_k: t,
                gradient_k_m: gradient / 1000.0,
                base_pressure_pa: p,
                base_density_kg_m3: p * per_k / t,
                hydrostatic_k_m: c.gravity_m_s2 * per_k,
                earth_radius_m: r_0,
            };
            let top = d
                .base_geopotential_km
                .get(i + 1)
                .map_or(d.top_altitude_km * 1000.0, |h| geometric(h * 1000.0));
            t = layer.molecular_scale_temperature_k(top);
            p = layer.density(top).value * t / per_k;
            layers.push(layer);
            tops_m.push(top);
        }
        let first_m = d.ratio_altitude_km.first().map_or(0.0, |km| km * 1000.0);
        let step_m = d
            .ratio_altitude_km
            .get(1)
            .map_or(1.0, |km| km * 1000.0 - first_m);
        Self {
            layers,
            tops_m,
            ratio: MolarMassRatio {
                first_m,
                step_m,
                values: d.molar_mass_ratio.clone(),
            },
        }
    }

    /// Constants of [`Self::kinetic_temperature_k`] for the layer that an altitude belongs to.
    fn row(&self, altitude_m: f64) -> [f64; 3] {
        let i = self
            .tops_m
            .partition_point(|top| *top < altitude_m)
            .min(self.layers.len().saturating_sub(1));
        self.layers.get(i).map_or([0.0; 3], |l| {
            [l.base_geopotential_m, l.base_temperature_k, l.gradient_k_m]
        })
    }

    /// Kinetic temperature, K, the layer chosen by the altitude.
    #[inline]
    pub fn kinetic_temperature_k<S: Scalar>(&self, earth_radius_m: f64, altitude_m: S) -> S {
        let [h_b, t_b, gradient] = altitude_m.lookup(|z| self.row(z));
        ((geopotential_m(earth_radius_m, altitude_m) - h_b) * gradient + t_b)
            * self.ratio.at(altitude_m)
    }
}

/// Mean free path, m, of a gas of the given molar mass, kg/kmol, and density, kg/m³.
///
/// ```text
/// L = M / (√2 π σ² N_A ρ)
/// ```
#[inline]
pub fn mean_free_path_m<S: Scalar>(
    per_molar_mass: f64,
    molar_mass_kg_kmol: S,
    density_kg_m3: S,
) -> S {
    molar_mass_kg_kmol * per_molar_mass / density_kg_m3
}

/// 1 / (√2 π σ² N_A), kmol/m².
pub fn mean_free_path_constant(definition: &Definition) -> f64 {
    let sigma = definition.constants.collision_diameter_m;
    1.0 / (2.0_f64.sqrt() * math::PI * sigma * sigma * definition.constants.avogadro_per_kmol)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lower() -> Lower {
        Lower::new(&crate::sample::definition())
    }

    #[test]
    fn pressure_at_the_tropopause_is_22632_pa() {
        // 101325 (288.15 / 216.65)^(−5.255876) = 101325 × 0.2233611
        let p = lower().layers[1].base_pressure_pa;
        assert!((p - 22632.06).abs() < 0.01, "{p}");
    }

    #[test]
    fn a_layer_begins_with_the_density_that_the_layer_below_ends_with() {
        let lower = lower();
        for (i, top) in lower.tops_m.iter().take(6).enumerate() {
            let below = lower.layers[i].density(*top).value;
            let above = lower.layers[i + 1].density(*top).value;
            assert!((below / above - 1.0).abs() < 1e-14, "{top} m");
        }
    }

    #[test]
    fn slope_of_the_density() {
        for layer in &lower().layers[..2] {
            let slope = (layer.density(9_001.0).value - layer.density(8_999.0).value) / 2.0;
            assert!((layer.density(9_000.0).slope_per_m / slope - 1.0).abs() < 1e-7);
        }
    }

    #[test]
    fn molar_mass_half_way_between_85_5_and_86_km_is_the_mean_of_the_two() {
        assert!((lower().ratio.at(85_750.0) - (0.999641 + 0.999579) / 2.0).abs() < 1e-12);
        assert_eq!(lower().ratio.at(79_999.0), 1.0);
    }
}
