//! Tables from text files, whatever the dialect.

pub mod aerodynamics;
pub mod atmosphere;
