//! Starting and ending flights.

use egui::Context;
use viewport::Camera;

use super::flight::{Flight, Landing};
use super::{View, widget_id};
use crate::input::actions::Action;

/// Starts to fly in the current view, in perspective.
pub(crate) fn start(view: &mut View, ctx: &Context) {
    view.flight = Some(Flight::from(view.camera));
    view.camera.orthographic = false;
    (view.hovered, view.looked) = (None, None);
    // No control shall take the keys.
    ctx.memory_mut(|memory| memory.request_focus(widget_id()));
}

/// Ends the flight, at a time in seconds.
pub(crate) fn end(view: &mut View, how: Landing, now: f64) {
    let Some(flight) = view.flight.take() else { return };
    if how == Landing::Here {
        return;
    }
    let from = view.cameras();
    let Camera { frame_share, scene_bounds, .. } = view.camera;
    view.camera = Camera { frame_share, scene_bounds, ..flight.before };
    let to = view.cameras();
    view.glides.start(from, &to, now);
}

/// Ends the flight before another action starts. Returns whether that was all of the action.
pub(crate) fn give_way(view: &mut View, action: Action, now: f64) -> bool {
    let was_flying = view.flight.is_some();
    end(view, if action == Action::Cancel { Landing::Back } else { Landing::Here }, now);
    was_flying && matches!(action, Action::Cancel | Action::Fly)
}
