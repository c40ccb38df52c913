//! State of a flight between two steps.
//!
//! ```text
//! h,   ḣ = v·û,   M = |u|/a,   |u|
//! ```
//!
//! with h the geodetic altitude in m, v and u the velocity relative to the planet and the air in m/s, û the geodetic
//! vertical, a the speed of sound in m/s.
//!
//! # Valid
//! Any motion.
//!
//! # References
//! - Own convention.

use crate::flight::equations::Surroundings;
use crate::flight::motion::Motion;
use crate::flight::sample::Loads;
use numerics::scalar::Scalar;

/// Height, rate of climb, Mach number, speed and loads between two steps.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node<S: Scalar> {
    place: Place<S::Value>,
    loads: Loads<S>,
}

/// Height, rate of climb, Mach number and speed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place<V = f64> {
    /// Geodetic altitude, m.
    pub altitude_m: V,
    /// Rate of climb, m/s.
    pub climb_m_s: V,
    /// Mach number where drag depends on it, else 0.
    pub mach: V,
    /// Speed relative to the air, m/s.
    pub speed_m_s: V,
}

impl<S: Scalar> Node<S> {
    /// The node of one state.
    #[inline]
    pub fn of<'a, const N: usize>(motion: &impl Motion<'a, N, S>, t: S, y: &[S; N]) -> Self {
        Self::within(motion, t, y, &motion.around(y))
    }

    /// The node of one state in its known surroundings.
    #[inline]
    pub fn within<'a, const N: usize>(
        motion: &impl Motion<'a, N, S>,
        t: S,
        y: &[S; N],
        around: &Surroundings<S>,
    ) -> Self {
        let loads = motion.loads_in(t, y, around);
        let [u, v, w] = around.up;
        let mach = match motion.drag_table() {
            None => S::constant(0.0),
            Some(_) => around.air_speed_m_s / motion.point().sound_m_s(around.altitude_m),
        };
        Node {
            place: Place {
                altitude_m: around.altitude_m.value(),
                climb_m_s: (y[3] * u + y[4] * v + y[5] * w).value(),
                mach: mach.value(),
                speed_m_s: around.air_speed_m_s.value(),
            },
            loads,
        }
    }

    /// The node of one lane.
    #[inline]
    pub fn lane(&self, lane: usize) -> (Place, Loads<S::Lane>) {
        let place = Place {
            altitude_m: self.place.altitude_m.lane(lane),
            climb_m_s: self.place.climb_m_s.lane(lane),
            mach: self.place.mach.lane(lane),
            speed_m_s: self.place.speed_m_s.lane(lane),
        };
        (place, self.loads.lane(lane))
    }
}
