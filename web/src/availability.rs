//! Whether an action can be done now, and if not, why: what greys menu items and buttons.

use std::cell::RefCell;
use std::collections::HashMap;

use editor::OpId;

use crate::actions::Action;
use crate::app::App;
use crate::bezier;
use crate::lists::columns::plural;
use crate::panels::fields;

/// What the editor said of operations since the document or the selection last changed.
#[derive(Default)]
pub(crate) struct Availability {
    known: RefCell<HashMap<OpId, Option<String>>>,
}

impl Availability {
    /// Forgets what was said: something changed.
    pub fn forget(&mut self) {
        self.known.get_mut().clear();
    }

    /// Why an operation on the selection can't be done now, as a sentence; none if it can.
    pub fn why_not(&self, editor: &editor::Editor, id: OpId) -> Option<String> {
        let ask = || {
            // The amounts that a form would fill in don't matter here.
            let filled = fields::initial(id.spec(), &editor::Facts::default());
            let can = fields::command(id, &filled).and_then(|command| editor.can(&command));
            can.err().map(|error| error.reason())
        };
        self.known.borrow_mut().entry(id).or_insert_with(ask).clone()
    }
}

impl App {
    /// Why an action can't be done now, as a sentence that says what to do first; none if it can.
    pub(crate) fn why_not(&self, action: Action) -> Option<String> {
        let kind = self.lists.kind.0;
        let document = self.editor.document();
        match action {
            Action::Undo if self.editor.undo_labels().next().is_none() && !self.editor.is_editing() => {
                Some("There is nothing to undo.".into())
            }
            Action::Redo if self.editor.redo_labels().next().is_none() => {
                Some("There is nothing to redo: nothing was undone since the last edit.".into())
            }
            Action::Save | Action::SaveAs(_) if document.objects().is_empty() => {
                Some("There is nothing to save. Open a file or make a shape first.".into())
            }
            Action::SelectAll | Action::SelectInverse | Action::GoToId => {
                let count = self.editor.mesh().map_or(0, |mesh| mesh.count(kind));
                (count == 0).then(|| format!("The mesh has no {}.", plural(kind).to_lowercase()))
            }
            Action::SelectNone if self.editor.selection().is_empty() => Some("Nothing is selected.".into()),
            Action::Next | Action::Twin if self.selected_halfedge().is_none() => {
                Some("Select a half-edge first.".into())
            }
            Action::Frame | Action::FrameAll if document.objects().is_empty() => {
                Some("There is nothing to look at. Open a file or make a shape first.".into())
            }
            Action::NextLevel | Action::Play | Action::ControlNets => self.why_not_bezier(action),
            Action::WholeCurve
            | Action::AddPoint
            | Action::DeletePoint
            | Action::ElevateDegree
            | Action::SplitCurve => self.why_not_bezier(action),
            // Which of the two it is may take a look at every face, and both say the same of a mesh with none.
            Action::Upsample => self.why_not_operation(OpId::SubdivideCatmullClark),
            Action::Downsample => self.why_not_operation(OpId::Simplify),
            Action::Resample | Action::LongerEdges | Action::ShorterEdges => {
                self.why_not_operation(OpId::Remesh)
            }
            Action::SlideSplit => self.why_not_operation(OpId::SplitEdge),
            Action::Operation(id) => self.why_not_operation(id),
            _ => None,
        }
    }

    fn why_not_operation(&self, id: OpId) -> Option<String> {
        self.availability.why_not(&self.editor, id)
    }

    /// Why something can't be done with the Bezier curve or surface that is active.
    fn why_not_bezier(&self, action: Action) -> Option<String> {
        let Some((_, shape)) = bezier::active(&self.editor) else {
            return Some("Open a Bezier curve or surface, a .bzc or .bez file, first.".into());
        };
        match (action, shape.curve()) {
            (Action::NextLevel | Action::Play, _) => None,
            (Action::ControlNets, None) => None,
            (Action::ControlNets, Some(_)) => Some("A curve's control points are always drawn.".into()),
            (_, None) => Some("This is for Bezier curves, and the active object is a surface.".into()),
            (Action::DeletePoint, Some(_)) if self.player.chosen.is_none() => {
                Some("Choose a control point first.".into())
            }
            (Action::SplitCurve, Some(_)) if self.player.t <= 0.0 || self.player.t >= 1.0 => {
                Some("Move t away from the ends of the curve first.".into())
            }
            (_, Some(_)) => None,
        }
    }
}

/// Whether an operation's button opens a form or starts an edit that follows the pointer instead of
/// acting at once.
pub(crate) fn opens_form(id: OpId) -> bool {
    !id.spec().runs_without_form()
}
