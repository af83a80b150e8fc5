//! `loop-cut`: cut along a ring of quads.

use crate::error::Problem;
use crate::ops::refs::{given, one};
use crate::ops::{
    Action, DefaultValue, Drag, EdgeRef, Field, LocalEdit, Operation, Reflection, SYMMETRY, Scope, Selected,
    Slot, Spec, Unit, edges_between_created,
};
use crate::outcome::ElementIds;
use crate::selection::Selection;
use halfedge::geometry::BitSet;
use halfedge::{EdgeId, Element, Mesh, VertexId, edit};
use serde::{Deserialize, Serialize};

/// Cut the ring of quads that crosses an edge. Several edges of one ring cut it once.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LoopCut {
    /// The edge; each selected one in turn when left out.
    pub edge: Option<EdgeRef>,
    /// How many cuts.
    pub cuts: u32,
    /// Where the middle of the cuts is along the edge's even half-edge, or from the vertex named first, between 0 and 1.
    #[serde(with = "crate::script::json::finite")]
    pub t: f32,
}

impl Operation for LoopCut {
    const SPEC: Spec =
        Spec::new(Scope::Elements, "loop-cut", "Loop cut", "Cut the ring of quads that crosses an edge.")
            .synonyms(&["insert edge loop", "ring cut"])
            .fields(&[
                Field::one("edge", Element::Edge, Selected::Each, "An edge that the ring crosses"),
                Field::count("cuts", edit::LOOP_CUTS_RANGE, "How many cuts").or(DefaultValue::Integer(1)),
                Field::number(
                    "t",
                    Unit::Fraction,
                    edit::SPLIT_T_RANGE,
                    "The position of the middle of the cuts along the edge",
                )
                .labelled("Position (0 to 1)")
                .or(DefaultValue::Number(0.5))
                .drag(Drag::Fraction),
                SYMMETRY,
            ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Edge(&mut self.edge)]
    }

    fn from_selection(ops: Vec<Self>, mesh: &Mesh) -> Result<Vec<Self>, Problem> {
        let mut cut: BitSet = BitSet::new();
        let is_new = |op: &Self| {
            let Ok(edge) = one(op.edge, "edge", mesh) else { return true };
            if cut.contains(edge.index()) {
                return false;
            }
            for h in edit::edge_ring(mesh, edge).0 {
                cut.insert(h.edge().index());
            }
            true
        };
        Ok(ops.into_iter().filter(is_new).collect())
    }

    fn reflect(&mut self, reflection: Reflection) {
        self.t = reflection.along(self.t);
    }

    fn pair(&mut self, image: Self, mesh: &Mesh) -> Option<Self> {
        let ring = one(self.edge, "edge", mesh).map(|edge| edit::edge_ring(mesh, edge).0).unwrap_or_default();
        // The place along the ring's direction.
        let along = |op: &Self| {
            let (edge, t) = op.edge?.find_along(op.t, mesh, "edge").ok()?;
            let h = ring.iter().find(|h| h.edge() == edge)?;
            Some(if *h == edge.halfedge() { t } else { 1.0 - t })
        };
        let [Some(own), Some(other)] = [along(self), along(&image)] else { return Some(image) };
        // One ring crosses both edges. Cuts that are not in its middle are mirror images of themselves only if the image's
        // amount is along the same side of the ring.
        if (own - other).abs() > f32::EPSILON {
            self.t = 0.5;
        }
        None
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for LoopCut {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        let (edge, t) = given(self.edge, "edge")?.find_along(self.t, mesh, "edge")?;
        Ok(edit::can_loop_cut(mesh, edge, self.cuts, t)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        let (edge, t) = given(self.edge, "edge")?.find_along(self.t, mesh, "edge")?;
        edit::loop_cut(mesh, edge, self.cuts, t)?;
        Ok(())
    }

    fn selects(&self, mesh: &Mesh, created: &ElementIds) -> Option<Selection> {
        // The new vertices are numbered edge by edge of the ring, `cuts` on each. The edges between those of one edge
        // are its pieces, not cuts; of the vertices where a ring crosses itself, none is beside an old one.
        let number = |v: VertexId| created.vertices.binary_search(&v.raw()).ok();
        let group = |v: VertexId| number(v).map(|at| at / self.cuts.max(1) as usize);
        let first = |group: usize| mesh.vertex(*created.vertices.get(group * self.cuts as usize)?);
        let is_beside_old = |v| mesh.outgoing(v).any(|h| number(mesh.to(h)).is_none());
        let is_piece = |edge: &EdgeId| {
            let [a, b] = mesh.ends(*edge).map(group);
            a == b && a.and_then(first).is_some_and(is_beside_old)
        };
        let edges = edges_between_created(mesh, created).into_iter().filter(|edge| !is_piece(edge));
        Some(Selection::of(Element::Edge, edges.map(EdgeId::raw)))
    }

    fn cuts_faces(&self) -> bool {
        true
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        let ring = one(self.edge, "edge", mesh).map_or(0, |edge| edit::edge_ring(mesh, edge).0.len());
        ring.saturating_mul(self.cuts as usize)
    }
}
