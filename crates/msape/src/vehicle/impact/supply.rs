//! The foam used for a required strength: between two grades, the weakest, beyond the strongest, or that of the case.
//!
//! ```text
//! ρ = ρ₁ + (σ − σ₁) (ρ₂ − ρ₁) / (σ₂ − σ₁)        σ₁ ≤ σ ≤ σ₂, and on from the last two beyond the strongest
//! ρ = ρ₀, σ = σ₀                                 weakest grade, where less is requested
//! ```
//!
//! with densities ρ in kg/m³ and compressive strengths σ in Pa, which are the plateaus of the crush law.
//!
//! # Valid
//! Foam of one family, made to any density between its grades. Beyond the strongest grade other materials carry the rest, and the
//! density is that of foam: a finding says so.
//!
//! # References
//! - \[evonik-rohacell\].

use crate::vehicle::impact::foam::{CrushLaw, FoamKind};
use crate::vehicle::input::VehicleInput;
use crate::vehicle::kinds::FoamGrade;
use numerics::scalar::Single;

/// Foams of which an impact absorber can be made.
#[derive(Clone, Copy, Debug)]
pub struct Supply<'a, S = f64> {
    kind: &'a FoamKind,
    grades: &'a [FoamGrade],
    given_kg_m3: Option<S>,
}

impl<S: Single> Supply<'_, S> {
    /// Foam supply of an input.
    pub fn new(input: &VehicleInput<S>) -> Supply<'_, S> {
        Supply {
            kind: &input.impact.foam,
            grades: &input.foam_grades,
            given_kg_m3: input.densities.impact_foam_kg_m3,
        }
    }

    /// Density of the foam, without panels unless the case gives it with them, kg/m³.
    pub fn density_kg_m3(&self, asked_pa: S) -> S {
        self.given_kg_m3
            .unwrap_or_else(|| foam_density_kg_m3(self.grades, asked_pa))
    }

    /// Crush law of the foam in use for a requested strength, Pa; a density of the case has the strength of its grades.
    pub fn law(&self, asked_pa: S) -> CrushLaw<S> {
        if let Some(density) = self.given_kg_m3
            && let Some(strength_pa) = foam_strength_at_pa(self.grades, density)
        {
            return self.kind.law(density, strength_pa);
        }
        let weakest = self.grades.first();
        let weakest_pa = weakest.map_or(0.0, |grade| grade.compressive_strength_pa);
        let density = foam_density_kg_m3(self.grades, asked_pa);
        self.kind
            .law(density, asked_pa.max(S::constant(weakest_pa)))
    }
}

/// Density at which a foam has a compressive strength, linear between grades and beyond the last two, kg/m³; zero without grades.
pub fn foam_density_kg_m3<S: Single>(grades: &[FoamGrade], strength_pa: S) -> S {
    let mut pairs = grades.iter().zip(grades.iter().skip(1));
    let enough = |grade: &FoamGrade| strength_pa.value() <= grade.compressive_strength_pa;
    let weakest = grades.first();
    let pair = pairs.clone().find(|(_, high)| enough(high));
    match (weakest.is_some_and(enough), pair.or(pairs.next_back())) {
        (false, Some((low, high))) => {
            let share = (strength_pa - low.compressive_strength_pa)
                / (high.compressive_strength_pa - low.compressive_strength_pa);
            share * (high.density_kg_m3 - low.density_kg_m3) + low.density_kg_m3
        }
        _ => S::constant(weakest.map_or(0.0, |grade| grade.density_kg_m3)),
    }
}

/// Compressive strength of a foam of this density between the grades, Pa; `None` outside them.
pub fn foam_strength_at_pa<S: Single>(grades: &[FoamGrade], density_kg_m3: S) -> Option<S> {
    grades
        .iter()
        .zip(grades.iter().skip(1))
        .find_map(|(low, high)| {
            let (from, to) = (low.density_kg_m3, high.density_kg_m3);
            (from < to && (from..=to).contains(&density_kg_m3.value())).then(|| {
                let share = (density_kg_m3 - from) / (to - from);
                share * (high.compressive_strength_pa - low.compressive_strength_pa)
                    + low.compressive_strength_pa
            })
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grades() -> Vec<FoamGrade> {
        let grade = |density_kg_m3, compressive_strength_pa| FoamGrade {
            name: String::new(),
            density_kg_m3,
            compressive_strength_pa,
            source: String::new(),
        };
        vec![grade(50.0, 1.0e6), grade(100.0, 2.0e6), grade(200.0, 4.0e6)]
    }

    #[test]
    fn foam_of_3_mpa_between_2_and_4_has_the_mean_density() {
        let grades = grades();
        assert_eq!(foam_density_kg_m3(&grades, 3.0e6), 150.0);
        assert_eq!(foam_density_kg_m3(&grades, 6.0e6), 300.0); // beyond: 50 kg/m³ a MPa further
        assert_eq!(foam_density_kg_m3(&grades, 0.5e6), 50.0);
        assert_eq!(foam_density_kg_m3(&[], 1.0e6), 0.0);
    }

    #[test]
    fn foam_half_way_between_two_grades_has_the_mean_strength() {
        assert_eq!(foam_strength_at_pa(&grades(), 75.0), Some(1.5e6));
        assert_eq!(foam_strength_at_pa(&grades(), 201.0), None);
    }

    #[test]
    fn less_than_the_weakest_grade_is_the_weakest_and_a_given_density_has_its_own_strength() {
        let kind =
            FoamKind::parse(crate::library::data_file("foams/pmi.toml").unwrap().into()).unwrap();
        let supply = |given_kg_m3| {
            Supply {
                kind: &kind,
                grades: &grades(),
                given_kg_m3,
            }
            .law(0.5e6)
        };
        assert_eq!(supply(None), kind.law(50.0, 1.0e6));
        assert_eq!(supply(Some(75.0)), kind.law(75.0, 1.5e6));
        // denser than any grade: the requested strength
        assert_eq!(supply(Some(500.0)), kind.law(50.0, 1.0e6));
    }
}
