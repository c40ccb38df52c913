//! Whole-system tests, and code shared by several of them.
//!
//! - [`shipped`]: the shipped cases and the command that solves each.
//! - [`snapshot`]: recorded answers, to the bit, and changes since.
//! - [`entry`]: invented entries for tests.
//! - [`text`]: cases written as text in tests.

pub mod entry;
pub mod shipped;
pub mod snapshot;
pub mod text;
