//! Sliding edges and vertices along their neighbours, by keys, pointer and tool bar.

use crate::page::{DESKTOP, Page};
use egui::{Event, Key, Modifiers, PointerButton, Pos2, vec2};
use glam::Vec3;
use halfedge::edit::edge_rails;
use halfedge::{EdgeId, Element, VertexId};
use serde_json::json;

fn press_button(page: &mut Page, at: Pos2, button: PointerButton) {
    for pressed in [true, false] {
        page.harness.event(Event::PointerButton { pos: at, button, pressed, modifiers: Modifiers::NONE });
        page.run();
    }
}

fn place(page: &mut Page, v: VertexId) -> Vec3 {
    page.mesh().position(v)
}

fn on_screen(page: &mut Page, point: Vec3) -> Pos2 {
    page.at(point.to_array())
}

/// A cube with a loop cut through its middle and selected; its frontmost vertex with its places at 1 and at -1.
fn with_loop(mut page: Page) -> (Page, VertexId, [Vec3; 2]) {
    page.select("edge", &[0]);
    page.command(json!({ "op": "loop-cut" }));
    let (kind, ids) = page.selected();
    assert_eq!((kind, ids.len()), (Element::Edge, 4));
    let edges: Vec<EdgeId> = ids.iter().map(|&id| EdgeId::new(id as usize)).collect();
    let sides = edge_rails(page.mesh(), &edges).expect("a loop");
    let depth = |page: &mut Page, at: Vec3| page.app().script().project(at.to_array()).map(|[_, y]| y);
    // The lowest on the screen is in front: the camera looks down.
    let rails: Vec<VertexId> = sides[0].iter().map(|rail| rail.vertex).collect();
    let mut front = rails[0];
    for &v in &rails {
        let [a, b] = [v, front].map(|v| {
            let at = place(&mut page, v);
            depth(&mut page, at).unwrap_or_default()
        });
        if a > b {
            front = v;
        }
    }
    let to =
        |side: &Vec<halfedge::edit::Rail>| side.iter().find(|rail| rail.vertex == front).map(|rail| rail.to);
    let ends = sides.each_ref().map(|side| to(side).expect("quads on both sides"));
    (page, front, ends)
}

#[test]
fn edges_follow_the_pointer_to_either_side_and_are_one_step() {
    // In a high window the bar of the edit lies below what moves.
    let (mut page, v, ends) = with_loop(Page::sized(vec2(1600.0, 1200.0)));
    let (before, selected, steps) = (page.mesh().clone(), page.selected(), page.undo_labels());
    let from = place(&mut page, v);
    let start = on_screen(&mut page, from);
    page.hover(start);
    page.press_with(Modifiers::SHIFT, Key::V);
    assert_eq!(page.mesh(), &before, "nothing moves before the pointer does");
    page.hover(start + vec2(1.0, 0.0));
    for end in ends {
        let goal = from.lerp(end, 0.5);
        let at = on_screen(&mut page, goal);
        page.hover(at);
        let now = place(&mut page, v);
        assert!(now.distance(goal) < 0.12, "{now}, not {goal}");
        let past = on_screen(&mut page, from + (end - from) * 1.1);
        page.hover(past);
        assert_eq!(place(&mut page, v), end, "no farther than the neighbour");
    }
    let at = on_screen(&mut page, from.lerp(ends[0], 0.5));
    page.hover(at);
    let shown = page.mesh().clone();
    press_button(&mut page, at, PointerButton::Primary);
    assert_eq!(page.mesh(), &shown, "a click accepts");
    assert_eq!(page.undo_labels().len(), steps.len() + 1);
    assert_eq!(page.undo_labels().last().map(String::as_str), Some("Slide edges"));
    assert_eq!(page.selected(), selected, "the edges stay selected");
    page.hover(start);
    assert_eq!(page.mesh(), &shown);
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(page.mesh(), &before);
}

#[test]
fn a_typed_number_is_exact_and_cancelling_leaves_no_trace() {
    let (mut page, v, [left, right]) = with_loop(Page::new());
    let (before, steps) = (page.mesh().clone(), page.undo_labels());
    let from = place(&mut page, v);
    for (text, expected) in [(".25", from.lerp(left, 0.25)), ("-.5", from.lerp(right, 0.5)), ("3", left)] {
        page.press_with(Modifiers::SHIFT, Key::V);
        text.chars().for_each(|letter| page.type_text(&letter.to_string()));
        page.press(Key::Enter);
        assert_eq!(place(&mut page, v), expected, "after {text}");
        page.press_with(Modifiers::COMMAND, Key::Z);
        assert_eq!(page.mesh(), &before);
    }
    let start = on_screen(&mut page, from);
    let at = on_screen(&mut page, from.lerp(left, 0.5));
    for by_key in [true, false] {
        page.hover(start);
        page.press_with(Modifiers::SHIFT, Key::V);
        page.hover(start);
        page.hover(at);
        assert_ne!(page.mesh(), &before);
        if by_key {
            page.press(Key::Escape);
        } else {
            press_button(&mut page, at, PointerButton::Secondary);
        }
        assert_eq!(page.mesh(), &before);
        assert!(!page.has("Cancel"));
        assert_eq!(page.undo_labels(), steps);
    }
}

#[test]
fn ctrl_snaps_to_tenths_and_shift_slows() {
    let (mut page, v, [left, _]) = with_loop(Page::new());
    let from = place(&mut page, v);
    let start = on_screen(&mut page, from);
    let at = on_screen(&mut page, from.lerp(left, 0.53));
    page.hover(start);
    page.press_with(Modifiers::SHIFT, Key::V);
    page.hover(start);
    page.harness.event_modifiers(Event::PointerMoved(at), Modifiers::COMMAND);
    page.run();
    let part = (place(&mut page, v) - from).length() / (left - from).length();
    assert!((part * 10.0 - (part * 10.0).round()).abs() < 1e-4 && part > 0.3, "{part}");
    page.press(Key::Escape);
    page.hover(start);
    page.press_with(Modifiers::SHIFT, Key::V);
    page.hover(start);
    page.harness.event_modifiers(Event::PointerMoved(at), Modifiers::SHIFT);
    page.run();
    let part = (place(&mut page, v) - from).length() / (left - from).length();
    assert!(part > 0.02 && part < 0.1, "{part}");
}

#[test]
fn a_vertex_takes_the_edge_that_the_pointer_goes_along() {
    let mut page = Page::new();
    let v =
        (0..8).map(VertexId::new).find(|&v| page.mesh().position(v) == Vec3::ONE).expect("a corner in front");
    page.select("vertex", &[v.raw()]);
    let ends: Vec<Vec3> = {
        let mesh = page.mesh();
        mesh.neighbors(v).map(|to| mesh.position(to)).collect()
    };
    let start = on_screen(&mut page, Vec3::ONE);
    page.hover(start);
    page.press_with(Modifiers::SHIFT, Key::V);
    page.hover(start);
    assert_eq!(ends.len(), 3);
    for end in ends {
        let goal = Vec3::ONE.lerp(end, 0.5);
        let at = on_screen(&mut page, goal);
        page.hover(at);
        let now = place(&mut page, v);
        assert!(now.distance(goal) < 0.2, "{now}, not {goal}");
        assert!(
            (now - Vec3::ONE).cross(end - Vec3::ONE).length() < 1e-5,
            "{now} is not on the edge to {end}"
        );
    }
    page.press(Key::Enter);
    assert_eq!(page.undo_labels().last().map(String::as_str), Some("Slide vertices"));
    assert_eq!(page.selected(), (Element::Vertex, vec![v.raw()]));
}

#[test]
fn the_move_key_again_slides_what_can_slide() {
    let (mut page, v, [left, _]) = with_loop(Page::with_parameter("keys", "Blender"));
    let from = place(&mut page, v);
    let start = on_screen(&mut page, from);
    page.hover(start);
    page.press(Key::G);
    page.hover(start + vec2(0.0, 1.0));
    page.hover(start + vec2(13.0, -37.0));
    let moved = place(&mut page, v);
    assert!((moved - from).cross(left - from).length() > 1e-3, "a move leaves the edges");
    assert!(page.has_part("G slides"));
    page.press(Key::G);
    page.hover(start);
    let at = on_screen(&mut page, from.lerp(left, 0.5));
    page.hover(at);
    let now = place(&mut page, v);
    assert!((now - from).cross(left - from).length() < 1e-5, "{now} is not on its rail");
    page.press(Key::Enter);
    assert_eq!(page.undo_labels().last().map(String::as_str), Some("Slide edges"));
    assert_eq!(page.undo_labels().iter().filter(|label| *label == "Move").count(), 0);
    // Faces can't slide: the move goes on.
    page.select("face", &[0]);
    page.press(Key::G);
    page.hover(start);
    page.hover(start + vec2(20.0, 0.0));
    let moved = page.mesh().clone();
    page.press(Key::G);
    assert_eq!(page.mesh(), &moved);
    page.press(Key::Enter);
    assert_eq!(page.undo_labels().last().map(String::as_str), Some("Move"));
}

#[test]
fn every_preset_and_the_tool_bar_start_it() {
    for preset in ["Course", "Blender", "Maya"] {
        let (mut page, v, [left, _]) = with_loop(Page::with_parameter("keys", preset));
        page.press_with(Modifiers::SHIFT, Key::V);
        page.type_text("1");
        page.press(Key::Enter);
        assert_eq!(place(&mut page, v), left, "{preset}");
    }
    let (mut page, v, [left, _]) = with_loop(Page::new());
    page.click("Tool: Slide");
    page.type_text("1");
    page.click("Apply");
    assert_eq!(place(&mut page, v), left);
}

#[test]
fn what_cannot_slide_says_why() {
    let mut page = Page::new();
    let edges: Vec<u32> = page.mesh().vertex_edges(VertexId::new(0)).map(EdgeId::raw).collect();
    page.select("edge", &edges);
    let before = page.mesh().clone();
    page.press_with(Modifiers::SHIFT, Key::V);
    assert!(page.has_part("choose lines of edges that don't branch"));
    assert_eq!(page.mesh(), &before);
    assert!(!page.has("Cancel"));
}

#[test]
fn a_slide_is_drawn_with_its_amount() {
    let (mut page, v, [left, _]) = with_loop(Page::drawn(DESKTOP, egui::Theme::Dark));
    let from = place(&mut page, v);
    let start = on_screen(&mut page, from);
    page.hover(start);
    page.press_with(Modifiers::SHIFT, Key::V);
    page.hover(start);
    let before = crate::looks::picture(&mut page, "slide, at rest");
    let at = on_screen(&mut page, from.lerp(left, 0.6));
    page.hover(at);
    let after = crate::looks::picture(&mut page, "slide, a loop on a cube");
    let changed = after.pixels().zip(before.pixels()).filter(|(a, b)| a != b).count();
    assert!(changed > 300, "{changed} pixels");
}
