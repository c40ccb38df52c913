//! Rigid bodies whose motion is known in closed form.

mod flights;

use super::*;
use crate::flight::freedom::Freedom;
use crate::flight::motion::Motion;
use crate::flight::within::Within;
use crate::problem::FlightProblem;
use crate::{Case, Library};
use nalgebra::{UnitQuaternion, Vector3};
use numerics::math;
use numerics::math::{PI, RADIANS_PER_DEGREE as DEG};

/// A planet without weight so large that a straight line stays level, air of one density, 1 km/s north.
const STREAM: &str = "
schema = 'msape/1'
[planet]
equatorial_radius_m = 1e13
uniform_gravity_m_s2 = 0.0
[atmosphere.exponential]
density_kg_m3 = 0.02
scale_height_m = 1e7
[entry]
altitude_m = 0.0
latitude_deg = 0.0
longitude_deg = 0.0
speed_m_s = 1000.0
flight_path_angle_deg = 0.0
azimuth_deg = 0.0
[heating]
radiative = 'none'
[vehicle]
dof = 6
mass_kg = 100.0
reference_area_m2 = 1.0
reference_length_m = 1.0
nose_radius_m = 0.5
";

fn problem(text: &str) -> FlightProblem {
    let case = Case::from_text(text).unwrap();
    FlightProblem::check(&case, &Library::builtin().unwrap()).unwrap()
}

fn rigid(problem: &FlightProblem) -> &Rigid {
    match &problem.body.freedom {
        Freedom::Rigid(rigid) => rigid,
        other => panic!("{other:?}"),
    }
}

fn record(problem: &FlightProblem) -> Record<RIGID_STATES> {
    integrate(
        &problem.mission,
        &problem.body,
        rigid(problem),
        &mut crate::progress::Unwatched,
    )
}

fn rates(y: &[f64; RIGID_STATES]) -> Vector3<f64> {
    Vector3::from_fn(|i, _| y[RATES + i])
}

fn attitude(y: &[f64; RIGID_STATES]) -> UnitQuaternion<f64> {
    let parts = quaternion::of_parts(core::array::from_fn(|i| y[ATTITUDE + i]));
    assert!((parts.norm_squared() - 1.0).abs() < 1e-8);
    quaternion::unit(parts)
}

fn last(record: &Record<RIGID_STATES>) -> (f64, [f64; RIGID_STATES]) {
    let step = &record.legs.last().unwrap().step;
    (step.t1, step.y1)
}

/// Over the turning Earth without air, ten minutes of tumbling about all axes of a body with products of inertia.
#[test]
fn without_forces_energy_and_angular_momentum_keep_to_1e_9_for_ten_minutes() {
    let text = "
schema = 'msape/1'
[entry]
altitude_m = 400e3
latitude_deg = 30.0
longitude_deg = 10.0
speed_m_s = 7600.0
flight_path_angle_deg = 0.0
azimuth_deg = 60.0
[stop]
time_s = 600.0
[heating]
radiative = 'none'
[vehicle]
dof = 6
mass_kg = 46.0
diameter_m = 0.8
nose_radius_m = 0.2
inertia_kg_m2 = [[1.5, 0.1, -0.05], [0.1, 2.2, 0.2], [-0.05, 0.2, 3.0]]
[attitude]
yaw_deg = 30.0
pitch_deg = -20.0
roll_deg = 100.0
body_rates_deg_s = [40.0, 60.0, -25.0]
";
    let problem = problem(text);
    let (rigid, record) = (rigid(&problem), record(&problem));
    let momentum = |y: &[f64; RIGID_STATES]| rigid.inertia.tensor_kg_m2 * rates(y);
    let energy = |y: &[f64; RIGID_STATES]| 0.5 * rates(y).dot(&momentum(y));
    // Planet-fixed axes rotate with the planet; in inertial axes the angular momentum is constant.
    let inertial = |t: f64, y: &[f64; RIGID_STATES]| {
        let angle = problem.mission.planet.rotation_rate_rad_s * t;
        UnitQuaternion::from_axis_angle(&Vector3::z_axis(), angle) * (attitude(y) * momentum(y))
    };
    let (e_0, h_0) = (energy(&record.start), inertial(0.0, &record.start));
    let (mut worst_energy, mut worst_momentum) = (0.0_f64, 0.0_f64);
    for leg in &record.legs {
        worst_energy = worst_energy.max((energy(&leg.step.y1) / e_0 - 1.0).abs());
        let h = inertial(leg.step.t1, &leg.step.y1);
        worst_momentum = worst_momentum.max((h - h_0).norm() / h_0.norm());
    }
    assert_eq!(last(&record).0, 600.0);
    assert!(worst_energy < 1e-9, "energy {worst_energy:e}");
    assert!(worst_momentum < 1e-9, "momentum {worst_momentum:e}");
}

/// ω across the axis rotates about it at (1 − I_x/I) p, and the axis about the angular momentum at |H|/I.
#[test]
fn without_forces_a_symmetric_body_follows_the_closed_form() {
    let text = STREAM.replace("density_kg_m3 = 0.02", "density_kg_m3 = 1e-30")
        + "inertia_kg_m2 = [[3.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]]
[attitude]
yaw_deg = 0.0
body_rates_deg_s = [90.0, 30.0, 0.0]
[stop]
time_s = 100.0
";
    let problem = problem(&text);
    let (t, y) = last(&record(&problem));
    let [p, q, r] = rates(&y).into();
    let (p_0, q_0) = (90.0 * DEG, 30.0 * DEG);
    // İ q̇ = (I − I_x) r p, I ṙ = (I_x − I) p q: (q, r) rotates at (I_x/I − 1) p = p/2
    let (sin, cos) = math::sin_cos(0.5 * p_0 * t);
    assert!((p - p_0).abs() < 1e-12);
    assert!(
        (q - q_0 * cos).abs() < 1e-9 && (r - q_0 * sin).abs() < 1e-9,
        "{q} {r}"
    );
    // The axis keeps its angle to the angular momentum and has turned about it by |H|/I t.
    let h_size = (9.0 * p_0 * p_0 + 4.0 * q_0 * q_0).sqrt();
    let axis = |y: &[f64; RIGID_STATES]| attitude(y) * Vector3::x();
    let start = super::start(&problem.mission, rigid(&problem));
    let h = attitude(&start) * Vector3::new(3.0 * p_0, 2.0 * q_0, 0.0) / h_size;
    let (a, b) = (axis(&start), axis(&y));
    let along = h.dot(&a);
    assert!((h.dot(&b) - along).abs() < 1e-8);
    let (sin, cos) = math::sin_cos(0.5 * h_size * t);
    let expected = h * along + (a - h * along) * cos + h.cross(&a) * sin;
    assert!((b - expected).amax() < 1e-8, "{b} {expected}");
}

/// q S d C_mα = −½ 0.02 10⁶ C_mα = −I ω² with ω = 2π 10 Hz and I = 2 kg·m².
fn of_ten_hertz(rest: &str) -> String {
    let omega = 20.0 * PI;
    let slope = -2.0 * omega * omega / 1e4;
    format!(
        "{STREAM}inertia_kg_m2 = [[3.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]]
[vehicle.aerodynamics]
cm_alpha_per_rad = {slope:?}
{rest}"
    )
}

/// 1800 swings of 10 Hz: α = α₀ cos ω t, without force, so that the speed stays.
#[test]
fn ten_hertz_for_three_minutes_has_the_frequency_of_the_closed_form() {
    let text = of_ten_hertz("[attitude]\nalpha_deg = 2.0\n[stop]\ntime_s = 180.0\n");
    let problem = problem(&text);
    let record = record(&problem);
    let omega = 20.0 * PI;
    let alpha_0 = 2.0 * DEG;
    let mut worst = 0.0_f64;
    for leg in &record.legs {
        let (t, y) = (leg.step.t1, &leg.step.y1);
        // Flying north, the angle of attack is the pitch: the rate is its derivative.
        let expected = -alpha_0 * omega * math::sin(omega * t);
        worst = worst.max((rates(y)[1] - expected).abs() / (alpha_0 * omega));
    }
    // Phase and amplitude to 1e-5 of the swing after 11310 rad.
    assert!(worst < 1e-5, "{worst:e}");
    assert!(record.legs.len() < 25_000, "{} steps", record.legs.len());
}

/// A top: I Ω² cos α − I_x p Ω + M/sin α = 0, M = q S d C_mα α, with Ω the rate at which the axis goes round the velocity.
#[test]
fn a_spinning_body_precesses_at_the_rate_of_the_closed_form() {
    let (i, i_x, alpha) = (2.0, 3.0, 0.2);
    let spin = 20.0;
    let moment = -1e4 * 0.05 * alpha;
    // dH/dt = (I_x p − I Ω cos α) Ω v̂ × n̂ for the axis n̂, p its inertial rate; the slow root.
    let (sin, cos) = math::sin_cos(alpha);
    let root = (i_x * i_x * spin * spin - 4.0 * i * cos * moment / sin).sqrt();
    let precession = (i_x * spin - root) / (2.0 * i * cos);
    // [60 − √(3600 + 8 0.98007 503.35)]/(4 0.98007)
    assert!((precession + 6.8543).abs() < 1e-3, "{precession}");
    // The axis moves on a cone about the velocity (north): the transverse rate is Ω sin α about the third axis of the
    // pitch plane.
    let text = format!(
        "{STREAM}inertia_kg_m2 = [[{i_x:?}, 0.0, 0.0], [0.0, {i:?}, 0.0], [0.0, 0.0, {i:?}]]
[vehicle.aerodynamics]
cm_alpha_per_rad = -0.05
[attitude]
alpha_deg = {:?}
body_rates_deg_s = [{:?}, 0.0, {:?}]
[stop]
time_s = 20.0
",
        alpha / DEG,
        spin / DEG,
        precession * sin / DEG,
    );
    let problem = problem(&text);
    let record = record(&problem);
    let axis = |y: &[f64; RIGID_STATES]| attitude(y) * Vector3::x();
    for leg in &record.legs {
        let (t, y) = (leg.step.t1, &leg.step.y1);
        // Over the equator at longitude 0: x up, y east, z north. The nose starts above the velocity.
        let [up, east, north] = axis(y).into();
        assert!(
            (math::acos(north) - alpha).abs() < 1e-6,
            "{t}: {}",
            math::acos(north)
        );
        let angle = math::atan2(east, up);
        let expected = precession * t;
        let off = math::sin(angle - expected).abs() + 1.0 - math::cos(angle - expected);
        assert!(off < 1e-5, "{t}: {angle} {expected}");
    }
}

#[test]
fn at_rest_it_has_the_drag_of_mach_0_whatever_line_holds() {
    let outlined = crate::library::data_file("cases/backward-entry.toml").unwrap();
    let drag_alone = STREAM.to_string()
        + "drag_table = [[0.0, 0.7], [2.0, 1.1], [4.0, 1.5]]
inertia_kg_m2 = [[3.0, 0, 0], [0, 2.5, 0], [0, 0, 2.5]]
";
    for text in [outlined, &drag_alone] {
        let problem = problem(text);
        let rigid = rigid(&problem);
        let motion = motion(&problem.mission, &problem.body, rigid);
        let fast = motion.within(&Within {
            mach: 3.0,
            ..Within::REST
        });
        let mut y = start(&problem.mission, rigid);
        y[3..6].fill(0.0);
        let table = motion.drag_table().unwrap();
        assert_ne!(table.at(0.0), table.at(3.0));
        assert_eq!(fast.drag_coefficient(0.0, &y), table.at(0.0));
    }
}
