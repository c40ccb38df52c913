//! Separators of the cells of a line.
//!
//! # References
//! - Own convention.

/// Separator of cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Separator {
    /// A single character.
    Sign(char),
    /// Any number of blanks and tabs.
    Blanks,
}
