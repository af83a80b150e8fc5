//! Split edge: a new vertex on an edge, and optionally cuts from it across the faces beside it.
//!
//! Every edge of a valid mesh can be split at any 0 < t < 1: before the cuts the new vertex has valence two, and its faces
//! gain a corner each. A cut goes to a corner at least two steps away on either side, so it duplicates no edge, with one
//! exception: both cuts may go to the same vertex, if it is the opposite corner of both faces. That is refused.

use crate::edit::Refusal;
use crate::edit::shared::Blend;
use crate::mesh::Mesh;
use crate::{EdgeId, Element, FaceId, HalfedgeId, NumberRange, VertexId};

/// Which faces beside a split edge are cut from the new vertex.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Connect {
    /// None: the faces gain a corner.
    None,
    /// Triangles are cut to their opposite corner; larger faces gain a corner.
    #[default]
    Triangles,
    /// Every face is cut to the corner halfway round: `n / 2` steps, rounded up, from the new vertex in a face
    /// that had n corners.
    All,
}

/// The places along an edge where it can be split.
pub const SPLIT_T_RANGE: NumberRange = NumberRange::between(0.0, 1.0);

/// The result of splitting an edge.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EdgeSplit {
    /// The new vertex.
    pub vertex: VertexId,
    /// The new edges: the second half of the split edge (the first keeps its id), then the cuts.
    pub edges: Vec<EdgeId>,
    /// The new faces, one per cut.
    pub faces: Vec<FaceId>,
}

/// Whether [`split_edge`] would succeed.
pub fn can_split_edge(mesh: &Mesh, edge: EdgeId, t: f32, connect: Connect) -> Result<(), Refusal> {
    mesh.require_edge(edge)?;
    SPLIT_T_RANGE.require("t", t)?;
    let [h, twin] = edge.halfedges().map(|h| {
        let steps = steps_to_cut(mesh, h, connect)?;
        Some(mesh.from((0..steps).fold(mesh.next(h), |h, _| mesh.next(h))))
    });
    match (h, twin) {
        (Some(a), Some(b)) if a == b => Err(Refusal::CutsMeet(a)),
        _ => Ok(()),
    }
}

/// The number of steps from the half-edge's end to the corner that the cut on its side goes to; none if there is no cut.
fn steps_to_cut(mesh: &Mesh, h: HalfedgeId, connect: Connect) -> Option<usize> {
    let degree = mesh.face_degree(mesh.face_of(h)?);
    match connect {
        Connect::None => None,
        Connect::Triangles => (degree == 3).then_some(1),
        Connect::All => Some(degree.div_ceil(2) - 1),
    }
}

/// Splits an edge at the fraction `t` along its even half-edge.
///
/// All ids survive; the edge keeps its id up to the new vertex. Costs O(degree of the faces beside it). Attributes: the
/// new vertex and its corners are interpolated at `t`; the new half copies the edge; new faces copy those that they are
/// cut from; cuts have default values.
pub fn split_edge(mesh: &mut Mesh, edge: EdgeId, t: f32, connect: Connect) -> Result<EdgeSplit, Refusal> {
    can_split_edge(mesh, edge, t, connect)?;
    let [h, twin] = edge.halfedges();
    let [a, b] = mesh.ends(edge);
    let steps = [h, twin].map(|h| steps_to_cut(mesh, h, connect));

    // Before: a --h--> b. After: a --h--> m --g--> b, with `twin` m -> a and `g`'s twin b -> m.
    let m = mesh.add_vertex(mesh.position(a).lerp(mesh.position(b), t));
    mesh.blend_attributes(Element::Vertex, &Blend::Mix(a.raw(), b.raw(), t), m.raw());
    let g = mesh.add_edge(m, b);
    let (after_h, before_twin) = (mesh.next(h), mesh.prev(twin));
    mesh.copy_attributes(Element::Edge, edge.raw(), g.edge().raw());
    // Corners: `g` has the new one on h's side. On the other side b's corner moves from `twin` to `g`'s twin, and
    // `twin` has the new one.
    mesh.blend_attributes(Element::Halfedge, &Blend::Mix(h.raw(), after_h.raw(), t), g.raw());
    mesh.copy_attributes(Element::Halfedge, twin.raw(), g.twin().raw());
    let a_corner = mesh.next(twin);
    mesh.blend_attributes(Element::Halfedge, &Blend::Mix(a_corner.raw(), g.twin().raw(), t), twin.raw());

    mesh.link(g, after_h);
    mesh.link(h, g);
    mesh.link(before_twin, g.twin());
    mesh.link(g.twin(), twin);
    mesh.set_to(h, m);
    mesh.set_face(g, mesh.face_of(h));
    let twin_face = mesh.face_of(twin);
    mesh.set_face(g.twin(), twin_face);
    if let Some(f) = twin_face
        && mesh.halfedge_of(f) == twin
    {
        // `twin` used to leave b; the face's first corner stays b.
        mesh.set_face_halfedge(f, g.twin());
    }
    if mesh.halfedge_from(b) == Some(twin) {
        mesh.set_vertex_halfedge(b, Some(g.twin()));
    }
    mesh.restore_vertex_halfedge(m, g);

    let mut split = EdgeSplit { vertex: m, edges: vec![g.edge()], faces: Vec::new() };
    for (corner, steps) in [(g, steps[0]), (twin, steps[1])] {
        if let Some(steps) = steps {
            // One step more, to the end of the split edge.
            let opposite = (0..=steps).fold(corner, |h, _| mesh.next(h));
            let (across, made) = mesh.cut_face(corner, opposite);
            split.edges.push(across.edge());
            split.faces.push(made);
        }
    }
    Ok(split)
}
