//! The compact triangle mesh that simplification and remeshing work on.
//!
//! Half-edge `3f + k` is side `k` of triangle `f` and leaves its corner `k`. A triangle therefore takes three
//! vertices and the three half-edges across, 24 bytes. The result is written to a half-edge mesh in one pass.

mod borders;
mod build;
mod edit;
mod follow;
mod order;
mod output;
mod values;
mod walk;

pub(crate) use borders::Borders;
pub(crate) use order::{Order, Renumbering};
pub(crate) use walk::{Foot, area_vector};

use glam::{DVec3, Vec3};
use halfedge::attribute::Column;
use halfedge::{Mesh, NONE};

/// The next side of the same triangle.
#[inline]
pub(crate) fn next(h: u32) -> u32 {
    if h % 3 == 2 { h - 2 } else { h + 1 }
}

/// The previous side of the same triangle.
#[inline]
pub(crate) fn prev(h: u32) -> u32 {
    if h.is_multiple_of(3) { h + 2 } else { h - 1 }
}

/// Reserves memory for this many more values. A vector that doubles takes up to twice the memory of its values;
/// this one grows by an eighth, which copies each value eight times on average.
#[inline]
pub(crate) fn make_room<T>(values: &mut Vec<T>, more: usize) {
    if values.capacity() - values.len() < more {
        values.reserve_exact(more.max(values.len() / 8));
    }
}

/// Collects values, with memory reserved for this many more.
pub(crate) fn with_room<T>(values: impl ExactSizeIterator<Item = T>, more: usize) -> Vec<T> {
    let mut list = Vec::with_capacity(values.len() + more);
    list.extend(values);
    list
}

/// Triangles, their adjacency, and the sources of their attributes.
pub(crate) struct TriMesh {
    /// Per half-edge: the vertex that it leaves; [`NONE`] for removed triangles.
    pub v: Vec<u32>,
    /// Per half-edge: its twin across the edge; [`NONE`] on the boundary.
    pub opp: Vec<u32>,
    /// Per vertex: a half-edge leaving it, a boundary one if there is one; [`NONE`] if it has no triangle.
    pub out: Vec<u32>,
    /// Per vertex: its position in mesh units, rounded as in the result, so that checks here hold there, and
    /// vertices that don't move keep their bits.
    pub position: Vec<Vec3>,
    /// Per triangle: the face that it comes from. Users who don't need it may empty it.
    pub face_source: Vec<u32>,
    /// Per half-edge: the index of its corner's values in `corner_columns`. Corners with equal values around a
    /// vertex share one. Empty if the mesh has no corner attributes.
    pub wedge: Vec<u32>,
    /// Per half-edge: the edge that it comes from, or [`NONE`]. Empty if edges have no attributes.
    pub edge_source: Vec<u32>,
    /// Corner values, indexed by `wedge`.
    pub corner_columns: Vec<Column>,
    /// Vertex values.
    pub vertex_columns: Vec<Column>,
    /// The number of triangles, without removed ones.
    pub faces: usize,
    pub frame: Frame,
}

/// How a vertex may move.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Role {
    /// Anywhere on the surface.
    Free,
    /// Along the kept curve that passes through it.
    Curve,
    /// Not at all: kept curves end, meet or turn there.
    Fixed,
}

/// Coordinates shifted by a float and scaled by a power of two, so that the mesh is centred and about 1 in size,
/// and sums of squares keep their precision.
#[derive(Clone, Copy)]
pub(crate) struct Frame {
    center: DVec3,
    /// Mesh units per unit of the frame.
    pub scale: f64,
    /// The inverse of the scale, which is exact too.
    inverse: f64,
}

impl Frame {
    fn of(mesh: &Mesh) -> Self {
        let bounds = crate::measure::bounding_box(mesh);
        let (center, size) = bounds.map_or((DVec3::ZERO, 1.0), |b| (b.center().as_dvec3(), b.diagonal()));
        let mut scale = 1.0f64;
        while scale < size && scale < 1e300 {
            scale *= 2.0;
        }
        while scale > 2.0 * size && size > 0.0 {
            scale *= 0.5;
        }
        Self { center, scale, inverse: 1.0 / scale }
    }

    /// A position in the frame.
    #[inline]
    pub fn inward(&self, p: Vec3) -> DVec3 {
        (p.as_dvec3() - self.center) * self.inverse
    }

    /// A position in mesh units.
    #[inline]
    pub fn outward(&self, p: DVec3) -> Vec3 {
        (p * self.scale + self.center).as_vec3()
    }
}

impl TriMesh {
    /// A copy of the triangles without attributes and sources, as [`Self::bare`] makes them.
    pub fn bare_copy(&self) -> Self {
        Self {
            v: self.v.clone(),
            opp: self.opp.clone(),
            out: self.out.clone(),
            position: self.position.clone(),
            face_source: Vec::new(),
            wedge: Vec::new(),
            edge_source: Vec::new(),
            corner_columns: Vec::new(),
            vertex_columns: Vec::new(),
            faces: self.faces,
            frame: self.frame,
        }
    }

    /// Reserves memory for exactly this many [`Self::split`]s.
    pub fn reserve_splits(&mut self, splits: usize) {
        self.position.reserve_exact(splits);
        self.out.reserve_exact(splits);
        self.face_source.reserve_exact(2 * splits);
        self.v.reserve_exact(6 * splits);
        self.opp.reserve_exact(6 * splits);
        for numbers in [&mut self.wedge, &mut self.edge_source] {
            if !numbers.is_empty() {
                numbers.reserve_exact(6 * splits);
            }
        }
    }

    #[inline]
    pub fn from(&self, h: u32) -> u32 {
        self.v[h as usize]
    }

    #[inline]
    pub fn to(&self, h: u32) -> u32 {
        self.v[next(h) as usize]
    }

    /// The vertex opposite a side in its triangle.
    #[inline]
    pub fn apex(&self, h: u32) -> u32 {
        self.v[prev(h) as usize]
    }

    #[inline]
    pub fn opp(&self, h: u32) -> u32 {
        self.opp[h as usize]
    }

    #[inline]
    pub fn at(&self, v: u32) -> DVec3 {
        self.frame.inward(self.position[v as usize])
    }

    /// Moves a vertex; its position is rounded to floats.
    #[inline]
    pub fn put(&mut self, v: u32, at: DVec3) {
        self.position[v as usize] = self.frame.outward(at);
    }

    /// The next half-edge leaving the same vertex, counter-clockwise; [`NONE`] after the last one of a boundary
    /// vertex.
    #[inline]
    pub fn turn(&self, h: u32) -> u32 {
        self.opp(prev(h))
    }

    /// Whether the triangle of a half-edge still exists.
    #[inline]
    pub fn is_alive(&self, h: u32) -> bool {
        self.v[h as usize] != NONE
    }

    #[inline]
    pub fn is_boundary_vertex(&self, v: u32) -> bool {
        let out = self.out[v as usize];
        out != NONE && self.opp(out) == NONE
    }

    /// The half-edge that stands for its edge: the smaller one.
    #[inline]
    pub fn edge(&self, h: u32) -> u32 {
        h.min(self.opp(h))
    }

    /// Calls `visit` with each half-edge leaving a vertex, counter-clockwise. The incoming boundary edge has no
    /// half-edge that leaves: its half-edge is `prev` of the last one.
    #[inline]
    pub fn around(&self, v: u32, mut visit: impl FnMut(u32)) {
        let first = self.out[v as usize];
        let mut h = first;
        while h != NONE {
            visit(h);
            h = self.turn(h);
            if h == first {
                break;
            }
        }
    }

    /// The last half-edge leaving the same vertex counter-clockwise, for a vertex on the boundary.
    #[inline]
    pub fn last_around(&self, h: u32) -> u32 {
        let mut last = h;
        while self.turn(last) != NONE {
            last = self.turn(last);
        }
        last
    }

    /// Calls `visit` with each neighbour of a vertex.
    #[inline]
    pub fn neighbors(&self, v: u32, mut visit: impl FnMut(u32)) {
        self.around(v, |h| {
            visit(self.to(h));
            if self.turn(h) == NONE {
                visit(self.apex(h));
            }
        });
    }

    /// Whether the corner values on the two sides of an edge differ at either end.
    pub fn is_seam(&self, h: u32) -> bool {
        let across = self.opp(h);
        !self.wedge.is_empty()
            && across != NONE
            && (self.wedge[h as usize] != self.wedge[next(across) as usize]
                || self.wedge[next(h) as usize] != self.wedge[across as usize])
    }
}
