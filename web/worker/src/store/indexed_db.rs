//! A disk in IndexedDB, for browsers without synchronous file handles.
//!
//! What was appended to a file at once is a record of its own. Its key is `folder/file/offset-length`, with the numbers
//! padded so that the keys of a file are in order, and lengths are known without reading the records.

use super::disk::{Disk, Failure, FileLength};
use super::locks::Locks;
use super::opfs::failure;
use idb::{
    CursorDirection, Database, Error, Factory, KeyRange, ObjectStore, ObjectStoreParams, Query, Transaction,
    TransactionMode,
};
use js_sys::{Array, Function, Object, Reflect, Uint8Array};
use std::collections::BTreeMap;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{IdbDatabase, IdbTransaction};

const DATABASE: &str = "meshwright";
const PARTS: &str = "parts";

/// The highest character that a key continues with.
const LAST: char = '\u{ffff}';

/// IndexedDB.
pub(super) struct IndexedDb {
    database: Database,
    /// The same, as the browser has it.
    raw: IdbDatabase,
    locks: Locks,
}

/// A record.
struct Part {
    folder: String,
    file: String,
    at: u64,
    len: u64,
}

impl Part {
    fn key(&self) -> JsValue {
        format!("{}/{}/{:016}-{:016}", self.folder, self.file, self.at, self.len).into()
    }

    fn of_key(key: &JsValue) -> Option<Self> {
        let key = key.as_string()?;
        let (folder, rest) = key.split_once('/')?;
        let (file, range) = rest.split_once('/')?;
        let (at, len) = range.split_once('-')?;
        Some(Self { folder: folder.into(), file: file.into(), at: at.parse().ok()?, len: len.parse().ok()? })
    }

    fn end(&self) -> u64 {
        self.at + self.len
    }
}

impl IndexedDb {
    /// Opens it.
    ///
    /// # Errors
    /// The browser has none, or allows none.
    pub async fn new() -> Result<Self, Failure> {
        let open = || {
            let mut request = Factory::new()?.open(DATABASE, Some(1))?;
            request.on_upgrade_needed(|event| {
                // If this fails, so does every later use, which says so.
                if let Ok(database) = idb::DatabaseEvent::database(&event) {
                    let _ = database.create_object_store(PARTS, ObjectStoreParams::new());
                }
            });
            Ok(request)
        };
        let database = open().map_err(|error| why(&error))?.await.map_err(|error| why(&error))?;
        let raw: IdbDatabase = database.into();
        Ok(Self { database: raw.clone().into(), raw, locks: Locks::default() })
    }

    fn begin(&self, mode: TransactionMode) -> Result<(Transaction, ObjectStore), Error> {
        let transaction = match mode {
            TransactionMode::ReadWrite => self.begin_strict()?,
            mode => self.database.transaction(&[PARTS], mode)?,
        };
        let store = transaction.object_store(PARTS)?;
        Ok((transaction, store))
    }

    /// A transaction that counts as carried out only once it is on the disk, in browsers that know the difference. The crate
    /// has no such option.
    fn begin_strict(&self) -> Result<Transaction, Error> {
        let options = Object::new();
        let _ = Reflect::set(&options, &"durability".into(), &"strict".into());
        let begin: Function = Reflect::get(&self.raw, &"transaction".into())
            .map_err(Error::TransactionOpenFailed)?
            .unchecked_into();
        let names = Array::of1(&PARTS.into());
        let transaction = begin
            .call3(&self.raw, &names, &"readwrite".into(), &options)
            .map_err(Error::TransactionOpenFailed)?;
        Ok(transaction.unchecked_into::<IdbTransaction>().into())
    }

    /// The records whose keys begin like this, in order.
    async fn parts(&self, prefix: &str) -> Result<Vec<Part>, Failure> {
        let read = async {
            let (_transaction, store) = self.begin(TransactionMode::ReadOnly)?;
            store.get_all_keys(Some(range(prefix)?), None)?.await
        };
        let keys = read.await.map_err(|error| why(&error))?;
        Ok(keys.iter().filter_map(Part::of_key).collect())
    }

    /// The last of the records whose keys begin like this.
    async fn last_part(&self, prefix: &str) -> Result<Option<Part>, Failure> {
        let read = async {
            let (_transaction, store) = self.begin(TransactionMode::ReadOnly)?;
            let cursor = store.open_key_cursor(Some(range(prefix)?), Some(CursorDirection::Prev))?.await?;
            cursor.map(|cursor| cursor.key()).transpose()
        };
        Ok(read.await.map_err(|error| why(&error))?.as_ref().and_then(Part::of_key))
    }

    async fn get(&self, part: &Part) -> Result<Vec<u8>, Failure> {
        let read = async {
            let (_transaction, store) = self.begin(TransactionMode::ReadOnly)?;
            store.get(part.key())?.await
        };
        let value = read.await.map_err(|error| why(&error))?.ok_or(Failure::Missing)?;
        Ok(value.unchecked_into::<Uint8Array>().to_vec())
    }

    async fn delete(&self, prefix: &str) -> Result<(), Failure> {
        let delete = async {
            let (transaction, store) = self.begin(TransactionMode::ReadWrite)?;
            store.delete(range(prefix)?)?.await?;
            transaction.await
        };
        ended(delete.await)
    }
}

impl Disk for IndexedDb {
    async fn folders(&mut self) -> Result<Vec<String>, Failure> {
        let mut names: Vec<String> = self.parts("").await?.into_iter().map(|part| part.folder).collect();
        names.dedup();
        Ok(names)
    }

    async fn files(&mut self, folder: &str) -> Result<Vec<FileLength>, Failure> {
        let mut files = BTreeMap::new();
        for part in self.parts(&format!("{folder}/")).await? {
            *files.entry(part.file).or_default() += part.len;
        }
        Ok(files.into_iter().map(|(name, bytes)| FileLength { name, bytes }).collect())
    }

    async fn append(&mut self, folder: &str, file: &str, bytes: &[u8]) -> Result<(), Failure> {
        let at = self.last_part(&format!("{folder}/{file}/")).await?.map_or(0, |part| part.end());
        let part = Part { folder: folder.into(), file: file.into(), at, len: bytes.len() as u64 };
        let value = Uint8Array::from(bytes);
        let add = async {
            let (transaction, store) = self.begin(TransactionMode::ReadWrite)?;
            store.add(&value, Some(&part.key()))?.await?;
            transaction.await
        };
        ended(add.await)
    }

    async fn read(&mut self, folder: &str, file: &str, at: u64, len: usize) -> Result<Vec<u8>, Failure> {
        let parts = self.parts(&format!("{folder}/{file}/")).await?;
        if parts.is_empty() {
            return Err(Failure::Missing);
        }
        let (mut bytes, end) = (Vec::new(), at + len as u64);
        for part in parts.iter().filter(|part| part.end() > at && part.at < end) {
            let whole = self.get(part).await?;
            let first = at.saturating_sub(part.at) as usize;
            let last = (end - part.at).min(part.len) as usize;
            bytes.extend_from_slice(whole.get(first..last).ok_or(Failure::Missing)?);
        }
        Ok(bytes)
    }

    async fn truncate(&mut self, folder: &str, file: &str, bytes: u64) -> Result<(), Failure> {
        for part in self.parts(&format!("{folder}/{file}/")).await? {
            if part.end() <= bytes {
                continue;
            }
            let whole = self.get(&part).await?;
            let kept = whole.get(..bytes.saturating_sub(part.at) as usize).unwrap_or_default();
            let (old, value) = (part.key(), Uint8Array::from(kept));
            let shorter = Part { len: kept.len() as u64, ..part };
            let cut = async {
                let (transaction, store) = self.begin(TransactionMode::ReadWrite)?;
                store.delete(old)?.await?;
                if shorter.len > 0 {
                    store.add(&value, Some(&shorter.key()))?.await?;
                }
                transaction.await
            };
            ended(cut.await)?;
        }
        Ok(())
    }

    async fn remove(&mut self, folder: &str, file: &str) -> Result<(), Failure> {
        self.delete(&format!("{folder}/{file}/")).await
    }

    async fn remove_folder(&mut self, folder: &str) -> Result<(), Failure> {
        self.delete(&format!("{folder}/")).await
    }

    async fn lock(&mut self, folder: &str) -> bool {
        self.locks.take(folder).await
    }

    fn has_locks(&self) -> bool {
        self.locks.work()
    }

    async fn unlock(&mut self, folder: &str) {
        self.locks.release(folder);
    }
}

/// The keys that begin like this.
fn range(prefix: &str) -> Result<Query, Error> {
    let end = format!("{prefix}{LAST}");
    Ok(KeyRange::bound(&prefix.into(), &end.into(), None, None)?.into())
}

/// Whether a transaction was carried out. Browsers abort one for which there is no room.
fn ended(result: Result<idb::TransactionResult, Error>) -> Result<(), Failure> {
    match result {
        Ok(result) if result.is_committed() => Ok(()),
        Ok(_) => Err(Failure::Full),
        Err(error) => Err(why(&error)),
    }
}

/// What an error means.
fn why(error: &Error) -> Failure {
    match error {
        Error::DomException(exception) => failure(exception),
        Error::IndexedDbNotFound(_) => Failure::Denied,
        Error::AddFailed(error) | Error::IndexedDbOpenFailed(error) | Error::UpdateFailed(error) => {
            failure(error)
        }
        error => Failure::Other(error.to_string()),
    }
}
