//! What can go wrong, and the code to end with.

use msape::library::DataError;
use std::io::{self, Write};
use std::process::ExitCode;

/// Why there is no answer.
#[derive(Debug)]
pub enum Failure {
    /// Bad input, every fault of it.
    Input(Vec<String>),
    /// A fault of the program.
    Program(String),
    /// Standard output was closed before the program began.
    NoOutput,
    /// The reader of our output went away.
    ReaderGone,
}

/// More faults than this are counted only.
const FAULTS_SHOWN: usize = 100;

impl Failure {
    /// One fault of the input.
    pub fn input(message: impl Into<String>) -> Failure {
        Failure::Input(vec![message.into()])
    }

    /// A failed write to standard output.
    pub fn writing(error: &io::Error) -> Failure {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Failure::ReaderGone,
            _ => Failure::Input(vec![format!("cannot write to standard output: {error}")]),
        }
    }

    /// Says what went wrong.
    pub fn report(&self) -> ExitCode {
        match self {
            Failure::Input(faults) => {
                for fault in faults.iter().take(FAULTS_SHOWN) {
                    say(fault);
                }
                if faults.len() > FAULTS_SHOWN {
                    say(&format!("and {} more", faults.len() - FAULTS_SHOWN));
                }
                ExitCode::from(2)
            }
            Failure::Program(message) => {
                say(&format!("{OUR_FAULT}: {message}"));
                ExitCode::from(1)
            }
            Failure::NoOutput => {
                say("standard output is closed: nothing was written");
                ExitCode::from(1)
            }
            Failure::ReaderGone => ExitCode::SUCCESS,
        }
    }
}

impl From<DataError> for Failure {
    fn from(error: DataError) -> Failure {
        Failure::Program(error.to_string())
    }
}

/// What is said before a fault of the program.
pub const OUR_FAULT: &str = "this is a fault of the program, please report it";
/// Most characters of a text of the user that a message repeats.
const SHOWN_MAX: usize = 100;

/// Says something on standard error. Where nobody can hear it, the code to end with still tells.
pub fn say(text: &str) {
    let _ = writeln!(io::stderr(), "msape: {}", printable(text));
}

/// A text of the user short enough for a message.
pub fn cut(text: &str) -> String {
    match text.char_indices().nth(SHOWN_MAX) {
        Some((end, _)) => format!("{}…", text.get(..end).unwrap_or_default()),
        None => text.to_string(),
    }
}

/// Text of unknown origin without what would steer a terminal: control characters, and signs that turn the direction of reading.
pub fn printable(text: &str) -> String {
    text.chars()
        .map(|c| match c {
            '\n' => "\n  ".to_string(),
            '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => {
                c.escape_unicode().to_string()
            }
            c if c.is_control() => c.escape_default().to_string(),
            c => c.to_string(),
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_terminal_is_not_steered_by_the_input() {
        assert_eq!(printable("a\u{1b}[2Jb\nc"), "a\\u{1b}[2Jb\n  c");
        assert_eq!(printable("a\u{202e}b"), "a\\u{202e}b");
    }
}
