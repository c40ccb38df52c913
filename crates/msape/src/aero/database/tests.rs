//! A database against its table, its symmetry and the integrals it interpolates.
//!
//! ```text
//! |C(α between nodes) − ∫| small
//! ```
//!
//! # Valid
//! The report's 60 deg shape with a flat back.
//!
//! # References
//! - \[samareh-2014\] section 3.3.

use super::*;
use crate::aero::AxialForce;
use crate::aero::damping::{DampingData, Reading};
use crate::vehicle::forebody::Forebody;

/// The report's 60-deg shape with a flat back.
fn outline() -> Profile {
    let theta = PI / 3.0;
    let body = Forebody {
        diameter_m: 1.0,
        nose_radius_m: 0.25,
        shoulder_radius_m: 0.035,
        cone_half_angle_rad: theta,
    };
    let center = body.shoulder_center();
    let arc = crate::vehicle::segment::Segment::arc(
        center,
        body.shoulder_radius_m,
        0.5 * PI + theta,
        -(0.5 * PI + theta),
    );
    let end = arc.end();
    body.nose(0.0)
        .then(&Profile {
            segments: vec![arc],
        })
        .line_to(crate::vehicle::segment::Point::on_axis(end.x_m))
        .closed()
}

fn options() -> Options {
    let force =
        AxialForce::parse(include_str!("../../../data/aerodynamics/mmeev-60.csv").into()).unwrap();
    let data =
        DampingData::parse(include_str!("../../../data/aero-models/damping.toml").into()).unwrap();
    Options {
        axial_force: force.table,
        bridging: Bridging::SineSquared,
        wall_temperature_ratio: 1.0,
        accommodation: [1.0, 1.0],
        damping: Damping::Report {
            data,
            reading: Reading::Corrected,
        },
        heat_capacity_ratio: GAMMA,
    }
}

fn database() -> Database {
    Database::of_outline(&outline(), 1.0, options())
}

#[test]
fn nose_first_in_a_continuum_it_is_the_table_of_axial_force() {
    let (database, table) = (database(), options().axial_force);
    for n in 0..=500 {
        let mach = 0.1 * f64::from(n);
        let got = database.coefficients(mach, 1e-3, 0.0);
        assert!(
            (got.ca - table.at(mach)).abs() < 1e-14,
            "{mach}: {}",
            got.ca
        );
        assert_eq!((got.cn, got.cm), (0.0, 0.0));
    }
}

#[test]
fn axial_force_and_damping_are_even_and_normal_force_and_moment_odd() {
    let database = database();
    for (mach, knudsen) in [(0.3, 0.0), (1.2, 0.0), (20.0, 0.01), (30.0, 50.0)] {
        for alpha in [0.1, 1.0, 2.0, 3.0] {
            let a = database.coefficients(mach, knudsen, alpha);
            let b = database.coefficients(mach, knudsen, -alpha);
            assert_eq!((a.ca, a.cmq, a.cn, a.cm), (b.ca, b.cmq, -b.cn, -b.cm));
            let around = database.coefficients(mach, knudsen, alpha - 2.0 * PI);
            assert!((around.cn - a.cn).abs() < 1e-12);
        }
    }
}

#[test]
fn between_the_nodes_it_agrees_with_the_integral() {
    let (database, surface) = (database(), Surface::new(&outline(), 1.0));
    let mut worst: [f64; 2] = [0.0; 2];
    for n in 0..72 {
        let alpha = (f64::from(n) + 0.4) * 2.5 * RADIANS_PER_DEGREE;
        let speed_ratio = 15.0 + 0.5 * f64::from(n);
        let mach = speed_ratio / (0.5 * GAMMA).sqrt();
        let [newton, free] = loads(
            &surface,
            &[
                Law::Newtonian(1.0),
                Law::FreeMolecular(Gas::diffuse(speed_ratio)),
            ],
            alpha,
            Effort::FINE,
        );
        let k = pressure_coefficient_max(mach, GAMMA);
        let got = database.coefficients(mach, 0.0, alpha);
        worst[0] = worst[0]
            .max((got.cn - k * newton.cn).abs())
            .max((got.cm - k * newton.cm).abs());
        let got = database.coefficients(mach, 20.0, alpha);
        for (g, w) in [(got.ca, free.ca), (got.cn, free.cn), (got.cm, free.cm)] {
            worst[1] = worst[1].max((g - w).abs());
        }
    }
    // Impact theory has no corners here. Thermal motion is as wide as 1/S, 2 deg at S = 25: within that of an angle at which
    // a flat side turns to the lee, interpolation in α and in 1/S loses a few thousandths of coefficients of order one.
    assert!(worst[0] < 5e-5 && worst[1] < 5e-3, "{worst:?}");
}
