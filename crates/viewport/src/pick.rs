//! Picking: the element under the pointer.

use crate::Camera;
use crate::sight::Sight;
use glam::Vec2;
use halfedge::{EdgeId, Element, FaceId, HalfedgeId, Mesh};
use std::collections::BTreeSet;
use surface::FaceTree;

/// Rays are cast around the pointer in this many directions, at half the pick radius and at the whole radius.
const PICK_DIRECTIONS: u16 = 8;
/// The most faces whose elements are candidates: vertices of very high valence have many.
const MAX_CANDIDATE_FACES: usize = 512;

/// An element under the pointer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Picked {
    /// Its kind.
    pub element: Element,
    /// Its id.
    pub id: u32,
    /// The distance from the eye in mesh units, for comparing picks in several objects.
    pub distance: f64,
}

/// Picks the element of a kind at a pixel, if there is one.
///
/// A face is picked at the pixel itself. A vertex or edge is the one nearest to the pixel on the screen,
/// within `radius` pixels, that belongs to the faces seen there or their neighbours and isn't hidden; the
/// pointer may be just outside the silhouette. Of an edge's two half-edges, the one of the face at the
/// pixel is picked; outside the surface the boundary one, or that of the face that faces the camera. Pixels
/// are in the unit of `viewport`. Costs a few dozen rays.
pub fn pick(
    mesh: &Mesh,
    tree: &FaceTree,
    camera: &Camera,
    viewport: Vec2,
    pixel: Vec2,
    kind: Element,
    radius: f32,
) -> Option<Picked> {
    let sight = Sight::new(mesh, tree, camera, viewport);
    let hit_at = |pixel| tree.hit(mesh, camera.ray(pixel, viewport));
    let under = hit_at(pixel);
    if kind == Element::Face {
        return under.map(|hit| Picked { element: kind, id: hit.face.raw(), distance: hit.distance });
    }
    let mut faces: Vec<FaceId> = under.iter().map(|hit| hit.face).collect();
    for ring in [0.5, 1.0] {
        for step in 0..PICK_DIRECTIONS {
            let angle = f32::from(step) * std::f32::consts::TAU / f32::from(PICK_DIRECTIONS);
            faces.extend(hit_at(pixel + Vec2::from_angle(angle) * radius * ring).map(|hit| hit.face));
        }
    }
    if under.is_none() {
        faces.extend(closest_to_ray(&sight, pixel));
    }
    let faces = with_neighbors(mesh, &faces);
    if kind == Element::Vertex {
        return pick_vertex(&sight, &faces, pixel, radius);
    }
    let (edge, distance) = pick_edge(&sight, &faces, pixel, radius)?;
    let id = match kind {
        Element::Halfedge => side_of(&sight, edge, under.map(|hit| hit.face)).raw(),
        _ => edge.raw(),
    };
    Some(Picked { element: kind, id, distance })
}

/// Picks like [`pick`]; where that finds nothing but a face is seen at the pixel, the vertex, edge or half-edge of this
/// face that is nearest to the pixel, however far away: a click on a model means some element of it.
pub fn pick_nearest(
    mesh: &Mesh,
    tree: &FaceTree,
    camera: &Camera,
    viewport: Vec2,
    pixel: Vec2,
    kind: Element,
    radius: f32,
) -> Option<Picked> {
    if let Some(picked) = pick(mesh, tree, camera, viewport, pixel, kind, radius) {
        return Some(picked);
    }
    let face = tree.hit(mesh, camera.ray(pixel, viewport))?.face;
    let (sight, faces) = (Sight::new(mesh, tree, camera, viewport), BTreeSet::from([face]));
    if kind == Element::Vertex {
        return pick_vertex(&sight, &faces, pixel, f32::INFINITY);
    }
    let (edge, distance) = pick_edge(&sight, &faces, pixel, f32::INFINITY)?;
    let id = if kind == Element::Halfedge { side_of(&sight, edge, Some(face)).raw() } else { edge.raw() };
    Some(Picked { element: kind, id, distance })
}

/// The face nearest to a pixel's ray that hits none: a thin corner may lie between the rays around it.
/// Alternates between the point of the mesh closest to the ray's point and the point of the ray closest to
/// that one, which converges.
fn closest_to_ray(sight: &Sight<'_>, pixel: Vec2) -> Option<FaceId> {
    let ray = sight.camera.ray(pixel, sight.viewport);
    let (origin, direction) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let mut along = (sight.camera.target - origin).dot(direction);
    let mut face = None;
    for _ in 0..8 {
        let closest = sight.tree.closest_point(sight.mesh, (origin + direction * along).as_vec3())?;
        face = Some(closest.face);
        along = (closest.point.as_dvec3() - origin).dot(direction);
    }
    face
}

/// The faces and those that share a vertex with one of them.
fn with_neighbors(mesh: &Mesh, faces: &[FaceId]) -> BTreeSet<FaceId> {
    let mut all: BTreeSet<FaceId> = faces.iter().copied().collect();
    for &face in faces {
        for v in mesh.face_vertices(face) {
            for neighbor in mesh.vertex_faces(v) {
                if all.len() >= MAX_CANDIDATE_FACES {
                    return all;
                }
                all.insert(neighbor);
            }
        }
    }
    all
}

fn pick_vertex(sight: &Sight<'_>, faces: &BTreeSet<FaceId>, pixel: Vec2, radius: f32) -> Option<Picked> {
    let mesh = sight.mesh;
    let vertices: BTreeSet<_> = faces.iter().flat_map(|&f| mesh.face_vertices(f)).collect();
    // No ray hits an isolated vertex.
    let first = mesh.connectivity().vertex_halfedge.iter().enumerate();
    let alone = first.filter(|(_, h)| **h == halfedge::NONE).filter_map(|(v, _)| mesh.vertex(v as u32));
    let near = vertices.into_iter().chain(alone).filter_map(|v| {
        let away = sight.project(mesh.position(v))?.distance(pixel);
        (away <= radius).then_some((away, v))
    });
    nearest_first(near).into_iter().find_map(|(_, v)| {
        let seen = |f: FaceId| mesh.face_vertices(f).any(|w| w == v);
        let distance = sight.sees(mesh.position(v), seen)?;
        Some(Picked { element: Element::Vertex, id: v.raw(), distance })
    })
}

fn pick_edge(sight: &Sight<'_>, faces: &BTreeSet<FaceId>, pixel: Vec2, radius: f32) -> Option<(EdgeId, f64)> {
    let mesh = sight.mesh;
    let edges: BTreeSet<EdgeId> =
        faces.iter().flat_map(|&f| mesh.face_halfedges(f)).map(HalfedgeId::edge).collect();
    let near = edges.into_iter().filter_map(|e| {
        let segment = sight.segment(e)?;
        let (t, away) = segment.nearest(pixel);
        (away <= radius).then(|| (away, (e, sight.point_on(&segment, t))))
    });
    nearest_first(near)
        .into_iter()
        .find_map(|(_, (edge, point))| Some((edge, sight.sees_edge_at(edge, point)?)))
}

fn nearest_first<T>(candidates: impl Iterator<Item = (f32, T)>) -> Vec<(f32, T)> {
    let mut candidates: Vec<_> = candidates.collect();
    candidates.sort_by(|a, b| a.0.total_cmp(&b.0));
    candidates
}

/// The half-edge of an edge to pick while the pointer is over the face `under`.
fn side_of(sight: &Sight<'_>, edge: EdgeId, under: Option<FaceId>) -> HalfedgeId {
    let mesh = sight.mesh;
    let sides = edge.halfedges();
    let over = |h: &HalfedgeId| under.is_some() && mesh.face_of(*h) == under;
    let outside = |h: &HalfedgeId| mesh.is_boundary_halfedge(*h);
    let towards = |h: &HalfedgeId| {
        mesh.face_of(*h).is_some_and(|f| {
            let to_eye = if sight.camera.orthographic {
                -sight.camera.axes()[2]
            } else {
                sight.camera.eye() - mesh.position(mesh.from(*h)).as_dvec3()
            };
            halfedge::geometry::face_area_vector(mesh, f).dot(to_eye) > 0.0
        })
    };
    let found = sides
        .into_iter()
        .find(over)
        .or_else(|| sides.into_iter().find(outside))
        .or_else(|| sides.into_iter().find(towards));
    found.unwrap_or(edge.halfedge())
}
