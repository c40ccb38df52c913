//! Displacements and forces.

use super::*;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

#[test]
fn circular_plate_under_pressure() {
    let t = 0.05;
    let middle = |held| {
        move |elements: u32| {
            let shell = plate(t, elements);
            -shell.pressed([None, held]).at_node(0, 0)[0]
        }
    };
    let shell = plate(t, 1);
    // with shear: w = p a⁴ / 64 D + p a² / 4 S
    let shear = PRESSURE / (4.0 * shell.shear());
    let bending = PRESSURE / (64.0 * shell.bending());
    let clamped = row(
        "plate, clamped: deflection",
        MESHES,
        bending + shear,
        middle(CLAMPED),
    );
    let resting = bending * (5.0 + NU) / (1.0 + NU) + shear;
    let supported = row(
        "plate, supported: deflection",
        MESHES,
        resting,
        middle(Some(Held::Axially)),
    );
    fourth_order(clamped, 1e-5);
    fourth_order(supported, 1e-5);
    // p a² (1 + ν) / 16 at the center, −p a² / 8 at the edge
    let moment = |elements, last: bool| {
        let samples = plate(t, elements).samples([None, CLAMPED]);
        let sample = if last {
            samples.last()
        } else {
            samples.first()
        };
        sample.unwrap().forces.bending_n[0].abs()
    };
    let inner = row(
        "plate, clamped: moment in the middle",
        MESHES,
        PRESSURE * (1.0 + NU) / 16.0,
        |n| moment(n, false),
    );
    let edge = row(
        "plate, clamped: moment at the edge",
        MESHES,
        PRESSURE / 8.0,
        |n| moment(n, true),
    );
    // at the edge exact from the balance of the element, as its edge rotation is quadratic; on the axis extrapolated
    // linearly from the Gauss points: second order
    assert!(edge.0 < 1e-11, "{:.1e}", edge.0);
    assert!(
        inner.0 < 4e-3 && inner.1 > 1.9,
        "{:.1e}, {:.2}",
        inner.0,
        inner.1
    );
}

#[test]
fn thin_plate_does_not_lock() {
    // a thousand times thinner than in the test above, and as exact
    let shell = plate(5e-5, 8);
    let exact = PRESSURE / (64.0 * shell.bending());
    let got = -shell.pressed([None, CLAMPED]).at_node(0, 0)[0];
    println!("plate, clamped, t/a = 5e-5: {:.1e}", got / exact - 1.0);
    assert!((got / exact - 1.0).abs() < 2e-4);
}

#[test]
fn cylinder_with_clamped_edge_under_pressure() {
    let t = 0.01;
    // D β'''' − (k D / S) β'' + k β = 0, k = E t / R²: β = C e^{−ax} sin bx, M₀ = p / (3a² − b²)
    let (d, s) = (cylinder(1.0, t, 1).bending(), cylinder(1.0, t, 1).shear());
    let k = E * t;
    // m² = k/2S ± i √(k/D − (k/2S)²), m = −a ± ib
    let (re, im) = (k / (2.0 * s), (k / d - (k / (2.0 * s)).powi(2)).sqrt());
    let modulus = re.hypot(im);
    let (a, b) = (((modulus + re) / 2.0).sqrt(), ((modulus - re) / 2.0).sqrt());
    let moment = PRESSURE / (3.0 * a * a - b * b);
    // where e^{−ax} is 1e-11 the other end has no effect
    let length = 25.0 / a;
    let shell = |elements| cylinder(length, t, elements);
    let meshes = [16, 32, 64, 128];
    let edge = row(
        "cylinder, clamped edge: moment at the edge",
        meshes,
        moment,
        |elements| {
            let samples = shell(elements).samples([CLAMPED, Some(Held::ByDiaphragm)]);
            samples[0].forces.bending_n[0].abs()
        },
    );
    // w = (p + D β''') / k at the node a sixteenth of the length from the edge
    let x = length / 16.0;
    let c = -PRESSURE / (d * b * (3.0 * a * a - b * b));
    let third = {
        // β''' = C e^{−ax} Im[(−a + ib)³ e^{ibx}]
        let (re3, im3) = (-a * a * a + 3.0 * a * b * b, 3.0 * a * a * b - b * b * b);
        c * (-a * x).exp() * (re3 * (b * x).sin() + im3 * (b * x).cos())
    };
    let radial = row(
        "cylinder, clamped edge: widening near the edge",
        meshes,
        (PRESSURE + d * third) / k,
        |elements| {
            let solution = shell(elements).pressed([CLAMPED, Some(Held::ByDiaphragm)]);
            solution.at_node(elements as usize / 16, 0)[1]
        },
    );
    let nearby = row(
        "cylinder, clamped edge: moment near the edge",
        meshes,
        // D β′
        (d * c * (-a * x).exp() * (b * (b * x).cos() - a * (b * x).sin())).abs(),
        |elements| {
            let samples = shell(elements).samples([CLAMPED, Some(Held::ByDiaphragm)]);
            samples[elements as usize / 16 * SAMPLES.len()]
                .forces
                .bending_n[0]
                .abs()
        },
    );
    fourth_order(radial, 1e-5);
    fourth_order(nearby, 1e-4);
    // D w′ w‴ − D w″²/2 + k w²/2 is constant, also in the model: two Gauss points integrate quadratic terms exactly.
    // The remainder is the effect of the other end, e⁻²⁵
    assert!(edge.0 < 1e-9, "{:.1e}", edge.0);
}

#[test]
fn sphere_under_pressure_widens_evenly() {
    let t = 0.02;
    // w = p R² (1 − ν) / 2 E t
    let exact = PRESSURE * (1.0 - NU) / (2.0 * E * t);
    let at_equator = row(
        "sphere: widening at the equator",
        [4, 8, 16, 32],
        exact,
        |elements| {
            let shell = cap(FRAC_PI_2, t, elements);
            let solution = shell.pressed([None, Some(Held::BySymmetry)]);
            solution.at_node(elements as usize - 1, 2)[1]
        },
    );
    fourth_order(at_equator, 1e-5);
}

#[test]
fn clamped_hemisphere_tends_to_the_edge_solution() {
    // M₀ = 2 b² D δ, δ = p R² (1 − ν) / 2 E t, b⁴ = 3 (1 − ν²) / R² t²: the limit of thin walls, next term √(t/R)
    let errors = [1e-2, 1e-3, 1e-4].map(|t: f64| {
        let shell = cap(FRAC_PI_2, t, 400);
        let moment = shell
            .samples([None, CLAMPED])
            .last()
            .unwrap()
            .forces
            .bending_n[0];
        let b2 = (3.0 * (1.0 - NU * NU)).sqrt() / t;
        let widening = PRESSURE * (1.0 - NU) / (2.0 * E * t);
        let exact = 2.0 * b2 * shell.bending() * widening;
        (moment.abs() / exact - 1.0).abs()
    });
    let [thick, thin, thinnest] = errors;
    println!(
        "hemisphere, clamped: moment at the edge, R/t 100, 1000, 10000: {thick:.1e} {thin:.1e} {thinnest:.1e}"
    );
    for (error, t) in errors.into_iter().zip([1e-2_f64, 1e-3, 1e-4]) {
        assert!(error < t.sqrt(), "{error:.1e} at {t}");
    }
    assert!(errors[2] < errors[1] && errors[1] < errors[0]);
}

#[test]
fn cone_carries_pressure_as_a_membrane() {
    // N_θ = p r / cos θ, N_s = half of it, far from the edge; bending is of order t/R there
    let half_angle = FRAC_PI_4;
    let t = 1e-3;
    let segment = Segment::Line {
        start: point(0.0, 0.0),
        end: point(1.0 / half_angle.tan(), 1.0),
    };
    let shell = Shell::new(segment, t, 200);
    let samples = shell.samples([None, CLAMPED]);
    let mut worst = 0.0_f64;
    for sample in samples.iter().filter(|s| (0.2..0.6).contains(&s.point.r_m)) {
        let hoop = PRESSURE * sample.point.r_m / half_angle.cos();
        let [n_s, n_t, _] = sample.forces.membrane_n_m;
        worst = worst
            .max((n_t / hoop - 1.0).abs())
            .max((2.0 * n_s / hoop - 1.0).abs());
    }
    println!("cone of 45 deg, t/R = 1e-3: membrane forces within {worst:.1e}");
    assert!(worst < 1e-3);
}

#[test]
fn cylinder_under_its_weight_across_the_axis_bends_like_a_beam() {
    // moment equilibrium, in any theory: N_s + M_s / R = μ g (L − x)² / R at θ = 0, for R = 1
    let (length, elements) = (4.0, 32);
    let shell = cylinder(length, 0.01, elements);
    let freedoms = shell.freedoms(1, [CLAMPED, None]);
    let stiffness = shell.model.stiffness().over(&freedoms).factor().unwrap();
    let weight = shell.model.walls[0].areal.mass_kg_m2 * 9.806_65;
    let loads = load(&shell.model, &freedoms, |_, _| [0.0, weight, -weight]);
    let samples = solve(&freedoms, &stiffness, loads).samples(&shell.model);
    let mut worst = 0.0_f64;
    for sample in samples.iter().step_by(SAMPLES.len()) {
        let [n_s, ..] = sample.forces.membrane_n_m;
        let [m_s, ..] = sample.forces.bending_n;
        let arm = length - sample.point.x_m;
        worst = worst.max(((n_s + m_s).abs() / (weight * arm * arm) - 1.0).abs());
    }
    println!("cylinder, lateral weight: balance of moments within {worst:.1e}");
    // the ends of elements are in equilibrium; rotations at the joints follow their geometry, here straight
    assert!(worst < 1e-9);
}

#[test]
fn samples_stand_at_ends_and_gauss_points() {
    let shell = plate(0.01, 3);
    assert_eq!(shell.samples([None, CLAMPED]).len(), 3 * SAMPLES.len());
}
