//! What divides the cells of a line.
//!
//! # References
//! - Own convention.

/// What stands between cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Separator {
    /// One character.
    Sign(char),
    /// Blanks and tabs, any number of them.
    Blanks,
}
