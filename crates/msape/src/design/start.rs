//! Start for the passes of a design: the end of those of a neighbor.

use numerics::fixed_point::Anderson;

/// Entry load in Earth g, stagnation pressure in Pa, speed at impact in m/s, heat-shield thicknesses of forebody and aftbody in m.
pub(super) type Numbers = [f64; 5];

/// Remembered steps of vehicles of the requested diameter, and of those that had to grow.
pub(super) type Memories = [Anderson<5>; 2];

/// Converged coupling numbers of a design, and the memory of its last passes.
#[derive(Clone, Debug)]
pub struct Start {
    pub(super) numbers: Numbers,
    pub(super) memories: Memories,
}
