//! Pages, one file each.

pub mod benchmark;
pub mod design;
pub mod library;
