//! Drags and spins: a preview that each movement replaces, and one undo step at the end.

use super::Editor;
use super::run::Planned;
use crate::command::{Action, Command, Commit, Op, OperationKind};
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
    /// It tries an operation on the whole mesh.
    whole: bool,
}

impl Editor {
    /// Shows what a local edit, a move of a control point, or an operation on the whole mesh would do,
    /// in place of what the last call of the same drag showed. The document has the preview in it until
    /// [`Editor::commit_drag`] or [`Editor::cancel_drag`].
    ///
    /// Whatever else is done meanwhile makes an edit that is dragged a step of its own first, as the
    /// hand that dragged it meant it; an operation on the whole mesh is only tried, and taken back.
    ///
    /// # Errors
    /// Why the edit is refused, or that an operation takes too long to be previewed
    /// ([`Editor::is_quick`]); the last preview stays.
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
        let (shown, selection, whole) = (last.command.clone(), last.selection.clone(), last.whole);
        let redo = self.take_back(last);
        self.preview(command, selection.clone()).inspect_err(|_| {
            let back = self.make(redo);
            self.drop_gone_from_selection();
            self.drag = Some(Drag { command: shown, back, selection, whole });
        })
    }

    fn preview(&mut self, command: Command, selection: Arc<Selection>) -> Result<Outcome, Problem> {
        let (back, outcome, whole) = match self.plan(command.clone())? {
            Planned::Local { object, ops } => {
                let edited = self.edit(object, &ops)?;
                let outcome =
                    Outcome { warnings: edited.notes, ..Self::outcome(&ops, edited.created, edited.removed) };
                (vec![Change::Journal(object, edited.journal)], outcome, false)
            }
            Planned::Document { op, changes } if op.spec().kind == OperationKind::Bezier => {
                let back = self.make_document(changes);
                (back, Self::outcome(&[op], Elements::default(), Elements::default()), false)
            }
            Planned::Whole { op, objects, at } if changes_one_mesh(&op) => {
                if !self.is_small(std::slice::from_ref(&op), &objects) {
                    return Err(Problem::new("on a mesh of this size it takes too long to be previewed"));
                }
                let made = self.compute(&op, &objects, &mut |_| std::ops::ControlFlow::Continue(()))?;
                let (outcome, back) = self.put_whole(&op, &objects, at, made)?;
                (back, outcome, true)
            }
            Planned::Whole { .. } | Planned::Document { .. } => {
                return Err(Problem::new(
                    "this op can't be dragged or previewed: it does not change one mesh",
                ));
            }
        };
        self.drag = Some(Drag { command, back, selection, whole });
        Ok(outcome)
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

    /// Whether what is shown is an operation on the whole mesh that is only tried.
    pub fn is_trying(&self) -> bool {
        self.drag.as_ref().is_some_and(|drag| drag.whole)
    }

    /// Ends a drag because something else is done: an edit becomes a step, an operation that is only
    /// tried goes.
    pub(super) fn settle(&mut self) {
        if self.is_trying() {
            self.cancel_drag()
        } else {
            self.commit_drag()
        };
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

/// Whether an operation changes meshes in place, and nothing else of the document.
fn changes_one_mesh(op: &Op) -> bool {
    matches!(op.action(), Action::WholeMesh(whole) if whole.commit() == Commit::Replace)
}
