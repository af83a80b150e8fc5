//! Drags that slide the selection along its neighbours.

use editor::OpId;
use egui::Pos2;

use super::Viewport;
use crate::input::actions::Action;
use crate::live::edit::Start;
use crate::request::{Request, Requests};
use crate::view::Gesture;

/// Starts to slide the selected edges or vertices; says why not where they can't.
pub(super) fn start(viewport: &Viewport<'_>, from: Pos2, out: &mut Requests) -> Gesture {
    let kind = viewport.session.editor.selection().kind();
    let slide = Action::Operation(OpId::SlideEdges).for_selection(kind);
    let Action::Operation(id) = slide else { return Gesture::Ended };
    if let Some(reason) = viewport.page().why_not(slide) {
        out.push(Request::Warn(reason));
        return Gesture::Ended;
    }
    out.push(Request::StartLive(Start { from: Some(from), ..Start::new(id, "") }));
    Gesture::Slide
}
