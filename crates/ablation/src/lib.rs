//! The one-dimensional response of a charring heat shield in depth.
//!
//! ```text
//! environment ─► wall: surface, blowing ─► cells: conduction, pyrolysis, gas ─► joints, layers ─► back
//! ```
//!
//! - [`stack`]: layers of [`solid`] materials, the first with [`reaction`]s, [`gas`] and [`surface`] chemistry; [`contact`],
//!   [`geometry`], back.
//! - [`environment`]: conditions at the wall in time; [`wall`]: its energy balance.
//! - [`grid`]: cells that shrink with the wall.
//! - [`march`]: steps by error, from [`settings`] to a [`history`] and an account of energy and mass.
//!
//! One temperature for solid and gas; gas in a quasi-steady state. A crate of its own, so that a program that solves no heat
//! shield in depth holds nothing of it.
//!
//! Deliberately absent: files, units, materials by name, sizing; swelling, radiation in depth, coking, mechanical erosion.
//!
//! # References
//! - \[amar-2006\], \[pato\].

pub mod contact;
pub mod environment;
pub mod fault;
pub mod gas;
pub mod geometry;
pub mod grid;
pub mod history;
pub mod march;
pub mod reaction;
pub mod settings;
pub mod solid;
pub mod stack;
mod stage;
mod state;
pub mod surface;
pub mod wall;
