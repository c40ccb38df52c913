//! Heat through a joint between two surfaces: contact and radiation across a gap side by side.
//!
//! ```text
//! q = (T₁ − T_a) / R₁ = h (T_a − T_b) + ε σ (T_a⁴ − T_b⁴) = (T_b − T₂) / R₂
//! ```
//!
//! with q in W/m², T in K, the resistances R from the middle of a cell to its surface in m² K/W, the conductance h of the
//! contact in W/(m² K), ε the effective emissivity of the gap.
//!
//! # Valid
//! Both surfaces gray and diffuse.
//!
//! # References
//! - \[incropera-2007\].

/// Stefan-Boltzmann constant, W/(m² K⁴), of the SI since 2019.
pub const STEFAN_BOLTZMANN_W_M2K4: f64 = 5.670_374_419e-8;

/// Joint of two surfaces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Joint {
    /// No resistance.
    Perfect,
    /// Contact with a resistance, m² K/W, above zero.
    Contact {
        /// Resistance, m² K/W.
        resistance_m2k_w: f64,
    },
    /// Film and radiation, as across a gap or to surroundings.
    Gap {
        /// Conductance, W/(m² K).
        conductance_w_m2k: f64,
        /// Effective emissivity.
        emissivity: f64,
    },
}

/// Flow through a joint and its slopes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Flow {
    /// Heat flux, W/m².
    pub q: f64,
    /// Its slope over the temperature of the first side, W/(m² K).
    pub by_first: f64,
    /// Its slope over the temperature of the second side, W/(m² K).
    pub by_second: f64,
}

impl Joint {
    /// Flow between two places behind resistances, m² K/W.
    pub fn flow(self, t1: f64, r1: f64, t2: f64, r2: f64) -> Flow {
        let series = |r: f64| Flow {
            q: (t1 - t2) / r,
            by_first: 1.0 / r,
            by_second: -1.0 / r,
        };
        match self {
            Self::Perfect => series(r1 + r2),
            Self::Contact { resistance_m2k_w } => series(r1 + resistance_m2k_w + r2),
            Self::Gap {
                conductance_w_m2k: h,
                emissivity,
            } => {
                let es = emissivity * STEFAN_BOLTZMANN_W_M2K4;
                let cube = |t: f64| 4.0 * es * t * t * t;
                // F(q) = h (T_a − T_b) + ε σ (T_a⁴ − T_b⁴) − q falls with q.
                let mut q = 0.0;
                let mut ends = [t1, t2];
                for _ in 0..50 {
                    ends = [(t1 - q * r1).max(0.0), (t2 + q * r2).max(0.0)];
                    let [a, b] = ends;
                    let f = h * (a - b) + es * (a * a * a * a - b * b * b * b) - q;
                    let step = f / (1.0 + r1 * (h + cube(a)) + r2 * (h + cube(b)));
                    q += step;
                    if step.abs() <= 1e-13 * (q.abs() + 1e-9) {
                        break;
                    }
                }
                let [a, b] = ends.map(cube);
                let by = 1.0 + r1 * (h + a) + r2 * (h + b);
                Flow {
                    q,
                    by_first: (h + a) / by,
                    by_second: -(h + b) / by,
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn resistances_add() {
        // 100 K over 0.1 + 0.3 + 0.1 m² K/W = 200 W/m²
        let flow = Joint::Contact {
            resistance_m2k_w: 0.3,
        }
        .flow(400.0, 0.1, 300.0, 0.1);
        assert!((flow.q - 200.0).abs() < 1e-12);
    }

    #[test]
    fn gap_without_resistance_radiates() {
        // σ (1000⁴ − 500⁴) = 5.670374419e-8 · 9.375e11 = 53159.76 W/m²
        let gap = Joint::Gap {
            conductance_w_m2k: 0.0,
            emissivity: 1.0,
        };
        assert!((gap.flow(1000.0, 0.0, 500.0, 0.0).q - 53_159.760_178).abs() < 1e-5);
    }

    #[test]
    fn slopes_are_those_of_the_flow() {
        let gap = Joint::Gap {
            conductance_w_m2k: 5.0,
            emissivity: 0.8,
        };
        let at = |t1: f64, t2: f64| gap.flow(t1, 0.01, t2, 0.02);
        let here = at(900.0, 400.0);
        let d = 1e-3;
        let first = (at(900.0 + d, 400.0).q - at(900.0 - d, 400.0).q) / (2.0 * d);
        let second = (at(900.0, 400.0 + d).q - at(900.0, 400.0 - d).q) / (2.0 * d);
        assert!((here.by_first - first).abs() < 1e-6 * first.abs());
        assert!((here.by_second - second).abs() < 1e-6 * second.abs());
    }
}
