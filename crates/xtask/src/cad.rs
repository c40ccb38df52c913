//! Checks of exported files with other programs: OpenCASCADE, a DXF reader, the glTF validator.

use std::{fs, path::PathBuf};

use anyhow::{Context, Result};

use crate::project::{Project, announce, files_below, output, run};

const REQUIREMENTS: &str = "tests/cad/requirements.txt";

/// Python of a separate virtual environment.
fn python(project: &Project) -> PathBuf {
    let programs = if cfg!(windows) { "Scripts" } else { "bin" };
    environment(project).join(programs).join("python")
}

fn environment(project: &Project) -> PathBuf {
    project.target.join("cad/python")
}

/// Installs the packages of `tests/cad/requirements.txt` in the build folder when the file has changed.
pub fn set_up(project: &Project) -> Result<()> {
    let wanted = fs::read_to_string(project.root.join(REQUIREMENTS))
        .with_context(|| format!("cannot read {REQUIREMENTS}"))?;
    let installed = environment(project).join("requirements.txt");
    let works = output(
        project
            .command(python(project))
            .args(["-c", "import OCP.STEPCAFControl, ezdxf; print(1)"]),
    );
    if works.is_some() && fs::read_to_string(&installed).ok().as_ref() == Some(&wanted) {
        return Ok(());
    }
    announce(format_args!(
        "Installing the packages of {REQUIREMENTS}: they read the exported CAD files"
    ));
    let program = std::env::var_os("PYTHON3").unwrap_or_else(|| "python3".into());
    run(project
        .command(program)
        .args(["-m", "venv", "--clear"])
        .arg(environment(project)))
    .context("Python needs its module venv; on Debian it is in the package python3-venv")?;
    run(project
        .command(python(project))
        .args([
            "-m",
            "pip",
            "install",
            "--disable-pip-version-check",
            "--quiet",
        ])
        .args(["--only-binary", ":all:", "--requirement", REQUIREMENTS]))?;
    fs::write(installed, wanted)?;
    Ok(())
}

/// Exports vehicles and compares the import by other programs with the model.
pub fn check(project: &Project) -> Result<()> {
    let build = ["build", "--locked", "--package", "msape-cli"];
    run(project.command("cargo").args(build))?;
    let files = project.target.join("cad/files");
    if files.is_dir() {
        fs::remove_dir_all(&files)?;
    }
    let program = format!("msape{}", std::env::consts::EXE_SUFFIX);
    run(project
        .command(python(project))
        .args(["-B", "tests/cad/check.py"])
        .arg(project.target.join("debug").join(program))
        .arg(&project.root)
        .arg(&files))?;
    let meshes = files_below(&files)?.into_iter().filter(|file| {
        let ending = file.extension().and_then(|ending| ending.to_str());
        matches!(ending, Some("gltf" | "glb"))
    });
    run(project
        .command("node")
        .arg("tests/cad/gltf.mjs")
        .args(meshes))
}
