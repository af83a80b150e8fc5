//! `merge-vertices`: merge several vertices into one.

use crate::error::Problem;
use crate::ops::refs::{all, count};
use crate::ops::{
    Action, Field, FieldKind, LocalEdit, Mirroring, Operation, Reflection, SYMMETRY, Scope, Selected, Slot,
    Spec, VertexRef,
};
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Merge several vertices into one.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct MergeVertices {
    /// The vertices; those of the selected elements when left out.
    pub vertices: Option<Vec<VertexRef>>,
    /// Where the vertex goes; the mean of the vertices when left out.
    #[serde(default, with = "crate::script::json::finite3_option")]
    pub position: Option<[f32; 3]>,
}

impl Operation for MergeVertices {
    const SPEC: Spec =
        Spec::new(Scope::Elements, "merge-vertices", "Merge vertices", "Merge several vertices into one.")
            .synonyms(&["weld", "merge at centre"])
            .fields(&[
                Field::many("vertices", Element::Vertex, Selected::Vertices, "The vertices to merge"),
                Field::required("position", FieldKind::Vector, "The position of the merged vertex")
                    .unset("the centre of the vertices"),
                SYMMETRY,
            ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Vertices(&mut self.vertices)]
    }

    const MIRRORING: Mirroring = Mirroring::Apart;

    fn reflect(&mut self, reflection: Reflection) {
        self.position = self.position.map(|position| reflection.vector(position));
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for MergeVertices {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        let vertices = all(&self.vertices, "vertices", mesh)?;
        Ok(edit::can_merge_vertices(mesh, &vertices, self.position.map(Into::into))?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        let vertices = all(&self.vertices, "vertices", mesh)?;
        edit::merge_vertices(mesh, &vertices, self.position.map(Into::into))?;
        Ok(())
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        count(&self.vertices, mesh.vertex_count())
    }
}
