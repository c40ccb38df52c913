//! CAD and mesh files of a vehicle, as text and bytes: every writer is a pure function, so that the page and the command
//! line give the same file.
//!
//! - [`model`]: what is exported: parts with name, material and colour.
//! - [`chain`]: a profile cleaned for export: joined, without its pieces on the axis, run so that its outside is known.
//! - [`mesh`]: triangles of a profile turned about the axis.
//! - [`step`](mod@step): solids; [`iges`](mod@iges): surfaces; [`stl`](mod@stl) and [`gltf`](mod@gltf): triangles.
//! - [`dxf`](mod@dxf) and [`table`]: the half-section; [`svg`](mod@svg): a drawing of it.
//! - [`format`](mod@format): the list of them.

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

/// What a file says about itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Info {
    /// When it was written, as `2000-01-01T12:00:00`.
    pub time_stamp: String,
    /// What wrote it.
    pub program: &'static str,
}

impl Default for Info {
    /// A moment that is always the same, so that the same design makes the same file.
    fn default() -> Self {
        Self {
            time_stamp: "2000-01-01T12:00:00".to_owned(),
            program: concat!("msape ", env!("CARGO_PKG_VERSION")),
        }
    }
}
