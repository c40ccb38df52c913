//! Pressure by Newton's impact theory, in its original form and as modified by Lees.
//!
//! ```text
//! C_p = C_p,max sin² δ  where the air meets the surface,  0 elsewhere
//! C_p,max = (p₀₂/p − 1)/(γ M²/2)
//! p₀₂/p = [(γ + 1)² M²/(4 γ M² − 2 (γ − 1))]^(γ/(γ − 1)) [2 γ M² − (γ − 1)]/(γ + 1)      M ≥ 1
//! p₀/p  = [1 + (γ − 1)/2 M²]^(γ/(γ − 1))                                                M < 1
//! ```
//!
//! with δ the angle between air and surface in rad, M the Mach number, γ the ratio of specific heats; p₀₂ the pressure behind a normal
//! shock brought to rest, in the unit of the free stream's p. C_p,max = 2 is Newton's own.
//!
//! # Valid
//! Hypersonic flow, blunt bodies, continuum. Below Mach 1 the factor is that of isentropic stagnation.
//!
//! # References
//! - \[anderson-2006\] sections 3.2 and 3.3 (Newton, modified Newton); \[ames-1953\] equation 100 (Rayleigh's pitot formula).

use numerics::math::pow;

/// Newton's own pressure coefficient at a surface normal to the flow.
pub const STRAIGHT_NEWTON: f64 = 2.0;

/// Pressure coefficient of the stagnation point at a Mach number.
pub fn pressure_coefficient_max(mach: f64, gamma: f64) -> f64 {
    let m2 = mach * mach;
    if m2 < 1e-6 {
        // 1 + M²/4 + …
        return 1.0 + 0.25 * m2;
    }
    let exponent = gamma / (gamma - 1.0);
    let ratio = if mach < 1.0 {
        pow(1.0 + 0.5 * (gamma - 1.0) * m2, exponent)
    } else {
        let rayleigh =
            (gamma + 1.0) * (gamma + 1.0) * m2 / (4.0 * gamma * m2 - 2.0 * (gamma - 1.0));
        pow(rayleigh, exponent) * (2.0 * gamma * m2 - (gamma - 1.0)) / (gamma + 1.0)
    };
    (ratio - 1.0) / (0.5 * gamma * m2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pitot_pressure_at_mach_1_2_and_far_beyond() {
        // \[ames-1953\] tables: p₀₂/p = 1.8929 at Mach 1 and 5.6404 at Mach 2, so 1.2756 and 1.6573
        assert!((pressure_coefficient_max(1.0, 1.4) - 0.8929 / 0.7).abs() < 1e-4);
        assert!((pressure_coefficient_max(2.0, 1.4) - 4.6404 / 2.8).abs() < 1e-4);
        // limit [(γ + 1)²/(4γ)]^(γ/(γ−1)) 4/(γ + 1) = 1.8394
        assert!((pressure_coefficient_max(1e4, 1.4) - 1.8394).abs() < 1e-4);
        assert!((pressure_coefficient_max(1e-9, 1.4) - 1.0).abs() < 1e-12);
        assert!(
            (pressure_coefficient_max(1.0 - 1e-12, 1.4) - pressure_coefficient_max(1.0, 1.4)).abs()
                < 1e-9
        );
    }
}
