//! Shell model compared with closed forms, over four meshes, each twice as fine as the one before.
//!
//! Where the closed form includes the shear deformation of the model, the difference is the discretization error, and
//! its order is asserted; where it is the thin-shell limit, the tolerance is the effect of the thickness.

mod statics;
mod vibration;

use msape::shell::element::ArealMass;
use msape::shell::mesh::{Meridian, Mesh};
use msape::shell::model::{Freedoms, Held, Model, Wall};
use msape::shell::modes::first_frequency;
use msape::shell::section::{Build, Section};
use msape::shell::statics::{SAMPLES, Sample, Solution, load, solve};
use msape::vehicle::segment::{Point, Segment};
use std::f64::consts::PI;

const E: f64 = 70e9;
const NU: f64 = 0.3;
const DENSITY: f64 = 2700.0;
const PRESSURE: f64 = 1e5;

fn point(x_m: f64, r_m: f64) -> Point {
    Point { x_m, r_m }
}

/// Shell of one segment and one solid wall.
struct Shell {
    model: Model,
    ends: [usize; 2],
    thickness: f64,
}

impl Shell {
    fn new(segment: Segment, thickness: f64, elements: u32) -> Shell {
        let length = msape::shell::mesh::length_m(&segment);
        let mut mesh = Mesh::default();
        let ends = mesh
            .add(&Meridian {
                segments: &[segment],
                wall: 0,
                target_m: length / (f64::from(elements) - 1e-6),
                first: None,
                last: None,
            })
            .unwrap();
        assert_eq!(mesh.elements.len(), elements as usize);
        let wall = Wall {
            section: Section {
                build: Build::Solid {
                    thickness_m: thickness,
                },
                elastic_modulus_pa: E,
                poisson_ratio: NU,
            },
            areal: ArealMass {
                mass_kg_m2: DENSITY * thickness,
                rotary_kg: DENSITY * thickness.powi(3) / 12.0,
            },
        };
        let model = Model {
            mesh,
            walls: vec![wall],
        };
        Shell {
            model,
            ends,
            thickness,
        }
    }

    fn freedoms(&self, harmonic: u32, held: [Option<Held>; 2]) -> Freedoms {
        let supports: Vec<_> = self
            .ends
            .into_iter()
            .zip(held)
            .filter_map(|(node, held)| Some((node, held?)))
            .collect();
        Freedoms::new(&self.model, harmonic, &supports)
    }

    /// Solution for a pressure along the normal (−s, c).
    fn pressed(&self, held: [Option<Held>; 2]) -> Solution {
        let freedoms = self.freedoms(0, held);
        let stiffness = self.model.stiffness().over(&freedoms).factor().unwrap();
        let forces = load(&self.model, &freedoms, |_, at| {
            let [c, s] = at.direction;
            [-s * PRESSURE, c * PRESSURE, 0.0]
        });
        solve(&freedoms, &stiffness, forces)
    }

    fn samples(&self, held: [Option<Held>; 2]) -> Vec<Sample> {
        self.pressed(held).samples(&self.model)
    }

    fn frequency_hz(&self, harmonic: u32, held: [Option<Held>; 2]) -> f64 {
        let freedoms = self.freedoms(harmonic, held);
        let stiffness = self.model.stiffness().over(&freedoms).factor().unwrap();
        first_frequency(&self.model, &freedoms, &stiffness)
            .unwrap()
            .frequency_hz
    }

    fn bending(&self) -> f64 {
        self.model.walls[0].section.stiffness().bending_nm
    }

    fn shear(&self) -> f64 {
        self.model.walls[0].section.stiffness().shear_n_m
    }
}

const CLAMPED: Option<Held> = Some(Held::Clamped);

/// Plate with a radius of 1 m.
fn plate(thickness: f64, elements: u32) -> Shell {
    let segment = Segment::Line {
        start: point(0.0, 0.0),
        end: point(0.0, 1.0),
    };
    Shell::new(segment, thickness, elements)
}

/// Cylinder with a radius of 1 m.
fn cylinder(length: f64, thickness: f64, elements: u32) -> Shell {
    let segment = Segment::Line {
        start: point(0.0, 1.0),
        end: point(length, 1.0),
    };
    Shell::new(segment, thickness, elements)
}

/// Spherical cap with a radius of 1 m, from its pole.
fn cap(half_angle: f64, thickness: f64, elements: u32) -> Shell {
    let segment = Segment::arc(point(0.0, 0.0), 1.0, PI, -half_angle);
    Shell::new(segment, thickness, elements)
}

/// A line of the table.
fn row(name: &str, meshes: [u32; 4], exact: f64, computed: impl Fn(u32) -> f64) -> (f64, f64) {
    let errors = meshes.map(|elements| (computed(elements) / exact - 1.0).abs());
    let orders = [0, 1, 2].map(|i| (errors[i] / errors[i + 1]).log2());
    let cells: Vec<String> = errors.iter().map(|e| format!("{e:8.1e}")).collect();
    let order_cells: Vec<String> = orders.iter().map(|o| format!("{o:5.2}")).collect();
    println!(
        "{name:52} {:?} {}  order {}",
        meshes,
        cells.join(" "),
        order_cells.join(" ")
    );
    (errors[3], orders[2])
}

/// Quadratic elements in one dimension: nodal displacements and eigenvalues converge with at least the fourth power of
/// the element size. 3.7 allows for a finest mesh that is not yet, or no longer, in the asymptotic range.
#[track_caller]
fn fourth_order((error, order): (f64, f64), allowed: f64) {
    assert!(error < allowed, "error {error:.1e}, allowed {allowed:.1e}");
    assert!(order > 3.7, "order {order:.2}");
}

const MESHES: [u32; 4] = [2, 4, 8, 16];
