//! Boundary loops and connected pieces of the active mesh, counted a slice a frame.
//!
//! Both take a walk over the whole mesh, which at a million faces is longer than a frame; the
//! status bar can wait, the page can't.

use editor::{Changes, Editor, ObjectChange, ObjectId};
use halfedge::{HalfedgeId, Mesh, VertexId};

/// Half-edges looked at in one frame: a few milliseconds.
const SLICE: usize = 200_000;

/// What a survey found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Found {
    /// Closed loops of boundary half-edges.
    pub boundary_loops: usize,
    /// Half-edges with no face.
    pub boundary_halfedges: usize,
    /// Connected pieces; a vertex in no face is one.
    pub components: usize,
    /// Whether every face is a triangle.
    pub triangles_only: bool,
}

/// A count that goes on from frame to frame.
#[derive(Debug, Default)]
pub struct Survey {
    object: Option<ObjectId>,
    found: Option<Found>,
    walk: Option<Walk>,
}

#[derive(Debug, Default)]
struct Walk {
    seen_loops: Vec<u64>,
    seen_vertices: Vec<u64>,
    stack: Vec<VertexId>,
    next_halfedge: usize,
    next_vertex: usize,
    next_face: usize,
    loops: usize,
    boundary: usize,
    components: usize,
    polygons: usize,
}

impl Survey {
    /// What was found; none while it is still being counted, or where there is no mesh.
    pub fn found(&self) -> Option<Found> {
        self.found
    }

    /// Starts over where connectivity changed; moving vertices or painting faces changes nothing.
    pub fn follow(&mut self, editor: &Editor, changes: &Changes) {
        let active = editor.document().active().map(editor::Object::id);
        let relinked = match active.and_then(|id| changes.of(id)) {
            None => false,
            // An edit that adds a face or a vertex links half-edges too.
            Some(ObjectChange::Touched(touched)) => {
                !touched.halfedges.is_empty() || !touched.edges.is_empty()
            }
            Some(_) => true,
        };
        if active != self.object || relinked {
            self.object = active;
            self.found = None;
            self.walk = active.map(|_| Walk::default());
        }
    }

    /// Counts on; gives whether there is more to count.
    pub fn step(&mut self, mesh: Option<&Mesh>) -> bool {
        let (Some(mesh), Some(walk)) = (mesh, &mut self.walk) else { return false };
        if walk.advance(mesh, SLICE) {
            return true;
        }
        self.found = Some(Found {
            boundary_loops: walk.loops,
            boundary_halfedges: walk.boundary,
            components: walk.components,
            triangles_only: walk.polygons == 0,
        });
        self.walk = None;
        false
    }
}

impl Walk {
    fn advance(&mut self, mesh: &Mesh, slice: usize) -> bool {
        let mut left = slice;
        while left > 0 && self.next_halfedge < mesh.halfedge_capacity() {
            let h = HalfedgeId::new(self.next_halfedge);
            self.next_halfedge += 1;
            left -= 1;
            if !mesh.has_halfedge(h)
                || !mesh.is_boundary_halfedge(h)
                || !mark(&mut self.seen_loops, h.index())
            {
                continue;
            }
            self.loops += 1;
            // A loop is walked whole: it can't be left half-way. Most are short.
            for side in mesh.loop_of(h) {
                self.boundary += 1;
                left = left.saturating_sub(1);
                mark(&mut self.seen_loops, side.index());
            }
        }
        while left > 0 && self.next_face < mesh.face_capacity() {
            let face = mesh.face(self.next_face as u32);
            self.next_face += 1;
            left -= 1;
            if face.is_some_and(|f| mesh.face_halfedges(f).take(4).count() != 3) {
                self.polygons += 1;
            }
        }
        while left > 0 {
            if let Some(v) = self.stack.pop() {
                for w in mesh.neighbors(v) {
                    left = left.saturating_sub(1);
                    if mark(&mut self.seen_vertices, w.index()) {
                        self.stack.push(w);
                    }
                }
                continue;
            }
            if self.next_vertex >= mesh.vertex_capacity() {
                return false;
            }
            let v = VertexId::new(self.next_vertex);
            self.next_vertex += 1;
            left -= 1;
            if mesh.has_vertex(v) && mark(&mut self.seen_vertices, v.index()) {
                self.components += 1;
                self.stack.push(v);
            }
        }
        true
    }
}

/// Sets a bit; gives whether it was not set before.
fn mark(words: &mut Vec<u64>, index: usize) -> bool {
    let at = index / 64;
    if words.len() <= at {
        words.resize(at + 1, 0);
    }
    let bit = 1_u64 << (index % 64);
    words.get_mut(at).is_some_and(|word| {
        let fresh = *word & bit == 0;
        *word |= bit;
        fresh
    })
}
