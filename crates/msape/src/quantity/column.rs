//! A column of a time history.

use crate::units::Dimension;

/// One column: key, unit and meaning; the lists stand beside what is sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Column {
    /// Key with its SI unit, such as `altitude_m`.
    pub key: &'static str,
    /// Name for axes and headers, without the unit.
    pub label: &'static str,
    /// Dimension of its values.
    pub dimension: Dimension,
    /// Symbol of the unit shown by default.
    pub unit: &'static str,
    /// One sentence: what it is.
    pub help: &'static str,
}
