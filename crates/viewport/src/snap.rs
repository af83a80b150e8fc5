//! Snapping: the point of a mesh under the pointer that moved elements go to.

use crate::Camera;
use crate::pick::{Aim, Still, nearest_edge, nearest_vertex, point_of_edge};
use crate::sight::Sight;
use glam::{Vec2, Vec3};
use halfedge::geometry::BitSet;
use halfedge::{Element, Mesh};
use surface::{FaceTree, Hit, Ray};

/// The most moved faces that a ray goes through before it gives up.
const MAX_FACES_PASSED: usize = 64;

/// The point to snap to at a pixel: the nearest vertex, the nearest point of an edge, or the point of the front face.
///
/// Finds what [`crate::pick`] does, at the same cost, without the elements that have a vertex in `moved` (by index).
/// What moves hides nothing.
pub fn snap(
    (mesh, tree): (&Mesh, &FaceTree),
    camera: &Camera,
    viewport: Vec2,
    pixel: Vec2,
    aim: Aim,
    moved: &BitSet,
) -> Option<Vec3> {
    let (sight, still) = (Sight::new(mesh, tree, camera, viewport), Still::Without(moved));
    match aim.kind {
        Element::Face => front_face(&sight, camera.ray(pixel, viewport), &still).map(|hit| hit.point),
        Element::Vertex => nearest_vertex(&sight, pixel, aim, &still).map(|(v, _)| mesh.position(v)),
        Element::Edge | Element::Halfedge => {
            let (edge, _) = nearest_edge(&sight, pixel, aim, &still)?;
            point_of_edge(&sight, pixel, edge)
        }
    }
}

/// The first face on a ray that doesn't move.
fn front_face(sight: &Sight<'_>, mut ray: Ray, still: &Still<'_>) -> Option<Hit> {
    for _ in 0..MAX_FACES_PASSED {
        let hit = sight.tree.hit(sight.mesh, ray)?;
        if still.face(sight.mesh, hit.face) {
            return Some(hit);
        }
        // A little behind the face, so that the ray doesn't hit it again.
        let step = (hit.distance * 1e-5).max(f64::from(f32::MIN_POSITIVE));
        ray.origin = (hit.point.as_dvec3() + ray.direction.as_dvec3() * step).as_vec3();
    }
    None
}
