//! `extrude-edges`: add quads beside boundary edges.

use super::sized::set_size;
use crate::error::Problem;
use crate::ops::refs::{ElementRef, all, count};
use crate::ops::{
    Action, Drag, EdgeRef, Family, Field, FieldKind, LocalEdit, Mirror, Operation, SYMMETRY, Scope, Selected,
    Slot, Spec, edges_between_created,
};
use crate::outcome::ElementIds;
use crate::selection::Selection;
use glam::Vec3;
use halfedge::{EdgeId, Element, Mesh, VertexId, edit};
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use surface::mirrored;

/// Add a quad beside each of some boundary edges.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ExtrudeEdges {
    /// The boundary edges; the selected ones when left out.
    pub edges: Option<Vec<EdgeRef>>,
    /// From the edges to the far sides of the quads, in mesh units.
    #[serde(with = "crate::script::json::finite3")]
    pub offset: [f32; 3],
}

impl Operation for ExtrudeEdges {
    const SPEC: Spec =
        Spec::new(Scope::Elements, "extrude-edges", "Extrude edges", "Add a quad beside each boundary edge.")
            .family(Family::Extrude)
            .fields(&[
                Field::many("edges", Element::Edge, Selected::All, "The boundary edges to extrude"),
                Field::required(
                    "offset",
                    FieldKind::Vector,
                    "From the edges to the far sides, in mesh units",
                )
                .drag(Drag::Offset),
                SYMMETRY,
            ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Edges(&mut self.edges)]
    }

    fn from_selection(mut ops: Vec<Self>, mesh: &Mesh) -> Result<Vec<Self>, Problem> {
        // Of a selection that reaches into the surface, the edges on the boundary are extruded.
        for edges in ops.iter_mut().filter_map(|op| op.edges.as_mut()) {
            let is_boundary =
                |edge: &EdgeRef| edge.find(mesh, "edges").is_ok_and(|e| mesh.is_boundary_edge(e));
            if edges.iter().any(is_boundary) {
                edges.retain(is_boundary);
            }
        }
        Ok(ops)
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for ExtrudeEdges {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_extrude_edges(mesh, &all(&self.edges, "edges", mesh)?)?)
    }

    fn edit(&self, mesh: &mut Mesh, notes: &mut Vec<String>) -> Result<(), Problem> {
        let live = edit::extrude_edges(mesh, &all(&self.edges, "edges", mesh)?, self.offset.into())?;
        set_size(mesh, &live, 1.0, "offset", notes)
    }

    fn edit_mirrored(
        &self,
        mesh: &mut Mesh,
        mirror: &Mirror<'_>,
        notes: &mut Vec<String>,
    ) -> Result<(), Problem> {
        let edges = all(&self.edges, "edges", mesh)?;
        let ends = |edges: &[EdgeId]| edges.iter().flat_map(|edge| mesh.ends(*edge)).collect::<Vec<_>>();
        let mut own = ends(edges.get(..mirror.own).unwrap_or(&edges));
        own.sort_unstable();
        let is_own = |v: VertexId| own.binary_search(&v).is_ok();
        let bits = |at: Vec3| at.to_array().map(f32::to_bits);
        let axis = mirror.images.axis();
        let offset = Vec3::from(self.offset);
        // How far the copy of the vertex at each place moves. The image of a given vertex follows it; of two given ones, that
        // on the positive side leads.
        let mut by: HashMap<[u32; 3], Vec3> = HashMap::new();
        for v in ends(&edges) {
            let at = mesh.position(v);
            let is_positive = at.to_array().get(axis).is_some_and(|at| *at > 0.0);
            let image = mirror.images.vertex(v);
            let moves = match image {
                Some(image) if image == v => (offset + mirrored(offset, axis)) * 0.5,
                Some(image) if !is_own(v) || (is_own(image) && !is_positive) => mirrored(offset, axis),
                _ => offset,
            };
            by.insert(bits(at), moves);
        }
        let mut live = edit::extrude_edges(mesh, &edges, offset)?;
        for moved in &mut live.slide.vertices {
            moved.by = by.get(&bits(moved.from)).copied().unwrap_or(moved.by);
        }
        set_size(mesh, &live, 1.0, "offset", notes)
    }

    fn selects(&self, mesh: &Mesh, created: &ElementIds) -> Option<Selection> {
        // The far sides: the edges beside the quads have an old end.
        let far = edges_between_created(mesh, created);
        Some(Selection::of(Element::Edge, far.into_iter().map(EdgeId::raw)))
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        count(&self.edges, mesh.edge_count())
    }
}
