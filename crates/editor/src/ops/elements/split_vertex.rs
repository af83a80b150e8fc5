//! `split-vertex`: split a vertex into two, joined by an edge.

use crate::error::Problem;
use crate::ops::refs::{one, two};
use crate::ops::{
    Action, Arity, EdgeRef, Field, FieldKind, LocalEdit, Operation, Reflection, SYMMETRY, Scope, Slot, Spec,
    Target, VertexRef,
};
use glam::Vec3;
use halfedge::{EdgeId, Element, Mesh, VertexId, edit};
use serde::{Deserialize, Serialize};

/// Split a vertex into two, joined by an edge: the inverse of collapsing one.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SplitVertex {
    /// The vertex; the one where the two edges meet when left out.
    pub vertex: Option<VertexRef>,
    /// Two of its edges, between which its faces are divided; the two selected ones when left out.
    pub edges: Option<[EdgeRef; 2]>,
    /// Where the two vertices go: the one that keeps its id, and the new one.
    #[serde(default, with = "crate::script::json::finite3_pair_option")]
    pub positions: Option<[[f32; 3]; 2]>,
}

impl SplitVertex {
    fn found(&self, mesh: &Mesh) -> Result<(VertexId, [EdgeId; 2]), Problem> {
        Ok((one(self.vertex, "vertex", mesh)?, two(self.edges, "edges", mesh)?))
    }

    fn new_positions(&self) -> Option<[Vec3; 2]> {
        self.positions.map(|pair| pair.map(Vec3::from))
    }
}

const VERTEX: FieldKind = FieldKind::Elements { element: Element::Vertex, arity: Arity::One };

impl Operation for SplitVertex {
    const SPEC: Spec = Spec::new(
        Scope::Elements,
        "split-vertex",
        "Split vertex",
        "Split a vertex into two, joined by an edge.",
    )
    .fields(&[
        Field::required("vertex", VERTEX, "The vertex to split").optional("where the two edges meet"),
        Field::two("edges", Element::Edge, "Two of its edges"),
        Field::required("positions", FieldKind::VectorPair, "The positions of the two vertices")
            .unset("a little apart"),
        SYMMETRY,
    ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Vertex(&mut self.vertex), Slot::TwoEdges(&mut self.edges)]
    }

    fn complete(&mut self, target: &Target<'_>) -> Result<(), Problem> {
        if self.vertex.is_none() {
            let mesh = target.mesh;
            let [a, b] = two(self.edges, "edges", mesh)?.map(|e| mesh.ends(e));
            let shared = a.into_iter().find(|v| b.contains(v));
            let shared = shared.ok_or_else(|| {
                Problem::of_field("vertex", "is missing, and the two edges don't share a vertex")
                    .advise("Select two edges that share a vertex.")
            })?;
            self.vertex = Some(shared.into());
        }
        Ok(())
    }

    fn reflect(&mut self, reflection: Reflection) {
        self.positions = self.positions.map(|pair| pair.map(|position| reflection.vector(position)));
        // The faces that the new vertex gets lie between the edges counter-clockwise.
        if let Some(edges) = self.edges.as_mut().filter(|_| !reflection.is_own) {
            edges.reverse();
        }
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for SplitVertex {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        let (vertex, edges) = self.found(mesh)?;
        Ok(edit::can_split_vertex(mesh, vertex, edges, self.new_positions())?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        let (vertex, edges) = self.found(mesh)?;
        edit::split_vertex(mesh, vertex, edges, self.new_positions())?;
        Ok(())
    }

    fn cost(&self, _mesh: &Mesh) -> usize {
        2
    }
}
