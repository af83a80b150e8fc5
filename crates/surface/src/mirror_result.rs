//! Whether the result of a symmetric edit is its own mirror image.
//!
//! Edits of elements on both sides of the mirror's plane are made one after the other. Where both change the same faces, the
//! second one meets what the first one has made: its connections may be mirror images all the same, with positions that are
//! not. So connections decide. The images of half-edges are followed from elements that were left alone through everything
//! that was written; if all have one, positions are made mirror images too.

use crate::mirror_images::{ROUNDING_SHARE, nearest_images};
use crate::{MirrorImages, mirrored};
use glam::Vec3;
use halfedge::{FaceId, HalfedgeId, Mesh, Touched, VertexId};
use rustc_hash::{FxHashMap, FxHashSet};

impl MirrorImages {
    /// Makes the result of a symmetric edit its own mirror image to the bit, if its connections are: vertices that the edit
    /// has moved or made go where their image says, and of two such ones halfway. Returns whether it is.
    ///
    /// `self` holds the images before the edit, `mesh` is recording it, and `made_from` is the number of vertices before it.
    /// Costs O(k log k) for k written elements, and O(n) more in a mesh of n vertices where vertices beside them were not
    /// looked up.
    pub fn settle_result(&self, mesh: &mut Mesh, made_from: usize) -> bool {
        let touched = mesh.recorded();
        let faces = faces_of(mesh, &touched);
        if are_mirrored(mesh, &faces, self.axis()) {
            return true;
        }
        let moved: FxHashMap<VertexId, Vec3> = mesh.recorded_moves().into_iter().collect();
        let Some(pairs) = Follow::new(self, mesh, &touched, &faces, &moved, made_from).follow() else {
            return false;
        };
        let [rounding, tolerance] =
            [ROUNDING_SHARE * self.largest(), self.tolerance()].map(|length| length as f32);
        let mut settled = Vec::new();
        for (v, image) in pairs.into_iter().filter(|(v, image)| v <= image) {
            let (at, wanted) = (mesh.position(v), mirrored(mesh.position(image), self.axis()));
            let apart = at.distance(wanted);
            let place = match [v, image].map(|v| moved.contains_key(&v)) {
                // What was left alone stays where it is, so its image has to be the one that it had.
                [false, false] if apart > tolerance => return false,
                [false, false] => continue,
                [true, false] => wanted,
                [true, true] if v == image || apart > rounding => (at + wanted) * 0.5,
                _ => at,
            };
            settled.push((v, place));
            if v != image {
                settled.push((image, mirrored(place, self.axis())));
            }
        }
        for (v, at) in settled {
            mesh.set_position(v, at);
        }
        true
    }

    /// Whether each of these faces has a mirror image in the mesh.
    pub fn have_images(mesh: &Mesh, axis: usize, faces: &[FaceId]) -> bool {
        let mut images = Self::new(mesh, axis);
        images.look_up(mesh, faces.iter().flat_map(|f| mesh.face_vertices(*f)));
        faces.iter().all(|f| images.face(mesh, *f).is_some())
    }
}

/// The faces that exist and that were written, or sides of them.
pub fn faces_of(mesh: &Mesh, touched: &Touched) -> Vec<FaceId> {
    let sides = touched.halfedges.iter().filter(|h| mesh.has_halfedge(**h));
    let mut faces: Vec<FaceId> = sides.filter_map(|h| mesh.face_of(*h)).collect();
    faces.extend(touched.faces.iter().filter(|f| mesh.has_face(**f)));
    faces.sort_unstable();
    faces.dedup();
    faces
}

/// Whether faces are mirror images of each other to the bit.
fn are_mirrored(mesh: &Mesh, faces: &[FaceId], axis: usize) -> bool {
    let mut numbers: FxHashMap<[u32; 3], usize> = FxHashMap::default();
    let mut number = |at: Vec3| {
        let next = numbers.len();
        // Zero has two signs.
        *numbers.entry((at + Vec3::ZERO).to_array().map(f32::to_bits)).or_insert(next)
    };
    let mut counts: FxHashMap<Vec<usize>, i32> = FxHashMap::default();
    for &face in faces {
        let places: Vec<usize> = mesh.face_vertices(face).map(|v| number(mesh.position(v))).collect();
        let mut images: Vec<usize> =
            mesh.face_vertices(face).map(|v| number(mirrored(mesh.position(v), axis))).collect();
        images.reverse();
        *counts.entry(from_least(places)).or_default() += 1;
        *counts.entry(from_least(images)).or_default() -= 1;
    }
    counts.values().all(|count| *count == 0)
}

/// A cycle of numbers, begun so that it is the least.
fn from_least(mut cycle: Vec<usize>) -> Vec<usize> {
    let turned = |by: usize| cycle.iter().cycle().skip(by).take(cycle.len());
    let least = cycle.iter().min();
    let starts = (0..cycle.len()).filter(|at| cycle.get(*at) == least);
    let first = starts.min_by(|a, b| turned(*a).cmp(turned(*b))).unwrap_or(0);
    cycle.rotate_left(first);
    cycle
}

/// Follows mirror images from half-edge to half-edge.
struct Follow<'a> {
    mesh: &'a Mesh,
    /// The half-edges that need an image: those of written faces and those that were written.
    needed: FxHashSet<HalfedgeId>,
    /// Half-edges to begin at, with their images.
    seeds: Vec<(HalfedgeId, HalfedgeId)>,
    halfedges: FxHashMap<HalfedgeId, HalfedgeId>,
    vertices: FxHashMap<VertexId, VertexId>,
}

impl<'a> Follow<'a> {
    fn new(
        images: &MirrorImages,
        mesh: &'a Mesh,
        touched: &Touched,
        faces: &[FaceId],
        moved: &FxHashMap<VertexId, Vec3>,
        made_from: usize,
    ) -> Self {
        let written = touched.halfedges.iter().copied().filter(|h| mesh.has_halfedge(*h));
        let sides = faces.iter().flat_map(|f| mesh.face_halfedges(*f));
        let needed: FxHashSet<HalfedgeId> = written.chain(sides).flat_map(|h| [h, h.twin()]).collect();
        let mut around: Vec<VertexId> = needed.iter().map(|h| mesh.from(*h)).collect();
        around.sort_unstable();
        around.dedup();
        let (left_alone, others): (Vec<_>, Vec<_>) =
            around.into_iter().partition(|v| v.index() < made_from && !moved.contains_key(v));
        // Vertices that were left alone have the images that they had.
        let mut known: FxHashMap<VertexId, VertexId> = FxHashMap::default();
        let mut unknown = Vec::new();
        for v in left_alone {
            match images.found(v) {
                Some(Some(image)) => drop(known.insert(v, image)),
                Some(None) => {}
                None => unknown.push(v),
            }
        }
        let tolerance = images.tolerance();
        let mut near = |vertices: &[VertexId], candidates: &mut dyn Iterator<Item = VertexId>| {
            let found = nearest_images(mesh, vertices, candidates, images.axis(), tolerance);
            known.extend(vertices.iter().zip(found).filter_map(|(v, image)| Some((*v, image?))));
        };
        if !unknown.is_empty() {
            near(&unknown, &mut mesh.vertices());
        }
        near(&others, &mut others.iter().copied());
        let is_alone = |v: &VertexId| !moved.contains_key(v);
        let mut seeds: Vec<(bool, HalfedgeId, HalfedgeId)> = Vec::new();
        for &h in &needed {
            let ends = [mesh.from(h), mesh.to(h)];
            let [Some(&from), Some(&to)] = ends.map(|v| known.get(&v)) else { continue };
            if mesh.has_vertex(from)
                && mesh.has_vertex(to)
                && let Some(image) = mesh.find_halfedge(to, from)
            {
                let is_alone = ends.iter().all(is_alone) && [from, to].iter().all(is_alone);
                seeds.push((!is_alone, h, image));
            }
        }
        // Those that were left alone first.
        seeds.sort_unstable();
        let seeds = seeds.into_iter().map(|(_, h, image)| (h, image)).collect();
        Self { mesh, needed, seeds, halfedges: FxHashMap::default(), vertices: FxHashMap::default() }
    }

    /// The images of the vertices of everything that needs one; none where the connections are no mirror images.
    fn follow(mut self) -> Option<FxHashMap<VertexId, VertexId>> {
        for (h, image) in std::mem::take(&mut self.seeds) {
            if !self.halfedges.contains_key(&h) {
                self.follow_from(h, image)?;
            }
        }
        self.needed.iter().all(|h| self.halfedges.contains_key(h)).then_some(self.vertices)
    }

    fn follow_from(&mut self, h: HalfedgeId, image: HalfedgeId) -> Option<()> {
        let mesh = self.mesh;
        let mut next = vec![(h, image)];
        while let Some((h, image)) = next.pop() {
            if let Some(known) = self.halfedges.get(&h) {
                if *known != image {
                    return None;
                }
                continue;
            }
            if mesh.face_of(h).is_some() != mesh.face_of(image).is_some() {
                return None;
            }
            self.halfedges.insert(h, image);
            for (v, image) in [(mesh.from(h), mesh.to(image)), (mesh.to(h), mesh.from(image))] {
                if *self.vertices.entry(v).or_insert(image) != image {
                    return None;
                }
            }
            next.push((image, h));
            if self.needed.contains(&h) || self.needed.contains(&image) {
                next.push((h.twin(), image.twin()));
                next.push((mesh.next(h), mesh.prev(image)));
                next.push((mesh.prev(h), mesh.next(image)));
            }
        }
        Some(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Shape;
    use halfedge::edit;

    #[test]
    fn a_cycle_begins_where_it_is_least() {
        assert_eq!(from_least(vec![3, 1, 2]), [1, 2, 3]);
        assert_eq!(from_least(vec![1, 3, 1, 2]), [1, 2, 1, 3]);
        assert_eq!(from_least(Vec::new()), [0; 0]);
    }

    /// The cube, with the vertex at each of these positions.
    fn cube<const N: usize>(at: [[f32; 3]; N]) -> (Mesh, [VertexId; N]) {
        let mut mesh = Shape::named("cube").expect("a shape").build().expect("a mesh");
        let find = |at: [f32; 3]| mesh.vertices().find(|v| mesh.position(*v).to_array() == at);
        let vertices = at.map(|at| find(at).expect("a corner"));
        mesh.start_recording();
        (mesh, vertices)
    }

    fn settle(mesh: &mut Mesh, made_from: usize, before: &Mesh) -> bool {
        let mut images = MirrorImages::new(before, 0);
        images.look_up(before, before.vertices());
        images.settle_result(mesh, made_from)
    }

    #[test]
    fn mirrored_connections_get_mirrored_positions() {
        let (mut mesh, [right, left]) = cube([[1.0, 1.0, 1.0], [-1.0, 1.0, 1.0]]);
        let before = mesh.clone();
        let edge = mesh.find_edge(right, left).expect("an edge");
        let made = edit::split_edge(&mut mesh, edge, 0.25, edit::Connect::None).expect("possible");
        assert!(settle(&mut mesh, before.vertex_capacity(), &before));
        assert_eq!(mesh.position(made.vertex), Vec3::new(0.0, 1.0, 1.0));
    }

    #[test]
    fn a_diagonal_across_the_plane_is_no_mirror_image() {
        let (mut mesh, [a, b]) = cube([[1.0, 1.0, 1.0], [-1.0, -1.0, 1.0]]);
        let before = mesh.clone();
        edit::connect_vertices(&mut mesh, a, b).expect("possible");
        let after = mesh.clone();
        assert!(!settle(&mut mesh, before.vertex_capacity(), &before));
        assert_eq!(mesh, after);
        assert!(MirrorImages::have_images(&before, 0, &faces_of(&before, &mesh.recorded())));
        assert!(!MirrorImages::have_images(&mesh, 0, &faces_of(&mesh, &mesh.recorded())));
    }
}
