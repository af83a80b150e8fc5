//! Toasts: at most one small one, in the corner, about the document that is open; errors until they are read.

use crate::page::Page;
use egui::accesskit::Role;
use egui::{Key, Modifiers, Rect};
use egui_kittest::kittest::{NodeT, Queryable};
use meshwright_web::platform::Event;
use serde_json::json;

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// The texts of the visible toasts, with their places.
fn toasts(page: &Page) -> Vec<(String, Rect)> {
    let nodes = page.harness.query_all_by_role(Role::Alert);
    nodes.map(|node| (node.accesskit_node().label().unwrap_or_default(), node.rect())).collect()
}

fn texts(page: &Page) -> Vec<String> {
    toasts(page).into_iter().map(|(text, _)| text).collect()
}

/// Lets seconds go by, with a frame only where the page asks for one.
fn wait_seconds(page: &mut Page, seconds: f64) {
    let now = page.harness.ctx.input(|input| input.time);
    page.harness.input_mut().time = Some(now + seconds);
    page.harness.step();
    page.run();
}

/// How far the lowest toast ends above the viewport's lower edge.
fn gap(page: &Page) -> f32 {
    let buttons = page.harness.query_all_by_label("Dismiss message");
    let lowest = toasts(page).iter().map(|(_, rect)| rect.bottom()).fold(f32::MIN, f32::max);
    assert!(buttons.count() > 0);
    page.find("Viewport").rect().bottom() - lowest
}

#[test]
fn a_new_message_replaces_the_last_one() {
    let mut page = Page::new();
    page.press(Key::N);
    assert_eq!(texts(&page), ["Select a half-edge first."]);
    page.press(Key::Period);
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(texts(&page), ["There is nothing to undo."]);
    let messages = page.app().script().state()["messages"].to_string();
    assert!(messages.contains("Select a half-edge first."), "the rest is in the list: {messages}");
}

#[test]
fn toasts_stay_in_the_corner_in_every_frame() {
    let mut page = Page::new();
    page.press(Key::N);
    let first = gap(&page);
    assert!((10.0..40.0).contains(&first), "{first}");
    // Frame by frame, a taller toast never leaves the viewport.
    page.outside.push(Event::Files(vec![meshwright_web::platform::NamedBytes::new("a.obj", b"f 1 2 3\n")]));
    for _ in 0..6 {
        page.harness.step();
        if !toasts(&page).is_empty() {
            assert!(gap(&page) >= 8.0, "{:?}", toasts(&page));
        }
    }
    page.run();
    assert_eq!(toasts(&page).len(), 2, "the error and the last message");
    // When one expires, the other takes its place.
    wait_seconds(&mut page, 13.0);
    assert_eq!(toasts(&page).len(), 1);
    assert!((gap(&page) - first).abs() < 24.0, "{} after {first}", gap(&page));
    let middle = page.find("Viewport").rect().center();
    assert!(toasts(&page).iter().all(|(_, rect)| !rect.contains(middle)));
}

#[test]
fn errors_stay_until_they_are_read() {
    let mut page = Page::new();
    for name in ["a.obj", "b.obj", "c.obj"] {
        page.open(name, "");
    }
    wait_seconds(&mut page, 100.0);
    assert_eq!(texts(&page), ["Could not open c.obj. The file is empty."]);
    page.click("Dismiss message");
    assert_eq!(texts(&page), ["Could not open b.obj. The file is empty."]);
    page.click("1 earlier error");
    assert!(page.has_part("Copy all"), "the list of messages");
    assert!(texts(&page).is_empty(), "which is where they are read");
}

#[test]
fn toasts_go_with_the_document_they_are_about() {
    let mut page = Page::new();
    page.open("bad.obj", "");
    page.open("triangle.obj", TRIANGLE);
    assert_eq!(texts(&page), ["Opened triangle: 3 vertices, 3 edges and 1 face"]);
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert!(texts(&page).is_empty(), "the triangle is gone");
    page.press(Key::N);
    page.command(json!({ "op": "new", "shape": "torus" }));
    assert!(texts(&page).is_empty());
}
