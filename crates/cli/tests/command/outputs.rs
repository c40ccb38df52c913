//! Written files, and files left unchanged after an error.

use crate::files::{DROP, with};
use crate::{Finished, M2, command, folder, msape, path, root};
use serde_json::Value;
use std::fs;
use std::process::Stdio;
use std::time::{Duration, Instant};

#[cfg(unix)]
#[test]
fn output_never_takes_the_place_of_what_was_read_or_is_kept() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let here = folder("output");
    let case = here.join("case.toml");
    fs::write(
        here.join("air.csv"),
        "altitude_m,density_kg_m3\n0,1.2\n9000,0.4\n",
    )
    .unwrap();
    let text = with(DROP, "[atmosphere]\nfile = \"air.csv\"");
    fs::write(&case, &text).unwrap();
    fs::hard_link(&case, here.join("same.toml")).unwrap();
    symlink("case.toml", here.join("link.toml")).unwrap();
    symlink("nothing", here.join("dangling")).unwrap();
    fs::write(here.join("kept.json"), "kept").unwrap();
    fs::set_permissions(here.join("kept.json"), fs::Permissions::from_mode(0o444)).unwrap();
    for (name, why) in [
        ("case.toml", "the case itself"),
        ("same.toml", "the case itself"),
        ("link.toml", "the case itself"),
        ("air.csv", "a file that it names"),
        ("kept.json", "it is read-only"),
        ("dangling", "it is a link to nothing"),
        (".", "it is a folder"),
    ] {
        let finished = msape(&["fly", path(&case), "--json", "-o", path(&here.join(name))]);
        assert_eq!(finished.code, Some(2), "{name}");
        assert!(finished.err.contains(why), "{name}: {}", finished.err);
    }
    assert_eq!(fs::read_to_string(&case).unwrap(), text);
    assert_eq!(fs::read_to_string(here.join("kept.json")).unwrap(), "kept");
    assert!(
        fs::symlink_metadata(here.join("dangling"))
            .unwrap()
            .is_symlink()
    );
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_standard_error_changes_no_code() {
    let full = || Stdio::from(fs::File::options().write(true).open("/dev/full").unwrap());
    let bad = command(&["fly", M2, "--set", "vehicle.mass_kg=-1"])
        .stderr(full())
        .output()
        .unwrap();
    assert_eq!(bad.status.code(), Some(2));
    let nowhere = command(&["fly", M2, "--json"])
        .stdout(full())
        .stderr(full())
        .status()
        .unwrap();
    assert_eq!(nowhere.code(), Some(2));
    let wrong = command(&["flee"]).stderr(full()).status().unwrap();
    assert_eq!(wrong.code(), Some(2));
}

/// A closed descriptor differs from a discarded stream: a shell closes with `>&-`, while a shell's, Python's and Node's
/// "no output" open the null device.
#[cfg(unix)]
#[test]
fn a_closed_standard_output_is_told() {
    let shell = |redirection: &str, arguments: &str| -> Finished {
        let line = format!("exec \"$0\" {arguments} {redirection}");
        let mut shell = std::process::Command::new("sh");
        let run = shell.args(["-c", &line, env!("CARGO_BIN_EXE_msape")]);
        run.current_dir(root()).output().unwrap().into()
    };
    let fly = format!("fly {M2} --json");
    for asked in [
        &fly,
        "schema",
        "quantities inputs",
        "validate galahad",
        "--version",
    ] {
        let closed = shell(">&-", asked);
        assert_eq!(closed.code, Some(1), "{asked}: {}", closed.err);
        assert!(
            closed.err.contains("standard output is closed"),
            "{}",
            closed.err
        );
    }
    assert_eq!(shell(">&- 2>&-", &fly).code, Some(1));
    for away in [">/dev/null", "<&- >/dev/null 2>&-", "1<>/dev/null"] {
        let done = shell(away, &fly);
        assert_eq!((done.code, done.err.as_str()), (Some(0), ""), "{away}");
    }
    // output to a file needs no standard output, and bad input is still reported
    let file = folder("closed").join("answer.json");
    let done = shell(">&-", &format!("{fly} -o {}", path(&file)));
    assert!(done.code == Some(0) && file.is_file(), "{}", done.err);
    let bad = shell(">&-", &format!("{fly} --set vehicle.mass_kg=-1"));
    assert_eq!(bad.code, Some(2), "{}", bad.err);
}

#[cfg(unix)]
#[test]
fn a_signal_leaves_no_unfinished_file() {
    for signal in ["INT", "TERM"] {
        let here = folder(&format!("signal-{signal}"));
        let out = here.join("history.csv");
        fs::write(&out, "old").unwrap();
        let mut child = command(&[
            "fly",
            "cases/stardust.toml",
            "--trajectory-step",
            "0.001",
            "--csv-si",
            "-o",
            path(&out),
        ])
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
        let names = || -> Vec<String> {
            let entries = fs::read_dir(&here).unwrap();
            entries
                .map(|entry| entry.unwrap().file_name().into_string().unwrap())
                .collect()
        };
        let start = Instant::now();
        while names().len() < 2 && start.elapsed() < Duration::from_secs(60) {
            std::thread::sleep(Duration::from_millis(2));
        }
        let pid = child.id().to_string();
        let sent = std::process::Command::new("kill")
            .args(["-s", signal, &pid])
            .status()
            .unwrap();
        assert!(sent.success());
        assert_eq!(child.wait().unwrap().code(), Some(130), "{signal}");
        assert_eq!(names(), ["history.csv"], "{signal}");
        assert_eq!(fs::read_to_string(&out).unwrap(), "old");
    }
}

/// Whether a process handles Ctrl-C.
#[cfg(target_os = "linux")]
fn hears_ctrl_c(process: u32) -> bool {
    let status = fs::read_to_string(format!("/proc/{process}/status")).unwrap_or_default();
    let caught = status.lines().find_map(|line| line.strip_prefix("SigCgt:"));
    let caught = caught.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    caught.is_some_and(|mask| mask & 2 != 0)
}

#[cfg(target_os = "linux")]
/// A design whose passes would go on for minutes.
const LONG: [&str; 7] = [
    "cases/run-page.toml",
    "--set",
    "design.max_iterations=10000",
    "--set",
    "design.relaxation=1e-6",
    "--set",
    "design.mass_criterion_kg=1e-15",
];

/// A command interrupted as soon as it handles Ctrl-C; begun again where it was finished before that.
#[cfg(target_os = "linux")]
fn interrupted(arguments: &[&str]) -> Finished {
    for _ in 0..10 {
        let mut child = command(arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let pid = child.id();
        let mut is_over = || child.try_wait().unwrap().is_some();
        while !hears_ctrl_c(pid) && !is_over() {
            std::thread::sleep(Duration::from_millis(1));
        }
        if !is_over() {
            let pid = pid.to_string();
            let sent = std::process::Command::new("kill")
                .args(["-s", "INT", &pid])
                .status();
            assert!(sent.unwrap().success());
        }
        let finished: Finished = child.wait_with_output().unwrap().into();
        if finished.code != Some(0) {
            assert_eq!(finished.code, Some(130), "{}", finished.err);
            return finished;
        }
    }
    panic!("{arguments:?} is always over before it can be stopped");
}

#[cfg(target_os = "linux")]
#[test]
fn ctrl_c_ends_a_long_design_and_keeps_what_is_done() {
    for entries in [None, Some("--reorientation")] {
        let mut arguments = vec!["design", "--json"];
        arguments.extend(LONG);
        arguments.extend(entries);
        let text = interrupted(&arguments).out;
        assert!(
            text.contains("gave-up") && text.contains("after which it was stopped"),
            "{text}"
        );
    }
}

#[cfg(target_os = "linux")]
#[test]
fn ctrl_c_ends_entries_and_comparisons_and_the_report_says_so() {
    let answer = |arguments: &[&str]| -> Value {
        let answer: Value = serde_json::from_str(&interrupted(arguments).out).unwrap();
        assert_eq!(answer["stopped"], true);
        answer
    };
    let rows = |answer: &Value| answer.as_array().unwrap().len();
    let entries = answer(&["reorientation", "cases/msr-eev-cp.toml", "--json"]);
    assert!(rows(&entries["reorientation"]["entries"]) < 9);
    assert!(rows(&answer(&["validate", "--json"])["rows"]) < 120);
    let text = interrupted(&["validate"]).out;
    assert!(text.contains("\nstopped after "), "{text}");
}

#[cfg(target_os = "linux")]
#[test]
fn ctrl_c_ends_the_design_of_an_export_and_nothing_is_written() {
    let out = folder("stopped").join("vehicle.step");
    let stopped = interrupted(&[&["export"], &LONG[..], &["-o", path(&out)]].concat());
    assert!(
        stopped.err.contains("stopped: nothing was written"),
        "{}",
        stopped.err
    );
    assert!(!out.exists());
}

#[test]
fn a_name_is_no_formula_and_no_command_of_a_terminal() {
    let named = |name: &str, form: &str| {
        let setting = format!("name={name}");
        let finished = msape(&["fly", M2, "--set", &setting, form]);
        assert_eq!(finished.code, Some(0), "{}", finished.err);
        finished.out
    };
    let csv = named("=HYPERLINK(\"http://x\",\"y\")", "--csv");
    assert!(csv.contains("\r\n\"'=HYPERLINK("), "{csv}");
    for form in ["--csv", "--csv-si"] {
        assert!(!named("a\u{1b}]0;b\u{7}\u{9b}2J", form).contains(['\u{1b}', '\u{7}', '\u{9b}']));
    }
    let text = msape(&["fly", M2, "--set", "name=a\u{1b}[2J\u{202e}b"]).out;
    assert!(!text.contains(['\u{1b}', '\u{202e}']), "{text}");
    let kml = named("a\u{fffe}\u{ffff}\u{1}\u{1b}<b>&", "--kml");
    assert!(kml.contains("<name>a&lt;b&gt;&amp;</name>"), "{kml}");
    let svg = msape(&[
        "export",
        "cases/run-page.toml",
        "--format",
        "svg",
        "--set",
        "name=a\u{fffe}\u{1b}b",
    ]);
    assert!(
        svg.code == Some(0) && !svg.out.contains(['\u{fffe}', '\u{1b}']),
        "{}",
        svg.err
    );
}
