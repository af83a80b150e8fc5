//! Edits that follow the pointer, and adjusting the last operation.

use crate::page::{DESKTOP, PHONE, Page};
use egui::{Event, Key, vec2};
use egui_kittest::kittest::Queryable;
use glam::Vec3;
use halfedge::Element;
use serde_json::json;

fn cube_face() -> Page {
    let mut page = Page::new();
    page.select("face", &[0]);
    page
}

#[test]
fn extruding_follows_the_pointer_and_is_one_step() {
    let mut page = cube_face();
    let before = page.mesh().clone();
    let steps = page.undo_labels();
    page.press(Key::E);
    assert_eq!(page.mesh(), &before, "nothing moves before the pointer does");
    page.hover_off_middle(vec2(0.0, 0.0));
    page.hover_off_middle(vec2(40.0, 0.0));
    assert_eq!(page.mesh().face_count(), 10);
    let near = page.mesh().clone();
    page.hover_off_middle(vec2(80.0, 0.0));
    assert_ne!(page.mesh(), &near, "the distance follows");
    assert_eq!(page.mesh().face_count(), 10, "and replaces the one before");
    page.press(Key::Enter);
    assert_eq!(page.undo_labels().len(), steps.len() + 1);
    let done = page.mesh().clone();
    page.hover_off_middle(vec2(-80.0, 0.0));
    assert_eq!(page.mesh(), &done, "Enter ends it");
    page.press_with(egui::Modifiers::COMMAND, Key::Z);
    assert_eq!(page.mesh(), &before);
}

#[test]
fn the_preview_changes_only_when_the_pointer_moves() {
    let mut page = cube_face();
    page.press_with(egui::Modifiers::SHIFT, Key::I);
    page.hover_off_middle(vec2(0.0, 0.0));
    page.hover_off_middle(vec2(15.0, 0.0));
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
    page.hover_off_middle(vec2(0.0, 0.0));
    page.hover_off_middle(vec2(15.0, 0.0));
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
        page.type_text(digit);
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
    page.type_text("1");
    page.click("Cancel");
    assert_eq!(page.mesh().face_count(), 6);
    page.press(Key::E);
    page.type_text("1");
    page.click("Apply");
    assert_eq!(page.mesh().face_count(), 10);
}

#[test]
fn the_bar_lies_at_the_bottom_of_the_viewport() {
    for size in [DESKTOP, PHONE] {
        let mut page = Page::sized(size);
        page.select("face", &[0]);
        page.press(Key::G);
        page.run();
        let (viewport, apply) = (page.find("Viewport").rect(), page.find("Apply").rect());
        assert!(viewport.contains_rect(apply) && apply.top() > viewport.bottom() - 110.0, "{apply}");
        let axis = page.harness.query_by_label("View from the front").map(|ball| ball.rect());
        assert_eq!(axis.is_some(), size == DESKTOP, "a telephone has no room for it");
        assert!(axis.is_none_or(|axis| !axis.intersects(apply)));
    }
}

#[test]
fn a_script_that_selects_ends_the_edit_of_what_was_selected() {
    let mut page = Page::new();
    let start = page.mesh().clone();
    page.select("vertex", &[0]);
    page.press(Key::G);
    page.hover_off_middle(vec2(0.0, 0.0));
    page.hover_off_middle(vec2(30.0, 0.0));
    let moved = page.mesh().clone();
    assert_ne!(moved, start);
    page.select("vertex", &[7]);
    page.hover_off_middle(vec2(90.0, 40.0));
    assert_eq!(page.mesh(), &moved, "what was moved stays, and nothing follows the pointer");
    assert!(!page.has("Apply"));
    assert_eq!(page.selected(), (Element::Vertex, vec![7]));
}

#[test]
fn keys_depend_on_the_selection() {
    let mut page = Page::new();
    page.select("vertex", &[0]);
    page.press(Key::B);
    page.type_text(".2");
    page.press(Key::Enter);
    assert_eq!((page.mesh().vertex_count(), page.mesh().face_count()), (10, 7));

    page.select("vertex", &[1]);
    page.press(Key::G);
    page.hover_off_middle(vec2(0.0, 0.0));
    let before = page.mesh().clone();
    page.hover_off_middle(vec2(30.0, 20.0));
    page.press(Key::Enter);
    let moved = page.mesh().positions().iter().zip(before.positions()).filter(|(a, b)| a != b).count();
    assert_eq!(moved, 1);
}

/// The mean position of the vertices of the mesh.
fn middle(page: &mut Page) -> Vec3 {
    let positions = page.mesh().positions();
    positions.iter().sum::<Vec3>() / positions.len() as f32
}

fn all_vertices(page: &mut Page) {
    page.select("vertex", &[0, 1, 2, 3, 4, 5, 6, 7]);
}

#[test]
fn numbers_are_typed_along_locked_axes() {
    let mut page = Page::new();
    all_vertices(&mut page);
    let start = middle(&mut page);
    let mut moved_by = |keys: &[Key], texts: &[&str]| {
        page.press(Key::G);
        keys.iter().for_each(|key| page.press(*key));
        for text in texts {
            if *text == "Tab" { page.press(Key::Tab) } else { page.type_text(text) }
        }
        page.press(Key::Enter);
        let moved = middle(&mut page) - start;
        page.press_with(egui::Modifiers::COMMAND, Key::Z);
        assert!(middle(&mut page).distance(start) < 1e-6, "undone");
        moved
    };
    assert!(moved_by(&[Key::Y], &["1", "/", "4"]).distance(Vec3::new(0.0, 0.25, 0.0)) < 1e-5);
    assert!(moved_by(&[], &["1", "Tab", "2", "Tab", "-", "3"]).distance(Vec3::new(1.0, 2.0, -3.0)) < 1e-5);
    assert!(
        moved_by(&[Key::X, Key::Z], &["2"]).distance(Vec3::new(0.0, 0.0, 2.0)) < 1e-5,
        "the last lock counts"
    );
}

#[test]
fn a_plane_lock_keeps_its_axis() {
    let mut page = Page::new();
    all_vertices(&mut page);
    let start = middle(&mut page);
    page.press(Key::G);
    page.hover_off_middle(vec2(0.0, 0.0));
    page.press_with(egui::Modifiers::SHIFT, Key::Y);
    page.hover_off_middle(vec2(50.0, 30.0));
    page.press(Key::Enter);
    let moved = middle(&mut page) - start;
    assert!(moved.y == 0.0 && moved.x.abs() > 0.05 && moved.z.abs() > 0.05, "{moved}");
}

#[test]
fn scaling_along_y_takes_three_keys() {
    let mut page = Page::new();
    all_vertices(&mut page);
    page.press_with(egui::Modifiers::SHIFT, Key::D);
    page.press(Key::Y);
    page.type_text(".75");
    page.press(Key::Enter);
    assert!(
        page.mesh().positions().iter().all(|p| p.x.abs() == 1.0 && p.y.abs() == 0.75 && p.z.abs() == 1.0)
    );
    assert_eq!(page.undo_labels().len(), 1, "one step");
}

#[test]
fn rotating_takes_degrees_and_axes() {
    let mut page = Page::new();
    page.select("vertex", &[7]);
    let before = page.mesh().position(halfedge::VertexId::new(7));
    page.command(serde_json::json!({ "op": "transform", "vertices": [7], "translate": [1, 0, 0] }));
    page.press_with(egui::Modifiers::COMMAND, Key::Z);
    all_vertices(&mut page);
    page.press_with(egui::Modifiers::SHIFT, Key::R);
    page.press(Key::Z);
    page.type_text("90");
    page.press(Key::Enter);
    let after = page.mesh().position(halfedge::VertexId::new(7));
    assert!(after.distance(Vec3::new(-before.y, before.x, before.z)) < 1e-5, "{before} became {after}");
}

#[test]
fn the_pointer_turns_and_scales_about_the_middle() {
    let mut page = Page::new();
    all_vertices(&mut page);
    let centre = page.at([0.0, 0.0, 0.0]);
    let to = |page: &mut Page, by: egui::Vec2| {
        page.harness.hover_at(centre + by);
        page.run();
    };
    page.press_with(egui::Modifiers::SHIFT, Key::D);
    to(&mut page, vec2(100.0, 0.0));
    to(&mut page, vec2(0.0, 50.0));
    page.press(Key::Enter);
    assert!(page.mesh().positions().iter().all(|p| (p.abs() - Vec3::splat(0.5)).abs().max_element() < 1e-3));
    page.press_with(egui::Modifiers::COMMAND, Key::Z);

    page.press_with(egui::Modifiers::SHIFT, Key::R);
    page.press(Key::Y);
    // A whole turn, in steps: y points at the viewer's side, so counter-clockwise is positive.
    for step in 0..=8 {
        let angle = step as f32 * std::f32::consts::TAU / 8.0;
        to(&mut page, vec2(angle.cos(), -angle.sin()) * 90.0);
    }
    assert!(page.mesh().positions().iter().all(|p| (p.abs() - Vec3::ONE).abs().max_element() < 1e-3));
    to(&mut page, vec2(1.0, 1.0) * 60.0);
    page.press(Key::Enter);
    let turned = page.mesh().positions().iter().map(|p| p.x.abs()).fold(0.0, f32::max);
    assert!((turned - 2f32.sqrt()).abs() < 2e-3, "an eighth of a turn: {turned}");
}

#[test]
fn ctrl_snaps_turns_to_five_degrees() {
    let mut page = Page::new();
    all_vertices(&mut page);
    let centre = page.at([0.0, 0.0, 0.0]);
    page.press_with(egui::Modifiers::SHIFT, Key::R);
    page.press(Key::Y);
    for (at, modifiers) in [(0.0, egui::Modifiers::NONE), (0.13, egui::Modifiers::COMMAND)] {
        let place = centre + egui::Vec2::angled(at) * 100.0;
        page.harness.event_modifiers(Event::PointerMoved(place), modifiers);
        page.run();
    }
    page.press(Key::Enter);
    // 0.13 radians are 7.4 degrees, which is nearest to 5.
    for p in page.mesh().positions() {
        let degrees = p.x.abs().atan2(p.z.abs()).to_degrees();
        assert!((degrees - 40.0).abs() < 1e-3 || (degrees - 50.0).abs() < 1e-3, "{degrees}");
    }
}

#[test]
fn the_amount_follows_any_direction() {
    let mut page = cube_face();
    for (key, modifiers) in [(Key::I, egui::Modifiers::SHIFT), (Key::B, egui::Modifiers::NONE)] {
        for by in [vec2(-25.0, 0.0), vec2(0.0, 25.0), vec2(25.0, -5.0)] {
            let before = page.mesh().clone();
            let start = if key == Key::B { ("edge", [0]) } else { ("face", [0]) };
            page.select(start.0, &start.1);
            page.press_with(modifiers, key);
            page.hover_off_middle(vec2(0.0, 0.0));
            page.hover_off_middle(by);
            page.press(Key::Enter);
            assert_ne!(page.mesh(), &before, "{key:?} by {by}");
            page.press_with(egui::Modifiers::COMMAND, Key::Z);
            assert_eq!(page.mesh(), &before);
        }
    }
}

#[test]
fn a_face_is_extruded_towards_where_its_normal_points_on_the_screen() {
    let mut page = Page::new();
    for face in 0..6 {
        page.select("face", &[face]);
        let mesh = page.mesh().clone();
        let corners: Vec<Vec3> =
            mesh.face_vertices(mesh.face(face).expect("a face")).map(|v| mesh.position(v)).collect();
        let middle = corners.iter().sum::<Vec3>() / 4.0;
        let (from, to) = (page.at(middle.to_array()), page.at((middle * 1.5).to_array()));
        page.harness.hover_at(from);
        page.run();
        page.press(Key::E);
        page.harness.hover_at(to);
        page.run();
        page.press(Key::Enter);
        let far = page.mesh().positions().iter().map(|p| p.abs().max_element()).fold(0.0, f32::max);
        assert!((far - 1.5).abs() < 0.15, "face {face} went to {far}");
        page.press_with(egui::Modifiers::COMMAND, Key::Z);
    }
}

#[test]
fn a_right_click_cancels_without_a_menu() {
    let mut page = cube_face();
    let before = page.mesh().clone();
    page.press(Key::E);
    page.hover_off_middle(vec2(0.0, 0.0));
    page.hover_off_middle(vec2(40.0, -40.0));
    assert_ne!(page.mesh(), &before);
    let at = page.harness.get_by_label("Viewport").rect().center() + vec2(40.0, -40.0);
    for pressed in [true, false] {
        page.harness.event(Event::PointerButton {
            pos: at,
            button: egui::PointerButton::Secondary,
            pressed,
            modifiers: egui::Modifiers::NONE,
        });
        page.run();
    }
    assert_eq!(page.mesh(), &before);
    assert!(!page.has("Cancel"), "the bar is gone");
    assert!(!egui::Popup::is_any_open(&page.harness.ctx), "and there is no menu");
}

#[test]
fn the_wheel_sets_the_segments_of_a_bevel() {
    let mut page = Page::new();
    page.select("edge", &[0]);
    page.press(Key::B);
    page.type_text("0.2");
    let faces = page.mesh().face_count();
    page.hover_off_middle(vec2(0.0, 0.0));
    page.turn_wheel(egui::MouseWheelUnit::Line, 1.0);
    assert_eq!(page.mesh().face_count(), faces + 1, "two segments");
    page.press(Key::Enter);
}

#[test]
fn dragging_a_selected_element_of_any_kind_moves_it() {
    for (kind, at, moved) in
        [("vertex", [1.0, 1.0, 1.0], 1), ("edge", [1.0, 1.0, 0.0], 2), ("face", [0.0, 1.0, 0.0], 4)]
    {
        let mut page = Page::new();
        let mode = match kind {
            "vertex" => Key::Num1,
            "edge" => Key::Num2,
            _ => Key::Num4,
        };
        page.press(mode);
        let at = page.at(at);
        page.harness.hover_at(at);
        page.run();
        page.harness.drag_at(at);
        page.run();
        page.drop(at);
        let (_, ids) = page.selected();
        assert_eq!(ids.len(), 1, "{kind}");
        let before = page.mesh().positions().to_vec();
        page.drag(at, at + vec2(40.0, 10.0));
        page.drop(at + vec2(40.0, 10.0));
        let changed = page.mesh().positions().iter().zip(&before).filter(|(a, b)| a != b).count();
        assert_eq!(changed, moved, "{kind}");
        assert_eq!(page.undo_labels().len(), 1, "one step for {kind}");
    }
}

#[test]
fn each_part_turns_about_its_own_middle() {
    let mut page = Page::new();
    page.app().script();
    page.click("Transform");
    page.harness.get_by_label("Pivot").click();
    page.run();
    page.harness.get_by_label_contains("Pivot: each part").click();
    page.run();
    // Two opposite faces.
    page.select("face", &[0]);
    let mesh = page.mesh().clone();
    let corners = |f: u32| mesh.face_vertices(mesh.face(f).expect("a face")).collect::<Vec<_>>();
    let other = (1..6).find(|f| corners(*f).iter().all(|v| !corners(0).contains(v))).expect("a face across");
    page.select("face", &[0, other]);
    page.press_with(egui::Modifiers::SHIFT, Key::D);
    page.type_text("0.5");
    page.press(Key::Enter);
    for f in [0, other] {
        let normal =
            halfedge::geometry::face_area_vector(&mesh, mesh.face(f).expect("a face")).as_vec3().normalize();
        for v in corners(f) {
            assert!((page.mesh().position(v).dot(normal) - 1.0).abs() < 1e-5, "the face stays in its plane");
            assert!((page.mesh().position(v).length() - 1.5f32.sqrt()).abs() < 1e-5);
        }
    }
}

#[test]
fn moving_snaps_to_a_vertex() {
    let mut page = Page::new();
    page.click("Transform");
    page.harness.get_by_label("Snap to").click();
    page.run();
    page.harness.get_by_label_contains("Snap to vertices").click();
    page.run();
    page.press(Key::Num1);
    let [from, to] = [page.at([1.0, 1.0, 1.0]), page.at([1.0, 1.0, -1.0])];
    let id = page.mesh().positions().iter().position(|p| *p == Vec3::ONE).expect("a corner") as u32;
    page.select("vertex", &[id]);
    page.press(Key::G);
    page.harness.hover_at(from);
    page.run();
    let near = Event::PointerMoved(to + vec2(5.0, -3.0));
    page.harness.event_modifiers(near, egui::Modifiers::COMMAND);
    page.run();
    page.press(Key::Enter);
    let at = page.mesh().position(halfedge::VertexId::new(id as usize));
    assert_eq!(at, Vec3::new(1.0, 1.0, -1.0));
}

#[test]
fn moving_snaps_to_the_grid_from_a_place_beside_it() {
    let mut page = Page::new();
    transform_menu(&mut page, "Snap to", "Snap to grid");
    page.command(json!({ "op": "set-vertex-position", "vertex": 0, "position": [-1.03, -1.07, -0.98] }));
    page.select("vertex", &[0]);
    page.press(Key::G);
    page.hover_off_middle(vec2(0.0, 0.0));
    let to = page.at([0.0, 0.0, 0.0]) + vec2(57.0, 31.0);
    page.harness.event_modifiers(Event::PointerMoved(to), egui::Modifiers::COMMAND);
    page.run();
    page.press(Key::Enter);
    let at = page.mesh().position(halfedge::VertexId::new(0));
    let steps = at * 10.0;
    assert!(at.distance(Vec3::new(-1.03, -1.07, -0.98)) > 0.1, "{at} has moved");
    assert!((steps - steps.round()).abs().max_element() < 1e-3, "{at}");
}

#[test]
fn moving_snaps_to_edges_and_faces_but_not_to_what_moves() {
    let corner = |page: &mut Page| {
        page.mesh().positions().iter().position(|p| *p == Vec3::ONE).expect("a corner") as u32
    };
    // Near the edge along z through (1, -1), and on the face at z = 1.
    for (entry, place) in [("Snap to edges", [1.0, -1.0, 0.25]), ("Snap to faces", [-0.5, -0.5, 1.0])] {
        let mut page = Page::new();
        transform_menu(&mut page, "Snap to", entry);
        let (from, to) = (page.at([1.0, 1.0, 1.0]), page.at(place));
        let id = corner(&mut page);
        page.select("vertex", &[id]);
        page.press(Key::G);
        page.harness.hover_at(from);
        page.run();
        page.harness.event_modifiers(Event::PointerMoved(to), egui::Modifiers::COMMAND);
        page.run();
        page.press(Key::Enter);
        let at = page.mesh().position(halfedge::VertexId::new(id as usize));
        if entry == "Snap to edges" {
            assert!(at.distance(Vec3::from(place)) < 0.02, "{at}");
        } else {
            // That face has the moved corner, and hides nothing: the face behind it counts.
            assert!((at - Vec3::from(place)).length() > 0.5, "{at}");
            assert!(at.x == -1.0 || at.y == -1.0 || at.z == -1.0, "on a face that stays: {at}");
        }
    }
}

#[test]
fn a_split_slides_along_its_edge() {
    let mut page = Page::new();
    page.select("edge", &[0]);
    page.press_with(egui::Modifiers::SHIFT, Key::S);
    assert_eq!(page.mesh().vertex_count(), 9, "in the middle at first");
    let middle = page.mesh().positions().last().copied();
    page.hover_off_middle(vec2(0.0, 0.0));
    page.hover_off_middle(vec2(40.0, 0.0));
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
    page.type_text("0.1");
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
        serde_json::json!({ "op": "transform", "vertices": [5], "scale": [0.51556, 1.23456, 1],
            "rotate": { "axis": [0.5155548, -0.4077604, 0.753567], "degrees": -123.4567 } }),
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

/// Chooses an entry of a submenu of the Transform menu.
fn transform_menu(page: &mut Page, submenu: &str, entry: &str) {
    page.click("Transform");
    page.click(submenu);
    page.harness.get_by_label_contains(entry).click();
    page.run();
}

#[test]
fn the_gizmo_moves_along_the_axis_of_its_arrow() {
    let mut page = Page::new();
    all_vertices(&mut page);
    transform_menu(&mut page, "Gizmo", "Move gizmo");
    let start = middle(&mut page);
    // From the middle of the arrow along x, twice as far.
    let [centre, right] = [page.at([0.0, 0.0, 0.0]), page.at([1.0, 0.0, 0.0])];
    let way = (right - centre).normalized();
    let from = centre + way * 50.0;
    page.drag(from, from + way * 60.0 + vec2(way.y, -way.x) * 25.0);
    page.drop(from + way * 60.0 + vec2(way.y, -way.x) * 25.0);
    let moved = middle(&mut page) - start;
    assert!(moved.x > 0.2 && moved.y == 0.0 && moved.z == 0.0, "{moved}");
    assert_eq!(page.undo_labels().len(), 1, "one step");
    // Beside the gizmo, a drag still turns the view.
    let before = page.mesh().clone();
    page.drag(centre + vec2(250.0, 200.0), centre + vec2(200.0, 150.0));
    page.drop(centre + vec2(200.0, 150.0));
    assert_eq!(page.mesh(), &before);
}

#[test]
fn the_gizmos_ring_rotates_and_its_boxes_scale() {
    let mut page = Page::new();
    all_vertices(&mut page);
    let centre = page.at([0.0, 0.0, 0.0]);
    transform_menu(&mut page, "Gizmo", "Rotate gizmo");
    let ring = 84.0 * 1.15;
    let (from, to) = (centre + vec2(ring, 0.0), centre + vec2(0.0, ring));
    page.drag(from, to);
    page.drop(to);
    let forward = page.mesh().positions().iter().map(|p| p.length()).fold(0.0, f32::max);
    assert!((forward - 3f32.sqrt()).abs() < 1e-4, "a rotation keeps lengths");
    assert!(page.mesh().positions().iter().any(|p| (p.x.abs() - 1.0).abs() > 0.1));
    page.press_with(egui::Modifiers::COMMAND, Key::Z);

    transform_menu(&mut page, "Gizmo", "Scale gizmo");
    let up = (page.at([0.0, 1.0, 0.0]) - centre).normalized();
    page.drag(centre + up * 60.0, centre + up * 120.0);
    page.drop(centre + up * 120.0);
    assert!(page.mesh().positions().iter().all(|p| p.x.abs() == 1.0 && p.z.abs() == 1.0));
    let tall = page.mesh().positions().iter().map(|p| p.y.abs()).fold(0.0, f32::max);
    assert!((tall - 2.0).abs() < 0.05, "twice as far is twice as tall: {tall}");
}

#[test]
fn gizmos_and_locks_look_right() {
    for (theme, name) in [(egui::Theme::Dark, "dark"), (egui::Theme::Light, "light")] {
        let mut page = Page::drawn(crate::page::DESKTOP, theme);
        page.select("face", &[0, 3]);
        for entry in ["Move gizmo", "Rotate gizmo", "Scale gizmo"] {
            transform_menu(&mut page, "Gizmo", entry);
            crate::looks::picture(&mut page, &format!("{entry} {name}"));
        }
        page.press(Key::G);
        page.hover_off_middle(vec2(0.0, 0.0));
        page.press(Key::X);
        page.hover_off_middle(vec2(40.0, -30.0));
        crate::looks::picture(&mut page, &format!("moving along x {name}"));
        page.press(Key::Escape);
    }
}

#[test]
fn a_move_follows_back_and_forth() {
    let mut page = Page::new();
    page.select("vertex", &[7]);
    page.hover_off_middle(vec2(-200.0, -100.0));
    page.press(Key::G);
    for step in 1..=4 {
        page.hover_off_middle(vec2(-200.0, -100.0) + vec2(30.0, -30.0) * (step as f32 / 4.0));
    }
    let far = page.mesh().clone();
    page.hover_off_middle(vec2(-185.0, -115.0));
    assert_ne!(page.mesh(), &far);
    page.press(Key::Escape);
}

#[test]
fn with_symmetry_the_mirror_image_follows_the_pointer() {
    let mut page = Page::new();
    let before = page.mesh().positions().to_vec();
    let corner = |x: f32| before.iter().position(|p| *p == Vec3::new(x, 1.0, 1.0)).expect("a corner");
    let (right, left) = (corner(1.0), corner(-1.0));
    page.click("Transform");
    page.click("Symmetry");
    page.click("Symmetry along x");
    page.select("vertex", &[right as u32]);
    page.press(Key::G);
    page.hover_off_middle(vec2(0.0, 0.0));
    page.hover_off_middle(vec2(40.0, 30.0));
    assert!(page.has_part("mirrored along x"));
    let during = page.mesh().positions().to_vec();
    assert_ne!(during[right], before[right]);
    assert_eq!(during[left], during[right] * Vec3::new(-1.0, 1.0, 1.0));
    page.press(Key::Escape);
    assert_eq!(page.mesh().positions(), before);
}

#[test]
fn soft_selection_switched_during_an_edit_shows_at_once() {
    let mut page = Page::new();
    page.command(serde_json::json!({ "op": "new", "shape": "grid", "columns": 8, "rows": 8 }));
    page.select("vertex", &[40]);
    page.press(Key::G);
    page.hover_off_middle(vec2(0.0, 0.0));
    page.hover_off_middle(vec2(0.0, -60.0));
    let hard = page.mesh().clone();
    page.press_with(egui::Modifiers::SHIFT, Key::O);
    let soft = page.mesh().clone();
    let moved =
        |mesh: &halfedge::Mesh| mesh.vertices().filter(|&v| mesh.position(v) != hard.position(v)).count();
    assert!(moved(&soft) > 3, "the vertices around it follow: {}", moved(&soft));
    page.press_with(egui::Modifiers::SHIFT, Key::O);
    assert_eq!(page.mesh(), &hard);
    page.press(Key::Enter);
    assert_eq!(page.mesh(), &hard);
}
