//! What several edits ask of a set of faces or vertices: the outline of faces that become one, and
//! the faces round vertices that become one.

use crate::edit::Refusal;
use crate::edit::blend::Blend;
use crate::edit::follow::{Follower, Followers};
use crate::edit::patch::{Corner, Patch, Plan};
use crate::mesh::Mesh;
use crate::{Element, FaceId, HalfedgeId, VertexId};
use rustc_hash::{FxHashMap, FxHashSet};

/// The half-edges of the outline of some faces, counter-clockwise. Refused unless the faces make a
/// disc: the outline is one loop, and faces - inner edges + inner vertices is 1. (Three rows of
/// edges shared by two faces can make a handle with one loop.) Whether the loop touches itself at a
/// vertex is left to the patch that uses it.
pub(crate) fn outline(mesh: &Mesh, faces: &FxHashSet<FaceId>) -> Result<Vec<HalfedgeId>, Refusal> {
    let inside = |h: HalfedgeId| mesh.face_of(h).is_some_and(|face| faces.contains(&face));
    let (mut rim, mut shared) = (0, 0);
    let mut start = None;
    let mut some_face = None;
    let mut vertices: FxHashSet<VertexId> = FxHashSet::default();
    for &face in faces {
        some_face = some_face.max(Some(face));
        for h in mesh.face_halfedges(face) {
            vertices.insert(mesh.from(h));
            if inside(h.twin()) {
                shared += 1;
            } else {
                rim += 1;
                start = start.max(Some(h));
            }
        }
    }
    let (Some(start), Some(some_face)) = (start, some_face) else {
        // Closed: merging all its faces leaves nothing.
        return Err(some_face_refusal(faces));
    };
    let mut walk = Vec::with_capacity(rim);
    let mut at = start;
    loop {
        walk.push(at);
        at = mesh.next(at);
        while inside(at.twin()) {
            at = mesh.next(at.twin());
        }
        if at == start {
            break;
        }
    }
    for &h in &walk {
        vertices.remove(&mesh.from(h));
    }
    let is_disc = walk.len() == rim && faces.len() + vertices.len() == shared / 2 + 1;
    if is_disc { Ok(walk) } else { Err(Refusal::NotADisc(some_face)) }
}

fn some_face_refusal(faces: &FxHashSet<FaceId>) -> Refusal {
    match faces.iter().min() {
        Some(&face) => Refusal::NotADisc(face),
        None => Refusal::NothingGiven(Element::Face),
    }
}

/// A patch in which vertices become others: each face round them has the new one in place of the
/// old, a corner less for each edge that joined two that are one now, and vanishes with fewer than
/// three. `becomes` maps the vertices that change.
pub(crate) fn substitute(mesh: &Mesh, becomes: &FxHashMap<VertexId, VertexId>) -> Patch {
    let mut patch = Patch::new(mesh);
    let mut faces: Vec<FaceId> = becomes.keys().flat_map(|&v| mesh.vertex_faces(v)).collect();
    faces.sort_unstable();
    faces.dedup();
    let now = |v: VertexId| becomes.get(&v).copied().unwrap_or(v);
    for face in faces {
        let mut corners: Vec<Corner> = Vec::new();
        // Corners that become one follow all of theirs, and have the side of the last.
        let mut run: Vec<u32> = Vec::new();
        let sides: Vec<HalfedgeId> = mesh.face_halfedges(face).collect();
        // Start after an edge that stays, so that no run goes round the end.
        let Some(first) = sides.iter().position(|&h| now(mesh.from(h)) != now(mesh.to(h))) else {
            patch.remove.push(face);
            continue;
        };
        let mut start_corner = 0;
        for i in first + 1..=first + sides.len() {
            let h = sides[i % sides.len()];
            run.push(h.raw());
            if i == sides.len() {
                start_corner = corners.len();
            }
            let vertex = now(mesh.from(h));
            if now(mesh.to(h)) == vertex {
                continue;
            }
            let value = match run.as_slice() {
                &[one] => Blend::Copy(one),
                many => Blend::Mean(many.to_vec()),
            };
            corners.push(Corner { vertex, value, like: Some(h) });
            run.clear();
        }
        // The first corner stays the first.
        let turn = start_corner.min(corners.len().saturating_sub(1));
        corners.rotate_left(turn);
        patch.replace_face(face, corners, true);
    }
    patch
}

/// What corners follow at the vertices that others become, by a plan of [`substitute`]. The faces that lose
/// most corners lie nearest to where those go, so they say what values are there; faces that vanish, too.
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
