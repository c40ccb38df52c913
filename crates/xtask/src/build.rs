//! The deployable folder `dist/`: static files that work in any folder of any host.

use std::{
    fs,
    hash::{DefaultHasher, Hasher},
    path::{Path, PathBuf},
};

use anyhow::{Context, Result, bail};

use crate::{
    project::{Project, announce, files_below, run},
    setup, sizes,
};

/// Builds `dist/` and prints the sizes of what is in it.
pub fn dist(project: &Project) -> Result<()> {
    setup::for_build(project)?;
    announce("Building the app into dist/");
    run(project
        .command("trunk")
        .args(["build", "--release", "--offline", "true"]))?;
    shrink(project)?;
    fingerprint(&project.dist)?;
    sizes::print(&project.dist)
}

/// Makes the WebAssembly smaller, if wasm-opt happens to be installed.
fn shrink(project: &Project) -> Result<()> {
    let Some(wasm_opt) = project.locate("wasm-opt") else {
        return Ok(());
    };
    announce("Making the WebAssembly smaller with wasm-opt");
    for file in files_below(&project.dist)? {
        if file
            .extension()
            .is_some_and(|extension| extension == "wasm")
        {
            run(project
                .command(&wasm_opt)
                .args(["-Oz", "--all-features", "-o"])
                .arg(&file)
                .arg(&file))?;
        }
    }
    Ok(())
}

/// Moves code and styles into a folder named by their content, so that a browser may keep them for ever and an app never
/// meets the worker of another release. The page itself, `static/` and a service worker keep their addresses.
fn fingerprint(dist: &Path) -> Result<()> {
    let page_file = dist.join("index.html");
    let page = fs::read_to_string(&page_file)?;
    let code: Vec<PathBuf> = files_below(dist)?
        .into_iter()
        .filter(|file| is_code(dist, file))
        .collect();
    let mut hasher = DefaultHasher::new();
    for file in &code {
        hasher.write(file.strip_prefix(dist)?.to_string_lossy().as_bytes());
        hasher.write(&fs::read(file)?);
    }
    let folder = format!("code-{:016x}", hasher.finish());
    for file in &code {
        let moved = dist.join(&folder).join(file.strip_prefix(dist)?);
        fs::create_dir_all(moved.parent().context("a file in no folder")?)?;
        fs::rename(file, moved)?;
    }
    let mut page_moved = page.clone();
    for file in &code {
        let name = file
            .strip_prefix(dist)?
            .to_string_lossy()
            .replace('\\', "/");
        page_moved =
            page_moved.replace(&format!("\"./{name}\""), &format!("\"./{folder}/{name}\""));
    }
    if page_moved == page {
        bail!("index.html refers to none of the files that trunk made");
    }
    fs::write(page_file, page_moved)?;
    Ok(())
}

fn is_code(dist: &Path, file: &Path) -> bool {
    let Ok(name) = file.strip_prefix(dist) else {
        return false;
    };
    let kept = name.starts_with("static") || name == Path::new("sw.js");
    !kept
        && name
            .extension()
            .is_some_and(|extension| ["js", "wasm", "css"].iter().any(|code| extension == *code))
}
