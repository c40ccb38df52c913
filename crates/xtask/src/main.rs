//! Set-up, serve, test, build.
fn main() {}
