//! Boundary loops and connected components of the active mesh, counted some half-edges a frame.
//!
//! Both take a pass over the whole mesh, which at a million faces is longer than a frame; the
//! status bar can wait, the page can't.

use editor::{Changes, Editor, ObjectChange, ObjectId};
use halfedge::{Mesh, Topology, TopologyCounter};

/// Half-edges counted in one frame: a few milliseconds.
const HALFEDGES_PER_FRAME: usize = 200_000;

/// A count that continues from frame to frame.
#[derive(Debug, Default)]
pub struct Survey {
    object: Option<ObjectId>,
    /// How many vertices the mesh had when the count began: removing an isolated one relinks nothing.
    vertices: usize,
    found: Option<Topology>,
    /// Whether the active object has a mesh that isn't counted yet.
    is_due: bool,
    counter: Option<TopologyCounter>,
}

impl Survey {
    /// The counts; none while they are being made, or where there is no mesh.
    pub fn found(&self) -> Option<Topology> {
        self.found
    }

    /// Starts over where connectivity changed; moving vertices or painting faces changes nothing.
    pub fn follow(&mut self, editor: &Editor, changes: &Changes) {
        let active = editor.document().active().map(editor::Object::id);
        let vertices = editor.mesh().map_or(0, Mesh::vertex_count);
        let relinked = match active.and_then(|id| changes.of(id)) {
            None => false,
            Some(ObjectChange::Touched(touched)) => {
                !touched.halfedges.is_empty() || !touched.edges.is_empty()
            }
            Some(_) => true,
        };
        if active != self.object || vertices != self.vertices || relinked {
            *self = Self { object: active, vertices, is_due: active.is_some(), ..Self::default() };
        }
    }

    /// Counts some more of the active mesh; whether there is more to count.
    pub fn step(&mut self, mesh: Option<&Mesh>) -> bool {
        let Some(mesh) = mesh.filter(|_| self.is_due) else { return false };
        let counter = self.counter.get_or_insert_with(|| TopologyCounter::new(mesh));
        self.found = counter.advance(mesh, HALFEDGES_PER_FRAME);
        if self.found.is_some() {
            self.is_due = false;
            self.counter = None;
        }
        self.is_due
    }
}
