//! What a slide goes along: the ways of the vertex that is nearest to the pointer when it starts.

use editor::{Editor, OpId};
use egui::Pos2;
use glam::{Vec2, Vec3};
use halfedge::edit::{Rail, Refusal, best_way, edge_rails};
use halfedge::{EdgeId, Element, HalfedgeId, Mesh, VertexId};

use super::pointer::Sight;
use crate::view::View;

/// The vertex that the pointer leads, and where it can go.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Track {
    /// Where the vertex is.
    pub at: Vec3,
    ways: Ways,
    /// The lines along which the vertices slide, to draw.
    pub rails: Vec<[Vec3; 2]>,
}

/// The most rails that are drawn.
const MAX_RAILS: usize = 2000;

#[derive(Clone, Debug, PartialEq)]
enum Ways {
    /// To the left and to the right; zero where there is nothing to slide along.
    Sides([Vec3; 2]),
    /// Along each edge.
    Edges(Vec<Vec3>),
}

impl Track {
    /// The track of a slide of the selection; none for another operation, or if nothing suitable is selected. Costs a pass
    /// over the selected elements.
    ///
    /// # Errors
    /// If the selected edges can't slide.
    pub fn of_selection(
        editor: &Editor,
        id: OpId,
        view: &View,
        pointer: Option<Pos2>,
    ) -> Result<Option<Self>, Refusal> {
        let Some(mesh) = editor.mesh() else { return Ok(None) };
        let pointer = pointer.map_or(view.size() / 2.0, |at| view.local(at));
        let distance = |v: VertexId| {
            let place = view.camera.project(mesh.position(v), view.size());
            place.map_or(f32::INFINITY, |place| place.distance_squared(pointer))
        };
        let nearest = |vertices: &mut dyn Iterator<Item = VertexId>| {
            vertices.min_by(|a, b| distance(*a).total_cmp(&distance(*b)))
        };
        let selection = editor.selection();
        let mut lines = Vec::new();
        let (vertex, ways) = match id {
            OpId::SlideEdges => {
                let rails = edge_rails(mesh, &selected_edges(editor, mesh))?;
                let Some(v) = nearest(&mut rails.iter().flatten().map(|rail| rail.vertex)) else {
                    return Ok(None);
                };
                let line = |rail: &Rail| [mesh.position(rail.vertex), rail.to];
                lines.extend(rails.iter().flatten().take(MAX_RAILS).map(line));
                let way = |side: &Vec<Rail>| {
                    let rail = side.iter().find(|rail| rail.vertex == v);
                    rail.map_or(Vec3::ZERO, |rail| rail.to - mesh.position(v))
                };
                (v, Ways::Sides(rails.each_ref().map(way)))
            }
            OpId::SlideVertices if selection.kind() == Element::Vertex => {
                let Some(v) = nearest(&mut selection.ids().filter_map(|id| mesh.vertex(id))) else {
                    return Ok(None);
                };
                let ends =
                    |v: VertexId| mesh.neighbors(v).map(move |to| [mesh.position(v), mesh.position(to)]);
                let all = selection.ids().filter_map(|id| mesh.vertex(id)).flat_map(ends);
                lines.extend(all.take(MAX_RAILS));
                (v, Ways::Edges(mesh.neighbors(v).map(|to| mesh.position(to) - mesh.position(v)).collect()))
            }
            _ => return Ok(None),
        };
        Ok(Some(Self { at: mesh.position(vertex), ways, rails: lines }))
    }

    /// The direction that a slide of vertices has before the pointer moves.
    pub fn first_way(&self) -> Vec3 {
        match &self.ways {
            Ways::Sides(_) => Vec3::ZERO,
            Ways::Edges(edges) => edges.first().copied().unwrap_or_default(),
        }
    }

    /// The amount for a movement of the pointer, and for vertices the direction of the movement.
    pub fn amount(&self, sight: Sight<'_>, by: Vec2) -> (f32, Option<Vec3>) {
        match &self.ways {
            Ways::Sides(sides) => {
                let along = |way: Vec3| (way != Vec3::ZERO).then(|| sight.fraction(way, by));
                let amount = match sides.map(along) {
                    // Both point at the viewer: up and to the right is left.
                    [Some(left), Some(right)] if left == right => left,
                    [Some(left), Some(right)] if left < right => -right.max(0.0),
                    [Some(left), _] => left.max(0.0),
                    [None, Some(right)] => -right.max(0.0),
                    [None, None] => 0.0,
                };
                (amount, None)
            }
            Ways::Edges(edges) => {
                let direction =
                    (sight.camera.drag(sight.anchor, by, sight.size) - sight.anchor).normalize_or_zero();
                let ways = edges.iter().enumerate().map(|(at, edge)| (edge.normalize_or_zero(), at));
                let best = best_way(ways, direction.as_dvec3()).and_then(|at| edges.get(at));
                let amount = best.map_or(0.0, |edge| sight.fraction(*edge, by).max(0.0));
                (amount, Some(direction))
            }
        }
    }
}

/// The selected edges, or those of the selected half-edges, in the order in which a command without edges takes them.
fn selected_edges(editor: &Editor, mesh: &Mesh) -> Vec<EdgeId> {
    let selection = editor.selection();
    let edge = |id: u32| match selection.kind() {
        Element::Edge => mesh.edge(id),
        Element::Halfedge => mesh.halfedge(id).map(HalfedgeId::edge),
        Element::Vertex | Element::Face => None,
    };
    selection.ids().filter_map(edge).collect()
}
