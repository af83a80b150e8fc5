//! Hidden faces and named selections follow the elements that operations renumber, and lose those that they remove.

use super::Editor;
use crate::document::{NamedSelection, ObjectId};
use crate::history::Change;
use crate::ops::{Action, Op};
use crate::outcome::ElementIds;
use crate::selection::Selection;
use halfedge::Element;
use halfedge::words::counted;
use std::sync::Arc;

impl Editor {
    /// Hides the pieces of hidden faces that a local edit has cut, and removes elements that it removed from the hidden faces
    /// and the named selections; returns the changes that undo that. Costs O(created and removed elements), and O(ids / 64)
    /// where one is hidden or named.
    pub(super) fn follow_edit(
        &mut self,
        id: ObjectId,
        created: &ElementIds,
        removed: &ElementIds,
    ) -> Vec<Change> {
        let Some(object) = self.document.object(id) else { return Vec::new() };
        let mut changes = Vec::new();
        let was_hidden = |f: u32| object.hidden().contains(f as usize);
        let has_hidden = !object.hidden().is_empty();
        let pieces = || created.pieces().filter(|(_, whole)| was_hidden(*whole));
        if has_hidden && (pieces().next().is_some() || removed.faces.iter().any(|f| was_hidden(*f))) {
            let mut hidden = (**object.hidden()).clone();
            pieces().for_each(|(piece, _)| {
                hidden.insert(piece as usize);
            });
            removed.faces.iter().for_each(|&f| {
                hidden.remove(f as usize);
            });
            changes.push(Change::Hidden(id, Arc::new(hidden)));
        }
        let sides: Vec<u32> = removed.edges.iter().flat_map(|e| [2 * e, 2 * e + 1]).collect();
        let gone = |kind| match kind {
            Element::Vertex => &removed.vertices,
            Element::Edge => &removed.edges,
            Element::Halfedge => &sides,
            Element::Face => &removed.faces,
        };
        let loses = |named: &NamedSelection| {
            let kind = named.selection.kind();
            gone(kind).iter().any(|&id| named.selection.contains(kind, id))
        };
        if object.named_selections().iter().any(loses) {
            let mut named = object.named_selections().to_vec();
            for NamedSelection { selection, .. } in &mut named {
                gone(selection.kind()).iter().for_each(|&id| selection.remove(id));
            }
            changes.push(Change::NamedSelections(id, Arc::new(named)));
        }
        self.apply(changes)
    }

    /// Removes elements that don't exist from the hidden faces and the named selections of an object: a step that is done
    /// again after later ones may have removed what those hid or named. Costs O(ids that are hidden or named).
    pub(super) fn forget_gone(&mut self, id: ObjectId) -> Vec<Change> {
        let Some(object) = self.document.object(id) else { return Vec::new() };
        let mut gone = ElementIds::default();
        let mut note = |kind, element| {
            if !object.mesh().exists(kind, element) {
                match kind {
                    Element::Vertex => gone.vertices.push(element),
                    Element::Edge => gone.edges.push(element),
                    Element::Halfedge => gone.edges.push(element / 2),
                    Element::Face => gone.faces.push(element),
                }
            }
        };
        object.hidden().iter().for_each(|face| note(Element::Face, face as u32));
        for NamedSelection { selection, .. } in object.named_selections() {
            selection.ids().for_each(|element| note(selection.kind(), element));
        }
        self.follow_edit(id, &ElementIds::default(), &gone)
    }

    /// The selection, and the changes of what is hidden and named, that go with an operation on an object whose elements get
    /// new ids; none where its result is made anew.
    pub(super) fn follow_ids(&self, op: &Op, objects: &[ObjectId]) -> Option<(Selection, Vec<Change>)> {
        let (Action::WholeMesh(whole), [id]) = (op.action(), objects) else { return None };
        let object = self.document.object(*id)?;
        let followed = |selection: &Selection| {
            let kind = selection.kind();
            Some(Selection::of_set(kind, whole.follow(object.mesh(), kind, selection.set())?, None))
        };
        let is_active = self.document.active().is_some_and(|active| active.id() == *id);
        let selection = if is_active { followed(&self.selection)? } else { (*self.selection).clone() };
        let mut changes = Vec::new();
        if !object.hidden().is_empty() {
            let hidden = whole.follow(object.mesh(), Element::Face, object.hidden())?;
            changes.push(Change::Hidden(*id, Arc::new(hidden)));
        }
        if !object.named_selections().is_empty() {
            let mut named = object.named_selections().to_vec();
            for NamedSelection { selection, .. } in &mut named {
                *selection = followed(selection)?;
            }
            changes.push(Change::NamedSelections(*id, Arc::new(named)));
        }
        Some((selection, changes))
    }

    /// The changes that show what is hidden of objects whose elements get new ids, and drop their named selections.
    /// Notes say so.
    pub(super) fn forget_ids(&self, objects: &[ObjectId], notes: &mut Vec<String>) -> Vec<Change> {
        let mut changes = Vec::new();
        for object in objects.iter().filter_map(|&id| self.document.object(id)) {
            if !object.hidden().is_empty() {
                let count = object.hidden().len();
                let faces = counted(count, "hidden face of", "hidden faces of");
                notes.push(format!("{faces} {} shown again", object.name()));
                changes.push(Change::Hidden(object.id(), Arc::default()));
            }
            if !object.named_selections().is_empty() {
                let names: Vec<String> =
                    object.named_selections().iter().map(|named| format!("“{}”", named.name)).collect();
                notes.push(format!(
                    "The elements have new ids, so these named selections were dropped: {}",
                    names.join(", ")
                ));
                changes.push(Change::NamedSelections(object.id(), Arc::default()));
            }
        }
        // Objects that are joined to the first are removed with theirs.
        let first = objects.first().copied();
        changes.retain(|change| match change {
            Change::Hidden(id, _) | Change::NamedSelections(id, _) => Some(*id) == first,
            _ => true,
        });
        changes
    }
}
