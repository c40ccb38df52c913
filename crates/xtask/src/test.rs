//! All checks, fastest to fail first.

use std::time::Instant;

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

const STAGES: [Stage; 8] = [
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
        name: "browser",
        set_up: setup::for_browser,
        check: browser,
    },
    Stage {
        name: "e2e",
        set_up: setup::for_end_to_end,
        check: end_to_end,
    },
];

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

/// Runs the named stages, or all, and stops at the first failure.
pub fn run_stages(project: &Project, names: &[&str]) -> Result<()> {
    set_up(project, names)?;
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
    clippy(&["--package", "msape-web", "--target", WASM])
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

/// Parity tests, compiled for WebAssembly and run in Chromium.
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
            project.tools.join("wasm-bindgen-test-runner"),
        )
        .env("CHROMEDRIVER", driver))
}

/// Tests of `tests/e2e`, against the app as it would be deployed.
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
