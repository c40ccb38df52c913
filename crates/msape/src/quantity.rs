//! Every number of a case and every column of a time history, declared once: key, label, unit, help, source.
//!
//! Forms, tables, axes, `--help`, CSV headers and the JSON Schema are generated from these lists and from that of the
//! outputs, [`crate::answer::output`].
//!
//! - [`input`]: the numbers and choices of a case, with allowed range, usual range and default.
//! - [`choice`]: the choices whose names are fixed, as enums.
//! - [`trajectory`]: the columns of a time history.
//! - [`Module`], [`Job`], [`Task`]: by which they are grouped.

pub mod choice;
pub mod input;
mod module;
pub mod trajectory;

pub use input::{Input, inputs};
pub use module::{Job, Module, Task};
