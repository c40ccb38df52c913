//! A column of a time history.

use crate::units::Dimension;

/// A column: key, unit and meaning; the lists of columns are in the modules of the sampled quantities.
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
    /// Explanation of the column in one sentence.
    pub help: &'static str,
}
