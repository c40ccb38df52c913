//! Against published and independent figures, and against itself at greater effort.
//!
//! - [`published`]: every documented case that ships with the program.
//! - [`aerodynamics`]: coefficients against exact, computed and published ones.
//! - [`accuracy`]: methods and tolerances of integration against one another.
//! - [`planets`]: atmospheres of the planets against measured ones and their sources.
//! - [`shell`]: the shell model against closed forms, with the order of convergence.
//! - [`outcomes`]: how flights begin and end.
//! - [`endings`]: ends that are met or not; [`tables`]: tables that are left; [`directions`]: singular directions.
//! - [`singular`]: straight down, over the pole, at rest, below sea level, beside an independent integration.
//! - [`phases`]: parachutes, and what else changes on the way.

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
