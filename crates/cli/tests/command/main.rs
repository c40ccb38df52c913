//! Tests of the command as users see it: exit codes, messages, files.

mod aero;
mod answers;
mod bad_input;
mod data;
mod drawing;
mod export;
mod files;
mod outputs;
mod reorientation;
mod schema;

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// Finished run of the command.
struct Finished {
    code: Option<i32>,
    out: String,
    err: String,
}

impl From<Output> for Finished {
    fn from(output: Output) -> Finished {
        Finished {
            code: output.status.code(),
            out: String::from_utf8(output.stdout).unwrap(),
            err: String::from_utf8(output.stderr).unwrap(),
        }
    }
}

fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_msape"));
    command.args(arguments).current_dir(root());
    command
}

fn msape(arguments: &[&str]) -> Finished {
    command(arguments).output().unwrap().into()
}

/// Runs the command with a case on standard input.
fn msape_with(arguments: &[&str], case: &[u8]) -> Finished {
    let mut child = command(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // a command that fails early closes its standard input
    let _ = child.stdin.take().unwrap().write_all(case);
    child.wait_with_output().unwrap().into()
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// A separate folder for a test.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

fn path(path: &Path) -> &str {
    path.to_str().unwrap()
}

const M2: &str = "cases/msape-ref-m2.toml";
