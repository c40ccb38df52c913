//! Rows of tables and branches of relations that hold for a whole step.
//!
//! ```text
//! ρ, a, w of one piece of altitude,   C_D of one line of Mach number,   q̇ of one row of speed
//! ```
//!
//! A step that ends where a row ends meets no kink of these tables, stages and derivatives included. Other kinks, at which
//! no step ends, are listed in [`super::numbers`].
//!
//! # Valid
//! Within a step, and as far beyond the ends of its rows as a step reaches before it is cut.
//!
//! # References
//! - Own convention.

use super::mission::{Body, Mission};
use super::within::Within;
use crate::aero::Drag;
use crate::planet::atmosphere::Piece;
use numerics::scalar::Scalar;

/// Rows that hold, one set per lane.
#[derive(Clone, Copy, Debug)]
pub struct Held<V: Scalar> {
    /// Piece of the atmosphere.
    pub piece: Piece<V>,
    /// Row of the wind.
    pub wind: [V; 5],
    /// Line of the drag table; zeros where there is none.
    pub drag: [V; 3],
    /// Speed relative to the air by which rows and branches of heating are chosen, m/s.
    pub speed_m_s: V,
}

impl Held<f64> {
    /// The rows about a place.
    #[inline]
    pub fn of(mission: &Mission, body: &Body, within: &Within) -> Self {
        let atmosphere = &mission.atmosphere;
        Held {
            piece: atmosphere.piece(atmosphere.layer(within.altitude_m)),
            wind: mission.wind.row(within.altitude_m),
            drag: match &body.drag {
                Drag::Constant(_) => [0.0; 3],
                Drag::Table(table) => table.line(within.mach),
            },
            speed_m_s: within.speed_m_s,
        }
    }
}

impl<V: Scalar<Value = V, Lane = f64>> Held<V> {
    /// Equal rows in every lane.
    pub fn everywhere(held: &Held<f64>) -> Self {
        Held {
            piece: Piece::everywhere(&held.piece),
            wind: held.wind.map(V::constant),
            drag: held.drag.map(V::constant),
            speed_m_s: V::constant(held.speed_m_s),
        }
    }

    /// The rows of one lane.
    pub fn lane(&self, lane: usize) -> Held<f64> {
        Held {
            piece: self.piece.lane(lane),
            wind: self.wind.map(|row| row.lane(lane)),
            drag: self.drag.map(|row| row.lane(lane)),
            speed_m_s: self.speed_m_s.lane(lane),
        }
    }

    /// Replaces the rows of one lane.
    pub fn set_lane(&mut self, lane: usize, held: &Held<f64>) {
        self.piece.set_lane(lane, &held.piece);
        for (all, one) in self.wind.iter_mut().zip(held.wind) {
            all.set_lane(lane, one);
        }
        for (all, one) in self.drag.iter_mut().zip(held.drag) {
            all.set_lane(lane, one);
        }
        self.speed_m_s.set_lane(lane, held.speed_m_s);
    }
}
