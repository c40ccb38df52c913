//! Whole-system tests, and what several of them share.
//!
//! - [`shipped`]: the cases that ship with the program, and how each is solved.
//! - [`snapshot`]: answers as recorded, to the bit, and what has changed since.
//! - [`entry`]: entries that tests make up.
//! - [`text`]: cases written out in tests.

pub mod entry;
pub mod shipped;
pub mod snapshot;
pub mod text;
