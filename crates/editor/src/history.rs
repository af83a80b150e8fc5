//! Undo and redo: one mechanism for every command.
//!
//! A step is a list of [`Change`]s. Applying a change returns its inverse. Undo therefore applies a step's
//! changes in reverse, and their inverses form the redo step. A local edit is stored as a journal, an
//! operation on a whole mesh as the mesh that it replaced, so undoing a step costs no more than the step
//! itself did.
//!
//! A step without changes is a change of the selection. Edits don't count it: it is not among the labels, undoing an
//! edit forgets those made since, and making one forgets no edit that could be redone.

use crate::bezier::Bezier;
use crate::changes::Changes;
use crate::document::{Document, NamedSelection, Object, ObjectId};
use crate::selection::Selection;
use formats::Materials;
use glam::DVec3;
use halfedge::geometry::BitSet;
use halfedge::{Journal, Mesh, PolygonSoup, Touched};
use std::collections::VecDeque;
use std::sync::Arc;

/// One reversible change to a document.
#[derive(Debug)]
pub(crate) enum Change {
    /// Plays a journal back on the object's mesh.
    Journal(ObjectId, Journal),
    /// Replaces the object's mesh.
    Mesh(ObjectId, Arc<Mesh>),
    /// Replaces the object's control points, or removes them.
    Bezier(ObjectId, Option<Arc<Bezier>>),
    /// Replaces the faces from which the object can be repaired, or removes them.
    Soup(ObjectId, Option<Arc<PolygonSoup>>),
    /// Sets the offset that is added to every position on saving.
    Offset(DVec3),
    /// Sets the document's materials.
    Materials(Materials),
    /// Renames the object.
    Name(ObjectId, String),
    /// Shows or hides the object.
    Visible(ObjectId, bool),
    /// Hides these faces of the object and no others.
    Hidden(ObjectId, Arc<BitSet>),
    /// Replaces the object's named selections.
    NamedSelections(ObjectId, Arc<Vec<NamedSelection>>),
    /// Activates the object at this place in the list.
    Active(usize),
    /// Inserts an object at this place in the list.
    Insert(usize, Box<Object>),
    /// Removes the object at this place from the list.
    Remove(usize),
    /// Renames the document.
    DocumentName(String),
}

impl Change {
    /// Applies the change and returns its inverse; none if the change doesn't fit the document, which then
    /// stays as it was. Calls `reshaped` with an object whose element counts may have changed.
    pub fn make(
        self,
        document: &mut Document,
        changes: &mut Changes,
        mut reshaped: impl FnMut(ObjectId),
    ) -> Option<Self> {
        let find = |document: &Document, id| document.index_of(id);
        Some(match self {
            Self::Journal(id, journal) => {
                let at = find(document, id)?;
                let mesh = Arc::make_mut(&mut document.objects.get_mut(at)?.named.mesh);
                let vertices = mesh.vertex_count();
                let back = mesh.undo(journal);
                let touched = back.touched();
                if is_reshaping(&touched) || mesh.vertex_count() != vertices {
                    reshaped(id);
                }
                changes.touched(id, mesh, touched);
                Self::Journal(id, back)
            }
            Self::Mesh(id, mesh) => {
                let at = find(document, id)?;
                let old = std::mem::replace(&mut document.objects.get_mut(at)?.named.mesh, mesh);
                changes.everything(id);
                reshaped(id);
                Self::Mesh(id, old)
            }
            Self::Bezier(id, bezier) => {
                let at = find(document, id)?;
                let old = std::mem::replace(&mut document.objects.get_mut(at)?.named.bezier, bezier);
                changes.controls(id);
                Self::Bezier(id, old)
            }
            Self::Soup(id, soup) => {
                let at = find(document, id)?;
                changes.document = true;
                Self::Soup(id, std::mem::replace(&mut document.objects.get_mut(at)?.named.soup, soup))
            }
            Self::Offset(offset) => {
                changes.document = true;
                Self::Offset(std::mem::replace(&mut document.offset, offset))
            }
            Self::Materials(materials) => {
                (changes.document, changes.materials) = (true, true);
                Self::Materials(std::mem::replace(&mut document.materials, materials))
            }
            Self::Name(id, name) => {
                let at = find(document, id)?;
                changes.document = true;
                Self::Name(id, std::mem::replace(&mut document.objects.get_mut(at)?.named.name, name))
            }
            Self::Visible(id, visible) => {
                let at = find(document, id)?;
                changes.document = true;
                Self::Visible(id, std::mem::replace(&mut document.objects.get_mut(at)?.visible, visible))
            }
            Self::Hidden(id, hidden) => {
                let at = find(document, id)?;
                let old = std::mem::replace(&mut document.objects.get_mut(at)?.hidden, hidden.clone());
                let mut changed = (*old).clone();
                changed.toggle_with(&hidden);
                changes.hid(id, changed);
                Self::Hidden(id, old)
            }
            Self::NamedSelections(id, named) => {
                let at = find(document, id)?;
                changes.document = true;
                let object = document.objects.get_mut(at)?;
                Self::NamedSelections(id, std::mem::replace(&mut object.named_selections, named))
            }
            Self::Active(at) => {
                changes.document = true;
                Self::Active(std::mem::replace(&mut document.active, at))
            }
            Self::Insert(at, object) => {
                if at > document.objects.len() {
                    return None;
                }
                changes.added(object.id());
                if object.bezier().is_some() {
                    changes.controls(object.id());
                }
                document.objects.insert(at, *object);
                Self::Remove(at)
            }
            Self::Remove(at) => {
                if at >= document.objects.len() {
                    return None;
                }
                let object = document.objects.remove(at);
                changes.gone(object.id());
                if object.bezier().is_some() {
                    changes.controls(object.id());
                }
                reshaped(object.id());
                Self::Insert(at, Box::new(object))
            }
            Self::DocumentName(name) => {
                changes.document = true;
                Self::DocumentName(std::mem::replace(&mut document.name, name))
            }
        })
    }

    /// The only object that the change affects, if it is identified by id: such a change still fits after changes to
    /// other objects.
    pub fn object(&self) -> Option<ObjectId> {
        match self {
            Self::Journal(id, _)
            | Self::Mesh(id, _)
            | Self::Bezier(id, _)
            | Self::Soup(id, _)
            | Self::Name(id, _)
            | Self::Visible(id, _)
            | Self::Hidden(id, _)
            | Self::NamedSelections(id, _) => Some(*id),
            _ => None,
        }
    }

    /// Whether applying the change would change nothing.
    pub fn is_nothing(&self) -> bool {
        matches!(self, Self::Journal(_, journal) if journal.is_empty())
    }

    fn bytes(&self) -> usize {
        size_of::<Self>()
            + match self {
                Self::Journal(_, journal) => journal.bytes(),
                Self::Mesh(_, mesh) => mesh.bytes(),
                Self::Bezier(_, bezier) => bezier.as_ref().map_or(0, |bezier| bezier.bytes()),
                Self::Soup(_, soup) => soup.as_ref().map_or(0, |soup| soup_bytes(soup)),
                Self::Materials(materials) => materials.bytes(),
                Self::Hidden(_, hidden) => hidden.bytes(),
                Self::NamedSelections(_, named) => named_bytes(named),
                Self::Insert(_, object) => {
                    object.mesh().bytes()
                        + object.bezier().map_or(0, |bezier| bezier.bytes())
                        + object.named.soup.as_ref().map_or(0, |soup| soup_bytes(soup))
                        + object.hidden.bytes()
                        + named_bytes(&object.named_selections)
                }
                _ => 0,
            }
    }
}

fn named_bytes(named: &[NamedSelection]) -> usize {
    named.iter().map(|named| size_of::<NamedSelection>() + named.name.len() + named.selection.bytes()).sum()
}

/// The approximate memory of a soup in bytes, without its attributes.
fn soup_bytes(soup: &PolygonSoup) -> usize {
    soup.positions.len() * 12 + (soup.corners.len() + soup.face_starts.len()) * 4
}

/// Whether an edit that touched these elements may have changed connectivity, not only positions and
/// attributes.
pub(crate) fn is_reshaping(touched: &Touched) -> bool {
    touched.everything || !touched.halfedges.is_empty()
}

/// A step that can be undone or, once undone, redone.
#[derive(Debug)]
pub(crate) struct Step {
    /// The label in menus.
    pub label: String,
    /// The changes that undo the step (or redo it, once undone), in order.
    pub changes: Vec<Change>,
    /// The selection to restore with them.
    pub selection: Arc<Selection>,
    /// The revision to restore with them; documents of equal revision are equal.
    pub revision: u64,
    /// The number of steps that were made before it; it keeps the number when it is undone.
    pub number: u64,
}

impl Step {
    /// Whether only the selection changed.
    pub fn is_selection(&self) -> bool {
        self.changes.is_empty()
    }

    fn bytes(&self) -> usize {
        size_of::<Self>() + self.selection.bytes() + self.changes.iter().map(Change::bytes).sum::<usize>()
    }
}

/// The steps that can be undone and redone, limited by the memory that they take.
#[derive(Debug)]
pub(crate) struct History {
    undo: VecDeque<(Step, usize)>,
    redo: Vec<(Step, usize)>,
    bytes: usize,
    limit: usize,
    /// Whether no edit was dropped because of the limit.
    pub is_whole: bool,
}

impl History {
    /// The default limit of memory, in bytes.
    pub const DEFAULT_LIMIT_BYTES: usize = 512 << 20;

    pub fn new() -> Self {
        Self {
            undo: VecDeque::new(),
            redo: Vec::new(),
            bytes: 0,
            limit: Self::DEFAULT_LIMIT_BYTES,
            is_whole: true,
        }
    }

    /// Adds a step that was just made and forgets the steps that could be redone.
    pub fn push(&mut self, step: Step) {
        self.bytes -= self.redo.drain(..).map(|(_, bytes)| bytes).sum::<usize>();
        self.keep_undo(step);
        self.shrink();
    }

    /// Adds a change of the selection. Forgets the changes of the selection that could be redone next, but no edits:
    /// they fit the document whatever is selected.
    pub fn push_selection(&mut self, step: Step) {
        self.forget_selections_to_redo();
        self.keep_undo(step);
        self.shrink();
    }

    /// Forgets the changes of the selection since the last edit.
    pub fn forget_selections(&mut self) {
        while self.next_undo().is_some_and(Step::is_selection) {
            self.take_undo();
        }
    }

    /// Forgets the changes of the selection that could be redone before an edit.
    pub fn forget_selections_to_redo(&mut self) {
        while self.next_redo().is_some_and(Step::is_selection) {
            self.take_redo();
        }
    }

    pub fn keep_undo(&mut self, step: Step) {
        let bytes = step.bytes();
        self.bytes += bytes;
        self.undo.push_back((step, bytes));
    }

    pub fn keep_redo(&mut self, step: Step) {
        let bytes = step.bytes();
        self.bytes += bytes;
        self.redo.push((step, bytes));
    }

    pub fn take_undo(&mut self) -> Option<Step> {
        let (step, bytes) = self.undo.pop_back()?;
        self.bytes -= bytes;
        Some(step)
    }

    pub fn take_redo(&mut self) -> Option<Step> {
        let (step, bytes) = self.redo.pop()?;
        self.bytes -= bytes;
        Some(step)
    }

    /// Takes all steps that can be redone, the next one last.
    pub fn take_all_redo(&mut self) -> Vec<Step> {
        self.bytes -= self.redo.iter().map(|(_, bytes)| bytes).sum::<usize>();
        self.redo.drain(..).map(|(step, _)| step).collect()
    }

    pub fn next_undo(&self) -> Option<&Step> {
        self.undo.back().map(|(step, _)| step)
    }

    pub fn next_redo(&self) -> Option<&Step> {
        self.redo.last().map(|(step, _)| step)
    }

    /// The steps from the next one to undo to the last of this many edits.
    pub fn steps_back(&self, edits: usize) -> impl Iterator<Item = &Step> {
        up_to(self.undo.iter().rev(), edits)
    }

    /// The steps from the next one to redo to the last of this many edits.
    pub fn steps_forward(&self, edits: usize) -> impl Iterator<Item = &Step> {
        up_to(self.redo.iter().rev(), edits)
    }

    /// The labels of the edits that can be undone, the next one last.
    pub fn undo_labels(&self) -> impl Iterator<Item = &str> {
        self.undo.iter().filter(|(step, _)| !step.is_selection()).map(|(step, _)| step.label.as_str())
    }

    /// The labels of the edits that can be redone, the next one last.
    pub fn redo_labels(&self) -> impl Iterator<Item = &str> {
        self.redo.iter().filter(|(step, _)| !step.is_selection()).map(|(step, _)| step.label.as_str())
    }

    pub fn bytes(&self) -> usize {
        self.bytes
    }

    pub fn limit(&self) -> usize {
        self.limit
    }

    pub fn set_limit(&mut self, limit: usize) {
        self.limit = limit;
        self.shrink();
    }

    /// Drops the oldest steps until the rest fits the limit. Keeps the latest edit whatever its size, so that it can
    /// always be undone.
    fn shrink(&mut self) {
        while self.bytes > self.limit {
            let edits = self.undo.iter().rev().filter(|(step, _)| !step.is_selection());
            let is_last_edit = edits.take(2).count() == 1;
            // Nothing else is left of the steps before the last edit's selections.
            let at = match self.undo.front() {
                Some((step, _)) => usize::from(is_last_edit && !step.is_selection()),
                None => return,
            };
            let Some((step, bytes)) = self.undo.remove(at) else { return };
            self.is_whole &= step.is_selection();
            self.bytes -= bytes;
        }
    }
}

/// The steps up to the last of this many edits.
fn up_to<'a>(
    steps: impl Iterator<Item = &'a (Step, usize)>,
    mut edits: usize,
) -> impl Iterator<Item = &'a Step> {
    steps.map(|(step, _)| step).take_while(move |step| {
        let is_wanted = edits > 0;
        edits -= usize::from(is_wanted && !step.is_selection());
        is_wanted
    })
}
