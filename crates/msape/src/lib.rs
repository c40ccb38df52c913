//! Systems analysis of planetary entry vehicles, after NASA/TM-2014-218507 ("the report").

pub mod aero;
pub mod answer;
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
pub mod table;
pub mod tps;
pub mod units;
pub mod validation;
pub mod vehicle;

pub use answer::{Answer, Outcome};
pub use case::{Case, InputError};
pub use flight::Request;
pub use library::Library;

/// Flies a vehicle as it is.
///
/// # Errors
/// Every fault of the case at once.
pub fn fly(case: &Case, library: &Library, request: Request) -> Result<Answer, Vec<InputError>> {
    problem::fly(case, library, request)
}

/// Designs a vehicle: geometry, mass, flight, heating, heat shield, soak, structure and impact, coupled.
///
/// # Errors
/// Every fault of the case at once.
pub fn design(case: &Case, library: &Library, request: Request) -> Result<Answer, Vec<InputError>> {
    problem::design(case, library, request)
}
