//! Crush stress of a closed-cell foam: elastic, plateau, densification.
//!
//! ```text
//! σ = E ε up to ε_y, then max( σ_pl, σ_pl/D · ε_D / (ε_D − ε) )      ε_D = 1 − 1.4 ρ/ρ_s      E = σ_pl / ε_y
//! ε_p = ε_D (1 − 1/D)                                         end of the plateau
//! ```
//!
//! with stresses in Pa, σ_pl the plateau, ε_D the strain at which the cells are closed, D = 2.3 where the curve leaves the plateau,
//! ρ the foam's density and ρ_s that of its solid in kg/m³, ε_y the elastic strain. Where the curve would be steeper than the
//! solid it goes on with the solid's modulus.
//!
//! # Valid
//! Plastic foams in uniaxial compression, slowly crushed. Radial panels of an impact sphere are not in it.
//!
//! # References
//! - \[gibson-ashby-1997\] chapters 5 and 8; \[maiti-1984\].

use crate::data::Data;
use numerics::scalar::Single;
use serde::{Deserialize, Serialize};

/// Constants of a kind of foam, a file of `data/foams`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FoamKind {
    /// Keys of the sources in the list of references.
    pub source: String,
    /// Places in the sources.
    pub place: String,
    /// Note for the reader.
    pub note: String,
    /// Density of the solid, kg/m³.
    pub solid_density_kg_m3: f64,
    /// Modulus of the solid, Pa.
    pub solid_modulus_pa: f64,
    /// Elastic strain at which the plateau begins.
    pub yield_strain_ratio: f64,
    /// Loss of strain by the volume of the solid.
    pub densification_factor: f64,
    /// The factor D, which sets the end of the plateau.
    pub knee_factor: f64,
}

/// Stress of one foam against strain.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct CrushLaw<S = f64> {
    /// Plateau, Pa.
    pub plateau_pa: S,
    /// Strain at which the cells are closed.
    pub closed_strain: S,
    /// The factor D.
    pub knee_factor: f64,
    /// Modulus of the foam, Pa.
    pub modulus_pa: S,
    /// Modulus of the solid, Pa.
    pub solid_modulus_pa: f64,
}

impl FoamKind {
    /// Reads a file of `data/foams`.
    pub fn parse(data: Data) -> Result<Self, String> {
        let kind: Self = data.read()?;
        let positive = [
            kind.solid_density_kg_m3,
            kind.solid_modulus_pa,
            kind.yield_strain_ratio,
            kind.densification_factor,
            kind.knee_factor - 1.0,
        ];
        if positive.iter().all(|x| x.is_finite() && *x > 0.0) {
            Ok(kind)
        } else {
            Err("every constant must be above 0, knee_factor above 1".to_string())
        }
    }

    /// The law of a foam with this density and plateau; a density beyond the solid leaves a tenth of the strain.
    pub fn law<S: Single>(&self, density_kg_m3: S, plateau_pa: S) -> CrushLaw<S> {
        let relative = density_kg_m3 / self.solid_density_kg_m3;
        let open = -(relative * self.densification_factor) + 1.0;
        CrushLaw {
            plateau_pa,
            closed_strain: open.max(S::constant(0.1)),
            knee_factor: self.knee_factor,
            modulus_pa: plateau_pa / self.yield_strain_ratio,
            solid_modulus_pa: self.solid_modulus_pa,
        }
    }
}

impl<S: Single> CrushLaw<S> {
    /// Strain at which the plateau ends.
    pub fn plateau_strain(&self) -> S {
        self.closed_strain * (1.0 - 1.0 / self.knee_factor)
    }

    /// Stress, Pa; zero without compression.
    pub fn stress_pa(&self, strain: S) -> S {
        if strain.value() <= self.yield_strain().value() {
            self.modulus_pa * strain.max(S::constant(0.0))
        } else {
            self.plateau_pa.max(self.dense_pa(strain))
        }
    }

    /// Slope of the stress, Pa.
    pub fn slope_pa(&self, strain: S) -> S {
        let left = self.closed_strain - strain;
        if strain.value() <= self.yield_strain().value() {
            self.modulus_pa
        } else if strain.less(self.plateau_strain()) {
            S::constant(0.0)
        } else if self.last_left().less(left) {
            self.scale_pa() / (left * left)
        } else {
            S::constant(self.solid_modulus_pa)
        }
    }

    /// Elastic strain at which the plateau begins.
    pub fn yield_strain(&self) -> S {
        self.plateau_pa / self.modulus_pa
    }

    /// Strain from which the foam is as stiff as its solid.
    pub fn last_strain(&self) -> S {
        self.closed_strain - self.last_left()
    }

    /// The rising branch, Pa.
    fn dense_pa(&self, strain: S) -> S {
        let (scale, last) = (self.scale_pa(), self.last_left());
        let left = self.closed_strain - strain;
        if last.less(left) {
            scale / left
        } else {
            scale / last + (last - left) * self.solid_modulus_pa
        }
    }

    /// Value of ε_D − ε at which the slope scale / (ε_D − ε)² is that of the solid.
    fn last_left(&self) -> S {
        (self.scale_pa() / self.solid_modulus_pa).sqrt()
    }

    /// Stress times strain left to closed cells on the rising branch, Pa.
    pub fn scale_pa(&self) -> S {
        self.plateau_pa * self.closed_strain / self.knee_factor
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kind() -> FoamKind {
        FoamKind::parse(crate::library::data_file("foams/pmi.toml").unwrap().into()).unwrap()
    }

    #[test]
    fn grade_110_leaves_its_plateau_at_0p49_and_has_twice_the_stress_at_0p68() {
        let law = kind().law(110.0, 3.0e6);
        // 1 − 1.4 · 110 / 1200 = 0.871667; · (1 − 1/2.3) = 0.492681
        assert!((law.closed_strain - 0.871_667).abs() < 1e-6);
        assert!((law.plateau_strain() - 0.492_681).abs() < 1e-6);
        assert_eq!(law.stress_pa(0.2), 3.0e6);
        // ε_D − ε = ε_D / 4.6 gives twice the plateau
        let strain = law.closed_strain * (1.0 - 1.0 / 4.6);
        assert!((law.stress_pa(strain) / 6.0e6 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn half_of_the_elastic_strain_has_half_of_the_plateau() {
        let law = kind().law(110.0, 3.0e6);
        assert!((law.stress_pa(0.0075) - 1.5e6).abs() < 1e-6);
        assert_eq!(law.stress_pa(-0.1), 0.0);
    }

    #[test]
    fn stress_is_continuous_and_bounded_where_the_cells_are_closed() {
        let law = kind().law(205.0, 9.58e6);
        for n in 1..2000 {
            let strain = f64::from(n) * 5e-4;
            let step = law.stress_pa(strain + 1e-9) - law.stress_pa(strain);
            // never steeper than the solid
            assert!(
                (0.0..=law.solid_modulus_pa * 1.001e-9).contains(&step),
                "{strain}"
            );
        }
    }

    #[test]
    fn slope_is_that_of_the_stress() {
        let law = kind().law(110.0, 3.0e6);
        for strain in [0.005, 0.2, 0.6, 0.8, 0.9] {
            let h = 1e-7;
            let slope_pa = (law.stress_pa(strain + h) - law.stress_pa(strain - h)) / (2.0 * h);
            assert!(
                (law.slope_pa(strain) - slope_pa).abs() <= 1e-5 * slope_pa,
                "{strain}"
            );
        }
    }

    #[test]
    fn a_foam_denser_than_its_solid_still_has_a_law() {
        assert_eq!(kind().law(3000.0, 1e6).closed_strain, 0.1);
    }
}
