//! Algorithms over a whole half-edge mesh, as free functions in files named after them.
//!
//! Operations that change the mesh return a new one, report to a [`Progress`](halfedge::Progress), which can
//! cancel them, and give the same bits on every machine: they use basic IEEE operations in a fixed order, and
//! nothing of the system's mathematics library.

#![cfg_attr(not(test), deny(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::unreachable))]

pub mod bezier;
pub mod curvature;
mod error;
mod extract_faces;
mod face_tree;
mod join_meshes;
pub mod measure;
mod merge_by_distance;
mod mirror_images;
mod mirror_result;
mod morton;
pub mod normals;
mod pace;
mod remesh;
pub mod selecting;
mod shapes;
mod simplify;
mod smooth;
mod soft_selection;
mod subdivide;
mod trig;
mod trimesh;

pub use error::SurfaceError;
pub use extract_faces::extract_faces;
pub use face_tree::{FaceTree, FaceTreeBuilder, FaceWalk, Hit, Ray};
pub use join_meshes::join_meshes;
pub use merge_by_distance::{Merged, merge_by_distance};
pub use mirror_images::{MirrorImages, mirrored};
pub use mirror_result::faces_of;
pub use remesh::{REMESH_FEATURE_ANGLE_RANGE, REMESH_ITERATIONS_RANGE, Remesh, remesh};
pub use shapes::{Shape, ShapeField};
pub use simplify::{SIMPLIFY_RATIO_RANGE, Simplified, Simplify, SimplifyTarget, simplify};
pub use smooth::{SMOOTH_ITERATIONS_RANGE, SMOOTH_STRENGTH_RANGE, Smooth, SmoothMethod, smooth};
pub use soft_selection::soft_selection;
pub use subdivide::{
    BoundaryRule, CatmullClark, Linear, Loop, LoopWeights, MAX_SUBDIVIDED_FACES, SUBDIVISION_LEVELS_RANGE,
    Split, VertexRule, compact_ids, descendants, quad_split_faces, subdivide_catmull_clark, subdivide_linear,
    subdivide_loop,
};

use halfedge::Mesh;

/// Refuses a mesh with a face of more than three corners; the error names the first.
fn require_triangles(mesh: &Mesh) -> Result<(), SurfaceError> {
    for face in mesh.faces() {
        let h = mesh.halfedge_of(face);
        if mesh.next(mesh.next(h)) != mesh.prev(h) {
            return Err(SurfaceError::NotTriangles { face, corners: mesh.face_degree(face) });
        }
    }
    Ok(())
}
