//! Boundary loops and connected components of the active mesh, counted over several frames.
//!
//! Each count takes a pass over the whole mesh, which at a million faces is longer than a frame. The status
//! bar can wait for it; the page can't.

use editor::{Changes, Editor, ObjectChange, ObjectId};
use halfedge::{Budget, InParts, Mesh, Topology, TopologyCounter};

/// A count that continues from frame to frame.
#[derive(Debug, Default)]
pub struct Survey {
    object: Option<ObjectId>,
    /// The number of vertices when the count began: removing an isolated one changes no half-edge.
    vertices: usize,
    found: Option<Topology>,
    /// Whether the active object has a mesh that is not counted yet.
    is_due: bool,
    counter: Option<TopologyCounter>,
}

impl Survey {
    /// The counts; none while counting, or if there is no mesh.
    pub fn found(&self) -> Option<Topology> {
        self.found
    }

    /// Starts over if connectivity changed; moving vertices or painting faces doesn't affect the counts.
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

    /// Counts more of the active mesh, as much as the budget allows; returns whether another frame is needed, to
    /// count the rest or to show the result.
    pub fn step(&mut self, mesh: Option<&Mesh>, budget: &mut Budget) -> bool {
        let Some(mesh) = mesh.filter(|_| self.is_due) else { return false };
        let counter = self.counter.get_or_insert_with(|| TopologyCounter::new(mesh));
        self.found = counter.step(mesh, budget);
        if self.found.is_some() {
            self.is_due = false;
            self.counter = None;
        }
        true
    }
}
