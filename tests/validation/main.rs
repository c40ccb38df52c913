//! Comparison with published and independent results, and with tighter tolerances.
//!
//! - [`published`]: every shipped comparison.
//! - [`aerodynamics`]: coefficients against exact, computed and published ones.
//! - [`accuracy`]: methods and tolerances of integration compared with one another.
//! - [`planets`]: atmospheres of the planets compared with measurements and their sources.
//! - [`shell`]: the shell model compared with closed forms, with the order of convergence.
//! - [`outcomes`]: start and end of flights.
//! - [`endings`]: end conditions that are met or not; [`tables`]: flights beyond tables; [`directions`]: singular
//!   directions.
//! - [`singular`]: straight down, over the pole, at rest, below sea level, compared with an independent integration.
//! - [`phases`]: parachutes, and other changes during a flight.

mod accuracy;
mod aerodynamics;
mod directions;
mod endings;
mod outcomes;
mod outlines;
mod phases;
mod planets;
mod published;
mod shell;
mod singular;
mod six_dof;
mod tables;
