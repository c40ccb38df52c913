//! Columns of the time history of a landing, on a rigid surface and on the chosen ground.

use crate::quantity::Column;
use crate::units::Dimension;
use crate::vehicle::impact::history::History;
use crate::vehicle::impact::landing::Landing;

/// A column of the time history of a landing.
#[derive(Clone, Copy)]
pub struct LandingColumn {
    /// Key, unit and meaning.
    pub column: Column,
    /// Function that returns the values in a history.
    pub values: fn(&History) -> &[f64],
}

/// Surface on which the vehicle lands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Surface {
    /// A rigid surface.
    Rigid,
    /// The ground chosen in the case.
    Ground,
}

impl Surface {
    /// Both surfaces, in the order of the columns in files.
    pub const ALL: [Surface; 2] = [Surface::Rigid, Surface::Ground];

    /// Prefix of the keys of the columns for this surface.
    pub fn prefix(self) -> &'static str {
        match self {
            Surface::Rigid => "rigid_surface",
            Surface::Ground => "ground",
        }
    }

    /// Time history of the landing on this surface.
    pub fn history(self, landing: &Landing) -> &History {
        match self {
            Surface::Rigid => &landing.rigid_surface.history,
            Surface::Ground => &landing.ground.history,
        }
    }
}

/// All columns of one surface, in the order of files.
pub fn columns() -> &'static [LandingColumn] {
    COLUMNS
}

/// Keys and values of both surfaces, such as `rigid_surface_time_s`.
pub fn keyed(landing: &Landing) -> impl Iterator<Item = (String, &[f64])> {
    Surface::ALL.into_iter().flat_map(move |surface| {
        let history = surface.history(landing);
        columns().iter().map(move |column| {
            let key = format!("{}_{}", surface.prefix(), column.column.key);
            (key, (column.values)(history))
        })
    })
}

const fn column(
    key: &'static str,
    label: &'static str,
    (dimension, unit): (Dimension, &'static str),
    help: &'static str,
    values: fn(&History) -> &[f64],
) -> LandingColumn {
    LandingColumn {
        column: Column {
            key,
            label,
            dimension,
            unit,
            help,
        },
        values,
    }
}

static COLUMNS: &[LandingColumn] = &[
    column(
        "time_s",
        "Time",
        (Dimension::Time, "ms"),
        "Time after first contact.",
        |h| &h.time_s,
    ),
    column(
        "payload_deceleration_earth_g",
        "Payload Deceleration",
        (Dimension::Load, "Earth g"),
        "Deceleration of the payload.",
        |h| &h.payload_deceleration_earth_g,
    ),
    column(
        "crush_m",
        "Crush",
        (Dimension::Length, "cm"),
        "Crush of the impact foam.",
        |h| &h.crush_m,
    ),
    column(
        "force_n",
        "Force (N)",
        (Dimension::One, ""),
        "Force of the impact foam, in N.",
        |h| &h.force_n,
    ),
    column(
        "penetration_m",
        "Penetration",
        (Dimension::Length, "cm"),
        "Depth of the vehicle in the ground.",
        |h| &h.penetration_m,
    ),
    column(
        "payload_speed_m_s",
        "Payload Velocity",
        (Dimension::Speed, "m/s"),
        "Speed of the payload relative to the ground.",
        |h| &h.payload_speed_m_s,
    ),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::Unit;

    #[test]
    fn units_fit_their_columns_and_keys_stand_once() {
        for (i, LandingColumn { column, .. }) in columns().iter().enumerate() {
            let unit = Unit::find(column.unit).unwrap();
            assert_eq!(unit.dimension, column.dimension, "{}", column.key);
            assert!(
                columns()[..i]
                    .iter()
                    .all(|other| other.column.key != column.key)
            );
        }
    }
    #[test]
    fn a_design_with_its_history_has_that_of_both_landings_in_its_json() {
        use crate::quantity::Job;
        use crate::{Case, Library, Request, answer, design};
        let library = Library::builtin().unwrap();
        let text = crate::library::data_file("cases/galahad.toml").unwrap();
        let case = Case::from_text(text).unwrap();
        let answer = design(&case, &library, Request::Uniform(100.0)).unwrap();
        let object = answer::json(&answer, Job::Design);
        let landing = object["landing"].as_object().unwrap();
        assert_eq!(landing.len(), 2 * columns().len());
        for (key, values) in landing {
            assert_eq!(values.as_array().unwrap().len(), 61, "{key}");
        }
        let pulse = &answer.design.as_ref().unwrap().landing.rigid_surface;
        // the last of 60 steps: 60 (T/60), which is T but for rounding
        let end_s = landing["rigid_surface_time_s"][60].as_f64().unwrap();
        assert!((end_s / pulse.duration_s - 1.0).abs() < 1e-15, "{end_s}");
        assert_eq!(
            landing["ground_payload_speed_m_s"][0],
            object["results"]["impact_speed_m_s"]
        );
        let text = answer::text(&answer, Job::Design);
        assert!(text.contains("\n  \"landing\": {\n    \"rigid_surface_time_s\": [0.0,"));
        let without = design(&case, &library, Request::Nothing).unwrap();
        assert!(answer::json(&without, Job::Design).get("landing").is_none());
    }
}
