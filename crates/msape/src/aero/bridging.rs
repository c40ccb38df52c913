//! Bridging from continuum to free-molecular flow by the Knudsen number.
//!
//! ```text
//! C = C_c + (C_fm − C_c) w
//! sine squared:    w = sin²[π (3/8 + log₁₀ Kn/8)]            Kn kept within 10⁻³…10
//! error function:  w = ½ {1 + erf[√π log₁₀(Kn/0.1)/Δ]}       Δ = 8/π
//! ```
//!
//! with Kn the mean free path of the undisturbed air over the diameter. Both are one half at Kn = 0.1 with the same slope; the error
//! function reaches its ends only at infinity.
//!
//! # Valid
//! Blunt bodies at hypersonic speed.
//!
//! # References
//! - \[wilmoth-1999\] (sine squared, 10⁻³ to 10 for Stardust); \[samareh-2014\] section 3.3 (the same ends for damping).
//!   The width of the error function is \[assumed\], so that its middle is that of the sine squared.

pub use crate::quantity::choice::Bridging;
use numerics::math::{PI, erf, log10, sin};

/// Knudsen number below which flow is a continuum.
pub const CONTINUUM: f64 = 1e-3;
/// Knudsen number above which flow is free-molecular.
pub const FREE_MOLECULAR: f64 = 10.0;

impl Bridging {
    /// Weight of the free-molecular limit at a Knudsen number, 0 to 1.
    pub fn weight(self, knudsen: f64) -> f64 {
        match self {
            Self::SineSquared if knudsen <= CONTINUUM => 0.0,
            Self::SineSquared if knudsen >= FREE_MOLECULAR => 1.0,
            Self::SineSquared => {
                let s = sin(PI * (0.375 + 0.125 * log10(knudsen)));
                s * s
            }
            Self::ErrorFunction if knudsen > 0.0 => {
                0.5 * (1.0 + erf(PI.sqrt() * log10(knudsen / 0.1) / (8.0 / PI)))
            }
            Self::ErrorFunction => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_way_at_a_tenth() {
        for form in [Bridging::SineSquared, Bridging::ErrorFunction] {
            assert!((form.weight(0.1) - 0.5).abs() < 1e-15);
            // slope in log₁₀ Kn: π/8
            let slope = (form.weight(0.1001) - form.weight(0.0999)) / log10(0.1001 / 0.0999);
            assert!((slope - PI / 8.0).abs() < 1e-5, "{slope}");
        }
        assert_eq!(Bridging::SineSquared.weight(1e-3), 0.0);
        assert!(Bridging::SineSquared.weight(1.0001e-3) < 1e-8);
        assert_eq!(Bridging::SineSquared.weight(20.0), 1.0);
        // 0.01 is at a quarter: sin²(π/8) = 0.14645
        assert!((Bridging::SineSquared.weight(0.01) - 0.146_446_6).abs() < 1e-7);
    }
}
