//! The keys, in one table that menus, tooltips, the shortcuts window and the input handling read.

use crate::input::actions::Action;
use crate::lists::row_list;
use crate::theme;
use editor::{OpId, SelectBy};
use egui::{Context, Event, Key, KeyboardShortcut, Modifiers};
use halfedge::Element;
use std::sync::LazyLock;
use viewport::Side;

const ALT_SHIFT: Modifiers = Modifiers::ALT.plus(Modifiers::SHIFT);
const CTRL_SHIFT: Modifiers = Modifiers::COMMAND.plus(Modifiers::SHIFT);

const fn key(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::NONE, key)
}

const fn with(modifiers: Modifiers, key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(modifiers, key)
}

/// An action with the keys that start it; menus show the first.
pub type Binding = (Action, Vec<KeyboardShortcut>);

use Action as A;

/// The keys of the page's own actions; operations list their keys in their descriptions.
static PAGE_BINDINGS: &[(Action, &[KeyboardShortcut])] = &[
    // The browser keeps Ctrl+N.
    (A::New, &[with(Modifiers::COMMAND.plus(Modifiers::ALT), Key::N)]),
    (A::Open, &[with(Modifiers::COMMAND, Key::O)]),
    (A::Save, &[with(Modifiers::COMMAND, Key::S)]),
    (A::Redo, &[with(CTRL_SHIFT, Key::Z), with(Modifiers::COMMAND, Key::Y)]),
    (A::Undo, &[with(Modifiers::COMMAND, Key::Z)]),
    (A::SelectNone, &[with(CTRL_SHIFT, Key::A)]),
    (A::SelectAll, &[with(Modifiers::COMMAND, Key::A)]),
    (A::SelectInverse, &[with(Modifiers::COMMAND, Key::I)]),
    (
        A::SelectBy(SelectBy::Grow),
        &[with(Modifiers::COMMAND, Key::Equals), with(Modifiers::COMMAND, Key::Plus)],
    ),
    (A::SelectBy(SelectBy::Shrink), &[with(Modifiers::COMMAND, Key::Minus)]),
    (A::SelectBy(SelectBy::Linked), &[with(Modifiers::COMMAND, Key::L)]),
    (A::GoToId, &[with(Modifiers::COMMAND, Key::G)]),
    (A::Palette, &[with(Modifiers::COMMAND, Key::K), key(Key::F3)]),
    (A::Shortcuts, &[key(Key::Questionmark), key(Key::F1)]),
    (A::Cancel, &[key(Key::Escape)]),
    (A::Show(Element::Vertex), &[key(Key::Num1)]),
    (A::Show(Element::Edge), &[key(Key::Num2)]),
    (A::Show(Element::Halfedge), &[key(Key::Num3)]),
    (A::Show(Element::Face), &[key(Key::Num4)]),
    (A::Next, &[key(Key::N)]),
    (A::Twin, &[key(Key::T)]),
    (A::SelectTool, &[with(Modifiers::SHIFT, Key::Q)]),
    (A::BoxSelect, &[with(Modifiers::SHIFT, Key::B)]),
    (A::CircleSelect, &[with(Modifiers::SHIFT, Key::C)]),
    (A::XRay, &[with(Modifiers::ALT, Key::X)]),
    (A::Upsample, &[key(Key::U)]),
    (A::Downsample, &[key(Key::D)]),
    (A::Resample, &[key(Key::R)]),
    (A::LongerEdges, &[key(Key::Equals)]),
    (A::ShorterEdges, &[key(Key::Minus)]),
    (A::OnlySelected, &[key(Key::O)]),
    (A::FrameAll, &[with(Modifiers::SHIFT, Key::Period), key(Key::Home)]),
    (A::Frame, &[key(Key::Period)]),
    (A::ResetView, &[key(Key::Space)]),
    (A::LookFrom(Side::Front), &[with(Modifiers::ALT, Key::Num1)]),
    (A::LookFrom(Side::Back), &[with(ALT_SHIFT, Key::Num1)]),
    (A::LookFrom(Side::Right), &[with(Modifiers::ALT, Key::Num3)]),
    (A::LookFrom(Side::Left), &[with(ALT_SHIFT, Key::Num3)]),
    (A::LookFrom(Side::Top), &[with(Modifiers::ALT, Key::Num7)]),
    (A::LookFrom(Side::Bottom), &[with(ALT_SHIFT, Key::Num7)]),
    (A::Orthographic, &[key(Key::P), with(Modifiers::ALT, Key::Num5)]),
    (A::Wireframe, &[key(Key::W)]),
    (A::Smooth, &[key(Key::M)]),
    (A::Dots, &[key(Key::V)]),
    (A::Grid, &[with(Modifiers::SHIFT, Key::G)]),
    (A::SlideSplit, &[with(Modifiers::SHIFT, Key::S)]),
    (A::Move, &[key(Key::G)]),
    (A::Rotate, &[with(Modifiers::SHIFT, Key::R)]),
    (A::Scale, &[with(Modifiers::SHIFT, Key::D)]),
    (A::Soft, &[with(Modifiers::SHIFT, Key::O)]),
    (A::Snap, &[with(Modifiers::SHIFT, Key::Tab)]),
    (A::Overlay, &[key(Key::I)]),
    (A::LeftPanel, &[key(Key::OpenBracket)]),
    (A::RightPanel, &[key(Key::CloseBracket)]),
];

/// Keys with another meaning while a Bezier curve or surface is active.
static BEZIER_PAGE_BINDINGS: &[(Action, &[KeyboardShortcut])] = &[
    (A::NextLevel, &[key(Key::E)]),
    (A::WholeCurve, &[key(Key::C)]),
    (A::Play, &[key(Key::K)]),
    (A::DeletePoint, &[key(Key::Delete), key(Key::X)]),
];

/// Keys with another meaning while elements are selected with the circle.
static CIRCLE_PAGE_BINDINGS: &[(Action, &[KeyboardShortcut])] =
    &[(A::SmallerCircle, &[key(Key::OpenBracket)]), (A::LargerCircle, &[key(Key::CloseBracket)])];

/// All keys, except those with another meaning on a Bezier object.
pub static BINDINGS: LazyLock<Vec<Binding>> = LazyLock::new(|| {
    let page = PAGE_BINDINGS.iter().map(|(action, keys)| (*action, keys.to_vec()));
    let operations = OpId::ALL.iter().filter(|id| !id.spec().keys.is_empty());
    let operations = operations.map(|id| (A::Operation(*id), shortcuts(id.spec().keys)));
    page.chain(operations).collect()
});

/// Keys with another meaning while a Bezier curve or surface is active.
pub static BEZIER_BINDINGS: LazyLock<Vec<Binding>> =
    LazyLock::new(|| BEZIER_PAGE_BINDINGS.iter().map(|(action, keys)| (*action, keys.to_vec())).collect());

/// Keys with another meaning while elements are selected with the circle.
pub static CIRCLE_BINDINGS: LazyLock<Vec<Binding>> =
    LazyLock::new(|| CIRCLE_PAGE_BINDINGS.iter().map(|(action, keys)| (*action, keys.to_vec())).collect());

/// Parses keys as the descriptions of operations write them: "Shift+T".
fn shortcuts(keys: &[&str]) -> Vec<KeyboardShortcut> {
    let shortcut = |text: &&str| {
        let (modifiers, key) = text.rsplit_once('+').unwrap_or(("", text));
        let modifiers = modifiers.split('+').fold(Modifiers::NONE, |all, name| match name {
            "Shift" => all.plus(Modifiers::SHIFT),
            "Ctrl" => all.plus(Modifiers::COMMAND),
            "Alt" => all.plus(Modifiers::ALT),
            _ => all,
        });
        Some(KeyboardShortcut::new(modifiers, Key::from_name(key)?))
    };
    // A test checks that every key parses.
    keys.iter().filter_map(shortcut).collect()
}

/// Gestures of the mouse, the trackpad and fingers, for the shortcuts window.
pub static GESTURES: &[(&str, &str)] = &[
    ("Orbit the view", "Drag beside the mesh, middle-drag, Alt+drag, one finger, or the arrow keys"),
    ("Pan the view", "Right-drag, Shift+drag, two fingers, or Shift and the arrow keys"),
    ("Zoom", "Wheel, pinch, or Ctrl+wheel"),
    ("Select", "Click"),
    ("Extend the selection", "Shift+click"),
    ("Add or remove", "Ctrl+click"),
    ("Select a loop", "Double-click or Alt+click; with Shift, add it"),
    ("Select a ring", "Ctrl+Alt+click; with Shift, add it"),
    ("Add the shortest path", "Ctrl+Shift+click"),
    ("Select with a lasso", "Ctrl+right-drag; with Shift, add; with Alt, add or remove"),
    (
        "Select with a circle",
        "The circle tool: drag; with Ctrl or the middle button, remove; wheel for the size",
    ),
    ("Select with a box", "The box tool: drag; with Shift, add; with Ctrl, add or remove"),
    ("Add or remove with a box", "Ctrl+drag"),
    ("Move the selection", "Drag a selected element, or a handle of the gizmo"),
    ("Move a control point", "Drag it, on a Bezier curve or surface"),
    ("Add a control point", "Double-click, on a Bezier curve"),
];

/// The keys of an action; an operation has its family's keys.
pub fn of(action: Action) -> Vec<KeyboardShortcut> {
    if let A::Operation(id) = action {
        return shortcuts(id.keys());
    }
    let mut all = BINDINGS.iter().chain(BEZIER_BINDINGS.iter()).chain(CIRCLE_BINDINGS.iter());
    all.find(|(bound, _)| *bound == action).map_or_else(Vec::new, |(_, keys)| keys.clone())
}

/// The first key of an action as the platform writes it; empty if there is none, and on a touch screen.
pub fn text(ctx: &Context, action: Action) -> String {
    if theme::is_for_touch(ctx) {
        return String::new();
    }
    of(action).first().map(|shortcut| written(ctx, shortcut)).unwrap_or_default()
}

/// A key as the platform writes it: "Ctrl+Z", "?".
pub fn written(ctx: &Context, shortcut: &KeyboardShortcut) -> String {
    let plain = matches!(
        shortcut.logical_key,
        Key::Questionmark
            | Key::Slash
            | Key::Period
            | Key::OpenBracket
            | Key::CloseBracket
            | Key::Equals
            | Key::Minus
    );
    let key = shortcut.logical_key;
    let text = ctx.format_shortcut(shortcut);
    match text.strip_suffix(key.name()) {
        Some(modifiers) if plain => format!("{modifiers}{}", key.symbol_or_name()),
        _ => text,
    }
}

/// A sentence followed by its key: "Undo the last change. (Ctrl+Z)".
pub fn tooltip(ctx: &Context, description: &str, action: Action) -> String {
    let key = text(ctx, action);
    if key.is_empty() { description.to_owned() } else { format!("{description} ({key})") }
}

/// The actions whose keys were pressed this frame, in order and as often as they were pressed; consumes the
/// keys. The events after a key that opens a text field belong to that field: they are removed and returned, for
/// the next frame. While the user types, only keys with Ctrl or Command that a text field doesn't use count, and Escape
/// goes to the field. While a menu is open, Escape goes to the menu. The tables in `first` come before the others.
pub fn pressed(ctx: &Context, menu: bool, first: &[&[Binding]]) -> (Vec<Action>, Vec<Event>) {
    let typing = ctx.text_edit_focused();
    // A focused button uses Space, and a focused list uses Home.
    let focused = ctx.memory(|memory| memory.focused());
    let on_list = focused.is_some() && focused == row_list::focused(ctx);
    let is_theirs = |key: Key| match key {
        Key::Space => focused.is_some() && !on_list,
        Key::Home => focused.is_some(),
        Key::Escape => menu,
        _ => false,
    };
    let action_of = |key: Key, modifiers: Modifiers| {
        let mut bindings = first.iter().copied().flatten().chain(BINDINGS.iter());
        bindings.find_map(|(action, keys)| {
            let hit = (!typing || works_while_typing(*action))
                && keys.iter().any(|k| k.logical_key == key && !is_theirs(key) && matches(modifiers, k));
            hit.then_some(*action)
        })
    };
    let (mut actions, mut later) = (Vec::new(), Vec::new());
    ctx.input_mut(|input| {
        input.events.retain(|event| {
            if actions.last().copied().is_some_and(opens_text_field) {
                let is_typed = matches!(event, Event::Key { .. } | Event::Text(_) | Event::Ime(_));
                later.extend(is_typed.then(|| event.clone()));
                return !is_typed;
            }
            let Event::Key { key, modifiers, pressed: true, .. } = event else { return true };
            let action = action_of(*key, *modifiers);
            actions.extend(action);
            action.is_none()
        });
    });
    (actions, later)
}

fn opens_text_field(action: Action) -> bool {
    matches!(action, A::Palette | A::GoToId | A::Save | A::SaveAs(_))
}

fn works_while_typing(action: Action) -> bool {
    matches!(action, A::Open | A::Save | A::Palette)
}

/// Whether a shortcut has the pressed modifiers. Unlike egui's own function, a plain letter doesn't also match
/// with Ctrl or Alt, and "?" matches with the Shift that typing it takes.
fn matches(pressed: Modifiers, shortcut: &KeyboardShortcut) -> bool {
    let wanted = shortcut.modifiers;
    let typed_with_shift = matches!(shortcut.logical_key, Key::Questionmark);
    pressed.command == wanted.command
        && pressed.alt == wanted.alt
        && (typed_with_shift || pressed.shift == wanted.shift)
        && (wanted.command || !pressed.ctrl)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::actions;

    #[test]
    fn no_key_is_bound_twice() {
        for table in [&*BINDINGS, &*BEZIER_BINDINGS, &*CIRCLE_BINDINGS] {
            let mut seen = Vec::new();
            for (action, keys) in table {
                for key in keys {
                    assert!(!seen.contains(key), "{key:?} is bound to {action:?} and to another");
                    seen.push(*key);
                }
            }
        }
    }

    #[test]
    fn keys_are_written_with_their_modifiers() {
        let ctx = Context::default();
        assert_eq!(text(&ctx, A::SelectBy(SelectBy::Grow)), "Ctrl+=");
        assert_eq!(text(&ctx, A::SelectBy(SelectBy::Shrink)), "Ctrl+−");
        assert_eq!(text(&ctx, A::LongerEdges), "=");
        let mut seen = std::collections::HashMap::new();
        for (action, keys) in BINDINGS.iter() {
            for key in keys {
                let text = written(&ctx, key);
                assert_eq!(text.contains("Ctrl+"), key.modifiers.command, "{text}");
                assert_eq!(text.contains("Alt+"), key.modifiers.alt, "{text}");
                assert_eq!(text.contains("Shift+"), key.modifiers.shift, "{text}");
                if let Some(other) = seen.insert(text.clone(), action) {
                    panic!("{action:?} and {other:?} are both written {text}");
                }
            }
        }
    }

    #[test]
    fn every_bound_action_is_in_a_menu() {
        for (action, _) in BINDINGS.iter().chain(BEZIER_BINDINGS.iter()).chain(CIRCLE_BINDINGS.iter()) {
            assert!(actions::all().any(|entry| entry.action == *action), "{action:?}");
        }
    }

    #[test]
    fn every_key_of_an_operation_parses() {
        let ctx = Context::default();
        for id in OpId::ALL {
            assert_eq!(shortcuts(id.spec().keys).len(), id.spec().keys.len(), "{:?}", id.spec().keys);
            for (text, shortcut) in id.spec().keys.iter().zip(shortcuts(id.spec().keys)) {
                assert_eq!(*text, written(&ctx, &shortcut));
            }
        }
    }
}
