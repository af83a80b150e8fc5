//! Lengths, areas, volumes and angles, in mesh units and radians.

use glam::{DVec3, Vec3};
use halfedge::geometry::{face_area_vector, mean_position};
use halfedge::{Budget, EdgeId, FaceId, InParts, Mesh, VertexId};

/// An axis-aligned box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The smallest coordinates.
    pub min: Vec3,
    /// The largest coordinates.
    pub max: Vec3,
}

impl Bounds {
    /// An empty box.
    pub const EMPTY: Self = Self { min: Vec3::INFINITY, max: Vec3::NEG_INFINITY };

    /// The smallest box around the points; none if there are no points.
    pub fn of(points: impl IntoIterator<Item = Vec3>) -> Option<Self> {
        points.into_iter().fold(None, |bounds: Option<Self>, p| {
            Some(bounds.map_or(Self { min: p, max: p }, |bounds| bounds.with(p)))
        })
    }

    /// The box extended to a point.
    #[inline]
    pub fn with(self, point: Vec3) -> Self {
        Self { min: self.min.min(point), max: self.max.max(point) }
    }

    /// The smallest box around both.
    #[inline]
    pub fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// The centre.
    pub fn center(self) -> Vec3 {
        self.min * 0.5 + self.max * 0.5
    }

    /// The length of the diagonal.
    pub fn diagonal(self) -> f64 {
        (self.max.as_dvec3() - self.min.as_dvec3()).length()
    }
}

/// The box around all vertices, with isolated ones; none for an empty mesh. Costs O(vertices).
pub fn bounding_box(mesh: &Mesh) -> Option<Bounds> {
    Bounds::of(mesh.vertices().map(|v| mesh.position(v)))
}

/// The length of an edge.
pub fn edge_length(mesh: &Mesh, edge: EdgeId) -> f64 {
    let [a, b] = mesh.ends(edge).map(|v| mesh.position(v).as_dvec3());
    a.distance(b)
}

/// The mean length of all edges; 0 if there are none. Costs O(edges).
pub fn mean_edge_length(mesh: &Mesh) -> f64 {
    let sum: f64 = mesh.edges().map(|e| edge_length(mesh, e)).sum();
    sum / mesh.edge_count().max(1) as f64
}

/// The area of a face; for a non-planar polygon that of its projection along its normal.
pub fn face_area(mesh: &Mesh, face: FaceId) -> f64 {
    face_area_vector(mesh, face).length()
}

/// The area of all faces. Costs O(mesh).
pub fn surface_area(mesh: &Mesh) -> f64 {
    mesh.faces().map(|f| face_area(mesh, f)).sum()
}

/// How close a face is to a regular polygon: 1 if it is one, 0 without area. The area over the sum of the squares of its
/// sides, relative to that of the regular polygon with as many corners.
pub fn face_quality(mesh: &Mesh, face: FaceId) -> f64 {
    let (mut squares, mut corners) = (0.0, 0.0);
    for h in mesh.face_halfedges(face) {
        squares +=
            mesh.position(mesh.from(h)).as_dvec3().distance_squared(mesh.position(mesh.to(h)).as_dvec3());
        corners += 1.0;
    }
    let regular = 0.25 / (std::f64::consts::PI / corners).tan();
    if squares > 0.0 { (face_area(mesh, face) / squares / regular).min(1.0) } else { 0.0 }
}

/// The mean of a face's corners, which is the face point of Catmull-Clark.
pub fn face_center(mesh: &Mesh, face: FaceId) -> DVec3 {
    mean_position(mesh, mesh.face_vertices(face))
}

/// The volume that a closed mesh encloses; negative if its faces point inward. It has no meaning for an open mesh.
/// Costs O(mesh).
pub fn volume(mesh: &Mesh) -> f64 {
    SizeCounter::default().finish(mesh).volume
}

/// How large a mesh is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sizes {
    /// The box around all vertices; none for an empty mesh.
    pub bounds: Option<Bounds>,
    /// The area of all faces.
    pub area: f64,
    /// The volume that a closed mesh encloses; see [`volume`].
    pub volume: f64,
    /// The number of vertices without an edge.
    pub isolated_vertices: usize,
}

/// Measures the [`Sizes`] of a mesh over several calls, so that none takes long. Start anew after an edit.
#[derive(Clone, Copy, Debug, Default)]
pub struct SizeCounter {
    /// The next vertex, then the next face.
    next: usize,
    has_bounds: bool,
    bounds: Option<Bounds>,
    isolated_vertices: usize,
    area: f64,
    six_volumes: f64,
}

impl InParts for SizeCounter {
    type Input<'a> = &'a Mesh;
    type Output = Sizes;

    fn step(&mut self, mesh: &Mesh, budget: &mut Budget) -> Option<Sizes> {
        if !self.has_bounds {
            let end = mesh.vertex_capacity();
            let first = self.next;
            self.next += budget.take(end.saturating_sub(first));
            let vertices = (first..self.next).map(VertexId::new).filter(|&v| mesh.has_vertex(v));
            let isolated = &mut self.isolated_vertices;
            let bounds = Bounds::of(vertices.map(|v| {
                *isolated += usize::from(mesh.halfedge_from(v).is_none());
                mesh.position(v)
            }));
            self.bounds = self.bounds.into_iter().chain(bounds).reduce(Bounds::union);
            if self.next < end {
                return None;
            }
            (self.has_bounds, self.next) = (true, 0);
        }
        // Relative to the centre, so that a mesh far from the origin keeps its precision.
        let origin = self.bounds.map_or(DVec3::ZERO, |bounds| bounds.center().as_dvec3());
        let end = mesh.face_capacity();
        let first = self.next;
        self.next += budget.take(end.saturating_sub(first));
        for face in (first..self.next).map(FaceId::new).filter(|&f| mesh.has_face(f)) {
            self.area += face_area(mesh, face);
            self.six_volumes += six_cone_volumes(mesh, face, origin);
        }
        let Self { bounds, area, six_volumes, isolated_vertices, .. } = *self;
        (self.next >= end).then_some(Sizes { bounds, area, volume: six_volumes / 6.0, isolated_vertices })
    }
}

/// Six times the signed volume between a face and a point.
fn six_cone_volumes(mesh: &Mesh, face: FaceId, apex: DVec3) -> f64 {
    let mut corners = mesh.face_vertices(face).map(|v| mesh.position(v).as_dvec3() - apex);
    let (Some(base), Some(mut before)) = (corners.next(), corners.next()) else { return 0.0 };
    let mut six_times = 0.0;
    for here in corners {
        six_times += base.dot(before.cross(here));
        before = here;
    }
    six_times
}
