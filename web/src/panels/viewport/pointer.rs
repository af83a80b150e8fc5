//! What the viewport reads of the pointer, and the keys that move the view.

use egui::{Event, Key, Modifiers, MouseWheelUnit, PointerButton, Pos2, Response, Ui};
use glam::vec2;

use crate::input::mouse::MouseAction;
use crate::view::{Gesture, View, widget_id};

/// How far an arrow key turns or moves the view: as far as a drag of this many pixels.
const ARROW_KEY_PIXELS: f32 = 40.0;

/// The radius around a mouse's pointer in which a vertex or an edge is picked, in points.
const MOUSE_RADIUS_POINTS: f32 = 8.0;
/// The radius around the tip of a pen, which is held less still than a mouse.
const PEN_RADIUS_POINTS: f32 = 13.0;
/// The radius around a finger, half of a touch target: the nearest element in it is meant.
const FINGER_RADIUS_POINTS: f32 = 22.0;

/// The zoom of one notch of a wheel.
pub(crate) const ZOOM_PER_NOTCH: f64 = 1.12;
/// The most notches that count of one event: some wheels and browsers report many at once.
const MAX_NOTCHES_PER_EVENT: f32 = 3.0;
/// What browsers report of one notch: pixels, or lines. Trackpads report parts of it.
const NOTCH_POINTS: f32 = 120.0;
const NOTCH_LINES: f32 = 3.0;
/// The most that one event of a pinch zooms.
const MAX_ZOOM_PER_PINCH: f64 = 1.5;

/// How much larger an event of a wheel or a trackpad makes things.
pub(super) fn zoom_of(event: &Event) -> f64 {
    match event {
        Event::MouseWheel { unit, delta, .. } => {
            let notches = match unit {
                MouseWheelUnit::Point => delta.y / NOTCH_POINTS,
                MouseWheelUnit::Line => delta.y / NOTCH_LINES,
                MouseWheelUnit::Page => delta.y,
            };
            ZOOM_PER_NOTCH.powf(notches.clamp(-MAX_NOTCHES_PER_EVENT, MAX_NOTCHES_PER_EVENT).into())
        }
        Event::Zoom(factor) => f64::from(*factor).clamp(1.0 / MAX_ZOOM_PER_PINCH, MAX_ZOOM_PER_PINCH),
        _ => 1.0,
    }
}

/// The modifiers that were held when the pointer's button was pressed or released in this frame: by the end of a slow
/// frame they may have been let go.
pub(super) fn modifiers_of_button(ui: &Ui) -> Modifiers {
    ui.input(|input| {
        let of_button = input.events.iter().rev().find_map(|event| match event {
            Event::PointerButton { modifiers, .. } => Some(*modifiers),
            _ => None,
        });
        of_button.unwrap_or(input.modifiers)
    })
}

/// Whether this is the second click of a double-click: both with the same modifiers. `before` has those of the last click.
pub(super) fn is_double(ui: &Ui, response: &Response, before: &mut Option<Modifiers>) -> bool {
    let is_double = response.double_clicked();
    if response.clicked() {
        let releases = ui.input(|input| {
            let clicks = input.events.iter().filter_map(|event| match event {
                Event::PointerButton {
                    button: PointerButton::Primary, pressed: false, modifiers, ..
                } => Some(*modifiers),
                _ => None,
            });
            clicks.collect::<Vec<_>>()
        });
        let clicks: Vec<Modifiers> = before.iter().copied().chain(releases).collect();
        *before = clicks.last().copied();
        return is_double && matches!(clicks.as_slice(), [.., first, second] if first == second);
    }
    is_double
}

/// The gesture that a drag begins which is not on anything that it could move.
pub(super) fn gesture_of(action: Option<MouseAction>, from: Pos2) -> Gesture {
    match action {
        Some(MouseAction::Orbit) => Gesture::Orbit,
        Some(MouseAction::Pan) => Gesture::Pan,
        Some(MouseAction::Zoom) => Gesture::Zoom,
        Some(MouseAction::Box) => Gesture::Box { from },
        Some(MouseAction::Lasso(_)) => Gesture::Lasso { points: vec![from], secondary: true },
        _ => Gesture::Ended,
    }
}

/// How far from an element a click on it may be, in points. Some browsers report a pen as a finger too.
pub(super) fn pick_radius(ui: &Ui, has_pen: bool) -> f32 {
    match has_pen {
        true => PEN_RADIUS_POINTS,
        false if is_finger(ui) => FINGER_RADIUS_POINTS,
        false => MOUSE_RADIUS_POINTS,
    }
}

/// Whether the pointer is a finger: while one is down, and in the frame in which it is lifted.
pub(super) fn is_finger(ui: &Ui) -> bool {
    ui.input(|input| {
        input.any_touches() || input.events.iter().any(|event| matches!(event, Event::Touch { .. }))
    })
}

/// The arrow keys orbit the view, with Shift they pan it, where no list or field has the focus.
pub(super) fn arrow_keys(ui: &Ui, view: &mut View) {
    if ui.memory(|memory| memory.focused().is_some_and(|id| id != widget_id())) {
        return;
    }
    let arrows = [
        (Key::ArrowLeft, vec2(1.0, 0.0)),
        (Key::ArrowRight, vec2(-1.0, 0.0)),
        (Key::ArrowUp, vec2(0.0, 1.0)),
        (Key::ArrowDown, vec2(0.0, -1.0)),
    ];
    let size = view.size();
    for (key, way) in arrows {
        let by = way * ARROW_KEY_PIXELS;
        let presses = |modifiers| ui.input_mut(|input| input.count_and_consume_key(modifiers, key));
        // Shift first: a key without modifiers also matches with Shift.
        (0..presses(Modifiers::SHIFT)).for_each(|_| view.camera.pan(by, size));
        (0..presses(Modifiers::NONE)).for_each(|_| view.turn(by));
    }
}
