//! Motion of a vehicle beyond its drag: none, lift at an angle of bank, or attitude.

use super::lift::Lift;
use super::six_dof::rigid::Rigid;

/// Freedom of motion of a vehicle.
#[derive(Clone, Debug, PartialEq)]
pub enum Freedom {
    /// A point mass with drag.
    Ballistic,
    /// A point mass with drag and lift, banked by a schedule.
    Lifting(Box<Lift>),
    /// A rigid body.
    Rigid(Box<Rigid>),
}
