//! What the buttons of the mouse, fingers and modifiers do now, for the status line.

use std::borrow::Cow;

use egui::Modifiers;

use crate::page_view::Page;
use crate::view::{Gesture, Tool};
use crate::widgets::icons::Icon;

/// How something is done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum By {
    /// With a button of the mouse: its icon and its name.
    Mouse(Icon, &'static str),
    /// With a key, or while it is held.
    Key(&'static str),
    /// With fingers.
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
    if let Some(live) = &page.live {
        let lock = live.takes_lock().then(|| hint(By::Key("X Y Z"), "Lock to an axis"));
        let all = [hint(LEFT, "Apply"), hint(RIGHT, "Cancel"), hint(By::Key("0-9"), "Type the amount")];
        let more = [hint(CTRL, "Snap"), hint(SHIFT, "Fine"), hint(ESCAPE, "Cancel")];
        return all.into_iter().chain(lock).chain(more).collect();
    }
    match page.view.gesture {
        Gesture::Box { .. } | Gesture::Lasso { .. } => vec![
            hint(LEFT, "Release to select"),
            hint(SHIFT, "Add"),
            hint(CTRL, "Add or remove"),
            hint(ESCAPE, "Cancel"),
        ],
        Gesture::Live { .. } | Gesture::Control { .. } => {
            vec![hint(LEFT, "Release to place"), hint(ESCAPE, "Cancel")]
        }
        Gesture::Paint { .. } => vec![hint(LEFT, "Release to end"), hint(ESCAPE, "Cancel")],
        Gesture::None | Gesture::Orbit | Gesture::Pan | Gesture::Ended => by_mouse(page, modifiers),
    }
}

/// The hints while no button is down.
fn by_mouse(page: &Page<'_>, modifiers: Modifiers) -> Vec<Hint> {
    let what = page.shown.kind;
    let draws = |what| {
        vec![
            hint(LEFT, what),
            hint(MIDDLE, "Orbit"),
            hint(RIGHT, "Menu, drag to pan"),
            hint(SHIFT, "Add"),
            hint(CTRL, "Add or remove"),
            hint(ESCAPE, "End the tool"),
        ]
    };
    match page.view.tool {
        Tool::Orbit => {}
        Tool::Box => return draws("Drag a box to select"),
        Tool::Lasso => return draws("Draw around what to select"),
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
    match (modifiers.command, modifiers.shift, modifiers.alt) {
        (true, true, _) => return vec![hint(LEFT, format!("Add the path to this {what}"))],
        (true, _, true) => return vec![hint(LEFT, "Select a ring")],
        (true, ..) => return vec![hint(LEFT, format!("Add or remove this {what}, drag a box"))],
        (_, _, true) => {
            return vec![hint(LEFT, "Select a loop, drag to orbit"), hint(SHIFT, "Add the loop")];
        }
        (_, true, _) => return vec![hint(LEFT, format!("Add this {what}, drag to pan"))],
        _ => {}
    }
    let selection = page.editor.selection();
    let left = if page.player.hovered.is_some() {
        Cow::Borrowed("Choose or drag this control point")
    } else {
        match page.view.hovered {
            Some((kind, id)) if selection.contains(kind, id) => {
                format!("Select only this {kind}, drag to move").into()
            }
            Some((kind, _)) => format!("Select this {kind}, drag to orbit").into(),
            None if selection.is_empty() => Cow::Borrowed("Drag to orbit"),
            None => Cow::Borrowed("Deselect, drag to orbit"),
        }
    };
    vec![
        hint(LEFT, left),
        hint(MIDDLE, "Orbit, wheel to zoom"),
        hint(RIGHT, "Menu, drag to pan"),
        hint(SHIFT, "Add"),
        hint(CTRL, "Add or remove"),
        hint(ALT, "Loop"),
    ]
}

/// The hints for fingers.
fn by_touch(page: &Page<'_>) -> Vec<Hint> {
    if page.live.is_some() {
        return vec![hint(By::Touch("Drag"), "Set the amount"), hint(By::Touch("Two fingers"), "Pan, zoom")];
    }
    let tap = if page.shown.adds { "Add or remove" } else { "Select" };
    let drag = match page.view.tool {
        Tool::Orbit => "Orbit",
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
