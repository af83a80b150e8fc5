//! A disk in memory, for tests, which fails when it is told to.

use super::disk::{Disk, Failure, FileLength};
use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap};
use std::pin::pin;
use std::rc::Rc;
use std::task::{Context, Poll, Waker};

/// Everything on a disk: by folder and file.
pub type Contents = BTreeMap<String, BTreeMap<String, Vec<u8>>>;

/// A disk in memory. Its clones are the same disk.
#[derive(Clone, Debug, Default)]
pub struct MemoryDisk {
    inner: Rc<RefCell<Inner>>,
}

#[derive(Debug, Default)]
struct Inner {
    folders: Contents,
    /// Which tab has locked a folder.
    locks: HashMap<String, u64>,
    tabs: u64,
    /// The bytes that can still be written, and what happens then.
    limit: Option<(u64, Failure)>,
}

/// A tab's view of a disk in memory. Dropping it ends its locks.
#[derive(Debug)]
pub struct Tab {
    disk: MemoryDisk,
    number: u64,
}

impl MemoryDisk {
    /// Another tab.
    pub fn tab(&self) -> Tab {
        let mut inner = self.inner.borrow_mut();
        inner.tabs += 1;
        Tab { disk: self.clone(), number: inner.tabs }
    }

    /// Fails once this many more bytes were written; the write that reaches the limit is cut off there.
    pub fn fail_after(&self, bytes: u64, failure: Failure) {
        self.inner.borrow_mut().limit = Some((bytes, failure));
    }

    /// Writes without a limit again.
    pub fn mend(&self) {
        self.inner.borrow_mut().limit = None;
    }

    /// Everything on the disk.
    pub fn contents(&self) -> Contents {
        self.inner.borrow().folders.clone()
    }

    /// Replaces everything on the disk.
    pub fn set_contents(&self, contents: Contents) {
        self.inner.borrow_mut().folders = contents;
    }
}

impl Drop for Tab {
    fn drop(&mut self) {
        self.disk.inner.borrow_mut().locks.retain(|_, tab| *tab != self.number);
    }
}

impl Inner {
    fn check(&self) -> Result<(), Failure> {
        match &self.limit {
            Some((0, failure)) => Err(failure.clone()),
            _ => Ok(()),
        }
    }

    fn file(&mut self, folder: &str, file: &str) -> Result<&mut Vec<u8>, Failure> {
        self.folders.get_mut(folder).and_then(|files| files.get_mut(file)).ok_or(Failure::Missing)
    }
}

impl Disk for Tab {
    async fn folders(&mut self) -> Result<Vec<String>, Failure> {
        Ok(self.disk.inner.borrow().folders.keys().cloned().collect())
    }

    async fn files(&mut self, folder: &str) -> Result<Vec<FileLength>, Failure> {
        let inner = self.disk.inner.borrow();
        let files = inner.folders.get(folder).into_iter().flatten();
        Ok(files.map(|(name, bytes)| FileLength { name: name.clone(), bytes: bytes.len() as u64 }).collect())
    }

    async fn append(&mut self, folder: &str, file: &str, bytes: &[u8]) -> Result<(), Failure> {
        let mut inner = self.disk.inner.borrow_mut();
        inner.check()?;
        let room = inner.limit.as_ref().map_or(usize::MAX, |(room, _)| *room as usize);
        let fits = bytes.get(..room.min(bytes.len())).unwrap_or_default();
        let files = inner.folders.entry(folder.to_owned()).or_default();
        files.entry(file.to_owned()).or_default().extend_from_slice(fits);
        if let Some((room, _)) = &mut inner.limit {
            *room -= fits.len() as u64;
        }
        if fits.len() < bytes.len() { inner.check() } else { Ok(()) }
    }

    async fn read(&mut self, folder: &str, file: &str, at: u64, len: usize) -> Result<Vec<u8>, Failure> {
        let mut inner = self.disk.inner.borrow_mut();
        let bytes = inner.file(folder, file)?;
        Ok(bytes.iter().skip(at as usize).take(len).copied().collect())
    }

    async fn truncate(&mut self, folder: &str, file: &str, bytes: u64) -> Result<(), Failure> {
        let mut inner = self.disk.inner.borrow_mut();
        inner.check()?;
        inner.file(folder, file)?.truncate(bytes as usize);
        Ok(())
    }

    async fn remove(&mut self, folder: &str, file: &str) -> Result<(), Failure> {
        let mut inner = self.disk.inner.borrow_mut();
        inner.check()?;
        if let Some(files) = inner.folders.get_mut(folder) {
            files.remove(file);
        }
        Ok(())
    }

    async fn remove_folder(&mut self, folder: &str) -> Result<(), Failure> {
        let mut inner = self.disk.inner.borrow_mut();
        inner.check()?;
        inner.folders.remove(folder);
        Ok(())
    }

    async fn lock(&mut self, folder: &str) -> bool {
        let mut inner = self.disk.inner.borrow_mut();
        *inner.locks.entry(folder.to_owned()).or_insert(self.number) == self.number
    }

    async fn unlock(&mut self, folder: &str) {
        let mut inner = self.disk.inner.borrow_mut();
        if inner.locks.get(folder) == Some(&self.number) {
            inner.locks.remove(folder);
        }
    }
}

/// The result of a future that never waits, as those on a [`MemoryDisk`]; none if it does.
pub fn now_or_never<T>(future: impl Future<Output = T>) -> Option<T> {
    match pin!(future).poll(&mut Context::from_waker(Waker::noop())) {
        Poll::Ready(value) => Some(value),
        Poll::Pending => None,
    }
}
