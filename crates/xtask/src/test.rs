//! All checks, in the order in which they fail soonest.

use std::time::Instant;

use anyhow::{Context, Result, bail};

use crate::{
    build,
    project::{Project, announce, files_below, run},
    serve,
    setup::{self, WASM},
    sizes,
};

type Stage = (&'static str, fn(&Project) -> Result<()>);

const STAGES: [Stage; 5] = [
    ("fmt", format),
    ("clippy", lints),
    ("native", native),
    ("browser", browser),
    ("e2e", end_to_end),
];

/// Runs the stages named, or all, and stops at the first that fails.
pub fn run_stages(project: &Project, names: &[&str]) -> Result<()> {
    if let Some(unknown) = names
        .iter()
        .find(|name| STAGES.iter().all(|(stage, _)| stage != *name))
    {
        let known = STAGES.map(|(stage, _)| stage).join(", ");
        bail!("no such stage: {unknown}; there are {known}");
    }
    setup::for_build(project)?;
    setup::for_tests(project)?;
    let mut times = Vec::new();
    for (name, stage) in STAGES
        .iter()
        .filter(|(name, _)| names.is_empty() || names.contains(name))
    {
        announce(format_args!("Test stage {name}"));
        let start = Instant::now();
        stage(project).with_context(|| format!("stage {name} failed"))?;
        times.push((name, start.elapsed()));
    }
    println!("\nAll stages passed:");
    for (name, time) in times {
        println!("{:>7.0} s  {name}", time.as_secs_f64());
    }
    Ok(())
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
    // web-tools is two lines around a large crate.
    clippy(&["--workspace", "--exclude", "msape-web-tools"])?;
    clippy(&["--package", "msape-web", "--target", WASM])
}

fn native(project: &Project) -> Result<()> {
    let everything = ["--locked", "--workspace", "--exclude", "msape-web-tools"];
    run(project.command("cargo").arg("test").args(everything))
}

/// The parity tests, compiled for WebAssembly and run in Chromium.
fn browser(project: &Project) -> Result<()> {
    let driver =
        setup::program_of_tests(project, "chromedriver").context("chromedriver is missing")?;
    let tests = [
        "--locked",
        "--package",
        "msape-tests",
        "--test",
        "parity",
        "--target",
        WASM,
    ];
    run(project
        .command("cargo")
        .arg("test")
        .args(tests)
        .env(
            "CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER",
            "wasm-bindgen-test-runner",
        )
        .env("CHROMEDRIVER", driver))
}

/// The tests in `tests/e2e`, against the app as it would be deployed.
fn end_to_end(project: &Project) -> Result<()> {
    sizes::check(build::dist(project)?)?;
    let address = serve::in_background(&project.dist)?;
    let chromium = setup::program_of_tests(project, "chromium").context("chromium is missing")?;
    let tests = files_below(&project.root.join("tests/e2e"))?
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
