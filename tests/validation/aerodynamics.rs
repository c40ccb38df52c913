//! Coefficients by integration over the surface, against exact and independently computed ones.

use msape::aero::free_molecular::Gas;
use msape::aero::integral::{Effort, Law, Loads, loads};
use msape::aero::surface::Surface;
use msape::vehicle::forebody::Forebody;
use msape::vehicle::profile::Profile;
use msape::vehicle::segment::{Point, Segment};
use numerics::math::{FRAC_PI_2, PI, RADIANS_PER_DEGREE, cos, sin, tan};

const PANELS: &str = include_str!("../data/aero_panel_reference.csv");

fn at(x_m: f64, r_m: f64) -> Point {
    Point { x_m, r_m }
}

/// Sphere-cone with a half torus as shoulder, of diameter 2, and its back: flat, or a cone of 15 deg with a lid.
fn sphere_cone(half_angle_deg: f64, nose: f64, shoulder: f64, lid_center: Option<f64>) -> Profile {
    let theta = half_angle_deg * RADIANS_PER_DEGREE;
    let body = Forebody {
        diameter_m: 2.0,
        nose_radius_m: nose,
        shoulder_radius_m: shoulder,
        cone_half_angle_rad: theta,
    };
    let center = body.shoulder_center();
    let arc = Segment::arc(center, shoulder, FRAC_PI_2 + theta, -(FRAC_PI_2 + theta));
    let rim = at(center.x_m + shoulder, center.r_m);
    let front = body
        .nose(0.0)
        .line_to(body.shoulder_tangent(0.0))
        .then(&Profile {
            segments: vec![arc],
        });
    let slope = tan(15.0 * RADIANS_PER_DEGREE);
    match lid_center {
        None => front.line_to(at(rim.x_m, 0.0)).closed(),
        Some(x_lid) => {
            // (x_rim + slope (r_rim − r) − x_lid)² + r² = 0.36
            let a = rim.x_m + slope * rim.r_m - x_lid;
            let (qa, qb, qc) = (1.0 + slope * slope, -2.0 * a * slope, a * a - 0.36);
            let root = qb * qb - 4.0 * qa * qc;
            if root < 0.0 {
                return front.line_to(at(x_lid + a, 0.0)).closed();
            }
            let r = (-qb + root.sqrt()) / (2.0 * qa);
            let foot = at(rim.x_m + slope * (rim.r_m - r), r);
            let start = numerics::math::atan2(foot.r_m, foot.x_m - x_lid);
            let lid = Segment::arc(at(x_lid, 0.0), 0.6, start, -start);
            front
                .line_to(foot)
                .then(&Profile {
                    segments: vec![lid],
                })
                .closed()
        }
    }
}

fn one(outline: &Profile, law: Law, alpha_deg: f64) -> Loads {
    let surface = Surface::new(outline, 2.0);
    loads(
        &surface,
        &[law],
        alpha_deg * RADIANS_PER_DEGREE,
        Effort::FINE,
    )[0]
}

#[test]
fn panels_of_an_independent_method_within_a_thousandth() {
    let mut worst = [0.0_f64; 3];
    let mut count = 0;
    let mut out = Vec::new();
    for line in PANELS
        .lines()
        .filter(|line| line.starts_with(|c: char| c.is_ascii_digit()))
    {
        let fields: Vec<&str> = line.split(',').collect();
        let number = |n: usize| fields[n].parse::<f64>().unwrap();
        let cg = number(9);
        let lid = (fields[3] == "mmeev").then_some(2.0 * cg);
        let outline = sphere_cone(number(0), number(1), number(2), lid);
        let law = match fields[4] {
            "newton2" => Law::Newtonian(2.0),
            _ => Law::FreeMolecular(Gas::diffuse(25.0)),
        };
        let got = one(&outline, law, number(5));
        let got3 = [got.ca, got.cn, got.cm, got.cm_about(cg, 0.0)];
        for (k, g) in got3.into_iter().enumerate() {
            let want = number(if k == 3 { 10 } else { 6 + k });
            worst[k.min(2)] = worst[k.min(2)].max((g - want).abs());
            if (g - want).abs() > 5e-4 {
                out.push(format!("{line}: {k} {g:.5} {want}"));
            }
        }
        count += 1;
    }
    for line in &out {
        println!("{line}");
    }
    println!("{count} rows, worst {worst:?}");
    assert!(count > 400 && worst.iter().all(|w| *w < 1e-3), "{worst:?}");
}

#[test]
fn closed_forms() {
    let mut worst: f64 = 0.0;
    for (theta, rn) in [
        (45.0, 0.5),
        (60.0, 0.5),
        (60.0, 0.9),
        (70.0, 0.5),
        (70.0, 0.9),
        (30.0, 0.1),
    ] {
        let outline = sphere_cone(theta, rn, 0.0, None);
        for alpha in [0.0, 5.0, 15.0, 30.0] {
            let (t, a) = (theta * RADIANS_PER_DEGREE, alpha * RADIANS_PER_DEGREE);
            let (s, c) = (sin(t), cos(t));
            let f = 1.0 - rn * rn * c * c;
            let k = 2.0;
            let ca = k
                * (rn
                    * rn
                    * ((1.0 - s * s * s * s) / 2.0 * cos(a) * cos(a)
                        + c * c * c * c / 4.0 * sin(a) * sin(a))
                    + f * (s * s * cos(a) * cos(a) + c * c / 2.0 * sin(a) * sin(a)));
            let cn = k / 4.0 * rn * rn * c * c * c * c * sin(2.0 * a)
                + k / 2.0 * f * c * c * sin(2.0 * a);
            let cm = -k
                * sin(2.0 * a)
                * ((1.0 - rn * rn * rn * c * c * c) / (6.0 * tan(t))
                    + rn * rn * rn * c * c * c * c / (8.0 * s));
            let got = one(&outline, Law::Newtonian(2.0), alpha);
            for (g, w) in [(got.ca, ca), (got.cn, cn), (got.cm, cm)] {
                worst = worst.max((g - w).abs());
            }
        }
    }
    println!("closed forms: worst {worst:e}");
    assert!(worst < 1e-7);
}

#[test]
fn spheres() {
    let arc = Segment::arc(Point::on_axis(0.0), 1.0, PI, -PI);
    let ball = Profile {
        segments: vec![arc],
    }
    .closed();
    for alpha in [0.0, 20.0, 90.0, 133.0, 180.0] {
        let got = one(&ball, Law::Newtonian(2.0), alpha);
        let a = alpha * RADIANS_PER_DEGREE;
        println!(
            "newton {alpha}: {:e} {:e} {:e}",
            got.cd(a) - 1.0,
            got.cl(a),
            got.cm
        );
        for s in [5.0, 10.0, 20.0] {
            for w in [0.5, 1.0] {
                let gas = Gas {
                    wall_temperature_ratio: w,
                    ..Gas::diffuse(s)
                };
                let got = one(&ball, Law::FreeMolecular(gas), alpha);
                let want = msape::aero::free_molecular::sphere_drag(s, w);
                println!(
                    "fm {alpha} {s}: {:e} {:e} {:e}",
                    got.cd(a) - want,
                    got.cl(a),
                    got.cm
                );
            }
        }
    }
}
