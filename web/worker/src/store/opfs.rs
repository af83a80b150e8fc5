//! A disk in the origin private file system, with synchronous handles, which only workers have.
//!
//! By `web-sys` and not by the `opfs` crate, which writes through streams: those copy the whole file for each record.

use super::disk::{Disk, Failure, FileLength};
use super::locks::Locks;
use js_sys::{ArrayBuffer, Promise, Reflect, Uint8Array};
use std::collections::HashMap;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::JsFuture;
use web_sys::{
    DedicatedWorkerGlobalScope, DomException, File, FileSystemDirectoryHandle, FileSystemFileHandle,
    FileSystemGetDirectoryOptions, FileSystemGetFileOptions, FileSystemHandle, FileSystemHandleKind,
    FileSystemReadWriteOptions, FileSystemRemoveOptions, FileSystemSyncAccessHandle,
};

/// The folder of the origin that holds everything.
const ROOT: &str = "meshwright";

/// The origin private file system.
#[derive(Debug)]
pub(super) struct Opfs {
    root: FileSystemDirectoryHandle,
    /// The files that were written last, by folder and name. Others can read but not write them.
    writing: HashMap<(String, String), FileSystemSyncAccessHandle>,
    locks: Locks,
}

impl Opfs {
    /// Opens it, and tries whether files in it can be written. A full disk has one too: what is there can be read.
    ///
    /// # Errors
    /// [`Failure::Denied`] if the browser has none or allows none.
    pub async fn new() -> Result<Self, Failure> {
        let scope: DedicatedWorkerGlobalScope = js_sys::global().unchecked_into();
        let navigator = scope.navigator();
        let storage = Reflect::get(&navigator, &"storage".into()).map_err(|error| failure(&error))?;
        if storage.is_undefined() || !has(&storage, "getDirectory") || !has_synchronous_handles() {
            return Err(Failure::Denied);
        }
        let origin: FileSystemDirectoryHandle = wait(navigator.storage().get_directory()).await?;
        let options = FileSystemGetDirectoryOptions::new();
        options.set_create(true);
        let root = match wait(origin.get_directory_handle_with_options(ROOT, &options)).await {
            Err(Failure::Full) => wait(origin.get_directory_handle(ROOT)).await?,
            root => root?,
        };
        let mut disk = Self { root, writing: HashMap::new(), locks: Locks::default() };
        let probe = format!("probe-{}", js_sys::Math::random());
        let probed = disk.append(&probe, "probe", b"probe").await;
        // A later sweep removes it otherwise.
        let _ = disk.remove_folder(&probe).await;
        if probed == Err(Failure::Denied) { Err(Failure::Denied) } else { Ok(disk) }
    }

    async fn folder(&self, name: &str, create: bool) -> Result<FileSystemDirectoryHandle, Failure> {
        let options = FileSystemGetDirectoryOptions::new();
        options.set_create(create);
        wait(self.root.get_directory_handle_with_options(name, &options)).await
    }

    async fn handle(&self, folder: &str, file: &str, create: bool) -> Result<FileSystemFileHandle, Failure> {
        let options = FileSystemGetFileOptions::new();
        options.set_create(create);
        let folder = self.folder(folder, create).await?;
        wait(folder.get_file_handle_with_options(file, &options)).await
    }

    /// The handle that writes to a file.
    async fn writer(
        &mut self,
        folder: &str,
        file: &str,
        create: bool,
    ) -> Result<FileSystemSyncAccessHandle, Failure> {
        let key = (folder.to_owned(), file.to_owned());
        if let Some(handle) = self.writing.get(&key) {
            return Ok(handle.clone());
        }
        let handle = self.handle(folder, file, create).await?;
        let writer: FileSystemSyncAccessHandle = wait(handle.create_sync_access_handle()).await?;
        self.writing.insert(key, writer.clone());
        Ok(writer)
    }

    /// Closes the writers of a folder's files, or of one of them.
    fn close(&mut self, folder: &str, file: Option<&str>) {
        self.writing.retain(|(of, name), handle| {
            let closes = of == folder && file.is_none_or(|file| file == name);
            if closes {
                handle.close();
            }
            !closes
        });
    }
}

impl Disk for Opfs {
    async fn folders(&mut self) -> Result<Vec<String>, Failure> {
        let handles = entries(&self.root).await?;
        Ok(handles
            .iter()
            .filter(|of| of.kind() == FileSystemHandleKind::Directory)
            .map(|of| of.name())
            .collect())
    }

    async fn files(&mut self, folder: &str) -> Result<Vec<FileLength>, Failure> {
        let handle = match self.folder(folder, false).await {
            Err(Failure::Missing) => return Ok(Vec::new()),
            handle => handle?,
        };
        let mut files = Vec::new();
        for entry in entries(&handle).await? {
            let name = entry.name();
            let bytes = match self.writing.get(&(folder.to_owned(), name.clone())) {
                Some(writer) => writer.get_size().map_err(|error| failure(&error))?,
                None => {
                    let handle: FileSystemFileHandle = entry.unchecked_into();
                    match wait::<File>(handle.get_file()).await {
                        // Another tab has just removed it.
                        Err(Failure::Missing) => continue,
                        file => file?.size(),
                    }
                }
            };
            files.push(FileLength { name, bytes: bytes as u64 });
        }
        Ok(files)
    }

    async fn append(&mut self, folder: &str, file: &str, bytes: &[u8]) -> Result<(), Failure> {
        let writer = self.writer(folder, file, true).await?;
        let size = writer.get_size().map_err(|error| failure(&error))?;
        let at = FileSystemReadWriteOptions::new();
        at.set_at_f64(size);
        let written = writer
            .write_with_u8_array_and_options(bytes, &at)
            .and_then(|written| writer.flush().map(|()| written))
            .map_err(|error| failure(&error));
        let appended = match written {
            Ok(written) if (written as usize) < bytes.len() => Err(Failure::Full),
            written => written.map(drop),
        };
        if appended == Err(Failure::Full) {
            // Whoever reads the file leaves out a part of a record or a checkpoint, if this fails too.
            let _ = writer.truncate_with_f64(size);
        }
        appended
    }

    async fn read(&mut self, folder: &str, file: &str, at: u64, len: usize) -> Result<Vec<u8>, Failure> {
        if let Some(writer) = self.writing.get(&(folder.to_owned(), file.to_owned())) {
            let options = FileSystemReadWriteOptions::new();
            options.set_at_f64(at as f64);
            let mut bytes = vec![0; len];
            let read = writer
                .read_with_u8_array_and_options(&mut bytes, &options)
                .map_err(|error| failure(&error))?;
            bytes.truncate(read as usize);
            return Ok(bytes);
        }
        let file: File = wait(self.handle(folder, file, false).await?.get_file()).await?;
        let part = file.slice_with_f64_and_f64(at as f64, at as f64 + len as f64);
        let buffer: ArrayBuffer = wait(part.map_err(|error| failure(&error))?.array_buffer()).await?;
        Ok(Uint8Array::new(&buffer).to_vec())
    }

    async fn truncate(&mut self, folder: &str, file: &str, bytes: u64) -> Result<(), Failure> {
        let writer = self.writer(folder, file, false).await?;
        writer.truncate_with_f64(bytes as f64).and_then(|()| writer.flush()).map_err(|error| failure(&error))
    }

    async fn remove(&mut self, folder: &str, file: &str) -> Result<(), Failure> {
        self.close(folder, Some(file));
        match self.folder(folder, false).await {
            Err(Failure::Missing) => Ok(()),
            handle => done(handle?.remove_entry(file)).await,
        }
    }

    async fn remove_folder(&mut self, folder: &str) -> Result<(), Failure> {
        self.close(folder, None);
        let options = FileSystemRemoveOptions::new();
        options.set_recursive(true);
        done(self.root.remove_entry_with_options(folder, &options)).await
    }

    async fn lock(&mut self, folder: &str) -> bool {
        self.locks.take(folder).await
    }

    fn has_locks(&self) -> bool {
        self.locks.work()
    }

    async fn unlock(&mut self, folder: &str) {
        self.close(folder, None);
        self.locks.release(folder);
    }
}

fn has(object: &JsValue, name: &str) -> bool {
    Reflect::get(object, &name.into()).is_ok_and(|value| !value.is_undefined())
}

/// Whether the browser's files can be written at once.
fn has_synchronous_handles() -> bool {
    let of = |object: &JsValue, name: &str| Reflect::get(object, &name.into()).unwrap_or_default();
    let prototype = of(&of(&js_sys::global(), "FileSystemFileHandle"), "prototype");
    has(&prototype, "createSyncAccessHandle")
}

/// What is in a folder.
async fn entries(folder: &FileSystemDirectoryHandle) -> Result<Vec<FileSystemHandle>, Failure> {
    let (values, mut found) = (folder.values(), Vec::new());
    loop {
        let next: JsValue = wait(values.next().map_err(|error| failure(&error))?.unchecked_into()).await?;
        let of = |name: &str| Reflect::get(&next, &name.into()).unwrap_or_default();
        if of("done").is_truthy() {
            return Ok(found);
        }
        found.push(of("value").unchecked_into());
    }
}

async fn wait<T: JsCast>(promise: Promise) -> Result<T, Failure> {
    JsFuture::from(promise).await.map(JsCast::unchecked_into).map_err(|error| failure(&error))
}

/// Waits for something to be removed, which may be gone already.
async fn done(promise: Promise) -> Result<(), Failure> {
    match wait::<JsValue>(promise).await {
        Err(Failure::Missing) => Ok(()),
        result => result.map(drop),
    }
}

/// What an exception means.
pub(super) fn failure(error: &JsValue) -> Failure {
    let Some(exception) = error.dyn_ref::<DomException>() else {
        return Failure::Other(format!("{error:?}"));
    };
    match exception.name().as_str() {
        "QuotaExceededError" => Failure::Full,
        "SecurityError" | "NotAllowedError" => Failure::Denied,
        "NotFoundError" => Failure::Missing,
        name => Failure::Other(format!("{name}: {}", exception.message())),
    }
}
