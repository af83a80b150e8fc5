//! `set-crease`: how sharp edges and vertices stay.

use super::fields::{edges, vertices};
use super::{
    Action, EdgeRef, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target, VertexRef,
};
use crate::error::Problem;
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Says how sharp edges and vertices stay under subdivision.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SetCrease {
    /// Edges. If no elements are given at all, the selected edges or vertices are meant.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edges: Option<Vec<EdgeRef>>,
    /// Vertices.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vertices: Option<Vec<VertexRef>>,
    /// 0 is smooth; 10 or more is infinitely sharp.
    #[serde(with = "crate::json::finite")]
    pub sharpness: f32,
}

impl Operation for SetCrease {
    const SPEC: Spec = Spec {
        name: "set-crease",
        label: "Set crease",
        description: "Says how sharp edges and vertices stay under subdivision.",
        key: None,
        kind: OperationKind::Local,
        fields: &[
            Field::new("edges", FieldKind::Edges, "Edges to make sharp").or("the selection"),
            Field::new("vertices", FieldKind::Vertices, "Vertices to make sharp").or("the selection"),
            Field::new(
                "sharpness",
                FieldKind::Number { min: 0.0, max: 10.0 },
                "0 is smooth, 10 infinitely sharp",
            ),
        ],
    };

    fields_by_serde!();

    fn resolve(mut self, target: &Target<'_>) -> Result<Vec<Self>, Problem> {
        if self.edges.is_none() && self.vertices.is_none() {
            match target.has_selected(Element::Vertex) {
                true => target.fill_vertices(&mut self.vertices, "vertices")?,
                false => target.fill_edges(&mut self.edges, "edges")?,
            }
        }
        Ok(vec![self])
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for SetCrease {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        let (edges, vertices) = (edges(&self.edges, mesh)?, vertices(&self.vertices, mesh)?);
        Ok(edit::can_set_crease(mesh, &edges, &vertices, self.sharpness)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        let (edges, vertices) = (edges(&self.edges, mesh)?, vertices(&self.vertices, mesh)?);
        edit::set_crease(mesh, &edges, &vertices, self.sharpness)?;
        Ok(())
    }

    fn cost(&self, _mesh: &Mesh) -> usize {
        (self.edges.as_ref().map_or(0, Vec::len) + self.vertices.as_ref().map_or(0, Vec::len)) / 16
    }
}
