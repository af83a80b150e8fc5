//! Snapping: the point of a mesh under the pointer that moved elements go to.

use crate::Camera;
use crate::sight::Sight;
use glam::Vec2;
use glam::Vec3;
use halfedge::geometry::BitSet;
use halfedge::{Element, Mesh, VertexId};
use surface::{FaceTree, Hit, Ray};

/// The most moved faces that a ray goes through before it gives up.
const MAX_FACES_PASSED: usize = 64;

/// The point to snap to at a pixel: the nearest vertex, the nearest point of an edge, or the point of the front face.
///
/// Elements with a vertex in `moved` (by index) are left out, as are hidden ones; moved faces hide nothing. Vertices
/// and edges count within `radius` pixels, in the unit of `viewport`. Costs a pass over the vertices or edges, and a
/// few rays.
#[expect(clippy::too_many_arguments, reason = "the arguments of `pick`, and what moves")]
pub fn snap(
    mesh: &Mesh,
    tree: &FaceTree,
    camera: &Camera,
    viewport: Vec2,
    pixel: Vec2,
    kind: Element,
    radius: f32,
    moved: &BitSet,
) -> Option<Vec3> {
    let sight = Sight::new(mesh, tree, camera, viewport);
    let stays = |v: VertexId| !moved.contains(v.index());
    let moves = |f| !mesh.face_vertices(f).all(stays);
    let mut near: Vec<(f32, Vec3, [VertexId; 2])> = match kind {
        Element::Face => {
            return front_face(mesh, tree, camera.ray(pixel, viewport), moves).map(|hit| hit.point);
        }
        Element::Vertex => mesh
            .vertices()
            .filter(|v| stays(*v))
            .filter_map(|v| {
                Some((sight.project(mesh.position(v))?.distance(pixel), mesh.position(v), [v, v]))
            })
            .collect(),
        Element::Edge | Element::Halfedge => mesh
            .edges()
            .filter(|e| mesh.ends(*e).into_iter().all(stays))
            .filter_map(|e| {
                let segment = sight.segment(e)?;
                let (t, away) = segment.nearest(pixel);
                Some((away, sight.point_on(&segment, t), mesh.ends(e)))
            })
            .collect(),
    };
    near.retain(|(away, ..)| *away <= radius);
    near.sort_by(|a, b| a.0.total_cmp(&b.0));
    near.into_iter().find_map(|(_, point, [a, b])| {
        let own = |f| moves(f) || mesh.face_vertices(f).any(|v| v == a || v == b);
        sight.sees(point, own).map(|_| point)
    })
}

/// The first face on a ray that doesn't move.
fn front_face(
    mesh: &Mesh,
    tree: &FaceTree,
    mut ray: Ray,
    moves: impl Fn(halfedge::FaceId) -> bool,
) -> Option<Hit> {
    for _ in 0..MAX_FACES_PASSED {
        let hit = tree.hit(mesh, ray)?;
        if !moves(hit.face) {
            return Some(hit);
        }
        // A little behind the face, so that the ray doesn't hit it again.
        let step = (hit.distance * 1e-5).max(f64::from(f32::MIN_POSITIVE));
        ray.origin = (hit.point.as_dvec3() + ray.direction.as_dvec3() * step).as_vec3();
    }
    None
}
