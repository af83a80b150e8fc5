//! The writes that every change of a mesh is made of. Each is recorded if it changes anything, so the journal of an
//! edit that changes nothing is empty.

use crate::mesh::Mesh;
use crate::mesh::journal::Change;
use crate::{Element, NONE, VertexId};
use glam::Vec3;

macro_rules! write_link {
    ($write:ident, $column:ident, $change:ident) => {
        #[inline]
        pub(crate) fn $write(&mut self, id: u32, value: u32) {
            let old = std::mem::replace(&mut self.$column[id as usize], value);
            if old != value {
                self.record(Change::$change(id, old));
            }
        }
    };
}

impl Mesh {
    write_link!(write_next, next, Next);
    write_link!(write_prev, prev, Prev);
    write_link!(write_to, to, To);
    write_link!(write_face, face, Face);
    write_link!(write_vertex_halfedge, vertex_halfedge, VertexHalfedge);
    write_link!(write_face_halfedge, face_halfedge, FaceHalfedge);

    /// Marks a vertex, edge or face as removed, or as not removed.
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

    /// Adds a vertex, edge or face without links, and with default attributes.
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

    /// Drops the last vertex, edge or face after recording its values for redo.
    pub(crate) fn drop_last(&mut self, element: Element) {
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

    /// Fits the length of columns to their element's ids; for edges also those of half-edges.
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
