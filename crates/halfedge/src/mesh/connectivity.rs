//! The links of a mesh as slices, for algorithms that read the whole mesh.

use crate::{Mesh, RawMesh};

/// The links of a mesh as slices. [`NONE`](crate::NONE) stands for "no face" and "no half-edge". Removed
/// elements have entries too: compact the mesh first where that matters.
#[derive(Clone, Copy, Debug)]
pub struct Connectivity<'a> {
    /// Per vertex: a half-edge leaving it, a boundary one if there is one.
    pub vertex_halfedge: &'a [u32],
    /// Per half-edge: the next in its loop.
    pub next: &'a [u32],
    /// Per half-edge: the previous in its loop.
    pub prev: &'a [u32],
    /// Per half-edge: the vertex it points to.
    pub to: &'a [u32],
    /// Per half-edge: its face.
    pub face: &'a [u32],
    /// Per face: its first half-edge.
    pub face_halfedge: &'a [u32],
}

macro_rules! connectivity {
    ($mesh:ty) => {
        impl $mesh {
            /// The links as slices.
            pub fn connectivity(&self) -> Connectivity<'_> {
                Connectivity {
                    vertex_halfedge: &self.vertex_halfedge,
                    next: &self.next,
                    prev: &self.prev,
                    to: &self.to,
                    face: &self.face,
                    face_halfedge: &self.face_halfedge,
                }
            }
        }
    };
}

connectivity!(Mesh);
connectivity!(RawMesh);
