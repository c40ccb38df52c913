//! Inputs of which one holds.

use super::Input;

/// Alternative ways to give a quantity, of which a case uses one; each way is one input or several.
pub struct Alternatives {
    /// Name of a quantity that a case must give, as a heading such as `Payload size`.
    pub asked_as: Option<&'static str>,
    /// The ways.
    pub ways: &'static [&'static [&'static Input]],
}

impl Alternatives {
    /// All its inputs, way by way.
    pub fn inputs(&self) -> impl Iterator<Item = &'static Input> {
        self.ways.iter().copied().flatten().copied()
    }
}
