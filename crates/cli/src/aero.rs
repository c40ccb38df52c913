//! `aero`: coefficients over the angle of attack.

use crate::failure::{Failure, cut, printable};
use crate::read::Data;
use crate::show::columns::{Align, Columns};
use crate::source::Source;
use crate::{Done, output, read};
use clap::{Args, ValueEnum};
use msape::Case;
use msape::aero::database::{Database, GAMMA};
use msape::aero::free_molecular::Gas;
use msape::aero::polar::write::COLUMNS;
use msape::aero::polar::{self, Polar, Theory, remarks};
use msape::aero::standard::AeroBody;
use msape::aero::table::Extrapolation;
use msape::finding::Finding;
use msape::problem::AeroProblem;
use msape::quantity::input::{self, Input};
use msape::units::told;
use std::path::PathBuf;
use std::process::ExitCode;

/// Speed ratio of free-molecular flow when neither it nor a Mach number is given.
const SPEED_RATIO: f64 = 25.0;
const WALL: &Input = &input::vehicle::AERODYNAMICS_WALL_TEMPERATURE_RATIO;
const ACCOMMODATION: &Input = &input::vehicle::AERODYNAMICS_ACCOMMODATION;
/// Decimals in tables; files have full precision.
const DECIMALS: usize = 5;
/// Largest number of angles accepted.
const ANGLES_MAX: usize = 100_000;

/// Arguments of `aero`.
#[derive(Args)]
pub struct Aero {
    /// The case.
    #[command(flatten)]
    pub source: Source,
    /// Which theory answers
    #[arg(long, value_enum, default_value_t = Regime::Blended)]
    pub regime: Regime,
    /// Angles of attack in deg: 0,5,10 or 0:180:5 (from, to, step)
    #[arg(
        long,
        value_name = "DEG",
        default_value = "0:180:5",
        allow_hyphen_values = true
    )]
    pub alpha: String,
    /// Mach number
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    pub mach: Option<f64>,
    /// Mean free path over diameter; 0, a continuum, when absent
    #[arg(long, value_name = "K", allow_hyphen_values = true)]
    pub knudsen: Option<f64>,
    /// Speed over the most probable speed of the molecules; from the Mach number, or 25, when absent
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    pub speed_ratio: Option<f64>,
    /// Newtonian pressure coefficient of the stagnation point; from the Mach number, or 2, when absent
    #[arg(long, value_name = "CP", allow_hyphen_values = true)]
    pub pressure_coefficient_max: Option<f64>,
    /// Temperature of the wall over that of the air in free-molecular flow; 1, or that of the case, when absent
    #[arg(long, value_name = "RATIO", allow_hyphen_values = true)]
    pub wall_temperature_ratio: Option<f64>,
    /// Accommodation of momentum in free-molecular flow; 1, or that of the case, when absent
    #[arg(long, value_name = "SIGMA", allow_hyphen_values = true)]
    pub accommodation: Option<f64>,
    /// One JSON object: name, results, trim, findings
    #[arg(long, conflicts_with = "csv")]
    pub json: bool,
    /// CSV, a line an angle
    #[arg(long)]
    pub csv: bool,
    /// The database at the Mach and Knudsen numbers of the report's figures, 0 to 180 deg, as CSV
    #[arg(long, conflicts_with_all = ["json", "csv"])]
    pub database: bool,
    /// Write to a file, which is replaced only when all went well
    #[arg(short, long, value_name = "PATH")]
    pub output: Option<PathBuf>,
}

/// Which theory answers.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Regime {
    /// Newton's impact theory, without correction and base pressure
    Newtonian,
    /// Molecules without collisions
    FreeMolecular,
    /// The database: both limits bridged, tables against Mach number, damping
    Blended,
}

/// Computes the coefficients and writes them.
pub fn run(arguments: &Aero, data: &Data) -> Done {
    let mut loaded = read::asked(&arguments.source, arguments.output.as_deref(), data)?;
    let (case, faults) = (&mut loaded.case, &mut loaded.faults);
    let angles = angles(&arguments.alpha, faults);
    for (input, value) in [
        (WALL, arguments.wall_temperature_ratio),
        (ACCOMMODATION, arguments.accommodation),
    ] {
        if let Some(value) = value {
            case.set(input.key, &value.to_string());
        }
    }
    let problem = AeroProblem::check(case, &data.library);
    let of_air = problem.as_ref().map(AeroProblem::heat_capacity_ratio);
    let theory = theory(arguments, case, of_air.unwrap_or(GAMMA), faults);
    let problem = loaded.unless_at_fault(problem)?;
    let (body, database) = loaded.unless_at_fault(problem.solve())?;
    if arguments.database {
        output::write(
            msape::aero::stored::csv(&database),
            arguments.output.as_deref(),
        )?;
        return Ok(ExitCode::SUCCESS);
    }
    refuse(&database, &theory, &angles)?;
    let polar = polar::polar(&polar::Aero::new(&body, theory, Some(&database)), &angles);
    let mut findings = remarks(&polar, &theory, &database);
    findings.extend(problem.findings);
    findings.extend(loaded.findings());
    let case = &loaded.case;
    let text = if arguments.json {
        format!("{:#}\n", polar.json(&case.name, &findings))
    } else if arguments.csv {
        polar.csv()
    } else {
        table(&case.name, &body, &polar, &findings)
    };
    output::write(&text, arguments.output.as_deref())?;
    Ok(ExitCode::SUCCESS)
}

fn theory(
    arguments: &Aero,
    case: &Case,
    heat_capacity_ratio: f64,
    faults: &mut Vec<String>,
) -> Theory {
    let mut within = |name: &str, value: Option<f64>, low: f64, high: f64| {
        if let Some(value) = value
            && !(low..=high).contains(&value)
        {
            let got = told(value);
            faults.push(format!("--{name}: got {got}, must be {low} to {high}"));
        }
    };
    within("mach", arguments.mach, 0.0, 1000.0);
    within("knudsen", arguments.knudsen, 0.0, 1e12);
    within("speed-ratio", arguments.speed_ratio, 0.01, 1e6);
    within(
        "pressure-coefficient-max",
        arguments.pressure_coefficient_max,
        0.0,
        10.0,
    );
    within(
        "wall-temperature-ratio",
        arguments.wall_temperature_ratio,
        0.0,
        1000.0,
    );
    within("accommodation", arguments.accommodation, 0.0, 1.0);
    match arguments.regime {
        Regime::Newtonian => arguments.pressure_coefficient_max.map_or(
            Theory::newtonian(arguments.mach, heat_capacity_ratio),
            |most| Theory::Newtonian {
                pressure_coefficient_max: most,
            },
        ),
        Regime::FreeMolecular => {
            let of_mach = arguments
                .mach
                .map(|mach| mach * (0.5 * heat_capacity_ratio).sqrt());
            let speed_ratio = arguments.speed_ratio.or(of_mach).unwrap_or(SPEED_RATIO);
            // ignore invalid numbers here: the check of the case reports them
            let of_case = |input: &Input| {
                let text = case.text(input.key);
                text.and_then(|text| text.parse().ok()).unwrap_or(1.0)
            };
            let accommodation = of_case(ACCOMMODATION);
            Theory::FreeMolecular(Gas {
                speed_ratio: speed_ratio.max(0.01),
                wall_temperature_ratio: of_case(WALL),
                normal_accommodation: accommodation,
                tangential_accommodation: accommodation,
            })
        }
        Regime::Blended => {
            if arguments.mach.is_none() && !arguments.database {
                faults.push("--mach: missing; the blended regime needs a Mach number".to_string());
            }
            Theory::Blended {
                mach: arguments.mach.unwrap_or_default(),
                knudsen: arguments.knudsen.unwrap_or_default(),
            }
        }
    }
}

/// Angles from a comma-separated list, each an angle or from:to:step.
fn angles(text: &str, faults: &mut Vec<String>) -> Vec<f64> {
    let mut angles = Vec::new();
    for part in text.split(',') {
        let numbers: Vec<Option<f64>> = part
            .split(':')
            .map(|number| number.trim().parse().ok())
            .collect();
        match numbers.as_slice() {
            [Some(angle)] if angle.abs() <= 180.0 => angles.push(*angle),
            [Some(from), Some(to), Some(step)]
                if from.abs() <= 180.0 && to.abs() <= 180.0 && *step > 0.0 && from <= to =>
            {
                let count = ((to - from) / step + 1e-9).floor();
                if count > ANGLES_MAX as f64 {
                    faults.push(format!(
                        "--alpha: {part} is {count} angles, must be at most {ANGLES_MAX}"
                    ));
                } else {
                    angles.extend((0..=count as u32).map(|n| from + f64::from(n) * step));
                }
            }
            _ => faults.push(format!(
                "--alpha: got \"{}\", must be an angle of -180 to 180 deg, or from:to:step",
                cut(part)
            )),
        }
    }
    angles
}

/// Fails for conditions outside a table that is set to refuse extrapolation.
fn refuse(database: &Database, theory: &Theory, angles: &[f64]) -> Result<(), Failure> {
    let (Some(grid), Theory::Blended { mach, knudsen }) = (database.table(), *theory) else {
        return Ok(());
    };
    if grid.extrapolation != Extrapolation::Refuse {
        return Ok(());
    }
    let mut faults = Vec::new();
    for angle in angles {
        for message in grid.beyond(mach, knudsen, angle.abs().to_radians()) {
            let fault = format!("{}: {message}", input::vehicle::AERODYNAMICS_TABLE);
            if !faults.contains(&fault) {
                faults.push(fault);
            }
        }
    }
    if faults.is_empty() {
        Ok(())
    } else {
        Err(Failure::Input(faults))
    }
}

fn table(name: &str, body: &AeroBody, polar: &Polar, findings: &[Finding]) -> String {
    let mut text = format!("{}: {}\n\n", printable(name), printable(&body.name));
    let mut columns = Columns::new(&[Align::Right; COLUMNS.len()]);
    columns.push(COLUMNS.map(|(key, _)| key.to_string()).to_vec());
    for row in &polar.rows {
        let cells = COLUMNS
            .iter()
            .enumerate()
            .map(|(n, (_, get))| match get(row) {
                Some(value) if n == 0 => value.to_string(),
                Some(value) => unsigned_zero(format!("{value:.DECIMALS$}")),
                None => "-".to_string(),
            });
        columns.push(cells.collect());
    }
    for line in columns.lines() {
        text.push_str(&line);
        text.push('\n');
    }
    text.push('\n');
    if let Some(center) = polar.pressure_center {
        text.push_str(&format!(
            "Center of pressure nose first: {center:.4} diameters aft of the virtual apex\n"
        ));
    }
    if let Some(margin) = polar.static_margin {
        text.push_str(&format!("Static margin: {margin:.4} diameters\n"));
    }
    for trim in &polar.trim {
        let kind = if trim.cm_alpha_per_rad < 0.0 {
            "stable"
        } else {
            "unstable"
        };
        text.push_str(&format!("Trim at {:.2} deg: {kind}\n", trim.alpha_deg));
    }
    for finding in findings {
        text.push_str(&format!("\n{}\n", finding.message));
    }
    text
}

/// Text without the sign of a negative zero.
fn unsigned_zero(text: String) -> String {
    let nothing = text
        .trim_start_matches('-')
        .chars()
        .all(|c| c == '0' || c == '.');
    if nothing {
        text.trim_start_matches('-').to_string()
    } else {
        text
    }
}
