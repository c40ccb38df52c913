//! The impact foam that a landing requires: least thickness, and strength and density at a thickness.
//!
//! ```text
//! t ≥ Stroke / η                     η ≤ ε_p, the end of the plateau of the foam in use        MSR
//!                                    η ≤ ε_p − ε_y/2, the elastic part takes half              non-MSR
//! FS = ½ M_PL V² / 𝒱(η t)               crush law: 𝒱 the volume swept by the footprint, less its elastic part
//! FS ≤ M_PL V² / (2 A_p Stroke)      equation 6, where the foam then keeps to its plateau
//! FS ≥ ½ M_PL V² / 𝒱(ε_p t)             the plateau takes all of the energy
//! ρ = ρ(FS) + ρ_panels               panels in the MSR concept only
//! ```
//!
//! with t the thickness in m, η the usable fraction of it, ε_p and ε_y the strains at the end and the start of the plateau, FS the
//! strength in Pa, M_PL the payload's mass in kg, 𝒱 in m³ as in [`crate::vehicle::impact::absorber`], ρ in kg/m³. As ε_p is that
//! of the foam that has FS, both are found together, as a bracketed root; without η of the case it is ε_p itself.
//!
//! On a rigid surface this is the landing that [`crate::vehicle::impact::crush`] follows in time: the payload stops at W = ½ M_PL V²
//! under the force FS A(s), which is the limit Ḡ where s is the stroke of equation 4, in a column to the last digit, and
//!
//! ```text
//! load / Ḡ = (1 − s/2R) / (1 − s/3R) / (1 − (ε_y t/s)² (1 − ε_y t/4R) / (3 − s/R)),   below 1 for s/R > 2 (ε_y t/s)²,
//! ```
//!
//! in a sphere of the radius R, and less in thicker foam.
//!
//! # Valid
//! Same as [`crate::vehicle::impact`]. The payload alone crushes the foam, as in equations 4 and 6; foam for the whole impact
//! sphere would have to carry its own mass, for which it would be too dense to be a foam. Foam weaker than the weakest grade is
//! not available: there the load is above the limit.
//!
//! # References
//! - \[samareh-2014\] section 3.1.5, equations 4 and 6.

use crate::vehicle::impact::absorber::{Absorber, Shape};
use crate::vehicle::impact::foam::CrushLaw;
use crate::vehicle::impact::supply::Supply;
use crate::vehicle::impact::{foam_strength_pa, required_stroke_m};
use crate::vehicle::input::VehicleInput;
use crate::vehicle::kinds::{Concept, Foam, FoamStrength};
use numerics::root;
use numerics::scalar::Single;

/// Lower end of the search for the usable fraction, assumed: a foam as dense as its solid has 0.06.
const LEAST_EFFICIENCY: f64 = 0.01;
/// Number of intervals in the search for the softest foam: assumed.
const STEPS: u32 = 16;
/// Distance kept from the foam of the least thickness, a root itself at its own, as part of the range searched: assumed, far above the
/// resolution of the search.
const APART: f64 = 1e-6;
/// Width of the last interval in the search for a usable fraction: that of rounding.
const RESOLUTION: f64 = 1e-15;

/// Impact foam that the landing requires.
#[derive(Clone, Copy, Debug)]
pub struct FoamRule<'a, S = f64> {
    /// Stroke of the payload on a rigid surface, m.
    pub stroke_m: S,
    /// Usable fraction of the foam: that of the case, or less where the plateau of the foam in use ends before.
    pub stroke_efficiency: S,
    /// Thickness that gives this stroke, m.
    pub required_thickness_m: S,
    /// Thickness used, m: the required one, or the least that the rules allow.
    pub least_thickness_m: S,
    /// Strength of equation 6, Pa.
    pub equation_6_pa: S,
    /// End of the plateau of the foam that the least thickness with the largest fraction requires.
    plateau_strain: S,
    shape: Shape<S>,
    input: &'a VehicleInput<S>,
}

impl<S: Single> FoamRule<'_, S> {
    /// The foam for the landing of a vehicle.
    pub fn new(input: &VehicleInput<S>) -> FoamRule<'_, S> {
        let v = input.loads.terminal_speed_m_s;
        let shape = Shape::of(input);
        let stroke_m = required_stroke_m(input.concept, v, input.impact.crush_load_limit_earth_g);
        // equation 6 with equation 4: the speed drops out, so that any speed above rest gives the same
        let none = S::constant(0.0);
        let equation_6_pa = if stroke_m.value() > 0.0 {
            foam_strength_pa(
                input.payload_mass_kg,
                input.payload_diameter_m(),
                v,
                stroke_m,
            )
        } else {
            none
        };
        let mut rule = FoamRule {
            stroke_m,
            stroke_efficiency: none,
            required_thickness_m: none,
            least_thickness_m: S::constant(input.rules.foam_thickness_min_m),
            equation_6_pa,
            plateau_strain: none,
            shape,
            input,
        };
        let usable = rule.largest_efficiency();
        rule.plateau_strain = usable + rule.elastic_part();
        rule.stroke_efficiency = match input.impact.stroke_efficiency {
            Some(asked) => asked.min(usable),
            None => usable,
        };
        rule.required_thickness_m = stroke_m / rule.stroke_efficiency;
        rule.least_thickness_m = rule.least_thickness_m.max(rule.required_thickness_m);
        rule
    }

    /// The foam at a thickness, m.
    pub fn at(&self, thickness_m: S) -> Foam<S> {
        let strength_pa = self.strength_pa(thickness_m);
        let panels_kg_m3 = match (self.input.concept, self.input.densities.impact_foam_kg_m3) {
            (Concept::Msr, None) => self.input.densities.impact_panels_kg_m3,
            _ => S::constant(0.0),
        };
        Foam {
            thickness_m,
            density_kg_m3: self.supply().density_kg_m3(strength_pa) + panels_kg_m3,
            strength_pa,
        }
    }

    fn supply(&self) -> Supply<'_, S> {
        Supply::new(self.input)
    }

    /// Part of the thickness that the elastic branch takes from the stroke of equation 4.
    fn elastic_part(&self) -> S {
        match self.input.concept {
            Concept::Msr => S::constant(0.0),
            Concept::NonMsr => self.supply().law(self.equation_6_pa).yield_strain() * 0.5,
        }
    }

    /// The largest fraction with which the foam of the least thickness keeps to its plateau.
    fn largest_efficiency(&self) -> S {
        let supply = self.supply();
        let usable = |law: CrushLaw<S>| law.plateau_strain() - self.elastic_part();
        let softest = usable(supply.law(S::constant(0.0)));
        let excess = |efficiency: S| {
            let strength_pa = match (self.input.impact.foam_strength, self.input.concept) {
                (FoamStrength::CrushLaw, Concept::Msr) if self.stroke_m.value() > 0.0 => {
                    self.needed_pa(self.stroke_m / efficiency, self.stroke_m)
                }
                // in a column the stroke of equation 4 requires the strength of equation 6
                _ => self.equation_6_pa,
            };
            usable(supply.law(strength_pa)) - efficiency
        };
        let excess_at = |efficiency: f64| excess(S::constant(efficiency)).value();
        // stronger foam is denser and its plateau shorter: the excess falls throughout
        root::brent(excess_at, LEAST_EFFICIENCY, softest.value(), RESOLUTION)
            .map_or(softest, |efficiency| S::implicit(efficiency, excess))
    }

    /// Requested strength at a thickness, Pa.
    fn strength_pa(&self, thickness_m: S) -> S {
        let at_rest = self.stroke_m.value() == 0.0;
        if self.input.impact.foam_strength == FoamStrength::Equation6 || at_rest {
            return self.equation_6_pa;
        }
        let on_plateau_pa = self.on_plateau_pa(thickness_m);
        match self.input.impact.stroke_efficiency {
            None => on_plateau_pa,
            Some(_) => {
                let crush_m = self.stroke_efficiency * thickness_m;
                let needed_pa = self.needed_pa(thickness_m, crush_m);
                on_plateau_pa.max(needed_pa.min(self.equation_6_pa))
            }
        }
    }

    /// Least strength with which a foam takes the energy on its plateau, Pa.
    fn on_plateau_pa(&self, thickness_m: S) -> S {
        let supply = self.supply();
        let strength_pa = |strain: S| self.needed_pa(thickness_m, strain * thickness_m);
        let left = |strain: S| supply.law(strength_pa(strain)).plateau_strain() - strain;
        let left_at = |strain: f64| left(S::constant(strain)).value();
        let softest = supply.law(S::constant(0.0)).plateau_strain().value();
        // thicker foam can be softer, and its plateau longer than that of the least thickness; beyond the grades there may be more than
        // one such foam, of which the softest is looked for
        let step = (1.0 - APART) * (softest - self.plateau_strain.value()) / f64::from(STEPS);
        let strain = (1..=STEPS)
            .map(|i| softest - f64::from(i) * step)
            .find(|strain| left_at(*strain) >= 0.0)
            .and_then(|low| root::brent(left_at, low, low + step, RESOLUTION));
        strength_pa(strain.map_or(self.plateau_strain, |strain| S::implicit(strain, left)))
    }

    /// Strength that takes the energy at a thickness within a crush on the plateau, m, Pa.
    fn needed_pa(&self, thickness_m: S, crush_m: S) -> S {
        let supply = self.supply();
        let v = self.input.loads.terminal_speed_m_s;
        let absorber = Absorber {
            shape: self.shape,
            thickness_m,
            law: supply.law(self.equation_6_pa),
        };
        self.input.payload_mass_kg * 0.5 * v * v / absorber.taken_m3(crush_m)
    }
}
