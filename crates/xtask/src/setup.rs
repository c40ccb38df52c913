//! Installs missing tools and says which and why; where it must not, it prints the command to run instead.

use std::{env, fs, path::PathBuf, process::Command};

use anyhow::{Context, Result, bail};

use crate::cad;
use crate::project::{Project, announce, line, output, run};

/// Compilation target for the browser.
pub const WASM: &str = "wasm32-unknown-unknown";
/// Version of Trunk: the newest that Rust 1.95 compiles.
const TRUNK: &str = "0.21.14";

/// Tools for building the app; a computer with rustup and a C linker is sufficient to start.
pub fn for_build(project: &Project) -> Result<()> {
    wasm_target(project)?;
    web_tool(
        project,
        "web-bindgen",
        &[],
        "it makes the JavaScript that loads the app's WebAssembly",
    )
}

/// Tools for checking format and lints.
pub fn for_lints(project: &Project) -> Result<()> {
    wasm_target(project)?;
    rust_components(project)
}

/// Tools for the tests compiled to WebAssembly.
pub fn for_browser(project: &Project) -> Result<()> {
    wasm_target(project)?;
    debian_packages(project, &[CHROMIUM, CHROMEDRIVER])?;
    let reason = "it runs the WebAssembly tests in the browser";
    web_tool(
        project,
        "wasm-bindgen-test-runner",
        &["--features", "commands"],
        reason,
    )
}

/// Trunk in the version of `Trunk.toml`, if there is none, and our wasm-bindgen, which it would otherwise download, in one
/// folder; returns that.
pub fn for_trunk(project: &Project) -> Result<PathBuf> {
    wasm_target(project)?;
    let folder = project.target.join("trunk");
    let programs = folder.join("bin");
    let ours = programs.join(format!("trunk{}", env::consts::EXE_SUFFIX));
    if !ours.is_file() && project.locate("trunk").is_none() {
        announce(
            "Installing Trunk, unoptimized, so that it is soon compiled: it builds the app, too",
        );
        let version = ["--version", TRUNK, "--locked", "--profile", "dev"];
        run(project
            .command("cargo")
            .args(["install", "trunk"])
            .args(version)
            .arg("--root")
            .arg(&folder)
            .arg("--target-dir")
            .arg(folder.join("build"))
            .env("CARGO_PROFILE_DEV_DEBUG", "false"))?;
        fs::remove_dir_all(folder.join("build"))
            .context("cannot remove what Trunk was built from")?;
    }
    // Trunk builds offline, so that it fetches no other wasm-bindgen
    run(project
        .command("cargo")
        .args(["fetch", "--locked", "--target", WASM]))?;
    let reason = "Trunk calls it";
    web_tool(
        project,
        "trunk-bindgen",
        &["--features", "commands"],
        reason,
    )?;
    fs::create_dir_all(&programs)?;
    let file = |name: &str| format!("{name}{}", env::consts::EXE_SUFFIX);
    let bindgen = project.tools.join(file("trunk-bindgen"));
    fs::copy(bindgen, programs.join(file("wasm-bindgen"))).context("cannot copy wasm-bindgen")?;
    Ok(programs)
}

/// Tools for the test of what Trunk builds.
pub fn for_trunk_tests(project: &Project) -> Result<()> {
    for_trunk(project)?;
    debian_packages(project, &[CHROMIUM, NODE, NPM])?;
    node_packages(project)
}

/// Tools for the end-to-end tests.
pub fn for_end_to_end(project: &Project) -> Result<()> {
    for_build(project)?;
    debian_packages(project, &[CHROMIUM, NODE, NPM])?;
    node_packages(project)
}

/// Tools for counting instructions.
pub fn for_counts(project: &Project) -> Result<()> {
    debian_packages(project, &[VALGRIND])
}

/// Tools for reading exported files back.
pub fn for_cad(project: &Project) -> Result<()> {
    debian_packages(project, &[PYTHON, NODE, NPM])?;
    node_packages(project)?;
    cad::set_up(project)
}

/// Program available as a Debian package, and the reason why it is needed.
struct Needed {
    program: &'static str,
    package: &'static str,
    reason: &'static str,
}

const CHROMIUM: Needed = Needed {
    program: "chromium",
    package: "chromium",
    reason: "tests run in a real browser",
};
const CHROMEDRIVER: Needed = Needed {
    program: "chromedriver",
    package: "chromium-driver",
    reason: "it starts tests in Chromium",
};
const VALGRIND: Needed = Needed {
    program: "valgrind",
    package: "valgrind",
    reason: "it counts instructions, so that a slower solver is seen on any machine",
};
const PYTHON: Needed = Needed {
    program: "python3",
    package: "python3-venv",
    reason: "it reads the exported CAD files back",
};
const NODE: Needed = Needed {
    program: "node",
    package: "nodejs",
    reason: "it runs the end-to-end tests",
};
const NPM: Needed = Needed {
    program: "npm",
    package: "npm",
    reason: "it installs the packages of the end-to-end tests",
};

/// Path of a program used by tests: from `CHROMIUM`, `CHROMEDRIVER` ... in the environment, or from the search path.
pub fn program_of_tests(project: &Project, program: &str) -> Option<PathBuf> {
    env::var_os(program.to_uppercase())
        .map(PathBuf::from)
        .or_else(|| project.locate(program))
}

fn wasm_target(project: &Project) -> Result<()> {
    let target = ["--target", "wasm32-unknown-unknown"];
    let libraries = output(
        project
            .command("rustc")
            .args(["--print", "target-libdir"])
            .args(target),
    );
    if libraries.is_some_and(|folder| PathBuf::from(folder).is_dir()) {
        return Ok(());
    }
    announce("Installing Rust's target wasm32-unknown-unknown: the app runs as WebAssembly");
    run(project.command("rustup").args(["target", "add", WASM])).context(
        "install the target wasm32-unknown-unknown for the toolchain of rust-toolchain.toml",
    )
}

fn rust_components(project: &Project) -> Result<()> {
    let present =
        |subcommand| output(project.command("cargo").args([subcommand, "--version"])).is_some();
    if present("fmt") && present("clippy") {
        return Ok(());
    }
    announce("Installing Rust's components rustfmt and clippy: the tests check format and lints");
    run(project
        .command("rustup")
        .args(["component", "add", "rustfmt", "clippy"]))
}

/// Builds a program of crates/web-tools.
fn web_tool(project: &Project, program: &str, features: &[&str], reason: &str) -> Result<()> {
    announce(format_args!(
        "Building {program} of crates/web-tools, if it has changed: {reason}"
    ));
    let package = [
        "build",
        "--locked",
        "--profile",
        "tools",
        "--package",
        "msape-web-tools",
    ];
    run(project
        .command("cargo")
        .args(package)
        .args(["--bin", program])
        .args(features))
}

fn node_packages(project: &Project) -> Result<()> {
    let modified = |file: &str| {
        fs::metadata(project.root.join(file))
            .and_then(|data| data.modified())
            .ok()
    };
    if modified("node_modules/.package-lock.json") >= modified("package-lock.json") {
        return Ok(());
    }
    announce(
        "Installing the packages of package-lock.json into node_modules: they drive and check the browser",
    );
    run(project
        .command("npm")
        .args(["ci", "--ignore-scripts", "--no-audit", "--no-fund"]))
}

/// Whether a program is missing or, for Python, the part that Debian packages separately.
fn is_missing(project: &Project, needed: &Needed) -> bool {
    match program_of_tests(project, needed.program) {
        None => true,
        Some(python) if needed.program == PYTHON.program => {
            let parts = ["-c", "import ensurepip, venv; print(1)"];
            output(project.command(python).args(parts)).is_none()
        }
        Some(_) => false,
    }
}

/// Installs the missing programs in one step.
fn debian_packages(project: &Project, needed: &[Needed]) -> Result<()> {
    let missing = || needed.iter().filter(|needed| is_missing(project, needed));
    if missing().next().is_none() {
        return Ok(());
    }
    let reasons: Vec<_> = missing()
        .map(
            |Needed {
                 program, reason, ..
             }| format!("{program} ({reason})"),
        )
        .collect();
    let reasons = reasons.join(", ");
    let mut update = project.command("apt-get");
    update.arg("update");
    let mut install = project.command("apt-get");
    install
        .args(["install", "--yes", "--no-install-recommends"])
        .args(missing().map(|needed| needed.package));
    let by_hand = format!("sudo {} && sudo {}", line(&update), line(&install));
    if project.locate("apt-get").is_none() {
        bail!(
            "missing: {reasons}. Put them on the PATH, or their places in CHROMIUM, CHROMEDRIVER, and start again. \
             On Debian it would be:\n\n    {by_hand}\n"
        );
    }
    if output(Command::new("id").arg("-u")).as_deref() != Some("0") {
        bail!(
            "missing: {reasons}. Only root may install them. Run this, and start again:\n\n    {by_hand}\n"
        );
    }
    announce(format_args!("Installing with apt-get: {reasons}"));
    run(&mut update)?;
    run(install.env("DEBIAN_FRONTEND", "noninteractive"))?;
    match missing().next() {
        Some(Needed {
            program, package, ..
        }) => bail!("Debian's package {package} is installed, but {program} is not on the PATH"),
        None => Ok(()),
    }
}
