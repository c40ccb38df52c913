use super::body::{Along, BodyHeating};
use super::*;
use numerics::scalar::Dual;

fn table(rows: &[[f64; 4]], rule: Extrapolation) -> GivenHeating {
    let rows: Vec<Vec<f64>> = rows.iter().map(|row| row.to_vec()).collect();
    GivenHeating::try_new("heating.table", &rows, rule).unwrap()
}

fn flux(table: &GivenHeating, part: Part, v: f64, rho: f64) -> f64 {
    table.heat_flux_w_m2(part, &Flow::new(rho, v, 1.0))
}

/// q̇ᶜ = 1e-4 √ρ V³; q̇ʳ zero at 8 km/s, then 1e6 and 4e6 W/m² for 1e-4 kg/m³, as ρ beside it.
fn two_columns(rule: Extrapolation) -> GivenHeating {
    let mut rows = Vec::new();
    for (v, q_r) in [(12e3, 4e6), (8e3, 0.0), (10e3, 1e6)] {
        for rho in [1e-4, 1e-2, 1e-3] {
            rows.push([rho, q_r * (rho / 1e-4), v]);
        }
    }
    let power = |rho: f64, v: f64| 1e-4 * rho.sqrt() * v * v * v;
    let rows: Vec<[f64; 4]> = rows
        .into_iter()
        .map(|[rho, q_r, v]| [v, rho, power(rho, v), q_r])
        .collect();
    table(&rows, rule)
}

#[test]
fn a_power_law_is_met_between_the_rows_and_beyond_them() {
    let table = two_columns(Extrapolation::Extend);
    let places: [(f64, f64); 5] = [
        (9e3, 3e-4),
        (10e3, 1e-3),
        (11.9e3, 9e-3),
        (500.0, 1e-9),
        (15e3, 1.0),
    ];
    for (v, rho) in places {
        let power = 1e-4 * rho.sqrt() * v * v * v;
        let ours = flux(&table, Part::Convective, v, rho);
        assert!((ours / power - 1.0).abs() < 1e-11, "{v} {rho}: {ours}");
    }
}

#[test]
fn rows_with_nought_are_linear_and_the_two_forms_meet() {
    let table = two_columns(Extrapolation::Extend);
    // half-way from 8 to 10 km/s at 1e-4 kg/m³: half of 1e6; at 3e-4, a power law of ρ, half of 3e6
    assert!((flux(&table, Part::Radiative, 9e3, 1e-4) / 5e5 - 1.0).abs() < 1e-12);
    assert!((flux(&table, Part::Radiative, 9e3, 3e-4) / 1.5e6 - 1.0).abs() < 1e-12);
    // both rows above zero: geometric; √(1 · 4) at the geometric mean of the speeds
    let middle = (10e3_f64 * 12e3).sqrt();
    assert!((flux(&table, Part::Radiative, middle, 1e-4) / 2e6 - 1.0).abs() < 1e-12);
    let [below, above] = [10e3 - 1e-7, 10e3 + 1e-7].map(|v| flux(&table, Part::Radiative, v, 2e-4));
    assert!((below / above - 1.0).abs() < 1e-9, "{below} {above}");
    assert_eq!(flux(&table, Part::Radiative, 7e3, 1e-3), 0.0);
}

#[test]
fn held_ends_stay_and_what_grows_downwards_does_not_go_on() {
    let held = two_columns(Extrapolation::Hold);
    let at = |v, rho| flux(&held, Part::Convective, v, rho);
    assert_eq!(at(3e3, 1e-6), at(8e3, 1e-4));
    assert_eq!(at(13e3, 1.0), at(12e3, 1e-2));
    // more heat at less speed and density, as from a table cut out of its middle
    let odd = [
        [1e3, 1e-4, 4e4, 0.0],
        [1e3, 1e-3, 2e4, 0.0],
        [2e3, 1e-4, 2e4, 0.0],
        [2e3, 1e-3, 1e4, 0.0],
    ];
    let odd = table(&odd, Extrapolation::Extend);
    let corner = flux(&odd, Part::Convective, 100.0, 1e-8);
    assert!((corner / 4e4 - 1.0).abs() < 1e-12, "{corner}");
}

/// A step holds the rows in which it begins: beyond their end they go on as a power law, and no kink is within the step.
#[test]
fn rows_that_hold_go_on_where_others_begin() {
    for rule in [
        Extrapolation::Hold,
        Extrapolation::Extend,
        Extrapolation::Refuse,
    ] {
        let table = two_columns(rule);
        for (chosen_by_m_s, v) in [(9e3, 10.2e3), (11e3, 9.7e3)] {
            let flow = Flow {
                chosen_by_m_s,
                ..Flow::new(3e-4, v, 1.0)
            };
            let ours = table.heat_flux_w_m2(Part::Convective, &flow);
            let power = 1e-4 * 3e-4_f64.sqrt() * v * v * v;
            assert!((ours / power - 1.0).abs() < 1e-11, "{rule:?} {v}: {ours}");
        }
        // radiation from 0 at 8 km/s to 3e6 at 10 km/s: linear, 3.3e6 at 10.2 km/s
        let flow = Flow {
            chosen_by_m_s: 9e3,
            ..Flow::new(3e-4, 10.2e3, 1.0)
        };
        let ours = table.heat_flux_w_m2(Part::Radiative, &flow);
        assert!((ours / 3.3e6 - 1.0).abs() < 1e-12, "{rule:?}: {ours}");
    }
}

#[test]
fn derivatives_are_those_of_differences() {
    let table = two_columns(Extrapolation::Extend);
    for part in [Part::Convective, Part::Radiative] {
        for (v, rho) in [(8.5e3, 4e-4), (11e3, 4e-4), (13e3, 3e-2), (9e3, 1e-5)] {
            let [rho_dual, nose] = [rho, 1.0].map(Dual::constant);
            let dual: Dual<1> =
                table.heat_flux_w_m2(part, &Flow::new(rho_dual, Dual::variable(v, 0), nose));
            let h = 1e-3;
            let central =
                (flux(&table, part, v + h, rho) - flux(&table, part, v - h, rho)) / (2.0 * h);
            assert!(
                (dual.slope[0] / central - 1.0).abs() < 1e-6,
                "{part:?} {v} {rho}: {} {central}",
                dual.slope[0]
            );
        }
    }
}

#[test]
fn every_hole_and_every_double_row_is_a_fault() {
    let faults = |rows: &[[f64; 3]]| {
        let rows: Vec<Vec<f64>> = rows.iter().map(|row| row.to_vec()).collect();
        GivenHeating::try_new("heating.table", &rows, Extrapolation::Hold).unwrap_err()
    };
    assert_eq!(
        faults(&[[1e3, 1e-3, 1.0], [2e3, 1e-3, 1.0], [2e3, 1e-2, 1.0]]),
        ["no row for 1000 m/s and 0.01 kg/m^3: each of the 2 speeds needs each of the 2 densities"]
    );
    let twice = [
        [1e3, 1e-3, 1.0],
        [1e3, 1e-2, 1.0],
        [2e3, 1e-3, 1.0],
        [2e3, 1e-2, 1.0],
        [2e3, 1e-2, 3.0],
    ];
    assert_eq!(
        faults(&twice),
        ["row 5: the speed and density 2000 m/s, 0.01 kg/m^3 stand twice"]
    );
    assert_eq!(
        faults(&[[1e3, 1e-3, 1.0]]),
        [
            "got one speed, 1000 m/s, must be 2 speeds or more: heat fluxes are interpolated over both",
            "got one density, 0.001 kg/m^3, must be 2 densities or more: heat fluxes are interpolated over both"
        ]
    );
    assert_eq!(faults(&[]).len(), 2);
}

#[test]
fn level_ends_are_known() {
    let rows = [
        [0.0, 0.0, 0.0, 0.0],
        [0.0, 1.0, 0.0, 0.0],
        [3e3, 0.0, 0.0, 0.0],
        [3e3, 1.0, 0.0, 0.0],
        [6e3, 0.0, 0.0, 0.0],
        [6e3, 1.0, 5e5, 1e5],
    ];
    let table = table(&rows, Extrapolation::Refuse);
    assert_eq!(table.level(), [[true, false], [false, false]]);
    // 4.5 km/s and 0.5 kg/m³ of a corner of 5e5 W/m²: a quarter
    assert!((flux(&table, Part::Convective, 4.5e3, 0.5) - 1.25e5).abs() < 1e-9);
}

#[test]
fn points_of_a_body_begin_at_the_stagnation_point() {
    let rows = |fractions: &[f64]| -> Vec<Vec<f64>> {
        let mut rows = Vec::new();
        for f in fractions {
            for v in [5e3, 10e3] {
                for rho in [1e-4, 1e-3] {
                    rows.push(vec![*f, v, rho, 1e6 * (1.0 - 0.5 * f), 0.0]);
                }
            }
        }
        rows
    };
    let body = |fractions: &[f64]| {
        BodyHeating::try_new(
            "heating.radius_table",
            Along::Radius,
            &rows(fractions),
            Extrapolation::Hold,
        )
    };
    let two = body(&[1.0, 0.0]).unwrap();
    assert_eq!(two.points.len(), 2);
    let edge = flux(&two.points[1].1, Part::Convective, 7e3, 5e-4);
    assert!((edge / 5e5 - 1.0).abs() < 1e-12);
    assert_eq!(
        body(&[0.5]).unwrap_err(),
        ["no rows of the fraction 0, the stagnation point"]
    );
    let alone = body(&[0.0]).unwrap_err().concat();
    assert!(alone.contains("got the fraction 0 alone"), "{alone}");
}

#[test]
fn rows_of_every_point_are_those_of_the_stagnation_point_and_are_counted_in_the_table() {
    let grid = |f: f64, speeds: &[f64], densities: &[f64]| -> Vec<Vec<f64>> {
        let row = |v: f64, rho: f64| vec![f, v, rho, 1e6, 0.0];
        let rows = speeds
            .iter()
            .map(|v| densities.iter().map(|rho| row(*v, *rho)));
        rows.flatten().collect()
    };
    let faults = |more: Vec<Vec<f64>>| {
        let mut rows = grid(0.0, &[5e3, 7e3, 9e3], &[1e-4, 1e-3]);
        rows.extend(more);
        let (along, rule) = (Along::Arc, Extrapolation::Hold);
        match BodyHeating::try_new("heating.arc_table", along, &rows, rule) {
            Ok(_) => String::new(),
            Err(faults) => faults.join("; "),
        }
    };
    // out of order is no fault
    assert_eq!(faults(grid(1.0, &[9e3, 5e3, 7e3], &[1e-3, 1e-4])), "");
    // the ends are equal, a row between them is not
    assert_eq!(
        faults(grid(1.0, &[5e3, 6e3, 9e3], &[1e-4, 1e-3])),
        "at the fraction 1: got the speed 6000 m/s, must be one of those of the fraction 0"
    );
    assert_eq!(
        faults(grid(0.5, &[5e3, 9e3], &[1e-4, 1e-3])),
        "at the fraction 0.5: no rows of the speed 7000 m/s, which the fraction 0 has"
    );
    assert_eq!(
        faults(grid(0.5, &[5e3, 7e3, 9e3], &[1e-4, 5e-4, 1e-3])),
        "at the fraction 0.5: got the density 0.0005 kg/m^3, must be one of those of the fraction 0"
    );
    let mut twice = grid(0.5, &[5e3, 7e3, 9e3], &[1e-4, 1e-3]);
    twice.push(vec![0.5, 7e3, 1e-3, 2e6, 0.0]);
    assert_eq!(
        faults(twice),
        "at the fraction 0.5: row 13: the speed and density 7000 m/s, 0.001 kg/m^3 stand twice"
    );
}
