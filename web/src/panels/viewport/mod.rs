//! The viewport: the picture and the gestures in it.

mod bezier_picture;
pub(crate) mod control_points;
mod gesture;
mod gizmo;
mod legend;
mod numbers;
mod overlay;
mod pointer;
mod regions;

use egui::{Sense, Ui, WidgetInfo};

use crate::bezier::{self, Player};
use crate::lists::columns::element_name;
use crate::page_view::Page;
use crate::panels;
use crate::request::Requests;
use crate::session::Session;
use crate::shown::Shown;
use crate::theme;
use crate::view::{Tool, View, picture};

/// The state that the viewport reads and changes.
pub(crate) struct Viewport<'a> {
    pub session: &'a Session,
    pub shown: &'a Shown,
    pub view: &'a mut View,
    pub player: &'a mut Player,
}

impl Viewport<'_> {
    /// The state that panels read.
    fn page(&self) -> Page<'_> {
        Page { session: self.session, shown: self.shown, view: self.view, player: self.player }
    }

    /// Draws the viewport and turns gestures into requests.
    pub fn show(mut self, ui: &mut Ui, out: &mut Requests) {
        let rect = ui.available_rect_before_wrap();
        self.view.rect = rect;
        self.view.style.theme = theme::viewport(ui.visuals());
        if self.view.frame_due > 0 {
            self.view.frame_due -= 1;
            self.view.frame_start();
            ui.ctx().request_repaint();
        }
        // Not focusable: its keys are the page's keys.
        let id = ui.scope_id().with("viewport");
        let response = ui.interact(rect, id, Sense::CLICK | Sense::DRAG);
        ui.advance_cursor_after_rect(rect);
        let under = self.view.hovered.map(|(kind, id)| element_name(kind, id));
        response.widget_info(|| WidgetInfo::labeled(egui::Role::Canvas, true, "Viewport"));
        ui.ctx().accesskit_node_builder(id, |node| node.set_value(under.unwrap_or_default()));

        let was_circle = self.view.tool == Tool::Circle;
        self.gestures(ui, &response, out);
        // A right click puts the circle away, or cancels the edit that follows the pointer.
        if !was_circle && self.session.live.is_none() {
            response.context_menu(|ui| match bezier::active(&self.session.editor) {
                Some(_) => panels::bezier::menu(ui, &self.page(), out),
                None => panels::elements::menu(ui, &self.page(), out),
            });
        }
        picture::paint(ui, rect, &self.session.editor, self.view);
        bezier_picture::paint(ui, rect, &self.session.editor, self.view, self.player);
        gizmo::paint(ui, rect, &self.page());
        regions::show(ui, rect, &self.page());
        if self.shown.numbers {
            self.numbers(ui, rect);
        }
        legend::paint(ui, self.view.free_rect(), &self.page());
        overlay::paint(ui, rect, &self.page());
    }
}
