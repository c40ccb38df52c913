//! What is kept in the browser, in IndexedDB: the document as it is now, and the named runs.

use crate::display::UnitSystem;
use crate::state::document::{Document, Rows, Run, recorded};
use idb::{Database, DatabaseEvent, Factory, ObjectStoreParams, Query, TransactionMode};
use msape::case::Version;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::sync::Arc;
use wasm_bindgen::JsValue;
use wasm_bindgen_futures::JsFuture;

const DATABASE: &str = "msape";
const VERSION: u32 = 1;
/// Store of single things, by name.
const THINGS: &str = "things";
/// Store of named runs, by identifier.
const RUNS: &str = "runs";
const CURRENT: &str = "current";

/// The open database.
pub struct Store(Database);

/// The document as it is kept; the runs are kept apart.
#[derive(Serialize, Deserialize)]
struct Current {
    case: String,
    units: UnitSystem,
    unit_of: BTreeMap<String, String>,
    /// Absent in what was kept before outlines could be imported.
    #[serde(default)]
    outlines: BTreeMap<String, Rows>,
    #[serde(default)]
    tables: BTreeMap<String, Rows>,
    /// Version that kept it; absent in what the first version kept.
    #[serde(default)]
    version: Option<Version>,
}

/// What was kept.
#[derive(Default)]
pub struct Kept {
    /// The document with its runs.
    pub document: Option<Document>,
    /// The runs, also when there is no document.
    pub runs: BTreeMap<String, Run>,
    /// What changed under the document's case since it was kept.
    pub remarks: Vec<String>,
}

impl Store {
    /// Opens the database, and makes it where there is none.
    ///
    /// # Errors
    /// What the browser refuses.
    pub async fn open() -> Result<Store, idb::Error> {
        let mut request = Factory::new()?.open(DATABASE, Some(VERSION))?;
        request.on_upgrade_needed(|event| {
            let made = event.database().and_then(|database| {
                database.create_object_store(THINGS, ObjectStoreParams::new())?;
                database.create_object_store(RUNS, ObjectStoreParams::new())
            });
            if let Err(error) = made {
                leptos::logging::error!("the browser's database cannot be made: {error}");
            }
        });
        Ok(Store(request.await?))
    }

    /// The document that was kept, with its runs.
    ///
    /// # Errors
    /// What the browser refuses.
    pub async fn load(&self) -> Result<Kept, idb::Error> {
        let transaction = self
            .0
            .transaction(&[THINGS, RUNS], TransactionMode::ReadOnly)?;
        let things = transaction.object_store(THINGS)?;
        let current = things.get(Query::Key(CURRENT.into()))?.await?;
        let store = transaction.object_store(RUNS)?;
        let keys = store.get_all_keys(None, None)?.await?;
        let values = store.get_all(None, None)?.await?;
        let runs: BTreeMap<String, Run> = keys
            .iter()
            .zip(&values)
            .filter_map(|(key, value)| Some((key.as_string()?, read(value)?)))
            .collect();
        let mut remarks = Vec::new();
        let document = current
            .and_then(|value| read::<Current>(&value))
            .and_then(|current| {
                let case = recorded(&current.case, current.version).ok()?;
                remarks = case.remarks;
                Some(Document {
                    case: Arc::new(case.case),
                    units: current.units,
                    unit_of: Arc::new(current.unit_of),
                    runs: Arc::new(runs.clone()),
                    outlines: Arc::new(current.outlines),
                    tables: Arc::new(current.tables),
                })
            });
        Ok(Kept {
            document,
            runs,
            remarks,
        })
    }

    /// Keeps a document; of the runs, those that differ from what was kept `before`.
    ///
    /// # Errors
    /// What the browser refuses, such as a full disk.
    pub async fn save(
        &self,
        before: &BTreeMap<String, Run>,
        document: &Document,
    ) -> Result<(), idb::Error> {
        let transaction = self
            .0
            .transaction(&[THINGS, RUNS], TransactionMode::ReadWrite)?;
        let current = Current {
            case: document.case.to_toml(),
            units: document.units,
            unit_of: (*document.unit_of).clone(),
            outlines: (*document.outlines).clone(),
            tables: (*document.tables).clone(),
            version: Some(Version::CURRENT),
        };
        transaction
            .object_store(THINGS)?
            .put(&written(&current), Some(&CURRENT.into()))?
            .await?;
        let runs = transaction.object_store(RUNS)?;
        for (id, run) in document.runs.iter() {
            if before.get(id) != Some(run) {
                runs.put(&written(run), Some(&id.into()))?.await?;
            }
        }
        for id in before.keys().filter(|id| !document.runs.contains_key(*id)) {
            runs.delete(Query::Key(id.into()))?.await?;
        }
        transaction.commit()?.await?;
        Ok(())
    }
}

fn read<T: for<'de> Deserialize<'de>>(value: &JsValue) -> Option<T> {
    serde_json::from_str(&value.as_string()?).ok()
}

fn written<T: Serialize>(value: &T) -> JsValue {
    // Maps of strings and numbers can always be written.
    serde_json::to_string(value).unwrap_or_default().into()
}

/// Whether the browser has promised never to clear what is kept.
pub async fn is_protected() -> bool {
    answer(leptos::prelude::window().navigator().storage().persisted()).await
}

/// Asks the browser never to clear what is kept; whether it promises.
pub async fn protect() -> bool {
    answer(leptos::prelude::window().navigator().storage().persist()).await
}

async fn answer(promise: Result<js_sys::Promise, JsValue>) -> bool {
    match promise {
        Ok(promise) => JsFuture::from(promise)
            .await
            .is_ok_and(|answer| answer.as_bool() == Some(true)),
        Err(_) => false,
    }
}
