//! Atmospheres of the planets: compared with measured profiles and with source rows that they do not contain, and in
//! hydrostatic balance.

use msape::Library;
use msape::library::{World, named};
use msape::planet::Planet;
use msape::planet::atmosphere::{Air, Atmosphere};
use msape::planet::geodetic::Geodetic;
use std::sync::LazyLock;

static LIBRARY: LazyLock<Library> = LazyLock::new(|| Library::builtin().unwrap());

fn planet(name: &str) -> &'static Planet {
    &named(&LIBRARY.planets, name).unwrap().planet
}

/// Default atmosphere of a planet.
fn own(name: &str) -> &'static Atmosphere {
    &named(&LIBRARY.atmospheres, &planet(name).atmosphere)
        .unwrap()
        .1
}

/// Rows of a file of numbers below its heading, without the first `words` cells.
fn rows(text: &str, words: usize) -> impl Iterator<Item = (&str, Vec<f64>)> {
    let lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    lines.map(move |line| {
        let cells = line.split(',');
        let numbers = cells.skip(words).map(|cell| cell.parse().unwrap());
        (line.split(',').next().unwrap(), numbers.collect())
    })
}

/// Largest deviation of a ratio from 1.
fn largest(ratios: impl Iterator<Item = f64>) -> f64 {
    ratios.fold(0.0, |most, ratio| most.max((ratio - 1.0).abs()))
}

#[test]
fn venus_is_what_the_day_probe_measured() {
    // A nominal model of all probes and latitudes compared with one of them; zero altitude is 6052.0 km there, 6051.8
    // km here, which is 0.4 to 4 % of density. At the cloud tops the air of one place is 2 % colder, and 6 % lower in
    // pressure, than the mean.
    let text = include_str!("../data/venus_pioneer_day.csv");
    let measured: Vec<Vec<f64>> = rows(text, 0).map(|(_, row)| row).collect();
    let air = |row: &Vec<f64>| own("venus").air(row[0] * 1e3);
    let density = largest(measured.iter().map(|row| air(row).density_kg_m3 / row[3]));
    let pressure = largest(
        measured
            .iter()
            .map(|row| air(row).pressure_pa / (row[1] * 1e5)),
    );
    let temperature = largest(measured.iter().map(|row| air(row).temperature_k / row[2]));
    let got = [density, pressure, temperature];
    assert!(
        density < 0.04 && pressure < 0.06 && temperature < 0.025,
        "{got:?}"
    );
}

#[test]
fn jupiter_is_what_the_galileo_probe_measured_but_for_its_waves() {
    // the nominal model smooths the waves that the probe met: its density is 0.89 to 1.07 of the table
    let text = include_str!("../data/jupiter_galileo_asi.csv");
    let table: Vec<Vec<f64>> = rows(text, 0).map(|(_, row)| row).collect();
    let inside = || table.iter().filter(|row| row[0] <= 1020.0);
    let air = |row: &Vec<f64>| own("jupiter").air(row[0] * 1e3);
    let density = largest(inside().map(|row| air(row).density_kg_m3 / row[3]));
    assert!(density < 0.12, "{density}");
    // speed of sound √(γ R T) of the table: γ of a harmonic and rotating mixture is within 1.3 % of the table's
    let sound = largest(inside().map(|row| {
        let measured = (row[5] * row[4] * row[2]).sqrt();
        air(row).speed_of_sound_m_s / measured
    }));
    assert!(sound < 0.06, "{sound}");
    let ratio = largest(inside().map(|row| {
        let gas = own("jupiter").planet_air().gas;
        gas.heat_capacity_ratio.at(row[2]) / row[5]
    }));
    assert!(ratio < 0.016, "{ratio}");
    // its last data: 22 bar and 427.7 K at −132.4 km
    let deep = own("jupiter").air(-132.4e3);
    assert!(
        (deep.pressure_pa / 22e5 - 1.0).abs() < 1e-3 && (deep.temperature_k - 427.7).abs() < 0.1
    );
}

#[test]
fn rows_left_out_of_a_source_are_met_within_the_error_stated() {
    let text = include_str!("../data/planet_columns.csv");
    let mut planets = Vec::new();
    for (name, row) in rows(text, 1) {
        let [altitude_km, density, temperature, pressure, sound] = row[..] else {
            panic!("{name}: {row:?}");
        };
        let air: Air<f64> = own(name).air(altitude_km * 1e3);
        // 0.5 % as stated plus rounding to four digits; the source's own speed of sound has γ within 0.005 of 1.4,
        // except on Jupiter, where it is 1.41 at any temperature
        let close = |what: &str, got: f64, expected: f64, part: f64| {
            let off = (got / expected - 1.0).abs();
            assert!(off < part, "{name}, {altitude_km} km: {what} off by {off}");
        };
        close("density", air.density_kg_m3, density, 6e-3);
        close("pressure", air.pressure_pa, pressure, 6e-3);
        close("temperature", air.temperature_k, temperature, 6e-3);
        let part = if name == "jupiter" { 0.07 } else { 8e-3 };
        close("speed of sound", air.speed_of_sound_m_s, sound, part);
        if !planets.contains(&name) {
            planets.push(name);
        }
    }
    assert_eq!(planets.len(), 6);
}

/// Gravity minus centrifugal acceleration at a geodetic latitude and an altitude, m/s².
fn gravity_m_s2(name: &str, latitude_deg: f64, altitude_m: f64) -> f64 {
    let place = Geodetic {
        altitude_m,
        latitude_rad: latitude_deg.to_radians(),
        longitude_rad: 0.0,
    };
    let [x, y, z] = planet(name).effective_gravity(planet(name).cartesian_m(&place));
    (x * x + y * y + z * z).sqrt()
}

#[test]
fn saturn_is_in_hydrostatic_balance_where_voyager_went_behind_it() {
    // ln(p/p') = ∫ g/(R T) dz over each interval, R T = p/ρ; heights are rounded to 0.1 km of 6.4 to 210 km
    let saturn = own("saturn");
    let (first_m, last_m) = saturn.valid_m();
    let ends: Vec<f64> = [first_m]
        .into_iter()
        .chain(saturn.boundaries_m().iter().copied())
        .chain([last_m])
        .collect();
    assert!(ends.len() > 30 && last_m == 1e6);
    for pair in ends.windows(2) {
        let steps = 64;
        let dz = (pair[1] - pair[0]) / f64::from(steps);
        let sum: f64 = (0..steps)
            .map(|i| {
                let z = pair[0] + (f64::from(i) + 0.5) * dz;
                let air = saturn.air(z);
                gravity_m_s2("saturn", 36.5, z) * air.density_kg_m3 / air.pressure_pa * dz
            })
            .sum();
        let [below, above] = [pair[0] + 1e-3, pair[1] - 1e-3].map(|z| saturn.air(z).pressure_pa);
        let fall = (below / above).ln();
        assert!(
            (fall / sum - 1.0).abs() < 0.02,
            "{pair:?}: {fall} against {sum}"
        );
    }
    // Lindal's heights of 0.2 mbar and of about 100 mbar: 376.7 and 94.4 km
    for (height_km, pressure_pa) in [(376.7, 20.0), (94.4, 8710.0)] {
        let pressure = saturn.air(height_km * 1e3).pressure_pa;
        // 1.2 km of a scale height of 33 to 53 km
        assert!(
            (pressure / pressure_pa).ln().abs() < 0.03,
            "{height_km}: {pressure}"
        );
    }
}

#[test]
fn each_planet_has_its_own_atmosphere_whose_density_falls_above_it() {
    for (name, World { planet, .. }) in &LIBRARY.planets {
        let (_, top_m) = own(name).valid_m();
        let density = |z: f64| own(name).density_kg_m3(z);
        assert!(density(top_m) > density(top_m + 1e5), "{name}");
        assert!(density(planet.lowest_altitude_m) >= density(0.0), "{name}");
        assert!(planet.entry_interface_m < 1.3 * top_m, "{name}");
        let air = own(name).air(planet.exponential_fit_m[0]);
        assert!((1.2..1.7).contains(&air.heat_capacity_ratio), "{name}");
        // mean free path of a gas of molecules of about 2.5 to 5 Å: 5e-9 to 1.2e-7 kg/m² divided by density
        let path = air.mean_free_path_m * air.density_kg_m3;
        assert!((5e-9..1.2e-7).contains(&path), "{name}: {path}");
    }
}

#[test]
fn probes_of_four_planets_are_slowed_where_other_codes_have_it() {
    // Code against code: columns thinned to 0.5 %, other constants of gravity and figure, latitudes and azimuths where
    // a study gives none: half a percent where all is known, one where not; 100 m of altitude are 2.5 % of density at
    // Venus.
    let text = include_str!("../data/planet_entries.csv");
    for line in text.lines().filter(|line| !line.starts_with('#')).skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let mut case = msape::Case::default();
        let keys = [
            "entry.planet",
            "entry.altitude_m",
            "entry.speed_m_s",
            "entry.flight_path_angle_deg",
            "vehicle.mass_kg",
            "entry.latitude_deg",
            "entry.azimuth_deg",
        ];
        for (key, cell) in keys.iter().zip(&cells) {
            case.set(key, cell);
        }
        for (key, value) in [
            ("entry.longitude_deg", "0"),
            ("heating.radiative", "none"),
            ("vehicle.reference_area_m2", "1"),
            ("vehicle.drag_coefficient", "1"),
            ("vehicle.nose_radius_m", "0.3"),
        ] {
            case.set(key, value);
        }
        let flight = msape_tests::entry::flown(&case, &LIBRARY).flight.unwrap();
        let peak = flight.peak_deceleration_earth_g;
        let number = |i: usize| cells[i].parse::<f64>();
        let (expected, within) = (number(7).unwrap(), number(9).unwrap());
        let off = (peak.value / expected - 1.0).abs();
        assert!(off < within, "{line}: {}", peak.value);
        if let Ok(altitude_m) = number(8) {
            let off_m = (peak.altitude_m - altitude_m).abs();
            assert!(off_m < 0.0025 * altitude_m, "{line}: {}", peak.altitude_m);
        }
    }
}

#[test]
fn the_sigma_of_a_source_is_kept() {
    let sigma = |name: &str, z: f64| match own(name) {
        Atmosphere::Table(table) => table.density_sigma(z),
        _ => None,
    };
    assert_eq!(sigma("mars", 0.0), Some(0.02));
    assert_eq!(sigma("mars", 2e6), Some(0.45));
    assert!((sigma("venus", 200e3).unwrap() - 0.1402).abs() < 1e-3);
    assert_eq!(sigma("jupiter", 0.0), None);
    assert_eq!(sigma("earth", 0.0), None);
}
