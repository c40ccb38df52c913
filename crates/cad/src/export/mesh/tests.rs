//! Closed bodies and their volumes.

use super::*;
use msape::vehicle::segment::{Point, Segment};
use std::collections::BTreeMap;

fn ball(center_x_m: f64, radius_m: f64) -> Profile {
    let center = Point::on_axis(center_x_m);
    Profile {
        segments: vec![Segment::arc(center, radius_m, PI, -PI)],
    }
    .closed()
}

fn hollow_ball() -> Profile {
    let inner = Segment::arc(Point::on_axis(0.0), 0.5, 0.0, PI);
    let inner = Profile {
        segments: vec![inner],
    };
    let outer = Segment::arc(Point::on_axis(0.0), 1.0, PI, -PI);
    Profile {
        segments: vec![outer],
    }
    .then(&inner)
    .closed()
}

fn ring() -> Profile {
    let center = Point { x_m: 1.0, r_m: 2.0 };
    Profile {
        segments: vec![Segment::arc(center, 0.5, 0.3, 2.0 * PI)],
    }
}

/// A cone on a cylinder.
fn pencil() -> Profile {
    let tip = Segment::Line {
        start: Point::on_axis(0.0),
        end: Point { x_m: 2.0, r_m: 1.0 },
    };
    Profile {
        segments: vec![tip],
    }
    .line_to(Point { x_m: 4.0, r_m: 1.0 })
    .line_to(Point::on_axis(4.0))
    .closed()
}

/// Each edge of the welded mesh: forward minus backward uses, and total uses.
fn edges(mesh: &Mesh) -> Vec<(i32, i32)> {
    let mut edges: BTreeMap<_, (i32, i32)> = BTreeMap::new();
    let bits = |i: u32| mesh.positions_m[i as usize].map(f32::to_bits);
    for t in &mesh.triangles {
        for (a, b) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
            let (a, b) = (bits(a), bits(b));
            let (key, way) = if a < b { ((a, b), 1) } else { ((b, a), -1) };
            let entry = edges.entry(key).or_default();
            entry.0 += way;
            entry.1 += 1;
        }
    }
    edges.into_values().collect()
}

fn watertight(mesh: &Mesh) {
    assert!(!mesh.triangles.is_empty());
    for (sum, count) in edges(mesh) {
        assert_eq!((sum, count), (0, 2));
    }
}

fn options(sweep_rad: f64) -> MeshOptions {
    MeshOptions {
        start_rad: 0.3,
        sweep_rad,
        ..MeshOptions::whole(1e-3)
    }
}

#[test]
fn bodies_are_watertight_whole_and_cut() {
    for body in [ball(0.0, 1.0), hollow_ball(), ring(), pencil()] {
        let exact = body.solid().volume_m3;
        for sweep in [2.0 * PI, 4.5, PI, 0.1] {
            let mesh = mesh(std::slice::from_ref(&body), &options(sweep));
            watertight(&mesh);
            // the chord error of 1e-3 on both circles of a ring of 0.5 is 0.8 % of its volume
            let want = exact * sweep / (2.0 * PI);
            let got = mesh.volume_m3();
            assert!((got / want - 1.0).abs() < 0.01, "{got} against {want}");
        }
    }
}

#[test]
fn normals_point_out_of_each_triangle() {
    for body in [ball(0.0, 1.0), hollow_ball(), ring(), pencil()] {
        let mesh = mesh(&[body], &options(4.0));
        for (t, [a, b, c]) in mesh.triangles.iter().zip(mesh.corners_m()) {
            let flat = (b - a).cross(&(c - a));
            for &i in t {
                let n = Vector3::from(mesh.normals[i as usize]).map(f64::from);
                assert!((n.norm_squared() - 1.0).abs() < 1e-6);
                assert!(n.dot(&flat) >= 0.0);
            }
        }
    }
}

#[test]
fn the_volume_converges_with_the_square_of_the_step() {
    let exact = 4.0 / 3.0 * PI;
    let short = |chords: f64| {
        // the chord error of a circle of radius 1 cut into so many chords
        let error = 1.0 - numerics::math::cos(PI / chords);
        let mesh = mesh(&[ball(0.0, 1.0)], &MeshOptions::whole(error));
        exact - mesh.volume_m3()
    };
    let (coarse, fine) = (short(64.0), short(128.0));
    // four times less at half the step; the next term is of relative size (π/64)² = 0.0024
    assert!((coarse / fine - 4.0).abs() < 0.01, "{coarse} {fine}");
    assert!(fine > 0.0);
}

#[test]
fn an_open_profile_is_a_surface_with_its_area() {
    let side = Segment::Line {
        start: Point::on_axis(0.0),
        end: Point { x_m: 3.0, r_m: 4.0 },
    };
    let cone = Profile {
        segments: vec![side],
    };
    let mesh = mesh(&[cone], &MeshOptions::whole(1e-5));
    // π r s = 20 π
    assert!((mesh.area_m2() / (20.0 * PI) - 1.0).abs() < 1e-5);
    assert!(edges(&mesh).iter().any(|&(_, count)| count == 1));
}

#[test]
fn lines_are_cut_into_pieces_where_asked() {
    let fine = MeshOptions {
        longest_piece_m: 0.5,
        ..MeshOptions::whole(1e-2)
    };
    let coarse = mesh(&[pencil()], &MeshOptions::whole(1e-2));
    let fine = mesh(&[pencil()], &fine);
    watertight(&fine);
    assert!(fine.triangles.len() > 2 * coarse.triangles.len());
    assert!((fine.volume_m3() / coarse.volume_m3() - 1.0).abs() < 1e-6);
}

/// The vehicle of a shipped case.
fn vehicle(case: &str) -> Vehicle {
    let text = msape::library::data_file(case).unwrap();
    let case = msape::Case::from_text(text).unwrap();
    let library = msape::Library::builtin().unwrap();
    let answer = msape::design(&case, &library, msape::Request::Nothing).unwrap();
    answer.design.unwrap().vehicle
}

#[test]
fn every_component_of_both_concepts_is_watertight_whole_and_cut() {
    for case in ["cases/msr-eev-pica.toml", "cases/galahad.toml"] {
        let vehicle = vehicle(case);
        for sweep in [2.0 * PI, 4.7] {
            let list = components(&vehicle, &options(sweep));
            assert!(list.len() > 8);
            for ComponentMesh { kind, mesh } in list {
                let exact = vehicle.component(kind).unwrap();
                // one profile at a time: both pieces of the body foam end in the circle in which the impact sphere
                // touches
                for profile in &exact.profiles {
                    watertight(&super::mesh(std::slice::from_ref(profile), &options(sweep)));
                }
                let area: f64 = exact.profiles.iter().map(Profile::wetted_area_m2).sum();
                // walls deviate from their triangles by at most twice the chord error: along the profile and around the
                // axis
                let error = mesh.volume_m3() - exact.volume_m3 * sweep / (2.0 * PI);
                assert!(error.abs() < 2e-3 * area, "{case} {kind:?} {error}");
            }
        }
        let outside = mesh(
            std::slice::from_ref(&vehicle.outline),
            &MeshOptions::whole(5e-4),
        );
        watertight(&outside);
        let share = outside.volume_m3() / vehicle.mass.volume_m3;
        assert!((share - 1.0).abs() < 0.004, "{share}");
    }
}
