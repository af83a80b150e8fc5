//! Drags and spins: a preview that each movement replaces, and one undo step at the end.

use super::Editor;
use super::run::Planned;
use crate::command::{Command, OperationKind};
use crate::error::{CommandError, Problem};
use crate::history::Change;
use crate::outcome::{Elements, Outcome};
use crate::selection::Selection;
use std::sync::Arc;

/// A drag that is going on: what takes its preview back.
#[derive(Debug)]
pub(super) struct Drag {
    command: Command,
    back: Vec<Change>,
    selection: Arc<Selection>,
}

impl Editor {
    /// Shows what a local edit, or a move of a control point, would do, in place of what the last call of the same drag showed.
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
        let (shown, selection) = (last.command.clone(), last.selection.clone());
        let redo = self.take_back(last);
        self.preview(command, selection.clone()).inspect_err(|_| {
            let back = self.make(redo);
            self.drop_gone_from_selection();
            self.drag = Some(Drag { command: shown, back, selection });
        })
    }

    fn preview(&mut self, command: Command, selection: Arc<Selection>) -> Result<Outcome, Problem> {
        match self.plan(command.clone())? {
            Planned::Local { object, ops } => {
                let edited = self.edit(object, &ops)?;
                let back = vec![Change::Journal(object, edited.journal)];
                self.drag = Some(Drag { command, back, selection });
                Ok(Outcome { warnings: edited.notes, ..Self::outcome(&ops, edited.created, edited.removed) })
            }
            Planned::Document { op, changes } if op.spec().kind == OperationKind::Bezier => {
                let back = self.make_document(changes);
                self.drag = Some(Drag { command, back, selection });
                Ok(Self::outcome(&[op], Elements::default(), Elements::default()))
            }
            Planned::Whole { .. } | Planned::Document { .. } => {
                Err(Problem::new("this op can't be dragged: it does not edit a few elements"))
            }
        }
    }

    /// Takes a preview back and gives what shows it again.
    fn take_back(&mut self, drag: Drag) -> Vec<Change> {
        let redo = self.make(drag.back);
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
        for change in &mut drag.back {
            if let Change::Journal(_, journal) = change {
                journal.fold_moves();
            }
        }
        let label = drag.command.op.spec().label.to_owned();
        self.push_step(label.clone(), drag.back, drag.selection);
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
