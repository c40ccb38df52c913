//! The flight of a vehicle as it is.

use crate::desk::Desk;
use crate::protocol::{Fault, Question, faults};
use msape::progress::Progress;
use msape::{Answer, Case, Request, fly};
use serde::{Deserialize, Serialize};

/// Asks for the flight of a vehicle as it is.
#[derive(Debug, Serialize, Deserialize)]
pub struct Fly(pub Case);

impl Question for Fly {
    type Answer = Answer;
    type Refusal = Vec<Fault>;

    fn answer(self, desk: &Desk, _: &mut dyn Progress) -> Result<Answer, Vec<Fault>> {
        fly(&self.0, &desk.library, Request::Steps).map_err(faults)
    }
}
