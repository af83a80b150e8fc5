//! Gestures in the viewport: orbit, pan, zoom, select, and drag vertices.

use editor::{OpId, SelectBy, SelectMode};
use egui::{CursorIcon, Modifiers, PointerButton, Pos2, Response, Ui};
use glam::{Vec2, Vec3, vec2};
use halfedge::{Element, Mesh};
use surface::FaceTree;
use surface::selecting::Line;
use viewport::{Aim, Camera, Picked, Region, ScreenRect};

use super::Viewport;
use super::control_points;
use super::fly;
use super::gizmo;
use super::navigate;
use super::pointer::{arrow_keys, gesture_of, is_double, is_finger, modifiers_of_button, pick_radius};
use super::ring_cut;
use super::slide;
use crate::bezier::ControlPoint;
use crate::input::actions::Action;
use crate::input::keys;
use crate::input::mouse::{Mouse, MouseAction};
use crate::live::edit::Start;
use crate::live::place::mean_of_element;
use crate::panels::live_bar;
use crate::request::{Request, Requests};
use crate::view::{Gesture, Tool};

/// A way to find the element at a pixel.
type Pick = fn(&Mesh, &FaceTree, &Camera, Vec2, Vec2, Aim) -> Option<Picked>;

impl Viewport<'_> {
    pub(super) fn gestures(&mut self, ui: &Ui, response: &Response, out: &mut Requests) {
        if response.is_pointer_button_down_on() || response.clicked() || response.secondary_clicked() {
            self.view.panes.active = self.view.panes.current;
        }
        if self.view.flight.is_some() {
            return fly::go_on(self, ui, response);
        }
        let touches = ui.input(|input| input.multi_touch());
        let pointer = response.interact_pointer_pos();
        self.view.pick_radius = pick_radius(ui, self.session.platform.has_pen());
        if let Some(touch) = touches.filter(|_| response.dragged() || response.contains_pointer()) {
            // A second finger ends whatever one finger had begun.
            self.end_gesture(None, out);
            self.view.gesture = Gesture::Ended;
            let size = self.view.size();
            let by = touch.translation_delta;
            self.view.camera.pan(vec2(by.x, by.y), size);
            let center = self.view.local(touch.center_pos);
            self.view.camera.zoom(f64::from(touch.zoom_delta), center, size);
            return;
        }
        if self.view.gesture == Gesture::Ended && !ui.input(|input| input.pointer.any_down()) {
            self.view.gesture = Gesture::None;
        }
        if self.view.tool.ends_on_right_click() && self.session.live.is_none() && response.secondary_clicked()
        {
            self.view.tool = Tool::Orbit;
            (self.view.hovered, self.view.looked) = (None, None);
            self.continue_regions(ui, out);
            return;
        }
        if self.paint(ui, response) {
            self.view.hovered = None;
            self.continue_regions(ui, out);
            return;
        }
        if response.drag_started() {
            let from = ui.input(|input| input.pointer.press_origin()).or(pointer);
            if let Some(from) = from {
                self.start_gesture(ui, response, from, out);
                if self.view.gesture == Gesture::Orbit {
                    navigate::begin_orbit(self, from);
                }
            }
        }
        // In a slow frame the last movement and the release come together.
        if response.dragged() || response.drag_stopped() {
            self.continue_gesture(ui, response, pointer, out);
        }
        if response.drag_stopped() {
            self.end_gesture(pointer.map(|at| (at, modifiers_of_button(ui))), out);
        }
        self.continue_regions(ui, out);
        navigate::wheel(self, ui, response, out);
        arrow_keys(ui, self.view);
        self.hover(ui, response);
        let is_pressed = ui.input(|input| input.pointer.any_down());
        if self.session.live.is_some() && !is_pressed && !is_finger(ui) {
            // Other bars over the viewport don't stop it. A finger leads it only by dragging: it taps on "Apply" too, and eframe
            // takes it for a mouse in the frame in which it is put down.
            let at = ui.input(|input| input.pointer.latest_pos()).filter(|at| response.rect.contains(*at));
            out.push(match at.filter(|at| live_bar::is_at(ui.ctx(), *at)) {
                Some(_) => Request::LivePointerOnBar,
                None => Request::LivePointer(at, ui.input(|input| input.modifiers)),
            });
        }
        if self.session.live.is_some() && response.secondary_clicked() {
            out.push(Request::AbandonLive);
            return;
        }
        if self.session.live.is_some() && response.clicked() {
            // A finger that taps may go on to drag: buttons end its edits.
            if !is_finger(ui) {
                out.push(Request::EndLive { commit: true });
            }
            // This click meant the edit: it is no half of a double-click.
            self.view.clicked_with = None;
            return;
        }
        if self.view.tool == Tool::LoopCut && response.clicked_by(PointerButton::Primary) {
            if let Some(start) = pointer.and_then(|at| ring_cut::start_at(self, at)) {
                out.push(Request::StartLive(start));
            }
            self.view.clicked_with = None;
            return;
        }
        if response.clicked_by(PointerButton::Primary)
            && let Some(at) = pointer
        {
            self.click(ui, at, out);
        }
        if is_double(ui, response, &mut self.view.clicked_with)
            && let Some(at) = pointer
            && self.control_point_at(at).is_none()
            // Where a double-click means nothing, each of two quick clicks has a meaning of its own.
            && let Some(action) = self.mouse().double_click(modifiers_of_button(ui), self.shown.kind)
        {
            let insert = control_points::add_control_point_at(&self.session.editor, self.view, at);
            match insert {
                Some(insert) => out.push(Request::InsertControlPoint(insert)),
                None => self.select_by(action, at, out),
            }
        }
        if response.secondary_clicked()
            && self.mouse().right_click(modifiers_of_button(ui)).is_none()
            && let Some(at) = pointer
            && let Some(id) = self.pick(at, self.shown.kind)
            && !self.session.editor.selection().contains(self.shown.kind, id)
        {
            out.select(self.shown.kind, [id], SelectMode::Replace);
        }
    }

    /// Puts the 3D cursor where the pointer is, if this right-click means that; returns whether it does.
    pub(super) fn place_cursor(&mut self, ui: &Ui, response: &Response) -> bool {
        let action = self.mouse().right_click(modifiers_of_button(ui));
        let is_meant = response.secondary_clicked() && action == Some(MouseAction::PlaceCursor);
        if let Some(at) = response.interact_pointer_pos().filter(|_| is_meant) {
            navigate::place_cursor(self, at);
        }
        is_meant
    }

    fn start_gesture(&mut self, ui: &Ui, response: &Response, from: Pos2, out: &mut Requests) {
        let modifiers = modifiers_of_button(ui);
        let primary = response.dragged_by(PointerButton::Primary);
        if primary && self.session.live.is_some() {
            let by_finger = is_finger(ui);
            if by_finger {
                out.push(Request::TakeUpLive(from));
            }
            self.view.gesture = Gesture::Live { applies: !by_finger };
            return;
        }
        if primary && !modifiers.any() && keys::is_held(ui.ctx(), Action::Soft) {
            out.push(Request::WidenSoft(0.0));
            self.view.gesture = Gesture::SoftRadius;
            return;
        }
        let handle = gizmo::handle_at(&self.page(), from, self.view.pick_radius)
            .filter(|_| primary && !modifiers.any());
        if let Some(handle) = handle {
            out.push(Request::StartLive(handle.start(from)));
            self.view.gesture = Gesture::Live { applies: true };
            return;
        }
        // With Alt held, a tool gives way to the view.
        let tool = if primary && !modifiers.alt { self.view.tool } else { Tool::Orbit };
        self.view.gesture = match tool {
            Tool::Lasso => Gesture::Lasso { points: vec![from], secondary: false },
            Tool::Box => Gesture::Box { from },
            Tool::LoopCut => match ring_cut::start_at(self, from) {
                Some(start) => {
                    out.push(Request::StartLive(start));
                    Gesture::Live { applies: !is_finger(ui) }
                }
                None => Gesture::Orbit,
            },
            _ if primary && !modifiers.any() => self.start_plain_drag(ui, from, out),
            _ => {
                let buttons = [PointerButton::Primary, PointerButton::Secondary, PointerButton::Middle];
                let button = buttons.into_iter().find(|button| response.dragged_by(*button));
                let action = button.and_then(|button| self.mouse().drag(button, modifiers));
                match action {
                    Some(MouseAction::Slide) => slide::start(self, from, out),
                    _ => gesture_of(action, from),
                }
            }
        };
    }

    /// A drag with the first button and no modifier: it moves what it begins on.
    fn start_plain_drag(&mut self, ui: &Ui, from: Pos2, out: &mut Requests) -> Gesture {
        if let Some((point, anchor)) = self.control_point_at(from) {
            self.player.controls.choose(Some(point));
            return Gesture::Control { point, from, anchor };
        }
        if let Some(anchor) = self.movable(from) {
            let start = Start::new(OpId::Transform, "translate");
            out.push(Request::StartLive(Start { from: Some(from), anchor: Some(anchor), ..start }));
            return Gesture::Live { applies: true };
        }
        // One finger has no other way to turn the view.
        if is_finger(ui) {
            return Gesture::Orbit;
        }
        gesture_of(self.mouse().drag(PointerButton::Primary, Modifiers::NONE), from)
    }

    /// How a box or a lasso with these modifiers changes the selection.
    fn mode_within(&self, modifiers: Modifiers) -> SelectMode {
        let adds = self.shown.adds && modifiers.is_none();
        if adds { SelectMode::Extend } else { self.mouse().mode_within(modifiers) }
    }

    /// What clicks and drags do in the preset of keys.
    fn mouse(&self) -> &'static Mouse {
        keys::map(&self.session.ctx).mouse()
    }

    /// The point under the pointer of a selected element: dragging it moves the selection.
    fn movable(&mut self, at: Pos2) -> Option<Vec3> {
        let (kind, selection) = (self.shown.kind, self.session.editor.selection());
        if selection.kind() != kind || selection.is_empty() {
            return None;
        }
        // A drag that begins inside a face, beside a selected vertex or edge, turns the view.
        let id = self.pick_by(viewport::pick, at, kind)?;
        let mesh = self.session.editor.mesh()?;
        let is_selected = self.session.editor.selection().contains(kind, id);
        is_selected.then(|| mean_of_element(mesh, kind, id))
    }

    fn continue_gesture(&mut self, ui: &Ui, response: &Response, pointer: Option<Pos2>, out: &mut Requests) {
        let by = vec2(response.drag_delta().x, response.drag_delta().y);
        navigate::drag(ui, self.view, by);
        match (&self.view.gesture, pointer) {
            (Gesture::Lasso { .. }, _) => self.draw_lasso(ui),
            (&Gesture::Control { point, from, anchor }, Some(at))
                if response.drag_delta() != egui::Vec2::ZERO || response.drag_stopped() =>
            {
                let to = control_points::dragged_to(&self.session.editor, self.view, anchor, from, at);
                if to.is_finite() {
                    out.update_edit(control_points::moved(point, to));
                }
            }
            (Gesture::Live { .. }, Some(at)) => {
                out.push(Request::LivePointer(Some(at), ui.input(|input| input.modifiers)));
            }
            (Gesture::Slide, Some(at)) => out.push(Request::LivePointer(Some(at), Modifiers::NONE)),
            (Gesture::SoftRadius, _) if by.x != 0.0 => out.push(Request::WidenSoft(by.x)),
            _ => {}
        }
    }

    /// Ends the drag at a place, with these modifiers held. Without a place, cancels the drag.
    fn end_gesture(&mut self, at: Option<(Pos2, Modifiers)>, out: &mut Requests) {
        match (std::mem::replace(&mut self.view.gesture, Gesture::None), at) {
            (Gesture::Live { applies: true } | Gesture::Slide, at) => {
                out.push(Request::EndLive { commit: at.is_some() })
            }
            (Gesture::Control { .. }, Some(_)) => out.push(Request::CommitEdit),
            (Gesture::Control { .. }, None) => out.push(Request::CancelEdit),
            (Gesture::Box { from }, Some((to, modifiers))) => {
                let (from, to) = (self.view.local(from), self.view.local(to));
                let mode = self.mode_within(modifiers);
                self.select_in(Region::rect(ScreenRect::between(from, to)), mode, None);
            }
            (Gesture::Lasso { points, secondary }, Some((_, modifiers))) => {
                // With the right button, Ctrl is what makes it a lasso.
                let mode = match self.mouse().drag(PointerButton::Secondary, modifiers).filter(|_| secondary)
                {
                    Some(MouseAction::Lasso(mode)) => mode,
                    _ if secondary => SelectMode::Replace,
                    _ => self.mode_within(modifiers),
                };
                self.end_lasso(points, mode);
            }
            _ => {}
        }
    }

    /// Finds the element under the pointer if the pointer or the view moved.
    fn hover(&mut self, ui: &Ui, response: &Response) {
        // During an edit that follows the pointer, the pointer sets an amount and picks nothing.
        let going = self.view.gesture != Gesture::None || self.session.live.is_some();
        let at = response.hover_pos().filter(|_| !going && !response.is_pointer_button_down_on());
        let Some(at) = at else {
            if !going || self.session.live.is_some() {
                self.view.hovered = None;
                self.player.hovered = None;
                self.view.looked = None;
            }
            return;
        };
        let kind = if self.view.tool == Tool::LoopCut { Element::Edge } else { self.shown.kind };
        let look = (at, self.view.camera, kind, self.view.style.x_ray);
        if self.view.looked == Some(look) {
            return;
        }
        let active = self.session.editor.document().active().filter(|object| object.visible());
        if active.is_some_and(|object| !self.view.build_tree_step(object)) {
            // The next frame continues, with more of the tree built.
            ui.ctx().request_repaint();
            return;
        }
        self.view.looked = Some(look);
        self.player.hovered = self.control_point_at(at).map(|(point, _)| point);
        self.view.hovered = match self.player.hovered {
            Some(_) => None,
            None => self.pick(at, kind).map(|id| (kind, id)),
        };
        ring_cut::follow_hovered(self);
        if (self.view.hovered.is_some() || self.player.hovered.is_some()) && self.view.tool == Tool::Orbit {
            ui.ctx().set_cursor_icon(CursorIcon::PointingHand);
        }
    }

    fn control_point_at(&self, at: Pos2) -> Option<(ControlPoint, Vec3)> {
        control_points::control_point_at(&self.session.editor, self.view, self.player, at)
    }

    /// The element that a click at a place on the page means: on a model there is always one.
    pub(super) fn pick(&mut self, at: Pos2, kind: Element) -> Option<u32> {
        self.pick_by(viewport::pick_nearest, at, kind)
    }

    fn pick_by(&mut self, pick: Pick, at: Pos2, kind: Element) -> Option<u32> {
        let object = self.session.editor.document().active().filter(|object| object.visible())?;
        let (camera, local, size) = (self.view.camera, self.view.local(at), self.view.size());
        let aim = Aim { kind, radius: self.view.pick_radius, through: self.view.style.x_ray };
        let mesh = object.mesh();
        let tree = self.view.tree(object);
        pick(mesh, tree, &camera, size, local, aim).map(|picked| picked.id)
    }

    /// Selects the line of elements of the listed kind through the edge nearest to a place on the page.
    fn select_line(&mut self, at: Pos2, line: Line, mode: SelectMode, out: &mut Requests) {
        let kind = self.shown.kind;
        // A vertex or a face lies on lines in several directions: the nearest edge decides.
        let Some(through) = self.pick(at, Element::Halfedge) else { return };
        out.push(Request::SelectLine { kind, through, line, mode });
    }

    fn click(&mut self, ui: &Ui, at: Pos2, out: &mut Requests) {
        let modifiers = modifiers_of_button(ui);
        let point = self.control_point_at(at).map(|(point, _)| point);
        self.player.controls.choose(point);
        if point.is_some() {
            return;
        }
        let adds = self.shown.adds && modifiers.is_none();
        let toggles = adds.then_some(MouseAction::Select(SelectMode::Toggle));
        if let Some(action) = toggles.or_else(|| self.mouse().click(modifiers)) {
            self.select_by(action, at, out);
        }
    }

    /// Selects what a click on a place of the page means.
    fn select_by(&mut self, action: MouseAction, at: Pos2, out: &mut Requests) {
        let kind = self.shown.kind;
        match action {
            MouseAction::Line(line, mode) => self.select_line(at, line, mode, out),
            MouseAction::Linked => out.act(Action::SelectBy(SelectBy::Linked)),
            MouseAction::Path => {
                if let Some(to) = self.pick(at, kind) {
                    out.push(Request::SelectPath { kind, to });
                }
            }
            MouseAction::Select(mode) => match self.pick(at, kind) {
                Some(id) => out.select(kind, [id], mode),
                // With a modifier held, a near miss should not clear the selection.
                None if mode == SelectMode::Replace => out.push(Request::Deselect),
                None => {}
            },
            _ => {}
        }
    }
}
