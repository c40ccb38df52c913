//! Checks the attitude of a designed vehicle: its own mass, inertia, center of gravity and database, through its own mission.

use super::aerodynamics::{Coefficients, Medium};
use super::forms::one_row;
use super::freedom::{Degrees, TOLERANCE_DATABASE, degrees};
use super::phases::{Flown, phases};
use super::{FlightProblem, attitude, design, freedom};
use crate::aero::Drag;
use crate::aero::standard::AeroBody;
use crate::answer::Answer;
use crate::case::{Case, InputError, Reader};
use crate::design::Design;
use crate::finding::{Finding, Severity};
use crate::flight::Request;
use crate::flight::freedom::Freedom;
use crate::flight::mission::Model;
use crate::flight::six_dof::aerodynamics::{Aerodynamics, OfOutline, Reference};
use crate::flight::six_dof::attitude::at_start;
use crate::flight::six_dof::inertia::Inertia;
use crate::flight::six_dof::rigid::Rigid;
use crate::flight::six_dof::turning::turning;
use crate::library::Library;
use crate::outcome::Outcome;
use crate::progress::Progress;
use crate::quantity::Task;
use crate::quantity::input::{self, Input};
use numerics::math::RADIANS_PER_DEGREE;
use numerics::ode::Method;

/// The flight of a designed vehicle with its attitude. `[attitude]` of the case gives that of the start, `vehicle.cg_m`
/// a center of gravity in the place of the vehicle's own.
///
/// # Errors
/// Every fault of the case at once.
pub fn attitude_of_design(
    case: &Case,
    library: &Library,
    designed: &Design,
) -> Result<FlightProblem, Vec<InputError>> {
    let mut reader = Reader::new(case);
    let input = design::design(&mut reader, library);
    remark_unused(&mut reader);
    let phases = phases(&mut reader, Flown::Rigid);
    let given = attitude::given(&mut reader);
    let rates = one_row::<3>(&mut reader, &input::attitude::BODY_RATES_DEG_S).flatten();
    let cg_m = one_row::<3>(&mut reader, &input::vehicle::CG_M).flatten();
    let damping = freedom::damping(&mut reader);
    let vehicle = &designed.vehicle;
    let shape = AeroBody::of_vehicle(&case.name, vehicle).with_cg(cg_m);
    let axial_force = input.as_ref().map(|input| input.drag.of(vehicle));
    let drag = axial_force.clone().map(Drag::Table);
    let medium = Medium::of(input.as_ref().map(|input| &input.mission), library);
    let diameter_m = shape.surface.diameter_m();
    let database = medium
        .and_then(|medium| {
            Coefficients::read(&mut reader, library, &medium, diameter_m, drag.as_ref())
        })
        .and_then(|coefficients| coefficients.noted(&mut reader, &shape));
    let mass = &vehicle.mass;
    let inertia = Inertia::try_new([
        [mass.ixx_kg_m2, 0.0, 0.0],
        [0.0, mass.iyy_kg_m2, 0.0],
        [0.0, 0.0, mass.izz_kg_m2],
    ]);
    if let Err(faults) = &inertia {
        faults
            .iter()
            .for_each(|fault| reader.fault(&input::vehicle::INERTIA_KG_M2, fault.as_str()));
    }
    let (Some(input), Some(phases), Some(given), Some(database), Ok(inertia), true) = (
        input,
        phases,
        given,
        database,
        inertia,
        reader.faults.is_empty(),
    ) else {
        return Err(reader.into_faults());
    };
    let of_outline = OfOutline {
        axial_force: axial_force.filter(|_| database.table().is_none()),
        database,
    };
    // the integration settings of the case are for its point mass
    let mut mission = input.mission.clone();
    mission.phases = phases;
    mission.solver.model = Model::ThreeDof;
    mission.solver.method = Method::DormandPrince853;
    mission.solver.tolerance = mission.solver.tolerance.min(TOLERANCE_DATABASE);
    let mut body = input.body(vehicle, None);
    body.freedom = Freedom::Rigid(Box::new(Rigid {
        inertia,
        cg_m: shape.cg_m.unwrap_or_default(),
        reference: Reference {
            area_m2: body.reference_area_m2,
            length_m: vehicle.dimensions.diameter_m,
            span_m: vehicle.dimensions.diameter_m,
        },
        aerodynamics: Aerodynamics::Database(Box::new(of_outline)),
        damping,
        attitude: at_start(&given, &mission.start, &mission),
        rates_rad_s: rates
            .unwrap_or_default()
            .map(|rate| rate * RADIANS_PER_DEGREE)
            .into(),
    }));
    Ok(FlightProblem {
        mission,
        body,
        outline: None,
        findings: reader.into_findings(),
    })
}

/// Whether a case leaves its vehicle to be designed: it has a section `[design]` and neither a mass nor an outline of its own.
pub fn leaves_vehicle_to_design(case: &Case) -> bool {
    case.gives_any(input::design::INPUTS)
        && !case.gives_any(input::outline::INPUTS)
        && !case.gives_any(&[&input::vehicle::MASS_KG])
}

/// Whether a case asks for six degrees of freedom.
pub fn asks_for_attitude(case: &Case) -> bool {
    degrees(&mut Reader::new(case)) == Some(Degrees::Six)
}

/// Whether `fly` flies the vehicle of a design as a rigid body.
pub(super) fn flies_design(case: &Case) -> bool {
    leaves_vehicle_to_design(case) && asks_for_attitude(case)
}

/// The answer of a design, flown as a rigid body; without a vehicle the outcome of the design is the answer.
///
/// # Errors
/// Every fault of the case at once.
pub fn fly_designed(
    case: &Case,
    library: &Library,
    designed: &Answer,
    request: Request,
) -> Result<Answer, Vec<InputError>> {
    let Some(design) = &designed.design else {
        return Ok(Answer {
            passes: Vec::new(),
            ..designed.clone()
        });
    };
    let mut answer = attitude_of_design(case, library, design)?.solve(&case.name, request);
    answer.adjustments.clone_from(&designed.adjustments);
    answer.findings.push(flown(designed.outcome, design));
    Ok(answer)
}

/// Adds to the answer of a design its entries from a set of attitudes and rates; nothing where there is no vehicle.
///
/// # Errors
/// Every fault of the case at once.
pub fn add_turning(
    case: &Case,
    library: &Library,
    designed: &mut Answer,
    progress: &mut dyn Progress,
) -> Result<(), Vec<InputError>> {
    if let Some(design) = &mut designed.design {
        let FlightProblem { mission, body, .. } = attitude_of_design(case, library, design)?;
        design.turning = turning(&mission, &body, progress);
    }
    Ok(())
}

/// Finding on the vehicle that was flown, and on whether its design converged.
fn flown(outcome: Outcome, design: &Design) -> Finding {
    let vehicle = &design.vehicle;
    let mass = &vehicle.mass;
    let (severity, settled) = match outcome {
        Outcome::Converged => (Severity::Note, String::new()),
        other => (
            Severity::Extrapolated,
            format!(" The design is {}.", other.name()),
        ),
    };
    Finding {
        severity,
        model: "design".to_string(),
        key: String::new(),
        value: None,
        valid: (None, None),
        message: format!(
            "Flown is the vehicle of the design: {:.3} kg, {:.4} m across, center of gravity {:.4} m aft of the virtual apex, inertia {:.3} kg-m^2 about the axis and {:.3} across it.{settled}",
            mass.mass_kg,
            vehicle.dimensions.diameter_m,
            vehicle.dimensions.cg_from_apex_m,
            mass.ixx_kg_m2,
            mass.iyy_kg_m2,
        ),
        source: "the design of the case".to_string(),
        field: None,
    }
}

/// Adds remarks on inputs of another vehicle that are given but not used.
fn remark_unused(reader: &mut Reader) {
    let unused = |input: &Input| !input.is_of(Task::DesignedBody);
    freedom::unused(reader, "the attitude of a design", unused);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Request, design};

    fn case() -> Case {
        let text = crate::library::data_file("cases/msr-eev-cp.toml").unwrap();
        Case::from_text(text).unwrap()
    }

    #[test]
    fn a_designed_vehicle_enters_nose_first_where_it_flies_as_its_point_mass() {
        let library = Library::builtin().unwrap();
        let case = case();
        let answer = design(&case, &library, Request::Nothing).unwrap();
        let point = answer.flight.as_ref().unwrap();
        let designed = answer.design.as_ref().unwrap();
        let problem = attitude_of_design(&case, &library, designed).unwrap();
        let rigid = problem.solve("", Request::Nothing).flight.unwrap();
        // Along the velocity at the start: gravity bends the path slowly, so that drag is that of zero angle but for cos α.
        let (a, b) = (
            rigid.peak_deceleration_earth_g.value,
            point.peak_deceleration_earth_g.value,
        );
        assert!((a / b - 1.0).abs() < 0.01, "{a} against {b} Earth g");
        assert!(rigid.attitude.is_some());
    }

    #[test]
    fn the_attitude_of_the_start_is_that_of_the_case_and_faults_are_told() {
        let library = Library::builtin().unwrap();
        let mut case = case();
        let answer = design(&case, &library, Request::Nothing).unwrap();
        let designed = answer.design.unwrap();
        case.set("attitude.alpha_deg", "170");
        let problem = attitude_of_design(&case, &library, &designed).unwrap();
        let attitude = problem.solve("", Request::Nothing).flight.unwrap().attitude;
        let initial = attitude.unwrap().initial_total_alpha_rad;
        assert!((initial / RADIANS_PER_DEGREE - 170.0).abs() < 1e-6);
        case.set("attitude.yaw_deg", "10");
        let faults = attitude_of_design(&case, &library, &designed).unwrap_err();
        assert!(
            faults
                .iter()
                .any(|fault| fault.key.starts_with("attitude.")),
            "{faults:?}"
        );
    }

    #[test]
    fn fly_takes_the_vehicle_of_a_design_as_the_page_does() {
        let library = Library::builtin().unwrap();
        let mut case = case();
        case.set("vehicle.dof", "6");
        case.set("attitude.alpha_deg", "145");
        let designed = design(&case, &library, Request::Steps).unwrap();
        let page = attitude_of_design(&case, &library, designed.design.as_ref().unwrap()).unwrap();
        let page = page.solve(&case.name, Request::Uniform(2.0));
        let ours = crate::fly(&case, &library, Request::Uniform(2.0)).unwrap();
        assert_eq!(ours.flight, page.flight);
        assert_eq!(ours.outcome, page.outcome);
        assert_eq!(ours.adjustments, designed.adjustments);
        let said = &ours.findings.last().unwrap().message;
        assert!(
            said.contains("Flown is the vehicle of the design"),
            "{said}"
        );
    }

    #[test]
    fn a_design_without_a_vehicle_is_the_answer_and_keys_that_play_no_part_are_told() {
        let library = Library::builtin().unwrap();
        let mut case = case();
        case.set("vehicle.dof", "6");
        case.set("vehicle.inertia_kg_m2", "[[3, 0, 0], [0, 2, 0], [0, 0, 2]]");
        let answer = design(&case, &library, Request::Nothing).unwrap();
        let problem = attitude_of_design(&case, &library, answer.design.as_ref().unwrap()).unwrap();
        let told = problem.findings.iter();
        let told = told.filter(|f| f.key == "vehicle.inertia_kg_m2").count();
        assert_eq!(told, 1);
        let none = Answer {
            outcome: Outcome::NotClosed,
            flight: None,
            design: None,
            ..answer
        };
        let answer = fly_designed(&case, &library, &none, Request::Nothing).unwrap();
        assert_eq!((answer.outcome, answer.flight), (Outcome::NotClosed, None));
    }

    #[test]
    fn with_three_degrees_of_freedom_the_way_to_fly_a_design_is_told() {
        let library = Library::builtin().unwrap();
        let faults = crate::fly(&case(), &library, Request::Nothing).unwrap_err();
        let mass = faults.iter().find(|f| f.key == "vehicle.mass_kg").unwrap();
        assert!(mass.message.contains("vehicle.dof = 6"), "{mass}");
        // a vehicle given in the case is flown as before, whatever else the case contains
        let mut own = case();
        own.set("vehicle.dof", "6");
        own.set("vehicle.mass_kg", "46");
        assert!(!leaves_vehicle_to_design(&own));
        own.set("vehicle.mass_kg", "");
        own.set("outline.preset", "stardust");
        assert!(!leaves_vehicle_to_design(&own));
    }
}
