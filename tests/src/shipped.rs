//! Shipped cases.

use msape::library::data_folder;
use msape::quantity::Job;
use msape::{Answer, Case, InputError, Library, Request};

/// A case of the folder `cases`.
#[derive(Clone, Debug)]
pub struct Shipped {
    /// File name without extension.
    pub name: &'static str,
    /// Text of the file.
    pub text: &'static str,
    /// Case.
    pub case: Case,
    /// Command that solves it: a design is designed, a vehicle is flown.
    pub job: Job,
}

impl Shipped {
    /// Solves the case.
    ///
    /// # Errors
    /// All faults of the case.
    pub fn solve(&self, library: &Library, request: Request) -> Result<Answer, Vec<InputError>> {
        match self.job {
            Job::Fly => msape::fly(&self.case, library, request),
            Job::Design => msape::design(&self.case, library, request),
        }
    }
}

/// All cases, by name.
///
/// # Errors
/// Name and fault of a case that cannot be read.
pub fn cases() -> Result<Vec<Shipped>, String> {
    let mut files: Vec<_> = data_folder("cases")
        .filter_map(|(path, text)| {
            let name = path.strip_prefix("cases/")?.strip_suffix(".toml")?;
            Some((name, text))
        })
        .collect();
    // files are sorted with their extension: "a-b.toml" before "a.toml"
    files.sort_by_key(|(name, _)| *name);
    files
        .into_iter()
        .map(|(name, text)| {
            let case = Case::from_text(text).map_err(|faults| format!("{name}: {faults:?}"))?;
            let designed = case.values.keys().any(|key| key.starts_with("design."));
            let job = if designed { Job::Design } else { Job::Fly };
            Ok(Shipped {
                name,
                text,
                case,
                job,
            })
        })
        .collect()
}
