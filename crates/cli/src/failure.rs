//! Errors of the command, and its exit codes.

use msape::library::DataError;
use std::io::{self, Write};
use std::process::ExitCode;

/// Exit code after Ctrl-C, that of shells.
pub const INTERRUPTED: u8 = 130;

/// Reason why there is no answer.
#[derive(Debug)]
pub enum Failure {
    /// Bad input, with all faults.
    Input(Vec<String>),
    /// Error of the program.
    Program(String),
    /// Standard output was closed before the program started.
    NoOutput,
    /// The reader of standard output closed it.
    ReaderGone,
    /// The command was stopped before it had something to write.
    Stopped,
}

/// Largest number of faults printed; others are counted.
const FAULTS_SHOWN: usize = 100;

impl Failure {
    /// A single fault of the input.
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

    /// Prints the error and returns the exit code.
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
            Failure::Stopped => {
                say("stopped: nothing was written");
                ExitCode::from(INTERRUPTED)
            }
        }
    }
}

impl From<DataError> for Failure {
    fn from(error: DataError) -> Failure {
        Failure::Program(error.to_string())
    }
}

/// Prefix of a message on an error of the program.
pub const OUR_FAULT: &str = "this is a fault of the program, please report it";
/// Largest number of characters of user text quoted in a message.
const SHOWN_MAX: usize = 100;

/// Prints a line on standard error; if that fails, the exit code still reports the error.
pub fn say(text: &str) {
    let _ = writeln!(io::stderr(), "msape: {}", printable(text));
}

/// User text shortened for a message.
pub fn cut(text: &str) -> String {
    match text.char_indices().nth(SHOWN_MAX) {
        Some((end, _)) => format!("{}…", text.get(..end).unwrap_or_default()),
        None => text.to_string(),
    }
}

/// Untrusted text without characters that control a terminal: control characters and bidirectional formatting.
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
