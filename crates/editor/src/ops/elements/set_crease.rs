//! `set-crease`: set how sharp edges and vertices stay.

use crate::error::Problem;
use crate::ops::refs::{all, count};
use crate::ops::{
    Action, EdgeRef, Field, LocalEdit, Operation, SYMMETRY, Scope, Selected, Slot, Spec, Unit, VertexRef,
};
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Set how sharp edges and vertices stay under subdivision.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SetCrease {
    /// Edges. When no elements are given at all, the selected edges or vertices stand in.
    pub edges: Option<Vec<EdgeRef>>,
    /// Vertices.
    pub vertices: Option<Vec<VertexRef>>,
    /// 0 is smooth; 10 or more is infinitely sharp.
    #[serde(with = "crate::script::json::finite")]
    pub sharpness: f32,
}

/// Marking an edge is this much less work than linking a face.
const EDGES_MARKED_PER_FACE_LINKED: usize = 16;

impl Operation for SetCrease {
    const SPEC: Spec = Spec::new(
        Scope::Elements,
        "set-crease",
        "Set crease",
        "Set how sharp edges and vertices stay under subdivision.",
    )
    .synonyms(&["sharp", "edge crease"])
    .fields(&[
        Field::many("edges", Element::Edge, Selected::All, "Edges to make sharp"),
        Field::many("vertices", Element::Vertex, Selected::All, "Vertices to make sharp"),
        Field::number(
            "sharpness",
            Unit::Count,
            edit::CREASE_SHARPNESS_RANGE,
            "0 is smooth, 10 or more infinitely sharp",
        ),
        SYMMETRY,
    ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Edges(&mut self.edges), Slot::Vertices(&mut self.vertices)]
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for SetCrease {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        let (edges, vertices) = (all(&self.edges, "edges", mesh)?, all(&self.vertices, "vertices", mesh)?);
        Ok(edit::can_set_crease(mesh, &edges, &vertices, self.sharpness)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        let (edges, vertices) = (all(&self.edges, "edges", mesh)?, all(&self.vertices, "vertices", mesh)?);
        edit::set_crease(mesh, &edges, &vertices, self.sharpness)?;
        Ok(())
    }

    fn cost(&self, _mesh: &Mesh) -> usize {
        (count(&self.edges, 0) + count(&self.vertices, 0)) / EDGES_MARKED_PER_FACE_LINKED
    }
}
