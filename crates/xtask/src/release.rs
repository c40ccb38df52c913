//! Release files in `target/release-VERSION/`: the app and the command for Linux as archives, and their hashes.
//!
//! The archives have the same bytes for the same source and toolchain: sorted, without owner, dated by the commit.

use std::{env, fs, path::Path};

use anyhow::{Context, Result};

use crate::{
    build,
    project::{Project, announce, output, run},
};

/// Documents packed with the command.
const PAPERS: [&str; 6] = [
    "README.md",
    "CHANGELOG.md",
    "CITATION.cff",
    "NOTICE.md",
    "LICENSE-MIT",
    "LICENSE-APACHE",
];

/// Builds app and command and packs them.
pub fn run_all(project: &Project) -> Result<()> {
    let version = env!("CARGO_PKG_VERSION");
    let name = format!("release-{version}");
    let folder = project.target.join(&name);
    if folder.exists() {
        fs::remove_dir_all(&folder).context("cannot replace the last release")?;
    }
    let app = format!("msape-{version}-app");
    let command = format!("msape-{version}-{}-{}", env::consts::ARCH, env::consts::OS);
    build::dist(project)?;
    copy_files(&project.dist, &folder.join(&app))?;
    build::command(project)?;
    let unpacked = folder.join(&command);
    fs::create_dir_all(&unpacked)?;
    let program = format!("msape{}", env::consts::EXE_SUFFIX);
    fs::copy(
        project.target.join("release").join(&program),
        unpacked.join(&program),
    )
    .context("the command was not built")?;
    for paper in PAPERS {
        fs::copy(project.root.join(paper), unpacked.join(paper))
            .with_context(|| format!("cannot copy {paper}"))?;
    }
    let date = output(project.command("git").args(["log", "-1", "--format=%ct"]))
        .context("git does not tell the date of the commit")?;
    announce("Packing");
    let archives = [&app, &command].map(|content| format!("{content}.tar.gz"));
    for (archive, content) in archives.iter().zip([&app, &command]) {
        pack(project, &folder, archive, content, &date)?;
    }
    let sums = output(
        project
            .command("sha256sum")
            .current_dir(&folder)
            .args(&archives),
    )
    .context("sha256sum failed")?;
    fs::write(folder.join("SHA256SUMS"), format!("{sums}\n"))?;
    println!("{}\n{sums}", folder.display());
    Ok(())
}

/// Packs with GNU tar, so that order, owner and date of the files do not depend on the machine.
fn pack(project: &Project, folder: &Path, archive: &str, content: &str, date: &str) -> Result<()> {
    run(project
        .command("tar")
        .current_dir(folder)
        .env("GZIP", "-n")
        .args(["--create", "--gzip", "--file", archive])
        .args(["--sort=name", "--owner=0", "--group=0", "--numeric-owner"])
        .arg(format!("--mtime=@{date}"))
        .arg(content))
}

fn copy_files(from: &Path, to: &Path) -> Result<()> {
    fs::create_dir_all(to)?;
    build::copy(from, to)
}
