//! `msape aero`: coefficients over the angle of attack.

use crate::{folder, msape, msape_with, path};
use serde_json::Value;
use std::fs;

const OUTLINE: &str = "schema = 'msape/1'\n[outline]\ncone_half_angle_deg = 60.0\ndiameter_m = 1.0\nnose_radius_m = 0.25\nshoulder_radius_m = 0.035\n";

fn object(arguments: &[&str], case: &str) -> Value {
    let mut all = vec!["aero", "-", "--json"];
    all.extend(arguments);
    let finished = msape_with(&all, case.as_bytes());
    assert_eq!((finished.code, finished.err.as_str()), (Some(0), ""));
    serde_json::from_str(&finished.out).unwrap()
}

fn array(object: &Value, key: &str) -> Vec<f64> {
    let list = object["results"][key].as_array().unwrap();
    list.iter().map(|value| value.as_f64().unwrap()).collect()
}

#[test]
fn arrays_as_long_as_the_list_of_angles_and_no_moment_without_a_center_of_gravity() {
    let newton = object(&["--regime", "newtonian", "--alpha", "0,30,180"], OUTLINE);
    assert_eq!(array(&newton, "alpha_deg"), [0.0, 30.0, 180.0]);
    // an independent panel method: 1.46939, 1.16772, −1.90821 and −0.17332, with discretization errors within 1e-3
    for (got, want) in array(&newton, "ca")
        .iter()
        .zip([1.46939, 1.16772, -1.90821])
    {
        assert!((got - want).abs() < 1e-3, "{got}");
    }
    assert!((array(&newton, "cm_apex")[1] + 0.17332).abs() < 1e-3);
    assert_eq!(newton["results"]["cm_cg"], Value::Null);
    let keys = ["ca", "cn", "cm_apex", "cd", "cl"];
    assert!(keys.iter().all(|key| array(&newton, key).len() == 3));
    let cg = format!("{OUTLINE}[vehicle]\ncg_m = [0.2, 0.0, 0.0]\n");
    let free = object(&["--regime", "free-molecular", "--alpha", "0,90"], &cg);
    // C_m about 0.2 diameters at 90 deg: −0.02065
    assert!((array(&free, "cm_cg")[1] + 0.02065).abs() < 1e-3);
    // specular in the cold limit; a disc of the same outline would have 4; half accommodation lies above full
    let wall = object(
        &[
            "--regime",
            "free-molecular",
            "--alpha",
            "0",
            "--accommodation",
            "0.5",
        ],
        &cg,
    );
    let of_case = format!("{cg}aerodynamics.accommodation = 0.5\n");
    let same = object(&["--regime", "free-molecular", "--alpha", "0"], &of_case);
    assert_eq!(array(&wall, "ca"), array(&same, "ca"));
    assert!(array(&wall, "ca")[0] > array(&free, "ca")[0]);
    let halved = object(
        &[
            "--regime",
            "newtonian",
            "--alpha",
            "0",
            "--pressure-coefficient-max",
            "1",
        ],
        OUTLINE,
    );
    assert!((array(&halved, "ca")[0] - 0.5 * array(&newton, "ca")[0]).abs() < 1e-12);
    // C_p,max(10) = 1.8322 of Rayleigh's formula
    let mach = object(
        &["--regime", "newtonian", "--alpha", "0", "--mach", "10"],
        OUTLINE,
    );
    assert!((array(&mach, "ca")[0] / array(&halved, "ca")[0] - 1.8322).abs() < 1e-3);
}

#[test]
fn a_named_database_has_its_axial_force_and_says_what_is_assumed() {
    let case = format!("{OUTLINE}[vehicle]\naerodynamics = 'mmeev-60'\n");
    let blended = object(&["--mach", "24.7", "--alpha", "0,-10,10"], &case);
    let (ca, cn) = (array(&blended, "ca"), array(&blended, "cn"));
    assert!((ca[0] - 1.4816).abs() < 1e-12, "{ca:?}");
    assert!(ca[1] == ca[2] && cn[1] == -cn[2]);
    let said = blended["findings"].to_string();
    assert!(said.contains("placeholder, assumed"), "{said}");
}

#[test]
fn a_design_brings_its_outline_and_center_of_gravity() {
    let finished = msape(&[
        "aero",
        "cases/msr-eev-cp.toml",
        "--regime",
        "newtonian",
        "--alpha",
        "0:20:10",
        "--csv",
    ]);
    assert_eq!(finished.code, Some(0));
    let mut lines = finished.out.lines();
    assert_eq!(
        lines.next(),
        Some("alpha_deg,ca,cn,cm_apex,cm_cg,cd,cl,cmq")
    );
    let cells: Vec<&str> = lines.last().unwrap().split(',').collect();
    assert!(cells[0] == "20" && cells[4].parse::<f64>().unwrap() < 0.0);
}

#[test]
fn a_table_of_ones_own_is_read_checked_and_extrapolated_as_asked() {
    let folder = folder("aero-table");
    let case = folder.join("case.toml");
    let text = format!("{OUTLINE}[vehicle.aerodynamics]\nfile = 'table.csv'\n");
    fs::write(&case, &text).unwrap();
    fs::write(
        folder.join("table.csv"),
        "mach,alpha_deg,cd,cl\n1,0,1.0,0\n1,10,1.1,-0.1\n2,0,1.5,0\n2,10,1.6,-0.2\n",
    )
    .unwrap();
    let ask = |mach: &str, rule: &str| {
        let rule = format!("vehicle.aerodynamics.extrapolation={rule}");
        msape(&[
            "aero",
            path(&case),
            "--mach",
            mach,
            "--alpha",
            "0",
            "--json",
            "--set",
            &rule,
        ])
    };
    let ca = |finished: &str| array(&serde_json::from_str(finished).unwrap(), "ca")[0];
    assert!((ca(&ask("1.5", "hold").out) - 1.25).abs() < 1e-12);
    assert!((ca(&ask("3", "hold").out) - 1.5).abs() < 1e-12);
    assert!((ca(&ask("3", "extend").out) - 2.0).abs() < 1e-12);
    let refused = ask("3", "refuse");
    assert_eq!(refused.code, Some(2));
    assert!(
        refused
            .err
            .contains("Mach number 3, the table runs from 1 to 2"),
        "{}",
        refused.err
    );
    fs::write(
        folder.join("table.csv"),
        "mach,alpha_deg,ca,cn\n2,0,1.5,0\n1,0,1,0\n1,-10,,0.1\n",
    )
    .unwrap();
    let faulty = msape(&["aero", path(&case), "--mach", "1", "--json"]);
    assert_eq!((faulty.code, faulty.out.as_str()), (Some(2), ""));
    assert!(
        faulty.err.contains("table.csv: line 4: column 3: got \"\""),
        "{}",
        faulty.err
    );
}

#[test]
fn every_fault_at_once() {
    let finished = msape_with(
        &[
            "aero",
            "-",
            "--mach=-1",
            "--knudsen",
            "nan",
            "--alpha",
            "0,200,x",
        ],
        b"schema = 'msape/1'\n[outline]\ncone_half_angle_deg = 60.0\n",
    );
    assert_eq!((finished.code, finished.out.as_str()), (Some(2), ""));
    for part in [
        "--mach",
        "--knudsen",
        "\"200\"",
        "\"x\"",
        "outline.diameter_m",
    ] {
        assert!(finished.err.contains(part), "{part}: {}", finished.err);
    }
    let nothing = msape_with(
        &["aero", "-", "--mach", "5"],
        b"schema = 'msape/1'\nname = 'a'\n",
    );
    assert_eq!(nothing.code, Some(2));
    assert!(nothing.err.contains("outline: missing"), "{}", nothing.err);
}
