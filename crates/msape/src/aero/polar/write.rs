//! A polar as JSON and as CSV: one array, or one column, a coefficient.
//!
//! ```text
//! alpha_deg, ca, cn, cm_apex, cm_cg, cd, cl, cmq
//! ```
//!
//! # Valid
//! Unknown values, such as a moment about a center of gravity that was not given, are `null`, or an empty column.
//!
//! # References
//! - Own convention.

use super::{Polar, Row};
use crate::finding::Finding;
use crate::units::number::shortest;
use serde_json::{Map, Value, json};

/// A column: its name, and the function that takes its number from a row.
pub type Column = (&'static str, fn(&Row) -> Option<f64>);

/// The columns of a polar.
pub const COLUMNS: [Column; 8] = [
    ("alpha_deg", |row| Some(row.alpha_deg)),
    ("ca", |row| Some(row.ca)),
    ("cn", |row| Some(row.cn)),
    ("cm_apex", |row| Some(row.cm_apex)),
    ("cm_cg", |row| row.cm_cg),
    ("cd", |row| Some(row.cd)),
    ("cl", |row| Some(row.cl)),
    ("cmq", |row| row.cmq),
];

impl Polar {
    /// One object: `name`, `outcome`, `results` with an array a coefficient, `trim`, `pressure_center_over_diameter`,
    /// `static_margin_over_diameter`, `findings`.
    pub fn json(&self, name: &str, findings: &[Finding]) -> Value {
        let mut results = Map::new();
        for (key, get) in COLUMNS {
            let values: Option<Vec<f64>> = self.rows.iter().map(get).collect();
            let values = values.filter(|_| !self.rows.is_empty());
            results.insert(key.to_string(), json!(values));
        }
        json!({
            "name": name,
            "outcome": "computed",
            "results": results,
            "trim": self.trim,
            "pressure_center_over_diameter": self.pressure_center,
            "static_margin_over_diameter": self.static_margin,
            "findings": findings,
        })
    }

    /// A line an angle, after a line of names.
    pub fn csv(&self) -> String {
        let mut text = COLUMNS.map(|(key, _)| key).join(",");
        text.push('\n');
        for row in &self.rows {
            let cells = COLUMNS.map(|(_, get)| get(row).map(shortest).unwrap_or_default());
            text.push_str(&cells.join(","));
            text.push('\n');
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_a_center_of_gravity_its_moment_is_null() {
        let row = Row {
            alpha_deg: 5.0,
            ca: 1.5,
            cn: 0.1,
            cm_apex: -0.05,
            cm_cg: None,
            cd: 1.5,
            cl: 0.0,
            cmq: None,
        };
        let polar = Polar {
            rows: vec![row],
            trim: Vec::new(),
            pressure_center: Some(0.5),
            static_margin: None,
        };
        let object = polar.json("a", &[]);
        assert_eq!(object["results"]["cm_cg"], Value::Null);
        assert_eq!(object["results"]["ca"], json!([1.5]));
        assert_eq!(
            polar.csv(),
            "alpha_deg,ca,cn,cm_apex,cm_cg,cd,cl,cmq\n5,1.5,0.1,-0.05,,1.5,0,\n"
        );
    }
}
