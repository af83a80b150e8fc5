//! `split-edge`: add a vertex to an edge, and cut from it.

use crate::error::Problem;
use crate::ops::choice::choice;
use crate::ops::refs::{given, one};
use crate::ops::{
    Action, DefaultValue, Drag, EdgeRef, Field, LocalEdit, Operation, Reflection, SYMMETRY, Scope, Selected,
    Slot, Spec, Unit,
};
use crate::outcome::ElementIds;
use crate::selection::Selection;
use halfedge::edit::Refusal;
use halfedge::{EdgeId, Element, FaceId, Mesh, VertexId, edit};
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
    /// The mirror image of the edge and of the place, where both edges are sides of one face.
    #[serde(skip)]
    image: Option<(EdgeRef, f32)>,
}

impl SplitEdge {
    /// Splits each selected edge there.
    pub fn at(t: f32, connect: Connect) -> Self {
        Self { edge: None, t, connect, image: None }
    }
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

    fn pair(&mut self, image: Self, mesh: &Mesh) -> Option<Self> {
        let [Ok(own), Ok(other)] = [&*self, &image].map(|op| one(op.edge, "edge", mesh)) else {
            return Some(image);
        };
        let faces = |edge: EdgeId| edge.halfedges().map(|h| mesh.face_of(h));
        let shares = faces(own).iter().any(|face| face.is_some() && faces(other).contains(face));
        if !shares {
            return Some(image);
        }
        self.image = image.edge.map(|edge| (edge, image.t));
        None
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

/// Splits two edges that are mirror images and sides of one face. A face between the two new vertices is cut from one to the
/// other: from each to a corner of its own, one cut would meet the other.
fn split_both(
    mesh: &mut Mesh,
    [(own, t), (other, other_t)]: [(EdgeId, f32); 2],
    connect: Connect,
) -> Result<(), Refusal> {
    let faces = |edge: EdgeId| edge.halfedges().map(|h| mesh.face_of(h));
    let shared: Vec<FaceId> =
        faces(own).into_iter().flatten().filter(|face| faces(other).contains(&Some(*face))).collect();
    let is_cut = |face: &FaceId| match connect {
        Connect::None => false,
        Connect::Triangles => mesh.face_degree(*face) == 3,
        Connect::All => true,
    };
    let cut = shared.iter().filter(|face| is_cut(face)).count();
    // Where the cuts beside the shared faces go.
    let corners = |edge: EdgeId| -> Vec<VertexId> {
        let sides = edge.halfedges().into_iter();
        let sides = sides.filter_map(|h| Some((h, mesh.face_of(h).filter(|face| !shared.contains(face))?)));
        sides
            .filter(|(_, face)| is_cut(face))
            .map(|(h, face)| {
                let steps = mesh.face_degree(face).div_ceil(2) - 1;
                mesh.from((0..steps).fold(mesh.next(h), |h, _| mesh.next(h)))
            })
            .collect()
    };
    let corners = [corners(own), corners(other)];
    let mut made = Vec::new();
    for ((edge, t), corners) in [(own, t), (other, other_t)].into_iter().zip(corners) {
        let vertex = edit::split_edge(mesh, edge, t, edit::Connect::None)?.vertex;
        for corner in corners {
            edit::connect_vertices(mesh, vertex, corner)?;
        }
        made.push(vertex);
    }
    if let (1.., &[a, b]) = (cut, made.as_slice()) {
        edit::connect_vertices(mesh, a, b)?;
    }
    Ok(())
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
        let own = given(self.edge, "edge")?.find_along(self.t, mesh, "edge")?;
        if let Some((image, t)) = self.image {
            split_both(mesh, [own, image.find_along(t, mesh, "edge")?], self.connect)?;
        } else {
            edit::split_edge(mesh, own.0, own.1, self.connect.into())?;
        }
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

    fn cuts_faces(&self) -> bool {
        true
    }

    fn cost(&self, _mesh: &Mesh) -> usize {
        2
    }
}
