//! The heat shield in depth: materials from their cards, sizing, and remarks on where a card ends.
//!
//! - [`card`]: materials, one file each in `data/ablators` or of one's own, with tables beside it.
//! - [`sizing`]: the thickness at which the temperature behind a layer keeps its limit.
//! - [`coverage`]: findings, where a run leaves the tables of its materials.
//!
//! The response itself is that of the crate `ablation`, which knows no file.
//!
//! Deliberately absent: kinetics of materials for which none are public; they are those of TACOT, and their cards say so.

pub mod card;
pub mod coverage;
pub mod sizing;
mod table;

pub use card::Cards;
