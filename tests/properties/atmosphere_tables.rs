//! Any atmosphere table: its own gas, or the planet's, and no growth of density beyond its ends.

use crate::config;
use crate::planets::{LIBRARY, case, ends, flown, refused, table, told};
use msape::library::named;
use msape::planet::atmosphere::Atmosphere;
use msape::planet::atmosphere::table::Table;
use proptest::prelude::*;

/// Isothermal rows of a gas with gas constant `r`: altitude, density, temperature, pressure every 10 km.
fn isothermal(r: f64, temperature_k: f64, density_kg_m3: f64, scale_m: f64) -> Vec<[f64; 4]> {
    let row = |i: i32| {
        let altitude_m = f64::from(i) * 1e4;
        let density = density_kg_m3 * (-altitude_m / scale_m).exp();
        [
            altitude_m,
            density,
            temperature_k,
            density * r * temperature_k,
        ]
    };
    (0..=13).map(row).collect()
}

#[test]
fn a_table_with_density_temperature_and_pressure_has_its_own_gas() {
    // carbon dioxide at 200 K: R 188.92, γ 1.346 (JANAF, 32.36 J/(mol K)); that of Mars has 1.350: 225.5 m/s
    let rows = isothermal(188.92, 200.0, 0.0155, 10_183.0);
    let answer = flown(&case("mars", 2e4, 1000.0, &table(&rows)));
    let [mach, _] = ends(&answer, "mach");
    assert!((mach - 4.434).abs() < 0.01, "{mach}");
    assert!(told(&answer, "make a gas of").is_none());
    // the same gas over the Earth gives a finding that it is not air; γ is that of air
    let answer = flown(&case("earth", 2e4, 1000.0, &table(&rows)));
    let [mach, _] = ends(&answer, "mach");
    assert!(
        (mach - 1000.0 / (1.4_f64 * 188.92 * 200.0).sqrt()).abs() < 1e-3,
        "{mach}"
    );
    assert!(
        told(
            &answer,
            "make a gas of 44.01 to 44.01 kg/kmol, that of Earth (WGS84, EGM96) has 28.96"
        )
        .is_some()
    );
    // the ratio of heat capacities may be given
    let mut own = case("earth", 2e4, 1000.0, &table(&rows));
    own.set("atmosphere.heat_capacity_ratio", "1.29");
    let [mach, _] = ends(&flown(&own), "mach");
    assert!((mach - 4.529).abs() < 1e-3, "{mach}");
}

#[test]
fn what_a_table_leaves_open_is_the_planet_s_own() {
    let rows = isothermal(191.1, 200.0, 0.0155, 10_183.0);
    let without = |column: usize| -> Vec<[f64; 4]> {
        let mut rows = rows.clone();
        rows.iter_mut().for_each(|row| row[column] = 0.0);
        rows
    };
    // gas of Mars: 8314.46/43.51 = 191.09; p = ρ R T gives any one of the three
    let three: Vec<[f64; 3]> = rows.iter().map(|[z, rho, t, _]| [*z, *rho, *t]).collect();
    let whole = flown(&case("mars", 2e4, 1000.0, &table(&rows)));
    for other in [table(&without(1)), table(&without(2)), table(&three)] {
        let answer = flown(&case("mars", 2e4, 1000.0, &other));
        for key in ["mach", "density_kg_m3", "temperature_k", "pressure_pa"] {
            let ([a, _], [b, _]) = (ends(&answer, key), ends(&whole, key));
            assert!((a / b - 1.0).abs() < 1e-3, "{key}: {a} against {b}");
        }
    }
    // density alone: temperature of the planet's own atmosphere, and a finding
    let two: Vec<[f64; 2]> = rows.iter().map(|[z, rho, ..]| [*z, *rho]).collect();
    let answer = flown(&case("mars", 2e4, 1000.0, &table(&two)));
    let [temperature, _] = ends(&answer, "temperature_k");
    assert!((temperature - 179.8).abs() < 0.1, "{temperature}");
    assert!(told(&answer, "Temperature and gas are assumed: of Mars-GRAM").is_some());
    // temperature alone gives no density
    let fault = refused(&case(
        "mars",
        2e4,
        1000.0,
        &table(&[[0.0, 0.0, 200.0], [1e4, 0.0, 200.0]]),
    ));
    assert!(
        fault.contains("row 1: density_kg_m3: got 0 kg/m³"),
        "{fault}"
    );
}

#[test]
fn numbers_that_are_no_gas_are_refused() {
    // pressure in hPa, where Pa is expected: 4401 kg/kmol
    let mut rows = isothermal(188.92, 200.0, 0.0155, 10_183.0);
    rows.iter_mut().for_each(|row| row[3] /= 100.0);
    let fault = refused(&case("mars", 2e4, 1000.0, &table(&rows)));
    assert!(
        fault.contains("row 1: density, temperature and pressure make a gas of 4401"),
        "{fault}"
    );
}

#[test]
fn knudsen_number_is_of_the_planet_s_gas() {
    // hydrogen and helium: L ρ = 3.2 μ/√(2π R T) = 3.2 · 9.8454e-6 (150/273)^0.669/√(2π · 3600.4 · 150) = 1.147e-8
    // kg/m²
    let rows: Vec<[f64; 3]> = vec![[0.0, 0.1, 150.0], [1e5, 1e-3, 150.0]];
    let answer = flown(&case("jupiter", 1e5, 3000.0, &table(&rows)));
    let [knudsen, _] = ends(&answer, "knudsen");
    assert!(
        (knudsen * 2.65 * 1e-3 / 1.147e-8 - 1.0).abs() < 2e-3,
        "{knudsen}"
    );
}

#[test]
fn extrapolated_density_never_grows_with_height() {
    let rising = table(&[[0.0, 1.225], [5000.0, 0.7361], [10_000.0, 0.8135]]);
    let answer = flown(&case("earth", 1e5, 0.0, &rising));
    assert!((ends(&answer, "density_kg_m3")[0] - 0.8135).abs() < 1e-9);
    assert!(told(&answer, "density is held, for it grows with height").is_some());
    let air = || {
        named(&LIBRARY.atmospheres, "us-1976")
            .unwrap()
            .1
            .planet_air()
    };
    let rows = |rows: &[[f64; 2]]| {
        let rows: Vec<Vec<f64>> = rows.iter().map(|row| row.to_vec()).collect();
        Atmosphere::Table(std::sync::Arc::new(Table::try_new(&rows, air()).unwrap()))
    };
    // growth within the table is the user's choice; below a first row from which density grows with height it is held,
    // too
    let inside = rows(&[[0.0, 1.0], [1e3, 1.2], [2e3, 0.5]]);
    assert!(inside.density_kg_m3(900.0) > inside.density_kg_m3(100.0));
    assert_eq!(inside.density_kg_m3(-5e3), 1.0);
    assert!(inside.density_kg_m3(3e3) < 0.5);
    assert_eq!(inside.boundaries_m(), [0.0, 1e3]);
}

proptest! {
    #![proptest_config(config(200))]

    #[test]
    fn beyond_any_table_density_does_not_grow_with_height(
        densities in prop::collection::vec(1e-6..1.0_f64, 2..8),
        steps in prop::collection::vec(100.0..20_000.0_f64, 8),
        beyond in 1.0..1e5_f64,
    ) {
        let mut altitude_m = -3000.0;
        let rows: Vec<Vec<f64>> = densities
            .iter()
            .zip(&steps)
            .map(|(density, step)| {
                altitude_m += step;
                vec![altitude_m, *density]
            })
            .collect();
        let air = named(&LIBRARY.atmospheres, "venus").unwrap().1.planet_air();
        let table = Atmosphere::Table(std::sync::Arc::new(Table::try_new(&rows, air).unwrap()));
        let (bottom_m, top_m) = table.valid_m();
        let density = |z: f64| table.density_kg_m3(z);
        prop_assert!(density(top_m + beyond) <= density(top_m) * (1.0 + 1e-12));
        prop_assert!(density(bottom_m - beyond) >= density(bottom_m) * (1.0 - 1e-12));
        for (row, density_kg_m3) in rows.iter().zip(&densities) {
            prop_assert!((density(row[0]) / density_kg_m3 - 1.0).abs() < 1e-9);
        }
    }
}
