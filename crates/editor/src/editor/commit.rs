//! Committing the result of a whole-mesh operation as one step.

use super::Editor;
use crate::Task;
use crate::document::{Object, ObjectId, Origin};
use crate::error::Problem;
use crate::history::Change;
use crate::job::Made;
use crate::ops::{Action, Commit, NamedMesh, Op};
use crate::outcome::{self, Elements, Outcome};
use crate::selection::Selection;
use glam::DVec3;
use std::sync::Arc;

impl Editor {
    /// Commits the valid result of a whole-mesh operation as one step.
    pub(super) fn commit_whole(
        &mut self,
        op: &Op,
        objects: &[ObjectId],
        at: usize,
        made: Made,
    ) -> Result<Outcome, Problem> {
        let before = self.selection.clone();
        if self.is_unchanged(op, objects, &made) {
            return Self::unchanged(op, made);
        }
        let (outcome, back) = self.put_result(op, objects, at, made)?;
        self.push_step(op.label().to_owned(), back, before);
        Ok(outcome)
    }

    /// The outcome of an operation whose result equals the mesh that it started from.
    pub(super) fn unchanged(op: &Op, made: Made) -> Result<Outcome, Problem> {
        let Made::Meshes(_, ids, warnings) = made else { return Err(other_job()) };
        // Local edits list the elements, also where there are none.
        let (created, removed) = ids.map(|(made, gone)| (made.into(), gone.into())).unwrap_or_default();
        let outcome = Self::outcome(op, created, removed);
        Ok(Outcome { warnings, ..outcome.unchanged() })
    }

    /// Whether an operation's result equals the mesh that it started from. Costs O(mesh) if the counts are
    /// equal.
    pub(super) fn is_unchanged(&self, op: &Op, objects: &[ObjectId], made: &Made) -> bool {
        let Made::Meshes(outputs, ..) = made else { return false };
        let ([output], [object]) = (outputs.as_slice(), objects) else { return false };
        let object = self.document.object(*object);
        commit_of(op) == Commit::Replace
            && output.name.is_empty()
            && object.is_some_and(|object| object.bezier().is_none() && object.mesh() == &*output.mesh)
    }

    /// Puts the result of a whole-mesh operation into the document; returns the changes that undo that.
    pub(super) fn put_result(
        &mut self,
        op: &Op,
        objects: &[ObjectId],
        at: usize,
        made: Made,
    ) -> Result<(Outcome, Vec<Change>), Problem> {
        let Made::Meshes(outputs, ids, notes) = made else {
            return Err(other_job());
        };
        let commit = commit_of(op);
        let after = outcome::sizes(outputs.iter().map(|output| &*output.mesh));
        let removed_all = commit == Commit::NewDocument;
        let replaced = |object: &&Object| removed_all || objects.contains(&object.id());
        let before = outcome::sizes(self.document.objects.iter().filter(replaced).map(Object::mesh));
        let local = ids.clone();
        let (created, removed) = match (ids, commit) {
            (Some((created, removed)), _) => (created.into(), removed.into()),
            (None, Commit::NewDocument) => {
                (Elements::gained([0; 3], after), Elements::gained([0; 3], before))
            }
            (None, Commit::NewObject) => (Elements::gained([0; 3], after), Elements::default()),
            (None, Commit::Replace | Commit::Join) => {
                (Elements::gained(before, after), Elements::gained(after, before))
            }
        };
        let keeps_ids = created.ids.is_some();
        let followed = if local.is_none() { self.follow_ids(op, objects) } else { None };
        let mut changes = self.changes_for(commit, objects, at, outputs)?;
        let mut notes = notes;
        let mut selection = Selection::new(self.selection.kind());
        match followed {
            Some((kept, followed)) => {
                selection = kept;
                changes.extend(followed);
            }
            None if local.is_none() && matches!(commit, Commit::Replace | Commit::Join) => {
                changes.extend(self.forget_ids(objects, &mut notes));
            }
            None => {}
        }
        let mut back = self.apply(changes);
        if let (Some((created, removed)), Some(&id)) = (local, objects.first()) {
            // Undone first, before the ids are back, as sets needn't exist.
            back.extend(self.follow_edit(id, &created, &removed));
        }
        if keeps_ids {
            self.drop_gone_from_selection();
        } else {
            self.selection = Arc::new(selection);
            self.changes.selection = true;
        }
        let outcome = Self::outcome(op, created, removed);
        let outcome = if removed_all { outcome.into_new_document() } else { outcome };
        Ok((Outcome { warnings: notes, ..outcome }, back))
    }

    fn changes_for(
        &mut self,
        commit: Commit,
        objects: &[ObjectId],
        at: usize,
        outputs: Vec<NamedMesh>,
    ) -> Result<Vec<Change>, Problem> {
        let mut outputs = outputs.into_iter();
        let first = outputs.next().ok_or_else(|| Problem::internal("the operation made nothing"))?;
        let mut changes = Vec::new();
        match commit {
            Commit::Replace | Commit::Join => {
                let gone = || Problem::new("the object is gone");
                let target = *objects.first().ok_or_else(gone)?;
                let index = self.document.index_of(target).ok_or_else(gone)?;
                changes.push(Change::Mesh(target, first.mesh));
                let object = self.document.object(target).ok_or_else(gone)?;
                if object.bezier().is_some() {
                    changes.push(Change::Bezier(target, None));
                }
                // The object no longer corresponds to the faces that it was read from.
                if object.is_repairable() && (commit == Commit::Join || outputs.len() > 0) {
                    changes.push(Change::Soup(target, None));
                }
                if !first.name.is_empty() {
                    changes.push(Change::Name(target, first.name));
                }
                if commit == Commit::Join {
                    let is_visible = |&id: &ObjectId| self.document.object(id).is_some_and(Object::visible);
                    if objects.iter().any(is_visible) && !is_visible(&target) {
                        changes.push(Change::Visible(target, true));
                    }
                    let mut places: Vec<usize> =
                        objects.iter().skip(1).filter_map(|&id| self.document.index_of(id)).collect();
                    places.sort_unstable();
                    let before = places.iter().filter(|&&place| place < index).count();
                    changes.extend(places.into_iter().rev().map(Change::Remove));
                    changes.push(Change::Active(index - before));
                } else {
                    for (offset, output) in outputs.enumerate() {
                        let object = self.object(output);
                        changes.push(Change::Insert(index + 1 + offset, Box::new(object)));
                    }
                    let inserted = changes.iter().filter(|c| matches!(c, Change::Insert(..))).count();
                    if inserted > 0 && self.document.active > index {
                        changes.push(Change::Active(self.document.active + inserted));
                    }
                }
            }
            Commit::NewDocument => {
                changes.extend((0..self.document.objects.len()).rev().map(Change::Remove));
                changes.push(self.another_document(false));
                changes.push(Change::DocumentName(first.name.clone()));
                changes.push(Change::Offset(DVec3::ZERO));
                changes.push(Change::Materials(formats::Materials::default()));
                let object = self.object(first);
                changes.push(Change::Insert(0, Box::new(object)));
                changes.push(Change::Active(0));
            }
            Commit::NewObject => {
                // The list may have become shorter since the command was given.
                let place = self.document.objects.len().min(at + 1);
                let object = self.object(first);
                changes.push(Change::Insert(place, Box::new(object)));
                changes.push(Change::Active(place));
            }
        }
        Ok(changes)
    }

    /// Makes the document another one.
    pub(super) fn another_document(&self, is_file: bool) -> Change {
        Change::Origin(Origin { revision: self.last_revision + 1, is_file })
    }

    /// A new object of a mesh.
    pub(super) fn object(&mut self, named: NamedMesh) -> Object {
        let id = ObjectId(self.next_object);
        self.next_object += 1;
        Object::new(id, named)
    }

    pub(super) fn outcome(op: &Op, created: Elements, removed: Elements) -> Outcome {
        Outcome::new(Task::Op(op.id()), created, removed)
    }
}

/// Where the result of an operation goes.
fn commit_of(op: &Op) -> Commit {
    match op.action() {
        Action::WholeMesh(whole) => whole.commit(),
        Action::Local(_) | Action::Document(_) | Action::Select(_) => Commit::Replace,
    }
}

fn other_job() -> Problem {
    Problem::internal("the result is of another job")
}
