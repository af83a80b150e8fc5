//! Building a mesh from a polygon soup, in time linear in the number of corners.
//!
//! Input that is an oriented manifold takes one pass: the edges found so far are kept in a list for each
//! smaller end vertex, so that finding a face's neighbour tests the few edges of one vertex. At the first
//! sign of anything else (an edge used twice in one direction, a repeated corner) the build starts over
//! with [`repair`], which turns any soup into an oriented manifold.

use crate::mesh::assembly::Assembly;
use crate::mesh::attribute::Column;
use crate::mesh::{Mesh, Note, NoteKind, PolygonSoup, repair};
use crate::{Element, NONE};
use glam::Vec3;
use std::fmt;

/// A mesh built from a soup, with notes of what had to be changed.
#[derive(Debug)]
pub struct Built {
    /// The mesh: compact and valid, with the faces and their first corners in the soup's order.
    pub mesh: Mesh,
    /// One note for each kind of change; none for an oriented manifold.
    pub notes: Vec<Note>,
    /// Per face of the mesh, the soup's face that it comes from.
    pub face_source: Vec<u32>,
    /// The soup as it was given, where something was changed.
    pub original: Option<PolygonSoup>,
}

/// The soup has more corners than ids can number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooLarge {
    /// The number of the soup's corners.
    pub corners: usize,
}

impl fmt::Display for TooLarge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the mesh has {} face corners; at most {} can be numbered", self.corners, Mesh::MAX_EDGES)
    }
}

impl std::error::Error for TooLarge {}

impl Mesh {
    /// Builds a mesh from a soup. Vertices keep their numbers; copies of vertices that had to be separated are
    /// at the end. Bad geometry is no error: what doesn't form a manifold is repaired and noted. Costs
    /// O(corners).
    ///
    /// # Errors
    /// [`TooLarge`] if ids run out.
    pub fn build(soup: PolygonSoup) -> Result<Built, TooLarge> {
        if soup.corners.len() > Self::MAX_EDGES || soup.positions.len() >= NONE as usize {
            return Err(TooLarge { corners: soup.corners.len() });
        }
        let mut soup = soup;
        let mut notes = Vec::new();
        let bad: Vec<u32> =
            (0..soup.positions.len() as u32).filter(|&v| !soup.positions[v as usize].is_finite()).collect();
        let mut not_finite: Vec<(usize, Vec3)> = Vec::new();
        if !bad.is_empty() {
            for v in bad.iter().map(|&v| v as usize) {
                not_finite.push((v, std::mem::take(&mut soup.positions[v])));
            }
            notes.push(Note::new(NoteKind::PositionNotFinite, bad));
        }
        let (assembly, corner_source, face_source) = match assemble_manifold(&soup) {
            Some(assembly) => (assembly, None, (0..soup.face_count() as u32).collect()),
            None => {
                let repaired = repair::assemble(&soup);
                notes.extend(repaired.notes);
                (repaired.assembly, Some(repaired.corner_source), repaired.face_source)
            }
        };
        let given = soup.positions.len() as u32;
        let (raw, split, corner_halfedge) = assembly.finish(std::mem::take(&mut soup.positions));
        let mut mesh = Self::from_raw(raw);
        let halfedges = mesh.halfedge_capacity();
        if !split.is_empty() {
            // A vertex with three fans or more has several copies.
            let mut separated = split.clone();
            separated.sort_unstable();
            separated.dedup();
            notes.push(Note::new(NoteKind::VertexSeparated, separated));
        }
        let is_changed = !notes.is_empty();
        // The columns of a soup that is no longer needed are freed one by one, to save memory.
        let mut carry = |columns: &mut Vec<Column>, element: Element, source: &[u32]| {
            for column in std::mem::take(columns) {
                mesh.insert_column(element, column.gather(source.iter().copied()));
                if is_changed {
                    columns.push(column);
                }
            }
        };
        if !soup.vertex_columns.is_empty() {
            let source: Vec<u32> = (0..given).chain(split).collect();
            carry(&mut soup.vertex_columns, Element::Vertex, &source);
        }
        if !soup.corner_columns.is_empty() {
            let mut source = vec![NONE; halfedges];
            for (corner, &h) in corner_halfedge.iter().enumerate() {
                source[h as usize] = corner_source.as_ref().map_or(corner as u32, |from| from[corner]);
            }
            carry(&mut soup.corner_columns, Element::Halfedge, &source);
        }
        carry(&mut soup.face_columns, Element::Face, &face_source);
        let original = is_changed.then(|| {
            soup.positions = mesh.positions()[..given as usize].to_vec();
            for (v, position) in not_finite {
                soup.positions[v] = position;
            }
            soup
        });
        Ok(Built { mesh, notes, face_source, original })
    }

    /// The soup of a mesh: its positions and faces with their attributes. Vertices are in order of id,
    /// renumbered without gaps.
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

/// Assembles an oriented manifold, in which vertices may have several fans; none for any other input.
fn assemble_manifold(soup: &PolygonSoup) -> Option<Assembly> {
    let vertices = soup.positions.len();
    // Below, a vertex number and one bit share a word.
    if vertices > (NONE >> 1) as usize {
        return None;
    }
    let corners = soup.corners.len();
    let edges = corners / 2 + corners / 32 + 16;
    let mut to: Vec<u32> = Vec::with_capacity(edges * 2);
    let mut face_of: Vec<u32> = Vec::with_capacity(edges * 2);
    let mut corner_halfedge: Vec<u32> = Vec::with_capacity(corners);
    // Edges listed by their smaller end: the last of each vertex; and for each edge its larger end, the
    // direction of its even side, and the edge before it in the same list.
    let mut latest = vec![NONE; vertices];
    let mut list: Vec<[u32; 2]> = Vec::with_capacity(edges);
    // Lists are short, except at the hub of a wheel, where searching a list of thousands for each of its edges
    // wouldn't be linear. The repair sorts instead and gives the same mesh.
    let mut steps_left = corners.saturating_mul(16);
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
                steps_left = steps_left.checked_sub(1)?;
            };
            // Marked at once, so that a face that returns along its own edge is detected.
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

/// Whether a face has at least three corners, all different.
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
