//! Changes since the last call of [`crate::Editor::take_changes`], which lists and GPU buffers follow.

use crate::document::{Object, ObjectId};
use halfedge::geometry::BitSet;
use halfedge::{Mesh, Touched};

/// What changed since the last [`crate::Editor::take_changes`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Changes {
    /// Objects whose mesh changed, each once, and objects that were added or removed.
    pub objects: Vec<(ObjectId, ObjectChange)>,
    /// Objects whose control points changed, and Bezier objects that were added or removed, each once. The
    /// mesh of a surface changes with its control points, so a surface is in `objects` too.
    pub bezier: Vec<ObjectId>,
    /// Objects of which faces were hidden or shown, each once, with those faces.
    pub hidden: Vec<(ObjectId, BitSet)>,
    /// The list of objects, an object's name or visibility, or which object is active.
    pub document: bool,
    /// The document's materials or their images.
    pub materials: bool,
    /// The selection.
    pub selection: bool,
    /// What undo and redo would do.
    pub history: bool,
    /// Messages for the user.
    pub messages: bool,
    /// Which jobs are running.
    pub jobs: bool,
}

/// What changed about one object's mesh.
#[derive(Clone, Debug, PartialEq)]
pub enum ObjectChange {
    /// The object is new.
    Added,
    /// The object was removed.
    Gone,
    /// Any element may have changed.
    Everything,
    /// These elements changed; no other did. Ids past the end of the mesh were removed.
    Touched(Touched),
}

/// Above this many elements, or about a quarter of the mesh's half-edges, listing the elements costs more
/// than it saves.
const MAX_LISTED_ELEMENTS: usize = 1 << 20;

impl Changes {
    /// Whether nothing changed.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// What changed about one object, if anything did.
    pub fn of(&self, id: ObjectId) -> Option<&ObjectChange> {
        self.objects.iter().find(|(object, _)| *object == id).map(|(_, change)| change)
    }

    pub(crate) fn added(&mut self, object: &Object) {
        let id = object.id();
        self.controls_of(object);
        self.document = true;
        match self.entry(id) {
            // The object was removed and restored between two calls of `take_changes`.
            Some(change) => *change = ObjectChange::Everything,
            None => self.objects.push((id, ObjectChange::Added)),
        }
    }

    pub(crate) fn gone(&mut self, object: &Object) {
        let id = object.id();
        self.controls_of(object);
        self.document = true;
        match self.entry(id) {
            Some(ObjectChange::Added) => self.objects.retain(|(object, _)| *object != id),
            Some(change) => *change = ObjectChange::Gone,
            None => self.objects.push((id, ObjectChange::Gone)),
        }
    }

    /// Another document took the place of one, with these objects each.
    pub(crate) fn replaced(&mut self, old: &[Object], new: &[Object]) {
        old.iter().for_each(|object| self.gone(object));
        new.iter().for_each(|object| self.added(object));
        (self.document, self.materials, self.selection) = (true, true, true);
        (self.history, self.jobs) = (true, true);
    }

    pub(crate) fn hid(&mut self, id: ObjectId, faces: BitSet) {
        self.document = true;
        match self.hidden.iter_mut().find(|(object, _)| *object == id) {
            // Some may be as they were, which does no harm.
            Some((_, changed)) => changed.union_with(&faces),
            None => self.hidden.push((id, faces)),
        }
    }

    fn controls_of(&mut self, object: &Object) {
        if object.bezier().is_some() {
            self.controls(object.id());
        }
    }

    pub(crate) fn controls(&mut self, id: ObjectId) {
        self.document = true;
        if !self.bezier.contains(&id) {
            self.bezier.push(id);
        }
    }

    pub(crate) fn everything(&mut self, id: ObjectId) {
        self.document = true;
        match self.entry(id) {
            Some(ObjectChange::Added) => {}
            Some(change) => *change = ObjectChange::Everything,
            None => self.objects.push((id, ObjectChange::Everything)),
        }
    }

    pub(crate) fn touched(&mut self, id: ObjectId, mesh: &Mesh, touched: Touched) {
        if touched.everything
            || element_count(&touched) > MAX_LISTED_ELEMENTS.min(mesh.halfedge_capacity() / 4 + 4096)
        {
            return self.everything(id);
        }
        match self.entry(id) {
            Some(ObjectChange::Added | ObjectChange::Everything) => {}
            Some(ObjectChange::Touched(earlier)) => {
                merge(&mut earlier.vertices, touched.vertices);
                merge(&mut earlier.halfedges, touched.halfedges);
                merge(&mut earlier.edges, touched.edges);
                merge(&mut earlier.faces, touched.faces);
            }
            Some(change @ ObjectChange::Gone) => *change = ObjectChange::Everything,
            None => self.objects.push((id, ObjectChange::Touched(touched))),
        }
    }

    fn entry(&mut self, id: ObjectId) -> Option<&mut ObjectChange> {
        self.objects.iter_mut().find(|(object, _)| *object == id).map(|(_, change)| change)
    }
}

fn element_count(touched: &Touched) -> usize {
    touched.vertices.len() + touched.halfedges.len() + touched.edges.len() + touched.faces.len()
}

fn merge<T: Ord>(into: &mut Vec<T>, more: Vec<T>) {
    into.extend(more);
    // The stable sort merges lists that are sorted already in linear time.
    into.sort();
    into.dedup();
}
