//! Whether an action can be done now, and if not, why: what greys menu items and buttons.

use editor::{Field, FieldKind, Spec};
use halfedge::Element;

use crate::actions::{self, Action};
use crate::app::App;
use crate::bezier;
use crate::lists::columns::plural;
use crate::panels::{fields, inspector};
use crate::refusals;

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
            Action::Upsample => self.why_not_operation("subdivide-catmull-clark"),
            Action::Downsample => self.why_not_operation("simplify"),
            Action::Resample | Action::LongerEdges | Action::ShorterEdges => self.why_not_operation("remesh"),
            Action::SlideSplit => self.why_not_operation("split-edge"),
            Action::Operation(name) => self.why_not_operation(name),
            _ => None,
        }
    }

    fn why_not_operation(&self, name: &str) -> Option<String> {
        let spec = actions::operation(name)?;
        if name == "new" {
            return None;
        }
        let Some(mesh) = self.editor.mesh() else {
            return Some("There is no object to work on. Open a file or make a shape first.".into());
        };
        match bezier::active(&self.editor) {
            Some((object, shape)) if name != "bezier-tessellate" || shape.curve().is_some() => {
                let what = match shape.curve() {
                    Some(_) => "a Bezier curve, which has no faces",
                    None => "a Bezier surface. Tessellate it first",
                };
                return Some(format!("{} is {what}.", object.name()));
            }
            None if name == "bezier-tessellate" => {
                return Some("This is a mesh already. Open a Bezier surface, a .bez file, first.".into());
            }
            _ => {}
        }
        // Separating by pieces or groups takes no faces; its form says what it does take.
        let fields = if name == "separate" { &[] } else { spec.fields };
        if let Some(reason) = fields.iter().find_map(|field| self.why_not_field(field)) {
            return Some(reason);
        }
        let selection = self.editor.selection();
        let any_kind = spec.fields.iter().any(|field| field.default == Some("the selection"));
        if any_kind && !inspector::applies_to(spec, selection.kind()) {
            let what = plural(selection.kind()).to_lowercase();
            return Some(format!("“{}” does not work on {what}. Select something else first.", spec.label));
        }
        match name {
            "subdivide-catmull-clark" | "subdivide-loop" | "subdivide-linear" if mesh.face_count() == 0 => {
                Some("The mesh has no face to subdivide.".into())
            }
            "join-objects" if self.editor.document().objects().len() < 2 => {
                Some("There is only one object, so there is nothing to join.".into())
            }
            "simplify" | "remesh" | "smooth" | "separate" if mesh.face_count() == 0 => {
                Some("The mesh has no face.".into())
            }
            "subdivide-loop" if self.survey.found().is_some_and(|found| !found.triangles_only) => {
                Some("Loop subdivision needs a mesh of triangles. Triangulate the faces first.".into())
            }
            "repair-import" if !self.editor.document().active().is_some_and(editor::Object::is_repairable) => Some(
                "Nothing had to be repaired when this object was read, so there is nothing to do another way."
                    .into(),
            ),
            "triangulate-faces" => {
                let chosen = selection.kind() == Element::Face && !selection.is_empty();
                let faces: Vec<_> = if chosen {
                    // Looking at a few is enough to say no, and saying yes wrongly costs nothing.
                    selection.ids().take(1000).filter_map(|id| mesh.face(id)).collect()
                } else {
                    return self
                        .survey
                        .found()
                        .is_some_and(|found| found.triangles_only)
                        .then(|| "All faces are triangles already.".into());
                };
                faces
                    .iter()
                    .all(|&f| mesh.face_halfedges(f).take(4).count() == 3)
                    .then(|| "The selected faces are triangles already.".into())
            }
            _ => None,
        }
        .or_else(|| refusals::refusal(mesh, selection, name).map(|refusal| capital(&refusal.to_string())))
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

    /// What a field lacks that the selection would have to give.
    fn why_not_field(&self, field: &Field) -> Option<String> {
        let selection = self.editor.selection();
        let words = field.default.unwrap_or_default();
        if words == "the selection" && fields::is_elements(field.kind) {
            return selection.is_empty().then(|| "Select something first.".into());
        }
        let two = words.starts_with("the two selected");
        if !(two || words.starts_with("the selected")) || words.contains(", or all") {
            return None;
        }
        let kind = selection.kind();
        let (fits, element) = match field.kind {
            FieldKind::Vertex => (kind == Element::Vertex, Element::Vertex),
            // Those of selected edges and faces stand in.
            FieldKind::Vertices => (!two || kind == Element::Vertex, Element::Vertex),
            FieldKind::Edge | FieldKind::Edges => {
                (matches!(kind, Element::Edge | Element::Halfedge), Element::Edge)
            }
            FieldKind::Halfedge | FieldKind::Halfedges => (kind == Element::Halfedge, Element::Halfedge),
            FieldKind::Face | FieldKind::Faces => (kind == Element::Face, Element::Face),
            _ => return None,
        };
        if two {
            let ready = fits && selection.len() == 2;
            return (!ready).then(|| format!("Select two {} first.", plural(element).to_lowercase()));
        }
        let article = if element == Element::Edge { "an" } else { "a" };
        (selection.is_empty() || !fits).then(|| format!("Select {article} {element} first."))
    }
}

/// Whether an operation does something sensible with nothing filled in: every field is given by the
/// selection or has a value for a default. One whose defaults are words, such as "no turn", opens its
/// form instead.
pub(crate) fn runs_bare(spec: &Spec) -> bool {
    spec.name != "new"
        && spec.fields.iter().all(|field| {
            field.default.is_some()
                && (fields::is_elements(field.kind) || fields::default_value(field).is_some())
        })
}

/// A sentence of a refusal's words.
pub(crate) fn capital(text: &str) -> String {
    let mut chars = text.chars();
    match chars.next() {
        Some(first) => format!("{}{}.", first.to_uppercase(), chars.as_str().trim_end_matches('.')),
        None => String::new(),
    }
}
