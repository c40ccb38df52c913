//! Inputs of the end of a flight.

use super::{CONVENTION, DEEPEST_M, Group, Input, Range};
use crate::quantity::Task;
use crate::units::Dimension;

inputs! {
    Task::ALL;
    ALTITUDE_M: "stop.altitude_m" = Input::number("Final Altitude", Group::Mission, Dimension::Length, Range::closed(DEEPEST_M, 1e7))
        .unit("m")
        .usual(-500.0, 5_000.0)
        .help("Geodetic altitude at which a falling vehicle ends its flight, not below the lowest of the planet; 0 m when nothing else ends it.", CONVENTION);
    TIME_S: "stop.time_s" = Input::number("Final Time", Group::Mission, Dimension::Time, Range::above(0.0, 1e7))
        .unit("s")
        .help("Time after the start at which the flight ends; a vehicle that leaves the atmosphere on a bound orbit flies on until then.", CONVENTION);
    PASSES: "stop.passes" = Input::number("Passes", Group::Mission, Dimension::One, Range::closed(1.0, 1000.0))
        .whole()
        .help("Number of passes through the atmosphere after which leaving it ends the flight; when absent the first, or with a final time none: a vehicle on a bound orbit flies on to its next entry.", CONVENTION);
}
