//! What the buttons of the mouse, fingers and modifiers do now, for the status line.

use std::borrow::Cow;

use editor::SelectMode;
use egui::{Modifiers, PointerButton};
use halfedge::Element;
use halfedge::words::capitalized;
use surface::selecting::Line;

use crate::input::keys;
use crate::input::mouse::MouseAction;
use crate::page_view::Page;
use crate::session::live::keeps_cut;
use crate::view::{Gesture, Tool};
use crate::widgets::icons::Icon;

/// How something is done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum By {
    /// With a button of the mouse: its icon and its name.
    Mouse(Icon, &'static str),
    /// With a key, or while it is held.
    Key(&'static str),
    /// With fingers, or by moving the pointer.
    Touch(&'static str),
}

impl By {
    /// The words for it.
    pub fn words(self) -> &'static str {
        match self {
            Self::Mouse(_, words) | Self::Key(words) | Self::Touch(words) => words,
        }
    }
}

/// What something does now.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Hint {
    pub by: By,
    pub does: Cow<'static, str>,
}

const LEFT: By = By::Mouse(Icon::MouseLeft, "Left button");
const MIDDLE: By = By::Mouse(Icon::MouseMiddle, "Middle button");
const RIGHT: By = By::Mouse(Icon::MouseRight, "Right button");
const WHEEL: By = By::Mouse(Icon::MouseMiddle, "Wheel");
const SHIFT: By = By::Key("Shift");
const CTRL: By = By::Key("Ctrl");
const ALT: By = By::Key("Alt");
const ESCAPE: By = By::Key("Esc");

fn hint(by: By, does: impl Into<Cow<'static, str>>) -> Hint {
    Hint { by, does: does.into() }
}

/// What can be done now, the most important first. `modifiers` are those that are held.
pub(crate) fn hints(page: &Page<'_>, modifiers: Modifiers) -> Vec<Hint> {
    if page.shown.touch {
        return by_touch(page);
    }
    let mouse = keys::map(&page.ctx).mouse();
    let within = |by| {
        let held = if by == SHIFT { Modifiers::SHIFT } else { Modifiers::COMMAND };
        hint(by, mode_words(mouse.mode_within(held)))
    };
    if let Some(live) = &page.live {
        let [snap_keys, snaps_to] = keys::snap_keys(&page.ctx);
        let snap = (live.is_move() && !snap_keys.is_empty())
            .then(|| hint(By::Key("Hold"), format!("{snap_keys}: snap to {snaps_to}")));
        let locks = live.takes_lock() && snap.is_none();
        let lock = locks.then(|| hint(By::Key("X Y Z"), "Lock to an axis"));
        let ends = if keeps_cut(page) { "Cut in the middle" } else { "Cancel" };
        let wheel = live.wheel_words(&page.live_settings).map(|words| hint(WHEEL, words));
        let all = [hint(LEFT, "Apply"), hint(RIGHT, ends), hint(By::Key("0-9"), "Type the amount")];
        let more = [hint(CTRL, "Snap"), hint(SHIFT, "Fine"), hint(ESCAPE, ends)];
        return all.into_iter().chain(wheel).chain(lock).chain(snap).chain(more).collect();
    }
    if let Some(flight) = &page.view.flight {
        return vec![
            hint(By::Key("W A S D"), "Fly"),
            hint(By::Key("Q E"), "Down, up"),
            hint(By::Touch("Pointer"), "Look around"),
            hint(WHEEL, format!("Speed {:.0} %", flight.speed_percent())),
            hint(SHIFT, "Faster"),
            hint(LEFT, "Stay here"),
            hint(ESCAPE, "Go back"),
        ];
    }
    match page.view.gesture {
        Gesture::Box { .. } | Gesture::Lasso { .. } => {
            vec![hint(LEFT, "Release to select"), within(SHIFT), within(CTRL), hint(ESCAPE, "Cancel")]
        }
        Gesture::SoftRadius => vec![hint(LEFT, "Release to keep the radius")],
        Gesture::Live { .. } | Gesture::Slide | Gesture::Control { .. } => {
            vec![hint(LEFT, "Release to place"), hint(ESCAPE, "Cancel")]
        }
        Gesture::Paint { .. } => vec![hint(LEFT, "Release to end"), hint(ESCAPE, "Cancel")],
        Gesture::None | Gesture::Orbit | Gesture::Pan | Gesture::Zoom | Gesture::Ended => {
            by_mouse(page, modifiers)
        }
    }
}

/// The hints while no button is down.
fn by_mouse(page: &Page<'_>, modifiers: Modifiers) -> Vec<Hint> {
    let mouse = keys::map(&page.ctx).mouse();
    let mode = |held| mode_words(mouse.mode_within(held));
    let drag = |button, held| drag_words(mouse.drag(button, held));
    let draws = |what| {
        let held = Modifiers::NONE;
        let others = [
            (MIDDLE, joined([drag(PointerButton::Middle, held), None])),
            (RIGHT, joined([Some("menu"), drag(PointerButton::Secondary, held)])),
            (SHIFT, Some(mode(Modifiers::SHIFT).to_owned())),
            (CTRL, Some(mode(Modifiers::COMMAND).to_owned())),
            (ESCAPE, Some("End the tool".to_owned())),
        ];
        std::iter::once(hint(LEFT, what)).chain(hints_of(others)).collect()
    };
    match page.view.tool {
        Tool::Orbit => {}
        Tool::Box => return draws("Drag a box to select"),
        Tool::LoopCut => {
            return vec![
                hint(LEFT, "Cut, then slide"),
                hint(MIDDLE, "Wheel or digits: number of cuts"),
                hint(RIGHT, "End the tool"),
                hint(ESCAPE, "End the tool"),
            ];
        }
        Tool::Lasso => return draws("Draw around elements"),
        Tool::Circle => {
            return vec![
                hint(LEFT, "Drag to add"),
                hint(MIDDLE, "Drag to remove, wheel for the size"),
                hint(RIGHT, "End the tool"),
                hint(CTRL, "Remove"),
                hint(By::Key("[ ]"), "Size"),
            ];
        }
    }
    let buttons = |left, [middle, right]: [Option<&str>; 2]| {
        let drag = |button| drag(button, modifiers);
        let all = [
            (LEFT, left),
            (MIDDLE, joined([drag(PointerButton::Middle), middle])),
            (RIGHT, joined([right, drag(PointerButton::Secondary)])),
        ];
        hints_of(all).collect::<Vec<_>>()
    };
    let dragged = |click: Option<&str>| joined([click, drag(PointerButton::Primary, modifiers)]);
    let what = page.shown.kind;
    if modifiers.command || modifiers.shift || modifiers.alt {
        let click = mouse.click(modifiers).map(|action| click_words(action, what));
        let places = mouse.right_click(modifiers).map(|_| "place the 3D cursor");
        return buttons(dragged(click.as_deref()), [None, places]);
    }
    if page.player.hovered.is_some() {
        return vec![hint(LEFT, "Choose or drag this control point")];
    }
    let selection = page.editor.selection();
    let left = match page.view.hovered {
        Some((kind, id)) if selection.contains(kind, id) => {
            Some(format!("Select only this {kind}, drag to move"))
        }
        Some((kind, _)) => dragged(Some(&format!("select this {kind}"))),
        None => dragged((!selection.is_empty()).then_some("deselect")),
    };
    let mut hints = buttons(left, [Some("wheel to zoom"), Some("menu")]);
    if mouse.scroll(Modifiers::NONE) == Some(MouseAction::Orbit) {
        hints.push(hint(By::Touch("Two fingers"), "Orbit, with Shift pan, with Ctrl zoom"));
    }
    for (by, held) in [(SHIFT, Modifiers::SHIFT), (CTRL, Modifiers::COMMAND), (ALT, Modifiers::ALT)] {
        let words = match mouse.click(held) {
            Some(MouseAction::Select(mode)) => Some(mode_words(mode)),
            Some(MouseAction::Line(..)) => Some("Loop"),
            Some(MouseAction::Path) => Some("Path"),
            _ => mouse.drag(PointerButton::Primary, held).map(|_| "Move the view"),
        };
        hints.extend(words.map(|words| hint(by, words)));
    }
    hints
}

/// What a click and a drag of one button do, as one text; none if they do nothing.
fn joined(parts: [Option<&str>; 2]) -> Option<String> {
    let text = parts.into_iter().flatten().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(", ");
    (!text.is_empty()).then(|| capitalized(&text))
}

/// The hints of those that do something.
fn hints_of<const N: usize>(all: [(By, Option<String>); N]) -> impl Iterator<Item = Hint> {
    all.into_iter().filter_map(|(by, does)| Some(hint(by, does?)))
}

/// How a box or a click changes the selection.
fn mode_words(mode: SelectMode) -> &'static str {
    match mode {
        SelectMode::Replace => "Select",
        SelectMode::Extend => "Add",
        SelectMode::Toggle => "Add or remove",
        SelectMode::Remove => "Remove",
        SelectMode::Intersect => "Keep only these",
    }
}

/// What a click on an element does.
fn click_words(action: MouseAction, what: Element) -> String {
    match action {
        MouseAction::Select(mode) => format!("{} this {what}", mode_words(mode).to_lowercase()),
        MouseAction::Path => format!("add the path to this {what}"),
        MouseAction::Line(Line::Loop, SelectMode::Extend) => "add a loop".to_owned(),
        MouseAction::Line(Line::Loop, _) => "select a loop".to_owned(),
        MouseAction::Line(Line::Ring, SelectMode::Extend) => "add a ring".to_owned(),
        MouseAction::Line(Line::Ring, _) => "select a ring".to_owned(),
        _ => String::new(),
    }
}

/// What a drag does.
fn drag_words(action: Option<MouseAction>) -> Option<&'static str> {
    Some(match action? {
        MouseAction::Orbit => "drag to orbit",
        MouseAction::Pan => "drag to pan",
        MouseAction::Zoom => "drag to zoom",
        MouseAction::Box => "drag a box",
        MouseAction::Lasso(_) => "draw a lasso",
        MouseAction::Slide => "drag to slide",
        MouseAction::Paint => "drag to paint a selection",
        _ => return None,
    })
}

/// The hints for fingers.
fn by_touch(page: &Page<'_>) -> Vec<Hint> {
    if page.live.is_some() {
        return vec![hint(By::Touch("Drag"), "Set the amount"), hint(By::Touch("Two fingers"), "Pan, zoom")];
    }
    let tap = match page.view.tool {
        Tool::LoopCut => "Cut a ring",
        _ if page.shown.adds => "Add or remove",
        _ => "Select",
    };
    let drag = match page.view.tool {
        Tool::Orbit => "Orbit",
        Tool::LoopCut => "Cut and slide",
        Tool::Box => "Select in a box",
        Tool::Lasso => "Draw around",
        Tool::Circle => "Paint over",
    };
    vec![
        hint(By::Touch("Tap"), tap),
        hint(By::Touch("Drag"), drag),
        hint(By::Touch("Two fingers"), "Pan, zoom"),
        hint(By::Touch("Hold"), "Menu"),
    ]
}
