//! Finding the face that a ray hits first, and the point of a mesh closest to a point.

mod builder;

pub use builder::FaceTreeBuilder;

use crate::measure::Bounds;
use glam::{DVec3, Vec3};
use halfedge::geometry::PolygonTriangulator;
use halfedge::{FaceId, HalfedgeId, Mesh, NONE, VertexId};

/// How many faces share a box at the bottom of the tree.
const LEAF: usize = 16;
/// How many boxes share one on the level above.
const WIDE: usize = 8;

/// A half-line in mesh coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where it starts.
    pub origin: Vec3,
    /// Where it goes; of any length but zero.
    pub direction: Vec3,
}

/// A point on a face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The face.
    pub face: FaceId,
    /// How far away it is, in mesh units.
    pub distance: f64,
    /// Where.
    pub point: Vec3,
    /// The corners of the face's triangle that the point is in, as the half-edges that leave them.
    pub corners: [HalfedgeId; 3],
    /// The point's weights of those corners; they sum to 1.
    pub barycentric: [f32; 3],
}

impl Hit {
    /// The vertex of the triangle's corners that the point is nearest to by weight.
    pub fn nearest_corner(&self, mesh: &Mesh) -> VertexId {
        let [a, b, c] = self.barycentric;
        let h = if a >= b && a >= c {
            self.corners[0]
        } else if b >= c {
            self.corners[1]
        } else {
            self.corners[2]
        };
        mesh.from(h)
    }
}

/// A hierarchy of boxes over the faces of a mesh, kept up to date as the mesh is edited.
///
/// The faces stand in one fixed order that keeps neighbours together; each 16 share a box, each 8 boxes
/// share one on the level above. The tree refers to the mesh by ids and has to be given the same mesh
/// each time, with [`FaceTree::update`] told of all changes between.
#[derive(Clone, Debug, Default)]
pub struct FaceTree {
    /// Face ids in the tree's order.
    order: Vec<u32>,
    /// Where each face id stands in `order`, or [`NONE`].
    place: Vec<u32>,
    /// Boxes, those of the leaves first.
    levels: Vec<Vec<Bounds>>,
    /// How many faces there were when the order was made.
    sorted: usize,
}

fn face_bounds(mesh: &Mesh, face: FaceId) -> Bounds {
    let links = mesh.connectivity();
    let positions = mesh.positions();
    let first = links.face_halfedge[face.index()];
    let mut bounds = Bounds::EMPTY;
    let mut h = first;
    loop {
        bounds = bounds.with(positions[links.to[h as usize] as usize]);
        h = links.next[h as usize];
        if h == first {
            return bounds;
        }
    }
}

impl FaceTree {
    /// The tree of all faces. Costs O(mesh).
    pub fn new(mesh: &Mesh) -> Self {
        FaceTreeBuilder::new(mesh).finish(mesh)
    }

    /// Heap bytes in use.
    pub fn bytes(&self) -> usize {
        (self.order.len() + self.place.len()) * 4
            + self.levels.iter().map(|level| level.len() * size_of::<Bounds>()).sum::<usize>()
    }

    /// Follows changes to the mesh: the faces that were made, removed, or have a corner that moved.
    /// Costs O(log mesh) for each. After so many new faces that the order has lost its worth, the tree
    /// is made anew.
    pub fn update(&mut self, mesh: &Mesh, faces: impl IntoIterator<Item = FaceId>) {
        let mut dirty = Vec::new();
        for face in faces {
            if self.place.len() <= face.index() {
                if !mesh.has_face(face) {
                    continue;
                }
                self.place.resize(mesh.face_capacity(), NONE);
            }
            let mut at = self.place[face.index()];
            if at == NONE {
                if !mesh.has_face(face) {
                    continue;
                }
                at = self.order.len() as u32;
                self.order.push(face.raw());
                self.place[face.index()] = at;
            }
            dirty.push(at as usize / LEAF);
        }
        if self.order.len() > self.sorted + self.sorted / 2 + 1024 {
            *self = Self::new(mesh);
            return;
        }
        self.fit_levels();
        for level in 0..self.levels.len() {
            dirty.sort_unstable();
            dirty.dedup();
            for node in &mut dirty {
                self.refresh(mesh, level, *node);
                *node /= WIDE;
            }
        }
    }

    /// Makes each level as long as the one below needs it, up to one of eight boxes at most.
    fn fit_levels(&mut self) {
        let mut len = self.order.len().div_ceil(LEAF);
        let mut level = 0;
        loop {
            match self.levels.get_mut(level) {
                Some(boxes) => boxes.resize(len, Bounds::EMPTY),
                None => {
                    self.levels.push(vec![Bounds::EMPTY; len]);
                    // All boxes of a new level have to be worked out, not only the dirty ones.
                    if let [.., below, top] = self.levels.as_mut_slice() {
                        for (node, children) in top.iter_mut().zip(below.chunks(WIDE)) {
                            *node = children.iter().copied().fold(Bounds::EMPTY, Bounds::union);
                        }
                    }
                }
            }
            if len <= WIDE {
                self.levels.truncate(level + 1);
                return;
            }
            len = len.div_ceil(WIDE);
            level += 1;
        }
    }

    fn children(&self, level: usize, node: usize) -> std::ops::Range<usize> {
        let (width, len) = match level {
            0 => (LEAF, self.order.len()),
            _ => (WIDE, self.levels[level - 1].len()),
        };
        node * width..len.min((node + 1) * width)
    }

    fn refresh(&mut self, mesh: &Mesh, level: usize, node: usize) {
        let children = self.children(level, node);
        self.levels[level][node] = if level == 0 {
            self.faces(mesh, children).map(|f| face_bounds(mesh, f)).fold(Bounds::EMPTY, Bounds::union)
        } else {
            self.levels[level - 1][children].iter().copied().fold(Bounds::EMPTY, Bounds::union)
        };
    }

    fn faces<'a>(
        &'a self,
        mesh: &'a Mesh,
        places: std::ops::Range<usize>,
    ) -> impl Iterator<Item = FaceId> + 'a {
        self.order[places].iter().filter_map(|&raw| mesh.face(raw))
    }

    /// Visits faces in boxes that are nearer than the bound, near boxes first. `near` gives a box's
    /// distance; `face` looks at a face and gives the new bound.
    fn visit(
        &self,
        mesh: &Mesh,
        near: impl Fn(&Bounds) -> f64,
        mut bound: f64,
        mut face: impl FnMut(FaceId, f64) -> f64,
    ) {
        let Some(top) = self.levels.len().checked_sub(1) else { return };
        let mut stack: Vec<(f64, usize, usize)> = Vec::with_capacity(8 * self.levels.len());
        let push = |stack: &mut Vec<(f64, usize, usize)>,
                    level: usize,
                    nodes: std::ops::Range<usize>,
                    bound: f64| {
            let start = stack.len();
            for node in nodes {
                let distance = near(&self.levels[level][node]);
                if distance <= bound {
                    stack.push((distance, level, node));
                }
            }
            stack[start..].sort_unstable_by(|a, b| b.0.total_cmp(&a.0));
        };
        push(&mut stack, top, 0..self.levels[top].len(), bound);
        while let Some((distance, level, node)) = stack.pop() {
            if distance > bound {
                continue;
            }
            let children = self.children(level, node);
            if level == 0 {
                for f in self.faces(mesh, children) {
                    bound = face(f, bound);
                }
            } else {
                push(&mut stack, level - 1, children, bound);
            }
        }
    }

    /// The first point where the ray meets a face, from either side; of two at the same distance, the
    /// face with the smaller id. Neighbouring faces leave no gap between them. A ray whose direction is
    /// zero or not finite hits nothing.
    pub fn hit(&self, mesh: &Mesh, ray: Ray) -> Option<Hit> {
        let origin = ray.origin.as_dvec3();
        let direction = ray.direction.as_dvec3().try_normalize()?;
        if !origin.is_finite() {
            return None;
        }
        // In place of an infinite inverse, one that no coordinate can bring back into range.
        let inverse = DVec3::from_array(direction.to_array().map(|d| if d == 0.0 { 1e300 } else { 1.0 / d }));
        let enters = |bounds: &Bounds| {
            let a = (bounds.min.as_dvec3() - origin) * inverse;
            let b = (bounds.max.as_dvec3() - origin) * inverse;
            let enter = a.min(b).max_element();
            // Roundings of the products must not let a ray slip past a face in the box's side.
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

    /// The point of the mesh closest to `point`; none for a mesh without faces or a point that is not
    /// finite.
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
            // Most triangles of a leaf are farther away than their box says already.
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

/// Where a ray from the origin meets a triangle: the distance and the corners' weights.
///
/// The sign of each side's volume decides (Plücker coordinates). A side shared by two triangles gives
/// exactly opposite numbers, so no ray passes between them.
fn intersect([a, b, c]: [DVec3; 3], direction: DVec3) -> Option<(f64, DVec3)> {
    let volumes = DVec3::new(direction.dot(c.cross(b)), direction.dot(a.cross(c)), direction.dot(b.cross(a)));
    if volumes.min_element() < 0.0 && volumes.max_element() > 0.0 {
        return None;
    }
    let sum = volumes.x + volumes.y + volumes.z;
    if sum == 0.0 {
        return None;
    }
    let weights = volumes / sum;
    let distance = direction.dot(a * weights.x + b * weights.y + c * weights.z);
    (distance >= 0.0).then_some((distance, weights))
}

/// The weights of the point of a triangle closest to `p` (Ericson: Real-time collision detection,
/// 5.1.5).
#[inline(always)]
pub(crate) fn closest_in_triangle([a, b, c]: [DVec3; 3], p: DVec3) -> DVec3 {
    let (ab, ac) = (b - a, c - a);
    let ap = p - a;
    let (d1, d2) = (ab.dot(ap), ac.dot(ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return DVec3::X;
    }
    let bp = p - b;
    let (d3, d4) = (ab.dot(bp), ac.dot(bp));
    if d3 >= 0.0 && d4 <= d3 {
        return DVec3::Y;
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 && d1 > d3 {
        let v = d1 / (d1 - d3);
        return DVec3::new(1.0 - v, v, 0.0);
    }
    let cp = p - c;
    let (d5, d6) = (ab.dot(cp), ac.dot(cp));
    if d6 >= 0.0 && d5 <= d6 {
        return DVec3::Z;
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 && d2 > d6 {
        let w = d2 / (d2 - d6);
        return DVec3::new(1.0 - w, 0.0, w);
    }
    let va = d3 * d6 - d5 * d4;
    let past_b = d4 - d3;
    let along = past_b + (d5 - d6);
    if va <= 0.0 && past_b >= 0.0 && d5 >= d6 && along > 0.0 {
        let w = past_b / along;
        return DVec3::new(0.0, 1.0 - w, w);
    }
    let sum = va + vb + vc;
    // A triangle without area to speak of is its sides, and the three areas are noise.
    if sum <= 1e-14 * ab.length_squared() * ac.length_squared() {
        return closest_on_sides([a, b, c], p);
    }
    let (v, w) = (vb / sum, vc / sum);
    DVec3::new(1.0 - v - w, v, w)
}

/// How far along a segment, from 0 to 1, the point of it is that is closest to `p`.
pub(crate) fn along_segment(from: DVec3, to: DVec3, p: DVec3) -> f64 {
    let along = to - from;
    ((p - from).dot(along) / along.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0)
}

/// The weights of the point closest to `p` on a triangle's sides.
#[cold]
#[inline(never)]
fn closest_on_sides(corners: [DVec3; 3], p: DVec3) -> DVec3 {
    let on_side = |i: usize| {
        let (from, to) = (corners[i], corners[(i + 1) % 3]);
        let t = along_segment(from, to, p);
        let mut weights = DVec3::ZERO;
        weights[i] = 1.0 - t;
        weights[(i + 1) % 3] = t;
        (weights, from.lerp(to, t).distance_squared(p))
    };
    let [first, second, third] = [0, 1, 2].map(on_side);
    let nearer = |a: (DVec3, f64), b: (DVec3, f64)| if b.1 < a.1 { b } else { a };
    nearer(nearer(first, second), third).0
}
