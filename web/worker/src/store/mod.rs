//! The documents that the browser keeps, so that nothing is lost when the page ends.
//!
//! Each document has a folder with
//!
//! - `checkpoint-7`: the document as [`editor::recovery::Snapshot`] writes it;
//! - `log-7`: what was done since that checkpoint;
//! - `info-3`: its name, sizes and dates; `picture-2`: what it looks like.
//!
//! Checkpoints, infos and pictures end with their length and a checksum (see `sealed`). A new one gets the next number, and
//! the old one is removed when the new one is complete: whenever the page ends, one of them is whole. A log has a checksum
//! for each record, and is cut off before the first damaged one.
//!
//! [`Documents`] does all that on a [`Disk`]: the origin private file system, IndexedDB, or memory for tests. In the browser
//! it runs in a worker of its own, which is never terminated for a job. A tab locks the document that it shows.

mod disk;
mod documents;
#[cfg(target_arch = "wasm32")]
mod indexed_db;
mod listing;
#[cfg(target_arch = "wasm32")]
mod locks;
mod memory;
mod message;
#[cfg(target_arch = "wasm32")]
mod opfs;
mod reading;
mod rescue;
mod sealed;
#[cfg(target_arch = "wasm32")]
mod serve;

pub use disk::{Disk, Failure, FileLength};
pub use documents::Documents;
pub use memory::{Contents, MemoryDisk, Tab, now_or_never};
pub use message::{Answer, Bytes, Id, Info, Kept, MIN_RESTORABLE_MS, Opened, Refusal, Request, WhyNot};
#[cfg(target_arch = "wasm32")]
pub use message::{from_js, to_js};
#[cfg(target_arch = "wasm32")]
pub use serve::{serve, serve_rescue};

/// The name of the worker that keeps documents: it runs the same program as that for jobs.
pub const WORKER_NAME: &str = "meshwright-store";

/// The name of the worker that makes a file of a kept document after the page's program has crashed. The page's script
/// starts it; see `web/site/rescue.js`.
pub const RESCUE_NAME: &str = "meshwright-rescue";
