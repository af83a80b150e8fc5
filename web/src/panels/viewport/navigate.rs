//! Moving the camera: drags, the wheel, a trackpad.

use egui::{CursorIcon, Event, Pos2, Response, Ui};
use glam::{DVec3, vec2};

use super::Viewport;
use super::pointer::zoom_of;
use super::ring_cut;
use crate::input::camera_style::OrbitAbout;
use crate::input::keys;
use crate::input::mouse::MouseAction;
use crate::live::edit_keys::notches_of;
use crate::live::place::SelectionPlace;
use crate::request::{Request, Requests};
use crate::view::{Gesture, Tool, View};

/// A drag that zooms makes things larger by the factor e over this distance, in points.
const ZOOM_DRAG_POINTS: f32 = 200.0;

/// Decides what an orbit that begins at a place on the page turns about.
pub(super) fn begin_orbit(viewport: &mut Viewport<'_>, at: Pos2) {
    let center = match viewport.view.turning.about {
        OrbitAbout::View => None,
        OrbitAbout::Selection => {
            SelectionPlace::of_selection(&viewport.session.editor).map(|place| place.middle.as_dvec3())
        }
        OrbitAbout::Pointer => {
            surface_at(viewport, at).or(viewport.view.camera.scene().map(|scene| scene.center().as_dvec3()))
        }
    };
    viewport.view.turning.center = center;
}

/// Puts the 3D cursor at a place on the page: on the surface there, or else as far away as what the view turns about.
pub(super) fn place_cursor(viewport: &mut Viewport<'_>, at: Pos2) {
    let on_surface = surface_at(viewport, at).map(|point| point.as_vec3());
    let view = &mut *viewport.view;
    let target = view.camera.target.as_vec3();
    let beside = || {
        let middle = view.camera.project(target, view.size())?;
        Some(view.camera.drag(target, view.local(at) - middle, view.size()))
    };
    if let Some(point) = on_surface.or_else(beside).filter(|point| point.is_finite()) {
        view.cursor.place(point, &viewport.session.editor);
    }
}

/// The point of a visible object's surface at a place on the page, the nearest to the eye. Leaves objects out whose trees
/// for picking are still being built.
pub(super) fn surface_at(viewport: &mut Viewport<'_>, at: Pos2) -> Option<DVec3> {
    let view = &mut *viewport.view;
    let ray = view.camera.ray(view.local(at), view.size());
    let visible = viewport.session.editor.document().objects().iter().filter(|object| object.visible());
    let hits = visible.filter_map(|object| {
        view.build_tree_step(object).then(|| view.tree(object).hit(object.mesh(), ray)).flatten()
    });
    let nearest = hits.min_by(|a, b| a.distance.total_cmp(&b.distance));
    nearest.map(|hit| hit.point.as_dvec3())
}

/// Continues a drag that moves the camera by so many points.
pub(super) fn drag(ui: &Ui, view: &mut View, by: glam::Vec2) {
    let size = view.size();
    let cursor = match view.gesture {
        Gesture::Orbit => {
            view.turn(by);
            CursorIcon::Grabbing
        }
        Gesture::Pan => {
            view.camera.pan(by, size);
            CursorIcon::Move
        }
        Gesture::Zoom => {
            view.camera.zoom(f64::from((by.x - by.y) / ZOOM_DRAG_POINTS).exp(), size * 0.5, size);
            CursorIcon::ZoomIn
        }
        _ => return,
    };
    ui.ctx().set_cursor_icon(cursor);
}

/// Acts on the wheel, and on two fingers on a trackpad.
pub(super) fn wheel(viewport: &mut Viewport<'_>, ui: &Ui, response: &Response, out: &mut Requests) {
    // Not over a bar that lies on the viewport.
    if !response.hovered() {
        return;
    }
    let Some(at) = ui.input(|input| input.pointer.hover_pos()) else { return };
    let scroll = ui.input_mut(|input| std::mem::take(&mut input.smooth_scroll_delta));
    // Smooth scrolling goes on for several frames after a notch: where notches are counted, only the notch counts.
    let notches: i32 = ui.input(|input| input.events.iter().map(notches_of).sum());
    let session = viewport.session;
    if session.live.as_ref().is_some_and(|live| live.takes_wheel(&session.live_settings)) {
        if notches != 0 {
            out.push(Request::LiveWheel(notches));
        }
        return;
    }
    let holds_command = ui.input(|input| input.modifiers.command);
    if viewport.view.tool == Tool::LoopCut && !holds_command {
        return ring_cut::turn_wheel(viewport.view, notches);
    }
    if viewport.view.tool == Tool::Circle {
        viewport.view.scale_circle((scroll.y / 240.0).exp());
    }
    // The wheel sets the circle's size; with Ctrl it zooms all the same.
    let is_for_circle = viewport.view.tool == Tool::Circle && !holds_command;
    let moves = |event: &&Event| match event {
        Event::MouseWheel { .. } => !is_for_circle,
        Event::Zoom(_) => true,
        _ => false,
    };
    let (events, now) =
        ui.input(|input| (input.events.iter().filter(moves).cloned().collect::<Vec<_>>(), input.time));
    for event in &events {
        move_by(viewport, ui, event, at, now);
    }
}

/// Moves the camera as one event says.
fn move_by(viewport: &mut Viewport<'_>, ui: &Ui, event: &Event, at: Pos2, now: f64) {
    let mut action = None;
    if let Event::MouseWheel { unit, delta, modifiers, .. } = event {
        let starts = viewport.view.turning.scrolling.is_over(now);
        if viewport.view.turning.scrolling.is_by_fingers(*unit, *delta, now) {
            action = keys::map(ui.ctx()).mouse().scroll(*modifiers).map(|action| (action, starts, *delta));
        }
    }
    let size = viewport.view.size();
    match action {
        Some((MouseAction::Orbit, starts, by)) => {
            if starts {
                begin_orbit(viewport, at);
            }
            viewport.view.turn(vec2(by.x, by.y));
        }
        Some((MouseAction::Pan, _, by)) => viewport.view.camera.pan(vec2(by.x, by.y), size),
        _ => {
            let local = viewport.view.local(at);
            viewport.view.camera.zoom(zoom_of(event), local, size);
        }
    }
}
