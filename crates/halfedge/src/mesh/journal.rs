//! Undo: writes to a mesh can be recorded together with the values before.
//!
//! A [`Journal`] takes memory in proportion to what was written, so undoing a local edit costs as little
//! as doing it, whatever the size of the mesh. Undoing is itself a sequence of recorded writes, whose
//! journal is the redo. Nothing else in the editor undoes changes of a mesh.

use crate::attribute::{Column, Value};
use crate::geometry::BitSet;
use crate::mesh::Mesh;
use crate::{EdgeId, Element, FaceId, HalfedgeId, NONE, VertexId};
use glam::Vec3;

/// Fewer moves than this are kept one by one, whatever the size of the mesh.
const MIN_MOVES_AS_COLUMN: usize = 10_000;

/// A write, with the value before.
#[derive(Clone, Debug)]
pub(crate) enum Change {
    Next(u32, u32),
    Prev(u32, u32),
    To(u32, u32),
    Face(u32, u32),
    VertexHalfedge(u32, u32),
    FaceHalfedge(u32, u32),
    Position(u32, Vec3),
    Positions(Box<[Vec3]>),
    Attribute(ColumnPlace, u32, Value),
    /// This column was replaced.
    Column(ColumnPlace, Box<Column>),
    /// A column was added at the end. The flag says whether it was blank: with the default everywhere, so that
    /// no element has another value than before.
    ColumnAdded(Element, bool),
    /// The last column was dropped. The flag says whether it was blank.
    ColumnGone(Element, Box<Column>, bool),
    /// A vertex, edge or face was added at the end.
    Added(Element),
    /// The vertex, edge or face at the end was dropped, after its values were reset.
    Dropped(Element),
    /// A vertex, edge or face was marked as removed, or as not removed.
    Marked(Element, u32, bool),
}

impl Change {
    /// What the write replaced: its kind, its column, and the element's number; none if it isn't a single value.
    fn place(&self) -> Option<(std::mem::Discriminant<Self>, u32, u32)> {
        let (column, index) = match *self {
            Self::Next(h, _) | Self::Prev(h, _) | Self::To(h, _) | Self::Face(h, _) => (0, h),
            Self::VertexHalfedge(v, _) | Self::Position(v, _) => (0, v),
            Self::FaceHalfedge(f, _) => (0, f),
            Self::Attribute(ColumnPlace(column), index, _) => (column, index),
            Self::Positions(_)
            | Self::Column(..)
            | Self::ColumnAdded(..)
            | Self::ColumnGone(..)
            | Self::Added(_)
            | Self::Dropped(_)
            | Self::Marked(..) => return None,
        };
        Some((std::mem::discriminant(self), column, index))
    }

    /// Whether a single value is in the mesh as it was before the write.
    fn is_taken_back(&self, mesh: &Mesh) -> bool {
        match *self {
            Self::Next(h, old) => mesh.next.get(h as usize) == Some(&old),
            Self::Prev(h, old) => mesh.prev.get(h as usize) == Some(&old),
            Self::To(h, old) => mesh.to.get(h as usize) == Some(&old),
            Self::Face(h, old) => mesh.face.get(h as usize) == Some(&old),
            Self::VertexHalfedge(v, old) => mesh.vertex_halfedge.get(v as usize) == Some(&old),
            Self::FaceHalfedge(f, old) => mesh.face_halfedge.get(f as usize) == Some(&old),
            Self::Position(v, old) => mesh
                .positions
                .get(v as usize)
                .is_some_and(|now| bytemuck::bytes_of(now) == bytemuck::bytes_of(&old)),
            Self::Attribute(place, index, old) => {
                let column = mesh.columns.of(place.element()).get(place.column());
                column
                    .and_then(|column| column.values.get(index as usize))
                    .is_some_and(|now| now.is_identical(old))
            }
            _ => false,
        }
    }
}

/// A kind of element and the index of one of its columns, in four bytes: a journal holds one for each
/// value written. The index has 30 bits; that many columns would take 64 GiB.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ColumnPlace(u32);

impl ColumnPlace {
    pub(crate) fn new(element: Element, column: usize) -> Self {
        debug_assert!(column < 1 << 30, "column {column} has no place in a journal");
        Self((column as u32) << 2 | element as u32)
    }

    fn element(self) -> Element {
        match self.0 & 3 {
            0 => Element::Vertex,
            1 => Element::Halfedge,
            2 => Element::Edge,
            _ => Element::Face,
        }
    }

    fn column(self) -> usize {
        (self.0 >> 2) as usize
    }
}

/// The writes to a mesh between [`Mesh::start_recording`] and [`Mesh::finish_recording`].
#[derive(Clone, Debug, Default)]
pub struct Journal {
    changes: Vec<Change>,
    /// New faces with the faces whose attributes they got, in the order in which they were made.
    face_sources: Vec<(FaceId, FaceId)>,
}

/// The elements that a journal's writes touched, each once, in order of id. They include elements that don't
/// exist: those that the edit removed, or that undoing it restores.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Touched {
    /// Vertices that were moved, relinked, added or removed, or got another attribute.
    pub vertices: Vec<VertexId>,
    /// Half-edges that were relinked, added or removed, or got another attribute.
    pub halfedges: Vec<HalfedgeId>,
    /// Edges that were added or removed, or got another attribute.
    pub edges: Vec<EdgeId>,
    /// Faces that were relinked, added or removed, or got another attribute.
    pub faces: Vec<FaceId>,
    /// Whether a whole column was added, replaced or dropped, so that every element may have changed. Blank
    /// columns, which the first value of an attribute adds, don't count.
    pub everything: bool,
}

impl Touched {
    /// Visits the faces that were added, removed, or changed a corner or its place, some of them several times.
    pub fn for_each_face(&self, mesh: &Mesh, mut visit: impl FnMut(FaceId)) {
        self.faces.iter().copied().for_each(&mut visit);
        for &v in self.vertices.iter().filter(|v| mesh.has_vertex(**v)) {
            mesh.vertex_faces(v).for_each(&mut visit);
        }
        for &h in self.halfedges.iter().filter(|h| mesh.has_halfedge(**h)) {
            mesh.face_of(h).into_iter().for_each(&mut visit);
        }
    }
}

impl Journal {
    /// Whether nothing was written: writes of equal values aren't recorded. A journal that isn't empty may still
    /// hold a change and its opposite: see [`Journal::changes_nothing`].
    pub fn is_empty(&self) -> bool {
        self.changes.is_empty()
    }

    /// Whether every value that was written is again what it was before. `mesh` is the mesh as the journal left it. A
    /// journal that added or removed elements, or replaced all values of a kind, counts as a change. Costs O(1) where the
    /// first write was a change, and at most O(journal).
    pub fn changes_nothing(&self, mesh: &Mesh) -> bool {
        let mut seen = std::collections::HashSet::new();
        self.changes.iter().all(|change| match change.place() {
            // Only the first write to a place knows what was there before.
            Some(place) => !seen.insert(place) || change.is_taken_back(mesh),
            None => false,
        })
    }

    /// Takes the new faces with the faces that they were cut from or that they follow, in the order in which they were made.
    /// Undoing doesn't need them.
    pub fn take_face_sources(&mut self) -> Vec<(FaceId, FaceId)> {
        std::mem::take(&mut self.face_sources)
    }

    /// Whether vertices were moved and nothing else was done. That breaks no rule of the mesh.
    pub fn is_of_moves(&self) -> bool {
        self.changes.iter().all(|change| matches!(change, Change::Position(..) | Change::Positions(_)))
    }

    /// The number of changes; replacing a whole column is one.
    pub fn len(&self) -> usize {
        self.changes.len()
    }

    /// Heap bytes in use, for the limit of the history.
    pub fn bytes(&self) -> usize {
        let heap: usize = self
            .changes
            .iter()
            .map(|change| match change {
                Change::Positions(positions) => std::mem::size_of_val::<[Vec3]>(positions),
                Change::Column(_, column) | Change::ColumnGone(_, column, _) => column.bytes(),
                _ => 0,
            })
            .sum();
        self.changes.len() * size_of::<Change>() + heap
    }

    /// Keeps only the first write to each vertex's position, so that a drag of a thousand steps takes the memory of one; of
    /// moves of much of a large mesh, the positions of all its vertices, which takes less memory and time. Journals with
    /// other writes stay as they are. The mesh is that after the writes.
    pub fn fold_moves(&mut self, mesh: &Mesh) {
        if !self.changes.iter().all(|c| matches!(c, Change::Position(..))) {
            return;
        }
        let mut seen = BitSet::new();
        self.changes.retain(|c| match c {
            Change::Position(v, _) => seen.insert(*v as usize),
            _ => true,
        });
        let moved = self.changes.len();
        if moved >= MIN_MOVES_AS_COLUMN && moved * 2 >= mesh.positions.len() {
            let mut before = mesh.positions.clone();
            for change in self.changes.drain(..) {
                if let Change::Position(v, old) = change {
                    before[v as usize] = old;
                }
            }
            self.changes = vec![Change::Positions(before.into_boxed_slice())];
        }
    }

    /// The elements that the writes touched.
    pub fn touched(&self) -> Touched {
        let (mut vertices, mut halfedges, mut edges, mut faces) = (vec![], vec![], vec![], vec![]);
        let mut everything = false;
        let mut added = |element: Element, raw: u32| match element {
            Element::Vertex => vertices.push(VertexId::new(raw as usize)),
            Element::Halfedge => halfedges.push(HalfedgeId::new(raw as usize)),
            Element::Edge => edges.push(EdgeId::new(raw as usize)),
            Element::Face => faces.push(FaceId::new(raw as usize)),
        };
        for change in &self.changes {
            match *change {
                Change::Next(h, _) | Change::Prev(h, _) | Change::To(h, _) => added(Element::Halfedge, h),
                Change::Face(h, old) => {
                    added(Element::Halfedge, h);
                    if old != NONE {
                        added(Element::Face, old);
                    }
                }
                Change::VertexHalfedge(v, _) | Change::Position(v, _) => added(Element::Vertex, v),
                Change::FaceHalfedge(f, _) => added(Element::Face, f),
                Change::Attribute(place, raw, _) => added(place.element(), raw),
                Change::Marked(element, raw, _) => added(element, raw),
                Change::ColumnAdded(_, blank) | Change::ColumnGone(_, _, blank) => everything |= !blank,
                Change::Positions(_) | Change::Column(..) => everything = true,
                Change::Added(_) | Change::Dropped(_) => {}
            }
        }
        vertices.sort_unstable();
        vertices.dedup();
        halfedges.sort_unstable();
        halfedges.dedup();
        edges.sort_unstable();
        edges.dedup();
        faces.sort_unstable();
        faces.dedup();
        Touched { vertices, halfedges, edges, faces, everything }
    }
}

impl Mesh {
    /// Starts recording writes; discards an unfinished recording.
    pub fn start_recording(&mut self) {
        self.journal = Some(Journal::default());
    }

    /// Stops recording; returns the writes since [`Mesh::start_recording`].
    pub fn finish_recording(&mut self) -> Journal {
        self.journal.take().unwrap_or_default()
    }

    /// The vertices that were moved since [`Mesh::start_recording`], each once in order of id, with the positions that
    /// they had then; for vertices added since, the origin. Costs O(writes).
    pub fn recorded_moves(&self) -> Vec<(VertexId, Vec3)> {
        let changes = self.journal.as_ref().map_or(&[][..], |journal| &journal.changes);
        let mut moves: Vec<(VertexId, Vec3)> = changes
            .iter()
            .filter_map(|change| match *change {
                Change::Position(v, old) => Some((VertexId::new(v as usize), old)),
                _ => None,
            })
            .collect();
        // The sort is stable, so the first write to each vertex is the one that stays.
        moves.sort_by_key(|(v, _)| *v);
        moves.dedup_by_key(|(v, _)| *v);
        moves
    }

    /// The elements that were written since [`Mesh::start_recording`]. Costs O(writes).
    pub fn recorded(&self) -> Touched {
        self.journal.as_ref().map(Journal::touched).unwrap_or_default()
    }

    /// The mesh as it was at [`Mesh::start_recording`]. Costs O(mesh).
    pub fn before_recording(&self) -> Self {
        let mut before = self.clone();
        before.undo(self.journal.clone().unwrap_or_default());
        before
    }

    /// Undoes the writes of a journal, the latest first; returns the journal that redoes them. The mesh must be
    /// as it was when the journal ended.
    pub fn undo(&mut self, journal: Journal) -> Journal {
        self.start_recording();
        for change in journal.changes.into_iter().rev() {
            self.revert(change);
        }
        self.finish_recording()
    }

    /// Runs an edit and returns its result with the journal; an error leaves the mesh as it was.
    ///
    /// Edits check before they write; the undo is for those that can't know beforehand.
    pub fn transaction<T, E>(
        &mut self,
        edit: impl FnOnce(&mut Self) -> Result<T, E>,
    ) -> Result<(T, Journal), E> {
        self.start_recording();
        let result = edit(self);
        let journal = self.finish_recording();
        match result {
            Ok(value) => Ok((value, journal)),
            Err(error) => {
                self.undo(journal);
                Err(error)
            }
        }
    }

    #[inline]
    pub(crate) fn record(&mut self, change: Change) {
        if let Some(journal) = &mut self.journal {
            journal.changes.push(change);
        }
    }

    /// Notes the face whose attributes a new face gets.
    pub(crate) fn record_face_source(&mut self, made: FaceId, source: FaceId) {
        if let Some(journal) = &mut self.journal {
            journal.face_sources.push((made, source));
        }
    }

    fn revert(&mut self, change: Change) {
        match change {
            Change::Next(h, old) => self.write_next(h, old),
            Change::Prev(h, old) => self.write_prev(h, old),
            Change::To(h, old) => self.write_to(h, old),
            Change::Face(h, old) => self.write_face(h, old),
            Change::VertexHalfedge(v, old) => self.write_vertex_halfedge(v, old),
            Change::FaceHalfedge(f, old) => self.write_face_halfedge(f, old),
            Change::Position(v, old) => self.set_position(VertexId::new(v as usize), old),
            Change::Positions(old) => {
                let now = std::mem::replace(&mut self.positions, old.into_vec());
                self.record(Change::Positions(now.into_boxed_slice()));
            }
            Change::Attribute(place, index, old) => {
                self.set_value(place.element(), place.column(), index as usize, old);
            }
            Change::Column(place, old) => {
                let now = std::mem::replace(&mut self.columns.of_mut(place.element())[place.column()], *old);
                self.record(Change::Column(place, Box::new(now)));
            }
            // All later writes are undone, so the column is as it was when it was added.
            Change::ColumnAdded(element, blank) => {
                if let Some(column) = self.columns.of_mut(element).pop() {
                    self.record(Change::ColumnGone(element, Box::new(column), blank));
                }
            }
            Change::ColumnGone(element, column, blank) => {
                self.columns.of_mut(element).push(*column);
                self.record(Change::ColumnAdded(element, blank));
            }
            Change::Added(element) => self.drop_last(element),
            Change::Dropped(element) => self.push_blank(element),
            Change::Marked(element, raw, on) => self.mark(element, raw, !on),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_recorded_write_takes_24_bytes() {
        assert_eq!(size_of::<Change>(), 24);
    }

    #[test]
    fn a_place_of_a_column_gives_back_what_it_was_made_of() {
        for element in Element::ALL {
            for column in [0, 1, 65_535, 65_536, (1 << 30) - 1] {
                let place = ColumnPlace::new(element, column);
                assert_eq!((place.element(), place.column()), (element, column));
            }
        }
    }
}
