//! Energy balance of the wall.
//!
//! ```text
//! C_H' (h_r − h_w) + ṁ_c (h_s − h_w) + ṁ_g (h_g − h_w) + α q_rad − ε σ (T_w⁴ − T_s⁴) = q
//! ```
//!
//! with C_H' in kg/(m² s), h in J/kg, ṁ in kg/(m² s), q in W/m² the conduction into the solid, h_s the enthalpy of the solid at the
//! wall (char once it is charred), T_s the sink in K.
//!
//! # Valid
//! As the chemistry of the wall. Where the boundary layer does not reach the wall only the last two terms are left.
//!
//! # References
//! - \[pato\], \[amar-2006\].

use crate::contact::STEFAN_BOLTZMANN_W_M2K4;
use crate::environment::Heating;
use crate::surface::{Exposure, Surface};

/// Conditions of the run that concern the wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallSettings {
    /// Blowing parameter λ.
    pub blowing: f64,
    /// Whether char is taken away.
    pub recession: bool,
    /// Temperature of the sink to which the wall radiates, K.
    pub sink_temperature_k: f64,
}

/// The solid and the gas at the wall.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct AtWall {
    pub t: f64,
    /// Pyrolysis gas, kg/(m² s).
    pub gas: f64,
    /// Enthalpy of the gas, J/kg, and its slope.
    pub gas_enthalpy: [f64; 2],
    /// Enthalpy of the solid, J/kg, and its slope.
    pub solid_enthalpy: [f64; 2],
    pub emissivity: f64,
    pub absorptivity: f64,
}

/// Heat to the wall and char taken away, each with its slopes over T and ṁ_g.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Balance {
    /// Heat into the solid by all terms but conduction, W/m².
    pub heat: [f64; 3],
    /// Char taken away, kg/(m² s).
    pub char: [f64; 3],
    /// Pyrolysis gas over the transfer coefficient with blowing; none without chemistry.
    pub gas_ratio: Option<f64>,
}

/// The balance without its conduction.
pub(crate) fn balance(
    surface: &Surface,
    settings: &WallSettings,
    heating: &Heating,
    at: &AtWall,
) -> Balance {
    let es = at.emissivity * STEFAN_BOLTZMANN_W_M2K4;
    let (t, sink) = (at.t, settings.sink_temperature_k);
    let fourth = |t: f64| t * t * t * t;
    let mut heat = [
        at.absorptivity * heating.radiative_w_m2 - es * (fourth(t) - fourth(sink)),
        -4.0 * es * t * t * t,
        0.0,
    ];
    let mut char = [0.0; 3];
    let mut gas_ratio = None;
    if heating.chemistry && heating.transfer_kg_m2s > 0.0 {
        let exposure = Exposure {
            pressure_pa: heating.pressure_pa,
            transfer_kg_m2s: heating.transfer_kg_m2s,
            blowing: settings.blowing,
            recession: settings.recession,
        };
        let blown = surface.blown(&exposure, t, at.gas);
        let ([u, u_t, u_m], [h, h_t, h_m]) = (blown.transfer, blown.enthalpy);
        let [c, c_t, c_m] = blown.char;
        let [h_s, h_s_t] = at.solid_enthalpy;
        let [h_g, h_g_t] = at.gas_enthalpy;
        let m_g = at.gas;
        let whole = u + c + m_g;
        heat[0] += u * (heating.recovery_j_kg - h) + c * (h_s - h) + m_g * (h_g - h);
        heat[1] += u_t * (heating.recovery_j_kg - h) + c_t * (h_s - h) + c * h_s_t + m_g * h_g_t
            - whole * h_t;
        heat[2] += u_m * (heating.recovery_j_kg - h) + c_m * (h_s - h) + (h_g - h) - whole * h_m;
        char = blown.char;
        gas_ratio = Some(m_g / u);
    }
    Balance {
        heat,
        char,
        gas_ratio,
    }
}
