//! Inputs of which one holds.

use super::Input;

/// Alternative ways to give a quantity, of which a case uses one; each way is one input or several.
pub struct Alternatives {
    /// Name of the quantity as a heading, such as `Payload size`.
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
