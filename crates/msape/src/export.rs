//! CAD and mesh files of a vehicle, as text and bytes: every writer is a pure function, so that the page and the command
//! line give the same file.
//!
//! - [`chain`]: a profile cleaned for export: joined, without its pieces on the axis, run so that its outside is known.
//! - [`mesh`]: triangles of a profile turned about the axis.

pub mod chain;
pub mod mesh;
