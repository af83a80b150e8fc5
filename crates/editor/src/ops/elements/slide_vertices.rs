//! `slide-vertices`: move vertices along their edges.

use super::sized::{nothing_moved, slide_amount};
use crate::error::Problem;
use crate::ops::refs::{all, count};
use crate::ops::{
    Action, DefaultValue, Family, Field, FieldKind, LocalEdit, Mirroring, Operation, Reflection, SYMMETRY,
    Scope, Selected, Slot, Spec, VertexRef,
};
use crate::script::json::finite3;
use halfedge::edit::Refusal;
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Slide vertices along their edges.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SlideVertices {
    /// The vertices; the selected ones when left out.
    pub vertices: Option<Vec<VertexRef>>,
    /// Each vertex takes the one of its edges that points most in this direction; its length doesn't matter.
    #[serde(with = "finite3")]
    pub direction: [f32; 3],
    /// How far they go: 1 is to the edges' other ends. Below 0 they go the other way.
    #[serde(with = "crate::script::json::finite")]
    pub amount: f32,
}

impl Operation for SlideVertices {
    const SPEC: Spec = Spec::new(
        Scope::Elements,
        "slide-vertices",
        "Slide vertices",
        "Move each vertex along the one of its edges that points most in a direction.",
    )
    .synonyms(&["vertex slide", "vert slide"])
    .family(Family::Slide)
    .fields(&[
        Field::many("vertices", Element::Vertex, Selected::All, "The vertices to slide"),
        Field::required(
            "direction",
            FieldKind::Vector,
            "Each vertex moves along the edge that points most in this direction",
        )
        .or(DefaultValue::Vector([1.0, 0.0, 0.0])),
        slide_amount("How far: 1 is to the edges' other ends; below 0 is the other way"),
        SYMMETRY,
    ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Vertices(&mut self.vertices)]
    }

    const MIRRORING: Mirroring = Mirroring::Moves;

    fn reflect(&mut self, reflection: Reflection) {
        self.direction = reflection.vector(self.direction);
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

/// A refusal that names the field it is about.
fn problem(refusal: Refusal) -> Problem {
    match refusal {
        Refusal::NoDirection => Problem::of_field("direction", "is too short to give a direction")
            .advise("The direction is too short. Give one with a length."),
        other => other.into(),
    }
}

impl LocalEdit for SlideVertices {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        let vertices = all(&self.vertices, "vertices", mesh)?;
        edit::can_slide_vertices(mesh, &vertices, self.direction.into(), self.amount).map_err(problem)
    }

    fn edit(&self, mesh: &mut Mesh, notes: &mut Vec<String>) -> Result<(), Problem> {
        let vertices = all(&self.vertices, "vertices", mesh)?;
        let moved =
            edit::slide_vertices(mesh, &vertices, self.direction.into(), self.amount).map_err(problem)?;
        notes.extend(nothing_moved(moved, self.amount, "no edge points that way"));
        Ok(())
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        count(&self.vertices, mesh.vertex_count())
    }
}
