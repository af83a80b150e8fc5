//! What is kept outside the program, so that nothing is lost when it ends without a warning.
//!
//! A document is kept as a [`SnapshotCopy`] and a log of what was done since. The log holds commands, which give the same
//! bits wherever they run; [`Editor::replay`] repeats them. An entry of a local edit takes some hundred bytes, whatever
//! the size of the mesh.
//!
//! This module makes and reads bytes. Where they are kept is up to the page.
//!
//! [`Editor::replay`]: crate::Editor::replay

mod entry;
mod log;
mod records;
mod replay;
mod sets;
mod snapshot;

pub use entry::{Entry, Event};
pub(crate) use log::Log;
pub use records::{Records, append_record, is_of_later_version, new_log, read_log};
pub use replay::{NotReplayed, Recovered};
pub(crate) use snapshot::Numbers;
pub use snapshot::{Snapshot, SnapshotCopy};
