//! (being written)

pub mod forebody;
pub mod outline;
pub mod profile;
pub mod segment;
