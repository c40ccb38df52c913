//! Project commands that need more than one line: `cargo xtask help`.

mod build;
mod cad;
mod counts;
mod fuzz;
mod licenses;
mod project;
mod release;
mod serve;
mod setup;
mod sizes;
mod test;

use std::{num::NonZeroU16, process::ExitCode};

use anyhow::{Context, Result, bail};

use project::Project;

const HELP: &str = "\
Usage: cargo xtask COMMAND

  serve [--port N]   sets up what is missing, builds the app, serves it on 127.0.0.1 (port 8080, or a free one)
  build              sets up what is missing, builds the deployable folder dist/, prints the sizes
  test [STAGE...]    sets up what is missing, runs all checks or the stages named:
                     fmt clippy deny native counts cad sizes browser e2e trunk
  fuzz [--seed N] [--seconds S] [KIND]
                     hostile and random input of tests/properties/hostile for S seconds of each kind (60), from seed N (1) on;
                     KIND is a part of the name of its test
  release            builds app and command and packs them with their hashes (needs git, GNU tar, sha256sum)
  setup              sets up everything that the above need, and nothing else
  setup trunk        sets up Trunk and the wasm-bindgen that it calls, in target/trunk/bin: see Trunk.toml
";

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("\nerror: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let project = Project::find()?;
    match arguments.as_slice() {
        ["serve"] => serve::run(&project, serve::DEFAULT_PORT),
        ["serve", "--port", port] => {
            let port: NonZeroU16 = port.parse().with_context(|| {
                format!("--port: got {port:?}, must be a number from 1 to 65535")
            })?;
            serve::run(&project, port.get())
        }
        ["build"] => build::dist(&project).map(|_| ()),
        ["test", stages @ ..] => test::run_stages(&project, stages),
        ["fuzz", arguments @ ..] => fuzz::run_kinds(&project, arguments),
        ["release"] => release::run_all(&project),
        ["setup"] => test::set_up(&project, &[]),
        ["setup", "trunk"] => {
            let programs = setup::for_trunk(&project)?;
            println!(
                "\nTrunk builds and serves the app now:\n\n    PATH={}:$PATH trunk serve\n",
                programs.display()
            );
            Ok(())
        }
        [] | ["help" | "--help" | "-h"] => {
            print!("{HELP}");
            Ok(())
        }
        other => bail!("no such command: {}\n\n{HELP}", other.join(" ")),
    }
}
