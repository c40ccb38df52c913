//! Whether standard output was closed when the program began.
//!
//! Before `main` the standard library opens the null device in the place of each closed standard stream, and from then on a
//! closed one looks like one that somebody sent there: Python and Node open the null device for reading and writing too. So it
//! is looked at before.

use std::sync::atomic::{AtomicBool, Ordering};

static CLOSED: AtomicBool = AtomicBool::new(false);

/// Whether what is written to standard output is lost because it was closed.
pub fn is_closed() -> bool {
    CLOSED.load(Ordering::Relaxed)
}

// One call of the system and one store: nothing that needs the standard library to be ready.
#[cfg(unix)]
ctor::declarative::ctor! {
    #[ctor(unsafe)]
    fn look() {
        let gone = rustix::io::fcntl_getfd(rustix::stdio::stdout()).is_err();
        CLOSED.store(gone, Ordering::Relaxed);
    }
}
