//! The viewport's gestures, and what fits on the screen.

use crate::page::{DESKTOP, PHONE, Page, wheel};
use egui::{Key, Modifiers, Pos2, Rect, pos2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use halfedge::{Element, VertexId};
use serde_json::json;

/// The vertex of the cube that is nearest to the eye, and where it is in the window.
pub fn nearest_vertex(page: &mut Page) -> (u32, Pos2) {
    let view = page.app().script().state()["view"].clone();
    let number = |name: &str| view[name].as_f64().expect("a number");
    let (yaw, pitch) = (number("yaw"), number("pitch"));
    let back =
        glam::vec3((yaw.sin() * pitch.cos()) as f32, pitch.sin() as f32, (yaw.cos() * pitch.cos()) as f32);
    let mesh = page.mesh();
    let nearest =
        mesh.vertices().max_by(|&a, &b| mesh.position(a).dot(back).total_cmp(&mesh.position(b).dot(back)));
    let v = nearest.expect("a cube has vertices");
    let at = mesh.position(v).to_array();
    (v.raw(), page.at(at))
}

pub fn click_at(page: &mut Page, at: Pos2, modifiers: Modifiers) {
    click_with(page, at, egui::PointerButton::Primary, modifiers);
}

pub fn click_with(page: &mut Page, at: Pos2, button: egui::PointerButton, modifiers: Modifiers) {
    page.harness.hover_at(at);
    page.run();
    for pressed in [true, false] {
        page.harness
            .event_modifiers(egui::Event::PointerButton { pos: at, button, pressed, modifiers }, modifiers);
    }
    page.run();
}

#[test]
fn a_click_selects_the_visible_element_and_the_list_shows_it() {
    let mut page = Page::new();
    let (v, at) = nearest_vertex(&mut page);
    click_at(&mut page, at, Modifiers::NONE);
    assert_eq!(page.selected(), (Element::Vertex, vec![v]));
    assert!(page.row(&format!("Vertex {v}")).accesskit_node().is_selected().unwrap_or_default());

    page.press(Key::Num4);
    click_at(&mut page, at + vec2(-6.0, 30.0), Modifiers::NONE);
    let (kind, faces) = page.selected();
    assert_eq!((kind, faces.len()), (Element::Face, 1));
    click_at(&mut page, at + vec2(0.0, -30.0), Modifiers::COMMAND);
    assert_eq!(page.selected().1.len(), 2, "control adds");
    click_at(&mut page, at + vec2(0.0, -30.0), Modifiers::COMMAND);
    assert_eq!(page.selected().1, faces, "and takes away");

    let corner = page.harness.get_by_label("Viewport").rect().left_bottom() + vec2(20.0, -20.0);
    click_at(&mut page, corner, Modifiers::SHIFT);
    assert_eq!(page.selected().1, faces, "a near miss with shift keeps the selection");
    click_at(&mut page, corner, Modifiers::NONE);
    assert!(page.selected().1.is_empty(), "a click on nothing selects nothing");
}

#[test]
fn a_pen_need_not_be_as_exact_as_a_mouse_and_more_than_a_finger() {
    let mut page = Page::new();
    let corners: Vec<[f32; 3]> = page.mesh().positions().iter().map(|at| at.to_array()).collect();
    let places: Vec<Pos2> = corners.into_iter().map(|at| page.at(at)).collect();
    let lowest = places.iter().copied().max_by(|a, b| a.y.total_cmp(&b.y)).expect("a cube has vertices");
    let mut is_hit = |has_pen: bool, away: f32| {
        page.outside.point_with_pen(has_pen);
        click_at(&mut page, lowest + vec2(0.0, away), Modifiers::NONE);
        !page.selected().1.is_empty()
    };
    assert!(is_hit(false, 6.0) && !is_hit(false, 11.0), "a mouse");
    assert!(is_hit(true, 11.0) && !is_hit(true, 17.0), "a pen");
}

#[test]
fn the_element_under_the_pointer_is_named() {
    let mut page = Page::new();
    let (v, at) = nearest_vertex(&mut page);
    page.harness.hover_at(at);
    page.run();
    assert_eq!(page.find("Viewport").value(), Some(format!("Vertex {v}")));
}

#[test]
fn dragging_a_selected_vertex_moves_it_in_one_step_and_escape_leaves_no_trace() {
    let mut page = Page::new();
    let (v, at) = nearest_vertex(&mut page);
    let before = page.mesh().position(VertexId::new(v as usize));
    click_at(&mut page, at, Modifiers::NONE);
    page.drag(at, at + vec2(40.0, -25.0));
    let moved = page.mesh().position(VertexId::new(v as usize));
    assert_ne!(moved, before, "the mesh follows the pointer");
    let seen = page.at(moved.to_array());
    assert!(seen.distance(at + vec2(40.0, -25.0)) < 1.0, "it is under the pointer: {seen:?}");
    page.press(Key::Escape);
    assert_eq!(page.mesh().position(VertexId::new(v as usize)), before);
    page.drop(at + vec2(60.0, 0.0));
    assert_eq!(page.mesh().position(VertexId::new(v as usize)), before);
    assert!(page.undo_labels().is_empty());
    assert_eq!(page.selected().1, [v], "Escape ended the drag, not the selection");

    page.drag(at, at + vec2(30.0, 10.0));
    page.drop(at + vec2(30.0, 10.0));
    assert_ne!(page.mesh().position(VertexId::new(v as usize)), before);
    assert_eq!(page.undo_labels().len(), 1, "{:?}", page.undo_labels());
}

#[test]
fn points_without_faces_are_in_view_and_can_be_pointed_at() {
    let mut page = Page::new();
    page.press(Key::Num4);
    let points = [[10.0, 0.0, 0.0], [12.0, 1.0, 0.0], [11.0, 3.0, -2.0]];
    let lines: Vec<String> = points.iter().map(|[x, y, z]| format!("v {x} {y} {z}\n")).collect();
    page.open("points.obj", &lines.concat());
    assert!(page.has_row("Vertex 2"), "the list that was shown has nothing to show");
    let view = page.find("Viewport").rect();
    for (v, point) in points.into_iter().enumerate() {
        let at = page.at(point);
        assert!(view.shrink(20.0).contains(at), "vertex {v} is framed: {at:?} in {view:?}");
        page.harness.hover_at(at);
        page.run();
        assert_eq!(page.find("Viewport").value(), Some(format!("Vertex {v}")));
        click_at(&mut page, at, Modifiers::NONE);
        assert_eq!(page.selected(), (Element::Vertex, vec![v as u32]));
    }
}

#[test]
fn dragging_beside_the_mesh_turns_the_view_and_space_resets_it() {
    let mut page = Page::new();
    let view = |page: &mut Page| {
        let view = page.app().script().state()["view"].clone();
        (view["yaw"].as_f64(), view["distance"].as_f64(), view["target"].to_string())
    };
    let start = view(&mut page);
    let corner = page.find("Viewport").rect().left_bottom() + vec2(30.0, -50.0);
    page.drag(corner, corner + vec2(80.0, 20.0));
    page.drop(corner + vec2(80.0, 20.0));
    let turned = view(&mut page);
    assert!(turned.0 != start.0 && turned.1 == start.1);

    page.harness.hover_at(corner);
    page.run();
    page.turn_wheel(egui::MouseWheelUnit::Point, 120.0);
    assert!(view(&mut page).1 < turned.1, "the wheel comes closer");
    page.press(Key::Space);
    assert_eq!(view(&mut page), start);
    assert!(page.undo_labels().is_empty(), "looking is no edit");
}

#[test]
fn a_box_selects_visible_elements() {
    let mut page = Page::new();
    let area = page.find("Viewport").rect();
    page.press_with(Modifiers::SHIFT, Key::B);
    page.drag(area.left_bottom() + vec2(10.0, -10.0), area.right_top() + vec2(-10.0, 10.0));
    page.drop(area.right_top() + vec2(-10.0, 10.0));
    assert_eq!(page.selected().1.len(), 7, "the eighth vertex of a cube is behind it");
    page.press(Key::Escape);
    assert_eq!(page.selected().1.len(), 7, "Escape first ends the tool");
    page.press(Key::Escape);
    assert!(page.selected().1.is_empty());
}

/// Everything on screen that can be worked with lies inside the window.
fn nothing_is_cut_off(page: &Page, size: egui::Vec2) {
    let window = Rect::from_min_size(pos2(0.0, 0.0), size).expand(0.5);
    for node in page.harness.root().children_recursive() {
        let role = node.accesskit_node().role();
        // Rows and links that are scrolled out of a panel are not on screen.
        if !egui::accessibility::is_input(role) || role == egui::accesskit::Role::ListBoxOption {
            continue;
        }
        let rect = node.rect();
        let name = node.accesskit_node().label().unwrap_or_default();
        assert!(
            rect.left() >= window.left() && rect.right() <= window.right(),
            "{name:?} is at {rect:?} of {size:?}"
        );
    }
}

#[test]
fn a_window_of_1280_by_800_cuts_nothing_off() {
    let mut page = Page::new();
    for (kind, id) in [("vertex", 0), ("edge", 0), ("halfedge", 0), ("face", 0)] {
        page.select(kind, &[id]);
        nothing_is_cut_off(&page, DESKTOP);
    }
}

#[test]
fn all_controls_are_within_reach_on_a_telephone() {
    let mut page = Page::sized(PHONE);
    let view = page.find("Viewport").rect();
    assert!(view.width() >= 380.0 && view.height() >= 280.0, "the viewport has {view:?}");
    nothing_is_cut_off(&page, PHONE);
    for mode in ["Vertex mode", "Edge mode", "Half-edge mode", "Face mode"] {
        assert!(page.has(mode));
    }
    assert!(page.row("Vertex 0").rect().height() >= 44.0, "rows are tall enough for fingers");
    page.select("vertex", &[1]);
    page.click("Inspector");
    assert!(page.has("Position x"));
    nothing_is_cut_off(&page, PHONE);
    page.click("Operations");
    assert!(page.has("Filter operations"));
    nothing_is_cut_off(&page, PHONE);
    // The open tab's own button puts the sheet away.
    page.harness.get_by_role_and_label(egui::accesskit::Role::Tab, "Operations").click();
    page.run();
    assert!(page.find("Viewport").rect().height() > 600.0);
    page.click("Menu");
    for menu in ["File", "Edit", "Select", "Mesh", "View", "Help"] {
        assert!(page.has_part(menu));
    }
}

#[test]
fn keys_turn_and_move_the_view_and_look_from_the_sides() {
    let mut page = Page::new();
    let view = |page: &mut Page| {
        let view = page.app().script().state()["view"].clone();
        let number = |name: &str| view[name].as_f64().expect("a number");
        (number("yaw"), number("pitch"), view["target"].to_string())
    };
    let start = view(&mut page);
    page.press(Key::ArrowLeft);
    page.press(Key::ArrowUp);
    let turned = view(&mut page);
    assert!(turned.0 != start.0 && turned.1 > start.1 && turned.2 == start.2, "{turned:?}");
    page.press(Key::ArrowRight);
    page.press(Key::ArrowDown);
    let back = view(&mut page);
    assert!((back.0 - start.0).abs() < 1e-9 && (back.1 - start.1).abs() < 1e-9, "{back:?}");
    page.press_with(Modifiers::SHIFT, Key::ArrowLeft);
    let moved = view(&mut page);
    assert!(moved.2 != start.2 && (moved.0 - start.0).abs() < 1e-9, "{moved:?}");

    let quarter = std::f64::consts::FRAC_PI_2;
    page.press_with(Modifiers::ALT, Key::Num3);
    assert_eq!((view(&mut page).0, view(&mut page).1), (quarter, 0.0));
    page.press_with(Modifiers::ALT.plus(Modifiers::SHIFT), Key::Num1);
    assert_eq!((view(&mut page).0, view(&mut page).1), (2.0 * quarter, 0.0));
    page.press_with(Modifiers::ALT, Key::Num7);
    assert_eq!((view(&mut page).0, view(&mut page).1), (0.0, quarter));
    // A list keeps its arrow keys.
    page.row("Vertex 2").click();
    page.run();
    page.press(Key::ArrowDown);
    assert_eq!(page.selected().1, [3]);
    assert_eq!(view(&mut page).1, quarter);
}

/// How much nearer the eye is after events of a wheel or a trackpad over a place.
fn zoomed_by(events: &[egui::Event]) -> f64 {
    let mut page = Page::new();
    let at = page.find("Viewport").rect().center() + vec2(60.0, 40.0);
    page.harness.hover_at(at);
    page.run();
    let distance =
        |page: &mut Page| page.app().script().state()["view"]["distance"].as_f64().expect("a distance");
    let before = distance(&mut page);
    for event in events {
        page.harness.event(event.clone());
    }
    page.run();
    before / distance(&mut page)
}

#[test]
fn a_notch_of_the_wheel_zooms_by_an_eighth_in_every_browser() {
    use egui::MouseWheelUnit::{Line, Page as Whole, Point};
    let close = |value: f64, wanted: f64| (value / wanted - 1.0).abs() < 1e-3;
    for (unit, notch) in [(Point, 120.0), (Line, 3.0), (Whole, 1.0)] {
        assert!(close(zoomed_by(&[wheel(unit, notch)]), 1.12), "{unit:?}");
        assert!(close(zoomed_by(&[wheel(unit, -notch)]), 1.0 / 1.12), "{unit:?}");
        let four = vec![wheel(unit, notch); 4];
        assert!(close(zoomed_by(&four), 1.12f64.powi(4)), "{unit:?}: four notches in a slow frame");
        assert!(close(zoomed_by(&[wheel(unit, 50.0 * notch)]), 1.12f64.powi(3)), "{unit:?}: capped");
    }
    let trackpad = vec![wheel(Point, 4.0); 30];
    assert!(close(zoomed_by(&trackpad), 1.12), "small steps add up to the same");
    assert!(close(zoomed_by(&[egui::Event::Zoom(1.05)]), 1.05), "a pinch");
    assert!(close(zoomed_by(&[egui::Event::Zoom(40.0)]), 1.5), "a pinch is capped too");
}

#[test]
fn the_wheel_keeps_what_is_under_the_pointer_in_place() {
    let mut page = Page::new();
    let middle = page.find("Viewport").rect().center();
    page.press_with(Modifiers::ALT, Key::Num1);
    let corner = [1.0, 1.0, 0.0];
    let before = page.at(corner);
    page.harness.hover_at(before);
    page.run();
    page.harness.event(wheel(egui::MouseWheelUnit::Point, 240.0));
    page.run();
    assert!(page.at(corner).distance(before) < 1.0);
    // Keys zoom to the middle by as much.
    let at = page.at(corner) - middle;
    page.press_with(Modifiers::ALT, Key::Equals);
    let nearer = page.at(corner) - middle;
    assert!((nearer.length() / at.length() - 1.12).abs() < 0.01, "{nearer:?} {at:?}");
    page.press_with(Modifiers::ALT, Key::Minus);
    assert!((page.at(corner) - middle - at).length() < 0.1);
}

#[test]
fn a_page_without_anything_to_see_comes_to_rest_and_frames_what_appears() {
    let mut page = Page::new();
    page.command(json!({ "op": "set-object-visible", "object": 0, "visible": false }));
    let frame_all = |page: &mut Page| page.press(Key::Home);
    let distance =
        |page: &mut Page| page.app().script().state()["view"]["distance"].as_f64().expect("a number");
    // Each of these settles, or fails.
    frame_all(&mut page);
    page.outside.advance(6000.0);
    page.run();
    let mut page = page.reload();
    frame_all(&mut page);
    page.command(json!({ "op": "new", "shape": "torus" }));
    let framed = distance(&mut page);
    frame_all(&mut page);
    assert!((distance(&mut page) - framed).abs() < 1e-6, "it was framed already");
}
