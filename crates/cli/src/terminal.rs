//! Terminal formatting: bold, color, and progress.

use msape::progress::Progress;
use std::io::{IsTerminal, Write, stderr, stdout};

/// Use of color on standard output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Paint {
    /// A terminal with color.
    Color,
    /// A file, a pipe, or a terminal without color.
    Plain,
}

impl Paint {
    /// Mode for standard output: plain if it is not a terminal, if `NO_COLOR` is set, or if the terminal is dumb.
    pub fn of_standard_output() -> Paint {
        let unwanted = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty())
            || std::env::var_os("TERM").is_some_and(|term| term == "dumb");
        if stdout().is_terminal() && !unwanted {
            Paint::Color
        } else {
            Paint::Plain
        }
    }

    fn with(self, code: &str, text: &str) -> String {
        match self {
            Paint::Color => format!("\u{1b}[{code}m{text}\u{1b}[0m"),
            Paint::Plain => text.to_string(),
        }
    }

    /// A heading.
    pub fn heading(self, text: &str) -> String {
        self.with("1", text)
    }

    /// A good result.
    pub fn good(self, text: &str) -> String {
        self.with("32", text)
    }

    /// A result that needs attention.
    pub fn doubtful(self, text: &str) -> String {
        self.with("33", text)
    }

    /// A bad result.
    pub fn bad(self, text: &str) -> String {
        self.with("1;31", text)
    }

    /// Secondary information.
    pub fn faint(self, text: &str) -> String {
        self.with("2", text)
    }
}

/// Observer of work in `count` equal parts that shows the part under way, and passes the progress on.
pub fn counted<'a>(
    whole: &'a mut dyn Progress,
    count: usize,
    text: impl Fn(usize) -> String + 'a,
) -> impl Progress + 'a {
    let mut shown = None;
    move |done: f64| {
        let part = (done * count as f64) as usize;
        if shown < Some(part) && part < count {
            shown = Some(part);
            progress(&format!("{} of {count}: {}", part + 1, text(part)));
        }
        whole.advance(done)
    }
}

/// Shows progress on a terminal; prints nothing elsewhere.
pub fn progress(text: &str) {
    let mut err = stderr();
    if err.is_terminal() {
        // return to the start of the line and clear the rest of it
        let _ = write!(err, "\r\u{1b}[K{text}");
        let _ = err.flush();
    }
}
