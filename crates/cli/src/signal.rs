//! Ctrl-C: during long work the first ends the work, which keeps what is done; otherwise, and the second time, it ends the program.

use crate::failure::INTERRUPTED;
use crate::output;
use msape::progress::Progress;
use std::ops::ControlFlow;
use std::process::ExitCode;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};

static LISTENS: OnceLock<bool> = OnceLock::new();
static AT_WORK: AtomicBool = AtomicBool::new(false);
static STOPPED: AtomicBool = AtomicBool::new(false);

/// Installs the signal handler. Without one an interrupted command may leave a file unfinished, which is no reason to refuse work.
pub fn listen() {
    LISTENS.get_or_init(|| ctrlc::set_handler(heard).is_ok());
}

fn heard() {
    if AT_WORK.load(Ordering::SeqCst) && !STOPPED.swap(true, Ordering::SeqCst) {
        return;
    }
    output::leave_nothing_unfinished();
    std::process::exit(i32::from(INTERRUPTED));
}

/// Runs a long computation that can be stopped.
pub fn stoppable<T>(work: impl FnOnce(&mut dyn Progress) -> T) -> T {
    AT_WORK.store(true, Ordering::SeqCst);
    listen();
    let done = work(&mut |_| match is_stopped() {
        true => ControlFlow::Break(()),
        false => ControlFlow::Continue(()),
    });
    AT_WORK.store(false, Ordering::SeqCst);
    done
}

/// Whether long work was stopped.
pub fn is_stopped() -> bool {
    STOPPED.load(Ordering::SeqCst)
}

/// Exit code of a command that has written its results; another one if it was stopped.
pub fn code(done: ExitCode) -> ExitCode {
    match is_stopped() {
        true => ExitCode::from(INTERRUPTED),
        false => done,
    }
}
