//! The questions. A further one is a type in a file of its own and a word in the list below.

mod attitude;
mod catalog;
pub mod curves;
mod fly;
mod measure;
mod read;
mod solve;
mod write;

use crate::protocol::{Kind, Listed, Role};

pub use attitude::{Attitude, Designed, Turning};
pub use catalog::ReadCatalog;
pub use curves::AskCurves;
pub use fly::Fly;
pub use measure::Measure;
pub use read::{FileKind, Read, ReadRows};
pub use solve::{Solution, Solve};
pub use write::Write;

/// Questions and the worker that answers them.
macro_rules! questions {
    ($($(#[$doc:meta])* $list:ident of $role:expr => $($question:ident)*;)*) => {
        $($(impl Listed for $question {
            const NAME: &'static str = stringify!($question);
            const ROLE: Role = $role;
        })*
        $(#[$doc])*
        pub const $list: &[Kind] = &[$(Kind::of::<$question>()),*];)*
    };
}

questions! {
    /// Questions to the solver.
    SOLVER of Role::Solver => ReadCatalog Solve;
    /// Questions to the toolbox.
    TOOLBOX of Role::Toolbox => AskCurves Attitude Fly Measure Read Turning Write;
}
