//! Progress of long computations, reported to a caller who can stop them.

use std::ops::ControlFlow;

/// Observer of a long computation.
///
/// ```
/// use msape::progress::Progress;
/// use std::ops::ControlFlow;
///
/// // Stops in the middle.
/// let mut watcher = |done: f64| match done < 0.5 {
///     true => ControlFlow::Continue(()),
///     false => ControlFlow::Break(()),
/// };
/// assert!(watcher.advance(0.4).is_continue() && watcher.advance(0.6).is_break());
/// ```
pub trait Progress {
    /// Receives the fraction done, 0 to 1; on `Break` the computation ends and keeps its results.
    fn advance(&mut self, done: f64) -> ControlFlow<()>;
}

impl<F: FnMut(f64) -> ControlFlow<()>> Progress for F {
    fn advance(&mut self, done: f64) -> ControlFlow<()> {
        self(done)
    }
}

/// Observer that never stops the computation.
#[derive(Clone, Copy, Debug)]
pub struct Unwatched;

impl Progress for Unwatched {
    fn advance(&mut self, _done: f64) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

/// Observer of a part of a computation: its 0 to 1 is `from` to `to` of the whole.
pub struct Part<'a> {
    /// Observer of the whole.
    pub whole: &'a mut dyn Progress,
    /// Fraction of the whole that is done before the part.
    pub from: f64,
    /// Fraction of the whole that is done after the part.
    pub to: f64,
}

impl Progress for Part<'_> {
    fn advance(&mut self, done: f64) -> ControlFlow<()> {
        self.whole.advance(self.from + done * (self.to - self.from))
    }
}
