//! Collapse edge: its two ends become one vertex.
//!
//! # When it is possible, exactly
//!
//! Let the edge e join a and b, with the faces F and G beside it; on the boundary one of them is missing. F and G
//! lose a corner; if one is a triangle a b w it vanishes, and its other two edges become one edge to w. Every other
//! face keeps its corners, with a and b renamed to one vertex v. The result is a valid mesh if and only if
//!
//! 1. no face but F and G has both a and b as corners (it would have v twice);
//! 2. every vertex joined to both a and b is the third corner of F or of G, that being a triangle
//!    (else two edges would join it to v). For triangle meshes (1) and (2) are the link condition
//!    lk(a) ∩ lk(b) = lk(e) on vertices: a face is its own boundary there;
//! 3. if a and b are both on the boundary, so is e (else the two boundaries meet at v, and the
//!    faces round it form two fans: a figure 8);
//! 4. no vanishing triangle has both other edges on the boundary (their one edge would have no face). The
//!    isolated triangle is such a case;
//! 5. F and G are not two triangles with the same three vertices (nothing would be left of them).
//!
//! Sufficient, rule by rule of [`Mesh::validate`](crate::Mesh::validate). Corners: those of F and G
//! still differ, being a subset; those of others do by (1); polygons of four or more keep three.
//! Edges: two that join the same vertices afterwards both lead to v from a common neighbour w of a
//! and b, which by (2) is the tip of a vanished triangle: they are the pair that becomes one. That
//! edge has the faces beyond the triangle on its two sides: at least one by (4), and not one face
//! twice, which would have a and b as corners, so is G by (1), and has sides a→w and w→b beside
//! b→a, so is the triangle of (5). Fans: round v one turns through a's faces from F to G and on
//! through b's, or, with a boundary at one of them or with e on it, along one path by (3). At w a
//! triangle leaves the fan and its neighbours in it become neighbours.
//!
//! An edge of a tetrahedron passes: two triangles back to back are left, which are a valid, if flat, sphere of
//! polygons. (5) refuses a second collapse. The Euler characteristic and the number of boundary loops never change; a
//! boundary loop of three never shrinks, by (2) or (4).

use crate::attribute::{Value, keys};
use crate::edit::Refusal;
use crate::edit::shared::{Blend, Follower, Followers, between, numbers};
use crate::mesh::Mesh;
use crate::{EdgeId, Element, FaceId, HalfedgeId, NumberRange, VertexId};
use rustc_hash::FxHashSet;

/// The result of collapsing an edge.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EdgeCollapse {
    /// The vertex that both ends became: the one that the edge's even half-edge leaves.
    pub vertex: VertexId,
    /// The other end, which was removed.
    pub removed_vertex: VertexId,
    /// The edge itself, then one edge for each triangle that vanished.
    pub removed_edges: Vec<EdgeId>,
    /// The triangles that vanished.
    pub removed_faces: Vec<FaceId>,
}

/// The places along an edge where the vertex of a collapse can lie.
pub const COLLAPSE_T_RANGE: NumberRange = NumberRange::new(0.0, 1.0);

/// Whether [`collapse_edge`] would succeed.
pub fn can_collapse_edge(mesh: &Mesh, edge: EdgeId, t: f32) -> Result<(), Refusal> {
    mesh.require_edge(edge)?;
    COLLAPSE_T_RANGE.require("t", t)?;
    let [a, b] = mesh.ends(edge);
    if !mesh.is_boundary_edge(edge) && mesh.is_boundary_vertex(a) && mesh.is_boundary_vertex(b) {
        return Err(Refusal::JoinsBoundaries(edge));
    }
    let tips = edge.halfedges().map(|h| triangle_tip(mesh, h));
    for h in edge.halfedges() {
        let Some(tip) = triangle_tip(mesh, h) else { continue };
        let beyond = [mesh.next(h).twin(), mesh.prev(h).twin()];
        if beyond.iter().all(|&h| mesh.is_boundary_halfedge(h))
            || beyond.iter().all(|&other| mesh.face_of(other) == mesh.face_of(h.twin()))
        {
            return Err(Refusal::LeftWithoutFace(tip));
        }
    }
    let near_a: FxHashSet<VertexId> = mesh.neighbors(a).collect();
    for w in mesh.neighbors(b) {
        if near_a.contains(&w) && !tips.contains(&Some(w)) {
            return Err(Refusal::AlreadyJoined(w, a));
        }
    }
    let beside = edge.halfedges().map(|h| mesh.face_of(h));
    let faces_of_a: FxHashSet<FaceId> = mesh.vertex_faces(a).collect();
    for face in mesh.vertex_faces(b) {
        if faces_of_a.contains(&face) && !beside.contains(&Some(face)) {
            return Err(Refusal::RepeatedCorner(a));
        }
    }
    Ok(())
}

/// The third corner of the face at a half-edge, if that is a triangle.
fn triangle_tip(mesh: &Mesh, h: HalfedgeId) -> Option<VertexId> {
    mesh.face_of(h)?;
    let after = mesh.next(h);
    (mesh.next(mesh.next(after)) == h).then(|| mesh.to(after))
}

/// Makes the two ends of an edge one vertex, at the fraction `t` along the even half-edge. Polygons beside the edge lose
/// a corner, and triangles vanish.
///
/// The end that the even half-edge leaves stays, and so does its edge of each vanished triangle. Costs O(valences of the
/// ends + degrees of the faces beside the edge). Attributes: the vertex gets the values at `t`. So do the corners at the
/// ends that have the same value as a corner beside the edge, so that texture coordinates stay in one piece on either
/// side of a seam; other corners get the values that their own faces have at the vertex's new place. Of two edges that
/// become one the sharper crease stays.
pub fn collapse_edge(mesh: &mut Mesh, edge: EdgeId, t: f32) -> Result<EdgeCollapse, Refusal> {
    can_collapse_edge(mesh, edge, t)?;
    let [h, twin] = edge.halfedges();
    let [a, b] = mesh.ends(edge);
    let at_b: Vec<HalfedgeId> = mesh.incoming(b).collect();
    let (blends, apart) = corner_values(mesh, edge, t);
    let followers =
        apart.into_iter().map(|corner| Follower { corner, vertex: a, side: Some(corner), rank: 1 }).collect();
    let followers = Followers::new(mesh, followers, |element, _| element == Element::Halfedge);
    mesh.set_position(a, mesh.position(a).lerp(mesh.position(b), t));
    followers.update(mesh);
    for (column, corner, value) in blends {
        mesh.set_value(Element::Halfedge, column, corner.index(), value);
    }
    mesh.blend_attributes(Element::Vertex, &Blend::Mix(a.raw(), b.raw(), t), a.raw());
    for h in at_b {
        mesh.set_to(h, a);
    }
    let mut made =
        EdgeCollapse { vertex: a, removed_vertex: b, removed_edges: vec![edge], removed_faces: vec![] };
    // A half-edge that leaves the vertex and stays.
    let mut stays = mesh.next(h);
    for (side, from_a) in [(h, true), (twin, false)] {
        let (before, after) = (mesh.prev(side), mesh.next(side));
        let Some(face) = mesh.face_of(side) else {
            mesh.link(before, after);
            continue;
        };
        if mesh.next(after) != before {
            mesh.link(before, after);
            if mesh.halfedge_of(face) == side {
                mesh.set_face_halfedge(face, after);
            }
            continue;
        }
        // The triangle is side, after, before. Its edge at a stays, in place of the one at b.
        let (keep, lose) = if from_a { (before, after) } else { (after, before) };
        let outer = lose.twin();
        let beyond = mesh.face_of(outer);
        mesh.copy_corners(&[(outer, keep)]);
        let (outer_prev, outer_next) = (mesh.prev(outer), mesh.next(outer));
        mesh.link(outer_prev, keep);
        mesh.link(keep, outer_next);
        mesh.set_face(keep, beyond);
        if let Some(beyond) = beyond
            && mesh.halfedge_of(beyond) == outer
        {
            mesh.set_face_halfedge(beyond, keep);
        }
        let sharper = mesh
            .get(keys::EDGE_CREASE, keep.edge().index())
            .max(mesh.get(keys::EDGE_CREASE, lose.edge().index()));
        if mesh.get(keys::EDGE_CREASE, keep.edge().index()) != sharper {
            mesh.set(keys::EDGE_CREASE, keep.edge().index(), sharper);
        }
        mesh.mark(Element::Edge, lose.edge().raw(), true);
        mesh.mark(Element::Face, face.raw(), true);
        made.removed_edges.push(lose.edge());
        made.removed_faces.push(face);
        let at_tip = if from_a { keep } else { keep.twin() };
        mesh.restore_vertex_halfedge(mesh.from(at_tip), at_tip);
        stays = at_tip.twin();
    }
    mesh.mark(Element::Edge, edge.raw(), true);
    mesh.mark(Element::Vertex, b.raw(), true);
    mesh.restore_vertex_halfedge(a, stays);
    Ok(made)
}

/// New values of corners: the column's number, the corner and the value.
type CornerValues = Vec<(usize, HalfedgeId, Value)>;

/// The values at `t` for the corners at both ends of an edge that have the value of a corner beside it, and the corners
/// that have another.
fn corner_values(mesh: &Mesh, edge: EdgeId, t: f32) -> (CornerValues, Vec<HalfedgeId>) {
    let [h, twin] = edge.halfedges();
    let beside: Vec<[HalfedgeId; 2]> = [[h, mesh.next(h)], [mesh.next(twin), twin]]
        .into_iter()
        .filter(|&[at_a, _]| mesh.face_of(at_a).is_some())
        .collect();
    let [a, b] = mesh.ends(edge);
    let (mut blends, mut apart) = (Vec::new(), Vec::new());
    for (at, column) in mesh.columns.of(Element::Halfedge).iter().enumerate() {
        let value = |corner: HalfedgeId| column.values.get(corner.index());
        for (end, v) in [a, b].into_iter().enumerate() {
            for corner in mesh.outgoing(v).filter(|&h| mesh.face_of(h).is_some()) {
                let Some(own) = value(corner) else { continue };
                match beside.iter().find(|pair| value(pair[end]) == Some(own)) {
                    Some(&[at_a, at_b]) => {
                        if let (Some(x), Some(y)) = (value(at_a), value(at_b)) {
                            blends.push((at, corner, between(column, x, y, t)));
                        }
                    }
                    None if numbers(own).is_some() => apart.push(corner),
                    None => {}
                }
            }
        }
    }
    (blends, apart)
}
