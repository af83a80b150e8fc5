//! Adding faces one by one, with the mesh's own ids or with the caller's.
//!
//! While faces are added in any order, several fans of faces may meet at a vertex for a time. Each fan's
//! boundary then leads to the next one's, so that a walk around the vertex still reaches all of them.
//! [`GivenIds::finish`] separates the fans that are left.

use crate::mesh::Mesh;
use crate::mesh::note::Note;
use crate::{FaceId, HalfedgeId, VertexId};
use glam::Vec3;
use std::collections::HashMap;
use std::fmt;

/// Why a face can't be added. The mesh is unchanged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AddFaceError {
    /// It has fewer than three corners.
    TooFewCorners(usize),
    /// A vertex is at two of its corners.
    RepeatedVertex(u32),
    /// There is no such vertex.
    NoSuchVertex(u32),
    /// One of its half-edges has a face already.
    SideTaken(u32, u32),
    /// There are faces all around this vertex already.
    VertexClosed(u32),
    /// The faces at this vertex leave no room for the new one, in whatever order.
    NoRoom(u32),
    /// The id is in use.
    IdTaken(u32),
}

impl fmt::Display for AddFaceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFewCorners(n) => write!(f, "a face needs three corners or more, not {n}"),
            Self::RepeatedVertex(v) => write!(f, "vertex {v} is at two corners of the face"),
            Self::NoSuchVertex(v) => write!(f, "there is no vertex {v}"),
            Self::SideTaken(a, b) => write!(f, "a face already runs from vertex {a} to vertex {b}"),
            Self::VertexClosed(v) => write!(f, "vertex {v} has faces all around it already"),
            Self::NoRoom(v) => write!(f, "the faces at vertex {v} leave no room for another there"),
            Self::IdTaken(id) => write!(f, "the id {id} is in use"),
        }
    }
}

impl std::error::Error for AddFaceError {}

impl Mesh {
    /// Adds a face with these corners, counter-clockwise as seen from outside, and the edges it needs. Costs
    /// O(corners * valence).
    ///
    /// # Errors
    /// [`AddFaceError`], which names vertices by their number; the mesh is unchanged.
    pub fn add_polygon(&mut self, corners: &[VertexId]) -> Result<FaceId, AddFaceError> {
        let n = corners.len();
        if n < 3 {
            return Err(AddFaceError::TooFewCorners(n));
        }
        let mut sorted = corners.to_vec();
        sorted.sort_unstable();
        if let Some(pair) = sorted.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(AddFaceError::RepeatedVertex(pair[0].raw()));
        }
        for &v in corners {
            if !self.has_vertex(v) {
                return Err(AddFaceError::NoSuchVertex(v.raw()));
            }
            if self.halfedge_from(v).is_some() && !self.is_boundary_vertex(v) {
                return Err(AddFaceError::VertexClosed(v.raw()));
            }
        }
        let side = |i: usize| (corners[i % n], corners[(i + 1) % n]);
        let found: Vec<Option<HalfedgeId>> =
            (0..n).map(|i| self.find_halfedge(side(i).0, side(i).1)).collect();
        for (i, h) in found.iter().enumerate() {
            if h.is_some_and(|h| !self.is_boundary_halfedge(h)) {
                return Err(AddFaceError::SideTaken(side(i).0.raw(), side(i).1.raw()));
            }
        }
        // All links are read first and written at the end.
        let mut links = Vec::with_capacity(3 * n);
        for i in 0..n {
            let (Some(into), Some(out)) = (found[i], found[(i + 1) % n]) else { continue };
            if self.next(into) == out {
                continue;
            }
            // Other fans of faces lie between `into` and `out`: they move to the gap behind `out`'s own fan. If
            // that fan leads back to `into`, the face would close the vertex and leave no room for the others.
            let v = self.to(into);
            let gap = self
                .turn_from(out)
                .skip(1)
                .map(HalfedgeId::twin)
                .find(|&h| self.is_boundary_halfedge(h))
                .filter(|&h| h != into)
                .ok_or(AddFaceError::NoRoom(v.raw()))?;
            links.push((gap, self.next(into)));
            links.push((self.prev(out), self.next(gap)));
            links.push((into, out));
        }
        let sides: Vec<HalfedgeId> =
            (0..n).map(|i| found[i].unwrap_or_else(|| self.add_edge(side(i).0, side(i).1))).collect();
        let face = self.add_face(sides[0]);
        for i in 0..n {
            let (into, out) = (sides[i], sides[(i + 1) % n]);
            let v = side(i).1;
            match (found[i], found[(i + 1) % n]) {
                (Some(_), Some(_)) => {}
                (None, Some(_)) => links.push((self.prev(out), into.twin())),
                (Some(_), None) => links.push((out.twin(), self.next(into))),
                (None, None) => match self.halfedge_from(v) {
                    None => links.push((out.twin(), into.twin())),
                    Some(gap) => {
                        links.push((self.prev(gap), into.twin()));
                        links.push((out.twin(), gap));
                    }
                },
            }
            links.push((into, out));
        }
        for (h, next) in links {
            self.link(h, next);
        }
        for &h in &sides {
            self.set_face(h, Some(face));
        }
        for &h in &sides {
            self.restore_vertex_halfedge(self.from(h), h);
        }
        Ok(face)
    }
}

/// A mesh whose vertices and cells (faces) have ids given by the caller, which may have gaps.
#[derive(Clone, Debug, Default)]
pub struct GivenIds {
    mesh: Mesh,
    vertices: HashMap<u32, VertexId>,
    cells: HashMap<u32, FaceId>,
    vertex_ids: Vec<u32>,
    cell_ids: Vec<u32>,
}

impl GivenIds {
    /// An empty mesh.
    pub fn new() -> Self {
        Self::default()
    }

    /// The mesh so far, with its own ids.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// Adds vertices 0 to `n` - 1 to an empty mesh, all at the origin.
    ///
    /// # Errors
    /// [`AddFaceError::IdTaken`] if there are vertices already.
    pub fn add_vertices(&mut self, n: u32) -> Result<(), AddFaceError> {
        if let Some(&id) = self.vertex_ids.first() {
            return Err(AddFaceError::IdTaken(id));
        }
        (0..n).try_for_each(|id| self.add_vertex(id).map(drop))
    }

    /// Adds a vertex with this id, at the origin.
    pub fn add_vertex(&mut self, id: u32) -> Result<VertexId, AddFaceError> {
        if self.vertices.contains_key(&id) {
            return Err(AddFaceError::IdTaken(id));
        }
        let v = self.mesh.add_vertex(Vec3::ZERO);
        self.vertices.insert(id, v);
        self.vertex_ids.push(id);
        Ok(v)
    }

    /// Adds a cell with this id and these corners, and the missing vertices and edges it needs.
    pub fn add_cell(&mut self, id: u32, corners: &[u32]) -> Result<FaceId, AddFaceError> {
        if self.cells.contains_key(&id) {
            return Err(AddFaceError::IdTaken(id));
        }
        if corners.len() < 3 {
            return Err(AddFaceError::TooFewCorners(corners.len()));
        }
        let mut sorted = corners.to_vec();
        sorted.sort_unstable();
        if let Some(pair) = sorted.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(AddFaceError::RepeatedVertex(pair[0]));
        }
        let first_new = self.vertex_ids.len();
        for &corner in corners {
            if !self.vertices.contains_key(&corner) {
                self.add_vertex(corner)?;
            }
        }
        let ours: Vec<VertexId> = corners.iter().filter_map(|c| self.vertices.get(c).copied()).collect();
        match self.mesh.add_polygon(&ours) {
            Ok(face) => {
                self.cells.insert(id, face);
                self.cell_ids.push(id);
                Ok(face)
            }
            Err(error) => {
                for id in self.vertex_ids.split_off(first_new) {
                    self.vertices.remove(&id);
                    self.mesh.pop_isolated_vertex();
                }
                Err(self.in_given_ids(error))
            }
        }
    }

    /// Moves a vertex.
    pub fn set_position(&mut self, id: u32, position: Vec3) -> Result<(), AddFaceError> {
        let v = self.vertex(id).ok_or(AddFaceError::NoSuchVertex(id))?;
        self.mesh.set_position(v, position);
        Ok(())
    }

    /// The mesh's vertex for a given id.
    pub fn vertex(&self, id: u32) -> Option<VertexId> {
        self.vertices.get(&id).copied()
    }

    /// The mesh's face for a given cell id.
    pub fn cell(&self, id: u32) -> Option<FaceId> {
        self.cells.get(&id).copied()
    }

    /// The given ids of all vertices, in the order in which they were added.
    pub fn vertex_ids(&self) -> &[u32] {
        &self.vertex_ids
    }

    /// The given ids of all cells, in the order in which they were added.
    pub fn cell_ids(&self) -> &[u32] {
        &self.cell_ids
    }

    /// The largest vertex id in use; that + 1 is free.
    pub fn max_vertex_id(&self) -> Option<u32> {
        self.vertex_ids.iter().copied().max()
    }

    /// The largest cell id in use; that + 1 is free.
    pub fn max_cell_id(&self) -> Option<u32> {
        self.cell_ids.iter().copied().max()
    }

    /// The finished mesh. Where fans of faces meet at a vertex without sharing an edge, each but the first gets a
    /// copy of the vertex at the end, which a note says.
    pub fn finish(self) -> (Mesh, Vec<Note>) {
        if self.mesh.validate().is_ok() {
            return (self.mesh, Vec::new());
        }
        match Mesh::build(self.mesh.to_soup()) {
            Ok(built) => (built.mesh, built.notes),
            // Impossible: ids would have run out while faces were added.
            Err(_) => (self.mesh, Vec::new()),
        }
    }

    fn in_given_ids(&self, error: AddFaceError) -> AddFaceError {
        let given = |v: u32| self.vertex_ids.get(v as usize).copied().unwrap_or(v);
        match error {
            AddFaceError::SideTaken(a, b) => AddFaceError::SideTaken(given(a), given(b)),
            AddFaceError::VertexClosed(v) => AddFaceError::VertexClosed(given(v)),
            AddFaceError::NoRoom(v) => AddFaceError::NoRoom(given(v)),
            other => other,
        }
    }
}
