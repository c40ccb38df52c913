//! Vehicle in three dimensions with WebGL2: profiles revolved by the graphics processor.
//!
//! - [`attitude`]: attitude of a vehicle in flight.
//! - [`lathe`]: profiles as edges with normals. [`scene`]: the parts of a vehicle. [`camera`]: viewpoint.
//! - [`pick`]: part under the pointer. [`paint`]: colors. [`renderer`]: the only file that uses WebGL.
//!
//! Only half-sections are uploaded, a few thousand vertices: the vertex shader revolves and cuts them, so that a moved
//! slider costs no more than sampling the profiles. The cut faces are filled through the stencil buffer.

pub mod attitude;
pub mod camera;
pub mod lathe;
pub mod paint;
pub mod pick;
pub mod renderer;
pub mod scene;
pub mod shader;
