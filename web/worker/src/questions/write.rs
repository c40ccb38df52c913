//! A model as a file for CAD, meshes or documents.

use crate::desk::Desk;
use crate::protocol::Question;
use cad::export::{Format, Info, Model};
use msape::progress::Progress;
use serde::{Deserialize, Serialize};

/// Asks for a model as a file, in bytes.
#[derive(Debug, Serialize, Deserialize)]
pub struct Write(pub Format, pub Box<Model>);

impl Question for Write {
    type Answer = Vec<u8>;
    type Refusal = String;

    fn answer(self, _: &Desk, _: &mut dyn Progress) -> Result<Vec<u8>, String> {
        Ok(self.0.write(&self.1, &Info::default()))
    }
}
