//! Selection of the curves that form the outline: entities of model space, blocks where they are inserted, and messages
//! on what is left out.
//!
//! ```text
//! point of the drawing = insertion + turn (place in the array + scale (point of the block − base))
//! ```
//!
//! Left out are paper space, invisible entities, layers that are off, frozen or not plotted (the usual place of
//! construction lines), construction lines (XLINE, RAY) and entities without lines: text, points, dimensions, hatches,
//! images. An entity on layer 0 of a block takes the layer of its insertion. Where something is drawn on a layer called
//! `outline`, or in a block inserted on it, only that counts.
//!
//! # Valid
//! Nested blocks to a depth of 32; 200,000 entities in all, each counted as often as it is inserted.
//!
//! # References
//! - \[autodesk-dxf\] groups 8, 60, 67; INSERT; SPATIAL_FILTER; \[ezdxf\] layer 0 of blocks.

use super::affine::Affine;
use super::curve::Curve;
use super::drawing::{Block, Drawing, Hidden, Record};
use super::entity::{curves, is_read, seen};
use super::group::{Group, Place};
use crate::outline::{ImportFault, MOST_FAULTS, shown};
use std::collections::BTreeMap;

/// Largest number of entities read, including those of inserted blocks.
pub const MOST_ENTITIES: usize = 200_000;
/// Largest depth of nested blocks.
const DEPTH: usize = 32;
/// Largest number of layers, and of entity types, named in a message.
const MOST_NAMED: usize = 12;

/// Entity types that are never part of an outline.
const PASSED_OVER: [&str; 30] = [
    "TEXT",
    "MTEXT",
    "RTEXT",
    "POINT",
    "DIMENSION",
    "ARC_DIMENSION",
    "LARGE_RADIAL_DIMENSION",
    "LEADER",
    "MULTILEADER",
    "MLEADER",
    "TOLERANCE",
    "ATTDEF",
    "HATCH",
    "MPOLYGON",
    "SOLID",
    "TRACE",
    "WIPEOUT",
    "IMAGE",
    "VIEWPORT",
    "XLINE",
    "RAY",
    "OLEFRAME",
    "OLE2FRAME",
    "ACAD_TABLE",
    "SHAPE",
    "DGNUNDERLAY",
    "DWFUNDERLAY",
    "PDFUNDERLAY",
    "LIGHT",
    "SUN",
];
/// Records that belong to the preceding entity.
const PARTS: [&str; 3] = ["VERTEX", "ATTRIB", "SEQEND"];

/// Curves of layer `outline` or of all other layers, with faults.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Found {
    /// Curves with their places in the file.
    pub curves: Vec<(Curve, Place)>,
    /// Faults.
    pub faults: Vec<ImportFault>,
}

/// Content of a drawing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawn {
    /// Curves on layer `outline`.
    outline: Found,
    /// Curves on other layers.
    others: Found,
    hidden: BTreeMap<(Hidden, String), usize>,
    passed_over: BTreeMap<String, usize>,
    visited: usize,
}

/// State of nested insertions.
#[derive(Clone)]
struct Nest<'n> {
    map: Affine,
    /// Layer of the insertion.
    layer: Option<&'n str>,
    /// Whether an insertion was on the layer `outline`.
    outline: bool,
    depth: usize,
}

/// Curves of a drawing and what is left out; lengths are multiplied by `scale`.
pub fn drawn(drawing: &Drawing, scale: f64) -> Drawn {
    let mut drawn = Drawn::default();
    let nest = Nest {
        map: Affine::scale(scale, scale),
        layer: None,
        outline: false,
        depth: 0,
    };
    drawn.visit(drawing, &drawing.entities, &nest);
    drawn
}

impl Drawn {
    /// The curves that count, and messages on those that do not.
    pub fn counted(self) -> (Found, Vec<String>) {
        let mut remarks: Vec<String> = [self.hidden_words(), self.passed_over_words()]
            .into_iter()
            .flatten()
            .collect();
        if self.outline.curves.is_empty() && self.outline.faults.is_empty() {
            return (self.others, remarks);
        }
        let left = self.others.curves.len();
        if left > 0 {
            remarks.push(format!(
                "only the layer outline counts; {left} curve{} of other layers left out",
                if left == 1 { " is" } else { "s are" }
            ));
        }
        (self.outline, remarks)
    }

    /// Message on hidden entities, if there are any.
    fn hidden_words(&self) -> Option<String> {
        let one = |((why, layer), count): (&(Hidden, String), &usize)| {
            let layer = shown(layer);
            match why {
                Hidden::Off => format!("{count} on the layer {layer}, which is off"),
                Hidden::Frozen => format!("{count} on the layer {layer}, which is frozen"),
                Hidden::NotPlotted => format!("{count} on the layer {layer}, which is not plotted"),
                Hidden::Paper => format!("{count} in paper space"),
                Hidden::Invisible => format!("{count} invisible"),
            }
        };
        listed(
            "entities that are not drawn are left out",
            self.hidden.iter().map(one),
        )
    }

    fn passed_over_words(&self) -> Option<String> {
        let one = |(kind, count): (&String, &usize)| format!("{count} {kind}");
        listed(
            "entities that are no part of an outline are left out",
            self.passed_over.iter().map(one),
        )
    }

    /// Counts an entity; false once there are too many.
    fn counts(&mut self, entity: &Record) -> bool {
        self.visited += 1;
        if self.visited == MOST_ENTITIES + 1 {
            let fault = entity.fault(format!(
                "the drawing has more than {MOST_ENTITIES} entities, insertions of blocks counted; keep only the outline"
            ));
            self.outline.faults.push(fault.clone());
            self.others.faults.push(fault);
        }
        self.visited <= MOST_ENTITIES
    }

    fn visit(&mut self, drawing: &Drawing, records: &[Record], nest: &Nest) {
        for (i, entity) in records.iter().enumerate() {
            if PARTS.contains(&entity.kind) {
                continue;
            }
            if !self.counts(entity) {
                return;
            }
            let own = entity.name(8).unwrap_or_else(|| "0".to_owned());
            let layer = nest.layer.filter(|_| own == "0").unwrap_or(&own);
            let why = self.hides(drawing, entity, layer, nest.depth);
            let insert = entity.kind == "INSERT";
            // a layer that is off hides a block's entities on layer 0, but not those on other layers
            let through = insert && matches!(why, Some((Hidden::Off | Hidden::NotPlotted, _)));
            if let Some(why) = why
                && !through
            {
                *self.hidden.entry(why).or_default() += 1;
                continue;
            }
            let outline = nest.outline || layer == "outline";
            if insert {
                let inner = Nest {
                    map: nest.map,
                    layer: Some(layer),
                    outline,
                    depth: nest.depth + 1,
                };
                if let Err(fault) = self.insert(drawing, entity, &inner) {
                    self.found(outline).fault(fault);
                }
            } else if is_read(entity.kind) {
                let vertices = records.get(i + 1..).unwrap_or(&[]);
                let count = vertices.iter().take_while(|record| record.kind == "VERTEX");
                let vertices = vertices.get(..count.count()).unwrap_or(&[]);
                self.found(outline).take(entity, vertices, &nest.map);
            } else if PASSED_OVER.contains(&entity.kind) {
                *self.passed_over.entry(entity.kind.to_owned()).or_default() += 1;
            } else {
                self.found(outline).fault(ImportFault::Entity {
                    place: entity.place,
                    kind: shown(entity.kind),
                });
            }
        }
    }

    fn found(&mut self, outline: bool) -> &mut Found {
        match outline {
            true => &mut self.outline,
            false => &mut self.others,
        }
    }

    /// Reason why an entity is not drawn, and the name of the layer that hides it.
    fn hides(
        &self,
        drawing: &Drawing,
        entity: &Record,
        layer: &str,
        depth: usize,
    ) -> Option<(Hidden, String)> {
        if depth == 0 && entity.whole(67) == Some(1) {
            Some((Hidden::Paper, String::new()))
        } else if entity.whole(60) == Some(1) {
            Some((Hidden::Invisible, String::new()))
        } else {
            drawing.hidden.get(layer).cloned()
        }
    }

    fn insert(
        &mut self,
        drawing: &Drawing,
        entity: &Record,
        nest: &Nest,
    ) -> Result<(), ImportFault> {
        let name = entity.name(2).unwrap_or_default();
        let block = match drawing.blocks.get(&name) {
            Some(block) if !block.external => block,
            Some(_) => {
                return Err(entity.fault(format!(
                    "INSERT: the block \"{}\" is another file; bind it into the drawing",
                    shown(&name)
                )));
            }
            None => {
                return Err(entity.fault(format!(
                    "INSERT: the drawing has no block \"{}\"",
                    shown(&name)
                )));
            }
        };
        let extended = |group: &Group| group.is(102, "{ACAD_XDICTIONARY");
        if drawing.clipped && entity.groups().iter().any(extended) {
            return Err(entity.fault(format!(
                "INSERT: the block \"{}\" may be clipped, which is not read; draw what is left of it",
                shown(&name)
            )));
        }
        if nest.depth > DEPTH {
            return Err(entity.fault(format!(
                "INSERT: blocks in blocks deeper than {DEPTH}; does \"{}\" hold itself?",
                shown(&name)
            )));
        }
        let (frame, inner) = frames(entity, block)?;
        let [columns, rows] = [70, 71].map(|code| entity.whole(code).unwrap_or(1).max(1));
        let spacing = [entity.number_or(44, 0.0)?, entity.number_or(45, 0.0)?];
        let outer = nest.map.after(&frame);
        for row in 0..rows {
            for column in 0..columns {
                if !self.counts(entity) {
                    return Ok(());
                }
                let place = Affine::shift([spacing[0] * column as f64, spacing[1] * row as f64]);
                let map = outer.after(&place.after(&inner));
                self.visit(
                    drawing,
                    &block.entities,
                    &Nest {
                        map,
                        ..nest.clone()
                    },
                );
            }
        }
        Ok(())
    }
}

/// Maps of an insertion that apply before and after the shift to a place of its array.
fn frames(entity: &Record, block: &Block) -> Result<(Affine, Affine), ImportFault> {
    let at = [entity.number_or(10, 0.0)?, entity.number_or(20, 0.0)?];
    let scale = [entity.number_or(41, 1.0)?, entity.number_or(42, 1.0)?];
    let turn = Affine::turn(entity.number_or(50, 0.0)?);
    let outer = seen(entity)?.after(&Affine::shift(at).after(&turn));
    let inner =
        Affine::scale(scale[0], scale[1]).after(&Affine::shift(block.base.map(|part| -part)));
    Ok((outer, inner))
}

impl Found {
    fn fault(&mut self, fault: ImportFault) {
        if self.faults.len() < MOST_FAULTS {
            self.faults.push(fault);
        }
    }

    fn take(&mut self, entity: &Record, vertices: &[Record], map: &Affine) {
        match curves(entity, vertices) {
            Ok(curves) => {
                let moved = curves.iter().flat_map(|curve| curve.moved(map));
                self.curves.extend(moved.map(|curve| (curve, entity.place)));
            }
            Err(fault) => self.fault(fault),
        }
    }
}

/// "what: a, b, and 3 more"; `None` for an empty list.
fn listed(what: &str, parts: impl ExactSizeIterator<Item = String>) -> Option<String> {
    let count = parts.len();
    let more = count.saturating_sub(MOST_NAMED);
    let list = parts.take(MOST_NAMED).collect::<Vec<_>>().join(", ");
    let end = if more > 0 {
        format!(", and {more} more")
    } else {
        String::new()
    };
    (count > 0).then(|| format!("{what}: {list}{end}"))
}
