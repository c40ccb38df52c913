//! Every number of a case, declared once: key, label, unit, help, source.
//!
//! Forms, tables, axes, `--help`, CSV headers and the JSON Schema are generated from these lists and from that of the
//! outputs, [`crate::answer::output`], and of time histories, [`crate::flight::columns`] and [`crate::answer::landing`].
//!
//! - [`input`]: the numbers and choices of a case, with allowed range, usual range and default.
//! - [`choice`]: the choices whose names are fixed, as enums.
//! - [`Column`]: a column of a time history.
//! - [`Module`], [`Job`], [`Task`]: by which they are grouped.

pub mod choice;
mod column;
pub mod input;
mod module;

pub use column::Column;
pub use input::{Input, inputs};
pub use module::{Job, Module, Task};
