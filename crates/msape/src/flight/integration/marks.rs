//! Events that flights through the same air may meet, collected once for all of them.
//!
//! ```text
//! h, M and V of the ends of rows,   h of the ground,   t of the end
//! ```
//!
//! with V in m/s, M without unit, h in m, t in s.
//!
//! # Valid
//! Flights of one mission with one kind of drag.
//!
//! # References
//! - Own convention.

use super::Keep;
use super::ladder::{Ladder, Ladders};
use crate::aero::DragTable;
use crate::flight::motion::Motion;
use crate::flight::reach::{Axis, axes, may_push};
use numerics::ode::Method;
use numerics::scalar::Single;

/// Longest flight, s: 30 days.
const LONGEST_FLIGHT_S: f64 = 30.0 * 86_400.0;
/// Below this Mach number the rows of a drag table that is looked up at each stage no longer matter to peaks and heat loads.
const KINKS_FROM_MACH: f64 = 3.0;

/// Events that flights through the same air may meet.
#[derive(Clone, Debug)]
pub(super) struct Marks {
    /// Ends of rows of atmosphere, wind, drag and heating.
    pub ladders: Ladders,
    /// Whether drag is taken by the line that holds.
    pub holds_drag: bool,
    /// Altitude that ends a fall, m.
    pub ground_m: f64,
    /// Time that ends a flight, s.
    pub end_s: f64,
    /// Axes of the tables of the case that are looked up.
    pub axes: Vec<Axis>,
    /// Whether the case refuses to continue beyond one of them.
    pub refuses: bool,
    /// Whether the drag coefficient may fall below zero.
    pub may_push: bool,
    /// Energy that the wind may give, J/kg, where the step is fixed and the energy is watched.
    pub wind_energy_j_kg: Option<f64>,
    /// Number of times the vehicle may leave the atmosphere before that ends its flight.
    pub exits: u32,
    /// Choice of the steps to keep.
    pub keep: Keep,
}

impl Marks {
    /// Whether each step is checked for the range of table look-ups, or for the drag.
    #[inline]
    pub fn looks_along(&self) -> bool {
        self.may_push || !self.axes.is_empty()
    }

    /// The marks of a motion.
    pub fn of<'a, M: Motion<'a, N, S>, const N: usize, S: Single>(motion: &M, keep: Keep) -> Self {
        let (mission, body) = (motion.point().mission, motion.point().body);
        let axes = axes(mission, body);
        let heating = &mission.heating;
        let heated = [
            heating.radiative.kinks_m_s(),
            heating.convective.kinks_m_s(),
        ];
        let air = mission.atmosphere.boundaries_m().iter();
        let machs = motion.drag_table().into_iter().flat_map(DragTable::machs);
        let holds_drag = motion.holds_drag();
        let matters = |mach: &f64| holds_drag || *mach >= KINKS_FROM_MACH;
        Self {
            ladders: Ladders {
                altitude_m: Ladder::new(air.chain(mission.wind.boundaries_m()).copied()),
                mach: Ladder::new(machs.copied().filter(matters)),
                speed_m_s: Ladder::new(heated.into_iter().flatten()),
            },
            holds_drag,
            ground_m: mission
                .stop
                .altitude_m
                .unwrap_or(mission.planet.lowest_altitude_m),
            end_s: mission.stop.time_s.unwrap_or(LONGEST_FLIGHT_S),
            refuses: axes.iter().any(Axis::refuses),
            axes,
            may_push: may_push(body),
            wind_energy_j_kg: matches!(mission.solver.method, Method::Rk4 { .. })
                .then(|| 4.0 * mission.wind.fastest_m_s() * mission.wind.fastest_m_s()),
            exits: mission.stop.exits(),
            keep,
        }
    }
}
