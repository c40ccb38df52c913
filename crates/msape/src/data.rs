//! Data files: text of the user, or a shipped file as converted by the build script.
//!
//! The build reads the TOML and CSV of the folder `data` once and embeds the same keys and values in the form that the
//! program reads fastest. TOML and CSV of the user are read with the feature `own-data` only, which the page, where nobody can
//! add such a file, is built without.

mod ordered;

use ordered::Ordered;
use serde::de::{DeserializeOwned, IgnoredAny};
use std::collections::BTreeMap;

/// A data file.
#[derive(Clone, Copy, Debug)]
pub enum Data<'d> {
    /// Text of a file of the user.
    #[cfg(feature = "own-data")]
    Own(&'d str),
    /// A shipped file as converted by the build script.
    Shipped(&'d str),
}

#[cfg(feature = "own-data")]
impl<'d> From<&'d str> for Data<'d> {
    fn from(text: &'d str) -> Self {
        Self::Own(text)
    }
}

#[cfg(feature = "own-data")]
impl<'d> From<&'d String> for Data<'d> {
    fn from(text: &'d String) -> Self {
        Self::Own(text)
    }
}

impl Data<'_> {
    /// The file as a type that names its keys.
    ///
    /// # Errors
    /// A message with place, key and the values allowed.
    pub fn read<T: DeserializeOwned>(self) -> Result<T, String> {
        match self {
            #[cfg(feature = "own-data")]
            Self::Own(text) => toml::from_str(text).map_err(|error| error.to_string()),
            Self::Shipped(text) => serde_json::from_str(text)
                .and_then(|file| T::deserialize(Ordered(Some(&file))))
                .map_err(|error| error.to_string()),
        }
    }

    /// The text of a file of the user.
    pub fn own(&self) -> Option<&str> {
        match self {
            #[cfg(feature = "own-data")]
            Self::Own(text) => Some(text),
            Self::Shipped(_) => None,
        }
    }

    /// Whether the file has a key, or a table of this name.
    pub fn has(self, key: &str) -> bool {
        let keys = self.read::<BTreeMap<String, IgnoredAny>>();
        keys.is_ok_and(|keys| keys.contains_key(key))
    }
}
