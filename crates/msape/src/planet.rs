//! x
pub mod atmosphere;
pub mod rows;
