//! Undo: every write to a mesh can be recorded with what was there before.
//!
//! A [`Journal`] costs memory in proportion to what was written, so undoing a local edit is as
//! cheap as doing it, on any size of mesh. Undoing is itself a sequence of recorded writes: its
//! journal is the redo. Nothing else in the editor knows how a mesh goes back.

use crate::attribute::{Column, Value};
use crate::mesh::Mesh;
use crate::{EdgeId, Element, FaceId, HalfedgeId, NONE, VertexId};
use glam::Vec3;

/// One write, with what was there before it.
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
    /// A column was put in place of this one.
    Column(ColumnPlace, Box<Column>),
    /// A column was added behind the others. Whether it was blank, with the default everywhere: then no
    /// element has another value than before.
    ColumnAdded(Element, bool),
    /// The column that was last is gone. Whether it was blank.
    ColumnGone(Element, Box<Column>, bool),
    /// A vertex, edge or face was added at the end.
    Added(Element),
    /// The vertex, edge or face at the end, all its values reset beforehand, is gone.
    Dropped(Element),
    /// A vertex, edge or face was marked as removed, or the mark was taken off.
    Marked(Element, u32, bool),
}

/// A kind of element and the number of one of its columns, in four bytes: a journal holds one for each
/// value written. The number has 30 bits; the columns themselves would fill 64 GiB first.
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

/// What was written to a mesh between [`Mesh::start_recording`] and [`Mesh::finish_recording`].
#[derive(Clone, Debug, Default)]
pub struct Journal {
    changes: Vec<Change>,
}

/// The elements that a journal's writes touched, each once, in order of id. Ids past the end of
/// the mesh (elements that the undo will bring back or the edit took away) are among them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Touched {
    /// Vertices moved, relinked, added or removed, or with another attribute.
    pub vertices: Vec<VertexId>,
    /// Half-edges relinked, added or removed, or with another attribute.
    pub halfedges: Vec<HalfedgeId>,
    /// Edges added or removed, or with another attribute.
    pub edges: Vec<EdgeId>,
    /// Faces relinked, added or removed, or with another attribute.
    pub faces: Vec<FaceId>,
    /// Whether a whole column was put in, replaced or taken away, so that every element may have
    /// changed. A column that is blank, as the first value of an attribute makes it, doesn't count.
    pub everything: bool,
}

impl Journal {
    /// Whether nothing was changed: writes of what was there already are not recorded. A journal that
    /// isn't empty may still end where it began, by a change and its opposite.
    pub fn is_empty(&self) -> bool {
        self.changes.is_empty()
    }

    /// Heap bytes in use; what a bounded history counts.
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

    /// Forgets all but the first write to each vertex's position: a drag of a thousand steps costs
    /// the memory of one. Only for journals with nothing but position writes; others stay as they are.
    pub fn fold_moves(&mut self) {
        if !self.changes.iter().all(|c| matches!(c, Change::Position(..))) {
            return;
        }
        let mut seen = std::collections::HashSet::new();
        self.changes.retain(|c| match c {
            Change::Position(v, _) => seen.insert(*v),
            _ => true,
        });
    }

    /// The elements that were touched.
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
    /// Starts recording writes. What an unfinished recording holds is dropped.
    pub fn start_recording(&mut self) {
        self.journal = Some(Journal::default());
    }

    /// Stops recording and gives what was written since [`Mesh::start_recording`].
    pub fn finish_recording(&mut self) -> Journal {
        self.journal.take().unwrap_or_default()
    }

    /// Takes back what a journal recorded, the latest write first, and gives the journal that does
    /// it again. The mesh must be as the journal left it.
    pub fn undo(&mut self, journal: Journal) -> Journal {
        self.start_recording();
        for change in journal.changes.into_iter().rev() {
            self.revert(change);
        }
        self.finish_recording()
    }

    /// Runs an edit: an error leaves the mesh as it was, success gives the journal too.
    ///
    /// Edits check before they write, so the way back is for those that can't know beforehand.
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
            // Every write since has been taken back, so the column is as it was when it was added.
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

    // The writes that everything else is made of. Writing what is there already records nothing, so the
    // journal of an edit that changes nothing is empty.

    #[inline]
    pub(crate) fn write_next(&mut self, h: u32, value: u32) {
        let old = std::mem::replace(&mut self.next[h as usize], value);
        if old != value {
            self.record(Change::Next(h, old));
        }
    }

    #[inline]
    pub(crate) fn write_prev(&mut self, h: u32, value: u32) {
        let old = std::mem::replace(&mut self.prev[h as usize], value);
        if old != value {
            self.record(Change::Prev(h, old));
        }
    }

    #[inline]
    pub(crate) fn write_to(&mut self, h: u32, value: u32) {
        let old = std::mem::replace(&mut self.to[h as usize], value);
        if old != value {
            self.record(Change::To(h, old));
        }
    }

    #[inline]
    pub(crate) fn write_face(&mut self, h: u32, value: u32) {
        let old = std::mem::replace(&mut self.face[h as usize], value);
        if old != value {
            self.record(Change::Face(h, old));
        }
    }

    #[inline]
    pub(crate) fn write_vertex_halfedge(&mut self, v: u32, value: u32) {
        let old = std::mem::replace(&mut self.vertex_halfedge[v as usize], value);
        if old != value {
            self.record(Change::VertexHalfedge(v, old));
        }
    }

    #[inline]
    pub(crate) fn write_face_halfedge(&mut self, f: u32, value: u32) {
        let old = std::mem::replace(&mut self.face_halfedge[f as usize], value);
        if old != value {
            self.record(Change::FaceHalfedge(f, old));
        }
    }

    /// Marks a vertex, edge or face as removed, or takes the mark off.
    pub(crate) fn mark(&mut self, element: Element, raw: u32, on: bool) {
        let marks = match element {
            Element::Vertex => &mut self.removed_vertices,
            Element::Edge | Element::Halfedge => &mut self.removed_edges,
            Element::Face => &mut self.removed_faces,
        };
        let changes = if on { marks.insert(raw as usize) } else { marks.remove(raw as usize) };
        if changes {
            self.record(Change::Marked(element, raw, on));
        }
    }

    /// Adds a vertex, edge or face with nothing linked and default attributes.
    pub(crate) fn push_blank(&mut self, element: Element) {
        match element {
            Element::Vertex => {
                self.positions.push(Vec3::ZERO);
                self.vertex_halfedge.push(NONE);
            }
            Element::Edge | Element::Halfedge => {
                for column in [&mut self.next, &mut self.prev, &mut self.to, &mut self.face] {
                    column.extend([NONE, NONE]);
                }
            }
            Element::Face => self.face_halfedge.push(NONE),
        }
        self.fit_columns(element);
        self.record(Change::Added(element));
    }

    /// Drops the last vertex, edge or face, recording its values first so that redo has them.
    fn drop_last(&mut self, element: Element) {
        let last = self.capacity(element).wrapping_sub(1) as u32;
        self.reset_columns(element, last);
        match element {
            Element::Vertex => {
                self.set_position(VertexId::new(last as usize), Vec3::ZERO);
                self.write_vertex_halfedge(last, NONE);
                self.positions.pop();
                self.vertex_halfedge.pop();
            }
            Element::Edge | Element::Halfedge => {
                for h in [last * 2, last * 2 + 1] {
                    self.reset_columns(Element::Halfedge, h);
                    self.write_next(h, NONE);
                    self.write_prev(h, NONE);
                    self.write_to(h, NONE);
                    self.write_face(h, NONE);
                }
                for column in [&mut self.next, &mut self.prev, &mut self.to, &mut self.face] {
                    column.truncate(last as usize * 2);
                }
            }
            Element::Face => {
                self.write_face_halfedge(last, NONE);
                self.face_halfedge.pop();
            }
        }
        self.fit_columns(element);
        self.record(Change::Dropped(element));
    }

    fn reset_columns(&mut self, element: Element, raw: u32) {
        for at in 0..self.columns.of(element).len() {
            let default = self.columns.of(element)[at].default;
            self.set_value(element, at, raw as usize, default);
        }
    }

    /// Makes columns as long as their element's ids; an edge's half-edges come along.
    fn fit_columns(&mut self, element: Element) {
        let kinds: &[Element] = match element {
            Element::Edge | Element::Halfedge => &[Element::Edge, Element::Halfedge],
            Element::Vertex => &[Element::Vertex],
            Element::Face => &[Element::Face],
        };
        for &kind in kinds {
            let len = self.capacity(kind);
            for column in self.columns.of_mut(kind) {
                column.values.resize(len, column.default);
            }
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
