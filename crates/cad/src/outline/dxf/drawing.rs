//! Sections of a drawing: unit, layers and their visibility, blocks, entities.
//!
//! # Valid
//! Files may lack HEADER, TABLES or BLOCKS, as release 12 allows.
//!
//! # References
//! - \[autodesk-dxf\] HEADER ($INSUNITS), LAYER (62, 70, 290), BLOCK (2, 10, 20, 70).

use super::group::{Group, Place, Value};
use crate::outline::ImportFault;
use std::collections::BTreeMap;
use std::str::from_utf8;

/// Groups from one code 0 to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Record<'a> {
    /// Record type.
    pub kind: &'a str,
    /// Place in the file.
    pub place: Place,
    groups: &'a [Group<'a>],
}

impl<'a> Record<'a> {
    /// First group with a code.
    pub fn group(&self, code: i32) -> Option<&'a Group<'a>> {
        self.groups.iter().find(|group| group.code == code)
    }

    /// All groups of the record.
    pub fn groups(&self) -> &'a [Group<'a>] {
        self.groups
    }

    /// Text of a group in lower case, for comparing names.
    pub fn name(&self, code: i32) -> Option<String> {
        self.group(code).map(|group| group.name().to_lowercase())
    }

    /// Whole number of a group.
    pub fn whole(&self, code: i32) -> Option<i64> {
        self.group(code).and_then(Group::whole)
    }

    /// Whether a bit of the flags, group 70, is set.
    pub fn flag(&self, bit: i64) -> bool {
        self.whole(70).is_some_and(|flags| flags & bit != 0)
    }

    /// Number of a required group.
    pub fn number(&self, code: i32) -> Result<f64, ImportFault> {
        match self.group(code) {
            Some(group) => group.number(),
            None => Err(self.fault(format!("{} has no group {code}", self.kind))),
        }
    }

    /// Number of an optional group.
    pub fn number_or(&self, code: i32, otherwise: f64) -> Result<f64, ImportFault> {
        self.group(code).map_or(Ok(otherwise), Group::number)
    }

    /// Point with x under `code` and y under `code` + 10.
    pub fn point(&self, code: i32) -> Result<[f64; 2], ImportFault> {
        Ok([self.number(code)?, self.number(code + 10)?])
    }

    /// Numbers of all groups with a code.
    pub fn numbers(&self, code: i32) -> Result<Vec<f64>, ImportFault> {
        let groups = self.groups.iter().filter(|group| group.code == code);
        groups.map(Group::number).collect()
    }

    /// A fault at the place of this record.
    pub fn fault(&self, reason: String) -> ImportFault {
        let place = self.place;
        ImportFault::Drawing { place, reason }
    }
}

/// Reason why a layer or an entity is not drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Hidden {
    /// The layer is off: its color is negative.
    Off,
    /// The layer is frozen.
    Frozen,
    /// The layer is not plotted.
    NotPlotted,
    /// The entity is in paper space: the sheet around the drawing.
    Paper,
    /// The entity is marked as invisible.
    Invisible,
}

/// Block: entities that are drawn where it is inserted.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Block<'a> {
    /// Base point, which is mapped to the insertion point.
    pub base: [f64; 2],
    /// Whether the block refers to another file.
    pub external: bool,
    /// Entities of the block.
    pub entities: Vec<Record<'a>>,
}

/// Sections of a drawing that are needed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing<'a> {
    /// $INSUNITS.
    pub unit: Option<&'a Group<'a>>,
    /// Layers that are not drawn, by lower-case name: reason and name as written.
    pub hidden: BTreeMap<String, (Hidden, String)>,
    /// Whether an insertion is clipped (SPATIAL_FILTER).
    pub clipped: bool,
    /// Blocks by lower-case name.
    pub blocks: BTreeMap<String, Block<'a>>,
    /// Entities of the drawing itself, outside blocks.
    pub entities: Vec<Record<'a>>,
}

/// The drawing that the groups describe.
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
