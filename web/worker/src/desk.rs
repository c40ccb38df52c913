//! Data that a worker keeps between questions.

use crate::questions::curves::Kept;
use benchmark::Bench;
use msape::Library;
use msape::library::DataError;
use std::cell::OnceCell;

/// Data that a worker keeps between questions.
pub struct Desk {
    /// Library.
    pub library: Library,
    /// Jobs of the benchmark, made on first use.
    pub bench: OnceCell<Result<Bench, DataError>>,
    /// Last aerodynamic database.
    pub aerodynamics: Kept,
}

impl Desk {
    /// A desk with nothing but the library.
    pub fn new(library: Library) -> Desk {
        Desk {
            library,
            bench: OnceCell::new(),
            aerodynamics: Kept::default(),
        }
    }
}
