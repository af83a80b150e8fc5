//! Entries of the log.

use super::sets::{read_selection, write_selection};
use crate::job::wire::{BadBytes, Reader, Wire, Writer};
use crate::ops::Command;
use crate::selection::Selection;
use serde::{Deserialize, Serialize};
use serde_json::Value;
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

/// Something that was done.
#[derive(Clone, Debug, PartialEq)]
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
        selection: Arc<Selection>,
        /// The places of the objects that the job read, before its result changed the list.
        objects: Vec<usize>,
        /// The place of the command's object when the command was given.
        at: usize,
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
    /// This revision was saved to a file.
    Saved(u64),
    /// The state of the viewport, in the page's own JSON.
    View(String),
    /// Something was done that only the next snapshot holds. What follows can't be replayed.
    Break,
}

#[derive(Serialize, Deserialize)]
struct Head {
    revision: u64,
    event: EventHead,
}

/// What JSON holds of an event. Names are part of the format: add new ones, don't rename.
#[derive(Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum EventHead {
    Start(Value),
    Run(Value),
    Job { command: Value, objects: Vec<usize>, at: usize },
    Edit(Value),
    Draft(Value),
    Cancel,
    Select { continues: bool },
    Undo,
    UndoStep,
    Redo,
    RedoStep,
    Saved(u64),
    View(String),
    Break,
}

const ENTRY_MARK: [u8; 8] = *b"MWentry1";

impl Wire for Entry {
    fn write_to(&self, out: &mut dyn Write) -> io::Result<()> {
        let mut out = Writer::start(out, ENTRY_MARK)?;
        let (event, selection) = match &self.event {
            Event::Start(command) => (EventHead::Start(command.to_value()), None),
            Event::Run(command) => (EventHead::Run(command.to_value()), None),
            Event::Job { command, selection, objects, at } => {
                let (command, objects) = (command.to_value(), objects.clone());
                (EventHead::Job { command, objects, at: *at }, Some(selection))
            }
            Event::Edit(command) => (EventHead::Edit(command.to_value()), None),
            Event::Draft(command) => (EventHead::Draft(command.to_value()), None),
            Event::Select { selection, continues } => {
                (EventHead::Select { continues: *continues }, Some(selection))
            }
            Event::Cancel => (EventHead::Cancel, None),
            Event::Undo => (EventHead::Undo, None),
            Event::UndoStep => (EventHead::UndoStep, None),
            Event::Redo => (EventHead::Redo, None),
            Event::RedoStep => (EventHead::RedoStep, None),
            Event::Saved(revision) => (EventHead::Saved(*revision), None),
            Event::View(view) => (EventHead::View(view.clone()), None),
            Event::Break => (EventHead::Break, None),
        };
        out.value(&Head { revision: self.revision, event })?;
        selection.map_or(Ok(()), |selection| write_selection(&mut out, selection))
    }

    fn read_from(from: &mut dyn Read, len: usize) -> Result<Self, BadBytes> {
        let mut from = Reader::start(from, len, ENTRY_MARK)?;
        let Head { revision, event } = from.value()?;
        let command = |value| Command::from_value(value).map_err(BadBytes::new);
        let event = match event {
            EventHead::Start(value) => Event::Start(command(value)?),
            EventHead::Run(value) => Event::Run(command(value)?),
            EventHead::Job { command: value, objects, at } => {
                let selection = Arc::new(read_selection(&mut from)?);
                Event::Job { command: command(value)?, selection, objects, at }
            }
            EventHead::Edit(value) => Event::Edit(command(value)?),
            EventHead::Draft(value) => Event::Draft(command(value)?),
            EventHead::Select { continues } => {
                Event::Select { selection: Arc::new(read_selection(&mut from)?), continues }
            }
            EventHead::Cancel => Event::Cancel,
            EventHead::Undo => Event::Undo,
            EventHead::UndoStep => Event::UndoStep,
            EventHead::Redo => Event::Redo,
            EventHead::RedoStep => Event::RedoStep,
            EventHead::Saved(revision) => Event::Saved(revision),
            EventHead::View(view) => Event::View(view),
            EventHead::Break => Event::Break,
        };
        from.end()?;
        Ok(Self { event, revision })
    }
}
