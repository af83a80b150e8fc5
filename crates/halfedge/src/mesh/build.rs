//! Polygon soup to mesh, in time linear in the number of corners.
//!
//! Input that is an oriented manifold takes one pass: the edges met so far are kept in a list per
//! smaller end vertex, so finding a face's neighbour looks at the few edges of one vertex. At the
//! first sign of anything else (an edge used twice in one direction, a corner that repeats) the
//! build starts over through [`repair`], which turns any soup into one that is.

use crate::geometry::BitSet;
use crate::mesh::repair::{self, Note, NoteKind};
use crate::mesh::soup::PolygonSoup;
use crate::mesh::{Mesh, RawMesh};
use crate::{Element, NONE};
use glam::Vec3;
use std::fmt;

/// A mesh made from a soup, and what had to be changed to make it one.
#[derive(Debug)]
pub struct Built {
    /// The mesh: compact, valid, faces in the soup's order, first corners first.
    pub mesh: Mesh,
    /// What was changed, one note for each kind of change; empty for an oriented manifold.
    pub notes: Vec<Note>,
    /// The soup's face that each face of the mesh comes from.
    pub face_source: Vec<u32>,
}

/// The soup has more corners than ids can number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooLarge {
    /// How many corners the soup has.
    pub corners: usize,
}

impl fmt::Display for TooLarge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the mesh has {} face corners; at most {} can be numbered", self.corners, Mesh::MAX_EDGES)
    }
}

impl std::error::Error for TooLarge {}

/// Faces whose sides are known to match: what both the quick way and the repair end in.
pub(crate) struct Assembly {
    /// `prev` and, for faces' half-edges, `next`.
    pub next: Vec<u32>,
    pub prev: Vec<u32>,
    pub to: Vec<u32>,
    pub face: Vec<u32>,
    pub face_halfedge: Vec<u32>,
    /// The half-edge made for each corner.
    pub corner_halfedge: Vec<u32>,
}

impl Assembly {
    pub(crate) fn with_capacity(faces: usize, corners: usize) -> Self {
        // A closed mesh has half as many edges as corners; boundaries add a few.
        let halfedges = corners + corners / 16 + 16;
        Self {
            next: Vec::with_capacity(halfedges),
            prev: Vec::with_capacity(halfedges),
            to: Vec::with_capacity(halfedges),
            face: Vec::with_capacity(halfedges),
            face_halfedge: Vec::with_capacity(faces),
            corner_halfedge: Vec::with_capacity(corners),
        }
    }

    /// A new edge whose even side goes `from` -> `to`; gives that side.
    #[inline]
    pub(crate) fn push_edge(&mut self, from: u32, to: u32) -> u32 {
        let h = self.to.len() as u32;
        self.to.push(to);
        self.to.push(from);
        self.face.push(NONE);
        self.face.push(NONE);
        self.next.push(NONE);
        self.next.push(NONE);
        self.prev.push(NONE);
        self.prev.push(NONE);
        h
    }

    #[inline]
    pub(crate) fn link(&mut self, h: u32, next: u32) {
        self.next[h as usize] = next;
        self.prev[next as usize] = h;
    }

    /// Links the sides pushed to `corner_halfedge` since the last face into a face.
    #[inline]
    pub(crate) fn close_face(&mut self, first_corner: usize) {
        let f = self.face_halfedge.len() as u32;
        let first = self.corner_halfedge[first_corner];
        let mut before = self.corner_halfedge[self.corner_halfedge.len() - 1];
        for corner in first_corner..self.corner_halfedge.len() {
            let h = self.corner_halfedge[corner];
            self.face[h as usize] = f;
            self.link(before, h);
            before = h;
        }
        self.face_halfedge.push(first);
    }

    /// Links boundary loops, gives each vertex its half-edge, and gives each further fan of faces
    /// at a vertex a vertex of its own at the end, whose sources are returned.
    fn finish(mut self, positions: Vec<Vec3>) -> (RawMesh, Vec<u32>, Vec<u32>) {
        let halfedges = self.to.len();
        for h in 0..halfedges as u32 {
            if self.face[h as usize] != NONE {
                continue;
            }
            // Turn round the vertex `h` points to, over its faces, to the next side without one.
            let mut out = h ^ 1;
            loop {
                out = self.prev[out as usize] ^ 1;
                if self.face[out as usize] == NONE {
                    break;
                }
            }
            self.link(h, out);
        }
        let (vertex_halfedge, several_fans) = self.first_fans(positions.len());
        let mut positions = positions;
        let mut vertex_halfedge = vertex_halfedge;
        let split = self.separate_fans(&several_fans, &mut positions, &mut vertex_halfedge);
        let raw = RawMesh {
            positions,
            vertex_halfedge,
            next: self.next,
            prev: self.prev,
            to: self.to,
            face: self.face,
            face_halfedge: self.face_halfedge,
            columns: Default::default(),
        };
        (raw, split, self.corner_halfedge)
    }

    /// For each vertex a half-edge that leaves it, a boundary one of its first fan if there is one;
    /// and the vertices with further fans.
    fn first_fans(&self, vertices: usize) -> (Vec<u32>, BitSet) {
        let mut halfedge = vec![NONE; vertices];
        let mut leaving = vec![0u32; vertices];
        for (edge, ends) in self.to.as_chunks::<2>().0.iter().enumerate() {
            for (side, from) in [(0, ends[1] as usize), (1, ends[0] as usize)] {
                leaving[from] += 1;
                if halfedge[from] == NONE {
                    halfedge[from] = (edge * 2 + side) as u32;
                }
            }
        }
        let mut several = BitSet::default();
        for (v, first) in halfedge.iter_mut().enumerate() {
            let start = *first;
            if start == NONE {
                continue;
            }
            let mut out = start;
            let mut met = 0;
            loop {
                met += 1;
                if self.face[out as usize] == NONE {
                    *first = out;
                }
                out = self.next[out as usize ^ 1];
                if out == start {
                    break;
                }
            }
            if met < leaving[v] {
                several.insert(v);
            }
        }
        (halfedge, several)
    }

    /// Gives every fan but the first of these vertices a copy of its own, in order of the fans'
    /// first half-edges; returns the vertex that each copy is of.
    fn separate_fans(
        &mut self,
        several: &BitSet,
        positions: &mut Vec<Vec3>,
        vertex_halfedge: &mut Vec<u32>,
    ) -> Vec<u32> {
        let mut split = Vec::new();
        if several.is_empty() {
            return split;
        }
        let mut seen = BitSet::default();
        let mut has_first = BitSet::default();
        for h in 0..self.to.len() as u32 {
            let v = self.to[h as usize ^ 1];
            if seen.contains(h as usize) || !several.contains(v as usize) {
                continue;
            }
            let mut first = h;
            let mut out = h;
            loop {
                seen.insert(out as usize);
                if self.face[out as usize] == NONE {
                    first = out;
                }
                out = self.next[out as usize ^ 1];
                if out == h {
                    break;
                }
            }
            if !has_first.contains(v as usize) {
                has_first.insert(v as usize);
                continue;
            }
            let copy = positions.len() as u32;
            positions.push(positions[v as usize]);
            vertex_halfedge.push(first);
            split.push(v);
            loop {
                self.to[out as usize ^ 1] = copy;
                out = self.next[out as usize ^ 1];
                if out == h {
                    break;
                }
            }
        }
        split
    }
}

impl Mesh {
    /// Builds a mesh from a soup. Vertex numbers are kept; vertices that had to be separated are
    /// at the end. Never fails on bad geometry: what doesn't fit a manifold is repaired and noted.
    ///
    /// # Errors
    /// [`TooLarge`] when ids would run out.
    pub fn build(soup: PolygonSoup) -> Result<Built, TooLarge> {
        if soup.corners.len() > Self::MAX_EDGES || soup.positions.len() >= NONE as usize {
            return Err(TooLarge { corners: soup.corners.len() });
        }
        let mut soup = soup;
        let mut notes = Vec::new();
        let bad: Vec<u32> =
            (0..soup.positions.len() as u32).filter(|&v| !soup.positions[v as usize].is_finite()).collect();
        if !bad.is_empty() {
            for &v in &bad {
                soup.positions[v as usize] = Vec3::ZERO;
            }
            notes.push(Note::new(NoteKind::PositionNotFinite, bad));
        }
        let (assembly, corner_source, face_source) = match quick(&soup) {
            Some(assembly) => (assembly, None, (0..soup.face_count() as u32).collect()),
            None => {
                let repaired = repair::assemble(&soup);
                notes.extend(repaired.notes);
                (repaired.assembly, Some(repaired.corner_source), repaired.face_source)
            }
        };
        let PolygonSoup { positions, vertex_columns, corner_columns, face_columns, .. } = soup;
        let given = positions.len() as u32;
        let (raw, split, corner_halfedge) = assembly.finish(positions);
        let mut mesh = Self::from_raw(raw);
        if !split.is_empty() {
            // A vertex with three fans or more has several copies.
            let mut separated = split.clone();
            separated.sort_unstable();
            separated.dedup();
            notes.push(Note::new(NoteKind::VertexSeparated, separated));
        }
        let vertices = || (0..given).chain(split.iter().copied());
        for column in vertex_columns {
            mesh.insert_column(Element::Vertex, column.gather(vertices()));
        }
        if !corner_columns.is_empty() {
            let mut source = vec![NONE; mesh.halfedge_capacity()];
            for (corner, &h) in corner_halfedge.iter().enumerate() {
                source[h as usize] = corner_source.as_ref().map_or(corner as u32, |from| from[corner]);
            }
            for column in corner_columns {
                mesh.insert_column(Element::Halfedge, column.gather(source.iter().copied()));
            }
        }
        for column in face_columns {
            mesh.insert_column(Element::Face, column.gather(face_source.iter().copied()));
        }
        Ok(Built { mesh, notes, face_source })
    }

    /// The soup of a mesh: its positions and faces with their attributes, vertices in order of id.
    /// Ids must have no gaps; a mesh that has some is compacted first.
    pub fn to_soup(&self) -> PolygonSoup {
        if !self.is_compact() {
            return self.compacted().0.to_soup();
        }
        let mut soup = PolygonSoup { positions: self.positions.clone(), ..PolygonSoup::default() };
        soup.corners.reserve(self.halfedge_capacity());
        soup.face_starts.reserve(self.face_capacity());
        let mut sources = Vec::with_capacity(self.halfedge_capacity());
        for f in self.faces() {
            for h in self.face_halfedges(f) {
                soup.corners.push(self.from(h).raw());
                sources.push(h.raw());
            }
            soup.face_starts.push(soup.corners.len() as u32);
        }
        soup.vertex_columns = self.columns.of(Element::Vertex).to_vec();
        soup.face_columns = self.columns.of(Element::Face).to_vec();
        soup.corner_columns = self
            .columns
            .of(Element::Halfedge)
            .iter()
            .map(|column| column.gather(sources.iter().copied()))
            .collect();
        soup
    }
}

/// The build for input that is an oriented manifold but for vertices with several fans; none for
/// any other.
fn quick(soup: &PolygonSoup) -> Option<Assembly> {
    let vertices = soup.positions.len();
    // A vertex number and one bit share a word below.
    if vertices > (NONE >> 1) as usize {
        return None;
    }
    let corners = soup.corners.len();
    let edges = corners / 2 + corners / 32 + 16;
    let mut to: Vec<u32> = Vec::with_capacity(edges * 2);
    let mut face_of: Vec<u32> = Vec::with_capacity(edges * 2);
    let mut corner_halfedge: Vec<u32> = Vec::with_capacity(corners);
    // Edges by smaller end: the latest of each vertex; and for each edge its larger end, which way
    // its even side runs, and the edge before it in the list of the same vertex.
    let mut latest = vec![NONE; vertices];
    let mut list: Vec<[u32; 2]> = Vec::with_capacity(edges);
    // Lists are a few edges long but at the hub of a wheel; walking a list of thousands for each of
    // its edges would not be linear. The repair sorts instead and gives the same mesh.
    let mut patience = corners.saturating_mul(16);
    for face in 0..soup.face_count() {
        let corners = soup.face(face);
        if !has_distinct_corners(corners) {
            return None;
        }
        let &first = corners.first()?;
        if first as usize >= vertices {
            return None;
        }
        let mut u = first;
        for &v in corners.iter().skip(1).chain([&first]) {
            if v as usize >= vertices {
                return None;
            }
            let (slot, end) = if u < v { (u, v * 2) } else { (v, u * 2 + 1) };
            let head = &mut latest[slot as usize];
            let mut edge = *head;
            let h = loop {
                let Some(&[other_end, before]) = list.get(edge as usize) else {
                    let edge = list.len() as u32;
                    list.push([end, *head]);
                    *head = edge;
                    to.extend_from_slice(&[v, u]);
                    face_of.extend_from_slice(&[NONE, NONE]);
                    break edge * 2;
                };
                if other_end == end ^ 1 {
                    if face_of[edge as usize * 2 + 1] != NONE {
                        return None;
                    }
                    break edge * 2 + 1;
                }
                if other_end == end {
                    return None;
                }
                edge = before;
                patience = patience.checked_sub(1)?;
            };
            // Claimed at once, so that a face that comes back along its own edge is noticed.
            face_of[h as usize] = face as u32;
            corner_halfedge.push(h);
            u = v;
        }
    }
    let mut next = vec![NONE; to.len()];
    let mut prev = vec![NONE; to.len()];
    let mut face_halfedge = Vec::with_capacity(soup.face_count());
    let mut rest = corner_halfedge.as_slice();
    for face in soup.faces() {
        let (sides, after) = rest.split_at(face.len());
        rest = after;
        let mut before = *sides.last()?;
        for &h in sides {
            next[before as usize] = h;
            prev[h as usize] = before;
            before = h;
        }
        face_halfedge.push(*sides.first()?);
    }
    Some(Assembly { next, prev, to, face: face_of, face_halfedge, corner_halfedge })
}

/// Whether a face has three corners or more, all different.
pub(crate) fn has_distinct_corners(corners: &[u32]) -> bool {
    match corners {
        [] | [_] | [_, _] => false,
        [a, b, c] => a != b && b != c && c != a,
        many if many.len() <= 16 => {
            many.iter().enumerate().all(|(i, a)| many.iter().skip(i + 1).all(|b| a != b))
        }
        many => {
            let mut sorted = many.to_vec();
            sorted.sort_unstable();
            sorted.windows(2).all(|pair| pair[0] != pair[1])
        }
    }
}
