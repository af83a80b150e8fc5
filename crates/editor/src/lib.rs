//! The editor without a screen: a document of objects, a selection, commands, history and jobs.
//!
//! Everything a user can do is a [`Command`] value given to an [`Editor`]. Menus, keys, scripts,
//! the command line and tests use the same commands; [`OpId::ALL`] lists them.

#![cfg_attr(not(test), deny(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::unreachable))]
#![cfg_attr(not(test), deny(clippy::indexing_slicing))]

mod bezier;
mod changes;
mod document;
mod editor;
mod error;
mod history;
mod job;
pub mod ops;
mod outcome;
pub mod project;
pub mod recovery;
pub mod script;
mod selection;
mod task;

pub use bezier::{Bezier, show_controls};
pub use changes::{Changes, ObjectChange};
pub use document::{Counts, Document, NamedSelection, Object, ObjectId, Origin};
pub use editor::{
    Begun, Editor, Finished, Jump, MAX_ELEMENTS_AT_ONCE, Message, MessageKind, RunningJob, SelectBy,
};
pub use error::{CommandError, ErrorKind};
pub use job::{BadBytes, JobId, JobRequest, JobResult, Part, Reading, Wire};
pub use ops::{Command, Facts, Op, OpId, Scope, SelectMode, Spec};
pub use outcome::{ElementIds, Elements, Outcome};
pub use script::{element_kind, element_name};
pub use selection::Selection;
pub use task::Task;

/// The library that reads and writes files, for its types in this crate's signatures.
pub use formats;
/// The mesh library, for its types in this crate's signatures.
pub use halfedge;
/// The algorithms, for [`Bezier`]'s curves and patches.
pub use surface;
