//! Derivatives of a vehicle by each of its continuous inputs against central differences, on the shipped designs and 50 others.

use super::trade_space::{Sequence, sampled};
use super::*;
use crate::problem::DesignProblem;
use crate::vehicle::derivatives::{Branches, DiameterBy, figures};
use crate::vehicle::impact::absorber::{Absorber, Shape};
use crate::vehicle::impact::landing::rigid_surface_load_earth_g;
use crate::vehicle::impact::supply::Supply;
use crate::{Case, Library};
use numerics::scalar::{Dual, Scalar, Single};

/// Largest difference over the derivative.
const RELATIVE: f64 = 1e-6;
/// Difference that the search leaves, over the number itself.
const NOISE: f64 = 2e-7;
/// Step over the input.
const STEP: f64 = 3e-4;
/// Difference of both sides over the larger one at a bend that no branch names.
const BEND: f64 = 0.01;
/// Difference of the crush load over itself where the payload stops at the end of the plateau: there the law bends.
const AT_PLATEAU: f64 = 2e-3;

/// Stride over the inputs compared for a random vehicle, with another offset for each vehicle: all inputs together take a minute.
const EVERY: usize = 4;

const NAMES: [&str; 20] = [
    "mass",
    "mass without margin",
    "cg",
    "ixx",
    "iyy",
    "crushed cg",
    "crushed iyy",
    "diameter",
    "shoulder radius",
    "lid radius",
    "forebody carrier",
    "aftbody carrier",
    "primary",
    "core density",
    "foam",
    "stroke",
    "strength",
    "foam density",
    "penetration load",
    "crush load",
];

fn numbers<S: Single>(input: &VehicleInput<S>, f: &Figures<S>) -> [S; NAMES.len()] {
    let (m, c, d, i, w) = (&f.mass, &f.crushed, &f.dimensions, &f.impact, &f.structure);
    let absorber = Absorber {
        shape: Shape::of(input),
        thickness_m: d.foam_thickness_m,
        law: Supply::new(input).law(i.foam_strength_pa),
    };
    let speed_m_s = input.loads.terminal_speed_m_s;
    let load = rigid_surface_load_earth_g(&absorber, input.payload_mass_kg, speed_m_s);
    let penetration = i
        .ground_penetration
        .map_or(S::constant(0.0), |g| g.load_earth_g);
    [
        m.mass_kg,
        m.mass_without_margin_kg,
        d.cg_from_nose_m,
        m.ixx_kg_m2,
        m.iyy_kg_m2,
        c.cg_x_m,
        c.iyy_kg_m2,
        d.diameter_m,
        d.shoulder_radius_m,
        d.lid_radius_m,
        w.forebody.thickness_m,
        w.aftbody.thickness_m,
        w.primary.thickness_m,
        w.forebody.density_kg_m3,
        d.foam_thickness_m,
        i.required_stroke_m,
        i.foam_strength_pa,
        i.foam_density_kg_m3,
        penetration,
        load,
    ]
}

/// The inputs with number `index` changed.
fn changed(input: &VehicleInput, index: usize, by: f64) -> VehicleInput {
    let mut k = 0;
    input.lift(|x: f64| {
        k += 1;
        if k - 1 == index { x + by } else { x }
    })
}

fn at(input: &VehicleInput, index: usize, by: f64) -> Option<([f64; NAMES.len()], Branches)> {
    let input = changed(input, index, by);
    let (found, branches) = figures(&input).ok()?;
    Some((numbers(&input, &found), branches))
}

/// Compared, left out since a branch changes within the step or since the number bends at the place, without a
/// derivative, and what differs.
#[derive(Default)]
struct Tally {
    compared: usize,
    kinks: usize,
    bends: usize,
    without: usize,
    wrong: Vec<String>,
}

/// Compares the derivatives by every input, or by every `every`-th from `first` on.
fn compare(name: &str, input: &VehicleInput, [first, every]: [usize; 2], tally: &mut Tally) {
    let mut input = input.clone();
    // what the search leaves is far below the step
    input.rules.diameter_resolution_m = 1e-13;
    input.rules.convergence_m = 1e-10;
    let mut inputs = Vec::new();
    input.lift(|x: f64| {
        inputs.push(x);
        x
    });
    let Ok((here, branches)) = figures(&input) else {
        return;
    };
    let built = build(&input).unwrap();
    assert_eq!(here.mass, built.mass, "{name}");
    assert_eq!(here.crushed, built.crushed, "{name}");
    assert_eq!(here.dimensions, built.dimensions, "{name}");
    assert_eq!(here.impact, built.impact, "{name}");
    assert_eq!(here.structure, built.structure, "{name}");
    let here = numbers(&input, &here);
    for (index, x) in inputs.into_iter().enumerate().skip(first).step_by(every) {
        let mut k = 0;
        let dual = input.lift(|x: f64| {
            k += 1;
            if k - 1 == index {
                Dual::<1>::variable(x, 0)
            } else {
                Dual::constant(x)
            }
        });
        let (found, _) = figures(&dual).unwrap();
        let dual = numbers(&dual, &found);
        let h = STEP * if x == 0.0 { 1e-2 } else { x.abs() };
        let steps = [-h, -0.5 * h, 0.5 * h, h].map(|by| at(&input, index, by));
        let same = steps
            .iter()
            .all(|s| s.as_ref().is_some_and(|s| s.1 == branches));
        if !same || branches.diameter == DiameterBy::Jump {
            tally.kinks += 1;
            continue;
        }
        let [a, b, c, d] = steps.map(|s| s.unwrap().0);
        for (i, name_of) in NAMES.iter().enumerate() {
            assert_eq!(
                dual[i].value.to_bits(),
                here[i].to_bits(),
                "{name} {name_of}"
            );
            let (wide, near) = ((d[i] - a[i]) / (2.0 * h), (c[i] - b[i]) / h);
            let difference = (4.0 * near - wide) / 3.0;
            let slope = dual[i].slope[0];
            let scale = if x == 0.0 { 1e-2 } else { x.abs() };
            let allowed = RELATIVE * slope.abs() * scale + NOISE * here[i].abs();
            let sides = [(here[i] - b[i]) / (0.5 * h), (c[i] - here[i]) / (0.5 * h)];
            let bend = (sides[1] - sides[0]).abs();
            let bent = bend > BEND * sides[0].abs().max(sides[1].abs()) && bend * scale > allowed;
            if slope.is_nan() || bent {
                tally.bends += usize::from(bent);
                tally.without += usize::from(!bent);
                continue;
            }
            let allowed = match *name_of {
                "crush load" => AT_PLATEAU * here[i].abs(),
                _ => allowed,
            };
            tally.compared += 1;
            if (slope - difference).abs() * scale > allowed {
                tally.wrong.push(format!(
                    "{name}: {name_of} by input {index} ({x}): {slope} against {difference}, sides {sides:?}, {branches:?}"
                ));
            }
        }
    }
}

#[test]
fn derivatives_of_shipped_designs_and_fifty_others_are_those_of_central_differences() {
    let mut tally = Tally::default();
    let library = Library::builtin().unwrap();
    for path in [
        "cases/msr-eev-pica.toml",
        "cases/msr-eev-cp.toml",
        "cases/galahad.toml",
        "cases/run-page.toml",
    ] {
        let case = Case::from_text(crate::library::data_file(path).unwrap()).unwrap();
        let problem = DesignProblem::check(&case, &library).unwrap();
        compare(path, &problem.input.vehicle, [0, 1], &mut tally);
    }
    let mut sequence = Sequence(7);
    for k in 0..50 {
        let name = format!("random {k}");
        compare(
            &name,
            &sampled(&mut sequence),
            [k % EVERY, EVERY],
            &mut tally,
        );
    }
    let first: Vec<_> = tally.wrong.iter().take(60).collect();
    let Tally {
        compared,
        kinks,
        bends,
        without,
        ..
    } = tally;
    assert!(
        first.is_empty(),
        "{compared} compared, {kinks}, {bends} and {without} left out, {} differ: {first:#?}",
        tally.wrong.len()
    );
    assert!(compared > 15_000, "{compared}");
    // one vehicle stands where a choice is a tie: not a number
    assert!(
        kinks < 20 && bends < 100 && without < 20,
        "{kinks} {bends} {without}"
    );
}
