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
use crate::{EdgeId, Element, FaceId, HalfedgeId, VertexId};

/// Whether [`flip_edge`] would succeed.
pub fn can_flip_edge(mesh: &Mesh, edge: EdgeId) -> Result<(), Refusal> {
    let [left, right] = flippable(mesh, edge)?;
    let [c, d] = edge.halfedges().map(|h| mesh.to(mesh.next(h)));
    check_ends(mesh, [(left, d), (right, c)])
}

/// The faces beside an edge that neither the boundary nor the valences of its ends keep from being flipped.
fn flippable(mesh: &Mesh, edge: EdgeId) -> Result<[FaceId; 2], Refusal> {
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
    Ok([left, right])
}

/// Refuses ends that their new faces have already as corners, or that an edge joins already.
fn check_ends(mesh: &Mesh, gained: [(FaceId, VertexId); 2]) -> Result<(), Refusal> {
    for (face, v) in gained {
        if mesh.face_vertices(face).any(|corner| corner == v) {
            return Err(Refusal::RepeatedCorner(v));
        }
    }
    let [(_, d), (_, c)] = gained;
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

    let followers = follow_across_seams(mesh, edge, [(h, d, h), (twin, c, twin)]);
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

/// Whether [`flip_edge_clockwise`] would succeed: as for [`can_flip_edge`], seen in a mirror.
pub fn can_flip_edge_clockwise(mesh: &Mesh, edge: EdgeId) -> Result<(), Refusal> {
    let [left, right] = flippable(mesh, edge)?;
    let [x, y] = edge.halfedges().map(|h| mesh.from(mesh.prev(h)));
    check_ends(mesh, [(left, y), (right, x)])
}

/// [`flip_edge`] the other way: each end moves one step clockwise. Between two triangles, both give the same triangles.
pub fn flip_edge_clockwise(mesh: &mut Mesh, edge: EdgeId) -> Result<(), Refusal> {
    can_flip_edge_clockwise(mesh, edge)?;
    let [h, twin] = edge.halfedges();
    let [a, b] = mesh.ends(edge);
    let (left, right) = (mesh.face_of(h), mesh.face_of(twin));
    // x -> a in the left face and y -> b in the right one change places.
    let (xa, yb) = (mesh.prev(h), mesh.prev(twin));
    let (x, y) = (mesh.from(xa), mesh.from(yb));
    let (before_x, before_y) = (mesh.prev(xa), mesh.prev(yb));
    let (after_a, after_b) = (mesh.next(twin), mesh.next(h));

    let followers = follow_across_seams(mesh, edge, [(h, y, yb), (twin, x, xa)]);
    mesh.copy_corners(&[(xa, h), (yb, twin)]);
    followers.update(mesh);
    for (face, lost, own) in [(left, xa, h), (right, yb, twin)] {
        if let Some(face) = face.filter(|&face| mesh.halfedge_of(face) == lost) {
            mesh.set_face_halfedge(face, own);
        }
    }
    // Left: before_x, x -> y, y -> b, after_b. Right: before_y, y -> x, x -> a, after_a.
    mesh.link(before_x, h);
    mesh.link(h, yb);
    mesh.link(yb, after_b);
    mesh.link(before_y, twin);
    mesh.link(twin, xa);
    mesh.link(xa, after_a);
    mesh.set_face(xa, right);
    mesh.set_face(yb, left);
    mesh.set_to(h, y);
    mesh.set_to(twin, x);
    if mesh.halfedge_from(a) == Some(h) {
        mesh.set_vertex_halfedge(a, Some(after_a));
    }
    if mesh.halfedge_from(b) == Some(twin) {
        mesh.set_vertex_halfedge(b, Some(after_b));
    }
    Ok(())
}

/// Followers for the corners that the two faces gain, in columns whose values differ between the sides of the edge:
/// there each face continues its own values. `gained` has a corner of each face, the vertex at the new corner and the
/// half-edge that leaves it afterwards.
fn follow_across_seams(
    mesh: &Mesh,
    edge: EdgeId,
    gained: [(HalfedgeId, VertexId, HalfedgeId); 2],
) -> Followers {
    let [h, twin] = edge.halfedges();
    let gained =
        gained.map(|(corner, vertex, side)| Follower { corner, vertex, side: Some(side), rank: 1 }).to_vec();
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
