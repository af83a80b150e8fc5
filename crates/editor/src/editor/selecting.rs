//! Selecting in large meshes, some elements at a time. Anything else that is done first completes it, so that it makes no
//! difference that it took several frames.

use super::{Editor, MAX_ELEMENTS_AT_ONCE, MessageKind};
use crate::ops::{Action, Command, Op, SelectMode};
use crate::outcome::{Elements, Outcome};
use crate::recovery::Event;
use crate::selection::Selection;
use halfedge::geometry::BitSet;
use halfedge::words::counted;
use halfedge::{Budget, Element, InParts, Mesh};
use surface::selecting::Finding;

/// Elements being looked for, to be selected.
#[derive(Debug)]
pub(super) struct Selecting {
    find: Finding,
    /// The command that asked for it; none for keys and menus that change the selection only.
    command: Option<(Op, Command)>,
}

impl Editor {
    /// Whether elements to select are still being looked for.
    pub fn is_selecting(&self) -> bool {
        self.selecting.is_some()
    }

    /// Looks for more of the elements to select, as many as the budget has; selects them once all are found.
    pub fn select_some(&mut self, budget: &mut Budget) {
        let Some(mut selecting) = self.selecting.take() else { return };
        match selecting.find.step(self.selected_mesh(), budget) {
            None => self.selecting = Some(selecting),
            Some(found) => self.select_all_found(selecting, found),
        }
    }

    /// The outcome of a command that [`Editor::select_some`] completed, once.
    pub fn take_selected(&mut self) -> Option<Outcome> {
        self.selected.take()
    }

    /// Stops looking for elements to select; returns whether it was going on.
    pub fn cancel_selecting(&mut self) -> bool {
        self.selecting.take().is_some()
    }

    /// Completes what is being looked for.
    pub(super) fn finish_selecting(&mut self) {
        self.select_some(&mut Budget::unlimited());
    }

    /// Begins to look for what a command selects.
    pub(super) fn start_selecting(&mut self, find: Finding, op: &Op, command: Option<Command>) {
        self.finish_selecting();
        let command = command.map(|command| (op.clone(), command));
        self.selecting = Some(Selecting { find, command });
    }

    /// Begins to look for elements to select instead, or selects them now if that is quick.
    pub(super) fn start_or_finish(&mut self, find: Finding) {
        let is_quick = find.cost(self.selected_mesh()) < MAX_ELEMENTS_AT_ONCE;
        self.selecting = Some(Selecting { find, command: None });
        if is_quick {
            self.finish_selecting();
        }
    }

    fn select_all_found(&mut self, selecting: Selecting, found: BitSet) {
        let kind = selecting.find.kind();
        match selecting.command {
            None => {
                self.put_found(kind, found, SelectMode::Replace);
                self.log_selection(false);
            }
            Some((op, command)) => {
                let before = self.selection.clone();
                let outcome = self.select_found(&op, kind, found);
                self.log(Event::Run(command.clone()));
                self.remember_selecting(command, &before);
                self.say(MessageKind::Info, outcome.message.clone());
                self.selected = Some(outcome);
            }
        }
    }

    /// Selects what an operation found.
    pub(super) fn select_found(&mut self, op: &Op, kind: Element, found: BitSet) -> Outcome {
        let mode = match op.action() {
            Action::Select(edit) => edit.mode(),
            Action::Local(_) | Action::WholeMesh(_) | Action::Document(_) => SelectMode::Replace,
        };
        let count = found.len();
        self.put_found(kind, found, mode);
        let found = counted(count, &kind.to_string(), kind.plural());
        let outcome = Self::outcome(op, Elements::default(), Elements::default());
        Outcome { message: format!("{}: {found} found", outcome.message), ..outcome }
    }

    fn put_found(&mut self, kind: Element, found: BitSet, mode: SelectMode) {
        let current = self.selection.clone();
        if mode == SelectMode::Remove && current.kind() != kind {
            return;
        }
        let mut set = if current.kind() == kind { current.set().clone() } else { BitSet::new() };
        match mode {
            SelectMode::Replace => set = found,
            SelectMode::Extend => set.union_with(&found),
            SelectMode::Toggle => set.toggle_with(&found),
            SelectMode::Remove => set.subtract(&found),
            SelectMode::Intersect => set.intersect_with(&found),
        }
        let latest = if current.kind() == kind { current.latest() } else { None };
        self.set_selection(Selection::of_set(kind, set, latest));
    }

    /// The mesh whose elements are selected; an empty one in a document without objects.
    pub(super) fn selected_mesh(&self) -> &Mesh {
        static NO_MESH: std::sync::LazyLock<Mesh> = std::sync::LazyLock::new(Mesh::new);
        self.mesh().unwrap_or(&NO_MESH)
    }
}
