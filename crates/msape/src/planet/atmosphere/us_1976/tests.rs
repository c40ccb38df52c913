//! The standard atmosphere against published and independently computed figures.

use crate::planet::atmosphere::Atmosphere;

fn us_1976() -> Atmosphere {
    Atmosphere::us_1976(include_str!("../../../../data/atmospheres/us-1976.toml")).unwrap()
}

/// Altitude, km, density, kg/m³, pressure, Pa: Table I of the document, four digits printed.
const PRINTED: [(f64, f64, f64); 13] = [
    (0.0, 1.225, 101325.0),
    (11.0, 3.6480e-1, 22700.0),
    (20.0, 8.8910e-2, 5529.3),
    (32.0, 1.3555e-2, 889.06),
    (47.0, 1.4965e-3, 115.85),
    (51.0, 9.0690e-4, 70.458),
    (71.0, 7.1966e-5, 4.4795),
    (86.0, 6.958e-6, 0.37338),
    (100.0, 5.604e-7, 3.2011e-2),
    (110.0, 9.708e-8, 7.1042e-3),
    (120.0, 2.222e-8, 2.5382e-3),
    (150.0, 2.076e-9, 4.5422e-4),
    (200.0, 2.541e-10, 8.4736e-5),
];

#[test]
fn printed_table_to_200_km() {
    let air = us_1976();
    for (km, density, pressure) in PRINTED {
        let a = air.air(km * 1000.0);
        // 2.5e-4 is half a unit of the fourth printed digit at its worst.
        assert!((a.density_kg_m3 / density - 1.0).abs() < 2.5e-4, "{km} km: {} {density}", a.density_kg_m3);
        assert!((a.pressure_pa / pressure - 1.0).abs() < 1e-4, "{km} km: {} {pressure}", a.pressure_pa);
    }
}

#[test]
fn printed_densities_to_1000_km() {
    // Table I as reproduced in textbooks of astrodynamics, four digits.
    let air = us_1976();
    for (km, density) in [
        (250.0, 6.073e-11),
        (300.0, 1.916e-11),
        (350.0, 7.014e-12),
        (400.0, 2.803e-12),
        (450.0, 1.184e-12),
        (500.0, 5.215e-13),
        (550.0, 2.384e-13),
        (600.0, 1.137e-13),
        (650.0, 5.712e-14),
        (700.0, 3.070e-14),
        (750.0, 1.788e-14),
        (800.0, 1.136e-14),
        (850.0, 7.824e-15),
        (900.0, 5.759e-15),
        (950.0, 4.453e-15),
        (1000.0, 3.561e-15),
    ] {
        let ours = air.air(km * 1000.0).density_kg_m3;
        println!("{km} {ours:e} {:.2e}", ours / density - 1.0);
        assert!((ours / density - 1.0).abs() < 5e-4, "{km} km: {ours:e} {density:e}");
    }
}
