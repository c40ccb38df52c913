//! Solves every shipped case and compares it, to the bit, with its recorded answer in this folder.
//!
//! `UPDATE_SNAPSHOTS=1 cargo test --package msape-tests --test snapshots` records new answers; the changelog must then
//! say which result changed, from what to what, and why.

mod figures;
mod reorientation;
mod sweeps;

use msape::Library;
use msape_tests::{shipped, snapshot};
use std::path::PathBuf;
use std::{env, fs};

#[test]
fn every_shipped_case_gives_its_recorded_answer() {
    let library = Library::builtin().unwrap();
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("snapshots");
    let update = env::var_os("UPDATE_SNAPSHOTS").is_some();
    let mut changes = Vec::new();
    let mut names = Vec::new();
    for case in shipped::cases().unwrap() {
        names.push(format!("{}.json", case.name));
        let now = snapshot::take(&case, &library).unwrap();
        let file = folder.join(format!("{}.json", case.name));
        if update {
            fs::write(&file, format!("{now:#}\n")).unwrap();
            continue;
        }
        match fs::read_to_string(&file) {
            Ok(text) => changes.extend(
                snapshot::differences(&serde_json::from_str(&text).unwrap(), &now)
                    .into_iter()
                    .map(|line| format!("{}: {line}", case.name)),
            ),
            Err(error) => changes.push(format!("{}: not recorded: {error}", case.name)),
        }
    }
    for entry in fs::read_dir(&folder).unwrap() {
        let name = entry.unwrap().file_name().to_string_lossy().into_owned();
        if name.ends_with(".json") && !names.contains(&name) {
            changes.push(format!("{name}: its case does not ship any more"));
        }
    }
    assert!(
        changes.is_empty(),
        "{} changes; if they are meant, record anew with UPDATE_SNAPSHOTS=1:\n{}",
        changes.len(),
        changes.join("\n")
    );
}
