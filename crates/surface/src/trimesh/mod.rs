//! The compact triangle structure that simplifying and remeshing work on.
//!
//! Half-edge `3f + k` is the `k`-th side of triangle `f` and leaves its `k`-th corner, so a triangle is
//! three vertices and three half-edges across, 24 bytes, and nothing else needs storing. The mesh is
//! written back at the end in one pass.

mod build;
mod edit;
mod order;
mod output;
mod values;
mod walk;

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

/// Makes room for so many more values. Vectors that grow by doubling take up to twice what they hold; this
/// grows by an eighth, which copies each value eight times on average.
#[inline]
pub(crate) fn make_room<T>(values: &mut Vec<T>, more: usize) {
    if values.capacity() - values.len() < more {
        values.reserve_exact(more.max(values.len() / 8));
    }
}

/// Collects values, with room for so many more.
pub(crate) fn with_room<T>(values: impl ExactSizeIterator<Item = T>, more: usize) -> Vec<T> {
    let mut list = Vec::with_capacity(values.len() + more);
    list.extend(values);
    list
}

/// Triangles with what lies across their sides, and where their attributes come from.
pub(crate) struct TriMesh {
    /// Per half-edge: the vertex it leaves; [`NONE`] for removed triangles.
    pub v: Vec<u32>,
    /// Per half-edge: the one across the edge, or [`NONE`] on the boundary.
    pub opp: Vec<u32>,
    /// Per vertex: a half-edge leaving it, the boundary one if there is one; [`NONE`] if it has no face.
    pub out: Vec<u32>,
    /// Per vertex: its position, in mesh units and rounded as the result's will be, so that what is checked
    /// here holds there, and what doesn't move comes back as it was.
    pub position: Vec<Vec3>,
    /// Per triangle: the face it comes from. May be emptied by those who don't need it.
    pub face_source: Vec<u32>,
    /// Per half-edge: the place of its corner's values in `corner_columns`; equal values around a
    /// vertex share one. Empty where the mesh has no corner attributes.
    pub wedge: Vec<u32>,
    /// Per half-edge: the edge it comes from, or [`NONE`]. Empty where edges have no attributes.
    pub edge_source: Vec<u32>,
    /// Values by `wedge`.
    pub corner_columns: Vec<Column>,
    /// Values by vertex.
    pub vertex_columns: Vec<Column>,
    /// How many triangles there are.
    pub faces: usize,
    pub frame: Frame,
}

/// Coordinates around zero and about one in size, so that sums of squares keep their digits: shifted by
/// a float and scaled by a power of two.
#[derive(Clone, Copy)]
pub(crate) struct Frame {
    center: DVec3,
    /// Mesh units per unit of the frame.
    pub scale: f64,
    /// The other way round: exact, too.
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

    #[inline]
    pub fn inward(&self, p: Vec3) -> DVec3 {
        (p.as_dvec3() - self.center) * self.inverse
    }

    #[inline]
    pub fn outward(&self, p: DVec3) -> Vec3 {
        (p * self.scale + self.center).as_vec3()
    }
}

impl TriMesh {
    /// A copy of its triangles alone, as [`Self::bare`] makes them.
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

    /// Makes room for so many [`Self::split`]s, and no more than that.
    pub fn make_room(&mut self, splits: usize) {
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

    /// The vertex across from a side in its triangle.
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

    /// Moves a vertex, to where rounding to floats leaves it.
    #[inline]
    pub fn put(&mut self, v: u32, at: DVec3) {
        self.position[v as usize] = self.frame.outward(at);
    }

    /// The next half-edge leaving the same vertex, counter-clockwise; [`NONE`] past the last of a
    /// boundary vertex.
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

    /// The name of an edge: the smaller of its half-edges.
    #[inline]
    pub fn edge(&self, h: u32) -> u32 {
        h.min(self.opp(h))
    }

    /// Calls `visit` with each half-edge leaving a vertex, counter-clockwise. An edge on the boundary
    /// whose half-edge comes in has none that leaves: it is `prev` of the last.
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

    /// Whether an edge's corner values differ across it, at either end.
    pub fn is_seam(&self, h: u32) -> bool {
        let across = self.opp(h);
        !self.wedge.is_empty()
            && across != NONE
            && (self.wedge[h as usize] != self.wedge[next(across) as usize]
                || self.wedge[next(h) as usize] != self.wedge[across as usize])
    }
}
