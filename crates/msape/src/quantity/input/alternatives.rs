//! Inputs of which one holds.

use super::Input;

/// Ways to give one thing, of which a case takes one; each way is one input or several.
pub struct Alternatives {
    /// The thing, as a heading: `Payload size`.
    pub label: &'static str,
    /// Whether a case must give one.
    pub required: bool,
    /// The ways.
    pub ways: &'static [&'static [&'static Input]],
}

impl Alternatives {
    /// All its inputs, way by way.
    pub fn inputs(&self) -> impl Iterator<Item = &'static Input> {
        self.ways.iter().copied().flatten().copied()
    }
}
