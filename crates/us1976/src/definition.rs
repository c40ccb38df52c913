//! Data file of the U.S. Standard Atmosphere 1976 as read: figures and units of the document.

use serde::Deserialize;

/// The whole file.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Definition {
    /// Key under which a case names this atmosphere.
    pub name: String,
    /// Name for people.
    pub title: String,
    /// Key in the bibliography.
    pub source: String,
    /// Place in the source.
    pub place: String,
    /// Note on the figures.
    pub note: String,
    /// Primary constants.
    pub constants: Constants,
    /// Layers below 86 km.
    pub lower: Lower,
    /// Temperature above 86 km.
    pub upper_temperature: UpperTemperature,
    /// Transport above 86 km.
    pub diffusion: Diffusion,
    /// N2, O, O2, Ar, He, H, in this order.
    pub species: Vec<Species>,
}

/// Primary constants.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Constants {
    /// Gas constant R*, J/(kmol K).
    pub gas_constant_j_kmol_k: f64,
    /// Boltzmann constant, J/K.
    pub boltzmann_j_k: f64,
    /// Avogadro number, 1/kmol.
    pub avogadro_per_kmol: f64,
    /// Gravity at sea level, m/s².
    pub gravity_m_s2: f64,
    /// Effective radius of the Earth, km.
    pub earth_radius_km: f64,
    /// Molar mass of air at sea level, kg/kmol.
    pub sea_level_molar_mass_kg_kmol: f64,
    /// Pressure at sea level, Pa.
    pub sea_level_pressure_pa: f64,
    /// Ratio of the heat capacities.
    pub heat_capacity_ratio: f64,
    /// Effective collision diameter, m.
    pub collision_diameter_m: f64,
}

/// Layers below 86 km.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Lower {
    /// Lower ends of the layers, geopotential km.
    pub base_geopotential_km: Vec<f64>,
    /// Gradient of the molecular-scale temperature, K per geopotential km.
    pub gradient_k_km: Vec<f64>,
    /// Temperature at sea level, K.
    pub sea_level_temperature_k: f64,
    /// Upper end of the last layer, geometric km.
    pub top_altitude_km: f64,
    /// Altitudes of the molar-mass ratio, geometric km, equally spaced.
    pub ratio_altitude_km: Vec<f64>,
    /// Molar mass over that at sea level.
    pub molar_mass_ratio: Vec<f64>,
}

/// Temperature above 86 km.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct UpperTemperature {
    /// 86 to 91 km, K.
    pub isothermal_k: f64,
    /// Center of the ellipse, K.
    pub ellipse_centre_k: f64,
    /// Axis of the ellipse in temperature, K.
    pub ellipse_axis_k: f64,
    /// Axis of the ellipse in altitude, km.
    pub ellipse_axis_km: f64,
    /// Temperature at 110 km, K.
    pub linear_base_k: f64,
    /// 110 to 120 km, K/km.
    pub linear_gradient_k_km: f64,
    /// Temperature at 120 km, K.
    pub exponential_base_k: f64,
    /// Limit far above, K.
    pub exosphere_k: f64,
    /// Rate λ, 1/km.
    pub exponential_rate_per_km: f64,
}

/// Transport above 86 km.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Diffusion {
    /// Eddy-diffusion coefficient to 95 km, m²/s.
    pub eddy_m2_s: f64,
    /// Vertical flux of atomic hydrogen, 1/(m² s).
    pub flux_of_h_per_m2_s: f64,
    /// Number density of atomic hydrogen at 500 km, 1/m³.
    pub h_at_500_km_per_m3: f64,
}

/// One gas above 86 km; what a gas has not got is zero.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Species {
    /// Chemical formula.
    pub name: String,
    /// Molar mass, kg/kmol.
    pub molar_mass_kg_kmol: f64,
    /// Number density at 86 km, 1/m³.
    pub at_86_km_per_m3: f64,
    /// Thermal-diffusion coefficient α.
    pub thermal_diffusion: f64,
    /// Coefficient a of molecular diffusion, 1/(m s).
    pub diffusion_a_per_m_s: f64,
    /// Exponent b of molecular diffusion.
    pub diffusion_b: f64,
    /// Coefficient Q of the vertical flux, 1/km³.
    pub q_capital_per_km3: f64,
    /// Altitude U of the vertical flux, km.
    pub u_capital_km: f64,
    /// Coefficient W of the vertical flux, 1/km³.
    pub w_capital_per_km3: f64,
    /// Coefficient q of the flux below u, 1/km³.
    pub q_small_per_km3: f64,
    /// Altitude u, km.
    pub u_small_km: f64,
    /// Coefficient w of the flux below u, 1/km³.
    pub w_small_per_km3: f64,
}

impl Definition {
    /// The definition, after a check of everything that the code relies on.
    ///
    /// # Errors
    /// The lists that do not fit each other.
    pub fn checked(self) -> Result<Self, String> {
        let Lower {
            base_geopotential_km: bases,
            gradient_k_km,
            ratio_altitude_km,
            molar_mass_ratio,
            ..
        } = &self.lower;
        if bases.is_empty() || bases.len() != gradient_k_km.len() {
            return Err("lower: one gradient_k_km for each base_geopotential_km".into());
        }
        if ratio_altitude_km.len() < 2 || ratio_altitude_km.len() != molar_mass_ratio.len() {
            return Err(
                "lower: one molar_mass_ratio for each ratio_altitude_km, at least two".into(),
            );
        }
        let names: Vec<&str> = self.species.iter().map(|s| s.name.as_str()).collect();
        if names != ["N2", "O", "O2", "Ar", "He", "H"] {
            return Err(format!(
                "species: {names:?}, must be N2, O, O2, Ar, He, H in this order"
            ));
        }
        Ok(self)
    }
}
