//! Outlines of the library: shipped and imported ones.

pub mod drawing;
pub mod facts;
pub mod flight;
pub mod import;

use crate::state::State;
use crate::state::document::Rows;
use leptos::prelude::*;
use msape::Case;
use msape::case::Value;
use msape::quantity::input;
use msape::vehicle::body::{OutlineData, RigidBody, from_rows};

/// Outline of the library.
#[derive(Clone, Debug, PartialEq)]
pub enum Entry {
    /// Shipped outline: its name in cases, and its data.
    Preset(String, OutlineData),
    /// Imported outline: its name and rows.
    Own(String, Rows),
}

impl Entry {
    /// Identifier in links.
    pub fn id(&self) -> String {
        match self {
            Entry::Preset(name, _) => name.clone(),
            Entry::Own(name, _) => format!("own:{name}"),
        }
    }

    /// Displayed name.
    pub fn title(&self) -> String {
        match self {
            Entry::Preset(_, data) => data.title.clone(),
            Entry::Own(name, _) => name.clone(),
        }
    }

    /// Rigid body of the outline; stored and shipped outlines have been checked.
    pub fn body(&self) -> Option<RigidBody> {
        match self {
            Entry::Preset(_, data) => data.body().ok(),
            Entry::Own(name, rows) => from_rows(name, rows).ok(),
        }
    }

    /// Puts the outline into a case.
    pub fn put(&self, case: &mut Case) {
        let (input, value) = match self {
            Entry::Preset(name, _) => (&input::outline::PRESET, Value::Text(name.clone())),
            Entry::Own(_, rows) => (&input::outline::POINTS, Value::Rows(rows.clone())),
        };
        case.values.insert(input.to_string(), value);
    }
}

/// All outlines: the shipped ones, then the imported ones by name.
pub fn entries(state: State) -> Vec<Entry> {
    let mut entries = state.catalog.with(|catalog| {
        let outlines = catalog.iter().flat_map(|catalog| &catalog.outlines);
        outlines
            .map(|(name, data)| Entry::Preset(name.clone(), data.clone()))
            .collect::<Vec<_>>()
    });
    let own = state.document.with(|document| document.outlines.clone());
    entries.extend(
        own.iter()
            .map(|(name, rows)| Entry::Own(name.clone(), rows.clone())),
    );
    entries
}
