//! Repeating the steps of a project.

use super::file::{Past, Project, is_same};
use crate::document::{ObjectId, Origin};
use crate::editor::Editor;
use crate::ops::Command;
use crate::recovery::{Entry, Event, Numbers, Snapshot, read_log};

/// The work of all steps together, in faces read or written, that is repeated when a project is opened.
const MAX_WORK: usize = 500_000;

/// The work that a step is taken for at least.
const MIN_WORK: usize = 100;

/// The faces of a document for which each step counts one more: checks and lists take time in proportion.
const FACES_PER_WORK: usize = 500;

/// How much was repeated.
#[derive(Default)]
pub(super) struct Work(usize);

impl Work {
    /// Counts a step that comes next, the one of a command or any other; false if it is too much.
    pub fn allows(&mut self, editor: &Editor, command: Option<&Command>) -> bool {
        let objects = editor.document().objects().iter();
        let faces: usize = objects.map(|object| object.mesh().face_count()).sum();
        let of_command = command.and_then(|command| editor.cost(command)).unwrap_or(0);
        self.0 = self.0.saturating_add(MIN_WORK + faces / FACES_PER_WORK).saturating_add(of_command);
        self.0 <= MAX_WORK
    }
}

/// The numbers that an editor has not given out yet.
#[derive(Clone, Copy)]
pub(crate) struct Unused {
    pub object: u64,
    pub revision: u64,
    pub step: u64,
}

impl Project {
    /// An editor on the project's document, without a history.
    pub(crate) fn without_history(&self, unused: Unused, history_limit: usize) -> Editor {
        editor_on(self.now.clone(), unused, history_limit)
    }

    /// An editor in which the steps of the history were done again, and the number of objects before the first of them.
    ///
    /// # Errors
    /// The steps can't be repeated, would take too long or lead to another document: a clause.
    pub(crate) fn repeat(&self, unused: Unused, history_limit: usize) -> Result<(Editor, usize), String> {
        // An editor that keeps no history needs no steps.
        let Some(past) = self.history.as_ref().filter(|_| history_limit > 0) else {
            return Ok((self.without_history(unused, history_limit), self.now.document.objects.len()));
        };
        let mut editor = editor_on(past.start.clone(), unused, history_limit);
        let numbers = past.start.numbers;
        let renumber = |revision: u64| match revision.checked_sub(numbers.last_revision) {
            Some(later @ 1..) => unused.revision.checked_add(later),
            _ => (revision == numbers.revision).then_some(unused.revision),
        };
        let objects = repeat_steps(&mut editor, past, renumber)?;
        let is_there = renumber(self.now.numbers.revision) == Some(editor.revision());
        if !is_there || !is_same(&Snapshot::of(&editor), &self.now) {
            return Err("repeating its steps leads to another document".to_owned());
        }
        editor.rename_document(self.now.document.name());
        Ok((editor, objects))
    }
}

fn editor_on(mut snapshot: Snapshot, unused: Unused, history_limit: usize) -> Editor {
    let objects = &mut snapshot.document.objects;
    let mut next_object = unused.object;
    for object in objects.iter_mut() {
        *object = object.clone().with_id(ObjectId(next_object));
        next_object += 1;
    }
    let revision = unused.revision;
    snapshot.document.origin = Origin { revision, is_file: true };
    snapshot.numbers = Numbers { next_object, revision, last_revision: revision, saved: revision };
    let mut editor = snapshot.into_editor();
    editor.begin_steps_at(unused.step, history_limit);
    editor
}

/// Does the steps again; returns the number of objects before the first one that can be undone.
fn repeat_steps(
    editor: &mut Editor,
    past: &Past,
    renumber: impl Fn(u64) -> Option<u64>,
) -> Result<usize, String> {
    let records = read_log(&past.log);
    if records.is_cut_off {
        return Err("its log is damaged".to_owned());
    }
    let mut work = Work::default();
    let mut objects_at_start = editor.document().objects().len();
    for Entry { event, revision } in records.entries {
        let objects = editor.document().objects();
        let command = match &event {
            Event::Job { objects: read, .. } if read.len() > objects.len() => {
                return Err("a step reads objects that are not there".to_owned());
            }
            // They mean nothing here, but name revisions.
            Event::Saved(_) => continue,
            Event::Start(command) | Event::Run(command) | Event::Edit(command) | Event::Draft(command) => {
                Some(command)
            }
            Event::Job { command, .. } => Some(command),
            _ => None,
        };
        if !work.allows(editor, command) {
            return Err("repeating its steps would take too long".to_owned());
        }
        let revision = renumber(revision).ok_or("its log does not fit its document")?;
        let begins = matches!(event, Event::Start(_));
        editor
            .replay(Entry { event, revision })
            .map_err(|error| format!("a step can't be repeated: {error}"))?;
        if begins {
            // What was before can't be undone.
            objects_at_start = editor.document().objects().len();
        }
    }
    editor.commit_edit();
    if !editor.has_whole_history() {
        return Err("its steps take more memory than undo may take".to_owned());
    }
    Ok(objects_at_start)
}
