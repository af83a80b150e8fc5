//! `split-edge`: add a vertex to an edge, and cut from it.

use crate::error::Problem;
use crate::ops::choice::choice;
use crate::ops::refs::given;
use crate::ops::{
    Action, DefaultValue, Drag, EdgeRef, Field, LocalEdit, Operation, Reflection, SYMMETRY, Scope, Selected,
    Slot, Spec, Unit,
};
use crate::outcome::ElementIds;
use crate::selection::Selection;
use halfedge::{EdgeId, Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Add a vertex to an edge and cut the faces beside it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SplitEdge {
    /// The edge; each selected one in turn when left out.
    pub edge: Option<EdgeRef>,
    /// Where the vertex is along the edge's even half-edge, between 0 and 1.
    #[serde(with = "crate::script::json::finite")]
    pub t: f32,
    /// Which faces beside the edge are cut.
    pub connect: Connect,
}

choice! {
    /// Which faces beside a split edge are cut from the new vertex.
    pub enum Connect {
        /// Triangles, to their opposite corner.
        Triangles = "triangles" "Split triangles too",
        /// None: both faces gain a corner.
        None = "none" "Add a vertex only",
        /// All, to the corner halfway round.
        All = "all" "Split both faces",
    }
}

impl Operation for SplitEdge {
    const SPEC: Spec = Spec::new(
        Scope::Elements,
        "split-edge",
        "Split edge",
        "Add a vertex to an edge and cut the faces beside it.",
    )
    .synonyms(&["add vertex", "insert vertex"])
    .fields(&[
        Field::one("edge", Element::Edge, Selected::Each, "The edge to split"),
        Field::number(
            "t",
            Unit::Fraction,
            edit::SPLIT_T_RANGE,
            "The position along the edge, between its ends",
        )
        .labelled("Position (0 to 1)")
        .or(DefaultValue::Number(0.5))
        .drag(Drag::Fraction),
        Connect::field("connect", "Which of the faces beside the edge are cut"),
        SYMMETRY,
    ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Edge(&mut self.edge)]
    }

    fn reflect(&mut self, reflection: Reflection) {
        self.t = reflection.along(self.t);
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl From<Connect> for edit::Connect {
    fn from(connect: Connect) -> Self {
        match connect {
            Connect::None => Self::None,
            Connect::Triangles => Self::Triangles,
            Connect::All => Self::All,
        }
    }
}

impl LocalEdit for SplitEdge {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        let (edge, t) = given(self.edge, "edge")?.find_along(self.t, mesh, "edge")?;
        Ok(edit::can_split_edge(mesh, edge, t, self.connect.into())?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        let (edge, t) = given(self.edge, "edge")?.find_along(self.t, mesh, "edge")?;
        edit::split_edge(mesh, edge, t, self.connect.into())?;
        Ok(())
    }

    fn selects(&self, mesh: &Mesh, created: &ElementIds) -> Option<Selection> {
        // Both halves. At a new vertex, the half that keeps the edge's id is the only old edge, and of the new ones, which
        // are numbered in the order in which they are made, the other half comes first.
        let is_new = |edge: &EdgeId| created.edges.binary_search(&edge.raw()).is_ok();
        let halves = created.vertices.iter().filter_map(|&id| mesh.vertex(id)).flat_map(|v| {
            let (new, mut halves): (Vec<_>, Vec<_>) = mesh.vertex_edges(v).partition(is_new);
            halves.extend(new.into_iter().min());
            halves
        });
        Some(Selection::of(Element::Edge, halves.map(EdgeId::raw)))
    }

    fn cost(&self, _mesh: &Mesh) -> usize {
        2
    }
}
