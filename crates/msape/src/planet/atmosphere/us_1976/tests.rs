//! The standard atmosphere against printed and independently computed figures.

use crate::planet::atmosphere::Atmosphere;

const COMPUTED: &str = include_str!("../../../../../../tests/data/us_1976_0_200_km.csv");
const PRINTED: &str = include_str!("../../../../../../tests/data/us_1976_printed.csv");

const DEFINITION: &str = include_str!("../../../../data/atmospheres/us-1976.toml");

fn us_1976() -> Atmosphere {
    Atmosphere::parse(DEFINITION.into()).unwrap().1
}

fn definition() -> us1976::definition::Definition {
    toml::from_str(DEFINITION).unwrap()
}

#[test]
fn the_gases_that_the_build_integrated_are_those_of_the_definition() {
    let shipped = crate::library::Library::builtin().unwrap();
    let (_, shipped) = shipped
        .atmospheres
        .iter()
        .find(|(name, _)| name == "us-1976")
        .unwrap();
    assert_eq!(shipped.1, us_1976());
}

#[cfg(feature = "prepared-air")]
#[test]
fn gases_of_the_build_are_of_no_other_definition() {
    use super::prepared_gases;
    use crate::data::Data;
    let prepared = |definition: &serde_json::Value| {
        let text = definition.to_string();
        prepared_gases(Data::Shipped(&text)).is_some()
    };
    let mut shipped: serde_json::Value = toml::from_str(DEFINITION).unwrap();
    assert!(prepared(&shipped));
    shipped["constants"]["gas_constant_j_kmol_k"] = 8314.0.into();
    assert!(!prepared(&shipped));
}

fn in_layer(air: &Atmosphere, layer: usize, altitude_m: f64) -> f64 {
    air.density_in(&air.piece(layer), altitude_m)
}

/// Rows of a file of reference; an empty field is not a number.
fn rows(text: &str) -> Vec<Vec<f64>> {
    let lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    lines
        .map(|line| {
            line.split(',')
                .map(|field| field.parse().unwrap_or(f64::NAN))
                .collect()
        })
        .collect()
}

#[test]
fn every_kilometer_to_200_km() {
    // The reference integrates across the step of the molar mass at 100 km (9e-6), takes that of N2 for the gases that
    // Ar and He diffuse through (2e-5), and leaves out hydrogen above 150 km (3e-5 in pressure and mean free path).
    let air = us_1976();
    let rows = rows(COMPUTED);
    assert_eq!(rows.len(), 201);
    for row in rows {
        let a = air.air(row[0] * 1000.0);
        let ours = [
            a.temperature_k,
            a.pressure_pa,
            a.density_kg_m3,
            a.speed_of_sound_m_s,
            a.mean_free_path_m,
        ];
        for (i, (ours, theirs)) in ours.iter().zip(&row[1..]).enumerate() {
            assert!(
                (ours / theirs - 1.0).abs() < 5e-5,
                "{} km, column {i}: {ours:e} {theirs:e}",
                row[0]
            );
        }
        assert!(
            (a.density_kg_m3 / row[3] - 1.0).abs() < 4e-5,
            "{} km: {:e}",
            row[0],
            a.density_kg_m3
        );
    }
}

#[test]
fn printed_table() {
    // Four or five digits are printed: half a unit of the fourth is up to 5e-4 (of 1.000) in density.
    let air = us_1976();
    for row in rows(PRINTED) {
        let a = air.air(row[0] * 1000.0);
        assert!(
            (a.density_kg_m3 / row[3] - 1.0).abs() < 5e-4,
            "{} km: {:e} {:e}",
            row[0],
            a.density_kg_m3,
            row[3]
        );
        if row[2].is_finite() {
            assert!(
                (a.pressure_pa / row[2] - 1.0).abs() < 1e-4,
                "{} km: {} Pa",
                row[0],
                a.pressure_pa
            );
            assert!(
                (a.temperature_k / row[1] - 1.0).abs() < 3e-5,
                "{} km: {} K",
                row[0],
                a.temperature_k
            );
        }
    }
}

#[test]
fn pieces_meet_at_their_boundaries() {
    // To rounding where the definition is continuous. The two regimes differ by 8e-6 at 86 km; the printed ellipse
    // ends 1.1e-6 beside 240 K at 110 km; hydrogen begins with 3e-7 of the density at 150 km.
    let air = us_1976();
    for (i, z) in air.boundaries_m().iter().enumerate() {
        let (below, above) = (in_layer(&air, i, *z), in_layer(&air, i + 1, *z));
        let step = (above / below - 1.0).abs();
        let allowed = match *z {
            86e3 => 1e-5,
            110e3 => 2e-6,
            150e3 => 1e-6,
            _ => 1e-13,
        };
        assert!(step < allowed, "{z} m: {step:e}");
        assert_eq!(air.layer(*z), i + 1);
    }
    assert_eq!(air.layer(-1000.0), 0);
    assert_eq!(air.boundaries_m().len(), 14);
}

#[test]
fn below_86_km_the_cells_meet_the_closed_form() {
    // (w/H)⁴/384 with w = 100 m and H above 5.4 km: 3e-10
    let lower = us1976::lower::Lower::new(&definition());
    let air = us_1976();
    let mut z = -4_987.0;
    while z < 86e3 {
        let layer = air.layer(z);
        let error = in_layer(&air, layer, z) / lower.layers[layer].density(z).value - 1.0;
        assert!(error.abs() < 3e-10, "{z} m: {error:e}");
        z += 37.0;
    }
}

#[test]
fn cells_of_the_speed_of_sound_meet_the_formula() {
    // The ellipse of the temperature is steepest just below 110 km, where the cells are good to 2.9e-8.
    let air = us_1976();
    let mut z = -4_987.0;
    while z < 900e3 {
        let piece = air.piece(air.layer(z));
        let error = air.speed_of_sound_in(&piece, z) / air.air(z).speed_of_sound_m_s - 1.0;
        assert!(error.abs() < 3e-8, "{z} m: {error:e}");
        z += if z < 120e3 { 37.0 } else { 1_937.0 };
    }
}

#[test]
fn lanes_and_derivatives_see_the_same_air() {
    use crate::planet::atmosphere::Piece;
    use numerics::scalar::{Dual, Lanes, Scalar};
    let air = us_1976();
    // The first and the last are evaluated from the piece below, far beyond its end.
    let places = [(3, 50e3), (7, 90e3), (2, 12e3), (9, 140e3)];
    let mut pieces = Piece::<Lanes<4>>::everywhere(&air.piece(0));
    for (lane, (layer, _)) in places.iter().enumerate() {
        pieces.set_lane(lane, &air.piece(*layer));
    }
    let all = air.air_in(&pieces, Lanes(places.map(|(_, z)| z)));
    let sound = air.speed_of_sound_in(&pieces, Lanes(places.map(|(_, z)| z)));
    for (lane, (layer, z)) in places.into_iter().enumerate() {
        let piece = air.piece(layer);
        let one = air.air_in(&piece, z);
        assert_eq!(all.density_kg_m3.lane(lane), one.density_kg_m3);
        assert_eq!(all.pressure_pa.lane(lane), one.pressure_pa);
        assert_eq!(all.mean_free_path_m.lane(lane), one.mean_free_path_m);
        assert_eq!(sound.lane(lane), air.speed_of_sound_in(&piece, z));
        let dual = air.density_in(&piece, Dual::<1>::variable(z, 0));
        let slope = (air.density_in(&piece, z + 1.0) - air.density_in(&piece, z - 1.0)) / 2.0;
        assert_eq!(dual.value, one.density_kg_m3);
        assert!((dual.slope[0] / slope - 1.0).abs() < 1e-6, "{z}");
    }
}

#[test]
fn a_piece_goes_on_smoothly_beyond_its_ends() {
    let air = us_1976();
    for (i, z) in air.boundaries_m().iter().enumerate() {
        for (layer, side) in [(i, 1.0), (i + 1, -1.0)] {
            let at = |dz: f64| in_layer(&air, layer, z + side * dz);
            // Slopes on both sides of the end agree to the curvature, dz/H = 1e-3.
            let (within, beyond) = (at(-1.0) - at(-2.0), at(3.0) - at(2.0));
            assert!(
                (within / beyond - 1.0).abs() < 3e-3,
                "{z} {side}: {within:e} {beyond:e}"
            );
            assert!(at(20e3) > 0.0 && at(20e3).is_finite());
        }
    }
}

#[test]
fn interpolation_between_knots_meets_the_definition() {
    // Halving the cells is the reference: knots of the fine grid lie in the middle of our cells. The fourth
    // derivative is largest at the lower ends of the spans.
    use us1976::{heterosphere::*, temperature::Upper};
    let definition = definition();
    let upper = Upper::new(&definition);
    let air = us_1976();
    for (i, span) in SPANS.iter().enumerate() {
        let fine: Vec<Span> = SPANS
            .iter()
            .map(|s| Span {
                cell_m: s.cell_m / 2.0,
                ..*s
            })
            .collect();
        let knots = &Heterosphere::new(&definition, &upper).knots_of(&fine)[i];
        for (j, knot) in knots.density.iter().enumerate() {
            let z = span.from_m + j as f64 * span.cell_m / 2.0;
            let error = in_layer(&air, 7 + i, z) / knot.value - 1.0;
            assert!(error.abs() < 3e-7, "{z} m: {error:e}");
        }
    }
}

#[test]
fn above_1000_km_the_density_keeps_falling_at_the_same_rate() {
    let air = us_1976();
    let ratio = |z: f64| air.density_kg_m3(z + 10e3) / air.density_kg_m3(z);
    assert!((ratio(1.2e6) / ratio(1.5e6) - 1.0).abs() < 1e-12);
    assert!((ratio(1e6) / ratio(0.99e6) - 1.0).abs() < 2e-3);
}

#[test]
fn sea_level_is_that_of_the_document() {
    // Table I and the text: 1.2250 kg/m³, 340.294 m/s, 6.6328e-8 m.
    let a = us_1976().air(0.0);
    assert!((a.density_kg_m3 - 1.2250).abs() < 5e-5);
    assert!((a.speed_of_sound_m_s - 340.294).abs() < 5e-4);
    assert!((a.mean_free_path_m / 6.6328e-8 - 1.0).abs() < 1e-4);
}
