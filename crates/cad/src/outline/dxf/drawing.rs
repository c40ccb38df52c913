//! Sections of a drawing: its unit, its layers and what hides them, its blocks, its entities.
//!
//! # Valid
//! Files without HEADER, TABLES or BLOCKS too, as release 12 allows.
//!
//! # References
//! - \[autodesk-dxf\] HEADER ($INSUNITS), LAYER (62, 70, 290), BLOCK (2, 10, 20, 70).

use super::group::{Group, Place, Value};
use crate::outline::ImportFault;
use std::collections::BTreeMap;
use std::str::from_utf8;

/// The groups from one code 0 to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Record<'a> {
    /// Its name.
    pub kind: &'a str,
    /// Where it stands.
    pub place: Place,
    groups: &'a [Group<'a>],
}

impl<'a> Record<'a> {
    /// The first group with a code.
    pub fn group(&self, code: i32) -> Option<&'a Group<'a>> {
        self.groups.iter().find(|group| group.code == code)
    }

    /// All of its groups.
    pub fn groups(&self) -> &'a [Group<'a>] {
        self.groups
    }

    /// A text in small letters, as names are compared.
    pub fn name(&self, code: i32) -> Option<String> {
        self.group(code).map(|group| group.name().to_lowercase())
    }

    /// A whole number.
    pub fn whole(&self, code: i32) -> Option<i64> {
        self.group(code).and_then(Group::whole)
    }

    /// Whether a bit of the flags, group 70, is set.
    pub fn flag(&self, bit: i64) -> bool {
        self.whole(70).is_some_and(|flags| flags & bit != 0)
    }

    /// A number that must be there.
    pub fn number(&self, code: i32) -> Result<f64, ImportFault> {
        match self.group(code) {
            Some(group) => group.number(),
            None => Err(self.fault(format!("{} has no group {code}", self.kind))),
        }
    }

    /// A number that may be missing.
    pub fn number_or(&self, code: i32, otherwise: f64) -> Result<f64, ImportFault> {
        self.group(code).map_or(Ok(otherwise), Group::number)
    }

    /// A point, its x under `code`, its y under ten more.
    pub fn point(&self, code: i32) -> Result<[f64; 2], ImportFault> {
        Ok([self.number(code)?, self.number(code + 10)?])
    }

    /// The numbers of all groups with a code.
    pub fn numbers(&self, code: i32) -> Result<Vec<f64>, ImportFault> {
        let groups = self.groups.iter().filter(|group| group.code == code);
        groups.map(Group::number).collect()
    }

    /// Something that is wrong with it.
    pub fn fault(&self, reason: String) -> ImportFault {
        let place = self.place;
        ImportFault::Drawing { place, reason }
    }
}

/// Why a layer, or an entity, is not drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Hidden {
    /// Its layer is off: its color is negative.
    Off,
    /// Its layer is frozen.
    Frozen,
    /// Its layer is not plotted.
    NotPlotted,
    /// It is in paper space: a sheet around the drawing.
    Paper,
    /// It is marked as invisible.
    Invisible,
}

/// A block: entities that are drawn where it is inserted.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Block<'a> {
    /// The point that goes to the point of insertion.
    pub base: [f64; 2],
    /// Whether it is the content of another file.
    pub external: bool,
    /// Its entities.
    pub entities: Vec<Record<'a>>,
}

/// A drawing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing<'a> {
    /// $INSUNITS.
    pub unit: Option<&'a Group<'a>>,
    /// Layers that are not drawn, by name in small letters: why, and their names.
    pub hidden: BTreeMap<String, (Hidden, String)>,
    /// Whether an insertion is clipped (SPATIAL_FILTER).
    pub clipped: bool,
    /// Blocks, by name in small letters.
    pub blocks: BTreeMap<String, Block<'a>>,
    /// Entities of the drawing itself.
    pub entities: Vec<Record<'a>>,
}

/// The drawing of groups.
pub fn drawing<'a>(groups: &'a [Group<'a>]) -> Result<Drawing<'a>, ImportFault> {
    let mut drawing = Drawing::default();
    let mut section = String::new();
    let mut block: Option<(String, Block)> = None;
    let rest = groups.iter().position(|group| group.code == 0);
    let rest = groups.get(rest.unwrap_or(groups.len())..).unwrap_or(&[]);
    for groups in rest.chunk_by(|_, next| next.code != 0) {
        let Some(first) = groups.first() else {
            continue;
        };
        let kind = match first.value {
            Value::Text(bytes) => from_utf8(bytes).unwrap_or("?"),
            _ => "?",
        };
        let place = first.place;
        let record = Record {
            kind,
            place,
            groups,
        };
        match (kind, section.as_str()) {
            ("SECTION", _) => {
                section = record.name(2).unwrap_or_default();
                if section == "header" {
                    let at = groups.iter().position(|group| group.is(9, "$INSUNITS"));
                    drawing.unit = at.and_then(|at| groups.get(at + 1));
                }
            }
            ("ENDSEC", _) => section.clear(),
            ("LAYER", "tables") => {
                if let (Some(group), Some(why)) = (record.group(2), hidden(&record)) {
                    let name = group.name();
                    drawing.hidden.insert(name.to_lowercase(), (why, name));
                }
            }
            ("BLOCK", "blocks") => {
                let base = [record.number_or(10, 0.0)?, record.number_or(20, 0.0)?];
                let external = record.flag(4);
                let entities = Vec::new();
                let opened = Block {
                    base,
                    external,
                    entities,
                };
                block = Some((record.name(2).unwrap_or_default(), opened));
            }
            ("ENDBLK", "blocks") => drawing.blocks.extend(block.take()),
            (_, "blocks") => {
                if let Some((_, block)) = &mut block {
                    block.entities.push(record);
                }
            }
            (_, "entities") => drawing.entities.push(record),
            ("SPATIAL_FILTER", "objects") => drawing.clipped = true,
            _ => {}
        }
    }
    Ok(drawing)
}

fn hidden(layer: &Record) -> Option<Hidden> {
    if layer.flag(1) {
        Some(Hidden::Frozen)
    } else if layer.whole(62).is_some_and(|color| color < 0) {
        Some(Hidden::Off)
    } else if layer.whole(290) == Some(0) {
        Some(Hidden::NotPlotted)
    } else {
        None
    }
}
