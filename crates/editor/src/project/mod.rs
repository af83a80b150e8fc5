//! Project files: a document with everything that Meshwright knows of it, for keeping and passing on.
//!
//! [`Project::of`] takes what an editor holds, [`Project::write`] makes a file of it, [`Project::read`] reads one, and
//! [`Editor::open_project`] replaces the document by it, as one step below which the steps of the project come back.
//! `docs/project-file.md` describes the bytes.
//!
//! The history is kept as an earlier document and the log of what was done since (see [`crate::recovery`]); opening the file
//! repeats it. The document itself is in the file too: if repeating takes too long, or leads to anything else, the
//! document is opened without a history, and the report says so.
//!
//! [`Editor::open_project`]: crate::Editor::open_project

mod container;
mod file;
mod link;
mod open;
mod trail;

pub use file::{Project, ReadProject};
pub use link::{LINK_MARK, Link, LinkKind};
pub(crate) use open::Unused;
pub(crate) use trail::Trail;
