//! One file for each page.

pub mod design;
