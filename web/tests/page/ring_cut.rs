//! The loop cut at the pointer: it shows its ring, takes its count from the wheel, and slides after a click.

use crate::page::{DESKTOP, Page};
use egui::{Event, Key, Modifiers, PointerButton, Pos2, vec2};
use halfedge::Element;

/// The middle of a visible vertical edge of the cube.
const ON_EDGE: [f32; 3] = [1.0, 0.0, 1.0];

fn click(page: &mut Page, at: Pos2) {
    for pressed in [true, false] {
        let button = PointerButton::Primary;
        page.harness.event(Event::PointerButton { pos: at, button, pressed, modifiers: Modifiers::NONE });
        page.run();
    }
}

fn turn_wheel(page: &mut Page, by: f32) {
    page.turn_wheel(egui::MouseWheelUnit::Line, by);
}

/// The page with the tool over an edge of the cube.
fn pointing() -> (Page, Pos2) {
    let mut page = Page::new();
    let at = page.at(ON_EDGE);
    page.hover(at);
    page.press(Key::L);
    page.hover(at + vec2(1.0, 0.0));
    (page, at)
}

#[test]
fn a_click_cuts_and_the_pointer_slides() {
    let (mut page, at) = pointing();
    assert_eq!(page.mesh().face_count(), 6, "pointing changes nothing");
    click(&mut page, at);
    assert_eq!(page.mesh().face_count(), 10, "four quads are cut in two");
    let before = page.mesh().clone();
    page.hover(at + vec2(0.0, 40.0));
    assert_ne!(page.mesh(), &before, "the cut slides along the edge");
    click(&mut page, at + vec2(0.0, 40.0));
    assert_eq!(page.undo_labels().last().map(String::as_str), Some("Loop cut"));
    assert_eq!(page.selected().0, Element::Vertex, "the kind that was worked on stays");
    assert_eq!(page.selected().1.len(), 4, "the new loop is selected");
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(page.mesh().face_count(), 6);
}

#[test]
fn the_wheel_sets_the_number_of_cuts_and_does_not_zoom() {
    let (mut page, at) = pointing();
    let edge_before = page.at(ON_EDGE);
    turn_wheel(&mut page, 1.0);
    turn_wheel(&mut page, 1.0);
    turn_wheel(&mut page, -1.0);
    assert_eq!(page.at(ON_EDGE), edge_before, "the view stays");
    click(&mut page, at);
    assert_eq!(page.mesh().face_count(), 6 + 4 * 2);
    page.press(Key::Enter);
    assert_eq!(page.undo_labels().len(), 1);
}

#[test]
fn digits_set_the_number_of_cuts_and_leave_the_mode() {
    let (mut page, at) = pointing();
    let digit = |page: &mut Page, key: Key, text: &str| {
        page.harness.key_press(key);
        page.harness.event(Event::Text(text.to_owned()));
        page.run();
    };
    // In the keys of the courses, 1 and 2 are modes too.
    digit(&mut page, Key::Num1, "1");
    digit(&mut page, Key::Num2, "2");
    page.press(Key::Backspace);
    digit(&mut page, Key::Num1, "1");
    assert_eq!(page.app().script().state()["view"]["list"], "vertex");
    turn_wheel(&mut page, 1.0);
    click(&mut page, at);
    page.press(Key::Enter);
    assert_eq!(page.mesh().face_count(), 6 + 4 * 12, "11 and a notch of the wheel");
    // The next number starts afresh.
    page.press(Key::L);
    page.hover(at + vec2(2.0, 0.0));
    digit(&mut page, Key::Num3, "3");
    click(&mut page, at);
    page.press(Key::Enter);
    assert_eq!(page.mesh().face_count(), 6 + 4 * 12 + 4 * 3);
}

#[test]
fn a_drag_cuts_and_slides_in_one() {
    let (mut page, at) = pointing();
    page.drag(at, at + vec2(0.0, 60.0));
    page.drop(at + vec2(0.0, 60.0));
    assert_eq!(page.mesh().face_count(), 10);
    assert_eq!(page.undo_labels().len(), 1);
    let heights: Vec<f32> = page.mesh().positions().iter().skip(8).map(|at| at.y).collect();
    assert!(heights.iter().all(|y| *y < -0.1), "{heights:?}");
}

#[test]
fn escape_and_a_right_click_end_the_tool_and_one_cut_does_too() {
    for by_key in [true, false] {
        let (mut page, at) = pointing();
        if by_key {
            page.press(Key::Escape);
        } else {
            let button = PointerButton::Secondary;
            for pressed in [true, false] {
                page.harness.event(Event::PointerButton {
                    pos: at,
                    button,
                    pressed,
                    modifiers: Modifiers::NONE,
                });
                page.run();
            }
        }
        click(&mut page, at);
        assert_eq!((page.mesh().face_count(), page.undo_labels().len()), (6, 0));
    }
    let (mut page, at) = pointing();
    click(&mut page, at);
    page.press(Key::Escape);
    assert_eq!(page.mesh().face_count(), 6, "a cancelled cut leaves no trace");
    click(&mut page, at);
    assert_eq!(page.mesh().face_count(), 6, "the next click selects");
    assert_eq!(page.selected().1.len(), 1);
}

#[test]
fn quick_clicks_cut_and_accept_and_are_no_double_click() {
    for preset in ["course", "blender", "maya"] {
        let mut page = Page::with_setting(DESKTOP, "keys", preset);
        let at = page.at(ON_EDGE);
        page.hover(at);
        page.click("Edge mode");
        page.click("Tool: Loop cut");
        page.hover(at);
        for _ in 0..2 {
            let button = |pressed| Event::PointerButton {
                pos: at,
                button: PointerButton::Primary,
                pressed,
                modifiers: Modifiers::NONE,
            };
            let input = page.harness.input_mut();
            input.events.extend([Event::PointerMoved(at), button(true), button(false)]);
            page.harness.step();
        }
        page.run();
        assert_eq!(page.undo_labels(), ["Loop cut"], "{preset}");
        let (kind, ids) = page.selected();
        assert_eq!((kind, ids.len()), (Element::Edge, 4), "{preset}");
        let mesh = page.mesh();
        let is_new = |id: &u32| {
            let [from, to] = mesh.ends(halfedge::EdgeId::new(*id as usize));
            from.raw() >= 8 && to.raw() >= 8
        };
        assert!(ids.iter().all(is_new), "{preset}: the new loop, not one across it: {ids:?}");
    }
}

#[test]
fn in_the_keys_of_blender_a_cut_stays_in_the_middle_when_its_slide_is_cancelled() {
    for (preset, faces) in [("blender", 10), ("course", 6)] {
        for by_key in [true, false] {
            let mut page = Page::with_setting(DESKTOP, "keys", preset);
            let at = page.at(ON_EDGE);
            page.click("Tool: Loop cut");
            page.hover(at);
            click(&mut page, at);
            page.hover(at + vec2(0.0, 40.0));
            assert_eq!(page.has_part("Right button: Cut in the middle"), preset == "blender");
            assert!(page.has_part("Wheel: Cuts"));
            if by_key {
                page.press(Key::Escape);
            } else {
                let button = PointerButton::Secondary;
                let (pos, modifiers) = (at + vec2(0.0, 40.0), Modifiers::NONE);
                for pressed in [true, false] {
                    page.harness.event(Event::PointerButton { pos, button, pressed, modifiers });
                    page.run();
                }
            }
            assert_eq!(page.mesh().face_count(), faces, "{preset}");
            assert!(page.mesh().positions().iter().skip(8).all(|at| at.y.abs() < 1e-6));
            assert!(!page.has("Apply"), "the edit has ended");
            assert_eq!(page.undo_labels().len(), usize::from(faces > 6));
        }
    }
}

#[test]
fn an_empty_document_says_why_there_is_nothing_to_cut() {
    let mut page = Page::new();
    page.command(serde_json::json!({ "op": "delete-faces", "faces": [0, 1, 2, 3, 4, 5] }));
    page.press(Key::L);
    assert!(page.has_part("There are no faces to cut."));
}

#[test]
fn the_ring_is_drawn() {
    let mut page = Page::drawn(DESKTOP, egui::Theme::Dark);
    let at = page.at(ON_EDGE);
    page.hover(at);
    page.press(Key::L);
    page.hover(at + vec2(1.0, 0.0));
    turn_wheel(&mut page, 1.0);
    // A bar over the viewport takes the pointer away from the model.
    let beside = page.find("Edge mode").rect().center();
    page.hover(beside);
    let without = crate::looks::picture(&mut page, "loop cut, beside the model");
    page.hover(at);
    let with = crate::looks::picture(&mut page, "loop cut at the pointer");
    let changed = with.pixels().zip(without.pixels()).filter(|(a, b)| a != b).count();
    assert!(changed > 300, "{changed} pixels");
}
