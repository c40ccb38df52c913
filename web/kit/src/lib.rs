//! Parts of pages without state of their own: values come in as signals, actions leave as callbacks, so that any page,
//! also one of others, can hold them. Their style is in `web/page`.
//!
//! - [`chart`], [`chart_foot`], [`chart_table`]: a figure, its reading and exports, its numbers.
//! - [`number`], [`choice`]: controls for the inputs of a case. [`segments`], [`tabs`], [`file_input`]: other controls.
//! - [`display`]: numbers and units as text. [`files`]: files given to and by the user. [`observe`]: size and visibility.

pub mod chart;
pub mod chart_foot;
pub mod chart_table;
pub mod choice;
pub mod display;
pub mod file_input;
pub mod files;
pub mod number;
pub mod observe;
pub mod segments;
pub mod tabs;
