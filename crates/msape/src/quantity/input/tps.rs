//! Inputs of the heat shield in depth: `[tps]`.

pub mod layer;

use super::{Alternatives, CONVENTION, Column, Group, Input, Kind, Preset, Range, column};
use crate::quantity::Task;
use crate::quantity::choice::{BackFace, Choice, NormalGeometry};
use crate::units::Dimension;

const PATO: &str = "PATO 3.1, boundary conditions of its tutorials";
const REPORT_TPS: &str = "NASA/TM-2014-218507, section 3.5 and Appendix B";
const TEMPERATURE_K: Range = Range::closed(1.0, 5_000.0);
/// Most depths.
const MOST_DEPTHS: usize = 40;
const DEPTHS: [Column; MOST_DEPTHS] = {
    let mut columns = [column::DEPTH_M.optional(); MOST_DEPTHS];
    columns[0] = column::DEPTH_M;
    columns
};

/// Ways to say what happens at the wall.
pub static WALL: Alternatives = Alternatives {
    asked_as: None,
    ways: &[
        &[&ENVIRONMENT_TABLE, &ENVIRONMENT],
        &[&SURFACE_TEMPERATURE_TABLE, &SURFACE_TEMPERATURE],
    ],
};

inputs! {
    &[Task::InDepth];
    INITIAL_TEMPERATURE_K: "tps.initial_temperature_k" = Input::number("Initial Temperature", Group::HeatShield, Dimension::Temperature, TEMPERATURE_K)
        .unit("K")
        .preset(Preset::Number(300.0))
        .help("Temperature of all layers at the start.", PATO);
    SINK_TEMPERATURE_K: "tps.sink_temperature_k" = Input::number("Sink Temperature", Group::HeatShield, Dimension::Temperature, Range::closed(0.0, 5_000.0))
        .unit("K")
        .preset(Preset::Number(300.0))
        .help("Temperature of the surroundings to which the wall radiates; 294.45 K is that of the report's relations.", PATO);
    BLOWING: "tps.blowing" = Input::number("Blowing Parameter", Group::HeatShield, Dimension::One, Range::closed(0.0, 2.0))
        .preset(Preset::Number(0.5))
        .help("Lambda of the reduction of the transfer coefficient by blowing, ln(1 + 2 lambda B')/(2 lambda B'): 0.5 laminar, 0.4 turbulent.", PATO);
    RECESSION: "tps.recession" = Input::new("Recession", Group::HeatShield, Kind::Flag)
        .preset(Preset::Flag(true))
        .help("Whether char is taken away; without it the balance of the wall holds none either.", PATO);
    ENVIRONMENT_TABLE: "tps.environment_table" = Input::new("Environment", Group::HeatShield, Kind::Rows(&[
        column::T_S,
        column::P_PA,
        column::CH_KG_M2S,
        column::H_R_J_KG,
        column::Q_RAD_W_M2.optional(),
        column::CHEMISTRY.optional(),
    ]))
        .one_way_of(&WALL)
        .help("Time, pressure, transfer coefficient without blowing, recovery enthalpy against the elements at 298 K, radiative heat flux, and whether the boundary layer reaches the wall (1) or it only radiates (0), which holds until the next row. After the last row the wall only radiates.", PATO);
    ENVIRONMENT: "tps.environment" = Input::new("Environment File", Group::HeatShield, Kind::Text)
        .file_of(&[&ENVIRONMENT_TABLE])
        .one_way_of(&WALL)
        .help("Name of a CSV file with the columns t_s, p_Pa, CH_kg_m2s, h_r_J_kg, and if wanted q_rad_W_m2 and chemistry.", CONVENTION);
    SURFACE_TEMPERATURE_TABLE: "tps.surface_temperature_table" = Input::new("Surface Temperature", Group::HeatShield, Kind::Rows(&[
        column::T_S,
        column::T_K,
        column::P_PA,
        column::RECESSION_M_S.optional(),
    ]))
        .one_way_of(&WALL)
        .help("Time, temperature of the wall, pressure, and if wanted the speed of recession, in the place of an environment.", CONVENTION);
    SURFACE_TEMPERATURE: "tps.surface_temperature" = Input::new("Surface Temperature File", Group::HeatShield, Kind::Text)
        .file_of(&[&SURFACE_TEMPERATURE_TABLE])
        .one_way_of(&WALL)
        .help("Name of a CSV file with the columns t_s, T_K, p_Pa, and if wanted recession_m_s.", CONVENTION);
    UNTIL_S: "tps.until_s" = Input::number("Until", Group::HeatShield, Dimension::Time, Range::closed(-1e7, 1e7))
        .unit("s")
        .help("Time at which the run ends; when absent, when the temperature behind the bond layer has passed its maximum.", CONVENTION);
    OUTPUT_STEP_S: "tps.output_step_s" = Input::number("Output Step", Group::HeatShield, Dimension::Time, Range::closed(0.001, 1e6))
        .unit("s")
        .preset(Preset::Number(1.0))
        .help("Interval of the rows of the history.", CONVENTION);
    DEPTHS_M: "tps.depths_m" = Input::new("Depths", Group::HeatShield, Kind::Rows(&DEPTHS))
        .one_row()
        .help("Depths from the initial wall at which temperatures are given, m; 0 K where the solid is gone.", PATO);
    GEOMETRY: "tps.geometry" = Input::new("Geometry", Group::HeatShield, Kind::Choice(NormalGeometry::CHOICES))
        .preset(Preset::Name(NormalGeometry::Planar.name()))
        .help("Shape of the surfaces of equal depth.", CONVENTION);
    RADIUS_M: "tps.radius_m" = Input::number("Radius of the Wall", Group::HeatShield, Dimension::Length, Range::above(0.0, 1e4))
        .unit("m")
        .help("Radius of the initial wall, of a cylinder or sphere.", CONVENTION);
    BACK: "tps.back" = Input::new("Back Face", Group::HeatShield, Kind::Choice(BackFace::CHOICES))
        .preset(Preset::Name(BackFace::Adiabatic.name()))
        .help("Condition behind the last layer.", REPORT_TPS);
    BACK_TEMPERATURE_K: "tps.back_temperature_k" = Input::number("Temperature Behind", Group::HeatShield, Dimension::Temperature, TEMPERATURE_K)
        .unit("K")
        .help("Temperature of the back, or of the surroundings behind it; the initial temperature when absent.", CONVENTION);
    BACK_EMISSIVITY: "tps.back_emissivity" = Input::number("Emissivity of the Back", Group::HeatShield, Dimension::One, Range::closed(0.0, 1.0))
        .preset(Preset::Number(0.9))
        .help("Emissivity of a back that radiates. Assumed where it is not given.", "assumed");
    BACK_FILM_W_M2K: "tps.back_film_w_m2k" = Input::number("Film Behind", Group::HeatShield, Dimension::HeatTransfer, Range::closed(0.0, 1e6))
        .unit("W/(m^2 K)")
        .preset(Preset::Number(0.0))
        .help("Heat transfer coefficient of a film behind, beside the radiation.", CONVENTION);
    BOND_LAYER: "tps.bond_layer" = Input::number("Bond Layer", Group::HeatShield, Dimension::One, Range::closed(1.0, 12.0))
        .whole()
        .preset(Preset::Number(1.0))
        .help("Layer, counted from 1 at the wall, behind which the temperature of the bond is judged.", REPORT_TPS);
    BOND_LIMIT_K: "tps.bond_limit_k" = Input::number("Bond Limit", Group::HeatShield, Dimension::Temperature, TEMPERATURE_K)
        .unit("K")
        .preset(Preset::Number(523.15))
        .help("Highest temperature allowed behind the bond layer; 250 C as of the design of Stardust.", "Covington 2008");
    TEMPERATURE_MARGIN_K: "tps.temperature_margin_k" = Input::number("Temperature Margin", Group::Margins, Dimension::Temperature, Range::closed(0.0, 500.0))
        .unit("K")
        .preset(Preset::Number(0.0))
        .help("Taken off the bond limit when a heat shield is sized.", CONVENTION);
    HEATING_MARGIN: "tps.heating_margin" = Input::number("Heating Margin", Group::Margins, Dimension::One, Range::closed(0.1, 10.0))
        .preset(Preset::Number(1.0))
        .help("Factor on transfer coefficient and radiative heat flux.", CONVENTION);
    RECESSION_MARGIN: "tps.recession_margin" = Input::number("Recession Margin", Group::Margins, Dimension::One, Range::closed(0.0, 5.0))
        .preset(Preset::Number(0.0))
        .help("Share of the recession that is added to the thickness when a heat shield is sized.", CONVENTION);
    CELLS: "tps.cells" = Input::number("Cells", Group::Solver, Dimension::One, Range::closed(8.0, 4_096.0))
        .whole()
        .preset(Preset::Number(64.0))
        .help("Cells of the first layer, finer towards the wall.", CONVENTION);
    TOLERANCE_K: "tps.tolerance_k" = Input::number("Error of a Step", Group::Solver, Dimension::Temperature, Range::closed(1e-6, 100.0))
        .unit("K")
        .preset(Preset::Number(0.1))
        .help("Error of temperature allowed in a step.", CONVENTION);
}
