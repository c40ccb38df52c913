//! All checks. Stages that need different parts of the build folder run side by side; those with a browser alone, because
//! their tests have time limits.

use std::{
    env,
    fs::{self, File},
    path::Path,
    process::Command,
    time::Instant,
};

use anyhow::{Context, Result, bail};

use crate::{
    build, cad, counts,
    project::{Project, announce, files_below, run},
    serve,
    setup::{self, WASM},
    sizes,
};

struct Stage {
    name: &'static str,
    set_up: Step,
    check: Step,
}

type Step = fn(&Project) -> Result<()>;

const STAGES: [Stage; 10] = [
    Stage {
        name: "fmt",
        set_up: setup::for_lints,
        check: format,
    },
    Stage {
        name: "clippy",
        set_up: setup::for_lints,
        check: lints,
    },
    Stage {
        name: "deny",
        set_up: |_| Ok(()),
        check: licenses_and_sources,
    },
    Stage {
        name: "native",
        set_up: |_| Ok(()),
        check: native,
    },
    Stage {
        name: "counts",
        set_up: setup::for_counts,
        check: counts::check,
    },
    Stage {
        name: "cad",
        set_up: setup::for_cad,
        check: cad::check,
    },
    Stage {
        name: "sizes",
        set_up: setup::for_build,
        check: |project| sizes::check(build::dist(project)?),
    },
    Stage {
        name: "browser",
        set_up: setup::for_browser,
        check: browser,
    },
    Stage {
        name: "e2e",
        set_up: setup::for_end_to_end,
        check: end_to_end,
    },
    Stage {
        name: "trunk",
        set_up: setup::for_trunk_tests,
        check: trunk,
    },
];

/// Stages that run side by side: the second list in a process of its own, whose output is printed when it ends.
const SIDE_BY_SIDE: [&[&str]; 2] = [
    &["fmt", "clippy", "deny", "native", "counts"],
    &["sizes", "browser", "cad"],
];
/// Stages that run alone, after those.
const ALONE: [&str; 2] = ["e2e", "trunk"];

/// Sets up the tools of the named stages, or of all; a tool that may not be installed is reported before the first
/// check.
pub fn set_up(project: &Project, names: &[&str]) -> Result<()> {
    if let Some(unknown) = names
        .iter()
        .find(|name| STAGES.iter().all(|stage| stage.name != **name))
    {
        let known = STAGES.map(|stage| stage.name).join(", ");
        bail!("no such stage: {unknown}; there are {known}");
    }
    chosen(names).try_for_each(|stage| (stage.set_up)(project))
}

/// Runs the named stages one after the other, or all, and stops at the first failure.
pub fn run_stages(project: &Project, names: &[&str]) -> Result<()> {
    set_up(project, names)?;
    if !names.is_empty() {
        return run_in_turn(project, names);
    }
    let [here, beside] = SIDE_BY_SIDE;
    let log = project.target.join("test.log");
    let output = File::create(&log).context("cannot write into the build folder")?;
    announce(format_args!(
        "Beside this, with output in {}: {}",
        log.display(),
        beside.join(" ")
    ));
    let mut other = Command::new(env::current_exe()?)
        .arg("test")
        .args(beside)
        .stdout(output.try_clone()?)
        .stderr(output)
        .spawn()
        .context("cannot start this program again")?;
    let passed = run_in_turn(project, here);
    if passed.is_err() {
        // it may have ended by itself
        other.kill().ok();
    }
    let status = other.wait()?;
    println!("\n{}", fs::read_to_string(&log)?);
    passed?;
    if !status.success() {
        bail!("one of {} failed: see above", beside.join(" "));
    }
    run_in_turn(project, &ALONE)
}

fn run_in_turn(project: &Project, names: &[&str]) -> Result<()> {
    let mut times = Vec::new();
    for stage in chosen(names) {
        announce(format_args!("Test stage {}", stage.name));
        let start = Instant::now();
        (stage.check)(project).with_context(|| format!("stage {} failed", stage.name))?;
        times.push((stage.name, start.elapsed()));
    }
    println!("\nPassed:");
    for (name, time) in times {
        println!("{:>7.0} s  {name}", time.as_secs_f64());
    }
    Ok(())
}

fn chosen(names: &[&str]) -> impl Iterator<Item = &'static Stage> {
    const { &STAGES }
        .iter()
        .filter(move |stage| names.is_empty() || names.contains(&stage.name))
}

fn format(project: &Project) -> Result<()> {
    run(project.command("cargo").args(["fmt", "--all", "--check"]))
}

fn lints(project: &Project) -> Result<()> {
    let clippy = |arguments: &[&str]| {
        let strict = ["--locked", "--all-targets", "--", "-D", "warnings"];
        run(project
            .command("cargo")
            .arg("clippy")
            .args(arguments)
            .args(strict))
    };
    // web-tools is two lines around a large crate
    clippy(&["--workspace", "--exclude", "msape-web-tools"])?;
    let [app, worker] = build::PACKAGES;
    clippy(&[
        "--package",
        app,
        "--package",
        worker,
        "--package",
        "msape-kit",
        "--target",
        WASM,
    ])
}

/// Checks the crates against `deny.toml`, without cargo-deny, which takes minutes to build.
fn licenses_and_sources(project: &Project) -> Result<()> {
    let tests = [
        "--locked",
        "--package",
        "msape-tests",
        "--test",
        "tidy",
        "deny",
    ];
    run(project.command("cargo").arg("test").args(tests))
}

fn native(project: &Project) -> Result<()> {
    let everything = ["--locked", "--workspace", "--exclude", "msape-web-tools"];
    run(project.command("cargo").arg("test").args(everything))
}

/// Parity tests and those of the kit, compiled for WebAssembly and run in Chromium.
fn browser(project: &Project) -> Result<()> {
    let driver =
        setup::program_of_tests(project, "chromedriver").context("chromedriver is missing")?;
    for [package, test] in [["msape-tests", "parity"], ["msape-kit", "plain"]] {
        let tests = ["--locked", "--package", package, "--test", test];
        run(project
            .command("cargo")
            .arg("test")
            .args(tests)
            .args(["--target", WASM])
            .env(
                "CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER",
                project.tools.join("wasm-bindgen-test-runner"),
            )
            .env("CHROMEDRIVER", &driver))?;
    }
    Ok(())
}

/// Tests of `tests/e2e`, against the app as it would be deployed.
fn end_to_end(project: &Project) -> Result<()> {
    sizes::check(build::dist(project)?)?;
    in_chromium(project, &project.dist, "tests/e2e")
}

/// The test of `tests/trunk`, against the app as Trunk builds it.
fn trunk(project: &Project) -> Result<()> {
    let programs = setup::for_trunk(project)?;
    let path = env::var_os("PATH").unwrap_or_default();
    let path = env::join_paths(std::iter::once(programs).chain(env::split_paths(&path)))?;
    run(project
        .command("trunk")
        .args(["build", "--release"])
        .env("PATH", path))?;
    in_chromium(project, &project.root.join("dist-trunk"), "tests/trunk")
}

/// Runs the tests of a folder with Node, against a served folder.
fn in_chromium(project: &Project, served: &Path, tests: &str) -> Result<()> {
    let address = serve::in_background(served)?;
    let chromium = setup::program_of_tests(project, "chromium").context("chromium is missing")?;
    let tests = files_below(&project.root.join(tests))?
        .into_iter()
        .filter(|file| {
            file.extension().is_some_and(|extension| extension == "mjs")
                && !file.ends_with("harness.mjs")
        });
    run(project
        .command("node")
        .arg("--test")
        .args(tests)
        .env("MSAPE_URL", format!("http://{address}/"))
        .env("CHROMIUM", chromium))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_stage_runs_once() {
        let mut run: Vec<&str> = [SIDE_BY_SIDE.concat(), ALONE.to_vec()].concat();
        let mut all: Vec<&str> = STAGES.iter().map(|stage| stage.name).collect();
        run.sort_unstable();
        all.sort_unstable();
        assert_eq!(run, all);
    }
}
