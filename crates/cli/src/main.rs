//! The command `msape`.
fn main() {}
