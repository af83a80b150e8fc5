//! Whether a local edit can be made on what is selected: the mesh's own checks, asked before the
//! person does.

use editor::Selection;
use halfedge::edit::{self, Refusal};
use halfedge::{EdgeId, Element, FaceId, HalfedgeId, Mesh, VertexId};

/// More than this many selected elements are not looked at beforehand: the command says no itself.
const MOST: usize = 2;

/// Why an edit of one or two selected elements would be refused. Costs O(valence); larger selections
/// cost nothing and give none.
pub fn refusal(mesh: &Mesh, selection: &Selection, op: &str) -> Option<Refusal> {
    if selection.is_empty() || selection.len() > MOST {
        return None;
    }
    let ids: Vec<u32> = selection.ids().collect();
    let result = match selection.kind() {
        Element::Vertex => {
            of_vertices(mesh, op, &ids.iter().filter_map(|&id| mesh.vertex(id)).collect::<Vec<_>>())
        }
        Element::Edge => of_edges(mesh, op, &ids.iter().filter_map(|&id| mesh.edge(id)).collect::<Vec<_>>()),
        Element::Face => of_faces(mesh, op, &ids.iter().filter_map(|&id| mesh.face(id)).collect::<Vec<_>>()),
        Element::Halfedge => {
            let sides: Vec<HalfedgeId> = ids.iter().filter_map(|&id| mesh.halfedge(id)).collect();
            let mut edges: Vec<EdgeId> = sides.iter().map(|h| h.edge()).collect();
            edges.dedup();
            match (op, sides.as_slice()) {
                ("fill-hole", &[side]) => edit::can_fill_hole(mesh, side),
                ("bridge", &[a, b]) => edit::can_bridge(mesh, [a, b]),
                _ => of_edges(mesh, op, &edges),
            }
        }
    };
    result.err()
}

fn of_vertices(mesh: &Mesh, op: &str, vertices: &[VertexId]) -> Result<(), Refusal> {
    match (op, vertices) {
        ("dissolve-vertex", &[v]) => edit::can_dissolve_vertex(mesh, v),
        ("connect-vertices", &[a, b]) => edit::can_connect_vertices(mesh, a, b),
        ("merge-vertices", both @ [_, _]) => edit::can_merge_vertices(mesh, both, None),
        ("bevel-vertices", _) => edit::can_bevel_vertices(mesh, vertices),
        _ => Ok(()),
    }
}

fn of_edges(mesh: &Mesh, op: &str, edges: &[EdgeId]) -> Result<(), Refusal> {
    match (op, edges) {
        ("flip-edge", &[e]) => edit::can_flip_edge(mesh, e),
        ("collapse-edge", &[e]) => edit::can_collapse_edge(mesh, e, 0.5),
        ("dissolve-edge", &[e]) => edit::can_dissolve_edge(mesh, e),
        ("loop-cut", &[e]) => edit::can_loop_cut(mesh, e, 1, 0.5),
        ("weld-edges", &[a, b]) => edit::can_weld_edges(mesh, [a, b]),
        ("extrude-edges", _) => edit::can_extrude_edges(mesh, edges),
        ("rip-edges", _) => edit::can_rip_edges(mesh, edges),
        _ => Ok(()),
    }
}

fn of_faces(mesh: &Mesh, op: &str, faces: &[FaceId]) -> Result<(), Refusal> {
    match (op, faces) {
        ("collapse-face", &[f]) => edit::can_collapse_face(mesh, f),
        ("triangulate-faces", &[f]) => edit::can_triangulate_face(mesh, f, edit::Triangulation::Fan),
        ("poke-faces", _) => edit::can_poke_faces(mesh, faces),
        ("flip-orientation", _) => edit::can_flip_orientation(mesh, faces),
        _ => Ok(()),
    }
}
