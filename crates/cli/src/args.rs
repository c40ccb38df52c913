//! Command-line arguments.

use crate::source::Source;
use cad::export::Format;
use clap::{Args, Parser, Subcommand, ValueEnum};
use msape::table::kml::Instant;
use msape::units::{Dimension, canonical, parse_number, told};
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  msape design cases/msr-eev-cp.toml                      a converged vehicle, as tables to read
  msape design cases/run-page.toml --set design.diameter_m=1.2 --set entry.speed_m_s=\"13 km/s\"
  msape design cases/galahad.toml --csv -o galahad.csv    the report's column names and units
  msape fly cases/stardust.toml --json --trajectory       results and time history as one JSON object
  msape fly cases/stardust.toml --trajectory-step 1 --csv-si -o history.csv
  msape fly cases/msr-eev-cp.toml --set vehicle.dof=6 --set attitude.alpha_deg=145    the vehicle of the design as a rigid body
  msape reorientation cases/msr-eev-cp.toml               does it turn nose first?
  msape fly - < my-case.toml                              the case from standard input
  msape fly my-case.toml --data my-data                   with planets, materials ... of the folder my-data
  msape export cases/galahad.toml -o galahad.step         solids for CAD; the ending names the format
  msape aero cases/msr-eev-cp.toml --regime blended --mach 20 --alpha 0:180:5
  msape tps cases/tps/ablation-2-2.toml --csv             a charring heat shield in an environment of its own
  msape tps my-flight.toml --size                         thickness for the bond limit, in the heating of the flight
  msape quantities inputs                                 every key of a case, with unit, range and default

Exit status: 0 when the case was answered, whatever the outcome; 2 for bad input, and nothing is written;
1 for a fault of the program, when standard output is closed, and for validate when a value is beyond its tolerance;
130 when it was stopped by Ctrl-C: design, reorientation and validate write the part that was done, the others nothing.";

/// Systems analysis of planetary entry vehicles, after NASA/TM-2014-218507.
#[derive(Parser)]
#[command(name = "msape", version, after_help = EXAMPLES, max_term_width = 120)]
pub struct Arguments {
    /// Subcommand.
    #[command(subcommand)]
    pub command: Command,
    /// Folder with data files of your own, laid out as crates/msape/data: planets/NAME.toml, atmospheres, materials, concepts,
    /// soak, grounds, outlines, aerodynamics/NAME.csv; a case may then name them
    #[arg(long, value_name = "DIR", global = true)]
    pub data: Option<PathBuf>,
}

/// Subcommand.
#[derive(Subcommand)]
pub enum Command {
    /// Fly a vehicle as it is; with vehicle.dof = 6 also the vehicle of a [design], with its outline, center of gravity and inertia
    #[command(after_help = EXAMPLES)]
    Fly(Run),
    /// Design a vehicle: geometry, mass, flight, heating, heat shield, soak, structure and impact, coupled
    #[command(after_help = EXAMPLES)]
    Design(Design),
    /// Whether a design, or a vehicle with vehicle.dof = 6, turns nose first: nine entries from 175, 145 and 120 deg with -2, 0 and
    /// 2 deg/s of pitch
    #[command(after_help = EXAMPLES)]
    Reorientation(Reorientation),
    /// Write the vehicle of a design, or an [outline] without [design] as it is, as a CAD, mesh or drawing file
    #[command(after_help = export_help())]
    Export(Export),
    /// Coefficients of an [outline], or of the vehicle of a design, over the angle of attack
    #[command(after_help = EXAMPLES)]
    Aero(crate::aero::Aero),
    /// The heat shield in depth: [tps] in an environment of its own, or in that of the case's flight or design
    #[command(after_help = EXAMPLES)]
    Tps(Tps),
    /// Solve every documented case that ships with the program and compare it with its reference
    Validate(Validate),
    /// Facts of the [outline] of a case: tangent points, areas, volume, centroid
    Outline(Outline),
    /// Print the JSON Schema of case files, for editors
    Schema(Plain),
    /// List the quantities: keys of a case, results, columns of a trajectory
    Quantities(Quantities),
}

/// Arguments of a run.
#[derive(Args)]
pub struct Run {
    /// The case.
    #[command(flatten)]
    pub source: Source,
    /// Form of the output.
    #[command(flatten)]
    pub form: Form,
    /// Add the time history, at the steps of the integrator; with --csv and --csv-si it is written in place of the
    /// results
    #[arg(long)]
    pub trajectory: bool,
    /// Add the time history at a uniform step in seconds, both ends included
    #[arg(long, value_name = "S", value_parser = step)]
    pub trajectory_step: Option<f64>,
    /// Moment of the start, for --kml
    #[arg(long, value_name = "UTC", value_parser = epoch, default_value = "2000-01-01T12:00:00Z")]
    pub epoch: Instant,
    /// Write to a file, which is replaced only when all went well
    #[arg(short, long, value_name = "PATH")]
    pub output: Option<PathBuf>,
}

/// Arguments of `design`.
#[derive(Args)]
pub struct Design {
    /// Arguments of a run.
    #[command(flatten)]
    pub run: Run,
    /// Add entries of the designed vehicle from 175, 145 and 120 deg with -2, 0 and 2 deg/s of pitch, and the share that is
    /// nose first at the largest heat rate
    #[arg(long)]
    pub reorientation: bool,
}

/// Arguments of `reorientation`.
#[derive(Args)]
pub struct Reorientation {
    /// The case.
    #[command(flatten)]
    pub source: Source,
    /// One JSON object: name, outcome, reason, stopped, reorientation
    #[arg(long, conflicts_with = "csv")]
    pub json: bool,
    /// One row an entry as CSV, in SI units and degrees
    #[arg(long)]
    pub csv: bool,
    /// Write to a file, which is replaced only when all went well
    #[arg(short, long, value_name = "PATH")]
    pub output: Option<PathBuf>,
}

/// Form of the output; without any of them, tables to read.
#[derive(Args, Clone, Copy)]
#[group(multiple = false)]
pub struct Form {
    /// One JSON object: name, outcome, reason, results, findings, adjustments, passes, of a design mass_tree, structure,
    /// stability, reorientation; trajectory, landing
    #[arg(long)]
    pub json: bool,
    /// CSV with the report's column names and units
    #[arg(long)]
    pub csv: bool,
    /// CSV with the keys as column names, in SI units and degrees
    #[arg(long)]
    pub csv_si: bool,
    /// The time history as KML, for viewers of the globe
    #[arg(long)]
    pub kml: bool,
    /// The mass tree of a design as CSV: components with material, density, volume, areas, mass, center of gravity, inertias
    #[arg(long)]
    pub mass_tree: bool,
}

/// Arguments of `tps`.
#[derive(Args)]
pub struct Tps {
    /// The case.
    #[command(flatten)]
    pub source: Source,
    /// Size the first layer, so that the temperature behind the bond layer keeps tps.bond_limit_k
    #[arg(long)]
    pub size: bool,
    /// One JSON object: outcome, layers, peaks, energy, mass, work, history, findings
    #[arg(long, conflicts_with = "csv")]
    pub json: bool,
    /// The history as CSV: t_s, Tw_K, T_1mm_K ..., mdot_g_kg_m2s, mdot_c_kg_m2s, recession_m, T_bond_K, T_back_K
    #[arg(long)]
    pub csv: bool,
    /// Write to a file, which is replaced only when all went well
    #[arg(short, long, value_name = "PATH")]
    pub output: Option<PathBuf>,
}

/// Arguments of `export`.
#[derive(Args)]
pub struct Export {
    /// The case.
    #[command(flatten)]
    pub source: Source,
    /// Format of the file; without it the ending of its name says it
    #[arg(long, value_name = "FORMAT", value_parser = format)]
    pub format: Option<Format>,
    /// Write to a file, which is replaced only when all went well; `-` is standard output, for formats that are text
    #[arg(short, long, value_name = "PATH")]
    pub output: Option<PathBuf>,
}

/// Arguments of `validate`.
#[derive(Args)]
pub struct Validate {
    /// Names of the comparisons to make; all when none is given
    #[arg(value_name = "NAME")]
    pub names: Vec<String>,
    /// One JSON object instead of tables
    #[arg(long)]
    pub json: bool,
    /// Write to a file, which is replaced only when all went well
    #[arg(short, long, value_name = "PATH")]
    pub output: Option<PathBuf>,
}

/// Arguments of `outline`.
#[derive(Args)]
pub struct Outline {
    /// The case.
    #[command(flatten)]
    pub source: Source,
    /// One JSON object instead of a table
    #[arg(long)]
    pub json: bool,
    /// Write to a file, which is replaced only when all went well
    #[arg(short, long, value_name = "PATH")]
    pub output: Option<PathBuf>,
}

/// Arguments of a command that only prints.
#[derive(Args)]
pub struct Plain {
    /// Write to a file, which is replaced only when all went well
    #[arg(short, long, value_name = "PATH")]
    pub output: Option<PathBuf>,
}

/// Arguments of `quantities`.
#[derive(Args)]
pub struct Quantities {
    /// Which list
    #[arg(value_enum)]
    pub list: List,
    /// Write to a file, which is replaced only when all went well
    #[arg(short, long, value_name = "PATH")]
    pub output: Option<PathBuf>,
}

/// A list of quantities.
#[derive(Clone, Copy, ValueEnum)]
pub enum List {
    /// Keys of a case
    Inputs,
    /// Results
    Outputs,
    /// Columns of a trajectory
    Trajectory,
}

/// Range of output steps, s: shorter ones only fill memory, longer ones resolve nothing.
const STEP_S: std::ops::RangeInclusive<f64> = 0.001..=100_000.0;

/// Names of the formats.
pub fn formats() -> String {
    Format::ALL.map(Format::name).join(", ")
}

fn format(text: &str) -> Result<Format, String> {
    Format::named(text).ok_or_else(|| format!("must be one of {}", formats()))
}

fn export_help() -> String {
    let lines = Format::ALL.map(|f| format!("  {:<6}{}\n", f.name(), f.help()));
    format!("Formats:\n{}\n{EXAMPLES}", lines.concat())
}

fn step(text: &str) -> Result<f64, String> {
    let value = parse_number(text, Dimension::Time, canonical(Dimension::Time))
        .map_err(|error| error.to_string())?;
    if STEP_S.contains(&value) {
        Ok(value)
    } else {
        Err(format!(
            "got {} s, must be {} to {} s",
            told(value),
            STEP_S.start(),
            STEP_S.end()
        ))
    }
}

fn epoch(text: &str) -> Result<Instant, String> {
    Instant::parse(text).ok_or_else(|| "must be a moment such as 2006-01-15T09:57:00Z".to_string())
}
