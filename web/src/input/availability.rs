//! Whether an action can be done now, and if not, why: menu items and buttons are greyed accordingly.

use editor::{Document, OpId};
use formats::Format;
use halfedge::Element;

use crate::bezier::{self, Player};
use crate::input::actions::Action;
use crate::lists::columns::plural;
use crate::session::{Session, form};
use crate::transforming::CursorAction;
use crate::view::textures;
use viewport::Look;

/// Why an action can't be done now, as a sentence that says what to do first; none if it can. `kind` is
/// the kind of element that the list shows.
pub(crate) fn why_not(action: Action, session: &Session, kind: Element, player: &Player) -> Option<String> {
    let editor = &session.editor;
    let document = editor.document();
    let operation = |id| session.why_not_operation(id);
    match action {
        Action::Undo if editor.next_undo().is_none() && !editor.is_editing() => {
            Some("There is nothing to undo.".into())
        }
        Action::Redo if editor.next_redo().is_none() => {
            Some("There is nothing to redo: nothing was undone since the last edit.".into())
        }
        Action::Adjust if form::adjustable(editor).is_none() => {
            Some("There is no operation whose fields could be changed.".into())
        }
        Action::Save | Action::SaveAs(_) if document.objects().is_empty() => {
            Some("There is nothing to save. Open a file or make a shape first.".into())
        }
        Action::Share if document.objects().is_empty() => {
            Some("There is nothing to share. Open a file or make a shape first.".into())
        }
        Action::Update if !session.update_is_ready => {
            Some("This is the newest version. A newer one is downloaded by itself.".into())
        }
        Action::Share if session.platform.address().is_none() => {
            Some("Links work with the editor's web page only. Save a project file and send that instead.".into())
        }
        Action::SaveAs(format) => why_not_in(format, document),
        Action::SelectAll
        | Action::SelectInverse
        | Action::GoToId
        | Action::NextElement
        | Action::PreviousElement => {
            let count = editor.mesh().map_or(0, |mesh| mesh.count(kind));
            (count == 0).then(|| format!("The mesh has no {}.", plural(kind).to_lowercase()))
        }
        Action::Preset(preset) => {
            editor.can(&preset.command(glam::DVec3::Z)).err().map(|error| error.reason())
        }
        Action::SelectBy(by) => editor.can_select_by(by).err().map(|error| error.reason()),
        Action::SelectNone if editor.selection().is_empty() => Some("Nothing is selected.".into()),
        Action::Next
        | Action::Previous
        | Action::Twin
        | Action::VertexOf
        | Action::EdgeOf
        | Action::FaceOf
            if session.selected_halfedge().is_none() =>
        {
            Some("Select a half-edge first.".into())
        }
        Action::AlignView if editor.selection().is_empty() => Some("Select something first.".into()),
        Action::FaceOf => {
            let face = session.selected_halfedge().and_then(|h| editor.mesh()?.face_of(h));
            face.is_none().then(|| "The half-edge is on the boundary and has no face.".into())
        }
        Action::Frame | Action::FrameAll if document.objects().is_empty() => {
            Some("There is nothing to look at. Open a file or make a shape first.".into())
        }
        Action::Look(Look::Texture) if !textures::has_textures(document) => Some(
            "No material here has an image. Open a model together with its images, or drop the missing ones on the page."
                .into(),
        ),
        Action::Look(Look::Checker) if !textures::has_uvs(document) => {
            Some("The model has no texture coordinates.".into())
        }
        Action::NextLevel | Action::Play | Action::ControlNets => why_not_bezier(action, session, player),
        Action::WholeCurve
        | Action::AddPoint
        | Action::DeletePoint
        | Action::ElevateDegree
        | Action::SplitCurve => why_not_bezier(action, session, player),
        // Which of the two applies may take a pass over all faces; on an empty mesh both give the same
        // reason.
        Action::Upsample => operation(OpId::SubdivideCatmullClark),
        Action::Downsample => operation(OpId::Simplify),
        Action::Resample | Action::LongerEdges | Action::ShorterEdges => operation(OpId::Remesh),
        Action::LoopCutTool => {
            let edges = editor.mesh().map_or(0, |mesh| mesh.count(Element::Edge));
            (edges == 0).then(|| "There are no faces to cut. Open a file or make a shape first.".into())
        }
        Action::SlideSplit => operation(OpId::SplitEdge),
        Action::Cursor(CursorAction::ToSelection) if editor.selection().is_empty() => {
            Some("Select something first.".into())
        }
        Action::Cursor(CursorAction::TakesSelection) => operation(OpId::Transform),
        Action::Cursor(CursorAction::Merge) => operation(OpId::MergeVertices),
        Action::Operation(OpId::Isolate) if editor.selection().is_empty() => {
            operation(OpId::Reveal).map(|_| "Select something first.".into())
        }
        Action::Move | Action::Rotate | Action::Scale => operation(OpId::Transform),
        Action::Operation(id) => operation(id),
        _ => None,
    }
}

/// Why a document can't be saved in a format: formats for control points hold nothing of a mesh.
fn why_not_in(format: Format, document: &Document) -> Option<String> {
    let holds_curves =
        [true, false].into_iter().find(|curves| Format::for_bezier(*curves) == Some(format))?;
    let mut kinds = document.objects().iter().filter_map(|object| Some(object.bezier()?.curve().is_some()));
    let shape = if holds_curves { "curve" } else { "surface" };
    let reason = || format!("{} holds a Bezier {shape}, and the document has none.", format.name());
    (!kinds.any(|is_curve| is_curve == holds_curves)).then(reason)
}

/// Why an action can't be done with the active Bezier curve or surface.
fn why_not_bezier(action: Action, session: &Session, player: &Player) -> Option<String> {
    let Some((_, shape)) = bezier::active(&session.editor) else {
        return Some("Open a Bezier curve (.bzc) or surface (.bez) first.".into());
    };
    match (action, shape.curve()) {
        (Action::NextLevel | Action::Play, _) => None,
        (Action::ControlNets, None) => None,
        (Action::ControlNets, Some(_)) => Some("A curve's control points are always drawn.".into()),
        (_, None) => Some("This works only on Bezier curves; the active object is a surface.".into()),
        (Action::DeletePoint, Some(_)) if player.controls.chosen.is_none() => {
            Some("Choose a control point first.".into())
        }
        (Action::SplitCurve, Some(_)) if player.controls.t <= 0.0 || player.controls.t >= 1.0 => {
            Some("Move t away from the ends of the curve first.".into())
        }
        (_, Some(_)) => None,
    }
}

/// Whether an operation starts an edit that follows the pointer. One with several amounts that could follow it has an
/// action for each, and opens its form.
pub(crate) fn follows_pointer(id: OpId) -> bool {
    opens_form(id) && id.spec().fields.iter().filter(|field| field.drag.is_some()).count() == 1
}

/// Whether an operation's button opens a form or starts an edit that follows the pointer instead of
/// acting at once.
pub(crate) fn opens_form(id: OpId) -> bool {
    !id.spec().runs_without_form()
}
