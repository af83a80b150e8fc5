//! The mesh as flat columns of connectivity, positions and attributes.

use crate::attribute::Columns;
use crate::geometry::BitSet;
use crate::mesh::journal::Journal;
use crate::mesh::values::same_bits;
use glam::Vec3;

/// A polygon mesh as plain data.
///
/// Half-edges `2e` and `2e + 1` are the sides of edge `e`. Each has a next and a previous half-edge in
/// its loop, a vertex that it points to, and a face, except on the boundary. Boundary half-edges are
/// stored and form loops as those of a face do. A vertex has one half-edge that leaves it, a boundary one
/// if there is one; a face has its first half-edge.
///
/// Removing an element marks it as removed: the ids of the others stay until [`Mesh::compact`].
#[derive(Debug, Default)]
pub struct Mesh {
    pub(crate) positions: Vec<Vec3>,
    pub(crate) vertex_halfedge: Vec<u32>,
    pub(crate) next: Vec<u32>,
    pub(crate) prev: Vec<u32>,
    pub(crate) to: Vec<u32>,
    pub(crate) face: Vec<u32>,
    pub(crate) face_halfedge: Vec<u32>,
    pub(crate) removed_vertices: BitSet,
    pub(crate) removed_edges: BitSet,
    pub(crate) removed_faces: BitSet,
    pub(crate) columns: Columns,
    pub(crate) journal: Option<Journal>,
}

/// The columns of a mesh, for algorithms that build a whole mesh at once and for sending a mesh elsewhere.
/// [`NONE`](crate::NONE) stands for "no face" and "no half-edge".
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RawMesh {
    /// Per vertex: its position.
    pub positions: Vec<Vec3>,
    /// Per vertex: a half-edge leaving it, a boundary one if there is one; [`NONE`](crate::NONE) if isolated.
    pub vertex_halfedge: Vec<u32>,
    /// Per half-edge: the next in its loop.
    pub next: Vec<u32>,
    /// Per half-edge: the previous in its loop.
    pub prev: Vec<u32>,
    /// Per half-edge: the vertex it points to.
    pub to: Vec<u32>,
    /// Per half-edge: its face; [`NONE`](crate::NONE) on the boundary.
    pub face: Vec<u32>,
    /// Per face: its first half-edge, which leaves the face's first corner.
    pub face_halfedge: Vec<u32>,
    /// The attribute columns, each with a value for each id.
    pub columns: Columns,
}

/// The ids of removed elements, which still have entries in the columns, in ascending order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Gaps {
    /// Vertex ids.
    pub vertices: Vec<u32>,
    /// Edge ids.
    pub edges: Vec<u32>,
    /// Face ids.
    pub faces: Vec<u32>,
}

impl Clone for Mesh {
    /// A copy of the mesh that records nothing.
    fn clone(&self) -> Self {
        Self {
            positions: self.positions.clone(),
            vertex_halfedge: self.vertex_halfedge.clone(),
            next: self.next.clone(),
            prev: self.prev.clone(),
            to: self.to.clone(),
            face: self.face.clone(),
            face_halfedge: self.face_halfedge.clone(),
            removed_vertices: self.removed_vertices.clone(),
            removed_edges: self.removed_edges.clone(),
            removed_faces: self.removed_faces.clone(),
            columns: self.columns.clone(),
            journal: None,
        }
    }
}

impl PartialEq for Mesh {
    /// Whether ids, links and attributes are the same, and positions to the bit.
    fn eq(&self, other: &Self) -> bool {
        self.next == other.next
            && self.prev == other.prev
            && self.to == other.to
            && self.face == other.face
            && self.vertex_halfedge == other.vertex_halfedge
            && self.face_halfedge == other.face_halfedge
            && self.removed_vertices == other.removed_vertices
            && self.removed_edges == other.removed_edges
            && self.removed_faces == other.removed_faces
            && same_bits(&self.positions, &other.positions)
            && self.columns == other.columns
    }
}

impl Mesh {
    /// The most edges that a mesh may have: half-edge ids have 32 bits.
    pub const MAX_EDGES: usize = (u32::MAX / 2 - 1) as usize;

    /// An empty mesh.
    pub fn new() -> Self {
        Self::default()
    }

    /// The mesh of these columns, unchecked: call [`Mesh::validate`] unless they come from an algorithm that
    /// is known to be right.
    pub fn from_raw(raw: RawMesh) -> Self {
        let RawMesh { positions, vertex_halfedge, next, prev, to, face, face_halfedge, columns } = raw;
        Self { positions, vertex_halfedge, next, prev, to, face, face_halfedge, columns, ..Self::default() }
    }

    /// The columns. Removed elements still have entries: compact the mesh first where that matters.
    pub fn into_raw(self) -> RawMesh {
        RawMesh {
            positions: self.positions,
            vertex_halfedge: self.vertex_halfedge,
            next: self.next,
            prev: self.prev,
            to: self.to,
            face: self.face,
            face_halfedge: self.face_halfedge,
            columns: self.columns,
        }
    }

    /// The ids of removed elements; none for a compact mesh.
    pub fn gaps(&self) -> Gaps {
        let list = |removed: &BitSet| removed.iter().map(|at| at as u32).collect();
        Gaps {
            vertices: list(&self.removed_vertices),
            edges: list(&self.removed_edges),
            faces: list(&self.removed_faces),
        }
    }

    /// [`Mesh::from_raw`] with removed elements: the inverse of [`Mesh::into_raw`] and [`Mesh::gaps`]. Ids past
    /// the end of the columns are ignored.
    pub fn from_raw_with_gaps(raw: RawMesh, gaps: &Gaps) -> Self {
        let mut mesh = Self::from_raw(raw);
        let lists = [
            (&mut mesh.removed_vertices, &gaps.vertices, mesh.positions.len()),
            (&mut mesh.removed_edges, &gaps.edges, mesh.next.len() / 2),
            (&mut mesh.removed_faces, &gaps.faces, mesh.face_halfedge.len()),
        ];
        for (marks, list, len) in lists {
            for &id in list.iter().filter(|&&id| (id as usize) < len) {
                marks.insert(id as usize);
            }
        }
        mesh
    }

    /// Heap bytes in use.
    pub fn bytes(&self) -> usize {
        self.positions.len() * size_of::<Vec3>()
            + (self.vertex_halfedge.len() + self.next.len() * 4 + self.face_halfedge.len()) * 4
            + self.columns.bytes()
            + self.removed_vertices.bytes()
            + self.removed_edges.bytes()
            + self.removed_faces.bytes()
    }
}
