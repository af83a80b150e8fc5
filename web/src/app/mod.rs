//! The page, frame by frame: panels draw and make requests, the app carries the requests out, and then
//! everything follows what changed.

mod actions;
mod camera;
mod carry_out;
pub mod drawing;
mod key_settings;
mod layout;
mod length_unit;
pub mod notices;
mod panels;
mod script;
mod sheet;
mod textures;
mod theme_setting;
mod title;
mod transforming;

use std::collections::VecDeque;

use editor::Editor;
use egui::epaint::MarginF32;
use egui::{CentralPanel, Context, Event as Input, Panel, Sense, Ui};
use halfedge::Element;

use crate::bezier::Player;
use crate::embedding;
use crate::fonts;
use crate::input::actions::Action;
use crate::input::brush_key::HeldTab;
use crate::input::held_keys::HeldKeys;
use crate::input::shortcut::Shortcut;
use crate::keeping::Keeper;
use crate::page_view::Page;
use crate::panels::viewport::{Viewport, ring_cut};
use crate::panels::{live_bar, menu_bar, status_bar, tool_bar, welcome};
use crate::platform::{DeviceInfo, Event, NamedBytes, Platform};
use crate::request::{Request, Requests, Waiting};
use crate::session::{Session, saving, selecting, sharing, update};
use crate::shown::Shown;
use crate::theme;
use crate::view::{self, Tool, View};
use crate::widgets::focus_ring;
use layout::Layout;
use notices::Notices;
use panels::Panels;
use script::Script;

/// The editor with its user interface. Call [`App::logic`] and [`App::ui`] once per frame each.
pub struct App {
    session: Session,
    shown: Shown,
    view: View,
    player: Player,
    keeper: Keeper,
    panels: Panels,
    requests: Requests,
    /// What happened since scripts were told.
    notices: Notices,
    /// What waits for the end of a jump in the history, in order.
    waiting: VecDeque<Waiting>,
    layout: Layout,
    /// Whether fingers were used last, not a mouse.
    fingers: bool,
    /// Whether the user wants less motion.
    less_motion: bool,
    /// Keys that were pressed after one that opened a text field, for the field in a later frame.
    held_keys: HeldKeys,
    /// Whether the document that the page starts with has not been followed yet.
    starting: bool,
    /// The title of the page.
    title: String,
}

/// The longest time from one click of a double-click to the other.
const MAX_DOUBLE_CLICK_SECONDS: f64 = 0.5;

impl App {
    /// An editor that contains a cube. Without `gpu` the viewport says that it can't draw.
    pub fn new(ctx: &Context, platform: Box<dyn Platform>, gpu: Option<egui_wgpu::RenderState>) -> Self {
        fonts::install(ctx);
        theme::install(ctx);
        ctx.add_plugin(HeldTab);
        ctx.options_mut(|options| {
            options.zoom_with_keyboard = false;
            // As in most systems; egui's own limit is too short where frames are slow.
            options.input_options.max_double_click_delay = MAX_DOUBLE_CLICK_SECONDS;
        });
        theme_setting::load(ctx, &*platform);
        length_unit::load(ctx, &*platform);
        let panels = Panels::new(&*platform);
        let layout = Layout::load(&*platform);
        let mut app = Self {
            session: Session::new(ctx, platform),
            shown: Shown::default(),
            view: View::new(gpu),
            player: Player::default(),
            keeper: Keeper::default(),
            panels,
            requests: Requests::default(),
            notices: Notices::default(),
            waiting: VecDeque::new(),
            layout,
            fingers: false,
            less_motion: false,
            held_keys: HeldKeys::default(),
            starting: true,
            title: String::new(),
        };
        layout::load_scale_and_axis(&mut app);
        app.apply_layout();
        key_settings::load(&mut app.session);
        camera::load(&mut app.session, &mut app.view);
        app.keeper = Keeper::start(&mut app.session);
        if !app.keeper.is_opening() {
            app.welcome();
        }
        layout::load_parts(&mut app.session, &mut app.shown);
        app
    }

    /// Shows the welcome view on a visit that begins with a new document.
    fn welcome(&mut self) {
        // A page that opens a file has something to start from already.
        self.shown.welcome = self.panels.welcome.at_start
            && self.session.jobs.iter().next().is_none()
            && !embedding::is_embedded(&*self.session.platform);
    }

    /// Whether the page still waits for the document of the last visit.
    pub fn is_opening(&self) -> bool {
        self.keeper.is_opening()
    }

    /// Whether leaving the page would lose changes.
    pub fn would_lose_changes(&self) -> bool {
        // What happens to an embedded document is up to the page around it.
        self.session.editor.is_dirty()
            && !self.keeper.keeps_all(&self.session.editor)
            && !embedding::is_embedded(&*self.session.platform)
    }

    /// The document and its history, read-only.
    pub fn editor(&self) -> &Editor {
        &self.session.editor
    }

    /// egui's context.
    pub fn ctx(&self) -> &Context {
        &self.session.ctx
    }

    /// The interface for script calls.
    pub fn script(&mut self) -> Script<'_> {
        Script { app: self }
    }

    /// The graphics device.
    pub fn device(&self) -> DeviceInfo {
        self.session.platform.device()
    }

    /// Handles what happened since the last frame. Draws nothing.
    pub fn logic(&mut self, ctx: &Context) {
        self.fit(ctx);
        self.view.budget = self.session.frames.begin(self.session.platform.now());
        let less_motion = self.session.platform.reduces_motion();
        self.view.glides.are_off = less_motion;
        self.view.glides.follow_input(ctx);
        if std::mem::replace(&mut self.less_motion, less_motion) != less_motion {
            theme::reduce_motion(ctx, less_motion);
        }
        for event in self.session.platform.poll(ctx) {
            match event {
                Event::JobProgress { job, fraction } => {
                    self.session.jobs.progress(job, fraction);
                    self.notices.note_progress();
                }
                Event::JobDone { job, result } => self.keeper.job_done(&mut self.session, job, result),
                Event::Fetched { job, files } => self.session.fetched(job, files),
                Event::Files(files) => drop(self.session.open_files(files, None)),
                Event::FilesOf(source, files) => saving::open(&mut self.session, source, files),
                Event::Written { files, result } => saving::written(&mut self.session, &files, result),
                Event::Placed(result) => saving::placed(&mut self.session, result),
                Event::Recalled { document, file } => saving::recalled(&mut self.session, &document, file),
                Event::UpdateReady => update::offer(&mut self.session),
                Event::Failed(text) => self.session.fail(text),
                Event::Store(answer, bytes) => {
                    if self.keeper.answered(&mut self.session, answer, bytes) {
                        self.welcome();
                    }
                }
                Event::Fragment(fragment) => sharing::open(&mut self.session, &fragment),
            }
        }
        self.shown.is_opening = self.keeper.is_opening();
        selecting::select_some(&mut self.session, &mut self.view.budget);
        self.go_on_with_jump();
        let now = ctx.input(|input| input.time);
        self.session.jobs.note_frame(now);
        if let Some(next) = self.session.toasts.expire(now) {
            ctx.request_repaint_after_secs(next.max(0.05) as f32);
        }
        self.held_keys.pace(ctx);
        self.panels.key_editor.take_key(ctx, self.shown.shortcuts);
        if self.session.live.is_none() {
            self.view.follow_pointer(ctx);
        }
        let live = self.session.live_keys(ctx, &self.view);
        let mut actions = self.keyboard(ctx, live).into_iter();
        // A second key in one frame acts on the result of the first.
        loop {
            self.follow();
            let waiting = if self.session.editor.jump().is_none() { self.waiting.pop_front() } else { None };
            let next =
                waiting.or_else(|| Some(Waiting { request: Request::Act(actions.next()?), by_key: true }));
            let Some(Waiting { request, by_key }) = next else { break };
            self.carry_out_or_wait(request, by_key);
        }
    }

    /// Draws a frame and acts on its input.
    pub fn ui(&mut self, ui: &mut Ui) {
        let ctx = ui.ctx().clone();
        let mut out = std::mem::take(&mut self.requests);
        self.draw(ui, &ctx, &mut out);
        for request in out.take() {
            self.carry_out_or_wait(request, false);
        }
        self.requests = out;
        self.finish_edits(&ctx);
        // What the picture and the pointer left of the budget.
        let (editor, kind) = (&self.session.editor, self.shown.kind);
        if self.panels.lists.step(editor, kind, &mut self.view.budget) {
            ctx.request_repaint();
        }
        if self.session.survey.step(self.session.editor.mesh(), &mut self.view.budget) {
            ctx.request_repaint();
        }
        self.keeper.step(&mut self.session, &mut self.view, &mut self.shown);
        title::follow(&mut self.session, &mut self.title);
        self.session.frames.end(self.session.platform.now(), self.view.budget.is_spent());
    }

    fn draw(&mut self, ui: &mut Ui, ctx: &Context, out: &mut Requests) {
        let page =
            Page { session: &self.session, shown: &self.shown, view: &self.view, player: &self.player };
        let narrow = self.shown.narrow;
        let mut widths = self.layout.widths;
        let parts = self.shown.parts;
        if parts.menu {
            let bar = Panel::top("menu bar").frame(bar_frame(ui));
            bar.show(ui, |ui| menu_bar::show(ui, &page, narrow, out));
        }
        // The viewport is drawn after the panels around it, but Tab and reading come to it first.
        let in_viewport = ui.interact(self.view.area, view::widget_id(), Sense::click_and_drag());
        let target_edge = self.panels.forms.target_edge();
        if parts.status {
            let bar = Panel::bottom("status").frame(bar_frame(ui));
            bar.show(ui, |ui| status_bar::show(ui, &page, narrow, target_edge, out));
        }
        if narrow {
            if parts.lists || parts.inspector {
                sheet::show(ui, &page, &mut self.panels, out);
            }
        } else {
            let [left, right] = self.layout.widths;
            if self.shown.left && parts.lists {
                let panel = Panel::left("elements").default_size(left).size_range(240.0..=560.0);
                let shown = panel.show(ui, |ui| self.panels.left(ui, &page, out));
                widths[0] = shown.response.rect.width().round();
            }
            if self.shown.right && parts.inspector {
                let panel = Panel::right("inspector").default_size(right).size_range(220.0..=460.0);
                let shown = panel.show(ui, |ui| {
                    self.panels.right(ui, &page, self.layout.history_height, out);
                });
                widths[1] = shown.response.rect.width().round();
            }
        }
        self.view.covered_below = if self.shown.welcome { self.panels.welcome.covers } else { 0.0 };
        let covered = CentralPanel::no_frame().show(ui, |ui| {
            let (view, player) = (&mut self.view, &mut self.player);
            Viewport { session: &self.session, shown: &self.shown, view, player }.show(ui, in_viewport, out);
            let page =
                Page { session: &self.session, shown: &self.shown, view: &self.view, player: &self.player };
            if parts.tools { tool_bar::show(ui, &page, narrow, out) } else { MarginF32::ZERO }
        });
        self.view.set_covered(covered.inner);
        let page =
            Page { session: &self.session, shown: &self.shown, view: &self.view, player: &self.player };
        live_bar::show(ctx, &page, out);
        self.panels.windows(ctx, &page, narrow, out);
        self.keep_layout(widths);
        focus_ring::show(ctx);
    }

    /// Opens pasted text; returns the actions of the pressed keys, during a live edit only those that work then.
    fn keyboard(&mut self, ctx: &Context, live: bool) -> Vec<Action> {
        if welcome::is_dismissed_by_key(ctx) {
            self.shown.welcome = false;
        }
        if !ctx.text_edit_focused() {
            let pasted = ctx.input_mut(|input| {
                let at = input.events.iter().position(|event| matches!(event, Input::Paste(_)))?;
                match input.events.remove(at) {
                    Input::Paste(text) => Some(text),
                    _ => None,
                }
            });
            if let Some(text) = pasted.filter(|text| !text.trim().is_empty()) {
                self.session.open_files(vec![NamedBytes::new("Pasted.obj", text.into_bytes())], None);
            }
        }
        if let Some(flight) = self.view.flight.as_mut().filter(|_| !ctx.text_edit_focused()) {
            flight.take_keys(ctx);
        }
        let Some(reader) = key_settings::reader(&self.page(), &self.panels) else { return Vec::new() };
        if self.view.tool == Tool::LoopCut && self.session.live.is_none() && !ctx.text_edit_focused() {
            ring_cut::take_digits(ctx, &mut self.view);
        }
        let (actions, held) =
            reader.take(ctx, |action| !live || key_settings::works_during_live_edit(action));
        self.held_keys.hold(ctx, held);
        actions
    }

    /// Whether the editor acts on a key, so that the browser must not.
    pub fn takes_key(&self, shortcut: Shortcut) -> bool {
        let acts = || {
            key_settings::reader(&self.page(), &self.panels)
                .is_some_and(|reader| reader.action_of(shortcut).is_some())
        };
        let flies = self.view.flight.is_some() && !shortcut.ctrl && !shortcut.alt;
        let listens = self.panels.key_editor.is_listening(self.shown.shortcuts);
        self.session.ctx.input(|input| input.focused) && (listens || flies || acts())
    }

    /// Ends edits that end without a request: painting when the button is released, a preview when its form
    /// leaves the screen.
    fn finish_edits(&mut self, ctx: &Context) {
        if self.session.commit_on_release && !ctx.input(|input| input.pointer.any_down()) {
            self.session.commit_on_release = false;
            self.session.editor.commit_edit();
            ctx.request_repaint();
        }
        if !self.panels.forms.previews.take_seen() && self.session.end_preview().is_some() {
            ctx.request_repaint();
        }
    }

    /// Updates lists, viewport and everything else to the changes in the editor. Called once per frame
    /// before drawing, after each key's action, and after each script call.
    fn follow(&mut self) {
        sharing::follow(&mut self.session);
        let changes = self.session.editor.take_changes();
        let look = self.session.look.take();
        if changes.is_empty() && look.is_none() {
            return;
        }
        self.session.ctx.request_repaint();
        self.notices.note(&changes);
        if !changes.is_empty() {
            self.shown.welcome &= std::mem::take(&mut self.starting);
        }
        let selection = self.session.editor.selection();
        if changes.selection && !selection.is_empty() {
            // Whatever made the selection (a click, an undo or a script), the list shows its kind.
            self.shown.kind = selection.kind();
        }
        if self.panels.lists.follow(&self.session.editor, &changes) {
            self.panels.forms.forget_lengths();
        }
        self.session.follow(&changes);
        self.panels.saving.follow(&changes);
        self.panels.history.follow(&self.session.editor, &changes);
        self.player.follow(&self.session.editor, &changes);
        self.view.follow(&self.session.editor, changes);
        textures::go_on(&mut self.session, &mut self.view);
        if let Some(look) = look {
            camera::show_target(&mut self.view, &self.session, look);
            if self.session.editor.mesh().is_some_and(|mesh| mesh.count(self.shown.kind) == 0) {
                // Points without faces can only be picked as vertices.
                self.shown.kind = Element::Vertex;
            }
        }
    }
}

fn bar_frame(ui: &Ui) -> egui::Frame {
    egui::Frame::side_top_panel(ui.style())
        .fill(theme::palette(ui.visuals()).bar)
        .inner_margin(egui::Margin::symmetric(8, 4))
}
