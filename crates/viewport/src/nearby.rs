//! The elements around a place on the screen, for their numbers.

use crate::Camera;
use crate::sight::Sight;
use glam::{Vec2, Vec3};
use halfedge::{EdgeId, Element, FaceId, Mesh, VertexId};
use std::collections::{HashSet, VecDeque};
use surface::FaceTree;
use surface::measure::face_center;

/// The search ends after so many faces.
const MAX_FACES_SEARCHED: usize = 400;

/// An element near a place on the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearby {
    /// The element's kind.
    pub kind: Element,
    /// The element's id.
    pub id: u32,
    /// Where it is on the screen: a vertex, the middle of an edge or of a face.
    pub pixel: Vec2,
}

/// Which elements around a place are wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Around {
    /// The place, in pixels.
    pub pixel: Vec2,
    /// How far from it, in pixels.
    pub radius: f32,
    /// Elements less than this far apart in x and in y count once: the one nearest to the place.
    pub gap: Vec2,
    /// The most elements.
    pub limit: usize,
}

/// The vertices, edges and faces around a place that nothing hides, nearest first. The search spreads from the face at
/// the place over neighbouring faces, so what it costs doesn't depend on the mesh.
pub fn elements_near(
    (mesh, tree): (&Mesh, &FaceTree),
    camera: &Camera,
    viewport: Vec2,
    around: Around,
) -> Vec<Nearby> {
    let Around { pixel, radius, gap, limit } = around;
    let Some(hit) = tree.hit(mesh, camera.ray(pixel, viewport)) else { return Vec::new() };
    let sight = Sight::new(mesh, tree, camera, viewport);
    let mut found: Vec<(f32, Nearby, Vec3)> = Vec::new();
    let mut add = |kind, id, point: Vec3| {
        let Some(at) = sight.project(point) else { return false };
        let away = at.distance(pixel);
        if away <= radius {
            found.push((away, Nearby { kind, id, pixel: at }, point));
        }
        away <= radius
    };
    let mut seen: HashSet<(Element, u32)> = HashSet::from([(Element::Face, hit.face.raw())]);
    let mut queue = VecDeque::from([hit.face]);
    let mut faces = 0;
    while let Some(face) = queue.pop_front().filter(|_| faces < MAX_FACES_SEARCHED) {
        faces += 1;
        let mut is_near = add(Element::Face, face.raw(), face_center(mesh, face).as_vec3());
        for h in mesh.face_halfedges(face) {
            let [a, b] = [mesh.from(h), mesh.to(h)].map(|v| mesh.position(v));
            if seen.insert((Element::Vertex, mesh.from(h).raw())) {
                is_near |= add(Element::Vertex, mesh.from(h).raw(), a);
            }
            if seen.insert((Element::Edge, h.edge().raw())) {
                is_near |= add(Element::Edge, h.edge().raw(), (a + b) * 0.5);
            }
        }
        if is_near || face == hit.face {
            let neighbours = mesh.face_halfedges(face).filter_map(|h| mesh.face_of(h.twin()));
            queue.extend(neighbours.filter(|f| seen.insert((Element::Face, f.raw()))));
        }
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut kept: Vec<Nearby> = Vec::new();
    for (_, near, point) in found {
        let is_free = |other: &Nearby| (other.pixel - near.pixel).abs().cmpge(gap).any();
        if kept.len() < limit && kept.iter().all(is_free) && is_seen(&sight, near, point) {
            kept.push(near);
        }
    }
    kept
}

fn is_seen(sight: &Sight<'_>, near: Nearby, point: Vec3) -> bool {
    let mesh = sight.mesh;
    let index = near.id as usize;
    let own = |f: FaceId| match near.kind {
        Element::Vertex => mesh.face_vertices(f).any(|v| v == VertexId::new(index)),
        Element::Edge | Element::Halfedge => mesh.face_halfedges(f).any(|h| h.edge() == EdgeId::new(index)),
        Element::Face => f == FaceId::new(index),
    };
    sight.sees(point, own).is_some()
}
