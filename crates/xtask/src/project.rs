//! Folders of the project, and calls of other programs.

use std::{
    env,
    ffi::OsStr,
    fs,
    path::{Path, PathBuf},
    process::Command,
};

use anyhow::{Context, Result, bail};

/// Folders of the project.
pub struct Project {
    /// Root of the repository.
    pub root: PathBuf,
    /// The deployable app.
    pub dist: PathBuf,
    /// Build folder of cargo.
    pub target: PathBuf,
    /// Build folder for the programs of crates/web-tools.
    pub tools: PathBuf,
}

impl Project {
    /// The project from which this program was built.
    pub fn find() -> Result<Self> {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"))
            .ancestors()
            .nth(2)
            .context("crates/xtask is not in a repository")?
            .to_path_buf();
        // this program is target/debug/xtask, wherever target is
        let program = env::current_exe()?;
        let target = program
            .ancestors()
            .nth(2)
            .context("this program is not in a target folder")?;
        Ok(Self {
            dist: root.join("dist"),
            target: target.to_path_buf(),
            tools: target.join("tools"),
            root,
        })
    }

    /// A command to be run in the root folder.
    pub fn command(&self, program: impl AsRef<OsStr>) -> Command {
        let mut command = Command::new(program);
        command.current_dir(&self.root);
        command
    }

    /// Path of the executable for `program`, if found; the project's Node packages take precedence.
    pub fn locate(&self, program: &str) -> Option<PathBuf> {
        let file = format!("{program}{}", env::consts::EXE_SUFFIX);
        let path = env::var_os("PATH").unwrap_or_default();
        std::iter::once(self.root.join("node_modules/.bin"))
            .chain(env::split_paths(&path))
            .map(|folder| folder.join(&file))
            .find(|path| path.is_file())
    }
}

/// Prints the name of the next step.
pub fn announce(what: impl std::fmt::Display) {
    eprintln!("\n==> {what}");
}

/// Runs a command to completion; an error names it.
pub fn run(command: &mut Command) -> Result<()> {
    let status = command
        .status()
        .with_context(|| format!("cannot start {}", line(command)))?;
    if !status.success() {
        bail!("{status}: {}", line(command));
    }
    Ok(())
}

/// Output of a command, if it succeeds.
pub fn output(command: &mut Command) -> Option<String> {
    let output = command
        .output()
        .ok()
        .filter(|output| output.status.success())?;
    String::from_utf8(output.stdout)
        .ok()
        .map(|text| text.trim().to_owned())
}

/// Command line as one would type it.
pub fn line(command: &Command) -> String {
    let words: Vec<_> = std::iter::once(command.get_program())
        .chain(command.get_args())
        .map(OsStr::to_string_lossy)
        .collect();
    words.join(" ")
}

/// All files below a folder, sorted by name.
pub fn files_below(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for entry in
        fs::read_dir(folder).with_context(|| format!("cannot read {}", folder.display()))?
    {
        let path = entry?.path();
        if path.is_dir() {
            files.extend(files_below(&path)?);
        } else {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}
