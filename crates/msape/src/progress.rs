//! How far, and shall I stop? Long work asks its caller.

use std::ops::ControlFlow;

/// Who watches long work.
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
    /// Hears the part that is done, 0 to 1; at `Break` the work ends and keeps what it has.
    fn advance(&mut self, done: f64) -> ControlFlow<()>;
}

impl<F: FnMut(f64) -> ControlFlow<()>> Progress for F {
    fn advance(&mut self, done: f64) -> ControlFlow<()> {
        self(done)
    }
}

/// Nobody: the work runs to its end.
#[derive(Clone, Copy, Debug)]
pub struct Unwatched;

impl Progress for Unwatched {
    fn advance(&mut self, _done: f64) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

/// A part of a work of several: its own 0 to 1 is `from` to `to` of the whole.
pub struct Part<'a> {
    /// Who watches the whole.
    pub whole: &'a mut dyn Progress,
    /// Part of the whole that is done before it.
    pub from: f64,
    /// Part of the whole that is done after it.
    pub to: f64,
}

impl Progress for Part<'_> {
    fn advance(&mut self, done: f64) -> ControlFlow<()> {
        self.whole.advance(self.from + done * (self.to - self.from))
    }
}
