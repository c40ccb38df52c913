use super::*;
use std::sync::LazyLock;

mod kinds;
mod public;

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
    read(&input::atmosphere::FILE, text.as_bytes(), &earth())
        .unwrap_or_else(|faults| panic!("{text}: {faults:?}"))
}

fn faults(key: &Input, text: &str) -> Vec<String> {
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
        let input = input::find(key).unwrap();
        let plain = read(input, text.as_bytes(), &earth())
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
                read(input, &file, &earth()).unwrap().rows,
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
    assert_eq!(
        air("altitude,density (kg/m3)\n0,1.2\n5,0.7\n").remarks,
        ["the heading names no unit for what is taken as altitude (m)"]
    );
    assert!(
        air("altitude_m,density_kg_m3\n0,1.2\n5,0.7\n")
            .remarks
            .is_empty()
    );
}

#[test]
fn what_can_be_read_in_two_ways_is_refused_with_its_line() {
    let said = |text: &str| faults(&input::atmosphere::FILE, text).join("\n");
    // thousands or decimals, with nothing to distinguish them
    assert!(
        said("z (m)\trho (kg/m3)\n0\t1,225\n1000\t1,112\n").starts_with("line 2: got \"1,225\"")
    );
    // both signs
    assert!(said("z (m)\trho (kg/m3)\n0.5\t1,2250\n").contains("both signs"));
    // not an altitude, or an altitude in km
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
    assert!(
        faults(&input::vehicle::AERODYNAMICS_FILE, aero)[0].starts_with("line 3: got \"1,212\"")
    );
    // columns without names, or not those of an atmosphere
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
            &input::atmosphere::FILE,
            "altitude_m,density_kg_m3\n0,1.2\n1000,dense\n2000,thin\n"
        ),
        [
            "line 3: column 2: got \"dense\", must be a number",
            "line 4: column 2: got \"thin\", must be a number"
        ]
    );
    assert_eq!(
        faults(&input::atmosphere::FILE, "# nothing\n\n"),
        ["the file holds no row of numbers"]
    );
    assert_eq!(
        faults(&input::atmosphere::FILE, "a\0b"),
        ["is not text: byte 2 is a control character"]
    );
}

#[test]
fn what_is_no_table_is_not_shown() {
    let passwd =
        "root:x:0:0:root:/root:/bin/bash\ndaemon:x:1:1:daemon:/usr/sbin:/usr/sbin/nologin\n";
    for key in files() {
        assert_eq!(
            faults(key, passwd),
            ["the file holds no row of numbers"],
            "{key}"
        );
    }
}

#[test]
fn ten_megabytes_of_garbage_make_a_hundred_faults_at_most() {
    let garbage = "1;2;3\n1;x;y\n".repeat(200_000);
    let found = faults(
        &input::atmosphere::FILE,
        &format!("altitude;density;t\n{garbage}"),
    );
    assert!(
        (2..=MOST_FAULTS + 2).contains(&found.len()),
        "{}",
        found.len()
    );
    for garbage in ["\u{2}ÿ,\"", "\",", "1,\"", "1 ", "-", "1e9999,", ";;;1"] {
        let text = garbage.repeat(200_000);
        let _ = read(&input::atmosphere::FILE, text.as_bytes(), &earth());
        let _ = read(
            &input::vehicle::AERODYNAMICS_FILE,
            text.as_bytes(),
            &earth(),
        );
    }
}

#[test]
fn the_planet_is_the_one_that_the_case_flies_over() {
    let of = |text: &str| {
        let case = Case::from_text(&format!("schema = \"msape/1\"\n{text}")).unwrap();
        Ground::of(&case, &LIBRARY)
    };
    let mars = of("[entry]\nplanet = \"mars\"");
    assert!(mars.radius_m > 3.3e6 && mars.radius_m < 3.4e6 && mars.standard.is_none());
    for name in [" Mars ", "MARS"] {
        let same = of(&format!("[entry]\nplanet = \"{name}\""));
        assert_eq!(same.radius_m, mars.radius_m, "{name}");
        assert_eq!(same.gas_constant_j_kg_k, mars.gas_constant_j_kg_k, "{name}");
    }
    for radius in ["3000000.0", "\"3000 km\""] {
        let own = of(&format!("[planet]\nequatorial_radius_m = {radius}"));
        assert!(
            (own.radius_m - 3e6).abs() < 1e-6,
            "{radius}: {}",
            own.radius_m
        );
        assert!(own.standard.is_none() && own.gas_constant_j_kg_k.is_none());
    }
    assert_eq!(of("").radius_m, EARTH_RADIUS_M);
}

/// Unit after a comma, as in public files; a heading with another number of cells is not a title.
#[test]
fn a_heading_that_does_not_fit_its_columns_is_not_passed_over() {
    let rows = "0,1.225,340.3\n5000,0.7361,320.5\n10000,0.4135,299.5\n";
    let table = air(&format!(
        "Altitude[m], Density [kg/m3], Speed of sound, [m/s]\n{rows}"
    ));
    same(&table.rows, &AIR);
    for heading in [
        "altitude_m,density_kg_m3",
        "Altitude (m),Density (kg/m3),a,b",
    ] {
        let found = faults(&input::atmosphere::FILE, &format!("{heading}\n{rows}"));
        assert!(found[0].starts_with("line 1: got "), "{found:?}");
    }
}

#[test]
fn rows_for_one_input_are_read_as_its_columns_or_refused() {
    let read = |table: &Input, text: &str| {
        read_for(table, text.as_bytes(), &earth()).map(|read| read.rows)
    };
    let by_time = &input::vehicle::BANK_TABLE_DEG;
    let by_speed = &input::vehicle::BANK_SPEED_TABLE_DEG;
    // without heading, as copied from a German spreadsheet
    for table in [by_time, by_speed] {
        let rows = read(table, "10\t0,5\n20\t1,5\n").unwrap();
        same(&rows, &[&[10.0, 0.5], &[20.0, 1.5]]);
    }
    let both = "time_s,speed_m_s,bank_deg\n0,7000,10\n5,8000,20\n";
    same(&read(by_time, both).unwrap(), &[&[0.0, 10.0], &[5.0, 20.0]]);
    let rows = read(by_speed, both).unwrap();
    same(&rows, &[&[7000.0, 10.0], &[8000.0, 20.0]]);
    let refused = |faults: Vec<TableFault>| faults[0].to_string();
    let over_time = read(by_speed, "time_s,bank_deg\n0,10\n5,20\n").unwrap_err();
    assert_eq!(
        refused(over_time),
        format!("the columns are those of {by_time}, must be those of {by_speed}")
    );
    let over_speed = read(by_time, "speed_m_s,bank_deg\n7000,10\n8000,20\n").unwrap_err();
    assert!(refused(over_speed).contains(by_speed.key));

    let mut body = String::new();
    for point in ["0", "0,5", "1"] {
        for place in ["8000;0,0001", "8000;0,001", "9000;0,0001", "9000;0,001"] {
            body.push_str(&format!("{point};{place};200000;0\n"));
        }
    }
    for table in [&input::heating::RADIUS_TABLE, &input::heating::ARC_TABLE] {
        let rows = read(table, &body).unwrap();
        assert_eq!(rows[4], [0.5, 8e3, 1e-4, 2e5, 0.0]);
    }
    let drag = "mach,cd\n1,1.2\n5,1.4\n";
    let faults = read(&input::vehicle::AERODYNAMICS_TABLE, drag).unwrap_err();
    assert!(refused(faults).contains("those of vehicle.drag_table"));
}
