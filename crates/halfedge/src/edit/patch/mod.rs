//! Patches: most edits take faces out of a mesh and put others in their place.
//!
//! An edit lists the faces that it removes and the corners of those that it adds, and nothing about links between
//! half-edges. [`Patch::plan`] works out the result without writing, and checks every rule of [`Mesh::validate`]
//! as far as the patch reaches. [`Plan::apply`] then writes it.
//!
//! # Why the checks suffice
//!
//! A side of a new face lies on the edge between its ends: an existing one, found by its ends, or a new one, one
//! for each pair of ends. So no edge is duplicated. If two faces take the same side of an edge the patch is refused
//! ([`Refusal::SideTaken`](super::Refusal::SideTaken)), and edges left without a face are removed. The corners of
//! a new face differ, and there are three or more. At each vertex of the patch, the corners of all faces there, old
//! and new, are ordered by the edges between them: they must form one fan. Boundary half-edges are linked from each
//! fan's end to its start, and the vertex gets the one that leaves it.
//!
//! # Cost
//!
//! O(corners of the removed and added faces + valences of their vertices), times a logarithm for sorting. Hash
//! tables are as large as the patch, never as the mesh.

mod apply;
mod fans;
mod followers;
mod plan;

pub(crate) use plan::Plan;

use crate::edit::shared::Blend;
use crate::{FaceId, HalfedgeId, Mesh, VertexId};
use glam::Vec3;

/// A corner of a new face, and the side that leaves it.
#[derive(Clone, Debug)]
pub(crate) struct Corner {
    /// A vertex of the mesh, or a new one of the patch.
    pub vertex: VertexId,
    /// The corner's values, from corners of the mesh.
    pub value: Blend,
    /// The half-edge of a removed face that this side replaces. Where no edge joins the side's ends, that
    /// half-edge's edge is moved to them if nothing else needs it; otherwise a new edge copies its attributes.
    pub replaces: Option<HalfedgeId>,
}

impl Corner {
    /// The corner and side of a half-edge as they are.
    pub(crate) fn keep(mesh: &Mesh, h: HalfedgeId) -> Self {
        Self::moved(mesh.from(h), h)
    }

    /// The corner and side of a half-edge, at another vertex.
    pub(crate) fn moved(vertex: VertexId, h: HalfedgeId) -> Self {
        Self { vertex, value: Blend::Copy(h.raw()), replaces: Some(h) }
    }

    /// A corner with the values of a half-edge's corner and a new side.
    pub(crate) fn new(vertex: VertexId, h: HalfedgeId) -> Self {
        Self { vertex, value: Blend::Copy(h.raw()), replaces: None }
    }
}

/// A face that a patch adds.
#[derive(Clone, Debug)]
pub(crate) struct NewFace {
    /// The removed face whose id and attributes this one takes over, if any.
    pub id: Option<FaceId>,
    /// The face whose attributes a face with a new id copies.
    pub attributes_of: Option<FaceId>,
    pub corners: Vec<Corner>,
}

/// A vertex that a patch adds.
#[derive(Clone, Debug)]
pub(crate) struct NewVertex {
    pub position: Vec3,
    pub value: Blend,
}

/// The faces that an edit removes, and the vertices and faces that it adds.
#[derive(Clone, Debug, Default)]
pub(crate) struct Patch {
    /// Ids may repeat.
    pub remove: Vec<FaceId>,
    pub vertices: Vec<NewVertex>,
    pub faces: Vec<NewFace>,
    /// Whether a vertex left with several fans of faces gets a new vertex for each but the first. Otherwise the
    /// patch is refused.
    pub separates_fans: bool,
    /// The id of the first new vertex.
    first_vertex: usize,
}

impl Patch {
    pub(crate) fn new(mesh: &Mesh) -> Self {
        Self { first_vertex: mesh.vertex_capacity(), ..Self::default() }
    }

    /// Adds a vertex; returns the id that it will have.
    pub(crate) fn add_vertex(&mut self, position: Vec3, value: Blend) -> VertexId {
        self.vertices.push(NewVertex { position, value });
        VertexId::new(self.first_vertex + self.vertices.len() - 1)
    }

    /// Adds a vertex with the position and attributes of one of the mesh.
    pub(crate) fn copy_vertex(&mut self, mesh: &Mesh, v: VertexId) -> VertexId {
        self.add_vertex(mesh.position(v), Blend::Copy(v.raw()))
    }

    /// Adds a face with the attributes of another.
    pub(crate) fn add_face(&mut self, attributes_of: Option<FaceId>, corners: Vec<Corner>) {
        self.faces.push(NewFace { id: None, attributes_of, corners });
    }

    /// Gives a face other corners.
    pub(crate) fn replace_face(&mut self, face: FaceId, corners: Vec<Corner>) {
        self.remove.push(face);
        self.faces.push(NewFace { id: Some(face), attributes_of: None, corners });
    }

    /// Gives a face other corners, or removes it if fewer than three are left.
    pub(crate) fn shrink_face(&mut self, face: FaceId, corners: Vec<Corner>) {
        if corners.len() >= 3 {
            self.replace_face(face, corners);
        } else {
            self.remove.push(face);
        }
    }
}
