//! The elements at the mirror images of others, for symmetric edits.

use glam::{DVec3, Vec3};
use halfedge::{EdgeId, FaceId, HalfedgeId, Mesh, VertexId};
use rustc_hash::FxHashMap;

/// How far from a mirror image its vertex may be, as a share of the largest coordinate.
const TOLERANCE_SHARE: f64 = 1e-4;

/// A direction that few models are aligned with, so that few vertices are at the same place along it.
const SORTED_ALONG: DVec3 = DVec3::new(0.597, 0.3917, 0.7001);

/// How far a position that an edit has made may be from its mirror image for rounding to be the reason, as a share of the
/// largest coordinate.
pub(crate) const ROUNDING_SHARE: f64 = 1e-5;

/// The elements of a mesh at the mirror images of others, across the plane through the origin that an axis (0 to 2) is
/// normal to. Vertices are looked up once and remembered, so the mesh must stay as it is in between.
///
/// The image of a vertex is the vertex nearest to its mirror image, within 1/10,000 of the mesh's largest coordinate: itself
/// if it lies in the plane, none if no vertex is near. The image of an edge or a face is that between the images of its
/// vertices.
#[derive(Clone, Debug)]
pub struct MirrorImages {
    axis: usize,
    /// The largest coordinate.
    largest: f64,
    found: FxHashMap<VertexId, Option<VertexId>>,
}

impl MirrorImages {
    /// Images of no vertex yet. Costs O(vertices).
    pub fn new(mesh: &Mesh, axis: usize) -> Self {
        let coordinates = mesh.vertices().map(|v| mesh.position(v).abs().max_element());
        Self { axis, largest: f64::from(coordinates.fold(0.0, f32::max)), found: FxHashMap::default() }
    }

    /// The number of the axis.
    pub fn axis(&self) -> usize {
        self.axis
    }

    /// The largest coordinate of the mesh.
    pub(crate) fn largest(&self) -> f64 {
        self.largest
    }

    /// How far from a mirror image its vertex may be.
    pub(crate) fn tolerance(&self) -> f64 {
        self.largest * TOLERANCE_SHARE
    }

    /// What looking up the image of a vertex has found; none if it was not looked up.
    pub(crate) fn found(&self, v: VertexId) -> Option<Option<VertexId>> {
        self.found.get(&v).copied()
    }

    /// Looks up the images of vertices. Costs O(k) if they are known, else O(n log k) for k of n vertices.
    pub fn look_up(&mut self, mesh: &Mesh, vertices: impl IntoIterator<Item = VertexId>) {
        let mut new: Vec<VertexId> = vertices.into_iter().filter(|v| !self.found.contains_key(v)).collect();
        new.sort_unstable();
        new.dedup();
        if !new.is_empty() {
            let images = nearest_images(mesh, &new, mesh.vertices(), self.axis, self.tolerance());
            self.found.extend(new.into_iter().zip(images));
        }
    }

    /// The image of a vertex that was looked up.
    pub fn vertex(&self, v: VertexId) -> Option<VertexId> {
        self.found.get(&v).copied().flatten()
    }

    /// The image of a half-edge whose vertices were looked up. It runs the other way, so that its face is on the same side.
    pub fn halfedge(&self, mesh: &Mesh, h: HalfedgeId) -> Option<HalfedgeId> {
        mesh.find_halfedge(self.vertex(mesh.to(h))?, self.vertex(mesh.from(h))?)
    }

    /// The image of an edge whose vertices were looked up.
    pub fn edge(&self, mesh: &Mesh, edge: EdgeId) -> Option<EdgeId> {
        self.halfedge(mesh, edge.halfedge()).map(HalfedgeId::edge)
    }

    /// The image of a face whose vertices were looked up.
    pub fn face(&self, mesh: &Mesh, face: FaceId) -> Option<FaceId> {
        let image = mesh.face_of(self.halfedge(mesh, mesh.halfedge_of(face))?)?;
        let is_side = |h| self.halfedge(mesh, h).is_some_and(|side| mesh.face_of(side) == Some(image));
        let is_image =
            mesh.face_halfedges(face).all(is_side) && mesh.face_degree(image) == mesh.face_degree(face);
        is_image.then_some(image)
    }

    /// Makes the positions of moved vertices mirror images to the bit where only rounding keeps them from it: those on the
    /// negative side are set from those on the positive side, and those in the plane are put into it. Costs O(k log k).
    pub fn settle(&self, mesh: &mut Mesh, moved: &[VertexId]) {
        let tolerance = self.largest * ROUNDING_SHARE;
        let images = nearest_images(mesh, moved, moved.iter().copied(), self.axis, tolerance);
        let coordinate = |at: Vec3| at.to_array().get(self.axis).copied().unwrap_or_default();
        let mut settled = Vec::new();
        for (&v, image) in moved.iter().zip(images) {
            let at = mesh.position(v);
            let stays_in_plane = self.found.get(&v) == Some(&Some(v));
            if image == Some(v) || stays_in_plane {
                settled.push((v, (at + mirrored(at, self.axis)) * 0.5));
            } else if let Some(image) = image.map(|image| mesh.position(image))
                && coordinate(at) < 0.0
                && coordinate(image) >= 0.0
            {
                settled.push((v, mirrored(image, self.axis)));
            }
        }
        for (v, at) in settled {
            mesh.set_position(v, at);
        }
    }
}

/// For each of these vertices, the nearest candidate within the tolerance to its mirror image. Costs O(n log k) for k
/// vertices and n candidates.
pub(crate) fn nearest_images(
    mesh: &Mesh,
    vertices: &[VertexId],
    candidates: impl Iterator<Item = VertexId>,
    axis: usize,
    tolerance: f64,
) -> Vec<Option<VertexId>> {
    let place = |at: DVec3| at.dot(SORTED_ALONG);
    let mut images: Vec<(f64, usize, DVec3)> = vertices
        .iter()
        .enumerate()
        .map(|(index, v)| {
            let image = mirrored(mesh.position(*v), axis).as_dvec3();
            (place(image), index, image)
        })
        .collect();
    images.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
    let mut nearest = vec![(tolerance, None); vertices.len()];
    // A place differs by at most the length of the direction times the distance.
    let reach = tolerance * SORTED_ALONG.length();
    for v in candidates {
        let at = mesh.position(v).as_dvec3();
        let here = place(at);
        let first = images.partition_point(|image| image.0 < here - reach);
        for (_, index, image) in images.iter().skip(first).take_while(|image| image.0 <= here + reach) {
            let Some(best) = nearest.get_mut(*index) else { continue };
            let distance = image.distance(at);
            // In the plane, the vertex itself is meant, and the earlier one of two.
            let is_itself = vertices.get(*index) == Some(&v);
            if distance < best.0 || (distance == best.0 && (best.1.is_none() || is_itself)) {
                *best = (distance, Some(v));
            }
        }
    }
    nearest.into_iter().map(|(_, v)| v).collect()
}

/// The mirror image of a point or a movement across the plane through the origin that an axis (0 to 2) is normal to.
pub fn mirrored(point: Vec3, axis: usize) -> Vec3 {
    let mut image = point.to_array();
    if let Some(coordinate) = image.get_mut(axis) {
        *coordinate = -*coordinate;
    }
    image.into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Shape;
    use halfedge::geometry::mean_position;

    fn shape(name: &str) -> Mesh {
        Shape::named(name).expect("a shape").build().expect("a mesh")
    }

    #[test]
    fn images_are_where_they_should_be() {
        for name in ["cube", "uv-sphere", "torus", "grid"] {
            let mesh = shape(name);
            for axis in [0, 2] {
                let mut images = MirrorImages::new(&mesh, axis);
                images.look_up(&mesh, mesh.vertices());
                for v in mesh.vertices() {
                    let (at, image) = (mesh.position(v), images.vertex(v).expect("symmetric"));
                    assert!(mesh.position(image).distance(mirrored(at, axis)) < 1e-4, "{name}: {v}");
                    assert_eq!(image == v, at[axis].abs() < 5e-5, "{name}: {v}");
                }
                let middle = |f| mean_position(&mesh, mesh.face_vertices(f)).as_vec3();
                for face in mesh.faces() {
                    let image = images.face(&mesh, face).expect("symmetric");
                    assert_eq!(images.face(&mesh, image), Some(face), "{name}: {face}");
                    let (at, image) = (middle(face), middle(image));
                    assert!(image.distance(mirrored(at, axis)) < 1e-4, "{name}: {face}");
                }
                for edge in mesh.edges() {
                    let image = images.edge(&mesh, edge).expect("symmetric");
                    assert_eq!(images.edge(&mesh, image), Some(edge), "{name}: {edge}");
                }
            }
        }
    }

    #[test]
    fn a_vertex_without_its_image_has_none() {
        let mut mesh = shape("cube");
        let v = VertexId::new(7);
        mesh.set_position(v, Vec3::new(1.0, 1.1, 1.0));
        let other =
            mesh.vertices().find(|u| mesh.position(*u) == Vec3::new(-1.0, 1.0, 1.0)).expect("a corner");
        let mut images = MirrorImages::new(&mesh, 0);
        images.look_up(&mesh, mesh.vertices());
        assert_eq!([images.vertex(v), images.vertex(other)], [None, None]);
        let beside = mesh.outgoing(v).find_map(|h| mesh.face_of(h)).expect("a face");
        assert_eq!(images.face(&mesh, beside), None);
    }

    #[test]
    fn rounding_is_settled_and_what_differs_stays() {
        let mut mesh = shape("cube");
        let at = |mesh: &Mesh, wanted: Vec3| {
            mesh.vertices().find(|v| mesh.position(*v) == wanted).expect("a corner of the cube")
        };
        let [right, left] = [at(&mesh, Vec3::ONE), at(&mesh, Vec3::new(-1.0, 1.0, 1.0))];
        let [up, down] = [at(&mesh, Vec3::new(1.0, 1.0, -1.0)), at(&mesh, Vec3::new(-1.0, 1.0, -1.0))];
        mesh.set_position(left, Vec3::new(-1.000_000_1, 1.0, 0.999_999_9));
        mesh.set_position(down, Vec3::new(-1.001, 1.0, -1.0));
        let all: Vec<VertexId> = mesh.vertices().collect();
        MirrorImages::new(&mesh, 0).settle(&mut mesh, &all);
        assert_eq!([mesh.position(right), mesh.position(left)], [Vec3::ONE, Vec3::new(-1.0, 1.0, 1.0)]);
        assert_eq!([mesh.position(up).x, mesh.position(down).x], [1.0, -1.001]);
    }
}
