//! Inputs of the heating: relations, margins, wall.

pub(super) mod table;

use super::{CONVENTION, Group, Input, Kind, Preset, RUN_PAGE, Range};
use crate::quantity::Task;
use crate::quantity::choice::{
    Choice, ConvectiveModel, JudgedAt, PressureModel, RadiativeModel, WallModel,
};
use crate::units::Dimension;

pub use table::*;

inputs! {
    Task::ALL;
    CONVECTIVE: "heating.convective" = Input::new("Convective Heat Rate Model", Group::Models, Kind::Choice(ConvectiveModel::CHOICES))
        .preset(Preset::Name(ConvectiveModel::SuttonGraves.name()))
        .basic()
        .help("Relation for convective heating at the stagnation point.", RUN_PAGE);
    RADIATIVE: "heating.radiative" = Input::new("Radiative Heat Rate Model", Group::Models, Kind::Choice(RadiativeModel::CHOICES))
        .preset(Preset::Name(RadiativeModel::TauberSutton.name()))
        .basic()
        .help("Relation for radiative heating at the stagnation point.", RUN_PAGE);
    CONVECTIVE_MARGIN: "heating.convective_margin" = Input::number("Convective Heat Rate Margin", Group::Margins, Dimension::One, Range::closed(0.0, 10.0))
        .usual(0.0, 10.0)
        .preset(Preset::Number(1.3))
        .basic()
        .help("Factor on convective heating chosen by the designer; results say whether they carry it.", RUN_PAGE);
    RADIATIVE_MARGIN: "heating.radiative_margin" = Input::number("Radiative Heat Rate Margin", Group::Margins, Dimension::One, Range::closed(0.0, 10.0))
        .usual(0.0, 2.0)
        .preset(Preset::Number(1.0))
        .basic()
        .help("Factor on radiative heating chosen by the designer; results say whether they carry it.", RUN_PAGE);
    CONVECTIVE_MODEL_FACTOR: "heating.convective_model_factor" = Input::number("Convective Model Factor", Group::Models, Dimension::One, Range::above(0.0, 10.0))
        .usual(1.0, 1.5)
        .preset(Preset::Number(1.0))
        .help("Correction of the convective relation itself, apart from the margin and not of heat fluxes that the case gives; the report's comparison with DPLR gives 1.33.", "NASA/TM-2014-218507, section 3.4.3");
    WALL: "heating.wall" = Input::new("Wall for Convective Heating", Group::Models, Kind::Choice(WallModel::CHOICES))
        .preset(Preset::Name(WallModel::Cold.name()))
        .help("Whether convective heating is that of a cold wall, or is lowered by the enthalpy of a wall in radiative equilibrium.", CONVENTION);
    WALL_EMISSIVITY: "heating.wall_emissivity" = Input::number("Wall Emissivity", Group::Models, Dimension::One, Range::above(0.0, 1.0))
        .usual(0.5, 1.0)
        .preset(Preset::Number(0.85))
        .help("Emissivity of the wall for its radiative-equilibrium temperature.", "NASA/TM-2014-218507, section 3.4.2");
    STAGNATION_PRESSURE: "heating.stagnation_pressure" = Input::new("Stagnation Pressure", Group::Models, Kind::Choice(PressureModel::CHOICES))
        .preset(Preset::Name(PressureModel::NewtonianLimit.name()))
        .help("How the pressure at the stagnation point is found, which loads the walls and is held against the limits of the heat shield; the Newtonian limit bounds the others.", "NASA/TM-2014-218507, equations 9 to 12");
    JUDGED_AT: "heating.judged_at" = Input::new("Heat Shield Judged at", Group::Models, Kind::Choice(JudgedAt::CHOICES))
        .preset(Preset::Name(JudgedAt::HottestPoint.name()))
        .tasks(&[Task::Design, Task::DesignedBody])
        .help("Where heat flux and heat load are taken for the thickness of the forebody's heat shield and for its limits; the report's relations took those of the stagnation point.", "NASA/TM-2014-218507, sections 3.4.3 and 3.5");
}
