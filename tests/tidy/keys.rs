//! Inputs are named once: outside `quantity` code uses the items, not the text of their keys.

use crate::{File, assert_none, files};
use msape::quantity::inputs;

/// Folders whose code names inputs by their items.
const FOLDERS: [&str; 5] = [
    "crates/msape",
    "crates/cad",
    "crates/cli",
    "crates/benchmark",
    "web",
];

/// Whether a file is of the list itself, or of tests, which hold text to test text.
fn is_exempt(path: &str) -> bool {
    path.starts_with("crates/msape/src/quantity") || path.contains("/tests")
}

/// Quoted texts of a line of code, without escapes.
fn quoted(line: &str) -> impl Iterator<Item = &str> {
    line.split('"').skip(1).step_by(2)
}

/// Words of a text that may be keys.
fn words(text: &str) -> impl Iterator<Item = &str> {
    let between = |c: char| !(c.is_ascii_lowercase() || c.is_ascii_digit() || "_.".contains(c));
    text.split(between).map(|word| word.trim_matches('.'))
}

/// Keys of inputs that stand in texts of the code of a file, alone or among other words.
fn keys(file: &File) -> Vec<String> {
    let code = file.text.split("#[cfg(test)]\nmod tests").next();
    let code = code.unwrap_or_default().lines().zip(1..);
    let code = code.filter(|(line, _)| !line.trim_start().starts_with("//"));
    let texts = code.flat_map(|(line, number)| quoted(line).map(move |text| (text, number)));
    let found = texts.flat_map(|(text, number)| words(text).map(move |word| (word, number)));
    let is_key =
        |text: &str| inputs().any(|input| input.key == text || input.aliases.contains(&text));
    found
        .filter(|(text, _)| is_key(text))
        .map(|(text, number)| format!("{}:{number}: \"{text}\"", file.path))
        .collect()
}

#[test]
fn no_key_of_an_input_stands_as_text_outside_the_list() {
    let code = FOLDERS.iter().flat_map(|folder| files(folder));
    let code = code.filter(|file| file.path.ends_with(".rs") && !is_exempt(&file.path));
    assert_none(&code.flat_map(|file| keys(&file)).collect::<Vec<_>>());
}

#[test]
fn a_key_as_text_is_found_and_one_in_a_test_is_not() {
    let file = |text: &str| File {
        path: "web/src/x.rs".to_string(),
        text: text.to_string(),
    };
    let line = "case.set(\"entry.speed_m_s\", \"1\"); // \"entry.frame\"\n";
    assert_eq!(keys(&file(line)).len(), 2);
    let told = "let message = \"Give vehicle.dof=6, or no vehicle.mass_kg.\";\n";
    assert_eq!(keys(&file(told)).len(), 2);
    let tested = format!("fn f() {{}}\n#[cfg(test)]\nmod tests {{\n{line}}}\n");
    assert!(keys(&file(&tested)).is_empty());
    assert!(keys(&file("/// A comment on \"entry.speed_m_s\".\n")).is_empty());
}
