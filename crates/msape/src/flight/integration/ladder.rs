//! Ends of the rows of tables, and the interval between them in which a flight is.
//!
//! ```text
//! xᵢ₋₁ ≤ x < xᵢ on rung i,   x₋₁ = −∞,   xₙ = ∞
//! ```
//!
//! with x an altitude in m, a Mach number or a speed in m/s.
//!
//! # Valid
//! Ends in ascending order.
//!
//! # References
//! - Own convention.

use super::node::Place;
use crate::flight::within::Within;

/// Argument of the tables whose rows end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Of {
    /// Geodetic altitude, m: atmosphere and wind.
    Altitude,
    /// Mach number: drag.
    Mach,
    /// Speed relative to the air, m/s: heating.
    Speed,
}

/// The ends of the rows, in ascending order.
#[derive(Clone, Debug)]
pub(super) struct Ladder(Vec<f64>);

impl Ladder {
    /// A ladder of ends in any order.
    pub fn new(ends: impl IntoIterator<Item = f64>) -> Self {
        let mut ends: Vec<f64> = ends.into_iter().collect();
        ends.sort_unstable_by(f64::total_cmp);
        ends.dedup();
        Self(ends)
    }

    /// The rung of a number; an end belongs to the rung above.
    fn rung(&self, x: f64) -> usize {
        self.0.partition_point(|end| *end <= x)
    }

    /// Both ends of a rung.
    fn ends(&self, rung: usize) -> [f64; 2] {
        let low = rung.checked_sub(1).and_then(|below| self.0.get(below));
        let high = self.0.get(rung);
        [
            low.copied().unwrap_or(f64::NEG_INFINITY),
            high.copied().unwrap_or(f64::INFINITY),
        ]
    }
}

/// Ladders of altitude, Mach number and speed.
#[derive(Clone, Debug)]
pub(super) struct Ladders {
    /// Altitudes, m.
    pub altitude_m: Ladder,
    /// Mach numbers.
    pub mach: Ladder,
    /// Speeds, m/s.
    pub speed_m_s: Ladder,
}

impl Ladders {
    fn of(&self, of: Of) -> &Ladder {
        match of {
            Of::Altitude => &self.altitude_m,
            Of::Mach => &self.mach,
            Of::Speed => &self.speed_m_s,
        }
    }
}

/// Rungs of a flight on the ladders.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rungs {
    rungs: [usize; 3],
    ends: [[f64; 2]; 3],
}

/// Direction in which a rung is left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Way {
    /// To the rung below.
    Down,
    /// To the rung above.
    Up,
}

impl Rungs {
    /// The rungs of a place.
    pub fn at(ladders: &Ladders, place: &Within) -> Self {
        let places = [place.altitude_m, place.mach, place.speed_m_s];
        let mut rungs = Rungs {
            rungs: [0; 3],
            ends: [[0.0; 2]; 3],
        };
        for (of, x) in [Of::Altitude, Of::Mach, Of::Speed].into_iter().zip(places) {
            rungs.put(ladders, of, ladders.of(of).rung(x));
        }
        rungs
    }

    /// Both ends of a rung.
    #[inline]
    pub fn ends(&self, of: Of) -> [f64; 2] {
        self.ends[of as usize]
    }

    fn put(&mut self, ladders: &Ladders, of: Of, rung: usize) {
        self.rungs[of as usize] = rung;
        self.ends[of as usize] = ladders.of(of).ends(rung);
    }

    /// Moves to the next rung of one ladder.
    pub fn leave(&mut self, ladders: &Ladders, of: Of, way: Way) {
        let rung = self.rungs[of as usize];
        let next = match way {
            Way::Down => rung.saturating_sub(1),
            Way::Up => rung + 1,
        };
        self.put(ladders, of, next);
    }

    /// Whether a place is within the rungs, ends included.
    #[inline]
    pub fn hold(&self, place: &Place) -> bool {
        let [altitude, mach, speed] = self.ends;
        let within = |[low, high]: [f64; 2], x: f64| low <= x && x <= high;
        within(altitude, place.altitude_m)
            && within(mach, place.mach)
            && within(speed, place.speed_m_s)
    }

    /// A place amid the rungs.
    pub fn amid(&self) -> Within {
        let amid = |of: Of| match self.ends(of) {
            [low, high] if low.is_finite() && high.is_finite() => 0.5 * (low + high),
            [low, _] if low.is_finite() => low + 1.0,
            [_, high] if high.is_finite() => high - 1.0,
            _ => 0.0,
        };
        Within {
            altitude_m: amid(Of::Altitude),
            mach: amid(Of::Mach),
            speed_m_s: amid(Of::Speed),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rungs_are_left_up_and_down() {
        let ladders = Ladders {
            altitude_m: Ladder::new([2e4, 1e4, 1e4]),
            mach: Ladder::new([]),
            speed_m_s: Ladder::new([9e3]),
        };
        let place = Within {
            altitude_m: 1e4,
            mach: 3.0,
            speed_m_s: 8e3,
        };
        let mut rungs = Rungs::at(&ladders, &place);
        assert_eq!(rungs.ends(Of::Altitude), [1e4, 2e4]);
        assert_eq!(rungs.ends(Of::Mach), [f64::NEG_INFINITY, f64::INFINITY]);
        assert_eq!(rungs.amid().altitude_m, 15e3);
        rungs.leave(&ladders, Of::Speed, Way::Up);
        rungs.leave(&ladders, Of::Altitude, Way::Down);
        assert_eq!(rungs.ends(Of::Speed), [9e3, f64::INFINITY]);
        let amid = rungs.amid();
        assert_eq!((amid.altitude_m, amid.speed_m_s), (9999.0, 9001.0));
    }
}
