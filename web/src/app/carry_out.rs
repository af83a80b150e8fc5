//! Carrying out requests, all in one place.

use editor::{MessageKind, SelectMode};
use halfedge::Element;

use super::{App, key_settings};
use crate::keeping::SavedView;
use crate::panels::save::FORMAT_SETTING;
use crate::panels::welcome::WELCOME_SETTING;
use crate::request::{Request, Waiting};
use crate::session::{edit, form, live, sharing};
use crate::view::Tool;

impl App {
    pub(super) fn carry_out(&mut self, request: Request) {
        match request {
            // Requested in every frame; a change asks for a repaint.
            Request::Hover(kind, id) => return self.hover(kind, id),
            Request::LivePointer(at, modifiers) => {
                return self.session.live_pointer(at, modifiers, &mut self.view);
            }
            Request::LivePointerOnBar => return live::rest_on_bar(&mut self.session),
            Request::Act(action) => self.act(action),
            Request::ActivateView(pane) => self.view.activate(pane),
            Request::Document(request) => {
                if self.panels.end_edits(&mut self.session) {
                    self.keeper.carry_out(&mut self.session, request);
                }
            }
            Request::Run(command) => self.session.begin_or_refuse(Ok(command)),
            Request::Refuse(error) => self.session.refuse(&error),
            Request::Select { kind, ids, mode } => self.select(kind, ids, mode),
            Request::PaintSelection { kind, ids, mode, stroke } => {
                self.select_further(|editor| editor.select_in_stroke(kind, ids, mode, stroke));
            }
            Request::SelectRange { kind, to } => {
                self.select_further(|editor| editor.select_range(kind, to).map(drop));
            }
            Request::SelectLine { kind, through, line, mode } => {
                self.select_further(|editor| editor.select_line(kind, through, line, mode));
            }
            Request::SelectPath { kind, to } => self.select_further(|editor| editor.select_path_to(kind, to)),
            Request::Deselect => {
                self.panels.end_edits(&mut self.session);
                self.session.editor.deselect();
            }
            Request::UpdateEdit(command) => {
                // The edit that follows the pointer ends before anything else is edited.
                self.session.end_live(true);
                let command = command.mirrored(self.session.live_settings.symmetry);
                if let Err(error) = edit::update_edit(&mut self.session, command) {
                    self.session.refuse(&error);
                }
            }
            Request::CommitEdit => {
                self.session.editor.commit_edit();
            }
            Request::CancelEdit => {
                self.session.editor.cancel_edit();
            }
            Request::CommitEditOnRelease => self.session.commit_on_release = true,
            Request::StartLive(start) => {
                if start.ring.is_some() {
                    // One cut, as with other operations: the next click selects.
                    self.view.tool = Tool::Orbit;
                }
                self.session.start_live(&start, &self.view);
            }
            Request::TakeUpLive(at) => self.session.change_live(|live, _| live.take_up(at)),
            Request::LiveWheel(notches) => {
                let view = &self.view;
                self.session.change_live(|live, settings| live.turn_wheel(notches, settings, view));
            }
            Request::WidenSoft(by) => live::widen_soft(&mut self.session, &self.view, by),
            Request::LockLive(axis) => {
                let view = &self.view;
                self.session.change_live(|live, settings| live.lock_axis(axis, settings, view));
            }
            Request::SetLiveCount(count) => self.session.change_live(|live, _| live.set_count(count)),
            Request::SetLiveAmount(value) => self.session.change_live(|live, _| live.set_amount(value)),
            Request::EndLive { commit } => self.session.end_live(commit),
            Request::AbandonLive => live::abandon(&mut self.session),
            Request::CloseWelcome => self.shown.welcome = false,
            Request::WelcomeAtStart(on) => {
                let welcome = &mut self.panels.welcome;
                welcome.at_start = on;
                self.session.platform.store_setting(WELCOME_SETTING, welcome.setting());
            }
            Request::OpenSample(sample) => drop(self.session.open_files(vec![sample.file()], None)),
            Request::StartWithShape(name) => self.session.new_document(form::shape(name)),
            Request::OpenForm(id) => self.open_form(id),
            Request::CloseForm => {
                self.panels.forms.close();
            }
            Request::Preview(id, filled) => self.session.show_preview(id, filled),
            Request::EndPreview => {
                self.session.forget_refused_preview();
                self.session.end_preview();
            }
            Request::Apply(id, filled) => {
                let jobs = self.session.jobs.iter().count();
                let before = (self.session.editor.revision(), jobs);
                if !self.session.apply_preview(id, &filled) {
                    self.session.begin_or_refuse(crate::session::form::command(id, &filled));
                }
                // "Adjust last operation" takes the place of the form. A refused form stays open.
                if (self.session.editor.revision(), self.session.jobs.iter().count()) != before {
                    self.panels.forms.close();
                }
            }
            Request::Adjust(command) => self.session.adjust(command),
            Request::UndoEdit => self.undo_edit(),
            Request::JumpTo(edits) => self.begin_jump(edits),
            Request::Play(setting) => self.player.controls.set(setting),
            Request::InsertControlPoint(insert) => self.insert_control_point(insert),
            Request::ShowSheet(sheet) => self.shown.sheet = sheet,
            Request::Close(window) => self.shown.close(window),
            Request::Save { format, name, brings_back_all } => {
                self.session.platform.store_setting(FORMAT_SETTING, format.code());
                if format.is_project() {
                    self.session.editor.log_view(SavedView::of(&self.view).to_json());
                }
                self.session.save(format, name, brings_back_all);
            }
            Request::MakeLink => sharing::make(&mut self.session),
            Request::Copy { text, said } => {
                self.session.ctx.copy_text(text);
                self.session.toast(MessageKind::Info, said.to_owned(), Vec::new());
            }
            Request::ChangeKeys(changes) => key_settings::change(&mut self.session, changes),
            Request::CancelJob(id) => self.session.cancel_job(id),
            Request::Warn(text) => self.session.warn(text, Vec::new()),
            Request::ToggleToast(at) => self.session.toasts.toggle(at),
            Request::DismissToast(at) => self.session.toasts.dismiss(at),
        }
        self.session.ctx.request_repaint();
    }

    /// Highlights the element whose row or link is under the pointer.
    fn hover(&mut self, kind: Element, id: u32) {
        if self.view.hovered != Some((kind, id)) {
            self.session.ctx.request_repaint();
        }
        self.view.hover_from_list(kind, id);
    }

    /// Selects elements.
    pub(super) fn select(&mut self, kind: Element, ids: impl IntoIterator<Item = u32>, mode: SelectMode) {
        if !self.panels.end_edits(&mut self.session) {
            return;
        }
        if let Err(error) = self.session.editor.select(kind, ids, mode) {
            self.session.refuse(&error);
        }
    }

    /// Carries out a request, or puts it off until the end of a jump.
    pub(super) fn carry_out_or_wait(&mut self, request: Request, by_key: bool) {
        if self.session.editor.jump().is_none() || request.goes_before_jump() {
            self.session.by_key = by_key;
            self.carry_out(request);
            self.session.by_key = false;
        } else if request.names_elements() {
            let text = "The history is still going to another step. Select again when it is there.";
            self.session.toast(MessageKind::Info, text.to_owned(), Vec::new());
        } else {
            self.waiting.push_back(Waiting { request, by_key });
        }
    }

    /// Begins a jump to the state after this many edits.
    fn begin_jump(&mut self, edits: usize) {
        self.end_preview();
        self.session.end_live(false);
        self.session.jump_since = None;
        match self.session.editor.begin_jump(edits) {
            Ok(()) => self.go_on_with_jump(),
            Err(error) => self.session.refuse(&error),
        }
    }

    /// Undoes or redoes more steps of a jump, as many as the frame's budget allows.
    pub(super) fn go_on_with_jump(&mut self) {
        if self.session.editor.jump().is_none() {
            return;
        }
        let now = self.session.ctx.input(|input| input.time);
        self.session.jump_since.get_or_insert(now);
        if let Err(error) = self.session.editor.jump_some(&mut self.view.budget) {
            self.session.refuse(&error);
        }
        self.session.ctx.request_repaint();
    }

    /// Undoes the last edit and what was selected since; cancels what is being edited.
    fn undo_edit(&mut self) {
        self.end_preview();
        self.session.end_live(false);
        if let Err(error) = self.session.editor.undo() {
            self.session.refuse(&error);
        }
    }

    /// Removes the preview and shows none until a field changes. If there was one, returns whether ids
    /// refer to the same elements as before.
    pub(super) fn end_preview(&mut self) -> Option<bool> {
        self.panels.forms.previews.end();
        self.session.end_preview()
    }
}
