//! Every number of a case or of an answer, declared once: key, label, unit, help, source.
//!
//! Forms, tables, axes, `--help`, CSV headers and the JSON Schema are generated from these lists.
//!
//! - [`input`]: what a person may ask for, with allowed range, usual range and default.
//! - [`output`]: what an answer holds, with the report's own column name where it has one.
//! - [`landing`]: the columns of a landing's history.
//! - [`trajectory`]: the columns of a time history.

pub mod input;
pub mod landing;
pub mod output;
pub mod schema;
pub mod trajectory;

pub use input::{Input, inputs};
pub use output::{Job, Output, outputs};
