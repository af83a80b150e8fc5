//! Selecting. A change of the selection is a step for [`Editor::undo_step`], but no edit. Selecting first ends an
//! ongoing edit, which refers to the selection that it began with.

use super::Editor;
use crate::error::{CommandError, Problem};
use crate::history::Step;
use crate::ops::SelectMode;
use crate::selection::Selection;
use halfedge::geometry::BitSet;
use halfedge::{Element, InParts};
use std::sync::Arc;
use surface::selecting::{Criterion, Finding, is_hidden};

/// The label of changes of the selection in the history.
const SELECT: &str = "Select";

impl Editor {
    /// Selects elements of the active object. Elements of another kind replace the selection.
    ///
    /// # Errors
    /// An id doesn't exist; the selection is unchanged.
    pub fn select(
        &mut self,
        kind: Element,
        ids: impl IntoIterator<Item = u32>,
        mode: SelectMode,
    ) -> Result<(), CommandError> {
        let selection = self.combine(kind, ids, mode)?;
        self.set_selection(selection);
        self.log_selection(false);
        Ok(())
    }

    /// Selects like [`Editor::select`], as part of a stroke: all changes with the same number, with nothing else between
    /// them, are one step for [`Editor::undo_step`].
    ///
    /// # Errors
    /// An id doesn't exist; the selection is unchanged.
    pub fn select_in_stroke(
        &mut self,
        kind: Element,
        ids: impl IntoIterator<Item = u32>,
        mode: SelectMode,
        stroke: u64,
    ) -> Result<(), CommandError> {
        let selection = self.combine(kind, ids, mode)?;
        if self.stroke == Some(stroke) && self.history.next_undo().is_some_and(Step::is_selection) {
            self.replace_selection(selection);
            self.log_selection(true);
        } else if *self.selection != selection {
            self.set_selection(selection);
            self.stroke = Some(stroke);
            self.log_selection(false);
        }
        Ok(())
    }

    /// The selection combined with elements, after ending an ongoing edit.
    fn combine(
        &mut self,
        kind: Element,
        ids: impl IntoIterator<Item = u32>,
        mode: SelectMode,
    ) -> Result<Selection, CommandError> {
        self.end_edit();
        let Some(mesh) = self.document.active().map(|object| object.named.mesh.clone()) else {
            return Err(CommandError::refused("select", "the document has no object"));
        };
        let is_same_kind = self.selection.kind() == kind;
        let mut selection = match mode {
            SelectMode::Remove => (*self.selection).clone(),
            SelectMode::Extend | SelectMode::Toggle if is_same_kind => (*self.selection).clone(),
            _ => Selection::new(kind),
        };
        for id in ids {
            if !mesh.exists(kind, id) {
                let problem = Problem::field("ids", format!("there is no {kind} {id}"));
                return Err(CommandError::of("select", problem));
            }
            match mode {
                SelectMode::Remove if !is_same_kind => {}
                SelectMode::Remove => {
                    selection.remove(id);
                }
                SelectMode::Toggle if selection.contains(kind, id) => {
                    selection.remove(id);
                }
                SelectMode::Intersect if !self.selection.contains(kind, id) => {}
                _ => {
                    selection.insert(id);
                }
            }
        }
        Ok(selection)
    }

    /// Extends the selection by all ids from the one selected last to this one that aren't hidden, like a Shift-click in
    /// a list.
    ///
    /// # Errors
    /// An id doesn't exist.
    pub fn select_range(&mut self, kind: Element, to: u32) -> Result<(), CommandError> {
        self.end_edit();
        let from = if self.selection.kind() == kind { self.selection.latest() } else { None };
        let Some(object) = self.document.active().filter(|object| object.mesh().exists(kind, to)) else {
            return Err(CommandError::of(
                "select",
                Problem::field("ids", format!("there is no {kind} {to}")),
            ));
        };
        let from = from.unwrap_or(to);
        let (mesh, hidden) = (object.mesh(), object.hidden());
        let shows = |id: &u32| mesh.exists(kind, *id) && !is_hidden(mesh, kind, *id as usize, hidden);
        let mut ids: Vec<u32> = (from.min(to)..=from.max(to)).filter(shows).collect();
        if from > to {
            ids.reverse();
        }
        self.select(kind, ids, SelectMode::Extend)
    }

    /// Selects every element of a kind that isn't hidden.
    pub fn select_all(&mut self, kind: Element) {
        self.select_by_criterion(Finding::by(kind, Criterion::Any));
    }

    /// Selects the elements of a kind instead that are neither selected nor hidden.
    pub fn select_inverse(&mut self, kind: Element) {
        self.end_edit();
        let of_kind = self.selection.kind() == kind;
        let selected = if of_kind { self.selection.set().clone() } else { BitSet::new() };
        self.select_by_criterion(Finding::outside(kind, selected));
    }

    fn select_by_criterion(&mut self, find: Finding) {
        self.end_edit();
        let Some(object) = self.document.active() else { return };
        let find = find.shown(object.hidden());
        self.start_or_finish(find);
    }

    /// Clears the selection; its kind stays.
    pub fn deselect(&mut self) {
        self.end_edit();
        self.set_selection(Selection::new(self.selection.kind()));
        self.log_selection(false);
    }

    /// Selects something else, as a step for [`Editor::undo_step`].
    pub(super) fn set_selection(&mut self, selection: Selection) {
        self.stroke = None;
        let before = self.selection.clone();
        self.replace_selection(selection);
        if self.selection.is_step_from(&before) {
            let (label, revision, number) = (SELECT.to_owned(), self.revision, self.number_step());
            let step = Step { label, changes: Vec::new(), selection: before, revision, number };
            self.history.push_selection(step);
            self.changes.history = true;
        }
    }

    /// Selects something else as part of an edit.
    pub(super) fn replace_selection(&mut self, selection: Selection) {
        if *self.selection != selection {
            self.selection = Arc::new(selection);
            self.changes.selection = true;
        }
    }

    /// Drops hidden elements from the selection.
    pub(super) fn drop_hidden_from_selection(&mut self) {
        let Some(object) = self.document.active() else { return };
        let (kind, latest) = (self.selection.kind(), self.selection.latest());
        let mut shown = self.selection.set().clone();
        if kind == Element::Face {
            shown.subtract(object.hidden());
        } else {
            shown = Finding::known(kind, shown).shown(object.hidden()).finish(object.mesh());
        }
        self.replace_selection(Selection::of_set(kind, shown, latest));
    }

    /// Drops removed elements from the selection.
    pub(super) fn drop_gone_from_selection(&mut self) {
        let Some(object) = self.document.active() else { return };
        if self.selection.has_gone(object.mesh()) {
            let mut selection = (*self.selection).clone();
            selection.keep_existing(object.mesh());
            self.replace_selection(selection);
        }
    }
}
