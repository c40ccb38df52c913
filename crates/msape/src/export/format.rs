//! The formats, declared once: name, ending, media type, writer.

use crate::export::model::Model;
use crate::export::{Info, step};

/// A kind of file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Solids: ISO 10303-21, application protocol 214.
    Step,
}

impl Format {
    /// All of them, in the order in which they are offered.
    pub const ALL: [Format; 1] = [Format::Step];

    /// Name, as typed.
    pub fn name(self) -> &'static str {
        match self {
            Format::Step => "step",
        }
    }

    /// The format of this name.
    pub fn named(name: &str) -> Option<Format> {
        Self::ALL.into_iter().find(|f| f.name() == name)
    }

    /// The model as a file of this format.
    pub fn write(self, model: &Model, info: &Info) -> Vec<u8> {
        match self {
            Format::Step => step::step(model, info).into_bytes(),
        }
    }
}
