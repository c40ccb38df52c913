//! Curves of aerodynamic coefficients. The theory is in `msape::aero`.

use crate::desk::Desk;
use crate::protocol::{Fault, Question, faults};
use msape::aero::database::{Coefficients, Database, Regime};
use msape::aero::polar::{Aero, Polar, Row, Theory, polar};
use msape::aero::standard::AeroBody;
use msape::finding::Finding;
use msape::problem::AeroProblem;
use msape::progress::Progress;
use msape::{Case, InputError, Library};
use serde::{Deserialize, Serialize};
use std::cell::RefCell;

/// Largest number of curves in a figure.
pub const CURVES_MAX: usize = 6;
/// Range of curves over Mach number.
const MACH: (f64, f64) = (0.1, 50.0);
/// Range of curves over Knudsen number.
const KNUDSEN: (f64, f64) = (1e-5, 1e3);
/// Number of points of a curve over Mach or Knudsen number.
const POINTS: u32 = 240;
/// Step of the angle of attack, deg.
const STEP_DEG: f64 = 1.0;

/// Asks for the curves of the aerodynamic database of a case.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AskCurves {
    /// Case with an outline or a design.
    pub case: Case,
    /// Conditions at which coefficients are wanted.
    pub places: Places,
}

impl Question for AskCurves {
    type Answer = Curves;
    type Refusal = Vec<Fault>;

    fn answer(self, desk: &Desk, _: &mut dyn Progress) -> Result<Curves, Vec<Fault>> {
        curves(&self, &desk.library, &desk.aerodynamics)
    }
}

/// Conditions at which coefficients are wanted, one curve for each.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Places {
    /// Mach numbers; the first applies where another number varies.
    pub mach: Vec<f64>,
    /// Knudsen numbers; the first applies where another number varies.
    pub knudsen: Vec<f64>,
    /// Angles of attack, deg.
    pub alpha_deg: Vec<f64>,
    /// Parameter of the curves over the angle of attack.
    pub family: Family,
    /// Center of gravity in diameters aft of the virtual apex, instead of the body's own.
    pub cg_over_diameter: Option<f64>,
}

/// Parameter of the curves over the angle of attack.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Family {
    /// Mach numbers at the first Knudsen number.
    Mach,
    /// Knudsen numbers at the first Mach number.
    Knudsen,
}

/// Coefficients over the angle of attack at one condition.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct OverAlpha {
    /// Mach number.
    pub mach: f64,
    /// Knudsen number.
    pub knudsen: f64,
    /// Coefficients from 0 to 180 deg, with trim.
    pub polar: Polar,
    /// Regime of the database at this condition.
    pub regime: Regime,
}

/// Coefficients at one angle of attack over Mach or Knudsen number.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Line {
    /// Angle of attack, deg.
    pub alpha_deg: f64,
    /// Mach or Knudsen numbers.
    pub x: Vec<f64>,
    /// Coefficients.
    pub rows: Vec<Row>,
}

/// All curves of a database that the page draws.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Curves {
    /// Name of the body.
    pub name: String,
    /// Diameter, m.
    pub diameter_m: f64,
    /// Center of gravity in diameters aft of the virtual apex, where known.
    pub cg_over_diameter: Option<f64>,
    /// Conditions of the question.
    pub places: Places,
    /// One curve for each Mach or Knudsen number.
    pub over_alpha: Vec<OverAlpha>,
    /// One curve for each angle.
    pub over_mach: Vec<Line>,
    /// One curve for each angle.
    pub over_knudsen: Vec<Line>,
    /// Whether static coefficients come from a table.
    pub is_table: bool,
    /// Origin of the damping coefficients.
    pub damping: DampingOrigin,
    /// Note on the placeholder for damping, where it is used.
    pub placeholder: Option<String>,
    /// Findings for the case, such as a table made for another gas.
    pub remarks: Vec<Finding>,
}

/// Origin of the damping coefficients.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum DampingOrigin {
    /// No damping.
    Absent,
    /// Equation 7 of the report and a placeholder.
    Report,
    /// The user's table.
    Table,
}

/// Cache of the last case and its database, used again when only the conditions change.
#[derive(Default)]
pub struct Kept(RefCell<Option<(Case, Prepared)>>);

type Prepared = ((AeroBody, Database), Vec<Finding>);

fn prepared(case: &Case, library: &Library) -> Result<Prepared, Vec<InputError>> {
    let problem = AeroProblem::check(case, library)?;
    Ok((problem.solve()?, problem.findings))
}

/// Curves of a case, or all of its faults.
///
/// # Errors
/// Faults of the case.
pub fn curves(question: &AskCurves, library: &Library, kept: &Kept) -> Result<Curves, Vec<Fault>> {
    let mut kept = kept.0.borrow_mut();
    let of_case = kept.take().filter(|(case, _)| *case == question.case);
    let ((mut body, database), remarks) = match of_case {
        Some((_, prepared)) => prepared,
        None => prepared(&question.case, library).map_err(faults)?,
    };
    let own_cg_m = body.cg_m;
    if let Some(x) = question.places.cg_over_diameter {
        body.cg_m = Some([x * body.surface.diameter_m(), 0.0, 0.0]);
    }
    let mut drawn = drawn(&body, &database, &question.places);
    drawn.remarks.clone_from(&remarks);
    body.cg_m = own_cg_m;
    *kept = Some((question.case.clone(), ((body, database), remarks)));
    Ok(drawn)
}

fn drawn(body: &AeroBody, database: &Database, places: &Places) -> Curves {
    use msape::aero::damping::Damping;
    let first = |list: &[f64], otherwise: f64| list.first().copied().unwrap_or(otherwise);
    let (mach, knudsen) = (first(&places.mach, 20.0), first(&places.knudsen, 0.0));
    let pairs: Vec<(f64, f64)> = match places.family {
        Family::Mach => places.mach.iter().map(|m| (*m, knudsen)).collect(),
        Family::Knudsen => places.knudsen.iter().map(|k| (mach, *k)).collect(),
    };
    let angles: Vec<f64> = (0..=(180.0 / STEP_DEG) as u32)
        .map(|n| STEP_DEG * f64::from(n))
        .collect();
    let at = |mach: f64, knudsen: f64, alpha_deg: f64| {
        let found = database.coefficients(mach, knudsen, alpha_deg.to_radians());
        row(body, &found, alpha_deg)
    };
    let line = |ends: (f64, f64), at: &dyn Fn(f64, f64) -> Row| {
        let of_angle = |alpha_deg: &f64| {
            let x = spaced(ends);
            Line {
                alpha_deg: *alpha_deg,
                rows: x.iter().map(|x| at(*x, *alpha_deg)).collect(),
                x,
            }
        };
        places
            .alpha_deg
            .iter()
            .take(CURVES_MAX)
            .map(of_angle)
            .collect()
    };
    Curves {
        name: body.name.clone(),
        diameter_m: body.surface.diameter_m(),
        cg_over_diameter: body.cg_over_diameter().map(|[x, _]| x),
        over_alpha: pairs
            .into_iter()
            .take(CURVES_MAX)
            .map(|(mach, knudsen)| {
                let aero = Aero::new(body, Theory::Blended { mach, knudsen }, Some(database));
                OverAlpha {
                    mach,
                    knudsen,
                    polar: polar(&aero, &angles),
                    regime: database.coefficients(mach, knudsen, 0.0).regime,
                }
            })
            .collect(),
        over_mach: line(MACH, &|mach, alpha_deg| at(mach, knudsen, alpha_deg)),
        over_knudsen: line(KNUDSEN, &|knudsen, alpha_deg| at(mach, knudsen, alpha_deg)),
        places: places.clone(),
        is_table: database.table().is_some(),
        damping: match database.damping() {
            Damping::Absent => DampingOrigin::Absent,
            Damping::Report { .. } => DampingOrigin::Report,
            Damping::Table(_) => DampingOrigin::Table,
        },
        placeholder: match database.damping() {
            Damping::Report { data, .. } => Some(data.placeholder_note().to_string()),
            _ => None,
        },
        remarks: Vec::new(),
    }
}

fn row(body: &AeroBody, found: &Coefficients, alpha_deg: f64) -> Row {
    let (loads, alpha_rad) = (found.loads(), alpha_deg.to_radians());
    Row {
        alpha_deg,
        ca: loads.ca,
        cn: loads.cn,
        cm_apex: loads.cm,
        cm_cg: body.cg_over_diameter().map(|[x, z]| loads.cm_about(x, z)),
        cd: loads.cd(alpha_rad),
        cl: loads.cl(alpha_rad),
        cmq: Some(found.cmq),
    }
}

/// Numbers in geometric progression, with exact ends.
fn spaced((first, last): (f64, f64)) -> Vec<f64> {
    let ratio = (last / first).ln();
    let at = |n: u32| match n {
        0 => first,
        POINTS => last,
        n => first * (ratio * f64::from(n) / f64::from(POINTS)).exp(),
    };
    (0..=POINTS).map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn question(preset: &str) -> AskCurves {
        let mut case = Case::default();
        case.set("outline.preset", preset);
        AskCurves {
            case,
            places: Places {
                mach: vec![20.0, 0.3],
                knudsen: vec![0.0, 100.0],
                alpha_deg: vec![0.0, 20.0],
                family: Family::Mach,
                cg_over_diameter: Some(0.2),
            },
        }
    }

    #[test]
    fn what_was_made_in_another_gas_is_told_with_the_curves() {
        let library = Library::builtin().unwrap();
        let told = |planet: &str| {
            let mut question = question("stardust");
            question.case.set("entry.planet", planet);
            let curves = curves(&question, &library, &Kept::default()).unwrap();
            curves
                .remarks
                .iter()
                .any(|remark| remark.key == "heat_capacity_ratio")
        };
        assert!(told("mars") && !told("earth"));
    }

    #[test]
    fn curves_are_those_of_the_database_and_meet_where_they_cross() {
        let library = Library::builtin().unwrap();
        let kept = Kept::default();
        let mut question = question("sphere-cone-60");
        let found = curves(&question, &library, &kept).unwrap();
        assert_eq!((found.over_alpha.len(), found.over_mach.len()), (2, 2));
        // at Mach 50 the curve over Mach ends; over the angle at Mach 20 and 20 deg it lies between its neighbors
        let problem = AeroProblem::check(&question.case, &library).unwrap();
        let (_, database) = problem.solve().unwrap();
        let want = database.coefficients(50.0, 0.0, 20.0_f64.to_radians());
        assert_eq!(found.over_mach[1].rows.last().unwrap().cn, want.cn);
        assert_eq!(found.over_alpha[0].polar.rows[20].alpha_deg, 20.0);
        // stable nose first with the center of gravity at 0.2 D
        let trim = found.over_alpha[0].polar.trim[0];
        assert!(trim.alpha_deg == 0.0 && trim.cm_alpha_per_rad < 0.0);
        // the cache gives the same answer as a new database, for another center of gravity
        question.places.cg_over_diameter = None;
        question.places.family = Family::Knudsen;
        let again = curves(&question, &library, &kept).unwrap();
        assert_eq!(
            again,
            curves(&question, &library, &Kept::default()).unwrap()
        );
        assert_eq!(again.cg_over_diameter, None);
        assert_eq!(again.over_alpha[1].regime, Regime::FreeMolecular);
    }

    #[test]
    fn faults_have_their_keys() {
        let faults = curves(
            &question("no-such-outline"),
            &Library::builtin().unwrap(),
            &Kept::default(),
        )
        .unwrap_err();
        assert_eq!(faults[0].key, "outline.preset");
    }

    #[test]
    fn numbers_in_equal_ratios_keep_their_ends() {
        let x = spaced((0.1, 50.0));
        assert_eq!((x[0], x.last().copied()), (0.1, Some(50.0)));
        assert!((x[120] / x[0] - (500.0_f64).sqrt()).abs() < 1e-9);
    }
}
