//! (being written)

pub mod forebody;
pub mod outline;
pub mod profile;
pub mod segment;
pub mod impact;
pub mod input;
pub mod rules;
pub mod structure;
