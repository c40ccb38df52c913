use super::*;
use std::sync::LazyLock;

static LIBRARY: LazyLock<Library> = LazyLock::new(|| Library::builtin().unwrap());

fn earth() -> Ground {
    Ground::earth(&LIBRARY)
}

fn mars() -> Ground {
    let mut case = Case::default();
    case.set("entry.planet", "mars");
    Ground::of(&case, &LIBRARY)
}

fn air(text: &str) -> Table {
    read("atmosphere.file", text.as_bytes(), &earth())
        .unwrap_or_else(|faults| panic!("{text}: {faults:?}"))
}

fn faults(key: &str, text: &str) -> Vec<String> {
    let found = read(key, text.as_bytes(), &earth());
    found.unwrap_err().iter().map(ToString::to_string).collect()
}

#[track_caller]
fn same(rows: &[Vec<f64>], wanted: &[&[f64]]) {
    assert_eq!(rows.len(), wanted.len(), "{rows:?}");
    for (row, wanted) in rows.iter().zip(wanted) {
        assert_eq!(row.len(), wanted.len(), "{rows:?}");
        for (x, y) in row.iter().zip(*wanted) {
            assert!((x - y).abs() <= 1e-12 * y.abs().max(1.0), "{rows:?}");
        }
    }
}

/// 0, 5 and 10 km of one atmosphere.
const AIR: [&[f64]; 3] = [&[0.0, 1.225], &[5e3, 0.7361], &[1e4, 0.4135]];
const WARM_AIR: [&[f64]; 3] = [
    &[0.0, 1.225, 288.15],
    &[5e3, 0.7361, 255.65],
    &[1e4, 0.4135, 223.15],
];

#[test]
fn one_atmosphere_in_the_dialects_of_many_programs() {
    for text in [
        "0,1.2250\n5000,0.7361\n10000,0.4135\n",
        "altitude_m,density_kg_m3\r\n0,1.2250\r\n5000,0.7361\r\n10000,0.4135\r\n",
        "altitude_m,density_kg_m3\r0,1.2250\r5000,0.7361\r10000,0.4135\r",
        "  0.0   1.2250\n 5000.0  0.7361\n10000.0  0.4135\n",
        "z (m)  rho (kg/m3)\n0 1,2250\n5000 0,7361\n10000 0,4135\n",
        "altitude (km)\trho [g cm^-3]\n0\t1,2250e-3\n5\t0,7361e-3\n10\t0,4135e-3\n",
        "altitude (m),density (kg/m3)\n10000,0.4135\n5000,0.7361\n0,1.2250\n",
        "sep=;\nh [m];Dichte [kg/m³]\n0;1,2250\n\n5000;0,7361;\n;;\n10000;0,4135\n",
        "US Standard Atmosphere 1976, excerpt\n\nAltitude;Density\nkm;kg/m^3\n0;1.2250\n5;0.7361\n10;0.4135\n",
        "# Altitude, density\n# km, kg/m3\n0,1.2250\n5,0.7361\n10,0.4135\n",
        "% alt_m rho_kgm3\n0 1.2250\n5000 0.7361\n10000 0.4135\n",
        "rho (kg/m3) | altitude (m)\n-----------|-----\n1.2250 | 0\n0.7361 | 5000\n0.4135 | 10000\n",
        "\"altitude (m)\",\"density (kg/m3)\"\n\"0\",\"1.2250\"\n\"5,000\",\"0.7361\"\n\"10,000\",\"0.4135\"\n",
        "altitude (m)\tdensity (kg/m3)\n0\t1.2250\n5,000\t0.7361\n10,000\t0.4135\n",
        "altitude (m);density (kg/m3)\n0;1,2250\n5.000;0,7361\n10.000;0,4135\n",
        "altitude (m);density (kg/m3)\n0,0;1,2250\n5.000,0;0,7361\n10.000,0;0,4135\n",
        "altitude (m);density (kg/m3)\n0;1,2250\n5\u{a0}000;0,7361\n10\u{202f}000;0,4135\n",
        "z, m, rho, kg/m3\n0, 1.2250\n5000, 0.7361\n10000, 0.4135\n",
        "name,altitude_m,density_kg_m3,speed_of_sound_m_s\nground,0,1.2250,340.3\nhigh,5000,0.7361,320.5\nhigher,10000,0.4135,299.5\n",
        "H [km];rho [kg/m3];z [m]\n9;1.2250;0\n9;0.7361;5000\n9;0.4135;10000\n\nSource: none\n",
        "altitude_m,density_kg_m3\n0,1.2250\n2500,\n5000,0.7361\n7500,-9999\n10000,0.4135\n12500,nan\n",
    ] {
        same(&air(text).rows, &AIR);
    }
    for text in [
        "altitude_m,density_kg_m3,temperature_K\n0,1.225,288.15\n5000,0.7361,255.65\n10000,0.4135,223.15\n",
        "\u{feff}T [°C];altitude [km];density [kg/m³]\n15,0;0;1,2250\n-17,5;5;0,7361\n\n-50,0;10;0,4135\n",
        "# made by hand\n# Z, km\tT, F\trho, g/m3\n10\t-58\t413.5\n5\t0.5\t736.1\n0\t\t59\t1225\n",
    ] {
        same(&air(text).rows, &WARM_AIR);
    }
}

#[test]
fn each_kind_of_table_in_each_encoding() {
    let tables = [
        (
            "atmosphere.file",
            "altitude [m];density [kg/m³]\n0;1,2250\n5000;0,7361\n",
        ),
        (
            "wind.file",
            "Höhe [m];u [m/s];v [m/s]\n0;1,5;2\n5000;2,5;3\n",
        ),
        ("vehicle.drag_file", "§ Mach;cw\n0,5;1,25\n2,0;1,5\n"),
        ("vehicle.bank_file", "§ t [s];bank [°]\n0,0;1,25\n2,0;1,5\n"),
        (
            "vehicle.aerodynamics.file",
            "mach;α [°];ca;cn\n1,5;0;1,4;0\n1,5;10;1,3;0,1\n",
        ),
    ];
    for (key, text) in tables {
        let plain = read(key, text.as_bytes(), &earth())
            .unwrap_or_else(|faults| panic!("{key}: {faults:?}"));
        let units: Vec<u16> = text.encode_utf16().collect();
        let le: Vec<u8> = units.iter().flat_map(|unit| unit.to_le_bytes()).collect();
        let be: Vec<u8> = units.iter().flat_map(|unit| unit.to_be_bytes()).collect();
        let mut files = vec![
            [b"\xef\xbb\xbf", text.as_bytes()].concat(),
            [&[0xff, 0xfe][..], &le].concat(),
            [&[0xfe, 0xff][..], &be].concat(),
        ];
        if !text.contains('α') {
            files.push(
                text.chars()
                    .map(|c| u8::try_from(u32::from(c)).unwrap())
                    .collect(),
            );
        }
        for file in files {
            assert_eq!(
                read(key, &file, &earth()).unwrap().rows,
                plain.rows,
                "{key}"
            );
        }
    }
}

#[test]
fn what_was_decided_is_told() {
    let remarks = air("name,altitude (m),density (kg/m3),a (m/s)\nx,\"10,000\",0.4135,1\ny,\"5,000\",0.7361,1\nz,2500,,1\nw,0,1.2250,1\nend of the table\n").remarks;
    let wanted = [
        "column",
        "line 6 below",
        "commas group the thousands of the altitude, such as 10,000 in line 2",
        "1 row with a blank in a column that is read left out, the first in line 4",
        "the rows descend in altitude and are turned round",
    ];
    for (remark, wanted) in remarks.iter().zip(wanted) {
        assert!(remark.starts_with(wanted), "{remarks:?}");
    }
    assert_eq!(remarks.len(), wanted.len(), "{remarks:?}");
    assert_eq!(remarks[0], "columns left out: \"name\", \"a (m/s)\"");
    assert_eq!(
        air("0,1.2\n5,0.7\n").remarks,
        ["the file names no columns; they are taken as altitude (m), density (kg/m3)"]
    );
    assert!(
        air("altitude_m,density_kg_m3\n0,1.2\n5,0.7\n")
            .remarks
            .is_empty()
    );
}

#[test]
fn what_can_be_read_in_two_ways_is_refused_with_its_line() {
    let said = |text: &str| faults("atmosphere.file", text).join("\n");
    // thousands or decimals, with nothing to tell them apart
    assert!(
        said("z (m)\trho (kg/m3)\n0\t1,225\n1000\t1,112\n").starts_with("line 2: got \"1,225\"")
    );
    // both signs
    assert!(said("z (m)\trho (kg/m3)\n0.5\t1,2250\n").contains("both signs"));
    // not an altitude, or one in km
    assert!(
        said("z (m)\trho (kg/m3)\tT (K)\n0\t1,225\t288.15\n1000\t1,112\t281.65\n")
            .starts_with("line 2: got \"1,225\"")
    );
    assert!(
        said("z (km)\trho (kg/m3)\n0\t1.2250\n5,000\t0.7361\n")
            .starts_with("line 3: got \"5,000\"")
    );
    assert!(
        said("z (m)\trho (kg/m3)\n0.5\t1.2250\n5,000\t0.7361\n")
            .starts_with("line 3: got \"5,000\"")
    );
    let aero =
        "mach;alpha_deg;ca;cn\n1;0;1.400;0\n1;30;1,212;0.250\n20;0;1.400;0\n20;30;1,212;0.250\n";
    assert!(faults("vehicle.aerodynamics.file", aero)[0].starts_with("line 3: got \"1,212\""));
    // columns that nothing names, or that are not those of an atmosphere
    assert!(
        said("# Z, foo, bar\n0,200,358\n1,200,300\n")
            .contains("header: got \"Z\", \"foo\", \"bar\"")
            || said("# Z, foo, bar\n0,200,358\n1,200,300\n").contains("no column for density")
    );
    assert!(said("0,200.0,0.5\n1,210.0,0.4\n").contains("grows with height"));
    assert!(said("1 2 3 4 5\n6 7 8 9 10\n").contains("no heading names them"));
    assert!(said("furlongs,weight\n0,1\n").contains("got \"furlongs\", \"weight\""));
    assert!(
        said("altitude (furlong),humidity\n0,1\n")
            .contains("got the unit \"furlong\", must be one of m, km, ft, kft")
    );
    assert_eq!(
        said("altitude_m,temperature_K\n0,288\n"),
        "header: no column for density"
    );
    assert!(said("altitude_m,altitude_km,density_kg_m3\n0,0,1\n").contains("a second time"));
    assert!(
        said("altitude_m,density_kg_m3\n(m),(pounds)\n0,1.2\n").contains("line 2: neither units")
    );
    assert!(
        said("z (m),rho (kg/m3)\n0,1\n2000,0.5\n1000,0.7\n3000,0.3\n")
            .contains("line 4: altitude 1000 after 2000")
    );
    assert!(said("H (m),rho (kg/m3)\n0,1\n2000,0.5\n").contains("H is geopotential"));
}

#[test]
fn faults_name_line_column_and_text() {
    assert_eq!(
        faults(
            "atmosphere.file",
            "altitude_m,density_kg_m3\n0,1.2\n1000,dense\n2000,thin\n"
        ),
        [
            "line 3: column 2: got \"dense\", must be a number",
            "line 4: column 2: got \"thin\", must be a number"
        ]
    );
    assert_eq!(
        faults("atmosphere.file", "# nothing\n\n"),
        ["the file holds no row of numbers"]
    );
    assert_eq!(
        faults("atmosphere.file", "a\0b"),
        ["is not text: byte 2 is a control character"]
    );
}

#[test]
fn what_is_no_table_is_not_shown() {
    let passwd =
        "root:x:0:0:root:/root:/bin/bash\ndaemon:x:1:1:daemon:/usr/sbin:/usr/sbin/nologin\n";
    for key in FILES {
        assert_eq!(
            faults(key, passwd),
            ["the file holds no row of numbers"],
            "{key}"
        );
    }
}

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
    let table = read("atmosphere.file", text.as_bytes(), &mars()).unwrap();
    // mean radius (2 × 3396190 + 3376200)/3 = 3389526.67 m: z = 72518.99 m
    assert!((table.rows[1][0] - 72_519.0).abs() < 0.1, "{table:?}");
    // where both stand, the geometric one counts
    let both =
        air("geopotential altitude (m),altitude (m),rho (kg/m3)\n0,0,1.2\n71000,71802,6e-5\n");
    assert_eq!(both.rows[1][0], 71_802.0);
    let plain = read(
        "atmosphere.file",
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
        read("atmosphere.file", text.as_bytes(), &earth())
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
    // too low to tell
    let low = "H (m), p (Pa), rho (kg/m3)\n0, 101325, 1.225\n1000, 89876, 1.1117\n";
    assert_eq!(
        read("atmosphere.file", low.as_bytes(), &earth()),
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
    let wind = read("wind.file", listing.as_bytes(), &earth()).unwrap();
    // 10 kt from the west go east
    assert!(
        (wind.rows[2][1] - 10.0 * 1852.0 / 3600.0).abs() < 1e-12 && wind.rows[2][2].abs() < 1e-12,
        "{wind:?}"
    );
    let unknown = read(
        "atmosphere.file",
        b"p (Pa),z (m),T (K)\n600,0,210\n300,7000,200\n",
        &mars(),
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
            "atmosphere.file",
            "pressure altitude (m),p (Pa)\n0,1\n1,2\n"
        )[0]
        .contains("no column for density")
            || faults(
                "atmosphere.file",
                "pressure altitude (m),p (Pa)\n0,1\n1,2\n"
            )[0]
            .contains("give temperature")
    );
    let text = b"pressure altitude (m),T (K)\n0,1\n1,2\n";
    assert!(
        read("atmosphere.file", text, &mars()).unwrap_err()[0]
            .to_string()
            .contains("of the Earth")
    );
}

#[test]
fn curves_of_drag_and_bank() {
    let of = |key: &str, text: &str| read(key, text.as_bytes(), &earth()).unwrap();
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
        faults("vehicle.drag_file", "1,0.5\n3,0.4\n2,0.6\n")[0]
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

#[test]
fn aerodynamic_tables() {
    let of = |text: &str| {
        read("vehicle.aerodynamics.file", text.as_bytes(), &earth())
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
        "vehicle.aerodynamics.damping_file",
        b"mach,alpha_deg,cmq\n1,0,-0.1\n2,0,-0.2\n",
        &earth(),
    );
    assert_eq!(damping.unwrap().rows, [[1.0, 0.0, -0.1], [2.0, 0.0, -0.2]]);
}

#[test]
fn faults_of_aerodynamic_tables() {
    let said = |text: &str| faults("vehicle.aerodynamics.file", text);
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

#[test]
fn ten_megabytes_of_garbage_make_a_hundred_faults_at_most() {
    let garbage = "1;2;3\n1;x;y\n".repeat(200_000);
    let found = faults("atmosphere.file", &format!("altitude;density;t\n{garbage}"));
    assert!(
        (2..=MOST_FAULTS + 2).contains(&found.len()),
        "{}",
        found.len()
    );
    for garbage in ["\u{2}ÿ,\"", "\",", "1,\"", "1 ", "-", "1e9999,", ";;;1"] {
        let text = garbage.repeat(200_000);
        let _ = read("atmosphere.file", text.as_bytes(), &earth());
        let _ = read("vehicle.aerodynamics.file", text.as_bytes(), &earth());
    }
}
