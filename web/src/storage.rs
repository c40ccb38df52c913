//! What is kept in the browser, in IndexedDB: case and units as they are now, imported outlines and tables, and the named runs,
//! each a record of its own.

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

/// The database. It is opened when it is first needed, and anew after a failure.
#[derive(Clone, Default)]
pub struct Store(Rc<RefCell<Line>>);

#[derive(Default)]
struct Line {
    database: Option<Rc<Database>>,
    /// Resolved when the opening that is under way has ended, well or not.
    opening: Option<Promise>,
}

impl Store {
    /// All records.
    ///
    /// # Errors
    /// Why the browser refuses, in words.
    pub async fn load(&self) -> Result<Vec<(Key, Found)>, String> {
        let database = self.database().await?;
        let loaded = load(&database).await;
        self.unless_failed(loaded)
    }

    /// Makes all changes, or none: where a record is not as expected, where the browser gives the transaction up.
    ///
    /// # Errors
    /// Why the browser refuses, in words.
    pub async fn write(&self, changes: &[Change]) -> Result<Written, String> {
        if changes.is_empty() {
            return Ok(Written::All);
        }
        let database = self.database().await?;
        let written = write(&database, changes).await;
        self.unless_failed(written)
    }

    /// Moves a record as it is, whatever it holds.
    ///
    /// # Errors
    /// Why the browser refuses, in words.
    pub async fn set_aside(&self, key: &Key, to: &Key) -> Result<(), String> {
        let database = self.database().await?;
        let moved = set_aside(&database, key, to).await;
        self.unless_failed(moved)
    }

    /// Removes a record, whatever it holds.
    ///
    /// # Errors
    /// Why the browser refuses, in words.
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
            // It is never rejected; who waits looks again.
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
            // Resolving a promise throws nothing.
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

/// Why the browser refuses, in words.
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
    // A later version of the program wants to change the database, and must not wait for this tab.
    database.on_version_change(move |_| store.close());
    Ok(database)
}

fn begin(database: &Database, mode: TransactionMode) -> Result<Transaction, idb::Error> {
    database.transaction(&Shelf::ALL.map(Shelf::name), mode)
}

fn shelf(transaction: &Transaction, key: &Key) -> Result<ObjectStore, idb::Error> {
    transaction.object_store(key.shelf.name())
}

/// Waits until a transaction is on disk, as far as the browser says.
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
            // Nothing was asked for that could be taken back.
            let _ = transaction.abort();
            Ok(Written::Nothing(clashes))
        }
        Err(error) => {
            // What was written before the failure must not stay alone; one that is over needs no abort.
            let _ = transaction.abort();
            Err(error)
        }
    }
}

/// Asks for all changes if every record is as expected.
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

/// What a value is; nothing where there is no record.
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
