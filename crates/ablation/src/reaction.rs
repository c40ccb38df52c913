//! Decomposition of the solid: independent Arrhenius reactions.
//!
//! ```text
//! dX/dt = − A' exp(−E/(R T)) |X|^(ψ−1) X        T > T_reac
//! X  = (ρᵢ − ρᵢ_c) / (ρᵢᵥ − ρᵢ_c)               A' = A ((ρᵢᵥ − ρᵢ_c) / ρᵢᵥ)^(ψ−1)
//! ```
//!
//! of dρᵢ/dt = −A ρᵢᵥ ((ρᵢ − ρᵢ_c)/ρᵢᵥ)^ψ exp(−E/(R T)), with ρ in kg/m³, A in 1/s, E/R and T in K. Continued as an odd function
//! below zero, where a step may end by its error.
//!
//! # Valid
//! Any T.
//!
//! # References
//! - \[pato\], \[amar-2006\].

use crate::fault::Fault;
use numerics::math;

/// One reaction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reaction {
    /// Density that it takes from the solid altogether, kg/m³.
    pub loss_kg_m3: f64,
    /// Rate A' of the share, 1/s.
    pub rate_per_s: f64,
    /// Activation temperature E/R, K.
    pub activation_k: f64,
    /// Order ψ, at least 1.
    pub order: f64,
    /// Temperature above which it goes on, K.
    pub start_k: f64,
}

/// Rate of a share: the rate with its slope over the share.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Rate {
    /// Rate of the loss of the share, 1/s.
    pub value: f64,
    /// Its slope over the share, 1/s.
    pub by_share: f64,
}

impl Reaction {
    /// The reaction of a component from its densities, kg/m³, its pre-exponential factor A, 1/s, E/R, K, and order.
    pub fn of_component(
        [virgin, char]: [f64; 2],
        rate_per_s: f64,
        activation_k: f64,
        order: f64,
        start_k: f64,
    ) -> Self {
        let share = (virgin - char) / virgin;
        Self {
            loss_kg_m3: virgin - char,
            rate_per_s: rate_per_s * math::pow(share, order - 1.0),
            activation_k,
            order,
            start_k,
        }
    }

    pub(crate) fn check(&self) -> Result<(), Fault> {
        for (key, value, least, most) in [
            (
                "density_kg_m3",
                self.loss_kg_m3,
                f64::MIN_POSITIVE,
                f64::MAX,
            ),
            ("rate_per_s", self.rate_per_s, 0.0, f64::MAX),
            ("activation_k", self.activation_k, 0.0, f64::MAX),
            ("order", self.order, 1.0, 10.0),
            ("start_k", self.start_k, 0.0, f64::MAX),
        ] {
            if !(least..=most).contains(&value) {
                return Err(Fault::Range {
                    of: "reaction",
                    key,
                    value,
                    least,
                    most,
                });
            }
        }
        Ok(())
    }

    /// Arrhenius factor at a temperature, K: A' exp(−E/(R T)), 1/s, and its slope, 1/(s K).
    #[inline]
    pub(crate) fn factor(&self, t: f64) -> [f64; 2] {
        if t <= self.start_k {
            return [0.0; 2];
        }
        let k = self.rate_per_s * math::exp(-self.activation_k / t);
        [k, k * self.activation_k / (t * t)]
    }

    /// |X|^(ψ−1) X and its slope.
    #[inline]
    pub(crate) fn of_share(&self, x: f64) -> Rate {
        let size = x.abs();
        let power = if self.order == 3.0 {
            size * size
        } else if self.order == 1.0 {
            1.0
        } else if self.order == 2.0 {
            size
        } else if size == 0.0 {
            0.0
        } else {
            math::pow(size, self.order - 1.0)
        };
        Rate {
            value: power * x,
            by_share: self.order * power,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn phenolic_of_the_workshop_has_a_ninth_of_its_rate() {
        // 4.48e9 · (300/900)² = 4.9778e8, the factor of the three-reaction form of the same material.
        let reaction = Reaction::of_component([90.0, 60.0], 4.48e9, 20_444.444, 3.0, 555.5556);
        assert!((reaction.rate_per_s - 4.48e9 / 9.0).abs() < 1.0);
        assert!((reaction.loss_kg_m3 - 30.0).abs() < 1e-12);
    }

    #[test]
    fn half_a_share_of_third_order_is_an_eighth() {
        let reaction = Reaction {
            loss_kg_m3: 30.0,
            rate_per_s: 1.0,
            activation_k: 0.0,
            order: 3.0,
            start_k: 0.0,
        };
        assert_eq!(
            reaction.of_share(0.5),
            Rate {
                value: 0.125,
                by_share: 0.75
            }
        );
        assert_eq!(reaction.of_share(-0.5).value, -0.125);
    }
}
