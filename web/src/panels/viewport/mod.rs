//! The viewport: the picture and the gestures in it.

mod axis_widget;
mod bezier_picture;
pub(crate) mod control_points;
mod cursor;
mod dividers;
mod fly;
mod gesture;
mod gizmo;
mod legend;
mod navigate;
mod numbers;
mod overlay;
mod panes;
mod pointer;
mod regions;
pub(crate) mod ring_cut;
mod slide;

use editor::Editor;
use egui::accesskit::Live;
use egui::{EventFilter, Response, Ui, WidgetInfo};
use halfedge::Element;

pub(crate) use pointer::ZOOM_PER_NOTCH;

use crate::bezier::{self, Player};
use crate::lists::columns::{counted, element_name};
use crate::page_view::Page;
use crate::panels;
use crate::panels::fields::selection_words;
use crate::request::Requests;
use crate::session::Session;
use crate::shown::Shown;
use crate::theme;
use crate::view::pane::Split;
use crate::view::{View, picture};

/// The state that the viewport reads and changes.
pub(crate) struct Viewport<'a> {
    pub session: &'a Session,
    pub shown: &'a Shown,
    pub view: &'a mut View,
    pub player: &'a mut Player,
}

/// The picture in words: the active object and the selection.
fn description(editor: &Editor) -> String {
    let Some(object) = editor.document().active() else { return "The document is empty".to_owned() };
    let mesh = object.mesh();
    let counts = [Element::Vertex, Element::Edge, Element::Face].map(|kind| counted(kind, mesh.count(kind)));
    let selection = editor.selection();
    let selected = selection_words(selection.kind(), selection.len(), selection.latest());
    format!("{}: {}. {selected}", object.name(), counts.join(", "))
}

impl Viewport<'_> {
    /// The state that panels read.
    fn page(&self) -> Page<'_> {
        Page { session: self.session, shown: self.shown, view: self.view, player: self.player }
    }

    /// Draws the viewport and turns gestures into requests.
    pub fn show(mut self, ui: &mut Ui, response: Response, out: &mut Requests) {
        let rect = ui.available_rect_before_wrap();
        let split = if self.shown.narrow { Split::One } else { self.shown.split };
        if self.view.lay_out(rect, split) {
            // The response is of the last frame's rectangle.
            ui.ctx().request_repaint();
        }
        self.view.style.theme = theme::viewport(ui.visuals());
        // A window that leaves no room for a picture is not drawn again until it does, nor is one with nothing to frame.
        let has_picture = rect.is_positive() && self.view.camera.scene().is_some();
        if self.view.frame_due > 0 && has_picture {
            self.view.frame_due -= 1;
            self.view.frame_start();
            ui.ctx().request_repaint();
        }
        let id = response.id;
        if response.has_focus() {
            // The arrow keys turn the view; Tab and Escape leave it.
            let arrows = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..Default::default() };
            ui.memory_mut(|memory| memory.set_focus_lock_filter(id, arrows));
        }
        ui.advance_cursor_after_rect(rect);
        let under = self.view.hovered.map(|(kind, id)| element_name(kind, id));
        response.widget_info(|| WidgetInfo::labeled(egui::Role::Canvas, true, "Viewport"));
        ui.ctx().accesskit_node_builder(id, |node| {
            node.set_value(under.unwrap_or_default());
            node.set_description(description(&self.session.editor));
            node.set_live(Live::Polite);
        });

        let ends_tool = self.view.tool.ends_on_right_click() || self.view.flight.is_some();
        self.gestures(ui, &response, out);
        // A right click puts the tool away, cancels the edit that follows the pointer, or places the cursor.
        let is_busy = ends_tool || self.session.live.is_some();
        if !is_busy && !self.place_cursor(ui, &response) {
            response.context_menu(|ui| match bezier::active(&self.session.editor) {
                Some(_) => panels::bezier::menu(ui, &self.page(), out),
                None => panels::elements::menu(ui, &self.page(), out),
            });
        }
        // What is painted follows the cameras on their way; nothing else does.
        let own = self.view.cameras();
        let shown = self.view.glides.shown(&own, ui.input(|input| input.time));
        let own = self.view.replace_cameras(shown);
        if !own.is_empty() {
            ui.ctx().request_repaint();
        }
        self.view.keep_surfaces_in_sight(&self.session.editor);
        picture::paint(ui, &self.session.editor, self.view);
        let current = self.view.panes.current;
        for pane in self.view.panes() {
            self.view.go_to(pane);
            bezier_picture::paint(ui, self.view.rect, &self.session.editor, self.view, self.player);
            cursor::paint(ui, self.view.rect, &self.page());
            gizmo::paint(ui, self.view.rect, &self.page());
            ring_cut::paint(ui, &self.page());
        }
        self.view.go_to(current);
        regions::show(ui, self.view.rect, &self.page());
        if self.shown.numbers {
            self.numbers(ui, self.view.rect);
        }
        overlay::mark_flight(ui, &self.page());
        // A telephone has no room for it above the bar of an edit.
        if !self.shown.narrow || self.session.live.is_none() {
            let free = panels::live_bar::room_above(ui.ctx(), &self.page());
            axis_widget::show(ui, free, self.shown, self.view, out);
        }
        self.view.replace_cameras(own);
        dividers::show(ui, self.view);
        panes::show(ui, &self.page(), out);
        legend::paint(ui, self.view.free_area(), &self.page());
        overlay::paint(ui, rect, &self.page());
    }
}
