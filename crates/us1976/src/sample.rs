//! The shipped definition, for tests.

use crate::definition::Definition;

/// The definition of the data file `us-1976.toml`.
pub fn definition() -> Definition {
    let text = include_str!("../../msape/data/atmospheres/us-1976.toml");
    toml::from_str::<Definition>(text)
        .unwrap()
        .checked()
        .unwrap()
}
