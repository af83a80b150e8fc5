//! The documents that are kept, in a thread.

use std::hash::{BuildHasher, RandomState};
use std::path::PathBuf;
use std::sync::mpsc::{Sender, channel};

use meshwright_web::platform::Event;
use meshwright_web::platform::store::{Answer, Bytes, Documents, Failure, Id, Request, now_or_never};

use super::folder_disk::FolderDisk;
use super::inbox::Inbox;

/// Sends requests to the thread that keeps documents.
pub struct Store {
    requests: Sender<(Request, Bytes)>,
    thread: Option<std::thread::JoinHandle<()>>,
}

impl Store {
    /// Keeps documents in a folder. Without one, every request fails.
    pub fn new(folder: Option<PathBuf>, inbox: Inbox) -> Self {
        let (requests, received) = channel::<(Request, Bytes)>();
        let thread = std::thread::spawn(move || {
            let mut documents = folder.map(|folder| Documents::new(FolderDisk::new(folder)));
            for (request, bytes) in received {
                let mut tell = |answer, bytes| inbox.push(Event::Store(answer, bytes));
                match &mut documents {
                    // A disk answers at once, so the future never waits.
                    Some(documents) => drop(now_or_never(documents.handle(request, &bytes, &mut tell))),
                    None => tell(Answer::Failed(Failure::Denied), Bytes::new()),
                }
            }
        });
        Self { requests, thread: Some(thread) }
    }

    pub fn ask(&self, request: Request, bytes: Bytes) {
        // The thread ends with the program.
        let _ = self.requests.send((request, bytes));
    }
}

impl Drop for Store {
    /// Waits until everything asked for is on the disk.
    fn drop(&mut self) {
        self.requests = channel().0;
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

/// A new identity for a document: 16 random hexadecimal digits.
pub fn new_id() -> Id {
    // The standard library seeds its hashers with random numbers.
    format!("{:016x}", RandomState::new().hash_one(std::time::SystemTime::now()))
}
