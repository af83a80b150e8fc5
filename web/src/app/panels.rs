//! The state and the layout of the panels.

use crate::panels::{
    about, documents, drop_overlay, elements, hidden_bar, history, inspector, messages, named_selections,
    objects, operations, palette, pointer_menu, save, share, shortcuts, toasts, welcome,
};
use egui::{Context, ScrollArea, Ui};

use crate::bezier;
use crate::page_view::Page;
use crate::platform::Platform;
use crate::request::{Request, Requests};
use crate::session::Session;
use crate::widgets::number_box;

/// What the list of operations keeps of the column's height, in points: its filter, a heading and some rows.
const OPERATIONS_HEIGHT_POINTS: f32 = 272.0;
/// In a low window, what is about the selection keeps this much.
const MIN_INSPECTOR_HEIGHT_POINTS: f32 = 140.0;

/// The state of each panel.
pub(crate) struct Panels {
    pub lists: elements::Lists,
    pub renaming: objects::Renaming,
    pub inspector: inspector::InspectorState,
    pub forms: operations::Forms,
    pub palette: palette::PaletteState,
    pub saving: save::Saving,
    pub history: history::HistoryList,
    pub naming: named_selections::Naming,
    pub share: share::Code,
    pub documents: documents::Documents,
    pub key_editor: shortcuts::KeyEditor,
    pub welcome: welcome::Welcome,
    pub pointer_menu: pointer_menu::PointerMenu,
}

impl Panels {
    pub fn new(platform: &dyn Platform) -> Self {
        Self {
            lists: Default::default(),
            renaming: Default::default(),
            inspector: Default::default(),
            forms: Default::default(),
            palette: Default::default(),
            saving: save::Saving::new(platform),
            history: Default::default(),
            naming: Default::default(),
            share: Default::default(),
            documents: Default::default(),
            key_editor: Default::default(),
            welcome: welcome::Welcome::new(platform),
            pointer_menu: Default::default(),
        }
    }

    /// Forgets the pictures on the graphics device, which are made again when they are seen.
    pub fn forget_pictures(&mut self) {
        self.share = share::Code::default();
        self.documents.forget_pictures();
        self.welcome.forget_pictures();
    }

    /// Ends what refers to the selection, before that changes: the edit that follows the pointer, and a preview. Returns
    /// whether ids still mean what they did: those of a preview's elements are meaningless once it is removed.
    pub fn end_edits(&mut self, session: &mut Session) -> bool {
        session.end_live(true);
        self.forms.previews.end();
        session.end_preview() != Some(false)
    }

    /// The panel on the left: the objects, and the elements of the active one.
    pub fn left(&mut self, ui: &mut Ui, page: &Page<'_>, out: &mut Requests) {
        objects::show(ui, page, &mut self.renaming, out);
        elements::show(ui, page, &mut self.lists, out);
    }

    /// The panel on the right: the selection or the document, the operations below it, and the list of steps at the bottom.
    /// A form and the last operation's fields come first. However much they say, some operations stay in sight.
    pub fn right(&mut self, ui: &mut Ui, page: &Page<'_>, history_height: f32, out: &mut Requests) {
        self.history.show(ui, page, history_height, out);
        let is_form = self.forms.is_open();
        if is_form || bezier::active(&page.editor).is_some() {
            ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
                ui.add_space(4.0);
                if is_form {
                    operations::show(ui, page, &mut self.forms, out);
                    separator(ui);
                }
                inspector::show(ui, page, &mut self.inspector, out);
                if !is_form {
                    separator(ui);
                    // Few of them can be carried out on a curve.
                    operations::show(ui, page, &mut self.forms, out);
                }
            });
            return;
        }
        let most = (ui.available_height() - OPERATIONS_HEIGHT_POINTS).max(MIN_INSPECTOR_HEIGHT_POINTS);
        let above = ScrollArea::vertical().id_salt("selection").max_height(most).auto_shrink([false, true]);
        above.show(ui, |ui| {
            ui.add_space(4.0);
            // First, so that it is in view however much there is to say about the result.
            operations::adjust(ui, page, &mut self.forms, out);
            inspector::show(ui, page, &mut self.inspector, out);
        });
        separator(ui);
        ScrollArea::vertical().id_salt("operations").auto_shrink([false, false]).show(ui, |ui| {
            operations::show(ui, page, &mut self.forms, out);
        });
    }

    /// The windows over the page.
    pub fn windows(&mut self, ctx: &Context, page: &Page<'_>, narrow: bool, out: &mut Requests) {
        if let Some(reason) = number_box::take_refusal(ctx) {
            out.push(Request::Warn(reason));
        }
        hidden_bar::show(ctx, page, out);
        named_selections::show(ctx, page, &mut self.naming, out);
        welcome::show(ctx, page, &mut self.welcome, &mut self.documents, out);
        pointer_menu::show(ctx, page, &mut self.pointer_menu, out);
        palette::show(ctx, page, &mut self.palette, out);
        save::show(ctx, page, &mut self.saving, narrow, out);
        shortcuts::show(ctx, page, &mut self.key_editor, out);
        share::show(ctx, page, &mut self.share, out);
        messages::show(ctx, page, out);
        documents::show(ctx, page, &mut self.documents, out);
        about::show(ctx, page, out);
        toasts::show(ctx, page, narrow, out);
        drop_overlay::show(ctx);
    }
}

fn separator(ui: &mut Ui) {
    ui.add_space(8.0);
    ui.separator();
    ui.add_space(4.0);
}
