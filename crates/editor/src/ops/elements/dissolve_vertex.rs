//! `dissolve-vertex`: remove vertices and merge their faces.

use crate::error::Problem;
use crate::ops::refs::{all, count, one};
use crate::ops::{
    Action, Family, Field, LocalEdit, Operation, SYMMETRY, Scope, Selected, Slot, Spec, VertexRef,
};
use halfedge::edit::{self, Refusal};
use halfedge::{Element, Mesh, VertexId};
use serde::{Deserialize, Serialize};

/// Remove vertices and merge the faces around each into one polygon.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct DissolveVertex {
    /// One vertex.
    pub vertex: Option<VertexRef>,
    /// Several vertices, each in turn; the selected ones when both are left out.
    pub vertices: Option<Vec<VertexRef>>,
}

impl DissolveVertex {
    fn find(&self, mesh: &Mesh) -> Result<Vec<VertexId>, Problem> {
        let mut vertices = all(&self.vertices, "vertices", mesh)?;
        if self.vertex.is_some() || self.vertices.is_none() {
            vertices.push(one(self.vertex, "vertex", mesh)?);
        }
        if vertices.is_empty() { Err(Refusal::NothingGiven(Element::Vertex).into()) } else { Ok(vertices) }
    }
}

impl Operation for DissolveVertex {
    const SPEC: Spec = Spec::new(
        Scope::Elements,
        "dissolve-vertex",
        "Dissolve vertex",
        "Remove vertices and merge the faces around each into one polygon.",
    )
    .synonyms(&["remove vertex"])
    .family(Family::Dissolve)
    .fields(&[
        Field::one("vertex", Element::Vertex, Selected::Each, "The vertex to dissolve")
            .optional("those of `vertices`"),
        Field::many(
            "vertices",
            Element::Vertex,
            Selected::All,
            "The vertices to dissolve, one after the other",
        ),
        SYMMETRY,
    ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Vertex(&mut self.vertex), Slot::Vertices(&mut self.vertices)]
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for DissolveVertex {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        let refused = match self.find(mesh)?.as_slice() {
            &[vertex] => edit::can_dissolve_vertex(mesh, vertex),
            vertices => edit::can_dissolve_around(mesh, vertices),
        };
        Ok(refused?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        let vertices = self.find(mesh)?;
        if let &[vertex] = vertices.as_slice() {
            edit::dissolve_vertex(mesh, vertex)?;
            return Ok(());
        }
        edit::dissolve_around(mesh, &vertices)?;
        for vertex in vertices {
            if mesh.has_vertex(vertex) {
                edit::dissolve_vertex(mesh, vertex).map_err(|refusal| {
                    Problem::new(format!("{vertex} can't be dissolved, because {refusal}"))
                })?;
            }
        }
        Ok(())
    }

    fn cost(&self, _mesh: &Mesh) -> usize {
        count(&self.vertices, 1)
    }
}
