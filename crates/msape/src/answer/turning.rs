//! Entries from a set of attitudes and rates as files have them: SI units, angles in degrees.

use crate::flight::six_dof::events::AngleAt;
use crate::flight::six_dof::reorientation::Facing;
use crate::flight::six_dof::turning::{Turn, Turning};
use numerics::math::RADIANS_PER_DEGREE;
use serde_json::{Map, Value, json as value};

/// A number or a word of an entry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cell {
    /// A number; absent where it did not occur.
    Number(Option<f64>),
    /// A word.
    Word(&'static str),
}

/// A column of the table of entries.
#[derive(Clone, Copy)]
pub struct Column {
    /// Key with its unit.
    pub key: &'static str,
    /// Heading, with the unit of the key.
    pub label: &'static str,
    /// The cell of an entry.
    pub cell: fn(&Turn) -> Cell,
}

/// `forward`, `unsteady` or `backward`.
pub fn word(facing: Facing) -> &'static str {
    match facing {
        Facing::Forward => "forward",
        Facing::Unsteady => "unsteady",
        Facing::Backward => "backward",
    }
}

fn number(x: f64) -> Cell {
    Cell::Number(Some(x))
}

fn degrees(rad: f64) -> Cell {
    // The angles of the set are whole degrees up to rounding in the conversion to radians and back.
    let deg = rad / RADIANS_PER_DEGREE;
    let whole = deg.round();
    number(if (deg - whole).abs() < 1e-9 {
        whole
    } else {
        deg
    })
}

/// The columns, in the order of tables and files.
pub static COLUMNS: [Column; 10] = [
    Column {
        key: "alpha_deg",
        label: "Angle of Attack (deg)",
        cell: |t| degrees(t.start.alpha_rad),
    },
    Column {
        key: "pitch_rate_deg_s",
        label: "Pitch Rate (deg/s)",
        cell: |t| degrees(t.start.pitch_rate_rad_s),
    },
    Column {
        key: "facing",
        label: "Facing",
        cell: |t| Cell::Word(word(t.facing)),
    },
    Column {
        key: "total_alpha_at_peak_heating_deg",
        label: "At Max Heat Rate (deg)",
        cell: |t| degrees(t.attitude.total_alpha_at_peak_heating_rad),
    },
    Column {
        key: "maximum_total_alpha_after_peak_heating_deg",
        label: "Max after it (deg)",
        cell: |t| {
            let AngleAt { angle_rad, .. } = t.attitude.maximum_total_alpha_after_peak_heating;
            degrees(angle_rad)
        },
    },
    Column {
        key: "last_hemisphere_change_time_s",
        label: "Last Turn through 90 deg (s)",
        cell: |t| Cell::Number(t.attitude.hemisphere_change_times_s.last().copied()),
    },
    Column {
        key: "last_hemisphere_change_knudsen",
        label: "At Knudsen Number",
        cell: |t| Cell::Number(t.attitude.last_hemisphere_change_knudsen),
    },
    Column {
        key: "first_below_10_deg_time_s",
        label: "First below 10 deg (s)",
        cell: |t| Cell::Number(t.attitude.first_below_10_deg_time_s),
    },
    Column {
        key: "first_below_10_deg_knudsen",
        label: "At Knudsen Number, below 10 deg",
        cell: |t| Cell::Number(t.attitude.first_below_10_deg_knudsen),
    },
    Column {
        key: "peak_heating_altitude_m",
        label: "Altitude of Max Heat Rate (m)",
        cell: |t| number(t.peak_heating_altitude_m),
    },
];

/// JSON object with the share of entries that are nose first at peak heating, and the entries, one object each.
pub fn json(turning: &Turning) -> Value {
    let entry = |turn: &Turn| {
        let cells = COLUMNS.iter().map(|column| {
            let cell = match (column.cell)(turn) {
                Cell::Number(x) => value!(x.filter(|x| x.is_finite())),
                Cell::Word(word) => value!(word),
            };
            (column.key.to_string(), cell)
        });
        Value::Object(cells.collect::<Map<String, Value>>())
    };
    let entries: Vec<Value> = turning.entries.iter().map(entry).collect();
    value!({ "nose_first_share": turning.nose_first_share(), "entries": entries })
}

/// Sentence that states how many entries are nose first at the largest heat rate.
pub fn sentence(turning: &Turning) -> String {
    format!(
        "{} of {} entries are nose first at the largest heat rate.",
        turning.nose_first(),
        turning.entries.len()
    )
}
