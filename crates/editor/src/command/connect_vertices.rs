//! `connect-vertices`: a face cut between two corners.

use super::fields::pair;
use super::{Action, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target, VertexRef};
use crate::error::Problem;
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Cuts a face from one of its corners to another.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ConnectVertices {
    /// Two corners of one face; the two selected vertices if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vertices: Option<[VertexRef; 2]>,
}

impl Operation for ConnectVertices {
    const SPEC: Spec = Spec {
        name: "connect-vertices",
        label: "Connect vertices",
        description: "Cuts a face from one of its corners to another.",
        key: None,
        kind: OperationKind::Local,
        fields: &[Field::new("vertices", FieldKind::Vertices, "Two corners of one face")
            .or("the two selected vertices")],
    };

    fields_by_serde!();

    fn resolve(mut self, target: &Target<'_>) -> Result<Vec<Self>, Problem> {
        if self.vertices.is_none() {
            self.vertices = Some(target.two(Element::Vertex, "vertices")?.map(VertexRef));
        }
        Ok(vec![self])
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for ConnectVertices {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        let [a, b] = pair(&self.vertices, "vertices", |v, field| v.find(mesh, field))?;
        Ok(edit::can_connect_vertices(mesh, a, b)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        let [a, b] = pair(&self.vertices, "vertices", |v, field| v.find(mesh, field))?;
        edit::connect_vertices(mesh, a, b)?;
        Ok(())
    }
}
