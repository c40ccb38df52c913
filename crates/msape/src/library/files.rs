//! The files that are built into the program, in lists, so that a program that reads only one of them, as the page reads
//! cases, holds no other.

/// Paths below `data`, and texts.
type Files = &'static [(&'static str, &'static str)];

/// Files of the library, as converted by the build script.
pub(super) static SHIPPED: Files = include!(concat!(env!("OUT_DIR"), "/shipped_files.rs"));
/// Texts of the files of the library.
pub(super) static LIBRARY: Files = include!(concat!(env!("OUT_DIR"), "/library_files.rs"));
/// Shipped cases, and the defaults of earlier versions.
static CASES: Files = include!(concat!(env!("OUT_DIR"), "/case_files.rs"));
/// References; empty without the feature `validation`.
static VALIDATION: Files = include!(concat!(env!("OUT_DIR"), "/validation_files.rs"));
/// Materials in depth, and references for them; empty without the feature `ablation`.
static ABLATORS: Files = include!(concat!(env!("OUT_DIR"), "/ablator_files.rs"));

/// Text of a data file by its path below `data`, such as `planets/earth.toml`.
pub fn data_file(path: &str) -> Option<&'static str> {
    [LIBRARY, CASES, ABLATORS, VALIDATION]
        .into_iter()
        .find_map(|files| of(files, path))
}

/// Paths and texts of the data files in one folder, such as `planets`; folders in it left out.
pub fn data_folder(folder: &str) -> impl Iterator<Item = (&'static str, &'static str)> + use<> {
    let inside = [LIBRARY, CASES, ABLATORS, VALIDATION].map(|files| within(files, folder));
    inside.into_iter().flatten()
}

/// Text of a file in `cases` or `versions` by its path below `data`.
pub fn case_file(path: &str) -> Option<&'static str> {
    of(CASES, path)
}

/// Paths and texts of the shipped cases.
pub fn cases() -> impl Iterator<Item = (&'static str, &'static str)> {
    within(CASES, "cases")
}

fn of(files: Files, path: &str) -> Option<&'static str> {
    let file = files.iter().find(|(name, _)| *name == path);
    file.map(|(_, text)| *text)
}

/// The files of a folder, those of folders in it left out.
pub(super) fn within(
    files: Files,
    folder: &str,
) -> impl Iterator<Item = (&'static str, &'static str)> + use<> {
    let prefix = format!("{folder}/");
    files.iter().copied().filter(move |(name, _)| {
        let inside = name.strip_prefix(&prefix);
        inside.is_some_and(|file| !file.contains('/'))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_build_made_of_a_file_is_what_the_file_says() {
        use crate::aero::AxialForce;
        use crate::data::Data;
        use serde_json::Value;
        assert_eq!(SHIPPED.len(), LIBRARY.len());
        for ((path, made), (_, text)) in SHIPPED.iter().zip(LIBRARY) {
            if path.ends_with(".csv") {
                let [made, read] = [Data::Shipped(made), Data::Own(text)]
                    .map(|data| AxialForce::parse(data).unwrap());
                assert_eq!(format!("{made:?}"), format!("{read:?}"), "{path}");
            } else {
                let [made, read] = [Data::Shipped(made), Data::Own(text)]
                    .map(|data| data.read::<Value>().unwrap());
                assert_eq!(made, read, "{path}");
            }
        }
    }

    #[test]
    fn every_file_is_in_one_list_and_is_found_in_it() {
        let lists = [LIBRARY, CASES, ABLATORS, VALIDATION];
        for (path, text) in lists.into_iter().flatten() {
            let holding = lists.iter().filter(|files| of(files, path).is_some());
            assert_eq!(
                (holding.count(), data_file(path)),
                (1, Some(*text)),
                "{path}"
            );
        }
        assert!(
            case_file("versions/0.1.toml").is_some() && case_file("planets/earth.toml").is_none()
        );
        assert!(cases().any(|(path, _)| path == "cases/run-page.toml"));
        assert!(cases().all(|(path, _)| !path.contains("0.1")));
        assert_eq!(
            data_folder("planets").count(),
            within(LIBRARY, "planets").count()
        );
    }
}
