//! Contents of the database when a tab opens. Records that cannot be read are listed, never dropped.

use super::ledger::Ledger;
use super::record::{Found, Key, Sheet, Sort, read};
use crate::state::document::{Apart, Document, Place, Rows, Run, Why, recorded};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Outlines and tables that an earlier version stored in the record of the document.
type Legacy = (BTreeMap<String, Rows>, BTreeMap<String, Rows>);

/// Record that cannot be read.
#[derive(Clone, Debug, PartialEq)]
pub struct Unreadable {
    /// Key.
    pub key: Key,
    /// Description for the user.
    pub what: String,
    /// Reason.
    pub why: String,
    /// Content.
    pub found: Found,
}

/// Separately stored work.
#[derive(Clone, Debug, PartialEq)]
pub struct KeptApart {
    /// Identifier of the record.
    pub id: String,
    /// Case, units and place; no runs, outlines or tables.
    pub document: Document,
    /// Time of storing, ms since 1970.
    pub saved_ms: Option<f64>,
    /// Reason for separate storage.
    pub why: Why,
}

/// Stored work.
#[derive(Clone, Debug, PartialEq)]
pub struct StoredWork {
    /// Document without runs, outlines and tables.
    pub document: Document,
    /// Time of storing, ms since 1970.
    pub saved_ms: Option<f64>,
    /// Changes that affect its case since it was stored.
    pub remarks: Vec<String>,
}

/// Everything found.
#[derive(Debug, Default)]
pub struct Stock {
    /// Initial knowledge of the tab.
    pub ledger: Ledger,
    /// The stored work.
    pub work: Option<StoredWork>,
    /// Separately stored work.
    pub apart: Vec<KeptApart>,
    /// Named runs.
    pub runs: BTreeMap<String, Run>,
    /// Imported outlines.
    pub outlines: BTreeMap<String, Rows>,
    /// Imported tables.
    pub tables: BTreeMap<String, Rows>,
    /// Records that cannot be read.
    pub unreadable: Vec<Unreadable>,
}

impl Stock {
    /// Parses all records.
    pub fn take(records: Vec<(Key, Found)>) -> Stock {
        let mut stock = Stock::default();
        let mut legacy = None;
        for (key, found) in records {
            let why = match key.sort() {
                Sort::Current => stock.take_current(&key, &found, &mut legacy),
                Sort::Apart(id) => stock.take_apart(id, &key, &found),
                Sort::Outline(name) => {
                    read(&found).map(|rows| drop(stock.outlines.insert(name, rows)))
                }
                Sort::Table(name) => read(&found).map(|rows| drop(stock.tables.insert(name, rows))),
                Sort::Run(id) => read::<Run>(&found).and_then(|run| {
                    readable(&run.case, run.version)?;
                    stock.runs.insert(id, run);
                    Ok(())
                }),
                Sort::Unknown => continue,
            };
            match (why, &found) {
                (Ok(()), Found::Text(text)) => stock.ledger.knows(key, text.clone()),
                (Ok(()), Found::Other(_)) => {}
                (Err(why), _) => {
                    let what = described(&key, &found);
                    stock.unreadable.push(Unreadable {
                        key,
                        what,
                        why,
                        found,
                    });
                }
            }
        }
        stock
            .ledger
            .keeps(&stock.runs, &stock.outlines, &stock.tables);
        // items that earlier versions stored in this record become separate records
        if let Some((outlines, tables)) = legacy {
            for (name, rows) in outlines {
                stock.outlines.entry(name).or_insert(rows);
            }
            for (name, rows) in tables {
                stock.tables.entry(name).or_insert(rows);
            }
        }
        stock
    }

    fn take_current(
        &mut self,
        key: &Key,
        found: &Found,
        legacy: &mut Option<Legacy>,
    ) -> Result<(), String> {
        let mut sheet: Sheet = read(found)?;
        if !(sheet.outlines.is_empty() && sheet.tables.is_empty()) {
            *legacy = Some((
                std::mem::take(&mut sheet.outlines),
                std::mem::take(&mut sheet.tables),
            ));
        }
        let (document, remarks) = document_of(&sheet, Place::Stored)?;
        // the record of an earlier version is rewritten with the next change
        if legacy.is_none() {
            self.ledger.says(key.clone(), sheet.clone());
        }
        self.work = Some(StoredWork {
            document,
            saved_ms: sheet.saved_ms,
            remarks,
        });
        Ok(())
    }

    fn take_apart(&mut self, id: String, key: &Key, found: &Found) -> Result<(), String> {
        let sheet: Sheet = read(found)?;
        let why = sheet.why.unwrap_or(Why::Unread);
        let opened = None;
        let place = Place::Apart(Arc::new(Apart {
            id: id.clone(),
            why,
            opened,
        }));
        let (document, _) = document_of(&sheet, place)?;
        self.apart.push(KeptApart {
            id,
            document,
            saved_ms: sheet.saved_ms,
            why,
        });
        self.ledger.says(key.clone(), sheet);
        Ok(())
    }

    /// Makes the unsaved work of a closed page the stored work again, if that has not changed since. Removes records of
    /// work that was saved after all.
    pub fn go_on(&mut self) {
        let (ledger, key) = (&mut self.ledger, Key::current());
        self.apart.retain(|apart| {
            let own = Key::apart(&apart.id);
            let written = match (ledger.sheet(&own), ledger.sheet(&key)) {
                (Some(last), Some(kept)) => apart.why == Why::Closed && last.says_as(kept),
                _ => false,
            };
            if written {
                ledger.dooms(own);
            }
            !written
        });
        let current = self.ledger.text(&Key::current()).unwrap_or_default();
        let goes_on = |ledger: &Ledger, apart: &KeptApart| {
            let sheet = ledger.sheet(&Key::apart(&apart.id));
            sheet.is_some_and(|sheet| sheet.continues.as_deref() == Some(current.as_str()))
        };
        let Some(at) = (self.apart.iter()).position(|apart| goes_on(&self.ledger, apart)) else {
            return;
        };
        let apart = self.apart.remove(at);
        self.ledger.dooms(Key::apart(&apart.id));
        self.work = Some(StoredWork {
            document: Document {
                place: Place::Stored,
                ..apart.document
            },
            saved_ms: apart.saved_ms,
            remarks: Vec::new(),
        });
    }
}

/// Document of a sheet, and the changes that affect its case since it was stored.
fn document_of(sheet: &Sheet, place: Place) -> Result<(Document, Vec<String>), String> {
    let case = recorded(&sheet.case, sheet.version).map_err(|faults| joined(&faults))?;
    let document = Document {
        units: sheet.units,
        unit_of: Arc::new(sheet.unit_of.clone()),
        place,
        ..Document::new(case.case)
    };
    Ok((document, case.remarks))
}

fn readable(case: &str, version: Option<msape::case::Version>) -> Result<(), String> {
    recorded(case, version)
        .map(drop)
        .map_err(|faults| joined(&faults))
}

fn joined(faults: &[msape::InputError]) -> String {
    let faults: Vec<String> = faults.iter().map(ToString::to_string).collect();
    faults.join("; ")
}

/// Description of an unreadable record, with its name if that can be read.
fn described(key: &Key, found: &Found) -> String {
    let value: Option<serde_json::Value> = read(found).ok();
    let name = value.as_ref().and_then(|value| value.get("name")?.as_str());
    match (key.sort(), name) {
        (Sort::Run(_), Some(name)) => format!("the saved run {name}"),
        _ => key.words(),
    }
}
