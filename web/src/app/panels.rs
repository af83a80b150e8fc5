//! The state and the layout of the panels.

use crate::panels::{
    about, drop_overlay, elements, hidden_bar, history, inspector, messages, named_selections, objects,
    operations, palette, save, shortcuts, toasts, welcome,
};
use egui::{Context, ScrollArea, Ui};

use crate::page_view::Page;
use crate::platform::Platform;
use crate::request::Requests;

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
    pub key_editor: shortcuts::KeyEditor,
    pub welcome: welcome::Welcome,
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
            key_editor: Default::default(),
            welcome: welcome::Welcome::new(platform),
        }
    }

    /// The panel on the left: the objects, and the elements of the active one.
    pub fn left(&mut self, ui: &mut Ui, page: &Page<'_>, out: &mut Requests) {
        objects::show(ui, page, &mut self.renaming, out);
        elements::show(ui, page, &mut self.lists, out);
    }

    /// The panel on the right: the selection or the document, the operations below it, and the list of steps at the bottom.
    /// A form and the last operation's fields come first.
    pub fn right(&mut self, ui: &mut Ui, page: &Page<'_>, history_height: f32, out: &mut Requests) {
        self.history.show(ui, page, history_height, out);
        ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
            ui.add_space(4.0);
            if self.forms.is_open() {
                operations::show(ui, page, &mut self.forms, out);
                separator(ui);
                inspector::show(ui, page, &mut self.inspector, out);
            } else {
                // First, so that it is in view however much there is to say about the result.
                operations::adjust(ui, page, &mut self.forms, out);
                inspector::show(ui, page, &mut self.inspector, out);
                separator(ui);
                operations::show(ui, page, &mut self.forms, out);
            }
        });
    }

    /// The windows over the page.
    pub fn windows(&mut self, ctx: &Context, page: &Page<'_>, narrow: bool, out: &mut Requests) {
        hidden_bar::show(ctx, page, out);
        named_selections::show(ctx, page, &mut self.naming, out);
        welcome::show(ctx, page, &mut self.welcome, out);
        palette::show(ctx, page, &mut self.palette, out);
        save::show(ctx, page, &mut self.saving, narrow, out);
        shortcuts::show(ctx, page, &mut self.key_editor, out);
        messages::show(ctx, page, out);
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
