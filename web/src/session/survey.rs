//! Facts about the active mesh that take a pass over it, found over several frames: boundary loops and connected
//! components, and the dimensions, area and volume.
//!
//! At a million faces each takes longer than a frame. The panels can wait for it; the page can't.

use editor::{Changes, Editor, ObjectChange, ObjectId};
use halfedge::{Budget, InParts, Mesh, Topology, TopologyCounter};
use surface::measure::{SizeCounter, Sizes};

/// Counts that continue from frame to frame.
#[derive(Debug, Default)]
pub struct Survey {
    object: Option<ObjectId>,
    /// The number of vertices when the count began: removing an isolated one changes no half-edge.
    vertices: usize,
    topology: Counted<TopologyCounter>,
    sizes: Counted<SizeCounter>,
}

/// The result of a count, and the next count.
#[derive(Debug)]
struct Counted<C: InParts> {
    found: Option<C::Output>,
    /// Whether the mesh has changed since.
    is_due: bool,
    counter: Option<C>,
}

impl<C: InParts> Default for Counted<C> {
    fn default() -> Self {
        Self { found: None, is_due: false, counter: None }
    }
}

impl<C: for<'a> InParts<Input<'a> = &'a Mesh>> Counted<C> {
    fn start_over(&mut self) {
        (self.is_due, self.counter) = (true, None);
    }

    /// Counts more; returns whether there was anything to do.
    fn step(&mut self, mesh: &Mesh, budget: &mut Budget, start: impl FnOnce(&Mesh) -> C) -> bool {
        if !self.is_due {
            return false;
        }
        let counter = self.counter.get_or_insert_with(|| start(mesh));
        if let Some(found) = counter.step(mesh, budget) {
            *self = Self { found: Some(found), is_due: false, counter: None };
        }
        true
    }
}

impl Survey {
    /// The counts; none while counting, or if there is no mesh.
    pub fn found(&self) -> Option<Topology> {
        self.topology.found
    }

    /// The dimensions, area and volume; none while they are first measured, or if there is no mesh. While the mesh
    /// is being changed they may be those of a few frames ago.
    pub fn sizes(&self) -> Option<Sizes> {
        self.sizes.found
    }

    /// Starts over what a change affects; moving vertices or painting faces doesn't affect the topology.
    pub fn follow(&mut self, editor: &Editor, changes: &Changes) {
        let active = editor.document().active().map(editor::Object::id);
        let vertices = editor.mesh().map_or(0, Mesh::vertex_count);
        let change = active.and_then(|id| changes.of(id));
        let relinked = match change {
            None => false,
            Some(ObjectChange::Touched(touched)) => {
                !touched.halfedges.is_empty() || !touched.edges.is_empty()
            }
            Some(_) => true,
        };
        if active != self.object {
            self.sizes.found = None;
        }
        if active != self.object || vertices != self.vertices || relinked {
            self.topology = Counted::default();
            self.topology.start_over();
        }
        if active != self.object || vertices != self.vertices || change.is_some() {
            self.sizes.start_over();
        }
        (self.object, self.vertices) = (active, vertices);
    }

    /// Counts more of the active mesh, as much as the budget allows; returns whether another frame is needed, to
    /// count the rest or to show the result.
    pub fn step(&mut self, mesh: Option<&Mesh>, budget: &mut Budget) -> bool {
        let Some(mesh) = mesh else { return false };
        let counted = self.topology.step(mesh, budget, TopologyCounter::new);
        self.sizes.step(mesh, budget, |_| SizeCounter::default()) || counted
    }
}
