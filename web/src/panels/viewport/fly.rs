//! The flight in progress: what the pointer and the wheel do in it.

use egui::{CursorIcon, PointerButton, Response, Ui};
use glam::vec2;

use super::Viewport;
use super::navigate::surface_at;
use crate::live::edit_keys::notches_of;
use crate::view::flight::Landing;
use crate::view::{Gesture, flying};

/// Goes on with the flight.
pub(super) fn go_on(viewport: &mut Viewport<'_>, ui: &Ui, response: &Response) {
    let Some(ending) = viewport.view.flight.map(|flight| flight.ends.or(ending_by_pointer(ui, response)))
    else {
        return;
    };
    look_and_move(viewport, ui, response);
    if let Some(how) = ending {
        if how == Landing::Here {
            turn_about_what_is_seen(viewport);
        }
        flying::end(viewport.view, how, ui.input(|input| input.time));
        viewport.view.gesture = Gesture::Ended;
        ui.ctx().request_repaint();
    }
}

/// How the pointer ends the flight: a click stays, a right-click goes back. A press elsewhere means something else, so it
/// stays too.
fn ending_by_pointer(ui: &Ui, response: &Response) -> Option<Landing> {
    let is_over = response.clicked() || response.drag_stopped();
    let by_second = response.secondary_clicked() || response.drag_stopped_by(PointerButton::Secondary);
    let elsewhere = ui.input(|input| input.pointer.any_pressed()) && !response.is_pointer_button_down_on();
    match (by_second, is_over || elsewhere) {
        (true, _) => Some(Landing::Back),
        (false, true) => Some(Landing::Here),
        (false, false) => None,
    }
}

fn look_and_move(viewport: &mut Viewport<'_>, ui: &Ui, response: &Response) {
    let view = &mut *viewport.view;
    let size = view.size();
    let Some(flight) = &mut view.flight else { return };
    let at = ui.input(|input| input.pointer.latest_pos()).filter(|at| response.rect.contains(*at));
    if let Some((before, now)) = std::mem::replace(&mut flight.seen, at).zip(at)
        && before != now
    {
        view.camera.look_around(vec2(now.x - before.x, now.y - before.y), size);
    }
    let notches: i32 = ui.input(|input| input.events.iter().map(notches_of).sum());
    flight.turn_wheel(notches);
    ui.input_mut(|input| input.smooth_scroll_delta = egui::Vec2::ZERO);
    if let Some(step) = ui.input(|input| flight.step(input)) {
        view.camera.fly(step);
        ui.ctx().request_repaint();
    }
    if at.is_some() {
        ui.ctx().set_cursor_icon(CursorIcon::Crosshair);
    }
}

/// Makes the point of the surface in the middle of the view what the view turns about from now on.
fn turn_about_what_is_seen(viewport: &mut Viewport<'_>) {
    let middle = viewport.view.rect.center();
    let Some(point) = surface_at(viewport, middle) else { return };
    let camera = &mut viewport.view.camera;
    camera.set_target_distance(camera.depth(point.as_vec3()));
}
