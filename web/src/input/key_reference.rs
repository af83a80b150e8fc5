//! `docs/keys.md`: the keys and gestures of all presets, from the tables.

use std::fmt::Write;

use super::actions::{self, Action};
use super::camera_style::CameraStyle;
use super::key_map::{KeyMap, When};
use super::key_preset::KeyPreset;
use super::menus;
use super::mouse;

const HEAD: &str = "\
# Keys

<!-- Made from the tables in web/src/input; `MESHWRIGHT_UPDATE=1 cargo test -p meshwright-web --lib key_reference` \
rewrites it. -->

There are three presets of keys: Course (the default), Blender and Maya. Edit > Keys chooses one and keeps it for later \
visits; `?keys=blender` in the page's address chooses one for this visit. Help > Keyboard shortcuts changes the keys of \
the chosen preset. Ctrl is Command on a Mac, and Alt is Option.

While an edit follows the pointer, digits type its amount (arithmetic and units too), X, Y and Z lock an axis (with Shift a plane), Tab goes to the \
next number, Enter applies and Escape cancels, in all presets. The key of Move, pressed again during a move, slides the \
selection along its neighbours (G G). A key of Snap to grid, steps, vertices, edges or faces snaps while it is held, as X, V \
and C do in Maya.

While flying (View > Zoom and fly), W, A, S, D or the arrow keys move the eye, E and Q move it up and down, Shift makes it faster, \
the wheel sets the speed, and the pointer turns it. Enter or a click stays there; Escape or a right-click goes back.

Ctrl+R, Ctrl+B, Ctrl+D, Ctrl+H, Ctrl+E and Ctrl+F are the browser's own while a list, a field or a button has \
the focus.
";

const CAMERA_NOTES: &str = "
Each preset moves the camera as its program does; View > Camera style chooses another style, and keeps it for later \
visits. A style's gestures come before those of the preset; where it leaves the first button free, a drag selects in a \
box. The CAD style turns about the point under the pointer, the others about the middle of the view; the same menu \
changes that. `scroll` is two fingers on a trackpad; a wheel zooms in every style.
";

/// The groups of actions: menus, and what is special to Bezier curves and the circle.
pub fn groups() -> Vec<(&'static str, Vec<Action>)> {
    let mut groups: Vec<(&'static str, Vec<Action>)> = Vec::new();
    let mut listed: Vec<Action> = Vec::new();
    for menu in menus::MENUS {
        let mut actions: Vec<Action> = menu.entries.iter().flatten().map(|entry| entry.action).collect();
        match menu.id {
            menus::MenuId::Select => {
                actions.extend(actions::criteria().chain(actions::hiding()).map(Action::Operation))
            }
            menus::MenuId::Mesh => actions.extend(actions::mesh_operations().map(Action::Operation)),
            menus::MenuId::File => actions.extend(actions::formats().map(|entry| entry.action)),
            _ => {}
        }
        actions.retain(|action| !listed.contains(action) && !is_apart(*action));
        listed.extend(&actions);
        let title = match menu.id {
            menus::MenuId::Bezier => "On a Bezier curve or surface",
            id => id.title(),
        };
        groups.push((title, actions));
    }
    for (title, when) in APART {
        let all = actions::all().map(|entry| entry.action);
        groups.push((title, all.filter(|action| When::of(*action) == when).collect()));
    }
    groups
}

/// The groups of keys that mean something only at times.
const APART: [(&str, When); 2] = [
    ("With the selecting circle", When::Circle),
    ("In the Study layout, with a half-edge selected", When::Halfedge),
];

fn is_apart(action: Action) -> bool {
    APART.iter().any(|(_, when)| When::of(action) == *when)
}

/// The document.
pub fn reference() -> String {
    let mut text = HEAD.to_owned();
    let maps = KeyPreset::ALL.map(KeyMap::new);
    let heads = KeyPreset::ALL.map(KeyPreset::label);
    for (title, actions) in groups() {
        let keys = |action: &Action| {
            maps.each_ref().map(|map| {
                let keys = map.own_keys(*action).iter().map(|key| code(&key.text()));
                keys.collect::<Vec<_>>().join(" ")
            })
        };
        let rows = actions.iter().map(|action| (actions::describe(*action).label, keys(action)));
        table(&mut text, title, heads, rows.filter(|(_, keys)| keys.iter().any(|keys| !keys.is_empty())));
    }
    table(
        &mut text,
        "Mouse",
        heads,
        mouse::described().map(|(name, cells)| (name, cells.map(str::to_owned))),
    );
    table(
        &mut text,
        "Camera",
        CameraStyle::ALL.map(CameraStyle::label),
        mouse::camera_described().map(|(name, cells)| (name, cells.map(str::to_owned))),
    );
    text += CAMERA_NOTES;
    text += "\nA drag that begins on a selected element, a control point or a handle of the gizmo moves it. In all presets:\n\n";
    for (what, how) in mouse::SHARED_GESTURES {
        // Writing to a string can't fail.
        let _ = writeln!(text, "- {what}: {how}");
    }
    text
}

/// A key as code. One that is a backtick takes two around it.
fn code(key: &str) -> String {
    if key.contains('`') { format!("`` {key} ``") } else { format!("`{key}`") }
}

fn table<'a, const COLUMNS: usize>(
    text: &mut String,
    title: &str,
    heads: [&str; COLUMNS],
    rows: impl Iterator<Item = (&'a str, [String; COLUMNS])>,
) {
    let mut rows = rows.peekable();
    if rows.peek().is_none() {
        return;
    }
    let _ =
        writeln!(text, "\n## {title}\n\n| Action | {} |\n|{}", heads.join(" | "), "---|".repeat(COLUMNS + 1));
    for (label, cells) in rows {
        let _ = writeln!(text, "| {label} | {} |", cells.join(" | "));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares `docs/keys.md` with what it should hold; with `MESHWRIGHT_UPDATE=1` writes it.
    #[cfg(not(target_arch = "wasm32"))]
    #[test]
    fn the_reference_of_the_keys_is_up_to_date() {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/keys.md");
        if std::env::var_os("MESHWRIGHT_UPDATE").is_some() {
            std::fs::write(&path, reference()).expect("a folder to write to");
        }
        let held = std::fs::read_to_string(&path).unwrap_or_default().replace("\r\n", "\n");
        assert!(
            held == reference(),
            "docs/keys.md is out of date; run `MESHWRIGHT_UPDATE=1 cargo test -p meshwright-web --lib key_reference`"
        );
    }

    #[test]
    fn every_action_is_in_one_group() {
        let mut listed: Vec<Action> = groups().into_iter().flat_map(|(_, actions)| actions).collect();
        for entry in actions::all() {
            let count = listed.iter().filter(|action| **action == entry.action).count();
            assert_eq!(count, 1, "{:?}", entry.action);
        }
        listed.retain(|action| actions::all().all(|entry| entry.action != *action));
        assert!(listed.is_empty(), "{listed:?}");
    }
}
