//! The session: the editor, its jobs, and the facts and messages about them. Panels read it; the app
//! changes it.

pub(crate) mod documents;
pub(crate) mod edit;
pub(crate) mod form;
pub(crate) mod frame_times;
pub(crate) mod guide;
pub(crate) mod in_place;
pub(crate) mod jobs;
pub(crate) mod live;
pub(crate) mod measures;
pub(crate) mod preview;
mod run;
pub(crate) mod saving;
pub(crate) mod selecting;
pub(crate) mod sharing;
pub(crate) mod survey;
pub(crate) mod toasts;
pub(crate) mod update;

use std::cell::RefCell;
use std::collections::HashMap;

use editor::{Changes, CommandError, Editor, Facts, JobId, MessageKind, OpId};
use egui::Context;
use formats::Picture;
use halfedge::{Element, HalfedgeId};

use crate::live::edit::Live;
use crate::live::place::SelectionPlace;
use crate::platform::Platform;
use crate::transforming::Gizmo;
use documents::DocumentList;
use frame_times::FrameTimes;
use in_place::InPlace;
use jobs::{Jobs, Reply};
use measures::Measured;
use preview::Previewing;
use sharing::Sharing;
use survey::Survey;
use toasts::Toasts;

/// The error that callers of a cancelled job get.
const CANCELLED: &str = "cancelled";

/// What the view should show after another document was opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ViewTarget {
    /// Everything.
    Document,
    /// As the view that came with the document.
    Kept,
    /// Flat curves, seen from straight above their plane, so that they appear as they were drawn.
    FlatCurves,
}

/// The editor and everything in progress in it.
pub(crate) struct Session {
    pub editor: Editor,
    pub platform: Box<dyn Platform>,
    pub ctx: Context,
    pub jobs: Jobs,
    pub toasts: Toasts,
    pub survey: Survey,
    pub frames: FrameTimes,
    /// The edit that follows the pointer.
    pub live: Option<Live>,
    /// Where the selection is, while the gizmo is shown or an edit follows the pointer.
    pub place: Option<SelectionPlace>,
    /// How live edits behave.
    pub live_settings: crate::transforming::Settings,
    /// The operation that is previewed while its form is filled in.
    pub previewing: Previewing,
    /// Whether the last adjustment took too long to run at every step of a spin box.
    pub adjusting_is_slow: bool,
    /// Links to the document, and whether it came by one.
    pub sharing: Sharing,
    /// The file that the document was opened from.
    pub in_place: InPlace,
    /// Whether a newer version of the page is there.
    pub update_is_ready: bool,
    /// What the view should show next.
    pub look: Option<ViewTarget>,
    /// Images that were decoded since the last frame, or why they can't be.
    pub decoded: Vec<(JobId, Result<Picture, String>)>,
    /// Who waits for a command that selects some elements at a time.
    pub(super) selecting: Option<Reply>,
    /// The time at which the jump in the history was first drawn, on egui's clock in seconds.
    pub jump_since: Option<f64>,
    /// Whether a key started the action that is being carried out.
    pub by_key: bool,
    /// Whether to commit the ongoing edit when the pointer's button is released.
    pub commit_on_release: bool,
    /// The documents that the browser keeps.
    pub documents: DocumentList,
    /// How long commands took since the log was last written: repeating them takes as long.
    pub work_seconds: f64,
    /// How long the last update of an ongoing edit took: repeating the edit takes as long.
    pub edit_seconds: f64,
    measured: RefCell<Measured>,
    /// The editor's answers for operations since the document or the selection last changed.
    refusals: RefCell<HashMap<OpId, Option<String>>>,
}

impl Session {
    pub fn new(ctx: &Context, platform: Box<dyn Platform>) -> Self {
        Self {
            editor: Editor::new(),
            platform,
            ctx: ctx.clone(),
            jobs: Jobs::default(),
            toasts: Toasts::default(),
            survey: Survey::default(),
            frames: FrameTimes::default(),
            live: None,
            place: None,
            live_settings: Default::default(),
            previewing: Previewing::default(),
            adjusting_is_slow: false,
            sharing: Sharing::default(),
            in_place: InPlace::default(),
            update_is_ready: false,
            look: None,
            decoded: Vec::new(),
            selecting: None,
            jump_since: None,
            by_key: false,
            commit_on_release: false,
            documents: DocumentList::default(),
            work_seconds: 0.0,
            edit_seconds: 0.0,
            measured: RefCell::default(),
            refusals: RefCell::default(),
        }
    }

    /// Forgets what no longer applies after a change.
    pub fn follow(&mut self, changes: &Changes) {
        self.refusals.get_mut().clear();
        if changes.selection || changes.document || !changes.objects.is_empty() {
            let is_needed = self.live_settings.gizmo != Gizmo::Off || self.live.is_some();
            self.place = is_needed.then(|| SelectionPlace::of_selection(&self.editor)).flatten();
        }
        self.survey.follow(&self.editor, changes);
        self.measured.get_mut().follow(&self.editor, changes);
        if changes.document {
            self.toasts.follow(&self.editor);
        }
    }

    /// Why an operation on the selection can't be done now, as a sentence; none if it can.
    pub fn why_not_operation(&self, id: OpId) -> Option<String> {
        let ask = || {
            // The amounts that a form would fill in don't matter here.
            let filled = form::initial(id.spec(), &Facts::default());
            let can = form::command(id, &filled).and_then(|command| self.editor.can(&command));
            can.err().map(|error| error.reason())
        };
        self.refusals.borrow_mut().entry(id).or_insert_with(ask).clone()
    }

    /// The facts that an operation's form needs, about the mesh without any preview.
    pub fn facts(&self, id: OpId) -> Facts {
        self.facts_with(form::needs_measures(id.spec()))
    }

    /// All facts about the mesh without any preview.
    pub fn measured_facts(&self) -> Facts {
        self.facts_with(true)
    }

    fn facts_with(&self, measures: bool) -> Facts {
        match self.preview() {
            Some(preview) => preview.before,
            None => self.measured.borrow_mut().facts(&self.editor, &self.survey, measures),
        }
    }

    /// The half-edge that was selected last.
    pub fn selected_halfedge(&self) -> Option<HalfedgeId> {
        let selection = self.editor.selection();
        let id = selection.latest().filter(|_| selection.kind() == Element::Halfedge)?;
        self.editor.mesh()?.halfedge(id)
    }

    /// Undoes the last edit or change of the selection.
    pub fn undo(&mut self) {
        if let Err(error) = self.editor.undo_step() {
            self.refuse(&error);
        }
    }

    /// Redoes the last undone edit or change of the selection.
    pub fn redo(&mut self) {
        if let Err(error) = self.editor.redo_step() {
            self.refuse(&error);
        }
    }

    /// Shows a toast.
    pub fn toast(&mut self, kind: MessageKind, text: String, details: Vec<String>) {
        let now = self.ctx.input(|input| input.time);
        self.toasts.add(now, kind, text, details, &self.editor);
        self.ctx.request_repaint();
    }

    /// Warns, in a toast and in the messages.
    pub fn warn(&mut self, text: String, details: Vec<String>) {
        for line in std::iter::once(&text).chain(&details) {
            self.editor.say(MessageKind::Warning, line.clone());
        }
        self.toast(MessageKind::Warning, text, details);
    }

    /// Says what happened, in a toast and in the messages.
    pub fn tell(&mut self, text: String, details: Vec<String>) {
        self.editor.say(MessageKind::Info, text.clone());
        self.toast(MessageKind::Info, text, details);
    }

    /// Reports a failure, in a toast and in the messages.
    pub fn fail(&mut self, text: String) {
        self.editor.say(MessageKind::Error, text.clone());
        self.toast(MessageKind::Error, text, Vec::new());
    }

    /// Reports why a command was refused.
    pub fn refuse(&mut self, error: &CommandError) {
        if error.is_cancelled() {
            return;
        }
        self.toast(MessageKind::Error, error.message(), Vec::new());
    }
}
