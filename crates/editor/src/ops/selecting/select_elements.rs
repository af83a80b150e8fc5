//! `select-elements`: select elements by id.

use crate::error::Problem;
use crate::ops::choice::choice;
use crate::ops::refs::all;
use crate::ops::{
    Action, Arity, EdgeRef, FaceRef, Field, FieldKind, HalfedgeRef, Operation, Scope, SelectEdit, Spec,
    Target, VertexRef,
};
use halfedge::Element;
use halfedge::geometry::BitSet;
use serde::{Deserialize, Serialize};
use surface::selecting::Finding;

/// Select elements by id.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SelectElements {
    /// Vertices to select.
    pub vertices: Option<Vec<VertexRef>>,
    /// Edges to select.
    pub edges: Option<Vec<EdgeRef>>,
    /// Half-edges to select.
    pub halfedges: Option<Vec<HalfedgeRef>>,
    /// Faces to select.
    pub faces: Option<Vec<FaceRef>>,
    /// How they change the selection.
    pub mode: SelectMode,
}

choice! {
    /// How new elements combine with the current selection, if that is of the same kind.
    pub enum SelectMode {
        /// Only the new elements are selected.
        Replace = "replace" "Replace",
        /// The new elements are added.
        Extend = "extend" "Add",
        /// Those of the new elements that are selected are deselected, the others added.
        Toggle = "toggle" "Add or remove",
        /// The new elements are deselected.
        Remove = "remove" "Deselect",
        /// Those of the new elements that were selected stay so; all others are deselected.
        Intersect = "intersect" "Keep only these",
    }
}

/// The field that says how what is found changes the selection.
pub(crate) const MODE: Field = SelectMode::field("mode", "How what is found changes the selection");

const fn list(name: &'static str, element: Element, description: &'static str) -> Field {
    Field::required(name, FieldKind::Elements { element, arity: Arity::Many }, description)
        .optional("none")
        .alternative("Elements")
}

impl Operation for SelectElements {
    const SPEC: Spec =
        Spec::new(Scope::Selection, "select-elements", "Select elements", "Select elements by id.").fields(
            &[
                list("vertices", Element::Vertex, "Vertices to select"),
                list("edges", Element::Edge, "Edges to select"),
                list("halfedges", Element::Halfedge, "Half-edges to select"),
                list("faces", Element::Face, "Faces to select"),
                MODE,
            ],
        );

    fn action(&self) -> Action<'_> {
        Action::Select(self)
    }
}

impl SelectEdit for SelectElements {
    fn find(&self, target: &Target<'_>) -> Result<Finding, Problem> {
        let mesh = target.mesh;
        let lists =
            [self.vertices.is_some(), self.edges.is_some(), self.halfedges.is_some(), self.faces.is_some()];
        if lists.into_iter().filter(|given| *given).count() != 1 {
            return Err(Problem::new("give exactly one of `vertices`, `edges`, `halfedges` and `faces`")
                .advise("Give one list: vertices, edges, half-edges or faces."));
        }
        let (kind, ids): (Element, BitSet) = if self.vertices.is_some() {
            (Element::Vertex, all(&self.vertices, "vertices", mesh)?.iter().map(|v| v.index()).collect())
        } else if self.edges.is_some() {
            (Element::Edge, all(&self.edges, "edges", mesh)?.iter().map(|e| e.index()).collect())
        } else if self.halfedges.is_some() {
            (Element::Halfedge, all(&self.halfedges, "halfedges", mesh)?.iter().map(|h| h.index()).collect())
        } else {
            (Element::Face, all(&self.faces, "faces", mesh)?.iter().map(|f| f.index()).collect())
        };
        Ok(Finding::known(kind, ids))
    }

    fn mode(&self) -> SelectMode {
        self.mode
    }

    fn takes_hidden(&self) -> bool {
        true
    }
}
