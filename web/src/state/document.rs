//! What undo steps through: the case, how it is shown, and the runs that are kept.

use crate::display::UnitSystem;
use msape::Case;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::sync::Arc;

/// A document; never changed, only replaced.
#[derive(Clone, Debug, PartialEq)]
pub struct Document {
    /// The case.
    pub case: Arc<Case>,
    /// System of units on screen.
    pub units: UnitSystem,
    /// Unit symbols chosen for single inputs, by key.
    pub unit_of: Arc<BTreeMap<String, String>>,
    /// Named runs, by identifier.
    pub runs: Arc<BTreeMap<String, Run>>,
    /// Outlines that were imported, by name.
    pub outlines: Arc<BTreeMap<String, Rows>>,
    /// Tables of coefficients that were imported, by name.
    pub tables: Arc<BTreeMap<String, Rows>>,
}

/// Rows of `outline.points` or of `vehicle.aerodynamics.table`.
pub type Rows = Vec<Vec<f64>>;

/// A run kept by name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Run {
    /// Name given by the user.
    pub name: String,
    /// When it was saved, ms since 1970.
    pub saved_ms: f64,
    /// The case as TOML.
    pub case: String,
    /// Headline results when saved: output key and value in its SI unit.
    pub headline: Vec<(String, f64)>,
}

impl Document {
    /// A document of a case alone.
    pub fn new(case: Case) -> Document {
        Document {
            case: Arc::new(case),
            units: UnitSystem::Report,
            unit_of: Arc::default(),
            runs: Arc::default(),
            outlines: Arc::default(),
            tables: Arc::default(),
        }
    }

    /// The same with the case changed.
    #[must_use]
    pub fn with_case(&self, change: impl FnOnce(&mut Case)) -> Document {
        let mut case = (*self.case).clone();
        change(&mut case);
        Document {
            case: Arc::new(case),
            ..self.clone()
        }
    }

    /// The same with the kept runs changed.
    #[must_use]
    pub fn with_runs(&self, change: impl FnOnce(&mut BTreeMap<String, Run>)) -> Document {
        let mut runs = (*self.runs).clone();
        change(&mut runs);
        Document {
            runs: Arc::new(runs),
            ..self.clone()
        }
    }

    /// The same with the imported outlines changed.
    #[must_use]
    pub fn with_outlines(&self, change: impl FnOnce(&mut BTreeMap<String, Rows>)) -> Document {
        let mut outlines = (*self.outlines).clone();
        change(&mut outlines);
        Document {
            outlines: Arc::new(outlines),
            ..self.clone()
        }
    }

    /// The same with the imported tables changed.
    #[must_use]
    pub fn with_tables(&self, change: impl FnOnce(&mut BTreeMap<String, Rows>)) -> Document {
        let mut tables = (*self.tables).clone();
        change(&mut tables);
        Document {
            tables: Arc::new(tables),
            ..self.clone()
        }
    }

    /// The same with one input shown in another unit.
    #[must_use]
    pub fn with_unit_of(&self, key: &str, symbol: &str) -> Document {
        let mut unit_of = (*self.unit_of).clone();
        unit_of.insert(key.to_string(), symbol.to_string());
        Document {
            unit_of: Arc::new(unit_of),
            ..self.clone()
        }
    }
}
