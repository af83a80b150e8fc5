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
    /// The bytes that all files together can have.
    quota: Option<usize>,
    /// Which tab has a file open to write it: until it unlocks the folder, no other one can write or remove the file.
    writers: HashMap<(String, String), u64>,
    /// What another tab makes of everything before the next read.
    next_contents: Option<Contents>,
    has_no_locks: bool,
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

    /// Lets all files together have this many bytes; what is removed makes room.
    pub fn set_quota(&self, bytes: Option<usize>) {
        self.inner.borrow_mut().quota = bytes;
    }

    /// The bytes of all files together.
    pub fn used(&self) -> usize {
        self.inner.borrow().used()
    }

    /// Replaces everything on the disk just before the next read, as another tab might.
    pub fn replace_before_next_read(&self, contents: Contents) {
        self.inner.borrow_mut().next_contents = Some(contents);
    }

    /// Is a browser without locks from here on.
    pub fn take_locks_away(&self) {
        self.inner.borrow_mut().has_no_locks = true;
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
        let mut inner = self.disk.inner.borrow_mut();
        inner.locks.retain(|_, tab| *tab != self.number);
        inner.writers.retain(|_, tab| *tab != self.number);
    }
}

impl Inner {
    fn check(&self) -> Result<(), Failure> {
        match &self.limit {
            Some((0, failure)) => Err(failure.clone()),
            _ => Ok(()),
        }
    }

    fn used(&self) -> usize {
        self.folders.values().flat_map(BTreeMap::values).map(Vec::len).sum()
    }

    /// Opens a file to write it, which only one tab can.
    fn write(&mut self, folder: &str, file: &str, tab: u64) -> Result<(), Failure> {
        let key = (folder.to_owned(), file.to_owned());
        if *self.writers.entry(key).or_insert(tab) == tab { Ok(()) } else { Err(open_elsewhere()) }
    }

    /// Closes what a tab writes in a folder, or only one file.
    fn close(&mut self, folder: &str, file: Option<&str>, tab: u64) {
        let closes = |of: &str, name: &str| of == folder && file.is_none_or(|file| file == name);
        self.writers.retain(|(of, name), by| *by != tab || !closes(of, name));
    }

    fn is_written(&self, folder: &str, file: Option<&str>) -> bool {
        self.writers.keys().any(|(of, name)| of == folder && file.is_none_or(|file| file == name))
    }

    fn file(&mut self, folder: &str, file: &str) -> Result<&mut Vec<u8>, Failure> {
        self.folders.get_mut(folder).and_then(|files| files.get_mut(file)).ok_or(Failure::Missing)
    }
}

/// What browsers say of a file that another tab writes.
fn open_elsewhere() -> Failure {
    Failure::Other("NoModificationAllowedError".to_owned())
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
        inner.write(folder, file, self.number)?;
        if inner.quota.is_some_and(|quota| inner.used() + bytes.len() > quota) {
            return Err(Failure::Full);
        }
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
        if let Some(contents) = inner.next_contents.take() {
            inner.folders = contents;
        }
        let bytes = inner.file(folder, file)?;
        Ok(bytes.iter().skip(at as usize).take(len).copied().collect())
    }

    async fn truncate(&mut self, folder: &str, file: &str, bytes: u64) -> Result<(), Failure> {
        let mut inner = self.disk.inner.borrow_mut();
        inner.check()?;
        inner.write(folder, file, self.number)?;
        inner.file(folder, file)?.truncate(bytes as usize);
        Ok(())
    }

    async fn remove(&mut self, folder: &str, file: &str) -> Result<(), Failure> {
        let mut inner = self.disk.inner.borrow_mut();
        inner.check()?;
        inner.close(folder, Some(file), self.number);
        if inner.is_written(folder, Some(file)) {
            return Err(open_elsewhere());
        }
        if let Some(files) = inner.folders.get_mut(folder) {
            files.remove(file);
        }
        Ok(())
    }

    async fn remove_folder(&mut self, folder: &str) -> Result<(), Failure> {
        let mut inner = self.disk.inner.borrow_mut();
        inner.check()?;
        inner.close(folder, None, self.number);
        if inner.is_written(folder, None) {
            return Err(open_elsewhere());
        }
        inner.folders.remove(folder);
        Ok(())
    }

    async fn lock(&mut self, folder: &str) -> bool {
        let mut inner = self.disk.inner.borrow_mut();
        if inner.has_no_locks {
            return true;
        }
        *inner.locks.entry(folder.to_owned()).or_insert(self.number) == self.number
    }

    fn has_locks(&self) -> bool {
        !self.disk.inner.borrow().has_no_locks
    }

    async fn unlock(&mut self, folder: &str) {
        let mut inner = self.disk.inner.borrow_mut();
        inner.close(folder, None, self.number);
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
