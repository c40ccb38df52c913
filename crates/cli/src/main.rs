//! Command `msape`: files, arguments and terminal around the core.

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
mod signal;
mod source;
mod terminal;
mod tps;
mod validate;

use args::{Arguments, Command, Design};
use clap::Parser;
use failure::Failure;
use msape::quantity::Job;
use read::Data;
use run::Entries;
use std::process::ExitCode;

fn main() -> ExitCode {
    // a panic is an error of the program: report it as one and exit with its code
    std::panic::set_hook(Box::new(|panic| {
        failure::say(&format!("{}: {panic}", failure::OUR_FAULT));
        std::process::exit(1);
    }));
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        // help and version are ordinary output
        Err(told) if !told.use_stderr() && msape_stdout::is_closed() => {
            return Failure::NoOutput.report();
        }
        Err(told) => return refused(&told),
    };
    match done(arguments) {
        Ok(code) => code,
        Err(failure) => failure.report(),
    }
}

fn done(Arguments { command, data }: Arguments) -> Done {
    let data = &Data::of(data.as_deref())?;
    let library = &data.library;
    match command {
        Command::Fly(arguments) => run::run(&arguments, data, Job::Fly, Entries::Nominal),
        Command::Design(Design { run, reorientation }) => {
            let entries = if reorientation {
                Entries::AnyAttitude
            } else {
                Entries::Nominal
            };
            run::run(&run, data, Job::Design, entries)
        }
        Command::Reorientation(arguments) => reorientation::reorientation(&arguments, data),
        Command::Export(arguments) => export::export(&arguments, data),
        Command::Aero(arguments) => aero::run(&arguments, data),
        Command::Tps(arguments) => tps::tps(&arguments, data),
        Command::Validate(arguments) => validate::validate(&arguments, library),
        Command::Outline(arguments) => outline::outline(&arguments, data),
        Command::Schema(arguments) => quantities::schema(&arguments, library),
        Command::Quantities(arguments) => quantities::quantities(&arguments, library),
    }
}

/// Prints errors of the arguments, with long ones shortened; help and version are not errors.
fn refused(error: &clap::Error) -> ExitCode {
    if !error.use_stderr() {
        let _ = error.print();
        return ExitCode::SUCCESS;
    }
    let mut message = error.render().to_string();
    let mut pieces: Vec<String> = std::env::args_os()
        .skip(1)
        .map(|argument| argument.to_string_lossy().into_owned())
        .flat_map(|argument| {
            let value = argument.split_once('=').map(|(_, value)| value.to_string());
            [Some(argument), value]
        })
        .flatten()
        .collect();
    pieces.sort_by_key(|piece| std::cmp::Reverse(piece.len()));
    for piece in pieces {
        let short = failure::cut(&piece);
        if short != piece {
            message = message.replace(&piece, &short);
        }
    }
    failure::say(message.trim_end());
    ExitCode::from(2)
}

/// Result of a command: its exit code.
type Done = Result<ExitCode, Failure>;
