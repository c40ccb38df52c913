//! Data of the library that the page shows.

use crate::catalog::Catalog;
use crate::desk::Desk;
use crate::protocol::Question;
use msape::progress::Progress;
use serde::{Deserialize, Serialize};

/// Asks for the catalog.
#[derive(Debug, Serialize, Deserialize)]
pub struct ReadCatalog;

impl Question for ReadCatalog {
    type Answer = Catalog;
    type Refusal = String;

    fn answer(self, desk: &Desk, _: &mut dyn Progress) -> Result<Catalog, String> {
        Ok(Catalog::of(&desk.library))
    }
}
