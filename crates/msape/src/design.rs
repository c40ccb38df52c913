//! The coupled design: passes through the modules until the mass settles.

use serde::{Deserialize, Serialize};

/// A designed vehicle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Design {}
