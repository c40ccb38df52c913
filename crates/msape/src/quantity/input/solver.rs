//! Inputs of the integration.

use super::{CONVENTION, Group, Input, Kind, Preset, Range};
use crate::quantity::Task;
use crate::quantity::choice::{Choice, FlightModel, MethodName};
use crate::units::Dimension;

inputs! {
    Task::ALL;
    TOLERANCE: "solver.tolerance" = Input::number("Integration Tolerance", Group::Solver, Dimension::One, Range::closed(1e-13, 1e-2))
        .help("Relative error allowed in one step; when absent, chosen so that peak deceleration and heat load are good to 1e-5.", CONVENTION);
    METHOD: "solver.method" = Input::new("Integration Method", Group::Solver, Kind::Choice(MethodName::CHOICES))
        .preset(Preset::Name(MethodName::DormandPrince54.name()))
        .help("Method that integrates the equations of motion.", "Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I");
    FLIGHT_MODEL: "solver.flight_model" = Input::new("Flight Model", Group::Solver, Kind::Choice(FlightModel::OF_POINT_MASS))
        .preset(Preset::Name(FlightModel::ThreeDof.name()))
        .help("High- or low-fidelity model of the flight.", "NASA/TM-2014-218507, section 2.2");
    STEP_S: "solver.step_s" = Input::number("Integration Step", Group::Solver, Dimension::Time, Range::closed(1e-4, 10.0))
        .unit("s")
        .preset(Preset::Number(0.05))
        .help("Step of the classical Runge-Kutta method.", CONVENTION);
}
