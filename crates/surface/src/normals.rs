//! Normals of faces, by Newell's method, and of vertices, as area-weighted means.
//!
//! The normals of single elements, for updates after an edit, and of the whole mesh use the same sums in the same
//! order, so that both give the same bits.

use glam::{DVec3, Vec3};
use halfedge::geometry::{face_area_vector, linked_area_vector};
use halfedge::{FaceId, Mesh, VertexId};

/// The unit normal of a face; zero for one without area.
pub fn face_normal(mesh: &Mesh, face: FaceId) -> Vec3 {
    face_area_vector(mesh, face).normalize_or_zero().as_vec3()
}

/// The unit normal of a vertex: the area-weighted mean over its faces; zero if it has none. Costs O(corners of
/// those faces).
pub fn vertex_normal(mesh: &Mesh, vertex: VertexId) -> Vec3 {
    let sum: DVec3 = mesh.vertex_faces(vertex).map(|f| face_area_vector(mesh, f)).sum();
    sum.normalize_or_zero().as_vec3()
}

/// [`face_normal`] of every face id; zero for removed ones. Costs O(mesh).
pub fn face_normals(mesh: &Mesh) -> Vec<Vec3> {
    let mut normals = vec![Vec3::ZERO; mesh.face_capacity()];
    for face in mesh.faces() {
        normals[face.index()] = face_normal(mesh, face);
    }
    normals
}

/// [`vertex_normal`] of every vertex id; zero for removed and isolated ones. Costs O(mesh).
pub fn vertex_normals(mesh: &Mesh) -> Vec<Vec3> {
    let (links, positions) = (mesh.connectivity(), mesh.positions());
    let mut areas = vec![DVec3::ZERO; mesh.face_capacity()];
    for face in mesh.faces() {
        areas[face.index()] = linked_area_vector(links, positions, face.index());
    }
    let mut normals = vec![Vec3::ZERO; mesh.vertex_capacity()];
    for vertex in mesh.vertices() {
        let sum: DVec3 = mesh.vertex_faces(vertex).map(|f| areas[f.index()]).sum();
        normals[vertex.index()] = sum.normalize_or_zero().as_vec3();
    }
    normals
}
