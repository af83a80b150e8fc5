//! The topology that extruding and insetting share: some faces come loose from those round them, and a wall of quads
//! joins their outline's old place to its new one.
//!
//! The result is always a valid mesh. Each group of the faces that follow one another round a vertex gets a vertex
//! of its own, so a vertex that the faces touch from two sides gets two. The walls on either side of a group share
//! the edge from the old vertex to the new one and close the gap that the group left. Outline edges on the boundary
//! of the mesh get walls too: the boundary stays where it was. Holes and several pieces are further outlines.

use crate::edit::Refusal;
use crate::edit::patch::{Corner, Patch};
use crate::mesh::Mesh;
use crate::{FaceId, HalfedgeId, VertexId};
use glam::Vec3;
use rustc_hash::{FxHashMap, FxHashSet};

/// Which of the given faces stay together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Grouping {
    /// Faces that share an edge.
    #[default]
    Region,
    /// None: each face is on its own.
    Individual,
}

/// A new vertex at the outline. Its corners lie counter-clockwise from one outline half-edge, which leaves it, to
/// another, which arrives.
pub(crate) struct WallVertex {
    pub vertex: VertexId,
    pub leaves: HalfedgeId,
    pub arrives: HalfedgeId,
    /// The unit vector along the sum of the unit normals of the vertex's faces.
    pub normal: Vec3,
}

pub(crate) struct Walls {
    pub patch: Patch,
    pub vertices: Vec<WallVertex>,
    /// Vertices whose faces are all in one region, with their normals: they stay in it.
    pub inner: Vec<(VertexId, Vec3)>,
    pub normals: FxHashMap<FaceId, Vec3>,
}

pub(crate) fn walls(mesh: &Mesh, faces: &[FaceId], grouping: Grouping) -> Result<Walls, Refusal> {
    mesh.require_faces(faces)?;
    let mut faces = faces.to_vec();
    faces.sort_unstable();
    faces.dedup();
    let chosen: FxHashSet<FaceId> = faces.iter().copied().collect();
    // Whether the face of a half-edge stays together with the chosen face across it.
    let is_joined = |h: HalfedgeId| {
        grouping == Grouping::Region && mesh.face_of(h).is_some_and(|face| chosen.contains(&face))
    };
    let normals: FxHashMap<FaceId, Vec3> = faces.iter().map(|&f| (f, mesh.unit_normal(f))).collect();
    let normal =
        |h: HalfedgeId| mesh.face_of(h).and_then(|face| normals.get(&face)).copied().unwrap_or_default();

    let mut patch = Patch::new(mesh);
    let mut moved: FxHashMap<HalfedgeId, VertexId> = FxHashMap::default();
    let mut vertices = Vec::new();
    for &face in &faces {
        for leaves in mesh.face_halfedges(face).filter(|&h| !is_joined(h.twin())) {
            let vertex = patch.copy_vertex(mesh, mesh.from(leaves));
            let mut corner = leaves;
            let mut sum = Vec3::ZERO;
            let arrives = loop {
                moved.insert(corner, vertex);
                sum += normal(corner);
                let before = mesh.prev(corner);
                if !is_joined(before.twin()) {
                    break before;
                }
                corner = before.twin();
            };
            vertices.push(WallVertex { vertex, leaves, arrives, normal: sum.normalize_or_zero() });
        }
    }
    let mut inner = Vec::new();
    let mut visited: FxHashSet<VertexId> = FxHashSet::default();
    for &face in &faces {
        let mut corners = Vec::new();
        let mut is_unchanged = true;
        for h in mesh.face_halfedges(face) {
            if let Some(&vertex) = moved.get(&h) {
                is_unchanged = false;
                corners.push(Corner::moved(vertex, h));
                continue;
            }
            let v = mesh.from(h);
            if visited.insert(v) {
                let sum: Vec3 = mesh.outgoing(v).map(normal).sum();
                inner.push((v, sum.normalize_or_zero()));
            }
            corners.push(Corner::keep(mesh, h));
        }
        if !is_unchanged {
            patch.replace_face(face, corners);
        }
    }
    for wall in &vertices {
        let (h, next) = (wall.leaves, mesh.next(wall.leaves));
        let Some(&far) = moved.get(&next) else { continue };
        let corners = vec![
            Corner::keep(mesh, h),
            Corner::new(mesh.to(h), next),
            Corner::new(far, next),
            Corner::new(wall.vertex, h),
        ];
        patch.add_face(mesh.face_of(h), corners);
    }
    Ok(Walls { patch, vertices, inner, normals })
}
