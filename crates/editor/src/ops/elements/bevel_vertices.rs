//! `bevel-vertices`: cut off each vertex with a face.

use super::sized::set_size;
use crate::error::Problem;
use crate::ops::refs::{all, count};
use crate::ops::{
    Action, Drag, Family, Field, LocalEdit, Operation, SYMMETRY, Scope, Selected, Slot, Spec, Unit, VertexRef,
};
use crate::outcome::ElementIds;
use crate::selection::Selection;
use halfedge::{Element, Mesh, NumberRange, edit};
use serde::{Deserialize, Serialize};

/// Cut off each vertex with a face.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BevelVertices {
    /// The vertices; the selected ones when left out.
    pub vertices: Option<Vec<VertexRef>>,
    /// How far along each edge the cut is, in mesh units, 0 or more.
    #[serde(with = "crate::script::json::finite")]
    pub width: f32,
}

impl Operation for BevelVertices {
    const SPEC: Spec =
        Spec::new(Scope::Elements, "bevel-vertices", "Bevel vertices", "Cut off each vertex with a face.")
            .synonyms(&["chamfer", "cut corner"])
            .family(Family::Bevel)
            .fields(&[
                Field::many("vertices", Element::Vertex, Selected::All, "The vertices to bevel"),
                Field::number(
                    "width",
                    Unit::Length,
                    NumberRange::NOT_NEGATIVE,
                    "How far along each edge, in mesh units",
                )
                .drag(Drag::Width),
                SYMMETRY,
            ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Vertices(&mut self.vertices)]
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for BevelVertices {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_bevel_vertices(mesh, &all(&self.vertices, "vertices", mesh)?)?)
    }

    fn edit(&self, mesh: &mut Mesh, notes: &mut Vec<String>) -> Result<(), Problem> {
        let live = edit::bevel_vertices(mesh, &all(&self.vertices, "vertices", mesh)?)?;
        set_size(mesh, &live, self.width, "width", notes)
    }

    fn selects(&self, _mesh: &Mesh, created: &ElementIds) -> Option<Selection> {
        Some(Selection::of(Element::Face, created.faces.iter().copied()))
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        count(&self.vertices, mesh.vertex_count())
    }
}
