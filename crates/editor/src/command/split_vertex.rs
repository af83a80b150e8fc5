//! `split-vertex`: a vertex made two.

use super::fields::{one, pair};
use super::{
    Action, EdgeRef, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target, VertexRef,
};
use crate::error::Problem;
use glam::Vec3;
use halfedge::{EdgeId, Element, Mesh, VertexId, edit};
use serde::{Deserialize, Serialize};

/// Makes a vertex two, joined by an edge: the inverse of collapsing one.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SplitVertex {
    /// The vertex; where the two edges meet if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vertex: Option<VertexRef>,
    /// Two of its edges, at which its faces are shared out; the two selected ones if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edges: Option<[EdgeRef; 2]>,
    /// Where the two vertices go: the one that keeps its id, and the new one.
    #[serde(default, skip_serializing_if = "Option::is_none", with = "crate::json::finite3_pair_option")]
    pub positions: Option<[[f32; 3]; 2]>,
}

impl SplitVertex {
    fn found(&self, mesh: &Mesh) -> Result<(VertexId, [EdgeId; 2]), Problem> {
        let vertex = one(self.vertex, "vertex")?.find(mesh, "vertex")?;
        Ok((vertex, pair(&self.edges, "edges", |e, field| e.find(mesh, field))?))
    }

    fn targets(&self) -> Option<[Vec3; 2]> {
        self.positions.map(|pair| pair.map(Vec3::from))
    }
}

impl Operation for SplitVertex {
    const SPEC: Spec = Spec {
        name: "split-vertex",
        label: "Split vertex",
        description: "Makes a vertex two, joined by an edge.",
        key: None,
        kind: OperationKind::Local,
        fields: &[
            Field::new("vertex", FieldKind::Vertex, "The vertex to split").or("where the two edges meet"),
            Field::new("edges", FieldKind::Edges, "Two of its edges").or("the two selected edges"),
            Field::new("positions", FieldKind::VectorPair, "Where the two vertices go").or("a little apart"),
        ],
    };

    fields_by_serde!();

    fn resolve(mut self, target: &Target<'_>) -> Result<Vec<Self>, Problem> {
        if self.edges.is_none() {
            self.edges = Some(target.two(Element::Edge, "edges")?.map(EdgeRef::Id));
        }
        if self.vertex.is_none() {
            let mesh = target.mesh;
            let [a, b] = pair(&self.edges, "edges", |e, field| e.find(mesh, field))?.map(|e| mesh.ends(e));
            let shared = a.into_iter().find(|v| b.contains(v));
            let shared = shared
                .ok_or_else(|| Problem::field("vertex", "is missing, and the two edges don't meet at one"))?;
            self.vertex = Some(shared.into());
        }
        Ok(vec![self])
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for SplitVertex {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        let (vertex, edges) = self.found(mesh)?;
        Ok(edit::can_split_vertex(mesh, vertex, edges, self.targets())?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        let (vertex, edges) = self.found(mesh)?;
        edit::split_vertex(mesh, vertex, edges, self.targets())?;
        Ok(())
    }
}
