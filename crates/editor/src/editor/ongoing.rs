//! The ongoing edit: a preview in the document that each update replaces, which becomes one undo step at
//! the end. Drags, edits that follow the pointer, spin boxes, painting and form previews are ongoing edits.

use super::Editor;
use super::run::Planned;
use crate::error::{CommandError, Problem};
use crate::history::Change;
use crate::ops::{Action, Command, Commit, Op, Scope, Symmetry};
use crate::outcome::{Elements, Outcome};
use crate::recovery::Event;
use crate::selection::Selection;
use std::ops::ControlFlow;
use std::sync::Arc;

/// An ongoing edit, with the changes that cancel its preview.
#[derive(Debug)]
pub(super) struct Ongoing {
    command: Command,
    back: Vec<Change>,
    selection: Arc<Selection>,
    /// Whether it previews an operation on the whole mesh.
    whole: bool,
}

impl Editor {
    /// Shows the effect of a local edit, a move of a control point, or an operation on the whole mesh, in
    /// place of the previous update's. The document contains the preview until [`Editor::commit_edit`] or
    /// [`Editor::cancel_edit`].
    ///
    /// Any other command first commits an ongoing edit of elements, or cancels the preview of an operation
    /// on the whole mesh.
    ///
    /// # Errors
    /// The edit is refused, or the operation takes too long to be previewed (see [`Editor::is_quick`]); the
    /// last preview stays.
    pub fn update_edit(&mut self, command: Command) -> Result<Outcome, CommandError> {
        let name = command.name();
        self.replace_preview(command).map_err(|problem| CommandError::of(name, problem))
    }

    fn replace_preview(&mut self, command: Command) -> Result<Outcome, Problem> {
        self.finish_parts();
        // Resolves the elements in the document without the preview, as the commit does.
        let Some(last) = self.ongoing.take() else {
            let selection = self.selection.clone();
            return self.show_preview(command, selection);
        };
        let (shown, selection, whole) = (last.command.clone(), last.selection.clone(), last.whole);
        let selected = self.selection.clone();
        let redo = self.remove_preview(last);
        self.show_preview(command, selection.clone()).inspect_err(|_| {
            let back = self.apply(redo);
            self.selection = selected;
            self.changes.selection = true;
            self.ongoing = Some(Ongoing { command: shown, back, selection, whole });
        })
    }

    fn show_preview(&mut self, command: Command, selection: Arc<Selection>) -> Result<Outcome, Problem> {
        let (back, outcome, whole) = match self.plan(command.clone())? {
            Planned::Local { object, ops, symmetry, .. } => {
                // Edits by hand leave their result selected, also where they name their elements.
                let edited = self.edit(object, &ops, symmetry, true)?;
                let outcome = Self::outcome(&command.op, edited.created, edited.removed);
                let outcome = Outcome { warnings: edited.notes, ..outcome };
                (edited.back, outcome, false)
            }
            Planned::Document { op, changes } if op.spec().scope == Scope::Bezier => {
                let back = self.apply_to_document(changes);
                (back, Self::outcome(&op, Elements::default(), Elements::default()), false)
            }
            Planned::Whole { op, objects, at } if replaces_its_object(&op) => {
                if !self.is_small(std::slice::from_ref(&op), Symmetry::None, &objects) {
                    return Err(Problem::new("a preview takes too long on a mesh of this size"));
                }
                let made = self.compute(&op, &objects, &mut |_| ControlFlow::Continue(()))?;
                if self.is_unchanged(&op, &objects, &made) {
                    (Vec::new(), Self::unchanged(&op, made)?, true)
                } else {
                    let (outcome, back) = self.put_result(&op, &objects, at, made)?;
                    (back, outcome, true)
                }
            }
            Planned::Whole { .. } | Planned::Document { .. } | Planned::Select { .. } => {
                return Err(Problem::new(
                    "this operation can't be dragged or previewed, because it doesn't change a single mesh",
                ));
            }
        };
        self.ongoing = Some(Ongoing { command, back, selection, whole });
        Ok(outcome)
    }

    /// Removes a preview and returns the changes that show it again.
    fn remove_preview(&mut self, ongoing: Ongoing) -> Vec<Change> {
        let redo = self.apply(ongoing.back);
        if self.selection != ongoing.selection {
            self.selection = ongoing.selection;
            self.changes.selection = true;
        }
        redo
    }

    /// The last command of the ongoing edit.
    pub(crate) fn ongoing_command(&self) -> Option<&Command> {
        self.ongoing.as_ref().map(|ongoing| &ongoing.command)
    }

    /// Whether an edit is ongoing.
    pub fn is_editing(&self) -> bool {
        self.ongoing.is_some()
    }

    /// Whether the ongoing edit previews an operation on the whole mesh.
    pub fn is_previewing_mesh(&self) -> bool {
        self.ongoing.as_ref().is_some_and(|ongoing| ongoing.whole)
    }

    /// Ends the ongoing edit because something else happens: commits an edit of elements, cancels the
    /// preview of an operation on the whole mesh.
    pub(super) fn end_edit(&mut self) {
        self.finish_parts();
        if self.is_previewing_mesh() {
            self.cancel_edit()
        } else {
            self.commit_edit()
        };
    }

    /// Makes the preview one undo step, unless it changes nothing; returns its label, or none if no edit is
    /// ongoing.
    pub fn commit_edit(&mut self) -> Option<String> {
        let ongoing = self.ongoing.take()?;
        let label = ongoing.command.op.label().to_owned();
        if self.push_step(label.clone(), ongoing.back, ongoing.selection) {
            self.log(Event::Edit(ongoing.command.clone()));
            self.remember(ongoing.command);
        } else {
            self.log_cancelled();
        }
        Some(label)
    }

    /// Removes the preview without a trace; returns its label, or none if no edit is ongoing.
    pub fn cancel_edit(&mut self) -> Option<String> {
        let ongoing = self.ongoing.take()?;
        let label = ongoing.command.op.label().to_owned();
        self.remove_preview(ongoing);
        self.log_cancelled();
        Some(label)
    }
}

/// Whether the operation's result replaces the mesh of its own object.
fn replaces_its_object(op: &Op) -> bool {
    matches!(op.action(), Action::WholeMesh(whole) if whole.commit() == Commit::Replace)
}
