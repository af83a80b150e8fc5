//! Selecting what belongs together: neighbours, pieces, loops, rings and paths.

use crate::page::Page;
use crate::viewport::click_at;
use egui::{Key, Modifiers, PointerButton, Pos2, vec2};
use egui_kittest::kittest::Queryable;
use halfedge::{Element, Mesh};
use serde_json::json;

const CTRL_SHIFT: Modifiers = Modifiers::COMMAND.plus(Modifiers::SHIFT);
const CTRL_ALT: Modifiers = Modifiers::COMMAND.plus(Modifiers::ALT);

/// A grid of six by six quads, with a list shown by its key.
fn grid(list: Key) -> Page {
    let mut page = Page::new();
    page.command(json!({"op": "new", "shape": "grid", "columns": 6, "rows": 6}));
    page.press(list);
    page
}

/// The vertex in a column and row.
fn vertex(column: u32, row: u32) -> u32 {
    row * 7 + column
}

fn edge(mesh: &Mesh, a: u32, b: u32) -> u32 {
    let [a, b] = [a, b].map(|v| mesh.vertex(v).expect("there"));
    mesh.find_edge(a, b).expect("neighbours").raw()
}

/// The place on the page of the middle between two vertices.
fn between(page: &mut Page, a: u32, b: u32) -> Pos2 {
    let mesh = page.mesh();
    let [p, q] = [a, b].map(|v| mesh.position(mesh.vertex(v).expect("there")));
    page.at(((p + q) * 0.5).to_array())
}

pub fn double_click_at(page: &mut Page, at: Pos2, modifiers: Modifiers) {
    page.harness.hover_at(at);
    page.run();
    // A frame of a test is a quarter of a second, and a double click takes three.
    page.harness.ctx.options_mut(|options| options.input_options.max_double_click_delay = 0.8);
    page.harness.event(egui::Event::ModifiersChanged(modifiers));
    page.harness.step();
    for pressed in [true, false, true, false] {
        let button = PointerButton::Primary;
        page.harness.event(egui::Event::PointerButton { pos: at, button, pressed, modifiers });
        page.harness.step();
    }
    page.harness.event(egui::Event::ModifiersChanged(Modifiers::NONE));
    page.run();
}

#[test]
fn the_selection_grows_and_shrinks_by_keys() {
    let mut page = grid(Key::Num1);
    let middle = vertex(3, 3);
    page.select("vertex", &[middle]);
    page.press_with(Modifiers::COMMAND, Key::Equals);
    assert_eq!(page.selected().1.len(), 9);
    page.press_with(Modifiers::COMMAND, Key::Equals);
    assert_eq!(page.selected().1.len(), 25);
    page.press_with(Modifiers::COMMAND, Key::Minus);
    page.press_with(Modifiers::COMMAND, Key::Minus);
    assert_eq!(page.selected(), (Element::Vertex, vec![middle]));
    page.press_with(Modifiers::COMMAND, Key::L);
    assert_eq!(page.selected().1.len(), 49);
    assert!(page.undo_labels().iter().all(|label| label == "New shape"), "selecting is no edit");
}

#[test]
fn a_click_with_alt_selects_a_loop_and_with_control_a_ring() {
    let mut page = grid(Key::Num2);
    let (a, b) = (vertex(2, 2), vertex(3, 2));
    let at = between(&mut page, a, b);
    let mut row: Vec<u32> = (0..6).map(|c| edge(page.mesh(), vertex(c, 2), vertex(c + 1, 2))).collect();
    row.sort_unstable();
    let mut ring: Vec<u32> = (0..7).map(|r| edge(page.mesh(), vertex(2, r), vertex(3, r))).collect();
    ring.sort_unstable();
    click_at(&mut page, at, Modifiers::ALT);
    assert_eq!(page.selected(), (Element::Edge, row.clone()));
    click_at(&mut page, at, CTRL_ALT);
    assert_eq!(page.selected(), (Element::Edge, ring.clone()));
    click_at(&mut page, at, Modifiers::ALT.plus(Modifiers::SHIFT));
    assert_eq!(page.selected().1.len(), 6 + 7 - 1, "Shift adds the loop");
    page.press(Key::Escape);
    double_click_at(&mut page, at, Modifiers::NONE);
    assert_eq!(page.selected(), (Element::Edge, row), "so does a double-click");

    // Of vertices and faces too.
    page.press(Key::Num1);
    click_at(&mut page, at, Modifiers::ALT);
    assert_eq!(page.selected(), (Element::Vertex, (0..7).map(|c| vertex(c, 2)).collect()));
    page.press(Key::Num4);
    click_at(&mut page, at + vec2(0.0, 3.0), Modifiers::ALT);
    assert_eq!(page.selected().1.len(), 6);
    page.press(Key::Num3);
    click_at(&mut page, at + vec2(0.0, 3.0), Modifiers::ALT);
    assert_eq!(page.selected().1.len(), 4, "the half-edges of a face");
}

#[test]
fn a_click_with_control_and_shift_selects_a_path() {
    let mut page = grid(Key::Num1);
    let places = [vertex(1, 1), vertex(4, 1), vertex(4, 5)].map(|v| between(&mut page, v, v));
    click_at(&mut page, places[0], Modifiers::NONE);
    click_at(&mut page, places[1], CTRL_SHIFT);
    assert_eq!(page.selected().1, (1..=4).map(|c| vertex(c, 1)).collect::<Vec<_>>());
    click_at(&mut page, places[2], CTRL_SHIFT);
    assert_eq!(page.selected().1.len(), 4 + 4, "the path goes on from the last click");
}

#[test]
fn menus_convert_the_selection_and_say_what_is_missing() {
    let mut page = grid(Key::Num4);
    page.select("face", &[8]);
    for (entry, kind, count) in [
        ("Convert to vertices", Element::Vertex, 4),
        ("Convert to edges", Element::Edge, 4),
        ("Convert to faces", Element::Face, 1),
    ] {
        page.click("Select");
        page.click("Convert to");
        page.click(entry);
        let (now, ids) = page.selected();
        assert_eq!((now, ids.len()), (kind, count), "{entry}");
    }
    page.click("Select");
    page.click("Loops and paths");
    page.click("Select outline");
    assert_eq!(page.selected().0, Element::Edge);
    assert_eq!(page.selected().1.len(), 4);
    page.press(Key::Escape);
    page.press_with(Modifiers::COMMAND, Key::L);
    assert!(page.has_part("Select something first."), "a key says why it does nothing");
}

#[test]
fn a_box_with_control_adds_or_removes() {
    let mut page = grid(Key::Num1);
    let area = page.find("Viewport").rect();
    let (from, to) = (area.left_bottom() + vec2(10.0, -10.0), area.right_top() + vec2(-10.0, 10.0));
    page.select("vertex", &[vertex(3, 3), vertex(0, 0)]);
    let drag = |page: &mut Page, modifiers: Modifiers| {
        page.harness.hover_at(from);
        page.run();
        let button = PointerButton::Primary;
        page.harness.event_modifiers(
            egui::Event::PointerButton { pos: from, button, pressed: true, modifiers },
            modifiers,
        );
        page.run();
        page.harness.event_modifiers(egui::Event::PointerMoved(to), modifiers);
        page.run();
        page.harness.event_modifiers(
            egui::Event::PointerButton { pos: to, button, pressed: false, modifiers },
            modifiers,
        );
        page.run();
    };
    drag(&mut page, Modifiers::COMMAND);
    assert_eq!(page.selected().1.len(), 47, "the two selected ones are deselected");
    drag(&mut page, Modifiers::COMMAND);
    assert_eq!(page.selected().1, [vertex(0, 0), vertex(3, 3)]);
    page.press_with(Modifiers::SHIFT, Key::B);
    drag(&mut page, Modifiers::SHIFT);
    assert_eq!(page.selected().1.len(), 49);
}

#[test]
fn a_click_counts_with_the_modifiers_that_were_held_then() {
    let mut page = grid(Key::Num2);
    let at = between(&mut page, vertex(2, 2), vertex(3, 2));
    page.harness.hover_at(at);
    page.run();
    // In one slow frame: Alt is pressed, the edge is clicked, and Alt is let go.
    let button = |pressed| egui::Event::PointerButton {
        pos: at,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::ALT,
    };
    page.harness.input_mut().events.extend([button(true), button(false)]);
    page.harness.step();
    page.run();
    assert_eq!(page.selected().1.len(), 6, "the loop is selected");
}

#[test]
fn switching_the_kind_converts_the_selection() {
    let mut page = grid(Key::Num4);
    page.press(Key::Num1);
    assert_eq!(page.selected(), (Element::Vertex, vec![]));
    page.press(Key::Num4);
    assert_eq!(page.selected(), (Element::Face, vec![]), "nothing stays nothing");
    page.select("face", &[8]);
    let [edges, vertices] = [(Element::Edge, 4), (Element::Vertex, 4)];
    let check = |page: &mut Page, key: Key, (kind, count): (Element, usize)| {
        page.press(key);
        let (now, ids) = page.selected();
        assert_eq!((now, ids.len()), (kind, count), "{key:?}");
    };
    check(&mut page, Key::Num2, edges);
    check(&mut page, Key::Num1, vertices);
    check(&mut page, Key::Num4, (Element::Face, 1));
    check(&mut page, Key::Num1, vertices);
    // With Ctrl, to all that touches the selection.
    let faces = page.harness.get_by_role_and_label(egui::accesskit::Role::Tab, "Faces").rect().center();
    click_at(&mut page, faces, Modifiers::COMMAND);
    assert_eq!(page.selected().1.len(), 9);
    assert!(page.undo_labels().iter().all(|label| label == "New shape"));
}

#[test]
fn undo_steps_back_through_selections_and_edits() {
    let mut page = grid(Key::Num1);
    let at = between(&mut page, vertex(3, 3), vertex(3, 3));
    click_at(&mut page, at, Modifiers::NONE);
    page.press_with(Modifiers::COMMAND, Key::Equals);
    page.press(Key::Delete);
    let edited = page.mesh().vertex_count();
    assert_eq!(page.undo_labels(), ["New shape", "Delete vertices"]);
    page.press(Key::Num4);
    page.press_with(Modifiers::COMMAND, Key::A);
    let undo = |page: &mut Page| page.press_with(Modifiers::COMMAND, Key::Z);
    undo(&mut page);
    assert_eq!((page.selected().1.len(), page.mesh().vertex_count()), (0, edited));
    undo(&mut page);
    assert_eq!(page.selected().1.len(), 9, "the edit is undone");
    undo(&mut page);
    assert_eq!(page.selected(), (Element::Vertex, vec![vertex(3, 3)]));
    undo(&mut page);
    assert!(page.selected().1.is_empty());
    for _ in 0..4 {
        page.press_with(Modifiers::COMMAND, Key::Y);
    }
    assert_eq!((page.selected().1.len(), page.mesh().vertex_count()), (20, edited));
}
