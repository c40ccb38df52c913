//! Checks how a vehicle is free to move: a point mass with or without lift, or a rigid body.

use super::forms::{beyond, one_row};
use super::outline::Outline;
use super::{attitude, center};
use crate::aero::Drag;
use crate::aero::table::Extrapolation;
use crate::case::Reader;
use crate::finding::Finding;
use crate::flight::freedom::Freedom;
use crate::flight::lift::{Bank, Lift, Source};
use crate::flight::mission::{Mission, Model, Solver};
use crate::flight::six_dof::aerodynamics::{
    Aerodynamics, Constants, Damping, OfOutline, Reference,
};
use crate::flight::six_dof::inertia::Inertia;
use crate::flight::six_dof::rigid::Rigid;
use crate::flight::trim::Trim;
use crate::quantity::Task;
use crate::quantity::input::vehicle::CONSTANTS;
use crate::quantity::input::{self, Alternatives, Input, inputs};
use numerics::interp::{End, Table1};
use numerics::math::{PI, RADIANS_PER_DEGREE};
use numerics::ode::Method;

const DAMPING: [&Input; 3] = [
    &input::vehicle::AERODYNAMICS_CLP,
    &input::vehicle::AERODYNAMICS_CMQ,
    &input::vehicle::AERODYNAMICS_CNR,
];

/// Degrees of freedom.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Degrees {
    Three,
    Six,
}

/// Degrees of freedom of the case.
pub(super) fn degrees(reader: &mut Reader) -> Option<Degrees> {
    if !reader.given(&input::vehicle::DOF) {
        return Some(Degrees::Three);
    }
    match reader.number(&input::vehicle::DOF)? {
        3.0 => Some(Degrees::Three),
        6.0 => Some(Degrees::Six),
        other => {
            reader.fault(&input::vehicle::DOF, format!("got {other}, must be 3 or 6"));
            None
        }
    }
}

/// Other data of the body.
pub(super) struct Known<'a> {
    pub(super) degrees: Degrees,
    pub(super) mission: Option<&'a Mission>,
    pub(super) area_m2: Option<f64>,
    pub(super) length_m: Option<f64>,
    pub(super) database: Option<OfOutline>,
    pub(super) outline: &'a Outline,
    /// Whether a point mass flies at trim.
    pub(super) at_trim: bool,
}

/// How the vehicle is free to move.
pub(super) fn freedom(reader: &mut Reader, known: Known) -> Option<Freedom> {
    match known.degrees {
        Degrees::Three => {
            let at_trim = known.at_trim;
            unused(reader, "three degrees of freedom", |input| {
                let of_trim = at_trim && *input == input::vehicle::CG_M;
                input.is_of(Task::RigidBody) && !input.is_of(Task::PointMass) && !of_trim
            });
            let bank = bank(reader);
            let lift = if at_trim {
                let cg = center::cg(reader, known.outline, true)?;
                let of_outline = known.database.as_ref()?;
                Some(Source::Trim(Trim::new(&of_outline.database, cg)))
            } else {
                lift(reader)?
            };
            Some(match lift {
                None => Freedom::Ballistic,
                Some(source) => Freedom::Lifting(Box::new(Lift {
                    source,
                    bank: bank?,
                    beyond_bank: beyond(reader, &input::vehicle::BANK_EXTRAPOLATION),
                })),
            })
        }
        Degrees::Six => {
            unused(reader, "six degrees of freedom", |input| {
                input.is_of(Task::PointMass) && !input.is_of(Task::RigidBody)
            });
            rigid(reader, known).map(|rigid| Freedom::Rigid(Box::new(rigid)))
        }
    }
}

/// Inputs that are given but not used lead to remarks, not faults, so that a case may be flown both ways.
pub(super) fn unused(reader: &mut Reader, model: &str, which: impl Fn(&Input) -> bool) {
    for input in inputs().filter(|input| which(input)) {
        if reader.given(input) {
            reader.remark(input, format!("{} is not used in {model}.", input.label));
        }
    }
}

fn rigid(reader: &mut Reader, known: Known) -> Option<Rigid> {
    let inertia = inertia(reader);
    let cg = center::cg(reader, known.outline, known.database.is_some());
    let span_m = reader.number(&input::vehicle::REFERENCE_SPAN_M);
    let [ca, cn, cm] = [
        &input::vehicle::AERODYNAMICS_CA,
        &input::vehicle::AERODYNAMICS_CN_ALPHA_PER_RAD,
        &input::vehicle::AERODYNAMICS_CM_ALPHA_PER_RAD,
    ]
    .map(|input| reader.number(input).unwrap_or(0.0));
    let damping = damping(reader);
    let constants = reader.any_given(CONSTANTS);
    let given = attitude::given(reader);
    let rates = one_row::<3>(reader, &input::attitude::BODY_RATES_DEG_S);
    if let Some(mission) = known.mission
        && mission.solver.model == Model::AllenEggers
    {
        let message = format!(
            "got \"{}\", which has no attitude; must be \"{}\" with {} = 6",
            Model::AllenEggers.name(),
            Model::ThreeDof.name(),
            input::vehicle::DOF
        );
        reader.fault(&input::solver::FLIGHT_MODEL, message);
    }
    let length_m = known.length_m?;
    let mission = known.mission?;
    Some(Rigid {
        inertia: inertia?,
        cg_m: cg?,
        reference: Reference {
            area_m2: known.area_m2?,
            length_m,
            span_m: span_m.unwrap_or(length_m),
        },
        aerodynamics: match known.database {
            Some(database) => Aerodynamics::Database(Box::new(database)),
            None if constants => Aerodynamics::Constants(Constants {
                ca,
                cn_alpha_per_rad: cn,
                cm_alpha_per_rad: cm,
            }),
            None => Aerodynamics::Drag,
        },
        damping,
        attitude: crate::flight::six_dof::attitude::at_start(&given?, &mission.start, mission),
        rates_rad_s: rates?
            .unwrap_or_default()
            .map(|p| p * RADIANS_PER_DEGREE)
            .into(),
    })
}

/// Damping about the three axes; none where the case gives none.
pub(super) fn damping(reader: &mut Reader) -> Damping {
    let [clp, cmq, cnr] = DAMPING.map(|input| reader.number(input).unwrap_or(0.0));
    Damping { clp, cmq, cnr }
}

fn inertia(reader: &mut Reader) -> Option<Inertia> {
    let key = &input::vehicle::INERTIA_KG_M2;
    if !reader.given(key) {
        let dof = &input::vehicle::DOF;
        let message =
            format!("missing; with {dof} = 6 give three rows of three numbers, in kg-m^2");
        reader.fault(key, message);
        return None;
    }
    let rows = reader.rows(key)?;
    let matrix: Option<Vec<[f64; 3]>> = rows
        .iter()
        .map(|row| <[f64; 3]>::try_from(row.as_slice()).ok())
        .collect();
    let Some(Ok(matrix)) = matrix.map(<[[f64; 3]; 3]>::try_from) else {
        let message = format!(
            "got {} rows, must be three rows of three numbers, in kg-m^2",
            rows.len()
        );
        reader.fault(key, message);
        return None;
    };
    match Inertia::try_new(matrix) {
        Ok(inertia) => Some(inertia),
        Err(faults) => {
            faults
                .iter()
                .for_each(|fault| reader.fault(key, fault.as_str()));
            None
        }
    }
}

/// Way in which the case gives a quantity; `Err`, with the fault recorded, if there is more than one.
fn one_of(
    reader: &mut Reader,
    alternatives: &Alternatives,
    what: &str,
) -> Result<Option<&'static Input>, ()> {
    match reader.ways(alternatives).as_slice() {
        [] => Ok(None),
        [only] => Ok(Some(only)),
        [_, second, ..] => {
            let keys: Vec<&str> = alternatives.inputs().map(|input| input.key).collect();
            let message = format!(
                "{what} is given in more than one way; give one of {}",
                keys.join(", ")
            );
            reader.fault(second, message);
            Err(())
        }
    }
}

fn lift(reader: &mut Reader) -> Option<Option<Source>> {
    let Some(way) = one_of(reader, &input::vehicle::LIFT, "lift").ok()? else {
        return Some(None);
    };
    Some(Some(if *way == input::vehicle::LIFT_TO_DRAG {
        Source::OfDrag(reader.number(way)?)
    } else if *way == input::vehicle::LIFT_COEFFICIENT {
        Source::Coefficient(reader.number(way)?)
    } else {
        let rule = beyond(reader, &input::vehicle::AERODYNAMICS_EXTRAPOLATION);
        let end = match rule {
            Extrapolation::Extend => End::Extrapolate,
            Extrapolation::Hold | Extrapolation::Refuse => End::Hold,
        };
        Source::Table(table(reader, way, 1.0, end)?, rule)
    }))
}

fn bank(reader: &mut Reader) -> Option<Bank> {
    let Some(way) = one_of(reader, &input::vehicle::BANK, "the angle of bank").ok()? else {
        return Some(Bank::Constant(0.0));
    };
    Some(if *way == input::vehicle::BANK_DEG {
        Bank::Constant(reader.number(way)? * RADIANS_PER_DEGREE)
    } else if *way == input::vehicle::BANK_TABLE_DEG {
        Bank::OfTime(bank_table(reader, way)?)
    } else {
        Bank::OfSpeed(bank_table(reader, way)?)
    })
}

/// A table of the angle of bank, rad; between two rows within half a turn of upright it goes the shorter way.
fn bank_table(reader: &mut Reader, input: &'static Input) -> Option<Table1> {
    let mut rows = reader.rows(input)?;
    let pairs = |rows: &[Vec<f64>]| -> Vec<f64> {
        rows.iter().filter_map(|row| row.get(1)).copied().collect()
    };
    let given = pairs(&rows);
    if given.iter().all(|angle| angle.abs() <= HALF_TURN_DEG) {
        let mut before = given.first().copied().unwrap_or_default();
        for row in &mut rows {
            if let Some(angle) = row.get_mut(1) {
                let turns = ((*angle - before) / (2.0 * HALF_TURN_DEG)).abs();
                if turns > 0.5 {
                    let nearest = ((before - *angle) / (2.0 * HALF_TURN_DEG)).round();
                    *angle += nearest * 2.0 * HALF_TURN_DEG;
                }
                before = *angle;
            }
        }
    }
    if pairs(&rows) != given {
        let message = "Between rows more than 180 deg apart the bank goes the shorter way, through 180 deg. For the other way write angles beyond 180 deg, or a row between.";
        reader.findings.push(Finding::note("bank", input, message));
    }
    let column = |i: usize, factor: f64| -> Vec<f64> {
        let cells = rows.iter().filter_map(|row| row.get(i));
        cells.map(|x| x * factor).collect()
    };
    let table = Table1::try_new(&column(0, 1.0), &column(1, RADIANS_PER_DEGREE), End::Hold);
    table
        .map_err(|error| reader.fault(input, error.to_string()))
        .ok()
}

/// Half a turn, deg.
const HALF_TURN_DEG: f64 = 180.0;

/// A table of two columns, the second times a factor.
fn table(reader: &mut Reader, input: &'static Input, factor: f64, end: End) -> Option<Table1> {
    let rows = reader.rows(input)?;
    let column = |i: usize, factor: f64| -> Vec<f64> {
        rows.iter()
            .filter_map(|row| row.get(i))
            .map(|x| x * factor)
            .collect()
    };
    match Table1::try_new(&column(0, 1.0), &column(1, factor), end) {
        Ok(table) => Some(table),
        Err(error) => {
            reader.fault(input, error.to_string());
            None
        }
    }
}

/// Reference length of moments and Knudsen number, m: as given, else the diameter, else that of a circle of the area.
pub(super) fn length_m(
    reader: &mut Reader,
    diameter_m: Option<f64>,
    area_m2: Option<f64>,
) -> Option<f64> {
    let of_area = || area_m2.map(|area| (4.0 * area / PI).sqrt());
    if reader.given(&input::vehicle::REFERENCE_LENGTH_M) {
        return reader.number(&input::vehicle::REFERENCE_LENGTH_M);
    }
    diameter_m.or_else(of_area)
}

/// Drag as for a point mass, where constant coefficients replace it.
pub(super) fn drag_of_constants(reader: &mut Reader) -> Option<Drag> {
    let input = &input::vehicle::AERODYNAMICS_CA;
    let ca = reader.number(input);
    Some(Drag::Constant(if reader.given(input) { ca? } else { 0.0 }))
}

/// Without moments the steps are long: energy and angular momentum keep to 1e-10 over ten minutes of tumbling.
const TOLERANCE_FREE: f64 = 1e-11;
/// With constants: energy and angular momentum without air to 1e-9, a swing of 10 Hz to 1e-5 after three minutes.
const TOLERANCE_CONSTANTS: f64 = 1e-9;
/// With a database, whose tables have kinks: largest angles of an entry to 1e-5.
pub(super) const TOLERANCE_DATABASE: f64 = 1e-8;

/// Method and accuracy of six degrees of freedom, where the case does not say otherwise.
pub(super) fn solver(reader: &Reader, rigid: &Rigid, solver: &mut Solver) {
    if !reader.given(&input::solver::METHOD) {
        solver.method = Method::DormandPrince853;
    }
    if !reader.given(&input::solver::TOLERANCE) {
        let damped = rigid.damping != Damping::default();
        solver.tolerance = match &rigid.aerodynamics {
            Aerodynamics::Database(_) => TOLERANCE_DATABASE,
            Aerodynamics::Drag if !damped => TOLERANCE_FREE,
            Aerodynamics::Constants(c) if !damped && c.cm_alpha_per_rad == 0.0 => TOLERANCE_FREE,
            _ => TOLERANCE_CONSTANTS,
        };
    }
}

#[cfg(test)]
mod tests {
    use super::Finding;
    use crate::problem::{FlightProblem, attitude_of_design};
    use crate::{Case, Library};

    const FREE: &str = "
schema = 'msape/1'
[entry]
altitude_m = 125e3
latitude_deg = 33.0
longitude_deg = 246.0
speed_m_s = 12e3
flight_path_angle_deg = -8.0
azimuth_deg = 90.0
[vehicle]
dof = 6
mass_kg = 46.0
diameter_m = 1.0
nose_radius_m = 0.25
";

    fn said(rest: &str) -> String {
        let case = Case::from_text(&format!("{FREE}{rest}")).unwrap();
        match FlightProblem::check(&case, &Library::builtin().unwrap()) {
            Ok(_) => String::new(),
            Err(faults) => {
                let lines: Vec<String> = faults.iter().map(ToString::to_string).collect();
                lines.join("\n")
            }
        }
    }

    const SOUND: &str = "inertia_kg_m2 = [[3.0, 0.0, 0.0], [0.0, 2.5, 0.0], [0.0, 0.0, 2.5]]\n";

    #[test]
    fn a_body_without_aerodynamics_and_attitude_is_allowed() {
        assert_eq!(said(SOUND), "");
    }

    #[test]
    fn constants_of_a_rigid_body_are_told_where_they_are_not_used() {
        let library = Library::builtin().unwrap();
        let told = |findings: &[Finding]| {
            let unused = findings
                .iter()
                .filter(|f| f.message.contains("is not used"));
            let keys: Vec<String> = unused.map(|finding| finding.key.clone()).collect();
            keys
        };
        let constants = "[vehicle.aerodynamics]\nca = 1.5\ncm_alpha_per_rad = -0.1\ncmq = -0.5\n";
        let point = FREE.replace("dof = 6", "dof = 3") + constants;
        let point = FlightProblem::check(&Case::from_text(&point).unwrap(), &library).unwrap();
        assert_eq!(
            told(&point.findings),
            [
                "vehicle.aerodynamics.cm_alpha_per_rad",
                "vehicle.aerodynamics.cmq"
            ]
        );
        let text = crate::library::data_file("cases/msr-eev-cp.toml").unwrap();
        let mut case = Case::from_text(text).unwrap();
        for (key, value) in [("ca", "1.5"), ("cm_alpha_per_rad", "-0.1"), ("cmq", "-0.5")] {
            case.set(&format!("vehicle.aerodynamics.{key}"), value);
        }
        let answer = crate::design(&case, &library, crate::Request::Nothing).unwrap();
        let designed = answer.design.unwrap();
        let designed = attitude_of_design(&case, &library, &designed).unwrap();
        assert_eq!(
            told(&designed.findings),
            [
                "vehicle.aerodynamics.ca",
                "vehicle.aerodynamics.cm_alpha_per_rad"
            ]
        );
    }

    /// Without a word the command would end with code 2 and nobody would know why.
    #[test]
    fn a_table_without_the_length_of_its_moments_is_refused_with_its_key() {
        let table = "cg_m = [0.2, 0.0, 0.0]\n[vehicle.aerodynamics]\ntable = [[1.0, 0.0, 1.5, 0.0], [1.0, 10.0, 1.4, 0.1]]\n";
        let area = "reference_area_m2 = 0.7854\nreference_length_m = 1.0";
        let case = format!("{FREE}{SOUND}{table}").replace("diameter_m = 1.0", area);
        let faults = FlightProblem::check(
            &Case::from_text(&case).unwrap(),
            &Library::builtin().unwrap(),
        );
        let said: Vec<String> = faults
            .unwrap_err()
            .iter()
            .map(ToString::to_string)
            .collect();
        assert!(
            said.concat().contains("vehicle.diameter_m: missing"),
            "{said:?}"
        );
    }

    #[test]
    fn every_fault_of_a_rigid_body_is_said_at_once() {
        let said = said(
            "
inertia_kg_m2 = [[9.0, 0.0, 0.0], [0.0, 2.5, 0.0], [0.0, 0.0, 2.5]]
cg_m = [0.2, 0.0]
[attitude]
quaternion = [0.0, 0.0, 0.0, 0.0]
body_rates_deg_s = [[1.0, 2.0, 3.0], [1.0, 2.0, 3.0]]
[solver]
flight_model = 'allen-eggers'
",
        );
        for part in [
            "vehicle.inertia_kg_m2: has the principal moments 2.500000, 2.500000 and 9.000000 kg-m^2; the largest must be at most 5.000000 kg-m^2",
            "vehicle.cg_m: row 1 has 2 numbers, must be",
            "attitude.quaternion: got [0.0, 0.0, 0.0, 0.0], whose length is 0; must have a length above 0",
            "attitude.body_rates_deg_s: got 2 rows, must be one row of 3 numbers",
            "solver.flight_model: got \"allen-eggers\", which has no attitude",
        ] {
            assert!(said.contains(part), "{part}\nnot in\n{said}");
        }
    }

    #[test]
    fn inertia_must_be_there_and_symmetric() {
        assert!(said("").contains("vehicle.inertia_kg_m2: missing"));
        let skewed = "inertia_kg_m2 = [[3.0, 0.5, 0.0], [0.0, 2.5, 0.0], [0.0, 0.0, 2.5]]\n";
        assert!(said(skewed).contains("both must be the same"));
        let two = "inertia_kg_m2 = [[3.0, 0.0, 0.0], [0.0, 2.5, 0.0]]\n";
        assert!(said(two).contains("got 2 rows, must be three rows of three numbers"));
        let nothing = "inertia_kg_m2 = [[0, 0, 0], [0, 0, 0], [0, 0, 0]]\n";
        assert!(said(nothing).contains("must be positive definite"));
    }

    #[test]
    fn a_center_of_gravity_outside_the_outline_is_refused_with_the_range() {
        let outline = "[outline]\npreset = 'stardust'\n";
        let with = |cg: &str| said(&format!("{SOUND}cg_m = {cg}\n{outline}"));
        assert_eq!(with("[0.3, 0.0, 0.01]"), "");
        assert!(
            with("[-0.2, 0.0, 0.0]")
                .contains("outside the outline; must be within it, x 0.0354 to")
        );
        assert!(with("[0.3, 0.4, 0.3]").contains("0.5 m from the axis"));
        assert!(said(&format!("{SOUND}{outline}")).contains("vehicle.cg_m: missing"));
    }

    #[test]
    fn two_ways_of_one_thing_are_refused() {
        let both = "[attitude]\nyaw_deg = 1.0\nbeta_deg = 2.0\n";
        assert!(
            said(&format!("{SOUND}{both}"))
                .contains("attitude.beta_deg: given together with attitude.yaw_deg")
        );
        let drag = format!("drag_coefficient = 1.0\n{SOUND}[vehicle.aerodynamics]\nca = 1.0\n");
        assert!(
            said(&drag)
                .contains("vehicle.aerodynamics.ca: given together with vehicle.drag_coefficient")
        );
        assert!(said("dof_ = 5\n").contains("vehicle.dof_: unknown key"));
    }
}
