//! `select-related`: select elements related to the selection.

use crate::error::Problem;
use crate::ops::choice::choice;
use crate::ops::{Action, Operation, Scope, SelectEdit, SelectMode, Spec, Target};
use serde::{Deserialize, Serialize};
use surface::selecting::Finding;

/// Select elements related to the selection.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SelectRelated {
    /// What to select.
    pub by: Relation,
}

choice! {
    /// What follows from a selection.
    pub enum Relation {
        /// It and its neighbours.
        Grow = "grow" "Grow",
        /// It without the elements beside unselected ones.
        Shrink = "shrink" "Shrink",
        /// The connected pieces that it is in.
        Linked = "linked" "Linked",
        /// The loops that it is on.
        Loops = "loops" "Loops",
        /// The rings that it is on.
        Rings = "rings" "Rings",
        /// The shortest path between its two elements.
        Path = "path" "Shortest path",
        /// The edges around its faces.
        Outline = "outline" "Outline",
        /// Its vertices.
        Vertices = "vertices" "Vertices",
        /// The edges in it.
        Edges = "edges" "Edges",
        /// The half-edges in it.
        Halfedges = "halfedges" "Half-edges",
        /// The faces in it.
        Faces = "faces" "Faces",
        /// Every edge that has one of its vertices.
        TouchingEdges = "touching-edges" "Touching edges",
        /// Every half-edge that has one of its vertices.
        TouchingHalfedges = "touching-halfedges" "Touching half-edges",
        /// Every face that has one of its vertices, edges or half-edges.
        TouchingFaces = "touching-faces" "Touching faces",
    }
}

impl Operation for SelectRelated {
    const SPEC: Spec = Spec::new(
        Scope::Selection,
        "select-related",
        "Select related",
        "Change the selection to its neighbours, pieces, loops or rings, or to another kind of element.",
    )
    .fields(&[Relation::field("by", "What to select")]);

    fn action(&self) -> Action<'_> {
        Action::Select(self)
    }
}

impl SelectEdit for SelectRelated {
    fn find(&self, target: &Target<'_>) -> Result<Finding, Problem> {
        crate::editor::find_related(target.mesh, target.selection, self.by.into())
    }

    fn mode(&self) -> SelectMode {
        SelectMode::Replace
    }
}
