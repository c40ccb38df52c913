//! The mass tree: components without margin, the margin once, the whole.
//!
//! ```text
//! M = Σ m + margin
//! ```
//!
//! with masses in kg. Sums run in the order of the components, so that the lines add up to the last bit.
//!
//! # Valid
//! Same as [`crate::vehicle::mass`].
//!
//! # References
//! - \[samareh-2014\] section 3.1.4 and Table 1.

use crate::vehicle::Vehicle;
use crate::vehicle::material::DensityBasis;
use serde::{Deserialize, Serialize};

/// A line of the mass tree; moments of inertia are through the line's own center of gravity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Line {
    /// Name.
    pub name: String,
    /// Material; absent for the margin and the whole.
    pub material: Option<String>,
    /// Density, kg/m³.
    pub density_kg_m3: Option<f64>,
    /// Basis of the density.
    pub density_basis: Option<DensityBasis>,
    /// Volume, m³.
    pub volume_m3: Option<f64>,
    /// Area of the closed surface, m².
    pub surface_area_m2: Option<f64>,
    /// Area that the outer air touches, m².
    pub wetted_area_m2: Option<f64>,
    /// Mass, kg; of components without margin.
    pub mass_kg: f64,
    /// Center of gravity behind the nose, m.
    pub cg_from_nose_m: f64,
    /// Moment of inertia about the axis, kg m²; of components without margin.
    pub ixx_kg_m2: f64,
    /// Moment of inertia about a transverse axis, kg m²; of components without margin.
    pub iyy_kg_m2: f64,
    /// Moment of inertia about the other transverse axis, kg m²; of components without margin.
    pub izz_kg_m2: f64,
}

/// The lines of a vehicle: components, their sum without margin, the margin, the whole.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MassTree {
    /// Components, one line each.
    pub components: Vec<Line>,
    /// Sum of the components, without margin.
    pub without_margin: Line,
    /// The margin on everything but the payload, where its mass is.
    pub margin: Line,
    /// The whole at entry.
    pub total: Line,
    /// The whole after landing, with the foam crushed by the required stroke.
    pub crushed: Line,
}

/// Mass, position and inertias of a line, x from the virtual apex.
#[derive(Clone, Copy, Default)]
struct Moments {
    mass_kg: f64,
    cg_x_m: f64,
    ixx_kg_m2: f64,
    iyy_kg_m2: f64,
}

impl Moments {
    fn about_apex(self) -> f64 {
        self.iyy_kg_m2 + self.mass_kg * self.cg_x_m * self.cg_x_m
    }

    /// Moments of the whole without a part.
    fn less(self, part: Self) -> Self {
        let mass_kg = self.mass_kg - part.mass_kg;
        if mass_kg <= 0.0 {
            let cg_x_m = self.cg_x_m;
            return Self {
                cg_x_m,
                ..Self::default()
            };
        }
        let cg_x_m = (self.mass_kg * self.cg_x_m - part.mass_kg * part.cg_x_m) / mass_kg;
        Self {
            mass_kg,
            cg_x_m,
            ixx_kg_m2: self.ixx_kg_m2 - part.ixx_kg_m2,
            iyy_kg_m2: self.about_apex() - part.about_apex() - mass_kg * cg_x_m * cg_x_m,
        }
    }

    fn line(self, name: &str, nose_x_m: f64) -> Line {
        Line {
            name: name.to_owned(),
            material: None,
            density_kg_m3: None,
            density_basis: None,
            volume_m3: None,
            surface_area_m2: None,
            wetted_area_m2: None,
            mass_kg: self.mass_kg,
            cg_from_nose_m: self.cg_x_m - nose_x_m,
            ixx_kg_m2: self.ixx_kg_m2,
            iyy_kg_m2: self.iyy_kg_m2,
            izz_kg_m2: self.iyy_kg_m2,
        }
    }
}

impl Vehicle {
    /// The mass tree.
    pub fn mass_tree(&self) -> MassTree {
        let nose_x_m = self.dimensions.virtual_apex_ahead_m;
        let mut bare = Moments::default();
        let (mut moment, mut about_apex) = (0.0, 0.0);
        let mut lines = Vec::with_capacity(self.components.len());
        for part in &self.components {
            let share = match part.mass_with_margin_kg > 0.0 {
                true => part.mass_kg / part.mass_with_margin_kg,
                false => 0.0,
            };
            let own = Moments {
                mass_kg: part.mass_kg,
                cg_x_m: part.cg_x_m,
                ixx_kg_m2: share * part.ixx_kg_m2,
                iyy_kg_m2: share * part.iyy_kg_m2,
            };
            bare.mass_kg += own.mass_kg;
            bare.ixx_kg_m2 += own.ixx_kg_m2;
            moment += own.mass_kg * own.cg_x_m;
            about_apex += own.about_apex();
            lines.push(Line {
                material: Some(part.material.clone()),
                density_kg_m3: Some(part.density_kg_m3),
                density_basis: Some(part.density_basis),
                volume_m3: Some(part.volume_m3),
                surface_area_m2: Some(part.surface_area_m2),
                wetted_area_m2: Some(part.wetted_area_m2),
                ..own.line(part.kind.label(), nose_x_m)
            });
        }
        if bare.mass_kg > 0.0 {
            bare.cg_x_m = moment / bare.mass_kg;
        }
        bare.iyy_kg_m2 = about_apex - bare.mass_kg * bare.cg_x_m * bare.cg_x_m;
        let of = |mass: &crate::vehicle::MassProperties| Moments {
            mass_kg: mass.mass_kg,
            cg_x_m: mass.cg_x_m,
            ixx_kg_m2: mass.ixx_kg_m2,
            iyy_kg_m2: mass.iyy_kg_m2,
        };
        let whole = of(&self.mass);
        MassTree {
            components: lines,
            without_margin: bare.line("Sum without margin", nose_x_m),
            margin: whole.less(bare).line("Margin", nose_x_m),
            total: Line {
                volume_m3: Some(self.mass.volume_m3),
                wetted_area_m2: Some(self.dimensions.wetted_area_m2),
                ..whole.line("Total at entry", nose_x_m)
            },
            crushed: Line {
                volume_m3: Some(self.crushed.volume_m3),
                ..of(&self.crushed).line("After landing, foam crushed", nose_x_m)
            },
        }
    }
}

impl MassTree {
    /// All lines, components first.
    pub fn lines(&self) -> impl Iterator<Item = &Line> {
        let sums = [
            &self.without_margin,
            &self.margin,
            &self.total,
            &self.crushed,
        ];
        self.components.iter().chain(sums)
    }
}

#[cfg(test)]
mod tests {
    use crate::vehicle::build;
    use crate::vehicle::tests::{galahad, msr};

    #[test]
    fn the_lines_add_up_to_the_last_bit_and_the_margin_stands_once() {
        for (mut input, margin) in [(msr(), 0.3), (galahad(), 0.0), (galahad(), 1.0)] {
            input.mass_margin = margin;
            let vehicle = build(&input).unwrap();
            let tree = vehicle.mass_tree();
            let sum: f64 = tree.components.iter().map(|line| line.mass_kg).sum();
            assert_eq!(sum, tree.without_margin.mass_kg);
            assert_eq!(
                tree.without_margin.mass_kg + tree.margin.mass_kg,
                tree.total.mass_kg
            );
            let share = margin * (sum - input.payload_mass_kg);
            assert!((tree.margin.mass_kg - share).abs() < 1e-12);
            assert_eq!(tree.total.mass_kg, vehicle.mass.mass_kg);
            let moment = |line: &super::Line| line.mass_kg * line.cg_from_nose_m;
            let parts = moment(&tree.without_margin) + moment(&tree.margin);
            assert!((parts - moment(&tree.total)).abs() < 1e-13);
            let ixx = tree.without_margin.ixx_kg_m2 + tree.margin.ixx_kg_m2;
            assert!((ixx - tree.total.ixx_kg_m2).abs() < 1e-13);
            assert_eq!(tree.lines().count(), tree.components.len() + 4);
        }
    }
}
