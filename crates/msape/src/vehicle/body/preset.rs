//! Outlines of known vehicles, read from a file of `data/outlines`: each dimension with its source, assumed ones marked.
//!
//! ```text
//! length' = length D' / D        where a case gives the diameter D' beside the preset
//! ```
//!
//! with lengths in m; angles stay.
//!
//! # Valid
//! Same as [`crate::vehicle::body::shape`].
//!
//! # References
//! - Those of each file.

use crate::data::Data;
use crate::vehicle::body::RigidBody;
use crate::vehicle::body::shape::{Aft, AftCone, Shape};
use crate::vehicle::rules::Datum;
use numerics::math::RADIANS_PER_DEGREE;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Aftbody of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum AftKind {
    /// [`Aft::Flat`].
    Flat,
    /// [`Aft::Mmeev`].
    Mmeev,
    /// [`Aft::Cones`], or [`Aft::Capped`] where the file has a cap radius.
    Cones,
}

/// A file of `data/outlines`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OutlineData {
    /// Title.
    pub title: String,
    /// Key in the list of references.
    pub source: String,
    /// Place in the source.
    pub place: String,
    /// Note for the reader.
    pub note: String,
    /// Aftbody.
    pub aft: AftKind,
    /// Dimensions, by name.
    pub dimension: BTreeMap<String, Datum>,
}

/// Aft cones that a file may have.
const MOST_CONES: usize = 4;

impl OutlineData {
    /// Reads a file of `data/outlines`; dimensions that make no outline are an error too.
    pub fn parse(data: Data) -> Result<Self, String> {
        let data: Self = data.read()?;
        data.body()?;
        Ok(data)
    }

    /// Shape that the dimensions define.
    pub fn shape(&self) -> Result<Shape, String> {
        let mut read = 0;
        let mut get = |key: &str| {
            let value = self.dimension.get(key).map(|datum| datum.value);
            read += usize::from(value.is_some());
            value
        };
        let needed = |key: &str, value: Option<f64>| value.ok_or(format!("{key} is missing"));
        let shape = Shape {
            diameter_m: needed("diameter_m", get("diameter_m"))?,
            nose_radius_m: needed("nose_radius_m", get("nose_radius_m"))?,
            shoulder_radius_m: needed("shoulder_radius_m", get("shoulder_radius_m"))?,
            cone_half_angle_rad: get("cone_half_angle_deg").map(|deg| deg * RADIANS_PER_DEGREE),
            aft: match self.aft {
                AftKind::Flat => Aft::Flat,
                AftKind::Mmeev => Aft::Mmeev,
                AftKind::Cones => {
                    let mut cones = Vec::new();
                    for i in 1..=MOST_CONES {
                        let Some(deg) = get(&format!("aft_cone_{i}_half_angle_deg")) else {
                            break;
                        };
                        cones.push(AftCone {
                            half_angle_rad: deg * RADIANS_PER_DEGREE,
                            end_radius_m: get(&format!("aft_cone_{i}_end_radius_m")).unwrap_or(0.0),
                        });
                    }
                    match get("aft_cap_radius_m") {
                        Some(cap_radius_m) => Aft::Capped {
                            cones,
                            cap_radius_m,
                        },
                        None => Aft::Cones(cones),
                    }
                }
            },
        };
        if read < self.dimension.len() {
            let keys = self.dimension.keys();
            return Err(format!("a dimension is not known, among: {keys:?}"));
        }
        Ok(shape)
    }

    /// Body of the shape, at the size in the file.
    pub fn body(&self) -> Result<RigidBody, String> {
        self.scaled_body(None)
    }

    /// Body of the shape, scaled to another diameter if one is given.
    pub fn scaled_body(&self, diameter_m: Option<f64>) -> Result<RigidBody, String> {
        let shape = self.shape()?;
        let factor = diameter_m.map_or(1.0, |diameter| diameter / shape.diameter_m);
        let shape = if factor == 1.0 {
            shape
        } else {
            shape.scaled(factor)
        };
        let mut body = shape.body(&self.title).map_err(|faults| {
            let said: Vec<String> = faults
                .iter()
                .map(|(key, m)| format!("{key}: {m}"))
                .collect();
            said.join("; ")
        })?;
        body.notes.push(self.note.clone());
        let assumed: Vec<&str> = self
            .dimension
            .iter()
            .filter(|(_, datum)| datum.source == "assumed")
            .map(|(key, _)| key.as_str())
            .collect();
        if !assumed.is_empty() {
            body.notes.push(format!("Assumed: {}.", assumed.join(", ")));
        }
        if factor != 1.0 {
            let note = format!("Scaled by {factor} to a diameter of {} m.", body.diameter_m);
            body.notes.push(note);
        }
        Ok(body)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: &str = "title='x'\nsource='assumed'\nplace='x'\nnote='x'\naft='cones'\n[dimension]\n\
        diameter_m={value=2.0,source='assumed',place='x'}\n\
        nose_radius_m={value=0.5,source='assumed',place='x'}\n\
        shoulder_radius_m={value=0.1,source='assumed',place='x'}\n\
        cone_half_angle_deg={value=60.0,source='assumed',place='x'}\n\
        aft_cone_1_half_angle_deg={value=30.0,source='assumed',place='x'}\n\
        aft_cone_1_end_radius_m={value=0.4,source='assumed',place='x'}\n";

    #[test]
    fn a_file_is_an_outline_and_scales_with_its_diameter() {
        let data = OutlineData::parse(FILE.into()).unwrap();
        let (one, half) = (data.body().unwrap(), data.scaled_body(Some(1.0)).unwrap());
        let ratio = one.outline.solid().volume_m3 / half.outline.solid().volume_m3;
        assert!((ratio - 8.0).abs() < 1e-12);
        assert_eq!(half.diameter_m, 1.0);
        assert!(half.notes.iter().any(|note| note.starts_with("Scaled")));
    }

    #[test]
    fn unknown_missing_and_impossible_dimensions_are_refused() {
        let refused = |from: &str, to: &str| {
            OutlineData::parse(FILE.replace(from, to).as_str().into()).unwrap_err()
        };
        assert!(refused("nose_radius_m", "nose_m").contains("nose_radius_m is missing"));
        assert!(refused("aft_cone_1_end", "aft_cone_2_end").contains("not known"));
        assert!(refused("value=0.4", "value=1.4").contains("must narrow"));
    }

    #[test]
    fn every_shipped_outline_is_sound() {
        let mut count = 0;
        for (path, text) in crate::library::data_folder("outlines") {
            let data = OutlineData::parse(text.into()).unwrap_or_else(|e| panic!("{path}: {e}"));
            let open = data.shape().unwrap().outline();
            let faults = crate::vehicle::body::check::faults(&open);
            assert!(faults.is_empty(), "{path}: {faults:?}");
            count += 1;
        }
        assert!(count >= 7);
    }

    #[test]
    fn known_heights_come_out() {
        let height = |name: &str| {
            let text = crate::library::data_file(&format!("outlines/{name}.toml")).unwrap();
            OutlineData::parse(text.into())
                .unwrap()
                .body()
                .unwrap()
                .length_m()
        };
        // Apollo 135 in; Genesis was divided so; Hayabusa 0.20 m, to the millimeters of its transcription
        assert!((height("apollo") - 135.0 * 0.0254).abs() < 0.01);
        assert!((height("genesis") - 1.31).abs() < 1e-3);
        assert!((height("hayabusa") - 0.20).abs() < 0.005);
    }
}
