//! Storage in the browser's IndexedDB: current case and units, imported outlines and tables, and named runs, each in a
//! record of its own.

pub mod ledger;
pub mod record;
pub mod stock;
#[cfg(test)]
mod tests;

use idb::{
    Database, DatabaseEvent, Factory, ObjectStore, ObjectStoreParams, Query, Transaction,
    TransactionMode, TransactionResult,
};
use js_sys::Promise;
use record::{Change, Clash, Found, Key, Shelf, Written};
use std::cell::RefCell;
use std::rc::Rc;
use wasm_bindgen::JsValue;
use wasm_bindgen_futures::JsFuture;

const DATABASE: &str = "msape";
const VERSION: u32 = 1;

/// Database, opened on first use and again after a failure.
#[derive(Clone, Default)]
pub struct Store(Rc<RefCell<Line>>);

#[derive(Default)]
struct Line {
    database: Option<Rc<Database>>,
    /// Promise resolved when the active opening has ended, successfully or not.
    opening: Option<Promise>,
}

impl Store {
    /// Reads all records.
    ///
    /// # Errors
    /// The browser's reason for refusing.
    pub async fn load(&self) -> Result<Vec<(Key, Found)>, String> {
        let database = self.database().await?;
        let loaded = load(&database).await;
        self.unless_failed(loaded)
    }

    /// Makes all changes or none: the transaction is aborted if a record is not as expected.
    ///
    /// # Errors
    /// The browser's reason for refusing.
    pub async fn write(&self, changes: &[Change]) -> Result<Written, String> {
        if changes.is_empty() {
            return Ok(Written::All);
        }
        let database = self.database().await?;
        let written = write(&database, changes).await;
        self.unless_failed(written)
    }

    /// Moves a record unchanged, whatever its content.
    ///
    /// # Errors
    /// The browser's reason for refusing.
    pub async fn set_aside(&self, key: &Key, to: &Key) -> Result<(), String> {
        let database = self.database().await?;
        let moved = set_aside(&database, key, to).await;
        self.unless_failed(moved)
    }

    /// Removes a record, whatever its content.
    ///
    /// # Errors
    /// The browser's reason for refusing.
    pub async fn remove(&self, key: &Key) -> Result<(), String> {
        let database = self.database().await?;
        let removed = remove(&database, key).await;
        self.unless_failed(removed)
    }

    async fn database(&self) -> Result<Rc<Database>, String> {
        loop {
            if let Some(database) = self.0.borrow().database.clone() {
                return Ok(database);
            }
            let Some(opening) = self.0.borrow().opening.clone() else {
                break;
            };
            // the promise is never rejected; the caller checks the result itself
            let _ = JsFuture::from(opening).await;
        }
        let mut end = None;
        let opening = Promise::new(&mut |resolve, _| end = Some(resolve));
        self.0.borrow_mut().opening = Some(opening);
        let opened = open(self.clone()).await;
        let opened = opened.map(Rc::new).map_err(|error| error.to_string());
        *self.0.borrow_mut() = Line {
            database: opened.as_ref().ok().cloned(),
            opening: None,
        };
        if let Some(end) = end {
            // resolving a promise does not throw
            let _ = end.call0(&JsValue::UNDEFINED);
        }
        opened
    }

    fn unless_failed<T>(&self, result: Result<T, Failure>) -> Result<T, String> {
        result.map_err(|Failure(reason)| {
            self.close();
            reason
        })
    }

    fn close(&self) {
        if let Some(database) = self.0.borrow_mut().database.take() {
            database.close();
        }
    }
}

/// The browser's reason for refusing.
struct Failure(String);

impl From<idb::Error> for Failure {
    fn from(error: idb::Error) -> Failure {
        Failure(error.to_string())
    }
}

async fn open(store: Store) -> Result<Database, idb::Error> {
    let mut request = Factory::new()?.open(DATABASE, Some(VERSION))?;
    request.on_upgrade_needed(|event| {
        let made = event.database().and_then(|database| {
            Shelf::ALL.into_iter().try_for_each(|shelf| {
                database
                    .create_object_store(shelf.name(), ObjectStoreParams::new())
                    .map(drop)
            })
        });
        if let Err(error) = made {
            leptos::logging::error!("the browser's database cannot be made: {error}");
        }
    });
    let mut database = request.await?;
    // a later version of the program wants to upgrade the database and must not wait for this tab
    database.on_version_change(move |_| store.close());
    Ok(database)
}

fn begin(database: &Database, mode: TransactionMode) -> Result<Transaction, idb::Error> {
    database.transaction(&Shelf::ALL.map(Shelf::name), mode)
}

fn shelf(transaction: &Transaction, key: &Key) -> Result<ObjectStore, idb::Error> {
    transaction.object_store(key.shelf.name())
}

/// Waits until a transaction is committed.
async fn committed(transaction: Transaction) -> Result<(), Failure> {
    match transaction.commit()?.await? {
        TransactionResult::Committed => Ok(()),
        TransactionResult::Aborted => Err(Failure(
            "the browser gave up writing; its disk may be full".to_string(),
        )),
    }
}

async fn load(database: &Database) -> Result<Vec<(Key, Found)>, Failure> {
    let transaction = begin(database, TransactionMode::ReadOnly)?;
    let mut records = Vec::new();
    for shelf in Shelf::ALL {
        let store = transaction.object_store(shelf.name())?;
        let keys = store.get_all_keys(None, None)?.await?;
        let values = store.get_all(None, None)?.await?;
        for (key, value) in keys.iter().zip(&values) {
            if let (Some(id), Some(found)) = (key.as_string(), found(value)) {
                records.push((Key { shelf, id }, found));
            }
        }
    }
    Ok(records)
}

async fn write(database: &Database, changes: &[Change]) -> Result<Written, Failure> {
    let transaction = begin(database, TransactionMode::ReadWrite)?;
    let clashes = try_change(&transaction, changes).await;
    match clashes {
        Ok(clashes) if clashes.is_empty() => committed(transaction).await.map(|()| Written::All),
        Ok(clashes) => {
            // no change was requested that would need an abort
            let _ = transaction.abort();
            Ok(Written::Nothing(clashes))
        }
        Err(error) => {
            // writes before the failure must not be committed alone; a finished transaction needs no abort
            let _ = transaction.abort();
            Err(error)
        }
    }
}

/// Requests all changes if every record is as expected.
async fn try_change(transaction: &Transaction, changes: &[Change]) -> Result<Vec<Clash>, Failure> {
    let mut clashes = Vec::new();
    for Change { key, expected, .. } in changes {
        let value = shelf(transaction, key)?.get(Query::Key((&key.id).into()))?;
        let found = value.await?.as_ref().and_then(found);
        if found != expected.clone().map(Found::Text) {
            clashes.push((key.clone(), found));
        }
    }
    if !clashes.is_empty() {
        return Ok(clashes);
    }
    for Change { key, text, .. } in changes {
        let store = shelf(transaction, key)?;
        match text {
            Some(text) => drop(store.put(&text.into(), Some(&(&key.id).into()))?.await?),
            None => store.delete(Query::Key((&key.id).into()))?.await?,
        }
    }
    Ok(clashes)
}

async fn set_aside(database: &Database, key: &Key, to: &Key) -> Result<(), Failure> {
    let transaction = begin(database, TransactionMode::ReadWrite)?;
    let store = shelf(&transaction, key)?;
    if let Some(value) = store.get(Query::Key((&key.id).into()))?.await? {
        shelf(&transaction, to)?
            .put(&value, Some(&(&to.id).into()))?
            .await?;
        store.delete(Query::Key((&key.id).into()))?.await?;
    }
    committed(transaction).await
}

async fn remove(database: &Database, key: &Key) -> Result<(), Failure> {
    let transaction = begin(database, TransactionMode::ReadWrite)?;
    shelf(&transaction, key)?
        .delete(Query::Key((&key.id).into()))?
        .await?;
    committed(transaction).await
}

/// Content of a value; `None` if there is no record.
fn found(value: &JsValue) -> Option<Found> {
    if value.is_undefined() {
        return None;
    }
    Some(match value.as_string() {
        Some(text) => Found::Text(text),
        None => Found::Other(
            js_sys::JSON::stringify(value)
                .ok()
                .and_then(|text| text.as_string())
                .unwrap_or_else(|| format!("{value:?}")),
        ),
    })
}

/// Whether the browser has promised not to clear the storage.
pub async fn is_protected() -> bool {
    answer(leptos::prelude::window().navigator().storage().persisted()).await
}

/// Asks the browser not to clear the storage; returns whether it promises.
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
