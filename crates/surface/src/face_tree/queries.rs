//! Ray and closest point queries.

use super::triangle::{closest_in_triangle, intersect};
use super::{FaceTree, Hit, Ray};
use crate::measure::Bounds;
use glam::{DVec3, Vec3};
use halfedge::geometry::PolygonTriangulator;
use halfedge::{FaceId, HalfedgeId, Mesh};

impl FaceTree {
    /// The first point where the ray hits a face, from either side; of two at the same distance, the one on the
    /// face with the smaller id. There are no gaps between neighbouring faces. A ray with a direction that is
    /// zero or not finite hits nothing.
    pub fn hit(&self, mesh: &Mesh, ray: Ray) -> Option<Hit> {
        let origin = ray.origin.as_dvec3();
        let direction = ray.direction.as_dvec3().try_normalize()?;
        if !origin.is_finite() {
            return None;
        }
        // Instead of an infinite inverse, one that no coordinate can bring back into range.
        let inverse = DVec3::from_array(direction.to_array().map(|d| if d == 0.0 { 1e300 } else { 1.0 / d }));
        let enters = |bounds: &Bounds| {
            let a = (bounds.min.as_dvec3() - origin) * inverse;
            let b = (bounds.max.as_dvec3() - origin) * inverse;
            let enter = a.min(b).max_element();
            // Rounding of the products must not let a ray miss a face in the box's side.
            let leave = a.max(b).min_element() * (1.0 + 1e-15);
            if enter <= leave && leave >= 0.0 { enter * (1.0 - 1e-15) } else { f64::INFINITY }
        };
        let mut best: Option<Hit> = None;
        let mut triangulator = PolygonTriangulator::new();
        self.visit(mesh, enters, f64::MAX, |face, bound| {
            let mut bound = bound;
            for &corners in triangulator.triangulate_face(mesh, face) {
                let points = corners.map(|h| mesh.position(mesh.from(h)).as_dvec3() - origin);
                let Some((distance, weights)) = intersect(points, direction) else { continue };
                let nearer = best.is_none_or(|hit| {
                    distance < hit.distance || (distance == hit.distance && face < hit.face)
                });
                if nearer {
                    bound = distance;
                    best = Some(Hit {
                        face,
                        distance,
                        point: (origin + direction * distance).as_vec3(),
                        corners,
                        barycentric: weights.as_vec3().to_array(),
                    });
                }
            }
            bound
        });
        best
    }

    /// The point of the mesh closest to `point`; none for a mesh without faces or a point that isn't finite.
    pub fn closest_point(&self, mesh: &Mesh, point: Vec3) -> Option<Hit> {
        let point = point.as_dvec3();
        if !point.is_finite() {
            return None;
        }
        let away = |bounds: &Bounds| {
            if bounds.min.x > bounds.max.x {
                return f64::INFINITY;
            }
            point.clamp(bounds.min.as_dvec3(), bounds.max.as_dvec3()).distance_squared(point)
        };
        let mut best: Option<Hit> = None;
        let mut best_squared = f64::MAX;
        let mut triangulator = PolygonTriangulator::new();
        let mut try_triangle = |face: FaceId, corners: [HalfedgeId; 3]| {
            let points = corners.map(|h| mesh.position(mesh.from(h)));
            // Most triangles of a leaf are too far away by their box already.
            let bounds = Bounds::EMPTY.with(points[0]).with(points[1]).with(points[2]);
            if away(&bounds) > best_squared {
                return best_squared;
            }
            let points = points.map(|p| p.as_dvec3());
            let weights = closest_in_triangle(points, point);
            let at = points[0] * weights.x + points[1] * weights.y + points[2] * weights.z;
            let squared = at.distance_squared(point);
            let nearer =
                best.is_none_or(|hit| squared < best_squared || (squared == best_squared && face < hit.face));
            if nearer {
                best_squared = squared;
                best = Some(Hit {
                    face,
                    distance: squared.sqrt(),
                    point: at.as_vec3(),
                    corners,
                    barycentric: weights.as_vec3().to_array(),
                });
            }
            best_squared
        };
        let look = |face: FaceId, _: f64| {
            let first = mesh.halfedge_of(face);
            let (second, last) = (mesh.next(first), mesh.prev(first));
            if mesh.next(second) == last {
                return try_triangle(face, [first, second, last]);
            }
            triangulator
                .triangulate_face(mesh, face)
                .iter()
                .fold(f64::MAX, |_, &corners| try_triangle(face, corners))
        };
        self.visit(mesh, away, f64::MAX, look);
        best
    }
}
