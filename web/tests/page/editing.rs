//! Editing by hand: symmetry, pivots, the walk along a half-edge, and what an emptied document says.

use crate::page::{DESKTOP, PHONE, Page};
use egui::{Key, Modifiers, vec2};
use egui_kittest::kittest::Queryable;
use glam::Vec3;
use halfedge::Element;
use serde_json::json;

/// Chooses an entry of a submenu of the Transform menu.
fn choose(page: &mut Page, submenu: &str, entry: &str) {
    page.click("Transform");
    page.click(submenu);
    page.harness.get_by_label_contains(entry).click();
    page.run();
}

/// The face of the cube whose corners all have this coordinate.
fn face_at(page: &mut Page, axis: usize, coordinate: f32) -> u32 {
    let mesh = page.mesh();
    let is_there =
        |f: &halfedge::FaceId| mesh.face_vertices(*f).all(|v| mesh.position(v)[axis] == coordinate);
    mesh.faces().find(is_there).expect("a face of the cube").raw()
}

fn bounds(page: &mut Page) -> [Vec3; 2] {
    let positions = page.mesh().positions();
    let low = positions.iter().copied().reduce(Vec3::min).expect("vertices");
    [low, positions.iter().copied().reduce(Vec3::max).expect("vertices")]
}

#[test]
fn with_symmetry_keys_forms_and_colours_act_on_both_sides() {
    let mut page = Page::new();
    choose(&mut page, "Symmetry", "Symmetry along x");
    let right = face_at(&mut page, 0, 1.0);
    page.select("face", &[right]);
    page.press(Key::E);
    page.hover_off_middle(vec2(0.0, 0.0));
    page.hover_off_middle(vec2(60.0, 0.0));
    page.type_text("0.5");
    assert!(page.has_part("mirrored along x"));
    let [low, high] = bounds(&mut page);
    assert_eq!([low.x, high.x], [-1.5, 1.5]);
    page.press(Key::Enter);
    assert_eq!(page.undo_labels().len(), 1, "both sides are one step");
    // What starts at once acts on both sides too.
    let faces = page.mesh().face_count();
    page.press(Key::Delete);
    assert_eq!(page.mesh().face_count(), faces - 2);
    page.press_with(Modifiers::COMMAND, Key::Z);
    page.press_with(Modifiers::COMMAND, Key::Z);
    // Without it, one side is edited.
    choose(&mut page, "Symmetry", "No symmetry");
    page.select("face", &[right]);
    page.press(Key::E);
    page.type_text("0.5");
    page.press(Key::Enter);
    let [low, high] = bounds(&mut page);
    assert_eq!([low.x, high.x], [-1.0, 1.5]);
}

#[test]
fn what_has_no_mirror_image_changes_alone_and_the_page_says_so() {
    let mut page = Page::new();
    let corner = page.mesh().positions().iter().position(|p| *p == Vec3::ONE).expect("a corner");
    page.command(json!({"op": "set-vertex-position", "vertex": corner, "position": [1.5, 1.25, 1.0]}));
    choose(&mut page, "Symmetry", "Symmetry along x");
    page.select("vertex", &[corner as u32]);
    page.press(Key::G);
    page.press(Key::Y);
    page.type_text("1");
    page.press(Key::Enter);
    assert_eq!(page.mesh().positions()[corner], Vec3::new(1.5, 2.25, 1.0));
    page.press_with(Modifiers::COMMAND, Key::Z);
    page.press_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::B);
    page.type_text("0.1");
    page.press(Key::Enter);
    assert!(page.has_part("no mirror image along x"));
}

#[test]
fn each_pivot_keeps_its_point() {
    // Two vertices of the top: the mean and the middle of their box differ from the one selected last.
    let top = |page: &mut Page| {
        let mesh = page.mesh();
        let at = |x: f32, z: f32| mesh.positions().iter().position(|p| *p == Vec3::new(x, 1.0, z));
        [at(1.0, 1.0), at(-1.0, 1.0), at(1.0, -1.0)].map(|id| id.expect("a corner") as u32)
    };
    let mean = Vec3::new(1.0, 3.0, 1.0) / 3.0;
    let cases = [
        ("Pivot: median", mean),
        ("Pivot: bounding box", Vec3::new(0.0, 1.0, 0.0)),
        ("Pivot: origin", Vec3::ZERO),
    ];
    for (entry, pivot) in cases {
        let mut page = Page::new();
        choose(&mut page, "Pivot", entry);
        let ids = top(&mut page);
        page.select("vertex", &ids);
        let before = page.mesh().clone();
        page.press_with(Modifiers::SHIFT, Key::D);
        page.type_text("0.5");
        page.press(Key::Enter);
        for id in ids {
            let v = before.vertex(id).expect("a vertex");
            let wanted = pivot + (before.position(v) - pivot) * 0.5;
            assert!(page.mesh().position(v).distance(wanted) < 1e-5, "{entry}: {}", page.mesh().position(v));
        }
    }
    // The element selected last stays where it is.
    let mut page = Page::new();
    choose(&mut page, "Pivot", "Pivot: last selected");
    let ids = top(&mut page);
    page.select("vertex", &[ids[0], ids[2]]);
    let selected = [ids[0], ids[2]];
    let before = page.mesh().clone();
    page.press_with(Modifiers::SHIFT, Key::D);
    page.type_text("0.5");
    page.press(Key::Enter);
    let after = page.mesh().clone();
    let moved = |id: &u32| before.vertex(*id).is_some_and(|v| after.position(v) != before.position(v));
    let ids: Vec<u32> = selected.into_iter().filter(|id| moved(id)).collect();
    assert_eq!(ids.len(), 1, "the one selected last stays");
}

#[test]
fn in_the_study_layout_keys_walk_from_a_half_edge_to_what_belongs_to_it() {
    let mut page = Page::sized(DESKTOP);
    page.click("View");
    page.click("Layout");
    page.harness.get_by_label_contains("Study").click();
    page.run();
    let h = page.mesh().edges().next().expect("an edge").halfedge();
    let (from, face) = (page.mesh().from(h).raw(), page.mesh().face_of(h).expect("a face").raw());
    let wanted = [
        (Key::V, Element::Vertex, from),
        (Key::Y, Element::Edge, h.edge().raw()),
        (Key::A, Element::Face, face),
    ];
    for (key, kind, id) in wanted {
        page.select("halfedge", &[h.raw()]);
        page.press(key);
        assert_eq!(page.selected(), (kind, vec![id]), "{key:?}");
    }
}

#[test]
fn an_emptied_document_says_what_to_do() {
    let mut page = Page::drawn(DESKTOP, egui::Theme::Dark);
    page.select("face", &[0, 1, 2, 3, 4, 5]);
    page.press(Key::Delete);
    assert_eq!(page.mesh().face_count(), 0);
    assert!(page.has("Nothing is left of the model"));
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert!(!page.has("Nothing is left of the model"));
}

#[test]
fn a_finger_drags_an_edit_and_its_buttons_end_it() {
    let mut page = Page::sized(PHONE);
    let before = page.mesh().clone();
    let steps = page.undo_labels().len();
    for (button, count) in [("Cancel", 0), ("Apply", 1)] {
        page.select("face", &[0]);
        let tool = page.find("Tool: Extrude").rect().center();
        page.tap(tool);
        let from = page.find("Viewport").rect().center();
        page.touch(from);
        for part in 1..=6 {
            page.move_finger(from + vec2(5.0, -12.0) * part as f32);
        }
        page.lift_finger(from + vec2(30.0, -72.0));
        let shown = page.mesh().clone();
        assert_eq!(shown.face_count(), before.face_count() + 4, "the finger edits");
        let at = page.find(button).rect().center();
        page.touch(at);
        assert_eq!(page.mesh(), &shown, "a finger on {button} moves nothing");
        page.lift_finger(at);
        let expected = if count == 0 { &before } else { &shown };
        assert_eq!(page.mesh(), expected, "{button}");
        assert_eq!(page.undo_labels().len(), steps + count);
    }
}
