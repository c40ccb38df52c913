//! What a terminal is told besides the text: bold and colour, and how far we are.

use std::io::{IsTerminal, Write, stderr, stdout};

/// Whether standard output is to be coloured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Paint {
    /// A terminal that wants colour.
    Colour,
    /// A file, a pipe, or a terminal that does not.
    Plain,
}

impl Paint {
    /// For standard output: plain when it is not a terminal, when `NO_COLOR` is set, when the terminal is dumb.
    pub fn of_standard_output() -> Paint {
        let unwanted = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty())
            || std::env::var_os("TERM").is_some_and(|term| term == "dumb");
        if stdout().is_terminal() && !unwanted {
            Paint::Colour
        } else {
            Paint::Plain
        }
    }

    fn with(self, code: &str, text: &str) -> String {
        match self {
            Paint::Colour => format!("\u{1b}[{code}m{text}\u{1b}[0m"),
            Paint::Plain => text.to_string(),
        }
    }

    /// A heading.
    pub fn heading(self, text: &str) -> String {
        self.with("1", text)
    }

    /// What is well.
    pub fn good(self, text: &str) -> String {
        self.with("32", text)
    }

    /// What needs a look.
    pub fn doubtful(self, text: &str) -> String {
        self.with("33", text)
    }

    /// What is not well.
    pub fn bad(self, text: &str) -> String {
        self.with("1;31", text)
    }

    /// What is only for reference.
    pub fn faint(self, text: &str) -> String {
        self.with("2", text)
    }
}

/// Says on a terminal how far we are; says nothing elsewhere.
pub fn progress(text: &str) {
    let mut err = stderr();
    if err.is_terminal() {
        // The cursor goes back and the rest of the line is cleared.
        let _ = write!(err, "\r\u{1b}[K{text}");
        let _ = err.flush();
    }
}
