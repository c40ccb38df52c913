//! One file for each page.

pub mod benchmark;
pub mod design;
pub mod library;
