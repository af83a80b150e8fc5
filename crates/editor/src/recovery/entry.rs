//! Entries of the log.

use super::sets::{read_selection, write_selection};
use crate::job::wire::{BadBytes, Part, Reader, Wire, Writer};
use crate::ops::Command;
use crate::selection::Selection;
use serde::{Deserialize, Serialize};
use std::io::{self, Read, Write};
use std::sync::Arc;

/// Something that was done, and the document's revision after it.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// What was done.
    pub event: Event,
    /// [`Editor::revision`](crate::Editor::revision) afterwards. Replaying gives the same one.
    pub revision: u64,
}

/// Something that was done. Its names are part of the log's format: add new ones, don't rename. Selections follow the JSON
/// in blocks of their own.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Event {
    /// The command that made the initial document.
    Start(Command),
    /// A command that was carried out at once.
    Run(Command),
    /// A command that was carried out by a job, when the job was finished.
    Job {
        /// The command as it was given.
        command: Command,
        /// What was selected when the command was given.
        #[serde(skip)]
        selection: Arc<Selection>,
        /// The places of the objects that the job read, before its result changed the list.
        objects: Vec<usize>,
        /// The place of the command's object when the command was given.
        at: usize,
        /// The names that these objects had when the command was given, if they were renamed since: parts are named
        /// after the whole.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        names: Vec<String>,
    },
    /// The last command of an ongoing edit that was committed.
    Edit(Command),
    /// The command of an ongoing edit that has not ended. It counts as committed if nothing follows.
    Draft(Command),
    /// The ongoing edit was cancelled, or ended without a change.
    Cancel,
    /// What is selected.
    Select {
        /// The selection.
        #[serde(skip)]
        selection: Arc<Selection>,
        /// Whether it belongs to the same step as the previous selection.
        continues: bool,
    },
    /// The last edit was undone, and with it the changes of the selection since.
    Undo,
    /// The last edit or change of the selection was undone.
    UndoStep,
    /// The last undone edit was redone.
    Redo,
    /// The last undone edit or change of the selection was redone.
    RedoStep,
    /// The document got the name of the file that it was saved as.
    Name(String),
    /// This revision was saved to a file.
    Saved(u64),
    /// The state of the viewport, in the page's own JSON.
    View(String),
    /// Something was done that only the next snapshot holds. What follows can't be replayed.
    Break,
}

/// What JSON holds of an entry.
#[derive(Serialize, Deserialize)]
struct Head<E> {
    revision: u64,
    event: E,
}

const ENTRY_MARK: [u8; 8] = *b"MWentry1";

impl Wire for Entry {
    fn write_to(&self, out: &mut dyn Write) -> io::Result<()> {
        let mut out = Writer::start(out, ENTRY_MARK)?;
        out.value(&Head { revision: self.revision, event: &self.event })?;
        match &self.event {
            Event::Job { selection, .. } | Event::Select { selection, .. } => {
                write_selection(&mut out, selection)
            }
            _ => Ok(()),
        }
    }

    async fn read(from: &mut dyn Read, len: usize, part: Part) -> Result<Self, BadBytes> {
        let mut from = Reader::start(from, len, ENTRY_MARK, part)?;
        let Head { revision, mut event }: Head<Event> = from.value().await?;
        if let Event::Job { selection, .. } | Event::Select { selection, .. } = &mut event {
            *selection = Arc::new(read_selection(&mut from).await?);
        }
        from.end()?;
        Ok(Self { event, revision })
    }
}
