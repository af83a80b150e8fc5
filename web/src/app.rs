//! The editor on a screen: what is shown, and how a frame goes.

use editor::{Changes, Editor, ObjectChange, ObjectId};
use egui::{CentralPanel, Context, Panel, ThemePreference, Ui};
use halfedge::Element;

use crate::availability::Availability;
use crate::bezier::Player;
use crate::frame_times::FrameTimes;
use crate::jobs::Jobs;
use crate::lists::index::RowIndex;
use crate::lists::row_list::RowListState;
use crate::live::Live;
use crate::measures::Measured;
use crate::panels::adjust::Adjusting;
use crate::panels::operations::Forms;
use crate::panels::palette::PaletteState;
use crate::panels::save::Saving;
use crate::platform::{Event, Platform};
use crate::survey::Survey;
use crate::theme;
use crate::toasts::Toasts;
use crate::viewport_widget::View;

/// Which parts of the page are open.
#[derive(Clone, Debug)]
pub(crate) struct Shown {
    pub left: bool,
    pub right: bool,
    pub overlay: bool,
    pub shortcuts: bool,
    pub messages: bool,
    pub about: bool,
    /// The sheet of the narrow layout.
    pub sheet: crate::panels::sheet::Sheet,
}

/// The lists of the active object.
#[derive(Default)]
pub(crate) struct Lists {
    /// The kind that is shown.
    pub kind: ShownKind,
    pub only_selected: bool,
    pub go_to: String,
    /// Puts the keyboard into the "Go to id" field in the next frame.
    pub focus_go_to: bool,
    indices: [RowIndex; 4],
    pub states: [RowListState; 4],
    /// A selected element that is to be scrolled to.
    pub reveal: bool,
}

/// The kind of element whose list is shown; vertices at first.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) struct ShownKind(pub Element);

impl Default for ShownKind {
    fn default() -> Self {
        Self(Element::Vertex)
    }
}

/// The place of a kind in arrays that have one entry for each.
pub(crate) fn slot(kind: Element) -> usize {
    Element::ALL.iter().position(|&k| k == kind).unwrap_or_default()
}

impl Lists {
    /// The rows of a kind.
    pub fn index(&self, kind: Element) -> &RowIndex {
        &self.indices[slot(kind)]
    }

    fn follow(&mut self, editor: &Editor, change: Option<&ObjectChange>) {
        let Some(mesh) = editor.mesh() else {
            self.indices = Default::default();
            return;
        };
        for kind in Element::ALL {
            let index = &mut self.indices[slot(kind)];
            match change {
                Some(ObjectChange::Touched(touched)) => index.follow(mesh, kind, touched),
                _ => *index = RowIndex::new(mesh, kind),
            }
        }
    }
}

impl Shown {
    /// Closes the windows that are open; gives whether there were any.
    pub fn close_windows(&mut self) -> bool {
        let any = self.shortcuts || self.messages || self.about;
        (self.shortcuts, self.messages, self.about) = (false, false, false);
        any
    }
}

/// The editor with its screen. [`App::logic`] and [`App::ui`] are called once a frame each.
pub struct App {
    pub(crate) editor: Editor,
    pub(crate) platform: Box<dyn Platform>,
    pub(crate) ctx: Context,
    pub(crate) view: View,
    pub(crate) lists: Lists,
    pub(crate) shown: Shown,
    pub(crate) toasts: Toasts,
    pub(crate) jobs: Jobs,
    pub(crate) forms: Forms,
    /// The edit that follows the pointer.
    pub(crate) live: Option<Live>,
    pub(crate) adjusting: Adjusting,
    pub(crate) palette: PaletteState,
    pub(crate) saving: Saving,
    pub(crate) availability: Availability,
    pub(crate) survey: Survey,
    pub(crate) measured: Measured,
    pub(crate) player: Player,
    pub(crate) frames: FrameTimes,
    /// The object whose rows the lists have.
    listed: Option<ObjectId>,
}

/// The setting that keeps the theme.
const THEME_SETTING: &str = "theme";

impl App {
    /// An editor with a cube in it. Without `gpu` the viewport says that it can't draw.
    pub fn new(ctx: &Context, platform: Box<dyn Platform>, gpu: Option<egui_wgpu::RenderState>) -> Self {
        theme::install(ctx);
        ctx.options_mut(|options| options.zoom_with_keyboard = false);
        ctx.set_theme(match platform.load_setting(THEME_SETTING).as_deref() {
            Some("light") => ThemePreference::Light,
            Some("dark") => ThemePreference::Dark,
            _ => ThemePreference::System,
        });
        let mut app = Self {
            editor: Editor::new(),
            ctx: ctx.clone(),
            view: View::new(gpu),
            lists: Lists::default(),
            shown: Shown {
                left: true,
                right: true,
                overlay: false,
                shortcuts: false,
                messages: false,
                about: false,
                sheet: Default::default(),
            },
            toasts: Toasts::default(),
            jobs: Jobs::default(),
            forms: Forms::default(),
            live: None,
            adjusting: Adjusting::default(),
            palette: PaletteState::default(),
            saving: Saving::new(&*platform),
            availability: Availability::default(),
            survey: Survey::default(),
            measured: Measured::default(),
            player: Player::default(),
            frames: FrameTimes::default(),
            listed: None,
            platform,
        };
        app.open_first();
        app.fetch_wanted();
        app
    }

    /// The document and its history, for reading.
    pub fn editor(&self) -> &Editor {
        &self.editor
    }

    /// Takes in what happened since the last frame. Draws nothing.
    pub fn logic(&mut self, ctx: &Context) {
        for event in self.platform.poll(ctx) {
            match event {
                Event::JobProgress { job, fraction } => self.jobs.progress(job, fraction),
                Event::JobDone { job, result } => self.job_done(job, result),
                Event::Fetched { job, files } => self.fetched(job, files),
                Event::Files(files) => self.open_files(files, None),
                Event::Failed(text) => self.fail(text),
            }
        }
        self.follow();
    }

    /// Draws a frame and acts on its input.
    pub fn ui(&mut self, ui: &mut Ui) {
        let started = self.platform.now();
        let ctx = ui.ctx().clone();
        if !self.live_keys(&ctx) {
            self.keyboard(&ctx);
        }
        let narrow = ui.available_width() < theme::NARROW;
        Panel::top("menu bar").frame(bar_frame(ui)).show(ui, |ui| self.menu_bar(ui, narrow));
        if narrow {
            Panel::bottom("status").frame(bar_frame(ui)).show(ui, |ui| self.status_bar(ui, true));
            self.sheet(ui);
        } else {
            Panel::bottom("status").frame(bar_frame(ui)).show(ui, |ui| self.status_bar(ui, false));
            if self.shown.left {
                Panel::left("elements").default_size(332.0).size_range(240.0..=560.0).show(ui, |ui| {
                    self.objects(ui);
                    self.elements(ui);
                });
            }
            if self.shown.right {
                Panel::right("inspector").default_size(300.0).size_range(220.0..=460.0).show(ui, |ui| {
                    self.right_panel(ui);
                });
            }
        }
        CentralPanel::no_frame().show(ui, |ui| self.viewport(ui));
        self.live_bar(&ctx);
        self.windows(&ctx, narrow);
        self.finish_live_edit(&ctx);
        self.end_unseen_preview();
        self.follow();
        self.frames.record(self.platform.now() - started);
    }

    /// The theme, kept for later visits.
    pub(crate) fn set_theme(&mut self, theme: ThemePreference) {
        self.ctx.set_theme(theme);
        let name = match theme {
            ThemePreference::Light => "light",
            ThemePreference::Dark => "dark",
            ThemePreference::System => "system",
        };
        self.platform.store_setting(THEME_SETTING, name);
    }

    /// Makes lists, viewport and counts follow what changed in the editor.
    pub(crate) fn follow(&mut self) {
        let changes = self.editor.take_changes();
        if changes.is_empty() {
            return;
        }
        self.ctx.request_repaint();
        self.availability.forget();
        self.follow_lists(&changes);
        self.survey.follow(&self.editor, &changes);
        self.saving.follow(&changes);
        self.measured.follow(&self.editor, &changes);
        self.player.follow(&self.editor, &changes);
        self.view.follow(&self.editor, changes);
    }

    fn follow_lists(&mut self, changes: &Changes) {
        let active = self.editor.document().active().map(editor::Object::id);
        if active != self.listed {
            self.listed = active;
            self.forms.forget_lengths();
            self.lists.follow(&self.editor, None);
            self.lists.states = Default::default();
        } else if let Some(change) = active.and_then(|id| changes.of(id)) {
            self.lists.follow(&self.editor, Some(change));
        }
        if changes.selection {
            let selection = self.editor.selection();
            if !selection.is_empty() {
                // Whoever selected, a click, an undo or a script: the list shows that kind.
                self.lists.kind = ShownKind(selection.kind());
                self.lists.reveal = true;
            }
        }
    }

    fn windows(&mut self, ctx: &Context, narrow: bool) {
        self.palette_window(ctx);
        self.save_window(ctx, narrow);
        self.shortcuts_window(ctx);
        self.messages_window(ctx);
        self.about_window(ctx);
        self.toasts(ctx, narrow);
        self.drop_overlay(ctx);
    }
}

fn bar_frame(ui: &Ui) -> egui::Frame {
    egui::Frame::side_top_panel(ui.style())
        .fill(theme::palette(ui.visuals()).bar)
        .inner_margin(egui::Margin::symmetric(8, 4))
}
