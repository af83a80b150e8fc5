//! A mesh as seen through a camera: shared by picking and region selection.

use crate::Camera;
use crate::projector::Projector;
use crate::region::ScreenRect;
use glam::{Vec2, Vec3};
use halfedge::{EdgeId, FaceId, Mesh};
use surface::FaceTree;
use surface::measure::Bounds;

/// A point counts as on a surface up to this far behind it, as a fraction of its distance from the eye.
const SURFACE_TOLERANCE: f64 = 3e-5;

/// A mesh with the camera and viewport that it is seen through.
#[derive(Clone, Copy)]
pub struct Sight<'a> {
    pub mesh: &'a Mesh,
    pub tree: &'a FaceTree,
    pub camera: &'a Camera,
    pub viewport: Vec2,
    view: Projector,
}

/// The part of an edge in front of the eye.
pub struct Segment {
    /// The ends in space.
    ends: [Vec3; 2],
    /// The ends on the screen.
    pub pixels: [Vec2; 2],
}

impl<'a> Sight<'a> {
    pub fn new(mesh: &'a Mesh, tree: &'a FaceTree, camera: &'a Camera, viewport: Vec2) -> Self {
        Self { mesh, tree, camera, viewport, view: camera.projector(viewport) }
    }

    pub fn project(&self, point: Vec3) -> Option<Vec2> {
        self.view.project(point).map(|(pixel, _)| pixel)
    }

    pub fn view(&self) -> &Projector {
        &self.view
    }

    /// Whether something in this box may be seen in a rectangle; certain if not.
    pub fn may_overlap(&self, bounds: &Bounds, rect: &ScreenRect) -> bool {
        let Bounds { min, max } = *bounds;
        if min.x > max.x {
            return false;
        }
        let ends = [min, max];
        let mut around = ScreenRect::around([]);
        for corner in 0..8 {
            let [Some(x), Some(y), Some(z)] =
                [corner & 1, corner >> 1 & 1, corner >> 2].map(|end| ends.get(end))
            else {
                return true;
            };
            match self.project(Vec3::new(x.x, y.y, z.z)) {
                Some(pixel) => around = ScreenRect { min: around.min.min(pixel), max: around.max.max(pixel) },
                // The box reaches behind the eye.
                None => return true,
            }
        }
        around.overlaps(rect)
    }

    /// The distance of a point from the eye, or with a parallel projection from where its ray starts.
    pub fn distance(&self, point: Vec3) -> Option<f64> {
        let ray = self.camera.ray(self.project(point)?, self.viewport);
        Some((point.as_dvec3() - ray.origin.as_dvec3()).dot(ray.direction.as_dvec3()))
    }

    /// The distance of a point from the eye, if nothing is in front of it but faces for which `own` is true.
    pub fn sees(&self, point: Vec3, own: impl Fn(FaceId) -> bool) -> Option<f64> {
        let ray = self.camera.ray(self.project(point)?, self.viewport);
        let away = (point.as_dvec3() - ray.origin.as_dvec3()).dot(ray.direction.as_dvec3());
        // Rays of a parallel projection start far in front of everything, so the view's size is used.
        let slack = SURFACE_TOLERANCE * if self.camera.orthographic { self.camera.distance } else { away };
        let hidden =
            self.tree.hit(self.mesh, ray).is_some_and(|hit| hit.distance < away - slack && !own(hit.face));
        (!hidden).then_some(away)
    }

    /// The distance of a point of an edge from the eye, if nothing is in front of it but the edge's faces and those for
    /// which `clear` is true.
    pub fn sees_edge_at(&self, edge: EdgeId, point: Vec3, clear: impl Fn(FaceId) -> bool) -> Option<f64> {
        let beside = edge.halfedges().map(|h| self.mesh.face_of(h));
        self.sees(point, |f| beside.contains(&Some(f)) || clear(f))
    }

    /// The part of an edge that is in front of the eye.
    pub fn segment(&self, edge: EdgeId) -> Option<Segment> {
        let mut ends = self.mesh.ends(edge).map(|v| self.mesh.position(v));
        if !self.camera.orthographic {
            // A little beyond the near plane, so that rounding doesn't lose the end again.
            let near = self.view.near * 1.001;
            let [a, b] = ends.map(|p| self.view.depth(p));
            if a < near && b < near {
                return None;
            }
            let cut = |t: f64| ends[0].as_dvec3().lerp(ends[1].as_dvec3(), t).as_vec3();
            let at_near = cut((near - a) / (b - a));
            if a < near {
                ends[0] = at_near;
            } else if b < near {
                ends[1] = at_near;
            }
        }
        let [Some(a), Some(b)] = ends.map(|p| self.project(p)) else { return None };
        Some(Segment { ends, pixels: [a, b] })
    }

    /// The point in space at a fraction of a segment's length on the screen.
    pub fn point_on(&self, segment: &Segment, t: f32) -> Vec3 {
        let [a, b] = segment.ends;
        let t = f64::from(t);
        let s = if self.camera.orthographic {
            t
        } else {
            // The inverse of the depth is linear along the screen.
            let (near, far) = (self.view.depth(a), self.view.depth(b));
            t * near / (far + t * (near - far))
        };
        a.as_dvec3().lerp(b.as_dvec3(), s).as_vec3()
    }
}

impl Segment {
    /// The point of the segment nearest to a pixel, as a fraction of its length, and how many pixels away it is.
    pub fn nearest(&self, pixel: Vec2) -> (f32, f32) {
        let [a, b] = self.pixels;
        let along = b - a;
        let t = ((pixel - a).dot(along) / along.length_squared().max(1e-12)).clamp(0.0, 1.0);
        (t, (a + along * t).distance(pixel))
    }
}
