//! Keys that mean something while they are held, and the menus of elements at the pointer.

use crate::page::{DESKTOP, Page};
use crate::regions::drag_along;
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, PointerButton, Pos2, vec2};
use egui_kittest::kittest::Queryable;
use glam::Vec3;
use halfedge::{Element, VertexId};
use serde_json::json;

fn with_keys(preset: &str) -> Page {
    Page::with_setting(DESKTOP, "keys", preset)
}

/// Presses a key or lets it go.
fn key(page: &mut Page, key: Key, pressed: bool) {
    let modifiers = Modifiers::NONE;
    page.harness.event(Event::Key { key, physical_key: None, pressed, repeat: false, modifiers });
    page.run();
}

fn place(page: &mut Page, v: usize) -> Vec3 {
    page.mesh().position(VertexId::new(v))
}

/// Drags the vertex 7 of a cube to a place near vertex 5 while a key is held; returns where both are then.
fn dragged_with(held: Option<Key>) -> [Vec3; 2] {
    let mut page = with_keys("maya");
    page.select("vertex", &[7]);
    let [from, to] = [7, 5].map(|v| {
        let at = place(&mut page, v);
        page.at(at.to_array())
    });
    if let Some(held) = held {
        key(&mut page, held, true);
    }
    page.drag(from, to + vec2(3.0, 2.0));
    page.drop(to + vec2(3.0, 2.0));
    if let Some(held) = held {
        key(&mut page, held, false);
    }
    assert_eq!(page.undo_labels(), ["Move"]);
    let state = page.app().script().state();
    assert_eq!(state["view"]["keys"], "maya");
    // Let go, it snaps no longer, and what edits snap to was not chosen.
    page.press_with(Modifiers::COMMAND, Key::Z);
    page.drag(from, to + vec2(3.0, 2.0));
    page.drop(to + vec2(3.0, 2.0));
    let free = place(&mut page, 7);
    page.press_with(Modifiers::COMMAND, Key::Z);
    page.press_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    assert_eq!(place(&mut page, 7), free);
    page.press_with(Modifiers::COMMAND, Key::Z);
    if let Some(held) = held {
        key(&mut page, held, true);
    }
    page.drag(from, to + vec2(3.0, 2.0));
    page.drop(to + vec2(3.0, 2.0));
    [place(&mut page, 7), place(&mut page, 5)]
}

#[test]
fn in_the_keys_of_maya_held_keys_snap_to_vertices_edges_and_the_grid() {
    let [free, target] = dragged_with(None);
    assert!(free.distance(target) > 1e-3, "{free} and {target}");
    let [snapped, target] = dragged_with(Some(Key::V));
    assert_eq!(snapped, target);
    let [stepped, _] = dragged_with(Some(Key::X));
    // The grid is a tenth or ten times as wide.
    let steps = stepped * 10.0;
    assert!((steps - steps.round()).abs().max_element() < 1e-3, "{stepped}");
    assert!((free * 10.0 - (free * 10.0).round()).abs().max_element() > 1e-3, "{free}");
    let [curve, _] = dragged_with(Some(Key::C));
    // On an edge of the cube, two coordinates are those of its ends.
    assert!(curve.abs().to_array().iter().filter(|c| (**c - 1.0).abs() < 1e-4).count() >= 2, "{curve}");
}

#[test]
fn a_key_that_snaps_locks_no_axis() {
    let mut page = with_keys("maya");
    page.select("vertex", &[7]);
    page.command(json!({ "op": "select-all", "kind": "vertex" }));
    page.click("Transform");
    page.click("Move");
    page.hover_off_middle(vec2(0.0, 0.0));
    page.hover_off_middle(vec2(37.0, 23.0));
    let free = page.mesh().clone();
    key(&mut page, Key::X, true);
    key(&mut page, Key::X, false);
    assert!(page.has("Apply"), "the move goes on");
    page.hover_off_middle(vec2(37.5, 23.0));
    let (a, b) = (free.position(VertexId::new(0)), place(&mut page, 0));
    assert!(a.distance(b) < 0.05, "{a} and {b}: not locked");
    page.press(Key::Escape);
}

/// The vertices of a grid that a soft move takes along after the radius was dragged.
fn taken_along(by: f32) -> usize {
    let mut page = with_keys("maya");
    page.command(json!({ "op": "new", "shape": "grid", "columns": 12, "rows": 12 }));
    page.select("vertex", &[84]);
    let before = page.mesh().clone();
    let beside = page.find("Viewport").rect().center() + vec2(-250.0, -180.0);
    key(&mut page, Key::B, true);
    page.drag(beside, beside + vec2(by, 0.0));
    page.drop(beside + vec2(by, 0.0));
    key(&mut page, Key::B, false);
    assert_eq!(page.mesh(), &before, "the drag moves nothing");
    assert_eq!(page.selected(), (Element::Vertex, vec![84]), "and selects nothing");
    page.click("Transform");
    page.click("Move");
    page.hover_off_middle(vec2(0.0, 0.0));
    page.hover_off_middle(vec2(0.0, -60.0));
    let mesh = page.mesh();
    mesh.vertices().filter(|&v| mesh.position(v) != before.position(v)).count()
}

#[test]
fn dragging_with_the_key_of_soft_selection_changes_its_radius() {
    let (small, middle, large) = (taken_along(-60.0), taken_along(5.0), taken_along(120.0));
    assert!(small < middle && middle < large, "{small}, {middle}, {large}");
    assert!(small >= 1);
}

#[test]
fn in_the_keys_of_maya_the_middle_button_slides() {
    let mut page = with_keys("maya");
    page.select("edge", &[0]);
    page.command(json!({ "op": "loop-cut" }));
    let (_, ids) = page.selected();
    let before = page.mesh().clone();
    let start: Pos2 = page.find("Viewport").rect().center();
    let path: Vec<Pos2> = (0..=6).map(|step| start + vec2(12.0, 9.0) * step as f32).collect();
    drag_along(&mut page, &path, PointerButton::Middle, Modifiers::COMMAND | Modifiers::SHIFT);
    assert_ne!(page.mesh(), &before);
    assert_eq!(page.selected().1, ids);
    assert_eq!(page.undo_labels().last().map(String::as_str), Some("Slide edges"));
    assert!(!page.has("Apply"), "letting go applies it");
    // The modifiers neither slow it down nor snap it.
    let slid = page.mesh().clone();
    page.press_with(Modifiers::COMMAND, Key::Z);
    page.hover(path[0]);
    page.press_with(Modifiers::SHIFT, Key::V);
    for at in &path {
        page.hover(*at);
    }
    page.press(Key::Enter);
    let again = page.mesh();
    for (a, b) in slid.positions().iter().zip(again.positions()) {
        assert!(a.distance(*b) < 1e-3, "{a} and {b}");
    }
}

/// Presses a key with Ctrl.
fn with_ctrl(page: &mut Page, key: Key) {
    page.press_with(Modifiers::COMMAND, key);
}

#[test]
fn in_the_keys_of_blender_menus_of_elements_open_at_the_pointer() {
    let count = |page: &Page, label: &str| page.harness.query_all_by_label_contains(label).count();
    let ctrl = Modifiers::COMMAND;
    for (modifiers, key, kind, entry) in [
        // Ctrl+V pastes.
        (ctrl | Modifiers::ALT, Key::V, "vertex", "Bevel vertices"),
        (ctrl, Key::E, "edge", "Bevel edges"),
        (ctrl, Key::F, "face", "Poke faces"),
    ] {
        let mut page = with_keys("blender");
        page.select(kind, &[0]);
        page.hover_off_middle(vec2(30.0, -20.0));
        let before = count(&page, entry);
        page.press_with(modifiers, key);
        assert_eq!(count(&page, entry), before + 1, "{kind}");
        crate::looks::picture(&mut page, &format!("{kind} menu"));
        page.press(Key::Escape);
        assert_eq!(count(&page, entry), before, "{kind}: closed");
    }
    let mut page = with_keys("blender");
    page.select("face", &[0]);
    let pointer = page.find("Viewport").rect().center() + vec2(30.0, -20.0);
    page.hover(pointer);
    with_ctrl(&mut page, Key::F);
    let poke =
        page.harness.get_all_by_role_and_label(Role::Button, "Poke faces").last().expect("in the menu");
    let rect = poke.rect();
    assert!((rect.left() - pointer.x).abs() < 40.0, "{rect} at {pointer}");
    poke.click();
    page.run();
    assert_eq!(page.mesh().face_count(), 9);
    // The Course keys have no such keys: Ctrl+E does nothing.
    let mut page = Page::new();
    page.select("edge", &[0]);
    let before = count(&page, "Bevel edges");
    with_ctrl(&mut page, Key::E);
    assert_eq!(count(&page, "Bevel edges"), before);
}

#[test]
fn in_the_keys_of_maya_a_drag_with_tab_held_paints_a_selection() {
    let mut page = with_keys("maya");
    page.select("vertex", &[]);
    let ways = [7, 5].map(|v| {
        let at = place(&mut page, v);
        page.at(at.to_array())
    });
    page.hover(ways[0]);
    let focused = |page: &Page| page.harness.ctx.memory(|memory| memory.focused());
    key(&mut page, Key::Tab, true);
    let first = focused(&page);
    key(&mut page, Key::Tab, true);
    assert_eq!(focused(&page), first, "held, it moves the focus once");
    page.drag(ways[0], ways[1]);
    page.drop(ways[1]);
    let (kind, mut painted) = page.selected();
    painted.sort_unstable();
    assert_eq!((kind, painted), (Element::Vertex, vec![5, 7]));
    // The next stroke adds; without the key, a drag draws a box.
    let third = place(&mut page, 6);
    let at = page.at(third.to_array());
    page.drag(at, at + vec2(3.0, 0.0));
    page.drop(at + vec2(3.0, 0.0));
    assert_eq!(page.selected().1.len(), 3);
    key(&mut page, Key::Tab, false);
    let corner = page.find("Viewport").rect().left_bottom() + vec2(150.0, -80.0);
    page.drag(corner, corner + vec2(4.0, 4.0));
    page.drop(corner + vec2(4.0, 4.0));
    assert_eq!(page.selected().1, [0; 0], "a box around nothing");
    // In other keys, Tab means nothing else than to go on.
    let mut course = with_keys("course");
    course.select("vertex", &[]);
    course.hover(ways[0]);
    key(&mut course, Key::Tab, true);
    course.drag(ways[0], ways[1]);
    course.drop(ways[1]);
    assert_eq!(course.selected().1, [0; 0]);
}
