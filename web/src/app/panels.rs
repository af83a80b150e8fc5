//! The state and the layout of the panels.

use crate::panels::{
    about, drop_overlay, elements, inspector, messages, objects, operations, palette, save, shortcuts, toasts,
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
        }
    }

    /// The panel on the left: the objects, and the elements of the active one.
    pub fn left(&mut self, ui: &mut Ui, page: &Page<'_>, out: &mut Requests) {
        objects::show(ui, page, &mut self.renaming, out);
        elements::show(ui, page, &mut self.lists, out);
    }

    /// The panel on the right: the inspector, and the operations below it.
    pub fn right(&mut self, ui: &mut Ui, page: &Page<'_>, out: &mut Requests) {
        ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
            inspector::show(ui, page, &mut self.inspector, out);
            ui.add_space(6.0);
            ui.separator();
            operations::show(ui, page, &mut self.forms, out);
        });
    }

    /// The windows over the page.
    pub fn windows(&mut self, ctx: &Context, page: &Page<'_>, narrow: bool, out: &mut Requests) {
        palette::show(ctx, page, &mut self.palette, out);
        save::show(ctx, page, &mut self.saving, narrow, out);
        shortcuts::show(ctx, page, out);
        messages::show(ctx, page, out);
        about::show(ctx, page, out);
        toasts::show(ctx, page, narrow, out);
        drop_overlay::show(ctx);
    }
}
