//! Flip edge: each end moves one step counter-clockwise round the union of the two faces.
//!
//! # When it is possible, exactly
//!
//! Let the edge run from a to b, with the face F on its left and G on its right. Counter-clockwise
//! round F ∪ G the corner after a is d (in G) and the one after b is c (in F). Afterwards the edge
//! runs from d to c; F loses b and gains d, G loses a and gains c. Nothing else changes. So the
//! result is a valid mesh if and only if
//!
//! 1. F and G exist: the edge is not on the boundary. (They are never the same face: a face with both sides of an
//!    edge would have a corner twice.)
//! 2. a and b have at least three edges: each loses one, and a vertex with one edge would be the
//!    tip of a spike in its face. Boundary vertices with an inner edge always have three.
//! 3. d is not a corner of F and c not one of G: no corner repeats. This includes d ≠ c.
//! 4. no edge joins c and d yet: no edge is duplicated.
//!
//! Sufficient, rule by rule of [`Mesh::validate`](crate::Mesh::validate): both faces keep their
//! number of corners, and those differ by (3); edges differ by (4); every edge keeps two sides with
//! the same faces as before but a→d and b→c, whose face changes from G to F and from F to G, so each
//! still has a face; round a the corners in F and G merge into one and round d the corner in G is
//! cut in two, so each fan stays one fan, and no boundary half-edge is touched.
//!
//! At an inner vertex of a triangle mesh, valence three never passes: its neighbours are joined to
//! each other, which is (4). Such a flip would leave it with valence two.

use crate::edit::Refusal;
use crate::edit::shared::{Follower, Followers};
use crate::mesh::Mesh;
use crate::{EdgeId, Element, HalfedgeId};

/// Whether [`flip_edge`] would succeed.
pub fn can_flip_edge(mesh: &Mesh, edge: EdgeId) -> Result<(), Refusal> {
    mesh.require_edge(edge)?;
    let [h, twin] = edge.halfedges();
    let (Some(left), Some(right)) = (mesh.face_of(h), mesh.face_of(twin)) else {
        return Err(Refusal::BoundaryEdge(edge));
    };
    for v in mesh.ends(edge) {
        let valence = mesh.outgoing(v).take(4).count();
        let inner_triangles =
            || mesh.outgoing(v).all(|h| mesh.face_of(h).is_some() && mesh.next(mesh.next(mesh.next(h))) == h);
        if valence < 3 || (valence == 3 && inner_triangles()) {
            return Err(Refusal::ValenceTooLow(v, valence));
        }
    }
    let (c, d) = (mesh.to(mesh.next(h)), mesh.to(mesh.next(twin)));
    if mesh.face_vertices(left).any(|v| v == d) {
        return Err(Refusal::RepeatedCorner(d));
    }
    if mesh.face_vertices(right).any(|v| v == c) {
        return Err(Refusal::RepeatedCorner(c));
    }
    match mesh.find_halfedge_between(c, d) {
        Some(_) => Err(Refusal::AlreadyJoined(c, d)),
        None => Ok(()),
    }
}

/// Moves each end of an edge one step counter-clockwise round the union of its two faces. Between two triangles this
/// is the usual flip; flipping twice gives the same triangles with the edge reversed.
///
/// All ids survive, and nothing is added or removed. Costs O(degrees of the two faces + valences of the
/// four vertices). Attributes: the edge keeps its own; corners keep theirs, and the corner each
/// face gains copies the other face's at that vertex. Where values differ between the sides of the edge,
/// each face continues its own to the corner that it gains.
pub fn flip_edge(mesh: &mut Mesh, edge: EdgeId) -> Result<(), Refusal> {
    can_flip_edge(mesh, edge)?;
    let [h, twin] = edge.halfedges();
    let [a, b] = mesh.ends(edge);
    let (left, right) = (mesh.face_of(h), mesh.face_of(twin));
    // b -> c in the left face and a -> d in the right one change places.
    let (bc, ad) = (mesh.next(h), mesh.next(twin));
    let (c, d) = (mesh.to(bc), mesh.to(ad));
    let (after_c, after_d) = (mesh.next(bc), mesh.next(ad));
    let (before_a, before_b) = (mesh.prev(h), mesh.prev(twin));

    let followers = follow_across_seams(mesh, edge);
    mesh.copy_corners(&[(h, ad), (twin, bc), (after_d, h), (after_c, twin)]);
    followers.update(mesh);
    if let (Some(left), Some(right)) = (left, right) {
        for (face, lost, kept, gained, own) in [(left, bc, h, ad, h), (right, ad, twin, bc, twin)] {
            let first = mesh.halfedge_of(face);
            if first == kept {
                mesh.set_face_halfedge(face, gained);
            } else if first == lost {
                mesh.set_face_halfedge(face, own);
            }
        }
    }
    // Left: before_a, a -> d, d -> c, after_c. Right: before_b, b -> c, c -> d, after_d.
    mesh.link(before_a, ad);
    mesh.link(ad, h);
    mesh.link(h, after_c);
    mesh.link(before_b, bc);
    mesh.link(bc, twin);
    mesh.link(twin, after_d);
    mesh.set_face(ad, left);
    mesh.set_face(bc, right);
    mesh.set_to(h, c);
    mesh.set_to(twin, d);
    if mesh.halfedge_from(a) == Some(h) {
        mesh.set_vertex_halfedge(a, Some(ad));
    }
    if mesh.halfedge_from(b) == Some(twin) {
        mesh.set_vertex_halfedge(b, Some(bc));
    }
    Ok(())
}

/// Followers for the corners that the two faces gain, in columns whose values differ between the sides of the edge:
/// there each face continues its own values.
fn follow_across_seams(mesh: &Mesh, edge: EdgeId) -> Followers {
    let [h, twin] = edge.halfedges();
    let (c, d) = (mesh.to(mesh.next(h)), mesh.to(mesh.next(twin)));
    let gained = [(h, d), (twin, c)]
        .map(|(corner, vertex)| Follower { corner, vertex, side: Some(corner), rank: 1 })
        .to_vec();
    Followers::new(mesh, gained, |element, column| {
        let values = &mesh.columns.of(element)[column].values;
        let differ = |a: HalfedgeId, b: HalfedgeId| values.get(a.index()) != values.get(b.index());
        element == Element::Halfedge && (differ(h, mesh.next(twin)) || differ(twin, mesh.next(h)))
    })
}

impl Mesh {
    /// Copies values between corners, from and to, as they were before the first one is written.
    pub(crate) fn copy_corners(&mut self, from_to: &[(HalfedgeId, HalfedgeId)]) {
        for at in 0..self.columns.of(Element::Halfedge).len() {
            let values = &self.columns.of(Element::Halfedge)[at].values;
            let read: Vec<_> =
                from_to.iter().map(|(from, to)| (values.get(from.index()), to.index())).collect();
            for (value, to) in read {
                if let Some(value) = value {
                    self.set_value(Element::Halfedge, at, to, value);
                }
            }
        }
    }
}
