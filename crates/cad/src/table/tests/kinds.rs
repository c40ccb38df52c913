//! Columns and units of each kind of table.

use super::*;

#[test]
fn geopotential_altitudes_become_geometric() {
    for heading in [
        "geopotential altitude (m)",
        "Geopotential_height_m",
        "HGHT",
        "gph [gpm]",
        "Altitude (geopotential) [m]",
    ] {
        let table = air(&format!(
            "{heading},rho (kg/m3)\n0,1.225\n71000,6.4211e-5\n"
        ));
        // 6356766 × 71000 / (6356766 − 71000) = 71801.97
        assert!((table.rows[1][0] - 71_801.97).abs() < 0.01, "{table:?}");
        assert!(
            table
                .remarks
                .iter()
                .any(|remark| remark.contains("6356.766 km"))
        );
    }
    let text = "geopotential altitude (m),rho (kg/m3)\n0,0.015\n71000,1e-5\n";
    let table = read(&input::atmosphere::FILE, text.as_bytes(), &mars()).unwrap();
    // mean radius (2 × 3396190 + 3376200)/3 = 3389526.67 m: z = 72518.99 m
    assert!((table.rows[1][0] - 72_519.0).abs() < 0.1, "{table:?}");
    // where both are given, the geometric altitude is used
    let both =
        air("geopotential altitude (m),altitude (m),rho (kg/m3)\n0,0,1.2\n71000,71802,6e-5\n");
    assert_eq!(both.rows[1][0], 71_802.0);
    let plain = read(
        &input::atmosphere::FILE,
        b"# H, m\tT, K\tp, Pa\trho, kg/m3\n0\t200\t585.65\t1.55e-2\n5000\t200\t358.45\t9.4867e-3\n",
        &mars(),
    )
    .unwrap();
    assert_eq!(plain.rows[1], [5e3, 9.4867e-3, 200.0, 358.45]);
    assert!(
        plain
            .remarks
            .iter()
            .any(|remark| remark.contains("H is taken as geometric"))
    );
}

#[test]
fn a_plain_h_is_told_by_the_weight_of_the_air() {
    let standard = earth().standard.unwrap();
    let geometric = |h: f64| 6_356_766.0 * h / (6_356_766.0 - h);
    let table = |altitude_m: fn(f64, f64) -> f64, columns: &str| {
        let mut text = format!("# H, km {columns}\n");
        for n in 0..36 {
            let h = 2e3 * f64::from(n);
            let air = standard.air(altitude_m(h, geometric(h)));
            let (p, rho, t) = (air.pressure_pa, air.density_kg_m3, air.temperature_k);
            text += &match columns {
                ", rho, kg/m3" => format!("{} {rho:.4e}\n", h / 1e3),
                ", T, K, rho, kg/m3" => format!("{}, {t:.2}, {rho:.4e}\n", h / 1e3),
                _ => format!("{}, {p:.4e}, {rho:.4e}\n", h / 1e3),
            };
        }
        read(&input::atmosphere::FILE, text.as_bytes(), &earth())
    };
    for columns in [", p, Pa, rho, kg/m3", ", T, K, rho, kg/m3"] {
        let found = table(|h, _| h, columns).unwrap();
        assert_eq!(found.rows[35][0], 70e3, "{columns}");
        assert!(
            found
                .remarks
                .iter()
                .any(|remark| remark.starts_with("H is taken as geometric"))
        );
        let found = table(|_, z| z, columns).unwrap();
        assert!(
            (found.rows[35][0] - geometric(70e3)).abs() < 1e-6,
            "{columns}"
        );
        assert!(
            found
                .remarks
                .iter()
                .any(|remark| remark.starts_with("H is taken as geopotential"))
        );
    }
    assert!(table(|h, _| h, ", rho, kg/m3").is_err());
    // too low to distinguish
    let low = "H (m), p (Pa), rho (kg/m3)\n0, 101325, 1.225\n1000, 89876, 1.1117\n";
    assert_eq!(
        read(&input::atmosphere::FILE, low.as_bytes(), &earth()),
        Err(vec![TableFault::CapitalH])
    );
}

#[test]
fn soundings_give_density_from_pressure_and_temperature() {
    let table = air(
        "pressure_hPa,height_m,temperature_C\n1013.25,0,15\n540.2,5000,-17.5\n264.4,10000,-49.9\n",
    );
    // 54020 / (287.05287 × 255.65) = 0.73612
    assert!((table.rows[1][1] - 0.73612).abs() < 1e-5, "{table:?}");
    assert_eq!(table.rows[1].len(), 4);
    let listing = "
-----------------------------------------------------------------------------
   PRES   HGHT   TEMP   DWPT   RELH   MIXR   DRCT   SKNT   THTA   THTE   THTV
    hPa     m      C      C      %    g/kg    deg   knot     K      K      K
-----------------------------------------------------------------------------
 1000.0    136
  925.0    747
  913.0    849   -8.5  -10.3     87   1.92    325     11  271.6  277.1  271.9
  908.0    892   -9.7  -13.6     73   1.48    317     14  270.8  275.1  271.1
  907.0    900   -9.8  -13.6     74   1.48    270     10  270.8  275.1  271.1

Station information and sounding indices
                         Station number: 99999
";
    let table = air(listing);
    assert_eq!(table.rows.len(), 3);
    // 91300 / (287.05287 × 264.65) = 1.20181; 6356766 × 849 / (6356766 − 849) = 849.11
    assert!(
        (table.rows[0][1] - 1.20181).abs() < 1e-5 && (table.rows[0][0] - 849.11).abs() < 0.01,
        "{table:?}"
    );
    assert!(
        table
            .remarks
            .iter()
            .any(|remark| remark.starts_with("2 rows with fewer cells")),
        "{:?}",
        table.remarks
    );
    let wind = read(&input::wind::FILE, listing.as_bytes(), &earth()).unwrap();
    // 10 kt from the west blow east
    assert!(
        (wind.rows[2][1] - 10.0 * 1852.0 / 3600.0).abs() < 1e-12 && wind.rows[2][2].abs() < 1e-12,
        "{wind:?}"
    );
    let elsewhere = b"p (Pa),z (m),T (K)\n600,0,210\n300,7000,200\n";
    // 600 / (191.093 × 210) = 0.0149515 in the gas of Mars
    let table = read(&input::atmosphere::FILE, elsewhere, &mars()).unwrap();
    assert!((table.rows[0][1] - 0.014_951_5).abs() < 1e-6, "{table:?}");
    let mut own = Case::default();
    own.set("planet.equatorial_radius_m", "3396190");
    let unknown = read(
        &input::atmosphere::FILE,
        elsewhere,
        &Ground::of(&own, &LIBRARY),
    );
    assert_eq!(unknown.unwrap_err(), [TableFault::UnknownGas]);
}

#[test]
fn pressure_altitudes_are_stacked_to_heights() {
    // in the standard atmosphere itself pressure altitude is geopotential altitude
    let standard =
        "pressure altitude (m),T (K)\n0,288.15\n500,284.9\n1000,281.65\n1500,278.4\n2000,275.15\n";
    let table = air(standard);
    let air_at = |z: f64| earth().standard.unwrap().air(z);
    for (row, h) in table.rows.iter().zip([0.0, 500.0, 1000.0, 1500.0, 2000.0]) {
        let z = 6_356_766.0 * h / (6_356_766.0 - h);
        assert!(
            (row[0] - z).abs() < 0.02 && (row[1] / air_at(z).density_kg_m3 - 1.0).abs() < 1e-5,
            "{table:?}"
        );
    }
    // air 10 % warmer is 10 % thicker between two pressures: 2000 m become 2200 m
    let warm = air("pressure altitude (m),T (K)\n0,316.965\n1000,309.815\n2000,302.665\n");
    assert!((warm.rows[2][0] - 2200.76).abs() < 0.5, "{warm:?}");
    assert!(
        faults(
            &input::atmosphere::FILE,
            "pressure altitude (m),p (Pa)\n0,1\n1,2\n"
        )[0]
        .contains("no column for density")
            || faults(
                &input::atmosphere::FILE,
                "pressure altitude (m),p (Pa)\n0,1\n1,2\n"
            )[0]
            .contains("give temperature")
    );
    let text = b"pressure altitude (m),T (K)\n0,1\n1,2\n";
    assert!(
        read(&input::atmosphere::FILE, text, &mars()).unwrap_err()[0]
            .to_string()
            .contains("of the Earth")
    );
}

#[test]
fn curves_of_drag_and_bank() {
    let of =
        |key: &str, text: &str| read(input::find(key).unwrap(), text.as_bytes(), &earth()).unwrap();
    let curve = [[0.5, 0.38], [1.0, 0.63], [2.0, 0.51]];
    for text in [
        "0.5,0.38\n1.0,0.63\n2.0,0.51\n",
        "Mach,Cd\n0.5,0.38\n1.0,0.63\n2.0,0.51\n",
        "Mach number;drag coefficient\n2,0;0,51\n1,0;0,63\n0,5;0,38\n",
        "# M Cd\n0.5 0.38\n1.0 0.63\n2.0 0.51\n",
    ] {
        for key in ["vehicle.drag_file", "vehicle.aerodynamics.file"] {
            let table = of(key, text);
            assert_eq!(table.key, "vehicle.drag_table");
            assert_eq!(table.rows, curve, "{text}");
        }
    }
    let export = "Mach,Alpha,CD,CD Power-Off,CD Power-On,CA Power-Off,CL,CN,CNalpha (0 to 4 deg) (per rad),CP\n0.5,0,0.38,1,1,1,0,0,6,66\n0.5,2,0.4,1,1,1,0.2,0.2,6,66\n1,0,0.63,1,1,1,0,0,6,66\n1,2,0.7,1,1,1,0.3,0.3,6,66\n";
    assert_eq!(
        of("vehicle.drag_file", export).rows,
        [[0.5, 0.38], [1.0, 0.63]]
    );
    let aerodynamics = of("vehicle.aerodynamics.file", export);
    assert_eq!(
        (aerodynamics.key, aerodynamics.rows.len()),
        ("vehicle.aerodynamics.table", 4)
    );
    let repeated = of("vehicle.drag_file", "0.1,0.5\n0.2,0.4\n0.2,0.6\n0.3,0.7\n");
    assert_eq!(repeated.rows, [[0.1, 0.5], [0.2, 0.5], [0.3, 0.7]]);
    assert!(
        repeated
            .remarks
            .iter()
            .any(|remark| remark.contains("at 1 Mach numbers"))
    );
    assert!(
        faults(&input::vehicle::DRAG_FILE, "1,0.5\n3,0.4\n2,0.6\n")[0]
            .starts_with("line 3: mach 2 after 3")
    );
    let bank = of("vehicle.bank_file", "speed (km/s),bank (rad)\n7,0\n3,1\n");
    assert_eq!(bank.key, "vehicle.bank_speed_table_deg");
    assert_eq!(bank.rows[0], [3e3, 180.0 / std::f64::consts::PI]);
    assert_eq!(
        of("vehicle.bank_file", "t (min)  bank\n0 0\n1 60\n").rows[1],
        [60.0, 60.0]
    );
    assert_eq!(
        of("vehicle.lift_file", "mach,cl\n1,0.3\n").key,
        "vehicle.lift_table"
    );
}

/// 1e308 km is more than a number of meters can be.
#[test]
fn numbers_that_no_unit_keeps_finite_are_refused() {
    let text = "altitude (km),density (kg/m3),temperature (K)\n0,1.2,288\n1e308,1e-9,200\n";
    let faults = read(&input::atmosphere::FILE, text.as_bytes(), &earth()).unwrap_err();
    let said = faults
        .iter()
        .map(ToString::to_string)
        .collect::<Vec<_>>()
        .concat();
    assert!(said.contains("line 3") && said.contains("1e308"), "{said}");
}

#[test]
fn aerodynamic_tables() {
    let of = |text: &str| {
        read(
            &input::vehicle::AERODYNAMICS_FILE,
            text.as_bytes(),
            &earth(),
        )
        .unwrap()
        .rows
    };
    let rows = [[1.0, 0.0, 1.5, 0.0], [1.0, 10.0, 1.4, 0.1]];
    for text in [
        "# wind tunnel\nMach,alpha (deg),CA,CN\n1,0,1.5,0\n1,10,1.4,0.1\n",
        "Mach;alpha_deg;CA;CN\n1;0;1,5;0\n1;10;1,4;0,1\n",
        "\"mach\",\"alpha, deg\",\"ca\",\"cn\"\n\"1\",\"0\",\"1.5\",\"0\"\n\"1\",\"10\",\"1.4\",\"0.1\"\n",
        "Mach  alpha  CA  CN\n-  deg  -  -\n1  10  1.4  0.1\n1  0  1.5  0\n",
        "# M aoa_deg ca cn source\n1 0 1.5 0 T1\n1 10 1.4 0.1 T1\n",
    ] {
        assert_eq!(of(text), rows, "{text}");
    }
    let radians = of("mach,alpha (rad),ca,cn\n1,0,1.5,0\n1,0.174532925199433,1.4,0.1\n");
    assert!((radians[1][1] - 10.0).abs() < 1e-12);
    let high = of("mach,alpha,altitude_km,ca,cn,cm\n20,0,80,1.5,0,0\n20,0,100,1.7,0,0\n");
    assert_eq!(high[1], [20.0, 0.0, 1.7, 0.0, 0.0, 0.0, 0.0, 1e5]);
    let descending = of("mach,alpha,ca,cn\n2,0,1,0\n\n1,0,1,0\n");
    assert_eq!(descending[0][0], 1.0);
    let damping = read(
        &input::vehicle::AERODYNAMICS_DAMPING_FILE,
        b"mach,alpha_deg,cmq\n1,0,-0.1\n2,0,-0.2\n",
        &earth(),
    );
    assert_eq!(damping.unwrap().rows, [[1.0, 0.0, -0.1], [2.0, 0.0, -0.2]]);
}

#[test]
fn faults_of_aerodynamic_tables() {
    let said = |text: &str| faults(&input::vehicle::AERODYNAMICS_FILE, text);
    let found = said("mach,alpha,ca,cn\n1,0,1,0\n1,5,,0.1\n1,10,x,0.1\n1,15,1,0.1,7\n");
    assert_eq!(
        found,
        [
            "line 3: column 3: got \"\", must be a number; the table has a hole there",
            "line 4: column 3: got \"x\", must be a number",
            "line 5: got 5 fields, must be 4"
        ]
    );
    assert!(said("mach,alpha,ca,cn\n1,0,1,0\n1,0,1,0\n")[0].contains("twice"));
    assert!(
        said("mach,beta,ca\n1,2,3\n")[0]
            .contains("no column for alpha_deg; the others are \"beta\"")
    );
    assert_eq!(said("mach,ca\n1,1\n").len(), 2);
    assert_eq!(said(""), ["the file holds no row of numbers"]);
    let radians = "mach,alpha,ca,cn\n5,0,1.4,0\n5,1.5708,0,0.5\n5,3.14159,-1.4,0\n";
    assert!(
        said(radians)[0].contains("which is pi"),
        "{:?}",
        said(radians)
    );
}
