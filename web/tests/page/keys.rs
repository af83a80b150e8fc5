//! The presets of keys, and the window that changes keys.

use crate::page::{DESKTOP, PHONE, Page};
use crate::regions::drag_along;
use crate::selecting::double_click_at;
use crate::viewport::click_at;
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Theme, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use halfedge::{Element, VertexId};
use meshwright_web::input::shortcut::{NUMBER_PAD, Shortcut};
use serde_json::{Value, json};

pub fn shortcut(text: &str) -> Shortcut {
    Shortcut::parse(text).unwrap_or_else(|| panic!("{text} is no key"))
}

/// Presses a key such as `Ctrl+Numpad1`.
fn press(page: &mut Page, text: &str) {
    strike(page, shortcut(text), "");
    page.run();
}

/// Presses a key that types its character too, as a keyboard's does; draws no frame.
pub fn strike_typing(page: &mut Page, shortcut: Shortcut) {
    let Shortcut { ctrl, alt, shift, key, .. } = shortcut;
    let symbol = match key {
        Key::Space => " ",
        Key::Minus => "-",
        key => key.symbol_or_name(),
    };
    let is_typed = !ctrl && !alt && symbol.len() == 1;
    let text = if shift { symbol.to_uppercase() } else { symbol.to_lowercase() };
    strike(page, shortcut, if is_typed { &text } else { "" });
}

/// Presses a key and lets it go; `text` is what it types.
fn strike(page: &mut Page, Shortcut { ctrl, alt, shift, pad, key }: Shortcut, text: &str) {
    let modifiers = Modifiers { alt, ctrl, shift, mac_cmd: false, command: ctrl };
    let physical_key = pad.then_some(NUMBER_PAD);
    let event = |pressed| Event::Key { key, physical_key, pressed, repeat: false, modifiers };
    page.harness.event_modifiers(event(true), modifiers);
    if !text.is_empty() {
        page.harness.event_modifiers(Event::Text(text.to_owned()), modifiers);
    }
    page.harness.event_modifiers(event(false), modifiers);
}

fn with_keys(preset: &str) -> Page {
    Page::with_setting(DESKTOP, "keys", preset)
}

fn view(page: &mut Page, name: &str) -> Value {
    page.app().script().state()["view"][name].clone()
}

fn number(page: &mut Page, name: &str) -> f64 {
    view(page, name).as_f64().expect("a number")
}

/// Whether a switch or a tool is on.
fn is_on(page: &Page, label: &str) -> bool {
    let node = page.find(label);
    let node = node.accesskit_node();
    node.is_selected() == Some(true) || node.toggled() == Some(egui::accesskit::Toggled::True)
}

#[test]
fn modes_have_the_keys_of_each_preset() {
    for (preset, keys) in [
        ("course", ["2", "3", "4", "1"]),
        ("blender", ["2", "4", "3", "1"]),
        ("maya", ["F10", "Alt+F10", "F11", "F9"]),
    ] {
        let mut page = with_keys(preset);
        assert_eq!(view(&mut page, "keys"), preset);
        for (key, list) in keys.into_iter().zip(["edge", "half-edge", "face", "vertex"]) {
            press(&mut page, key);
            assert_eq!(view(&mut page, "list"), list, "{preset}: {key}");
        }
    }
}

#[test]
fn keys_of_blender_do_what_they_do_there() {
    let mut page = with_keys("blender");
    press(&mut page, "A");
    assert_eq!(page.selected().1.len(), 8);
    press(&mut page, "Alt+A");
    assert!(page.selected().1.is_empty());

    // S Y .75 scales along y.
    page.select("face", &[0, 1, 2, 3, 4, 5]);
    press(&mut page, "S");
    press(&mut page, "Y");
    page.type_text(".75");
    press(&mut page, "Enter");
    let tallest = page.mesh().positions().iter().map(|p| p.y).fold(0.0, f32::max);
    assert!((tallest - 0.75).abs() < 1e-5, "{tallest}");
    press(&mut page, "Ctrl+Z");

    page.select("face", &[0]);
    press(&mut page, "E");
    page.type_text("1");
    press(&mut page, "Enter");
    assert_eq!(page.mesh().face_count(), 10);
    press(&mut page, "Ctrl+Z");
    press(&mut page, "I");
    page.type_text(".1");
    press(&mut page, "Enter");
    assert_eq!(page.mesh().face_count(), 10);
    press(&mut page, "Ctrl+Z");

    press(&mut page, "Ctrl+R");
    assert!(page.has_part("Cut, then slide"), "the loop cut at the pointer");
    press(&mut page, "Escape");
    page.select("edge", &[0]);
    press(&mut page, "Ctrl+B");
    page.type_text(".1");
    press(&mut page, "Enter");
    assert_eq!(page.undo_labels().last().map(String::as_str), Some("Bevel edges"));
    press(&mut page, "Ctrl+Z");
    // Dissolving suits what is selected.
    page.select("edge", &[0]);
    press(&mut page, "Ctrl+X");
    assert_eq!(page.mesh().face_count(), 5);
    press(&mut page, "Ctrl+Z");
    page.select("vertex", &[0]);
    press(&mut page, "Ctrl+X");
    assert_eq!((page.mesh().vertex_count(), page.mesh().face_count()), (7, 4));
    press(&mut page, "Ctrl+Z");

    press(&mut page, "U");
    press(&mut page, "D");
    assert_eq!(page.mesh().face_count(), 6, "keys of the courses do nothing");
    assert!(page.has("Go to id"));
    press(&mut page, "T");
    assert!(!page.has("Go to id"), "T puts the lists away");
    press(&mut page, "Space");
    assert!(page.has("Find a command"));
}

#[test]
fn the_number_pad_looks_from_the_sides() {
    let mut page = with_keys("blender");
    let quarter = std::f64::consts::FRAC_PI_2;
    press(&mut page, "Numpad3");
    assert_eq!((number(&mut page, "yaw"), number(&mut page, "pitch")), (quarter, 0.0));
    assert_eq!(view(&mut page, "list"), "vertex", "the digit above the letters is another key");
    press(&mut page, "Ctrl+Numpad1");
    assert_eq!(number(&mut page, "yaw"), 2.0 * quarter);
    press(&mut page, "Numpad5");
    assert_eq!(view(&mut page, "orthographic"), true);
    press(&mut page, "Numpad2");
    assert_eq!(view(&mut page, "list"), "vertex");
    page.select("vertex", &[0]);
    let before = number(&mut page, "distance");
    press(&mut page, "Numpad.");
    assert_ne!(number(&mut page, "distance"), before, "the selection is framed");
    press(&mut page, "Ctrl+Numpad+");
    assert_eq!(page.selected().1.len(), 7, "the selection grew by the faces around the vertex");
}

#[test]
fn a_number_that_is_typed_during_an_edit_moves_no_view() {
    for (preset, digit, point) in [("blender", "Numpad1", "Numpad."), ("course", "1", ".")] {
        let mut page = with_keys(preset);
        page.select("vertex", &[0]);
        press(&mut page, "G");
        press(&mut page, "X");
        let before = (number(&mut page, "yaw"), number(&mut page, "distance"));
        for (key, text) in [(digit, "1"), (point, "."), (digit, "1")] {
            press(&mut page, key);
            page.type_text(text);
        }
        assert_eq!((number(&mut page, "yaw"), number(&mut page, "distance")), before);
        let from = page.mesh().position(VertexId::new(0)).x;
        press(&mut page, "Enter");
        press(&mut page, "Ctrl+Z");
        let moved = from - page.mesh().position(VertexId::new(0)).x;
        assert!((moved - 1.1).abs() < 1e-5, "{preset}: {moved}");
    }
}

#[test]
fn keys_of_maya_do_what_they_do_there() {
    let mut page = with_keys("maya");
    page.select("face", &[0]);
    for (key, tool) in
        [("W", "Tool: Move"), ("E", "Tool: Rotate"), ("R", "Tool: Scale"), ("Q", "Tool: Select")]
    {
        press(&mut page, key);
        assert!(is_on(&page, tool), "{key}");
    }
    press(&mut page, "Ctrl+E");
    page.type_text("1");
    press(&mut page, "Enter");
    assert_eq!(page.mesh().face_count(), 10);
    press(&mut page, "Z");
    assert_eq!(page.mesh().face_count(), 6);
    page.select("face", &[0]);
    press(&mut page, "Shift+.");
    assert_eq!(page.selected().1.len(), 5);
    press(&mut page, "Shift+,");
    assert_eq!(page.selected().1, [0]);
    press(&mut page, "Ctrl+H");
    assert!(page.has("1 face hidden"));
    press(&mut page, "Shift+H");
    assert!(!page.has("1 face hidden"));
    page.select("halfedge", &[0]);
    let mesh = page.mesh();
    let before = mesh.prev(halfedge::HalfedgeId::new(0)).raw();
    press(&mut page, "Shift+N");
    assert_eq!(page.selected().1, [before]);
    press(&mut page, "4");
    assert_eq!(view(&mut page, "look"), "hidden-line");
    press(&mut page, "5");
    assert_eq!(view(&mut page, "look"), "studio");
    page.select("vertex", &[0]);
    press(&mut page, "Backspace");
    assert_eq!(page.mesh().vertex_count(), 7);
}

/// Types into the field of the window of keys.
fn look_for(page: &mut Page, text: &str) {
    page.click("Find by name");
    page.press_with(Modifiers::COMMAND, Key::A);
    page.press(Key::Delete);
    if !text.is_empty() {
        page.type_text(text);
    }
}

/// A grid of six by six quads seen from above, with a preset and a kind of element.
fn grid(preset: &str, kind: &str) -> Page {
    let mut page = with_keys(preset);
    page.command(json!({"op": "new", "shape": "grid", "columns": 6, "rows": 6}));
    page.select(kind, &[0]);
    press(&mut page, "Escape");
    press(&mut page, "Numpad7");
    page
}

fn place(page: &mut Page, vertices: &[u32]) -> Pos2 {
    let mesh = page.mesh();
    let sum =
        vertices.iter().fold(glam::Vec3::ZERO, |sum, v| sum + mesh.position(VertexId::new(*v as usize)));
    page.at((sum / vertices.len() as f32).to_array())
}

/// What a drag beside the mesh does to yaw, distance and target of the view, and to the selection.
fn effect(page: &mut Page, button: PointerButton, modifiers: Modifiers) -> &'static str {
    let read = |page: &mut Page| {
        (number(page, "yaw"), number(page, "distance"), view(page, "target"), page.selected().1.len())
    };
    let area = page.find("Viewport").rect();
    let from = area.left_bottom() + vec2(170.0, -30.0);
    let before = read(page);
    drag_along(
        page,
        &[from, from + vec2(30.0, -40.0), area.right_top() + vec2(-20.0, 70.0)],
        button,
        modifiers,
    );
    let after = read(page);
    let effect = match () {
        () if after.3 != before.3 => "select",
        () if after.0 != before.0 => "orbit",
        () if after.1 != before.1 => "zoom",
        () if after.2 != before.2 => "pan",
        () => "nothing",
    };
    if effect == "select" {
        press(page, "Ctrl+Z");
    } else {
        page.app().script().undo().ok();
        let reset = if view(page, "keys") == "blender" {
            "Shift+C"
        } else if view(page, "keys") == "maya" {
            "Home"
        } else {
            "Space"
        };
        press(page, reset);
    }
    effect
}

#[test]
fn the_mouse_moves_the_view_as_each_preset_says() {
    use PointerButton::{Middle, Primary, Secondary};
    const NONE: Modifiers = Modifiers::NONE;
    const SHIFT: Modifiers = Modifiers::SHIFT;
    const CTRL: Modifiers = Modifiers::COMMAND;
    const ALT: Modifiers = Modifiers::ALT;
    let cases = [
        ("course", Primary, NONE, "orbit"),
        ("course", Primary, SHIFT, "pan"),
        ("course", Primary, CTRL, "select"),
        ("course", Primary, ALT, "orbit"),
        ("course", Middle, NONE, "orbit"),
        ("course", Secondary, NONE, "pan"),
        ("blender", Primary, NONE, "select"),
        ("blender", Primary, ALT, "orbit"),
        ("blender", Middle, NONE, "orbit"),
        ("blender", Middle, SHIFT, "pan"),
        ("blender", Middle, CTRL, "zoom"),
        ("maya", Primary, NONE, "select"),
        ("maya", Primary, SHIFT, "select"),
        ("maya", Primary, ALT, "orbit"),
        ("maya", Middle, ALT, "pan"),
        ("maya", Secondary, ALT, "zoom"),
        ("maya", Middle, NONE, "nothing"),
    ];
    for preset in ["course", "blender", "maya"] {
        let mut page = with_keys(preset);
        for (_, button, modifiers, expected) in cases.iter().filter(|case| case.0 == preset) {
            assert_eq!(
                effect(&mut page, *button, *modifiers),
                *expected,
                "{preset}: {button:?} with {modifiers:?}"
            );
        }
    }
}

#[test]
fn one_finger_turns_the_view_in_every_preset() {
    let mut page = Page::with_setting(PHONE, "keys", "blender");
    let from = page.find("Viewport").rect().center_bottom() + vec2(-60.0, -20.0);
    let before = number(&mut page, "yaw");
    page.touch(from);
    for step in 1..5 {
        page.move_finger(from + vec2(step as f32 * 15.0, 0.0));
    }
    assert_ne!(number(&mut page, "yaw"), before);
}

#[test]
fn clicks_select_as_each_preset_says() {
    const SHIFT: Modifiers = Modifiers::SHIFT;
    const CTRL: Modifiers = Modifiers::COMMAND;
    let mut page = grid("blender", "vertex");
    let [a, b] = [[8], [11]].map(|v| place(&mut page, &v));
    click_at(&mut page, a, Modifiers::NONE);
    click_at(&mut page, b, SHIFT);
    assert_eq!(page.selected().1, [8, 11]);
    click_at(&mut page, b, SHIFT);
    assert_eq!(page.selected().1, [8], "Shift takes away too");
    click_at(&mut page, b, CTRL);
    assert_eq!(page.selected().1, [8, 9, 10, 11], "Ctrl adds the path");

    page.harness.hover_at(b);
    page.run();
    press(&mut page, "Alt+A");
    press(&mut page, "L");
    assert_eq!(page.selected().1.len(), 49, "everything linked to what is under the pointer");

    let mut page = grid("maya", "edge");
    let edge = place(&mut page, &[16, 17]);
    double_click_at(&mut page, edge, Modifiers::NONE);
    assert_eq!(page.selected().1.len(), 6, "a loop");
    click_at(&mut page, edge, CTRL);
    assert_eq!(page.selected().1.len(), 5, "Ctrl takes away");
    click_at(&mut page, edge, CTRL);
    assert_eq!(page.selected().1.len(), 5, "and does not add");
    click_at(&mut page, edge, CTRL.plus(SHIFT));
    assert_eq!(page.selected().1.len(), 6);
    // A part of a loop: from the edge that was clicked to the one that is double-clicked with Shift.
    let [first, last] = [[14, 15], [17, 18]].map(|ends| place(&mut page, &ends));
    click_at(&mut page, first, Modifiers::NONE);
    double_click_at(&mut page, last, SHIFT);
    assert_eq!(page.selected().1.len(), 4);

    let mut page = grid("maya", "face");
    let face = place(&mut page, &[16, 17, 23, 24]);
    double_click_at(&mut page, face, Modifiers::NONE);
    assert_eq!(page.selected(), (Element::Face, (0..36).collect()), "everything linked");
}

#[test]
fn boxes_change_the_selection_as_each_preset_says() {
    let mut page = grid("blender", "vertex");
    let [a, b, c] = [[8], [10], [24]].map(|v| place(&mut page, &v));
    let out = vec2(12.0, 12.0);
    let left = PointerButton::Primary;
    drag_along(&mut page, &[a - out, b + out], left, Modifiers::NONE);
    assert_eq!(page.selected().1, [8, 9, 10]);
    drag_along(&mut page, &[b + vec2(12.0, -12.0), c + vec2(-12.0, 12.0)], left, Modifiers::SHIFT);
    assert_eq!(page.selected().1, [8, 9, 10, 17, 24], "Shift adds");
    drag_along(&mut page, &[a - out, b + out], left, Modifiers::COMMAND);
    assert_eq!(page.selected().1, [17, 24], "Ctrl removes");
    // A selected element is moved instead.
    let before = page.mesh().position(VertexId::new(24));
    drag_along(&mut page, &[c, c + vec2(30.0, 0.0), c + vec2(60.0, 10.0)], left, Modifiers::NONE);
    assert_ne!(page.mesh().position(VertexId::new(24)), before);
}

#[test]
fn the_preset_is_chosen_in_the_menu_and_kept() {
    let mut page = Page::new();
    assert_eq!(view(&mut page, "keys"), "course");
    page.click("Edit");
    page.click("Keys");
    page.click("Maya keys");
    assert_eq!(view(&mut page, "keys"), "maya");
    assert_eq!(page.outside.setting("keys").as_deref(), Some("maya"));
    page.press(Key::Escape);
    // Menus show its keys.
    page.click("Mesh");
    page.click("Face edits");
    assert!(page.has_part("Extrude faces") && page.has_part("Ctrl+E"));
}

#[test]
fn the_address_chooses_keys_for_a_visit() {
    let mut page = Page::with_parameter("keys", "Blender");
    assert_eq!(view(&mut page, "keys"), "blender");
    assert_eq!(page.outside.setting("keys"), None);
    let mut page = Page::with_parameter("keys", "emacs");
    assert_eq!(view(&mut page, "keys"), "course");
    assert!(page.has_part("use one of course, blender, maya"));
}

#[test]
fn keys_are_changed_in_the_window_and_kept() {
    let mut page = Page::new();
    press(&mut page, "F1");
    look_for(&mut page, "sample");
    assert!(page.has("Upsample (subdivide): U") && !page.has("Undo: Ctrl+Z"));
    page.click("Upsample (subdivide): U");
    assert!(page.has("Press a key…"));
    press(&mut page, "Ctrl+U");
    assert!(page.has("Upsample (subdivide): Ctrl+U") && !page.has("Upsample (subdivide): U"));
    assert_eq!(view(&mut page, "changed_keys"), json!({"upsample": ["Ctrl+U"]}));

    // A second key, which is another's: it is named, and taken over.
    page.click("Add a key to Downsample (simplify)");
    press(&mut page, "B");
    assert!(page.has("B starts Bevel edges."));
    assert_eq!(page.mesh().face_count(), 6);
    page.click("Take it over");
    assert!(page.has("Downsample (simplify): B") && page.has("Downsample (simplify): D"));
    // Removing one.
    page.click("Downsample (simplify): D");
    page.click("Remove");
    assert!(!page.has("Downsample (simplify): D"));
    // Escape ends the waiting, not the window.
    page.click("Add a key to Resample (remesh)");
    press(&mut page, "Escape");
    assert!(!page.has("Press a key…") && page.has("Find by name"));
    press(&mut page, "Escape");
    assert!(!page.has("Find by name"));

    press(&mut page, "U");
    assert_eq!(page.mesh().face_count(), 6);
    press(&mut page, "Ctrl+U");
    assert_eq!(page.mesh().face_count(), 24);

    // After a reload, in this preset and not in another.
    let stored = page.outside.setting("changed-keys").expect("kept");
    let mut page = Page::with_setting(DESKTOP, "changed-keys", &stored);
    let changed = json!({"upsample": ["Ctrl+U"], "downsample": ["B"], "operation-bevel-edges": []});
    assert_eq!(view(&mut page, "changed_keys"), changed);
    page.click("Edit");
    page.click("Keys");
    page.click("Blender keys");
    assert_eq!(view(&mut page, "changed_keys"), json!({}));
    page.press(Key::Escape);
    press(&mut page, "F1");
    page.harness.get_by_role_and_label(Role::Button, "Course keys").click();
    page.run();
    page.click("Changed only");
    assert!(page.has("Bevel edges") && !page.has("Undo: Ctrl+Z"));
    page.click("Reset the keys of Bevel edges");
    assert!(page.has("B also starts Bevel edges."), "a conflict is shown by name");
    page.click("Reset all");
    assert_eq!(view(&mut page, "changed_keys"), json!({}));
    assert!(page.has("Nothing matches."));
    assert_eq!(page.outside.setting("changed-keys").as_deref(), Some("{}"));
}

#[test]
fn keys_are_found_by_pressing_them() {
    let mut page = Page::new();
    press(&mut page, "F1");
    page.click("Find by key");
    press(&mut page, "Ctrl+Z");
    assert!(page.has("Undo: Ctrl+Z") && !page.has("Upsample (subdivide): U"));
    assert!(page.undo_labels().is_empty() && !page.has_part("nothing to undo"));
    page.click("Find by key");
    assert!(page.has("Upsample (subdivide): U"));
}

#[test]
fn settings_that_cannot_be_read_are_reported() {
    let mut page = Page::with_setting(DESKTOP, "changed-keys", "[broken");
    assert!(page.has_part("can't be read"));
    press(&mut page, "U");
    assert_eq!(page.mesh().face_count(), 24);
}

#[test]
fn keys_of_the_browser_are_taken_in_the_viewport_only() {
    let mut page = with_keys("blender");
    for text in ["Ctrl+R", "Ctrl+B", "Ctrl+Z", "Ctrl+Alt+V", "Ctrl+F", "F3", "Space"] {
        assert!(page.app().takes_key(shortcut(text)), "{text}");
    }
    for text in ["Ctrl+D", "Ctrl+H", "Ctrl+V", "F5", "Ctrl+W", "U"] {
        assert!(!page.app().takes_key(shortcut(text)), "{text} means nothing here");
    }
    page.row("Vertex 2").click();
    page.run();
    assert!(!page.app().takes_key(shortcut("Ctrl+R")), "a list has the focus");
    assert!(!page.app().takes_key(shortcut("Ctrl+F")), "finding is the browser's");
    assert!(page.app().takes_key(shortcut("Ctrl+J")));
    press(&mut page, "Ctrl+K");
    page.run();
    for text in ["Ctrl+R", "Ctrl+Z", "A"] {
        assert!(!page.app().takes_key(shortcut(text)), "{text} is the palette's");
    }
    press(&mut page, "Escape");
    press(&mut page, "F1");
    page.click("Find by key");
    assert!(page.app().takes_key(shortcut("F5")), "the window waits for any key");
    let mut page = Page::new();
    assert!(!page.app().takes_key(shortcut("Ctrl+R")), "not a key of the courses");
}

#[test]
fn every_preset_pastes_with_ctrl_v() {
    for preset in ["course", "blender", "maya"] {
        let mut page = with_keys(preset);
        page.harness.event(Event::Paste("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".to_owned()));
        press(&mut page, "Ctrl+V");
        assert_eq!(page.mesh().face_count(), 1, "{preset}");
        assert!(!page.has_part("Merge vertices…"), "{preset}: no menu");
    }
    let mut page = with_keys("blender");
    page.select("vertex", &[0]);
    press(&mut page, "Ctrl+Alt+V");
    assert!(page.harness.query_by_role_and_label(Role::Menu, "Vertex menu").is_some());
}

#[test]
fn f9_goes_to_the_fields_of_the_last_operation() {
    for preset in ["course", "blender"] {
        let mut page = with_keys(preset);
        press(&mut page, "F9");
        assert!(page.has_part("There is no operation whose fields could be changed"), "{preset}");
        page.select("face", &[0]);
        page.command(json!({"op": "extrude-faces", "distance": 0.5}));
        press(&mut page, "F9");
        press(&mut page, "Ctrl+A");
        page.type_text("2");
        press(&mut page, "Enter");
        let far = page.mesh().positions().iter().map(|p| p.abs().max_element()).fold(0.0, f32::max);
        assert_eq!(far, 3.0, "{preset}: the distance is the first field");
        assert_eq!(page.undo_labels().len(), 1, "{preset}: still one step");
    }
}

#[test]
fn menus_of_looks_and_of_the_cursor_open_at_the_pointer() {
    for preset in ["course", "blender"] {
        let mut page = with_keys(preset);
        page.hover_off_middle(vec2(0.0, 0.0));
        press(&mut page, "Z");
        let middle = page.find("Viewport").rect().center();
        let entry = page.find("Normals as colours").rect();
        assert!((entry.left() - middle.x).abs() < 40.0, "{preset}: {entry} is at the pointer");
        page.click("Normals as colours");
        assert_eq!(view(&mut page, "look"), "normals", "{preset}");
    }
    let mut page = with_keys("blender");
    press(&mut page, "Shift+Z");
    assert_eq!(view(&mut page, "wireframe"), false);
    press(&mut page, "Shift+S");
    page.click("Cursor to origin");
    assert_eq!(view(&mut page, "cursor"), json!([0.0, 0.0, 0.0]));
}

#[test]
fn an_operation_on_the_whole_mesh_that_a_key_started_says_so() {
    let mut page = Page::new();
    press(&mut page, "U");
    assert_eq!(page.mesh().face_count(), 24);
    // Undo in the message is about the operation, whatever was selected since.
    page.select("face", &[3]);
    let undo = page.harness.get_by_role_and_label(Role::Link, "Undo");
    undo.click();
    page.run();
    assert_eq!(page.mesh().face_count(), 6);
    assert!(page.harness.query_by_role_and_label(Role::Link, "Undo").is_none(), "it is undone");
    // After another edit, undo would undo that one.
    press(&mut page, "U");
    page.command(json!({ "op": "poke-faces", "faces": [0] }));
    assert!(page.harness.query_by_role_and_label(Role::Link, "Undo").is_none());
    // Whoever chose it in a menu knows.
    let mut page = Page::new();
    page.click("Mesh");
    page.click("Subdivide");
    page.click("Upsample (subdivide) U");
    page.run();
    assert_eq!(page.mesh().face_count(), 24);
    assert!(page.harness.query_by_role_and_label(Role::Link, "Undo").is_none());
}

#[test]
fn the_window_of_the_keys_looks_well() {
    for (size, theme, name) in [
        (DESKTOP, Theme::Dark, "keys dark"),
        (DESKTOP, Theme::Light, "keys light"),
        (PHONE, Theme::Dark, "keys phone"),
    ] {
        let mut page = Page::drawn(size, theme);
        press(&mut page, "F1");
        look_for(&mut page, "sample");
        page.click("Upsample (subdivide): U");
        press(&mut page, "Ctrl+U");
        page.click("Add a key to Downsample (simplify)");
        press(&mut page, "B");
        crate::looks::picture(&mut page, &format!("{name} conflict"));
        page.click("Cancel");
        look_for(&mut page, "");
        crate::looks::picture(&mut page, name);
        let window = page.harness.get_by_label_contains("Reset all").rect();
        assert!(window.right() <= size.x, "{name}: {window:?}");
    }
}
