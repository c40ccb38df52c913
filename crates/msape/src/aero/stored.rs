//! A database as rows for storage, at the conditions of the report's figures.
//!
//! ```text
//! Mach 25 at Kn 100, 1, 0.1 and 0.01; Mach 24, 9.8, 3.98, 1.3, 1.15, 0.85, 0.75, 0.6 and 0.5 in a continuum; 0 to 180 deg by 5
//! ```
//!
//! # Valid
//! Range of the source database.
//!
//! # References
//! - \[samareh-2014\] Appendix A, Figures A1 to A10 (the Mach numbers of its database V_021).

use super::database::Database;
use numerics::math::RADIANS_PER_DEGREE;

/// Mach and Knudsen numbers of the rows.
pub const PLACES: [[f64; 2]; 13] = [
    [25.0, 100.0],
    [25.0, 1.0],
    [25.0, 0.1],
    [25.0, 0.01],
    [24.0, 1e-4],
    [9.8, 1e-4],
    [3.98, 1e-4],
    [1.3, 1e-4],
    [1.15, 1e-4],
    [0.85, 1e-4],
    [0.75, 1e-4],
    [0.6, 1e-4],
    [0.5, 1e-4],
];

/// Steps of 5 deg.
const STEPS: u32 = 36;

/// The rows as CSV, five decimals, with the regime as provenance.
pub fn csv(database: &Database) -> String {
    let mut text = String::from(
        "mach,knudsen_ratio,alpha_deg,axial_force_coefficient,normal_force_coefficient,moment_coefficient,damping_coefficient,provenance\n",
    );
    for [mach, knudsen] in PLACES {
        for n in 0..=STEPS {
            let alpha_deg = 5.0 * f64::from(n);
            let found = database.coefficients(mach, knudsen, alpha_deg * RADIANS_PER_DEGREE);
            // Plus zero: no zero carries a sign.
            let round = |x: f64| (x * 1e5).round() / 1e5 + 0.0;
            text.push_str(&format!(
                "{mach},{knudsen},{alpha_deg},{:.5},{:.5},{:.5},{:.5},{}\n",
                round(found.ca),
                round(found.cn),
                round(found.cm),
                round(found.cmq),
                found.regime.name()
            ));
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::aero::Drag;
    use crate::aero::standard::AeroBody;
    use crate::library::{Library, data_file, named};

    #[test]
    fn the_stored_database_is_what_its_recipe_gives() {
        let library = Library::builtin().unwrap();
        let outline = named(&library.outlines, "mmeev-60").unwrap();
        let body = AeroBody::of_rigid(&outline.body().unwrap(), None);
        let force = named(&library.aerodynamics, "mmeev-60").unwrap();
        let database = body.database(
            &library.aero_standard(),
            Some(&Drag::Table(force.table.clone())),
        );
        let stored = data_file("aero-models/mmeev-60-database.csv").unwrap();
        let rows = stored.lines().filter(|line| !line.starts_with('#'));
        let made = csv(&database);
        assert_eq!(made.lines().count(), 1 + PLACES.len() * 37);
        // panels of a table are integrated to 5e-5, so its recipe may be computed in another order without a new file
        for (stored, made) in rows.zip(made.lines()) {
            for (stored, made) in stored.split(',').zip(made.split(',')) {
                match (stored.parse::<f64>(), made.parse::<f64>()) {
                    (Ok(stored), Ok(made)) => assert!((stored - made).abs() < 1e-4),
                    _ => assert_eq!(stored, made),
                }
            }
        }
    }
}
