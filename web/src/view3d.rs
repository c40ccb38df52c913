//! A vehicle in three dimensions, by WebGL2: profiles that the graphics processor turns about the axis.
//!
//! - [`attitude`]: how a vehicle is turned in flight.
//! - [`lathe`]: profiles as edges with normals. [`scene`]: the parts of a vehicle. [`camera`]: from where it is looked at.
//! - [`pick`]: what is under the pointer. [`paint`]: colours. [`renderer`]: the only file that speaks to the graphics processor.
//!
//! Only half-sections are uploaded, some thousand vertices: turning and cutting are done by the vertex shader, so that a moved
//! slider costs no more than sampling the profiles. The cut faces are filled through the stencil buffer.

pub mod attitude;
pub mod camera;
pub mod lathe;
pub mod paint;
pub mod pick;
pub mod renderer;
pub mod scene;
pub mod shader;
