//! Edits that follow the pointer, and adjusting the last operation.

use crate::page::Page;
use egui::{Event, Key, vec2};
use egui_kittest::kittest::Queryable;
use halfedge::Element;

fn cube_face() -> Page {
    let mut page = Page::new();
    page.select("face", &[0]);
    page
}

/// The pointer over the middle of the viewport, then this far from there.
fn hover(page: &mut Page, by: egui::Vec2) {
    let middle = page.harness.get_by_label("Viewport").rect().center();
    page.harness.hover_at(middle + by);
    page.run();
}

fn type_text(page: &mut Page, text: &str) {
    page.harness.event(Event::Text(text.to_owned()));
    page.run();
}

#[test]
fn extruding_follows_the_pointer_and_is_one_step() {
    let mut page = cube_face();
    let before = page.mesh().clone();
    let steps = page.undo_labels();
    page.press(Key::E);
    assert_eq!(page.mesh(), &before, "nothing moves before the pointer does");
    hover(&mut page, vec2(0.0, 0.0));
    hover(&mut page, vec2(40.0, 0.0));
    assert_eq!(page.mesh().face_count(), 10);
    let near = page.mesh().clone();
    hover(&mut page, vec2(80.0, 0.0));
    assert_ne!(page.mesh(), &near, "the distance follows");
    assert_eq!(page.mesh().face_count(), 10, "and replaces the one before");
    page.press(Key::Enter);
    assert_eq!(page.undo_labels().len(), steps.len() + 1);
    let done = page.mesh().clone();
    hover(&mut page, vec2(-80.0, 0.0));
    assert_eq!(page.mesh(), &done, "Enter ends it");
    page.press_with(egui::Modifiers::COMMAND, Key::Z);
    assert_eq!(page.mesh(), &before);
}

#[test]
fn the_preview_changes_only_when_the_pointer_moves() {
    let mut page = cube_face();
    page.press_with(egui::Modifiers::SHIFT, Key::I);
    hover(&mut page, vec2(0.0, 0.0));
    hover(&mut page, vec2(15.0, 0.0));
    let shown = page.mesh().clone();
    // A panel that takes or leaves a pixel makes the picture, and so a point's worth of it, another.
    let size = page.harness.ctx.content_rect().size();
    page.harness.set_size(size - vec2(60.0, 40.0));
    page.run();
    assert_eq!(page.mesh(), &shown);
    page.press(Key::Enter);
    assert_eq!(page.mesh(), &shown);
}

#[test]
fn escape_leaves_no_trace() {
    let mut page = cube_face();
    let before = page.mesh().clone();
    let steps = page.undo_labels();
    page.press_with(egui::Modifiers::SHIFT, Key::I);
    hover(&mut page, vec2(0.0, 0.0));
    hover(&mut page, vec2(15.0, 0.0));
    assert_ne!(page.mesh(), &before);
    page.press(Key::Escape);
    assert_eq!(page.mesh(), &before);
    assert_eq!(page.undo_labels(), steps);
    assert_eq!(page.selected(), (Element::Face, vec![0]), "the selection stays");
    assert!(!page.has("Cancel"));
}

#[test]
fn a_typed_number_is_the_amount() {
    let mut page = cube_face();
    page.press(Key::E);
    for digit in ["0", ".", "2", "5", "7"] {
        type_text(&mut page, digit);
    }
    page.press(Key::Backspace);
    page.press(Key::Enter);
    assert_eq!(page.mesh().face_count(), 10);
    let far = page.mesh().positions().iter().map(|p| p.abs().max_element()).fold(0.0, f32::max);
    assert_eq!(far, 1.25);
}

#[test]
fn the_buttons_do_what_the_keys_do() {
    let mut page = cube_face();
    page.press(Key::E);
    type_text(&mut page, "1");
    page.click("Cancel");
    assert_eq!(page.mesh().face_count(), 6);
    page.press(Key::E);
    type_text(&mut page, "1");
    page.click("Apply");
    assert_eq!(page.mesh().face_count(), 10);
}

#[test]
fn keys_depend_on_the_selection() {
    let mut page = Page::new();
    page.select("vertex", &[0]);
    page.press(Key::B);
    type_text(&mut page, ".2");
    page.press(Key::Enter);
    assert_eq!((page.mesh().vertex_count(), page.mesh().face_count()), (10, 7));

    page.select("vertex", &[1]);
    page.press(Key::G);
    hover(&mut page, vec2(0.0, 0.0));
    let before = page.mesh().clone();
    hover(&mut page, vec2(30.0, 20.0));
    page.press(Key::Enter);
    let moved = page.mesh().positions().iter().zip(before.positions()).filter(|(a, b)| a != b).count();
    assert_eq!(moved, 1);
}

#[test]
fn a_split_slides_along_its_edge() {
    let mut page = Page::new();
    page.select("edge", &[0]);
    page.press_with(egui::Modifiers::SHIFT, Key::S);
    assert_eq!(page.mesh().vertex_count(), 9, "in the middle at first");
    let middle = page.mesh().positions().last().copied();
    hover(&mut page, vec2(0.0, 0.0));
    hover(&mut page, vec2(40.0, 0.0));
    assert_ne!(page.mesh().positions().last().copied(), middle);
    page.press(Key::Enter);
    assert_eq!(page.undo_labels().last().map(String::as_str), Some("Split edge"));
}

#[test]
fn a_refused_live_edit_says_why_and_changes_nothing() {
    let mut page = Page::new();
    page.command(serde_json::json!({ "op": "new", "shape": "plane" }));
    let before = page.mesh().clone();
    page.select("edge", &[0]);
    page.press(Key::B);
    type_text(&mut page, "0.1");
    assert_eq!(page.mesh(), &before);
    assert!(page.has_part("boundary"), "the reason is on the screen");
    page.press(Key::Escape);
    assert_eq!(page.mesh(), &before);
}

/// A viewport that changes its size under the pointer moves what one is about to click.
#[test]
fn the_adjust_panel_does_not_resize_the_viewport() {
    let mut page = Page::new();
    let width = |page: &Page| page.harness.get_by_label("Viewport").rect().width();
    let before = width(&page);
    for command in [
        serde_json::json!({ "op": "bevel-edges", "edges": [0], "width": 0.1 }),
        serde_json::json!({ "op": "extrude-faces", "faces": [0], "distance": 0.1 }),
        serde_json::json!({ "op": "transform", "vertices": [5], "translate": [0.1, 0.2, 0.3] }),
        serde_json::json!({ "op": "subdivide-catmull-clark" }),
        serde_json::json!({ "op": "smooth" }),
        serde_json::json!({ "op": "triangulate-faces" }),
        serde_json::json!({ "op": "subdivide-loop" }),
        serde_json::json!({ "op": "remesh" }),
        serde_json::json!({ "op": "simplify", "ratio": 0.5 }),
        serde_json::json!({ "op": "merge-by-distance", "distance": 0.001 }),
    ] {
        let op = command["op"].to_string();
        page.command(command);
        assert!(page.has("Adjust last operation"), "{op}");
        assert_eq!(width(&page), before, "{op}");
    }
}

#[test]
fn the_last_operation_can_be_adjusted() {
    let mut page = Page::new();
    page.command(serde_json::json!({ "op": "extrude-faces", "faces": [0], "distance": 0.5 }));
    let steps = page.undo_labels().len();
    assert!(page.has("Adjust last operation") && page.has("Extrude faces"));
    let field = page.harness.get_all_by_label("Distance").next().expect("its distance");
    field.focus();
    page.run();
    page.press(Key::ArrowUp);
    let far = page.mesh().positions().iter().map(|p| p.abs().max_element()).fold(0.0, f32::max);
    assert!(far > 1.5, "further than it was: {far}");
    assert_eq!(page.undo_labels().len(), steps, "in place of itself");
    assert_eq!(page.mesh().face_count(), 10);
    // While a number is being typed, Ctrl+Z is the field's.
    page.press(Key::Enter);
    page.press_with(egui::Modifiers::COMMAND, Key::Z);
    assert_eq!(page.mesh().face_count(), 6);
    assert!(!page.has_part("Adjust last operation"), "an undo is nothing to adjust");
}
