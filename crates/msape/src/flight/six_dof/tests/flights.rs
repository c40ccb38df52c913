//! Flights of one entry with three and with six degrees of freedom, and lift of a point mass.

use crate::flight::Request;
use crate::{Answer, Case, Library};
use numerics::math::RADIANS_PER_DEGREE as DEG;

fn entry(rest: &str) -> Answer {
    let text = format!(
        "schema = 'msape/1'
[entry]
altitude_m = 125e3
latitude_deg = 33.0
longitude_deg = 246.3833
speed_m_s = 12000.0
flight_path_angle_deg = -8.0
azimuth_deg = 90.0
[vehicle]
mass_kg = 60.0
diameter_m = 1.0
nose_radius_m = 0.35
{rest}"
    );
    let case = Case::from_text(&text).unwrap();
    crate::fly(&case, &Library::builtin().unwrap(), Request::Nothing).unwrap()
}

/// A body that keeps its nose forward flies as a point mass.
#[test]
fn trimmed_it_flies_as_a_point_mass_to_a_thousandth() {
    let three = entry("drag_coefficient = 1.5\n").flight.unwrap();
    let six = entry(
        "dof = 6
inertia_kg_m2 = [[3.0, 0.0, 0.0], [0.0, 2.5, 0.0], [0.0, 0.0, 2.5]]
[vehicle.aerodynamics]
ca = 1.5
cn_alpha_per_rad = 0.2
cm_alpha_per_rad = -0.15
cmq = -1.0
cnr = -1.0
",
    )
    .flight
    .unwrap();
    for (a, b) in [
        (
            three.peak_deceleration_earth_g.value,
            six.peak_deceleration_earth_g.value,
        ),
        (
            three.peak_deceleration_earth_g.altitude_m,
            six.peak_deceleration_earth_g.altitude_m,
        ),
        (
            three.convective_heat_load_j_m2,
            six.convective_heat_load_j_m2,
        ),
        (three.radiative_heat_load_j_m2, six.radiative_heat_load_j_m2),
        (three.time_of_flight_s, six.time_of_flight_s),
        (three.final_speed_m_s, six.final_speed_m_s),
        (three.downrange_m, six.downrange_m),
        (
            three.ballistic_coefficient_kg_m2,
            six.ballistic_coefficient_kg_m2,
        ),
    ] {
        assert!((b / a - 1.0).abs() < 1e-3, "{a} {b}");
    }
    assert!(
        six.attitude
            .unwrap()
            .maximum_total_alpha_after_peak_heating
            .angle_rad
            < 1.0 * DEG
    );
}

/// Drag against the velocity is drag at any attitude: to the accuracy of both integrations.
#[test]
fn tumbling_under_drag_alone_changes_nothing_of_the_path() {
    let three = entry("drag_coefficient = 1.5\n").flight.unwrap();
    let six = entry(
        "drag_coefficient = 1.5
dof = 6
inertia_kg_m2 = [[3.0, 0.0, 0.0], [0.0, 2.5, 0.0], [0.0, 0.0, 2.5]]
[attitude]
alpha_deg = 150.0
body_rates_deg_s = [3.0, 20.0, -5.0]
",
    )
    .flight
    .unwrap();
    let (a, b) = (
        three.peak_deceleration_earth_g,
        six.peak_deceleration_earth_g,
    );
    assert!((b.value / a.value - 1.0).abs() < 1e-5 && (b.time_s - a.time_s).abs() < 1e-2);
    assert!((six.downrange_m / three.downrange_m - 1.0).abs() < 1e-5);
}

/// A center of gravity off the axis, above it: trimmed nose down, a blunt body lifts up. With lift the point mass at trim and
/// the rigid body that starts at trim, in continuum flow, fly one path to a thousandth.
#[test]
fn at_trim_with_lift_three_and_six_degrees_of_freedom_agree_to_a_thousandth() {
    let case = |vehicle: &str| {
        let text = format!(
            "schema = 'msape/1'
[entry]
altitude_m = 70e3
latitude_deg = 33.0
longitude_deg = 246.3833
speed_m_s = 11000.0
flight_path_angle_deg = -8.0
azimuth_deg = 90.0
[stop]
altitude_m = 45e3
[outline]
preset = 'stardust'
[vehicle]
mass_kg = 46.0
cg_m = [0.25, 0.0, -0.02]
{vehicle}"
        );
        let case = Case::from_text(&text).unwrap();
        crate::fly(&case, &Library::builtin().unwrap(), Request::Nothing)
            .unwrap()
            .flight
            .unwrap()
    };
    let trimmed = case("trim = true\n");
    let six = case(
        "dof = 6
inertia_kg_m2 = [[2.4, 0.0, 0.0], [0.0, 1.9, 0.0], [0.0, 0.0, 1.9]]
[attitude]
alpha_deg = -9.6
",
    );
    for (a, b) in [
        (
            trimmed.peak_deceleration_earth_g.value,
            six.peak_deceleration_earth_g.value,
        ),
        (
            trimmed.convective_heat_load_j_m2,
            six.convective_heat_load_j_m2,
        ),
        (trimmed.time_of_flight_s, six.time_of_flight_s),
        (trimmed.downrange_m, six.downrange_m),
    ] {
        assert!((b / a - 1.0).abs() < 1e-3, "{a} {b}");
    }
    // The lift is there: without it the vehicle comes down sooner.
    let ballistic = case("");
    assert!(trimmed.time_of_flight_s > 2.0 * ballistic.time_of_flight_s);
    // The attitude stays near trim: a quarter of a degree of oscillation about a trim that changes little.
    let largest = six.attitude.unwrap().maximum_total_alpha;
    assert!(
        largest.angle_rad < 10.5 * DEG,
        "{}",
        largest.angle_rad / DEG
    );
}

/// Zero lift equals no lift; different rounding may move a peak within the tolerance of its time.
#[test]
fn lift_of_nothing_changes_nothing() {
    let none = entry("drag_coefficient = 1.5\n").flight.unwrap();
    let zero = entry("drag_coefficient = 1.5\nlift_to_drag = 0.0\nbank_deg = 30.0\n")
        .flight
        .unwrap();
    let (a, b) = (
        none.peak_deceleration_earth_g.value,
        zero.peak_deceleration_earth_g.value,
    );
    assert!((b / a - 1.0).abs() < 1e-7);
    assert!((zero.downrange_m / none.downrange_m - 1.0).abs() < 1e-9);
}

/// Lift to the right bends the path to the right, and a level schedule equals a constant.
#[test]
fn banked_to_the_right_it_comes_down_to_the_right() {
    let of = |bank: &str| {
        entry(&format!(
            "drag_coefficient = 1.5\nlift_to_drag = 0.1\n{bank}"
        ))
        .flight
        .unwrap()
    };
    let right = of("bank_deg = 90.0\n");
    let (scheduled, by_speed) = (
        of("bank_table_deg = [[0.0, 90.0], [100.0, 90.0]]\n"),
        of("bank_speed_table_deg = [[0.0, 90.0], [13000.0, 90.0]]\n"),
    );
    // Flying east, right is south.
    assert!(right.final_latitude_rad < of("bank_deg = 0.0\n").final_latitude_rad - 1e-4);
    assert_eq!(scheduled.final_latitude_rad, right.final_latitude_rad);
    assert_eq!(by_speed.final_latitude_rad, right.final_latitude_rad);
}
