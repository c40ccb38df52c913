//! CAD and mesh files of a vehicle, as text and bytes: every writer is a pure function, so that the page and the command
//! line give the same file.
//!
//! - [`model`]: the exported model: parts with name, material and color.
//! - [`chain`]: a profile prepared for export: segments joined, those on the axis removed, orientation fixed.
//! - [`mesh`]: triangles of a profile revolved about the axis.
//! - [`step`](mod@step): solids; [`iges`](mod@iges): surfaces; [`stl`](mod@stl) and [`gltf`](mod@gltf): triangles.
//! - [`dxf`](mod@dxf) and [`table`]: the half-section; [`svg`](mod@svg): a drawing of it.
//! - [`format`](mod@format): the list of the formats.

pub mod chain;
pub mod dxf;
pub mod format;
pub mod gltf;
pub mod iges;
pub mod mesh;
pub mod model;
pub mod step;
pub mod stl;
pub mod svg;
pub mod table;

pub use format::Format;
pub use model::Model;

/// Metadata written into a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Info {
    /// Time of writing, as `2000-01-01T12:00:00`.
    pub time_stamp: String,
    /// Name of the writing program.
    pub program: &'static str,
}

impl Default for Info {
    /// A fixed time, so that the same design gives the same file.
    fn default() -> Self {
        Self {
            time_stamp: "2000-01-01T12:00:00".to_owned(),
            program: concat!("msape ", env!("CARGO_PKG_VERSION")),
        }
    }
}
