//! Drags and spins: a preview that each movement replaces, and one undo step at the end.

use super::Editor;
use super::run::Planned;
use crate::command::Command;
use crate::document::ObjectId;
use crate::error::{CommandError, Problem};
use crate::history::Change;
use crate::outcome::Outcome;
use crate::selection::Selection;
use halfedge::Journal;
use std::sync::Arc;

/// A drag that is going on: what takes its preview back.
#[derive(Debug)]
pub(super) struct Drag {
    object: ObjectId,
    command: Command,
    journal: Journal,
    selection: Arc<Selection>,
}

impl Editor {
    /// Shows what a local edit would do, in place of what the last call of the same drag showed.
    /// The document has the preview in it until [`Editor::commit_drag`] or [`Editor::cancel_drag`].
    ///
    /// # Errors
    /// Why the edit is refused; the last preview stays.
    pub fn drag(&mut self, command: Command) -> Result<Outcome, CommandError> {
        let name = command.name();
        self.drag_inner(command).map_err(|problem| CommandError::of(name, problem))
    }

    fn drag_inner(&mut self, command: Command) -> Result<Outcome, Problem> {
        // The elements are looked for in the document without the preview, as at the commit.
        let Some(last) = self.drag.take() else {
            let selection = self.selection.clone();
            return self.preview(command, selection);
        };
        let (object, shown, selection) = (last.object, last.command.clone(), last.selection.clone());
        let redo = self.take_back(last);
        self.preview(command, selection.clone()).inspect_err(|_| {
            if let Some(Change::Journal(_, journal)) = self.make(redo).pop() {
                self.drop_gone_from_selection();
                self.drag = Some(Drag { object, command: shown, journal, selection });
            }
        })
    }

    fn preview(&mut self, command: Command, selection: Arc<Selection>) -> Result<Outcome, Problem> {
        let Planned::Local { object, ops } = self.plan(command.clone())? else {
            return Err(Problem::new("this op can't be dragged: it does not edit a few elements"));
        };
        let edited = self.edit(object, &ops)?;
        self.drag = Some(Drag { object, command, journal: edited.journal, selection });
        Ok(Outcome { warnings: edited.notes, ..Self::outcome(&ops, edited.created, edited.removed) })
    }

    /// Takes a preview back and gives what shows it again.
    fn take_back(&mut self, drag: Drag) -> Vec<Change> {
        let redo = self.make(vec![Change::Journal(drag.object, drag.journal)]);
        if self.selection != drag.selection {
            self.selection = drag.selection;
            self.changes.selection = true;
        }
        redo
    }

    /// Whether a drag is going on.
    pub fn is_dragging(&self) -> bool {
        self.drag.is_some()
    }

    /// Makes the preview one undo step; gives its label, or none where nothing was dragged.
    pub fn commit_drag(&mut self) -> Option<String> {
        let mut drag = self.drag.take()?;
        drag.journal.fold_moves();
        let label = drag.command.op.spec().label.to_owned();
        let back = vec![Change::Journal(drag.object, drag.journal)];
        self.push_step(label.clone(), back, drag.selection);
        self.remember(drag.command);
        Some(label)
    }

    /// Takes the preview back without a trace; gives its label, or none where nothing was dragged.
    pub fn cancel_drag(&mut self) -> Option<String> {
        let drag = self.drag.take()?;
        let label = drag.command.op.spec().label.to_owned();
        self.take_back(drag);
        Some(label)
    }
}
