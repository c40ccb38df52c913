//! The command `msape`: files, arguments and terminals around the core.

mod aero;
mod args;
mod export;
mod failure;
mod outline;
mod output;
mod quantities;
mod read;
mod reorientation;
mod run;
mod show;
mod terminal;
mod validate;

use args::{Arguments, Command, Design};
use clap::Parser;
use failure::Failure;
use msape::quantity::Job;
use run::Entries;
use std::process::ExitCode;

fn main() -> ExitCode {
    // A panic is a fault of the program: say so, and end with the code of such faults.
    std::panic::set_hook(Box::new(|panic| {
        failure::say(&format!("{}: {panic}", failure::OUR_FAULT));
        std::process::exit(1);
    }));
    let arguments = Arguments::parse();
    match done(arguments) {
        Ok(code) => code,
        Err(failure) => failure.report(),
    }
}

fn done(Arguments { command, data }: Arguments) -> Done {
    let library = &read::library(data.as_deref())?;
    match command {
        Command::Fly(arguments) => run::run(&arguments, library, Job::Fly, Entries::Nominal),
        Command::Design(Design { run, reorientation }) => {
            let entries = if reorientation {
                Entries::AnyAttitude
            } else {
                Entries::Nominal
            };
            run::run(&run, library, Job::Design, entries)
        }
        Command::Reorientation(arguments) => reorientation::reorientation(&arguments, library),
        Command::Export(arguments) => export::export(&arguments, library),
        Command::Aero(arguments) => aero::run(&arguments, library),
        Command::Validate(arguments) => validate::validate(&arguments, library),
        Command::Outline(arguments) => outline::outline(&arguments, library),
        Command::Schema(arguments) => quantities::schema(&arguments, library),
        Command::Quantities(arguments) => quantities::quantities(&arguments, library),
    }
}

/// What a command comes to: the code to end with.
type Done = Result<ExitCode, Failure>;
