//! Lower bound for the cost of a trajectory: the same method at the same tolerance, over a non-rotating sphere with an
//! exponential atmosphere, constant drag, no heating, no events except the ground, no results. And the same method over
//! the right-hand side of a flight.

use msape::flight::integration::point_tolerance;
use msape::flight::motion::Motion;
use msape::flight::three_dof;
use msape::flight::within::Within;
use msape::problem::FlightProblem;
use numerics::math;
use numerics::ode::{Integrator, Method, Tolerance};

const MU_M3_S2: f64 = 3.986e14;
const RADIUS_M: f64 = 6_378_100.0;
const SURFACE_DENSITY_KG_M3: f64 = 1.225;
const SCALE_HEIGHT_M: f64 = 7_100.0;
const BALLISTIC_COEFFICIENT_KG_M2: f64 = 60.0;

fn derivative(y: &[f64; 6]) -> [f64; 6] {
    let [px, py, pz, vx, vy, vz] = *y;
    let r = (px * px + py * py + pz * pz).sqrt();
    let v = (vx * vx + vy * vy + vz * vz).sqrt();
    let rho = SURFACE_DENSITY_KG_M3 * math::exp((RADIUS_M - r) / SCALE_HEIGHT_M);
    let drag = rho * v / (2.0 * BALLISTIC_COEFFICIENT_KG_M2);
    let pull = MU_M3_S2 / (r * r * r);
    [
        vx,
        vy,
        vz,
        -pull * px - drag * vx,
        -pull * py - drag * vy,
        -pull * pz - drag * vz,
    ]
}

/// Flight from 125 km at 12 km/s and -8 deg to the ground: time in s, and number of evaluations.
pub fn bare_flight(tolerance: f64) -> (f64, u64) {
    let (speed, angle) = (12_000.0, -8.0 * math::RADIANS_PER_DEGREE);
    let start = [
        RADIUS_M + 125_000.0,
        0.0,
        0.0,
        speed * math::sin(angle),
        speed * math::cos(angle),
        0.0,
    ];
    let (position, relative) = (1_000.0 * tolerance, tolerance);
    let tolerance = Tolerance {
        relative: [0.0, 0.0, 0.0, relative, relative, relative],
        absolute: [
            position,
            position,
            position,
            10.0 * relative,
            10.0 * relative,
            10.0 * relative,
        ],
    };
    let mut integrator = Integrator::new(Method::DormandPrince54, tolerance, 0.0, start);
    let mut f = |_: f64, y: &[f64; 6]| derivative(y);
    loop {
        let [x, y, z, ..] = *integrator.y();
        let above = (x * x + y * y + z * z).sqrt() > RADIUS_M;
        if !above || integrator.step(&mut f, 1e5).is_err() {
            return (integrator.t(), integrator.statistics().evaluations);
        }
    }
}

/// Flies a problem by its own right-hand side to the ground, without stops, records and results: time in s, and evaluations.
pub fn exact_flight(problem: &FlightProblem, tolerance: f64) -> (f64, u64) {
    let FlightProblem { mission, body, .. } = problem;
    let mut motion = three_dof::motion(mission, body);
    let start = three_dof::start(&mission.start);
    let tolerance = point_tolerance(tolerance);
    let mut integrator = Integrator::new(Method::DormandPrince54, tolerance, 0.0, start);
    loop {
        let [x, y, z, ..] = *integrator.y();
        let altitude_m = motion.point.ellipsoid.local([x, y, z]).altitude_m;
        motion = motion.within(&Within {
            altitude_m,
            ..Within::REST
        });
        let mut f = |t: f64, y: &[f64; 8]| motion.derivative(t, y);
        if altitude_m <= 0.0 || integrator.step(&mut f, 1e5).is_err() {
            return (integrator.t(), integrator.statistics().evaluations);
        }
    }
}
