//! The outline of faces that become one, and the faces round vertices that become one.

use super::{Blend, Follower, Followers};
use crate::edit::Refusal;
use crate::edit::patch::{Corner, Patch, Plan};
use crate::mesh::Mesh;
use crate::{Element, FaceId, HalfedgeId, VertexId};
use rustc_hash::{FxHashMap, FxHashSet};

/// The half-edges of the outline of some faces, counter-clockwise. Refused unless the faces form a disc: the outline
/// is one loop, and faces - inner edges + inner vertices is 1. (A handle can have an outline of one loop too.) The
/// loop may touch itself at a vertex; planning a patch finds that.
pub(crate) fn outline(mesh: &Mesh, faces: &FxHashSet<FaceId>) -> Result<Vec<HalfedgeId>, Refusal> {
    let is_inside = |h: HalfedgeId| mesh.face_of(h).is_some_and(|face| faces.contains(&face));
    let (mut outer_sides, mut inner_sides) = (0, 0);
    let mut start = None;
    let mut last_face = None;
    let mut inner_vertices: FxHashSet<VertexId> = FxHashSet::default();
    for &face in faces {
        last_face = last_face.max(Some(face));
        for h in mesh.face_halfedges(face) {
            inner_vertices.insert(mesh.from(h));
            if is_inside(h.twin()) {
                inner_sides += 1;
            } else {
                outer_sides += 1;
                start = start.max(Some(h));
            }
        }
    }
    let (Some(start), Some(last_face)) = (start, last_face) else {
        // The faces are a whole closed piece: nothing would be left.
        let first_face = faces.iter().min().copied();
        return Err(first_face.map_or(Refusal::NothingGiven(Element::Face), Refusal::NotADisc));
    };
    let mut walk = Vec::with_capacity(outer_sides);
    let mut at = start;
    loop {
        walk.push(at);
        at = mesh.next(at);
        while is_inside(at.twin()) {
            at = mesh.next(at.twin());
        }
        if at == start {
            break;
        }
    }
    for &h in &walk {
        inner_vertices.remove(&mesh.from(h));
    }
    let is_disc = walk.len() == outer_sides && faces.len() + inner_vertices.len() == inner_sides / 2 + 1;
    if is_disc { Ok(walk) } else { Err(Refusal::NotADisc(last_face)) }
}

/// A patch in which vertices become others, by the map `becomes`. Each face round them has the new vertices in place
/// of the old, and a corner less for each edge whose ends become one. Faces with fewer than three corners left are
/// removed.
pub(crate) fn merge_corners(mesh: &Mesh, becomes: &FxHashMap<VertexId, VertexId>) -> Patch {
    let mut patch = Patch::new(mesh);
    let mut faces: Vec<FaceId> = becomes.keys().flat_map(|&v| mesh.vertex_faces(v)).collect();
    faces.sort_unstable();
    faces.dedup();
    let now = |v: VertexId| becomes.get(&v).copied().unwrap_or(v);
    for face in faces {
        let mut corners: Vec<Corner> = Vec::new();
        // Corners that become one get their value from all of them, and their side from the last.
        let mut run: Vec<u32> = Vec::new();
        let sides: Vec<HalfedgeId> = mesh.face_halfedges(face).collect();
        // Start after an edge that stays, so that no run goes round the end.
        let Some(first) = sides.iter().position(|&h| now(mesh.from(h)) != now(mesh.to(h))) else {
            patch.remove.push(face);
            continue;
        };
        let mut first_corner = 0;
        for i in first + 1..=first + sides.len() {
            let h = sides[i % sides.len()];
            run.push(h.raw());
            if i == sides.len() {
                first_corner = corners.len();
            }
            let vertex = now(mesh.from(h));
            if now(mesh.to(h)) == vertex {
                continue;
            }
            let value = match run.as_slice() {
                &[one] => Blend::Copy(one),
                many => Blend::Mean(many.to_vec()),
            };
            corners.push(Corner { vertex, value, replaces: Some(h) });
            run.clear();
        }
        // The first corner stays the first.
        let turn = first_corner.min(corners.len().saturating_sub(1));
        corners.rotate_left(turn);
        patch.shrink_face(face, corners);
    }
    patch
}

/// The followers at the vertices that others become, for a plan of [`merge_corners`]. The faces that lose most
/// corners lie nearest to the new place, so their values count, even those of faces that vanish.
pub(crate) fn follow_merged(mesh: &Mesh, plan: &Plan, becomes: &FxHashMap<VertexId, VertexId>) -> Followers {
    let targets: FxHashSet<VertexId> = becomes.values().copied().collect();
    let mut followers = plan.followers(mesh, targets.iter().copied());
    let now = |h: HalfedgeId| becomes.get(&mesh.from(h)).copied().unwrap_or(mesh.from(h));
    for &face in &plan.made.removed_faces {
        let mut ranks: FxHashMap<VertexId, usize> = FxHashMap::default();
        for h in mesh.face_halfedges(face) {
            *ranks.entry(now(h)).or_default() += 1;
        }
        for corner in mesh.face_halfedges(face) {
            let vertex = now(corner);
            if let Some(&rank) = ranks.get(&vertex).filter(|_| targets.contains(&vertex)) {
                followers.push(Follower { corner, vertex, side: None, rank });
            }
        }
    }
    Followers::new(mesh, followers, |element, _| element == Element::Halfedge)
}
