//! Argument that names a case.

use clap::Args;
use std::path::PathBuf;

/// The case of a command, and what is set in it.
#[derive(Args)]
pub struct Source {
    /// The case, TOML or JSON; `-` is standard input
    #[arg(value_name = "CASE")]
    pub case: PathBuf,
    /// Set a key of the case, in its unit or with another: entry.speed_m_s=13000, entry.speed_m_s="13 km/s"; an empty
    /// value takes the key away
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Folder below which files that the case names may lie; without it, that of the case
    #[arg(long, value_name = "DIR")]
    pub root: Option<PathBuf>,
}
