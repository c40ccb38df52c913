//! Drag of a design against Mach number: a table by name, or that of the outline of each pass.

use crate::aero::DragTable;
use crate::aero::standard::{AeroBody, AxialForces};
use crate::vehicle::Vehicle;

/// Source of the drag of a design; below Mach 0.5 it is always a number of the case.
#[derive(Clone, Debug, PartialEq)]
pub enum DesignDrag {
    /// A table, whatever the outline.
    Table(DragTable),
    /// Computed from the outline.
    Outline {
        /// Axial forces of the outline.
        forces: AxialForces,
        /// Coefficient below Mach 0.5.
        subsonic: f64,
    },
}

impl DesignDrag {
    /// The drag of a vehicle.
    pub fn of(&self, vehicle: &Vehicle) -> DragTable {
        match self {
            Self::Table(table) => table.clone(),
            Self::Outline { forces, subsonic } => forces
                .of_outline(&AeroBody::of_vehicle("", vehicle))
                .with_subsonic(*subsonic),
        }
    }

    /// Coefficient at rest.
    pub fn subsonic(&self) -> f64 {
        match self {
            Self::Table(table) => table.at(0.0),
            Self::Outline { subsonic, .. } => *subsonic,
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::{Case, Library, Request, design};

    /// Newton: C_A of a cone is 2 sin² θ, 1 at 45 deg against 1.5 at 60 deg; the nose brings them together.
    #[test]
    fn a_slender_cone_has_the_drag_of_its_own_outline_and_not_that_of_a_table() {
        let library = Library::builtin().unwrap();
        let entry_load = |angle: &str, aerodynamics: &str| {
            let mut case = Case::run_page();
            case.set("design.cone_half_angle_deg", angle);
            case.set("design.aerodynamics", aerodynamics);
            case.set("design.nose_radius_ratio", "0.4");
            let answer = design(&case, &library, Request::Nothing).unwrap();
            let (flight, vehicle) = (answer.flight.unwrap(), answer.design.unwrap().vehicle);
            flight.peak_dynamic_pressure_pa.value * vehicle.dimensions.reference_area_m2
                / vehicle.mass.mass_kg
                / flight.peak_deceleration_earth_g.value
        };
        // the dynamic pressure at a given load is proportional to 1 / C_A
        let own = entry_load("45", "outline") / entry_load("60", "outline");
        let table = entry_load("45", "mmeev-60") / entry_load("60", "mmeev-60");
        assert!(own > 1.25 && own < 1.5, "{own}");
        assert!((table - 1.0).abs() < 0.02, "{table}");
    }
}
