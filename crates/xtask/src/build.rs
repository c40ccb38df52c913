//! Build of the deployable folder `dist/`: static files that work in any folder of any host.
//!
//! The page `index.html` refers to its code as `./name`. Code is the content of `web/page` and, for each binary of
//! `web`, the pair `name.js` and `name_bg.wasm` that wasm-bindgen generates. In `dist/` all code is in one folder named
//! by a hash of its content, so that a browser may cache it indefinitely and an app never loads the worker of another
//! release.

use std::{
    env, fs,
    hash::{DefaultHasher, Hasher},
    path::{Path, PathBuf},
};

use anyhow::{Context, Result, bail};

use crate::{
    licenses,
    project::{Project, announce, files_below, run},
    setup, sizes,
};

/// Binaries of [`PACKAGES`].
const BINARIES: [&str; 3] = ["app", "worker", "tools"];

/// Packages that the browser runs.
pub const PACKAGES: [&str; 2] = ["msape-app", "msape-worker"];

/// Builds `dist/` and prints the sizes of its files; returns those of its parts.
pub fn dist(project: &Project) -> Result<sizes::Sizes> {
    setup::for_build(project)?;
    compile(project)?;
    announce("Putting dist/ together");
    let code = project.dist.join("code");
    if project.dist.exists() {
        fs::remove_dir_all(&project.dist).context("cannot replace dist/")?;
    }
    fs::create_dir_all(&code)?;
    bind(project, &code)?;
    copy(&project.root.join("web/page"), &code)?;
    let named = format!("code-{:016x}", digest(&code)?);
    let page = fs::read_to_string(project.root.join("index.html"))?;
    fs::write(
        project.dist.join("index.html"),
        with_code_in(&named, &page, &code)?,
    )?;
    fs::rename(&code, project.dist.join(&named))?;
    let sizes = sizes::print(&project.dist)?;
    // not counted: loaded only on request
    licenses::write(project)?;
    Ok(sizes)
}

/// Builds the command as described in the README: `target/release/msape`.
pub fn command(project: &Project) -> Result<()> {
    announce("Building the command");
    let package = ["build", "--locked", "--release", "--package", "msape-cli"];
    run(project.command("cargo").args(package))
}

/// Compiles the binaries without local paths in them: the same source gives the same files anywhere.
fn compile(project: &Project) -> Result<()> {
    announce("Building the app for the browser");
    let crates = env::var_os("CARGO_HOME")
        .map(PathBuf::from)
        .or_else(|| Some(env::home_dir()?.join(".cargo")))
        .context("no home folder")?;
    let paths = [(&crates, "cargo"), (&project.root, "msape")]
        .map(|(folder, name)| format!("--remap-path-prefix={}={name}", folder.display()));
    // type erasure of Leptos views: less code to download
    let flags = [paths.as_slice(), &["--cfg=erase_components".to_string()]].concat();
    let arguments = [
        "build",
        "--locked",
        "--profile",
        "web",
        "--bins",
        "--package",
        PACKAGES[0],
        "--package",
        PACKAGES[1],
        "--target",
        setup::WASM,
    ];
    // CARGO_ENCODED_RUSTFLAGS separates flags by 0x1f, so that a path may contain spaces
    run(project
        .command("cargo")
        .args(arguments)
        .env("CARGO_ENCODED_RUSTFLAGS", flags.join("\u{1f}")))
}

/// Generates the pairs of JavaScript and WebAssembly.
fn bind(project: &Project, code: &Path) -> Result<()> {
    let modules = project.target.join(setup::WASM).join("web");
    let modules = BINARIES.map(|binary| modules.join(binary).with_extension("wasm"));
    run(project
        .command(project.tools.join("web-bindgen"))
        .arg(code)
        .args(modules))
}

/// Copies all files of a folder into another, recursively.
pub fn copy(from: &Path, to: &Path) -> Result<()> {
    for file in files_below(from)? {
        let copied = to.join(file.strip_prefix(from)?);
        fs::create_dir_all(copied.parent().context("a file in no folder")?)?;
        fs::copy(&file, copied)?;
    }
    Ok(())
}

/// Hash over the names and contents of all files.
fn digest(folder: &Path) -> Result<u64> {
    let mut hasher = DefaultHasher::new();
    for file in files_below(folder)? {
        hasher.write(slashed(file.strip_prefix(folder)?).as_bytes());
        hasher.write(&fs::read(file)?);
    }
    Ok(hasher.finish())
}

/// The page without what is for Trunk, with every `"./name"` replaced by its path in the folder `named`; a name that is not in `code` is an error.
fn with_code_in(named: &str, page: &str, code: &Path) -> Result<String> {
    let lines = page.lines().filter(|line| !line.contains("data-trunk"));
    let page = lines.flat_map(|line| [line, "\n"]).collect::<String>();
    for name in page
        .split("\"./")
        .skip(1)
        .filter_map(|rest| rest.split('"').next())
    {
        if !code.join(name).is_file() {
            bail!(
                "index.html refers to ./{name}, which is neither in web/page nor made by the build"
            );
        }
    }
    Ok(page.replace("\"./", &format!("\"./{named}/")))
}

fn slashed(path: &Path) -> String {
    path.to_string_lossy().replace('\\', "/")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_leads_into_the_folder_and_an_unknown_name_is_an_error() {
        let code = Path::new(env!("CARGO_MANIFEST_DIR"));
        let moved = with_code_in(
            "code-1",
            r#"<a href="./Cargo.toml"> <b c="./src/main.rs">"#,
            code,
        );
        assert_eq!(
            moved.unwrap(),
            "<a href=\"./code-1/Cargo.toml\"> <b c=\"./code-1/src/main.rs\">\n"
        );
        assert!(with_code_in("code-1", r#"<a href="./none.js">"#, code).is_err());
        let trunk = "<a>\n<link data-trunk href=\"./none.js\">\n<b>\n";
        assert_eq!(with_code_in("code-1", trunk, code).unwrap(), "<a>\n<b>\n");
    }
}
