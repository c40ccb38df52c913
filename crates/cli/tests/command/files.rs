//! Files that a case names, in any dialect and at any place.

use crate::{M2, folder, msape, msape_with, path, root};
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

/// A drop from 5 km through the atmosphere of a file, with its initial state.
pub const DROP: &str = "schema = \"msape/1\"
[entry]
planet = \"earth\"
altitude_m = 5000.0
latitude_deg = 0.0
longitude_deg = 0.0
speed_m_s = 0.0
flight_path_angle_deg = 0.0
azimuth_deg = 90.0
[heating]
radiative = \"none\"
[stop]
time_s = 1.0
[vehicle]
mass_kg = 100.0
reference_area_m2 = 1.0
nose_radius_m = 0.5
drag_coefficient = 1.0
";

/// A case with text appended.
pub fn with(case: &str, extra: &str) -> String {
    format!("{case}{extra}\n")
}

/// Answer of a case in `folder` that names its atmosphere file.
fn flown(here: &Path, case: &str) -> Result<Value, String> {
    let file = here.join("case.toml");
    fs::write(&file, case).unwrap();
    let finished = msape(&["fly", path(&file), "--json", "--trajectory"]);
    match finished.code {
        Some(0) => Ok(serde_json::from_str(&finished.out).unwrap()),
        code => {
            assert_eq!(
                (code, finished.out.as_str()),
                (Some(2), ""),
                "{}",
                finished.err
            );
            Err(finished.err)
        }
    }
}

fn density(here: &Path, name: &str, air: &[u8]) -> Result<(f64, f64, String), String> {
    fs::write(here.join(name), air).unwrap();
    let case = with(DROP, &format!("[atmosphere]\nfile = \"{name}\""));
    let answer = flown(here, &case)?;
    let first = |key: &str| answer["trajectory"][key][0].as_f64().unwrap();
    let findings = answer["findings"].to_string();
    Ok((first("density_kg_m3"), first("temperature_k"), findings))
}

#[test]
fn an_atmosphere_of_every_dialect_has_the_same_density() {
    let here = folder("dialects");
    let files: [(&str, &[u8]); 10] = [
        ("cp1252.csv", b"altitude [m];density [kg/m\xb3];T [\xb0C]\n0;1,2250;15,0\n5000;0,7361;-17,5\n10000;0,4135;-50,0\n"),
        ("bom.csv", "\u{feff}altitude [km];density [kg/m³];T [°C]\r\n0;1,2250;15,0\r\n5;0,7361;-17,5;\r\n\r\n10;0,4135;-50,0\r\n".as_bytes()),
        ("air.txt", b"  0.0   1.2250\n 5000.0  0.7361\n10000.0  0.4135\n"),
        ("extra.csv", b"altitude_m,density_kg_m3,temperature_K,pressure_Pa,speed_of_sound_m_s\n0,1.2250,288.15,101325,340.3\n5000,0.7361,255.65,54020,320.5\n"),
        ("descending.csv", b"altitude_m,density_kg_m3\n10000,0.4135\n5000,0.7361\n0,1.2250\n"),
        ("quoted.csv", b"\"altitude (m)\",\"density (kg/m3)\"\n\"0\",\"1.2250\"\n\"5,000\",\"0.7361\"\n\"10,000\",\"0.4135\"\n"),
        ("thousands.tsv", b"altitude (m)\tdensity (kg/m3)\n0\t1.2250\n5,000\t0.7361\n10,000\t0.4135\n"),
        ("sounding.csv", b"pressure_hPa,height_m,temperature_C\n1013.25,0,15\n540.2,5000,-17.5\n264.4,10000,-49.9\n"),
        ("commented.dat", b"# Z, m\tT, K\tp, Pa\trho, kg/m3\n0\t288.15\t101325\t1.2250\n5000\t255.65\t54020\t0.7361\n10000\t223.15\t26436\t0.4135\n"),
        ("g.csv", b"altitude (km);rho [g cm^-3]\n0;1,2250e-3\n5;0,7361e-3\n10;0,4135e-3\n"),
    ];
    for (name, air) in files {
        let (density, temperature, _) =
            density(&here, name, air).unwrap_or_else(|fault| panic!("{name}: {fault}"));
        assert!((density - 0.7361).abs() < 1e-4, "{name}: {density}");
        assert!((temperature - 255.65).abs() < 0.05, "{name}: {temperature}");
    }
    let (.., findings) = density(&here, "extra.csv", files[3].1).unwrap();
    assert!(
        findings.contains("extra.csv: column left out: \\\"speed_of_sound_m_s\\\"."),
        "{findings}"
    );
}

#[test]
fn what_may_be_two_things_is_refused_with_its_line() {
    let here = folder("doubtful");
    let said = |air: &str| density(&here, "air.csv", air.as_bytes()).unwrap_err();
    assert!(
        said("z (m)\trho (kg/m3)\n0\t1,225\n9000\t1,112\n")
            .contains("atmosphere.file: air.csv: line 2: got \"1,225\"")
    );
    assert!(said("z (m);rho (kg/m3)\n0.5;1,2250\n9000;1,1125\n").contains("both signs"));
    assert!(said("H (m),rho (kg/m3)\n0,1.225\n11000,0.3639\n").contains("geopotential"));
    fs::write(
        here.join("t.csv"),
        "mach;alpha_deg;ca;cn\n1;0;1.400;0\n1;30;1,212;0.250\n20;0;1.400;0\n20;30;1,212;0.250\n",
    )
    .unwrap();
    let case = with(
        &DROP.replace("drag_coefficient = 1.0\n", ""),
        "[vehicle.aerodynamics]\nfile = \"t.csv\"",
    );
    assert!(
        flown(&here, &case)
            .unwrap_err()
            .contains("line 3: got \"1,212\"")
    );
}

#[test]
fn geopotential_altitude_is_converted() {
    let here = folder("geopotential");
    let air = "geopotential altitude (m),rho (kg/m3)\n0,1.225000e+00\n51000,8.616060e-04\n71000,6.421100e-05\n79000,1.847490e-05\n";
    fs::write(here.join("air.csv"), air).unwrap();
    let case = DROP.replace("altitude_m = 5000.0", "altitude_m = 71802.0");
    let answer = flown(&here, &with(&case, "[atmosphere]\nfile = \"air.csv\"")).unwrap();
    let density = answer["trajectory"]["density_kg_m3"][0].as_f64().unwrap();
    assert!((density / 6.4211e-5 - 1.0).abs() < 1e-5, "{density}");
}

#[test]
fn drag_wind_and_bank_come_from_files() {
    let here = folder("curves");
    let free = DROP
        .replace("drag_coefficient = 1.0\n", "")
        .replace("speed_m_s = 0.0", "speed_m_s = 600.0")
        .replace("[stop]", "[solver]\ntolerance = 1e-12\n[stop]");
    fs::write(
        here.join("drag.csv"),
        "0.01,0.33\n0.5,0.38\n1.0,0.63\n2.0,0.51\n",
    )
    .unwrap();
    fs::write(
        here.join("wind.csv"),
        "Altitude (ft);Speed (kt);Direction (deg)\n0;19,43844;270\n30000;19,43844;270\n",
    )
    .unwrap();
    fs::write(here.join("bank.txt"), "t (s)  bank (deg)\n0  30\n10  30\n").unwrap();
    let rows = "drag_table = [[0.01, 0.33], [0.5, 0.38], [1.0, 0.63], [2.0, 0.51]]\nbank_deg = 30.0\nlift_to_drag = 0.3\n[wind]\neastward_m_s = 10.0";
    let by_rows = flown(&here, &with(&free, rows)).unwrap();
    for key in ["drag_file = \"drag.csv\"\n", ""] {
        let aerodynamics = if key.is_empty() {
            "[vehicle.aerodynamics]\nfile = \"drag.csv\"\n"
        } else {
            ""
        };
        let files = format!(
            "{key}bank_file = \"bank.txt\"\nlift_to_drag = 0.3\n{aerodynamics}[wind]\nfile = \"wind.csv\""
        );
        let by_files = flown(&here, &with(&free, &files)).unwrap();
        for result in [
            "final_speed_m_s",
            "final_latitude_deg",
            "final_longitude_deg",
            "peak_deceleration_earth_g",
        ] {
            let value = |answer: &Value| answer["results"][result].as_f64().unwrap();
            let (rows, files) = (value(&by_rows), value(&by_files));
            assert!(
                (rows - files).abs() <= 1e-6 * rows.abs(),
                "{result}: {rows} {files}"
            );
        }
    }
    let twice = with(&free, "drag_file = \"drag.csv\"\ndrag_table = [[0.0, 1.0]]");
    assert!(
        flown(&here, &twice)
            .unwrap_err()
            .contains("there is a vehicle.drag_table as well")
    );
}

#[test]
fn files_are_read_below_the_folder_of_the_case() {
    let all = folder("root");
    let here = all.join("cases");
    fs::create_dir_all(here.join("data")).unwrap();
    let air = "altitude_m,density_kg_m3\n0,1.2250\n5000,0.7361\n10000,0.4135\n";
    fs::write(all.join("air.csv"), air).unwrap();
    fs::write(here.join("data/air.csv"), air).unwrap();
    let case = |name: &str| with(DROP, &format!("[atmosphere]\nfile = \"{name}\""));
    let said = |name: &str| flown(&here, &case(name)).unwrap_err();
    assert!(flown(&here, &case("data/air.csv")).is_ok());
    assert!(flown(&here, &case("../cases/data/air.csv")).is_ok());
    let secret = path(&all).to_string() + "/air.csv";
    for name in [
        "../air.csv",
        &secret,
        "/etc/passwd",
        "/proc/self/environ",
        "../../../../../../etc/passwd",
        "/nowhere/at/all",
        "data/../../air.csv",
    ] {
        let said = said(name);
        assert!(
            said.contains("lies outside of the folder of the case"),
            "{name}: {said}"
        );
        assert_eq!(said.lines().count(), 1, "{said}");
    }
    let file = here.join("case.toml");
    fs::write(&file, case("../air.csv")).unwrap();
    assert_eq!(
        msape(&["fly", path(&file), "--root", path(&all)]).code,
        Some(0)
    );
    fs::write(&file, case("air.csv")).unwrap();
    assert_eq!(
        msape(&["fly", path(&file), "--root", path(&all)]).code,
        Some(0)
    );
    fs::write(&file, case("/etc/passwd")).unwrap();
    let refused = msape(&["fly", path(&file), "--root", path(&all)]);
    assert!(
        refused.code == Some(2) && refused.err.contains("lies outside"),
        "{}",
        refused.err
    );
    // a file named on the command line may lie anywhere
    fs::write(&file, DROP).unwrap();
    let named = format!("atmosphere.file={secret}");
    assert_eq!(msape(&["fly", path(&file), "--set", &named]).code, Some(0));
}

#[cfg(unix)]
#[test]
fn links_pipes_and_devices_are_no_way_around() {
    use std::os::unix::fs::symlink;
    let all = folder("links");
    let here = all.join("cases");
    fs::create_dir_all(&here).unwrap();
    symlink("/etc/passwd", here.join("x.csv")).unwrap();
    symlink("/dev/zero", here.join("zero.csv")).unwrap();
    assert!(
        std::process::Command::new("mkfifo")
            .arg(here.join("pipe.csv"))
            .status()
            .unwrap()
            .success()
    );
    let said = |key: &str, name: &str| {
        flown(&here, &with(DROP, &format!("[{key}]\nfile = \"{name}\""))).unwrap_err()
    };
    for key in ["atmosphere", "wind", "outline"] {
        for (name, why) in [
            ("x.csv", "lies outside"),
            ("zero.csv", "lies outside"),
            ("pipe.csv", "is no regular file"),
            (".", "is a folder"),
        ] {
            let said = said(key, name);
            assert!(
                said.contains(why) && !said.contains("root:"),
                "{key} {name}: {said}"
            );
        }
    }
    let file = here.join("case.toml");
    fs::write(&file, DROP).unwrap();
    let device = msape(&["fly", path(&file), "--set", "atmosphere.file=/dev/stdin"]);
    assert!(
        device.code == Some(2) && device.err.contains("is no regular file"),
        "{}",
        device.err
    );
    // not even an allowed file is quoted if it is not a table
    let shown = msape(&["fly", path(&file), "--set", "atmosphere.file=/etc/passwd"]);
    assert_eq!(
        shown.err.trim_end(),
        "msape: atmosphere.file: /etc/passwd: the file holds no row of numbers"
    );
}

#[test]
fn a_key_that_stands_twice_is_refused() {
    let twice = |text: &str| {
        let finished = msape_with(&["fly", "-"], text.as_bytes());
        assert_eq!((finished.code, finished.out.as_str()), (Some(2), ""));
        finished.err
    };
    let entry = r#""schema": "msape/1", "entry": {"speed_m_s": 12900, "speed_m_s": 8000}"#;
    assert!(twice(&format!("{{{entry}}}")).contains("entry.speed_m_s: stands twice"));
    let mixed = r#""schema": "msape/1", "entry": {"speed_m_s": 12900}, "entry.speed_m_s": 8000"#;
    assert!(twice(&format!("{{{mixed}}}")).contains("entry.speed_m_s: stands twice"));
    let spellings =
        "schema = \"msape/1\"\n[planet]\nequatorial_radius_m = 1.0e6\nradius_m = 6378000.0\n";
    assert!(twice(spellings).contains("planet.equatorial_radius_m: stands twice, as planet."));
}

#[test]
fn what_is_long_is_neither_compared_nor_repeated() {
    let long = "k".repeat(1_000_000);
    let start = Instant::now();
    let case = format!(
        "schema = \"msape/1\"\n{long} = 1\n[entry]\nplanet = \"{long}\"\nspeed_m_s = \"{long}\"\n[atmosphere]\nfile = \"{long}\"\n"
    );
    let finished = msape_with(&["fly", "-"], case.as_bytes());
    assert_eq!(finished.code, Some(2));
    assert!(
        finished.err.lines().all(|line| line.chars().count() < 1000),
        "{}",
        finished.err
    );
    assert!(finished.err.contains(&format!("{}…", "k".repeat(100))));
    let setting = format!("entry.planet={}", "k".repeat(100_000));
    let finished = msape(&[
        "fly",
        M2,
        "--set",
        &setting,
        "--set",
        &setting.replace('=', ""),
    ]);
    assert!(
        finished.err.lines().all(|line| line.chars().count() < 1000),
        "{}",
        finished.err
    );
    assert!(
        start.elapsed() < Duration::from_secs(20),
        "{:?}",
        start.elapsed()
    );
}

#[test]
fn large_tables_and_many_keys_take_no_minutes() {
    let here = folder("large");
    let mut table = String::from("mach,alpha_deg,ca,cn\n");
    for n in 0..543 * 181 {
        let (mach, alpha) = (n / 181, n % 181 - 90);
        table.push_str(&format!("{mach},{alpha},1.0,0.0\n"));
    }
    fs::write(here.join("table.csv"), table).unwrap();
    let free = DROP.replace("drag_coefficient = 1.0\n", "");
    let case = with(&free, "[vehicle.aerodynamics]\nfile = \"table.csv\"");
    let start = Instant::now();
    // comparing each row with each other one took half a minute
    assert!(flown(&here, &case).is_ok());
    let mut scattered = String::from("mach,alpha_deg,ca,cn\n");
    for n in 0..100_000 {
        scattered.push_str(&format!("{},{},1.0,0.0\n", f64::from(n) / 100.0, n % 180));
    }
    fs::write(here.join("table.csv"), scattered).unwrap();
    assert!(flown(&here, &case).unwrap_err().contains("and "));
    let mut keys = String::from("schema = \"msape/1\"\n");
    for n in 0..4_900 {
        keys.push_str(&format!("[s{n}]\nk = 1\n"));
    }
    let finished = msape_with(&["fly", "-"], keys.as_bytes());
    assert!(
        finished.err.contains("and 4850 more unknown keys"),
        "{}",
        finished.err
    );
    let finished = msape_with(&["fly", "-"], "[s]\nk = 1\n".repeat(500_000).as_bytes());
    assert!(
        finished.err.contains("the file holds more than 10000 keys"),
        "{}",
        finished.err
    );
    assert!(
        start.elapsed() < Duration::from_secs(300),
        "{:?}",
        start.elapsed()
    );
}

#[test]
fn a_case_may_be_utf_16_with_its_mark() {
    let text = fs::read_to_string(root().join(M2)).unwrap();
    let units = text.encode_utf16().flat_map(u16::to_le_bytes);
    let bytes: Vec<u8> = [0xff, 0xfe].into_iter().chain(units).collect();
    assert_eq!(
        msape_with(&["fly", "-", "--json"], &bytes).out,
        msape(&["fly", M2, "--json"]).out
    );
}
