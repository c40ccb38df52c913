//! Style checks: data files, headings, lengths, words, documents, licenses.

mod data;
mod deny;
mod documents;
mod keys;
mod layers;
mod sources;

use std::fs;
use std::path::{Path, PathBuf};

/// Root folder of the workspace.
fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// File of the project: path relative to the root with `/`, and text.
struct File {
    path: String,
    text: String,
}

/// Text files below a folder of the project, sorted by path; built and installed files are left out.
fn files(folder: &str) -> Vec<File> {
    let mut found = Vec::new();
    collect(&root().join(folder), &mut found);
    found.sort();
    let files = found.into_iter().filter_map(|path| {
        let text = fs::read_to_string(&path).ok()?;
        let path = path.strip_prefix(root()).unwrap().to_string_lossy();
        Some(File {
            path: path.replace('\\', "/"),
            text,
        })
    });
    files.collect()
}

fn collect(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if ["target", "dist", "dist-trunk", "node_modules", ".git"].contains(&name.as_str()) {
            continue;
        }
        if path.is_dir() {
            collect(&path, found);
        } else {
            found.push(path);
        }
    }
}

/// Fails with all faults.
fn assert_none(faults: &[String]) {
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}
