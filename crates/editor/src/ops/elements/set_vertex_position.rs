//! `set-vertex-position`: move one vertex to a position.

use crate::error::Problem;
use crate::ops::refs::one;
use crate::ops::{
    Action, Field, FieldKind, LocalEdit, Mirroring, Operation, SYMMETRY, Scope, Selected, Slot, Spec,
    VertexRef,
};
use halfedge::{Element, Mesh};
use serde::{Deserialize, Serialize};

/// Move one vertex to a position.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SetVertexPosition {
    /// The vertex; the selected one when left out.
    pub vertex: Option<VertexRef>,
    /// The new position, in mesh units.
    #[serde(with = "crate::script::json::finite3")]
    pub position: [f32; 3],
}

impl Operation for SetVertexPosition {
    const SPEC: Spec =
        Spec::new(Scope::Elements, "set-vertex-position", "Move vertex", "Move a vertex to a position.")
            .fields(&[
                Field::one("vertex", Element::Vertex, Selected::Only, "The vertex to move"),
                Field::required("position", FieldKind::Vector, "The new position, in mesh units"),
                SYMMETRY,
            ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Vertex(&mut self.vertex)]
    }

    const MIRRORING: Mirroring = Mirroring::Moves;

    fn pair(&mut self, _image: Self, _mesh: &Mesh) -> Option<Self> {
        None
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for SetVertexPosition {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        one(self.vertex, "vertex", mesh).map(drop)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        let v = one(self.vertex, "vertex", mesh)?;
        mesh.set_position(v, self.position.into());
        Ok(())
    }

    fn cost(&self, _mesh: &Mesh) -> usize {
        1
    }
}
