//! Systems analysis of planetary entry vehicles, after NASA/TM-2014-218507 ("the report").

pub mod aero;
pub mod case;
pub mod design;
pub mod finding;
pub mod flight;
pub mod heating;
pub mod library;
pub mod planet;
pub mod problem;
pub mod quantity;
pub mod soak;
pub mod tps;
pub mod units;
pub mod vehicle;

pub use case::Case;
