//! The diameter found is the smallest that closes, wherever the search starts; no result jumps where a loop once did not converge.

use super::trade_space::{Sequence, sampled};
use super::*;
use crate::vehicle::close::Search;

/// Diameters from which each vehicle is grown, as parts of the way from 0.5 m to the one found.
const ASKED: [f64; 5] = [0.0, 0.2, 0.45, 0.7, 0.95];
/// Diameters tried below the one found.
const BELOW: u32 = 200;

/// A vehicle of a payload with a size of its own, asked for at 0.5 m.
fn small(sequence: &mut Sequence) -> VehicleInput {
    let mut input = sampled(sequence);
    input.payload_size = PayloadSize::DensityKgM3(sequence.between(500.0, 8000.0));
    input.loads.entry_load_earth_g = sequence.between(20.0, 200.0);
    input.loads.peak_stagnation_pressure_pa = sequence.between(1e4, 2e5);
    input.diameter_m = 0.5;
    input
}

#[test]
fn the_smallest_diameter_is_found_from_wherever_it_is_looked_for_and_none_below_it_closes() {
    let mut sequence = Sequence(31);
    let mut grown = 0;
    let mut faults = Vec::new();
    while grown < 100 {
        let input = small(&mut sequence);
        let Ok(vehicle) = build(&input) else { continue };
        let found_m = vehicle.dimensions.diameter_m;
        if found_m < 0.51 {
            continue;
        }
        grown += 1;
        for part in ASKED {
            let mut asked = input.clone();
            asked.diameter_m = 0.5 + part * (found_m - 0.5);
            let other_m = build(&asked).unwrap().dimensions.diameter_m;
            if (other_m - found_m).abs() > 1e-6 {
                faults.push(format!(
                    "{:?}: {found_m} from 0.5 m, {other_m} from {}",
                    input.concept, asked.diameter_m
                ));
            }
        }
        let rule = FoamRule::new(&input);
        for k in 0..BELOW {
            let part = f64::from(k) / f64::from(BELOW - 1);
            let diameter_m = 0.5 + part * (found_m - 1e-4 - 0.5);
            let tried = Search::new(&input, &rule).attempt(diameter_m);
            if tried.is_ok_and(|tried| tried.misfit().is_none()) {
                faults.push(format!(
                    "{:?}: {diameter_m} closes below {found_m}",
                    input.concept
                ));
                break;
            }
        }
    }
    assert!(faults.is_empty(), "{}: {faults:#?}", faults.len());
}

#[test]
fn what_stands_about_the_center_of_gravity_stands_about_it() {
    let mut sequence = Sequence(32);
    let mut closed = 0;
    for _ in 0..400 {
        let mut input = sampled(&mut sequence);
        input.concept = Concept::NonMsr;
        let Ok(vehicle) = build(&input) else { continue };
        closed += 1;
        let layout = &vehicle.layout;
        let off = layout.outline.lid_center_x_m - vehicle.mass.cg_x_m;
        assert!(off.abs() < 1e-7, "{off}");
        // the payload in its place: on the foam that its stroke requires, on the forebody's layers
        let foam = FoamRule::new(&input).least_thickness_m;
        assert_eq!(layout.foam_thickness_m, foam);
        let rest = layout
            .outline
            .forebody
            .resting_ball_x_m(layout.depths.fore_m(), layout.payload_radius_m + foam);
        assert_eq!(layout.payload_x_m, rest);
        // under a lid 50 mm above it or, with a remark, higher
        let top = layout.outline.lid_top_x_m() - layout.depths.aft_m();
        let gap = top - layout.payload_x_m - layout.payload_radius_m;
        assert!((gap - layout.lid_insulation_thickness_m).abs() < 1e-12 && gap > 0.05 - 1e-9);
        let raised = adjusted(&vehicle, "lid_gap_m");
        assert_eq!(gap > 0.05 + 1e-9, raised.is_some(), "{gap}");
    }
    assert!(closed > 300, "{closed}");
}

/// Mass, diameter and shoulder radius at each of `values`.
fn sweep(values: &[f64], set: impl Fn(&mut VehicleInput, f64)) -> Vec<[f64; 3]> {
    let one = |&value| {
        let mut input = galahad();
        input.payload_mass_kg = 3.0;
        input.payload_size = PayloadSize::DensityKgM3(1500.0);
        input.forebody.tps_thickness_m = 0.0425;
        set(&mut input, value);
        let vehicle = build(&input).unwrap();
        let d = vehicle.dimensions;
        [vehicle.mass.mass_kg, d.diameter_m, d.shoulder_radius_m]
    };
    values.iter().map(one).collect()
}

#[test]
fn nothing_jumps_where_the_loop_did_not_settle() {
    let fine = |from: f64, to: f64| -> Vec<f64> {
        (0..=40)
            .map(|k| from + (to - from) * f64::from(k) / 40.0)
            .collect()
    };
    let sweeps = [
        sweep(&fine(1.20, 1.34), |i, v| i.diameter_m = v),
        sweep(&fine(0.13, 0.15), |i, v| i.shoulder_radius_ratio = v),
        sweep(&fine(4050.0, 4300.0), |i, v| {
            i.impact.crush_load_limit_earth_g = v
        }),
        sweep(&fine(5500.0, 5900.0), |i, v| {
            i.payload_size = PayloadSize::DensityKgM3(v)
        }),
        sweep(&fine(51.0, 54.0), |i, v| {
            i.cone_half_angle_rad = v * RADIANS_PER_DEGREE
        }),
    ];
    for (k, rows) in sweeps.iter().enumerate() {
        for pair in rows.windows(2) {
            for (a, b) in pair[0].iter().zip(pair[1]) {
                assert!((b / a - 1.0).abs() < 0.012, "sweep {k}: {a} to {b}");
            }
        }
        if k > 0 {
            assert!(rows.iter().all(|row| row[1] == 1.1), "sweep {k} grows");
        }
    }
}
