//! `bevel-vertices`: vertices cut off with a face each.

use super::fields::vertices;
use super::live::{not_negative, slide};
use super::{Action, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target, VertexRef};
use crate::error::Problem;
use halfedge::{Mesh, edit};
use serde::{Deserialize, Serialize};

/// Cuts off vertices with a face each.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BevelVertices {
    /// The vertices; the selected ones if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vertices: Option<Vec<VertexRef>>,
    /// How far along each edge the cut is, in mesh units, 0 or more.
    #[serde(with = "crate::json::finite")]
    pub width: f32,
}

impl Operation for BevelVertices {
    const SPEC: Spec = Spec {
        name: "bevel-vertices",
        label: "Bevel vertices",
        description: "Cuts off vertices with a face each.",
        key: None,
        kind: OperationKind::Local,
        fields: &[
            Field::new("vertices", FieldKind::Vertices, "The vertices to bevel").or("the selected vertices"),
            Field::new(
                "width",
                FieldKind::Number { min: 0.0, max: f32::MAX },
                "How far along each edge, in mesh units",
            ),
        ],
    };

    fields_by_serde!();

    fn resolve(mut self, target: &Target<'_>) -> Result<Vec<Self>, Problem> {
        target.fill_vertices(&mut self.vertices, "vertices")?;
        Ok(vec![self])
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for BevelVertices {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        not_negative(self.width, "width")?;
        Ok(edit::can_bevel_vertices(mesh, &vertices(&self.vertices, mesh)?)?)
    }

    fn edit(&self, mesh: &mut Mesh, notes: &mut Vec<String>) -> Result<(), Problem> {
        not_negative(self.width, "width")?;
        let live = edit::bevel_vertices(mesh, &vertices(&self.vertices, mesh)?)?;
        slide(mesh, &live, self.width, "width", notes)
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        self.vertices.as_ref().map_or(mesh.vertex_count(), Vec::len)
    }
}
