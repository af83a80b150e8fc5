//! Drags and spins: a preview that each movement replaces, and one undo step at the end.

use super::Editor;
use crate::command::{Command, Op};
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
    label: String,
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
        let last = self.drag.take();
        let shown = last.as_ref().map(|drag| (drag.object, drag.label.clone(), drag.selection.clone()));
        let redo = last.map(|drag| self.take_back(drag));
        let result = self.preview(command);
        match (result, shown) {
            (Ok((object, ops, edited, selection)), shown) => {
                let label = ops.first().map_or_else(String::new, |op| op.spec().label.to_owned());
                let selection = shown.map_or(selection, |(_, _, before)| before);
                self.drag = Some(Drag { object, label, journal: edited.journal, selection });
                Ok(Self::outcome(&ops, edited.created, edited.removed))
            }
            (Err(problem), Some((object, label, selection))) => {
                let back = redo.into_iter().flat_map(|redo| self.make(redo)).next();
                if let Some(Change::Journal(_, journal)) = back {
                    self.drop_gone_from_selection();
                    self.drag = Some(Drag { object, label, journal, selection });
                }
                Err(problem)
            }
            (Err(problem), None) => Err(problem),
        }
    }

    #[expect(clippy::type_complexity, reason = "four parts of one preview, named where it is called")]
    fn preview(
        &mut self,
        command: Command,
    ) -> Result<(ObjectId, Vec<Op>, super::Edited, Arc<Selection>), Problem> {
        let selection = self.selection.clone();
        match self.plan(command)? {
            super::Planned::Local { object, ops } => {
                let edited = self.edit(object, &ops)?;
                Ok((object, ops, edited, selection))
            }
            _ => Err(Problem::new("this op can't be dragged: it does not edit a few elements")),
        }
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
        let back = vec![Change::Journal(drag.object, drag.journal)];
        self.push_step(drag.label.clone(), back, drag.selection);
        Some(drag.label)
    }

    /// Takes the preview back without a trace; gives its label, or none where nothing was dragged.
    pub fn cancel_drag(&mut self) -> Option<String> {
        let drag = self.drag.take()?;
        let label = drag.label.clone();
        self.take_back(drag);
        Some(label)
    }
}
