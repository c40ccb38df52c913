//! The one-dimensional response of a charring heat shield in depth.

pub mod contact;
pub mod environment;
pub mod fault;
pub mod gas;
pub mod geometry;
pub mod grid;
pub mod history;
pub mod march;
pub mod reaction;
pub mod solid;
pub mod stack;
mod stage;
mod state;
pub mod surface;
pub mod wall;
