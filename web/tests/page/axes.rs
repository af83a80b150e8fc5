//! The axes that edits go along, fine movements, and the marks that are drawn during an edit.

use crate::page::{Page, wheel};
use egui::epaint::CircleShape;
use egui::{Event, Key, Modifiers, MouseWheelUnit, PointerButton, Pos2, Shape, Vec2, vec2};
use egui_kittest::kittest::Queryable;
use glam::Vec3;
use halfedge::edit::edge_rails;
use halfedge::{EdgeId, Mesh, VertexId};
use serde_json::json;

/// Chooses an entry of the Transform menu.
pub fn choose(page: &mut Page, submenu: &str, entry: &str) {
    page.click("Transform");
    page.click(submenu);
    page.harness.get_by_label_contains(entry).click();
    page.run();
}

/// The mean position of some vertices.
pub fn mean(mesh: &Mesh, ids: &[u32]) -> Vec3 {
    ids.iter().map(|v| mesh.position(VertexId::new(*v as usize))).sum::<Vec3>() / ids.len() as f32
}

/// A cube with its slanted cut: the page, the vertices of a face whose normal is along no axis, and that normal.
fn slanted() -> (Page, Vec<u32>, Vec3) {
    let mut page = Page::new();
    // A corner cut off.
    page.select("vertex", &[7]);
    page.command(json!({ "op": "bevel-vertices", "width": 0.5 }));
    let mesh = page.mesh();
    let face = mesh.faces().find(|&f| mesh.face_vertices(f).count() == 3).expect("the cut");
    let normal = halfedge::geometry::face_area_vector(mesh, face).as_vec3().normalize();
    let corners: Vec<u32> = mesh.face_vertices(face).map(|v| v.raw()).collect();
    page.select("face", &[face.raw()]);
    assert!(normal.abs().min_element() > 0.1, "along no axis: {normal}");
    (page, corners, normal)
}

/// The directions to the right and up in the picture, as the page projects.
pub fn picture_axes(page: &mut Page) -> [Vec3; 2] {
    let view = page.app().script().state()["view"].clone();
    let number = |name: &str| view[name].as_f64().expect("a number") as f32;
    let (yaw, pitch) = (number("yaw"), number("pitch"));
    let right = Vec3::new(yaw.cos(), 0.0, -yaw.sin());
    let back = Vec3::new(yaw.sin() * pitch.cos(), pitch.sin(), yaw.cos() * pitch.cos());
    [right, back.cross(right)]
}

#[test]
fn typed_moves_go_along_the_chosen_axes() {
    let (mut page, ids, normal) = slanted();
    let start = mean(page.mesh(), &ids);
    let moved = |page: &mut Page, keys: &[(Modifiers, Key)], words: &str| {
        page.press(Key::G);
        keys.iter().for_each(|(held, key)| page.press_with(*held, *key));
        assert!(page.has(words), "the bar says {words:?}");
        page.type_text("2");
        page.press(Key::Enter);
        let moved = mean(page.mesh(), &ids) - start;
        page.press_with(Modifiers::COMMAND, Key::Z);
        moved
    };
    let z = (Modifiers::NONE, Key::Z);
    let x = (Modifiers::NONE, Key::X);
    let along_z = moved(&mut page, &[z], "along z");
    assert!(along_z.distance(Vec3::Z * 2.0) < 1e-5, "{along_z}");
    let along_normal = moved(&mut page, &[z, z], "along z (normal)");
    assert!(along_normal.distance(normal * 2.0) < 1e-5, "the second press takes the normal: {along_normal}");

    choose(&mut page, "Axes", "Normal axes");
    let along_normal = moved(&mut page, &[z], "along z (normal)");
    assert!(along_normal.distance(normal * 2.0) < 1e-5, "{along_normal}");
    let along_z = moved(&mut page, &[z, z], "along z");
    assert!(along_z.distance(Vec3::Z * 2.0) < 1e-5, "the second press takes the mesh's axes: {along_z}");
    let across = moved(&mut page, &[x], "along x (normal)");
    assert!((across.length() - 2.0).abs() < 1e-5 && across.dot(normal).abs() < 1e-5, "{across}");
    assert!(across.y.abs() < 1e-5, "horizontal: {across}");
    let in_plane = moved(&mut page, &[(Modifiers::SHIFT, Key::Z)], "in the x-y plane (normal)");
    assert!(in_plane.distance(across) < 1e-5, "the first number is x: {in_plane}");

    choose(&mut page, "Axes", "View axes");
    let [right, up] = picture_axes(&mut page);
    for (key, name, wanted) in [(Key::X, "x", right), (Key::Y, "y", up), (Key::Z, "z", right.cross(up))] {
        let along = moved(&mut page, &[(Modifiers::NONE, key)], &format!("along {name} (view)"));
        assert!(along.distance(wanted * 2.0) < 1e-4, "{name}: {along}, not {wanted}");
    }
}

#[test]
fn rotations_and_scales_go_by_the_chosen_axes() {
    let (mut page, ids, normal) = slanted();
    choose(&mut page, "Axes", "Normal axes");
    let start = page.mesh().clone();
    let centre = mean(&start, &ids);
    let offsets = |mesh: &Mesh| -> Vec<Vec3> {
        ids.iter().map(|v| mesh.position(VertexId::new(*v as usize)) - centre).collect()
    };
    let before = offsets(&start);
    page.press_with(Modifiers::SHIFT, Key::R);
    page.press(Key::Z);
    "120".chars().for_each(|digit| page.type_text(&digit.to_string()));
    page.press(Key::Enter);
    // The cut is a regular triangle: a third of a turn about its normal takes each corner to another one.
    for after in offsets(page.mesh()) {
        assert!(before.iter().any(|corner| corner.distance(after) < 1e-5), "{after} of {before:?}");
        assert!(after.dot(normal).abs() < 1e-5);
    }
    assert_ne!(page.mesh(), &start);
    page.press_with(Modifiers::COMMAND, Key::Z);

    choose(&mut page, "Axes", "View axes");
    let [right, up] = picture_axes(&mut page);
    page.press_with(Modifiers::SHIFT, Key::D);
    page.press(Key::X);
    page.type_text("3");
    page.press(Key::Enter);
    for (after, before) in offsets(page.mesh()).into_iter().zip(&before) {
        assert!((after.dot(right) - 3.0 * before.dot(right)).abs() < 1e-4, "wider in the picture");
        assert!((after.dot(up) - before.dot(up)).abs() < 1e-4, "as high as before");
    }
}

#[test]
fn the_gizmo_goes_along_the_chosen_axes() {
    let (mut page, ids, normal) = slanted();
    choose(&mut page, "Gizmo", "Move gizmo");
    // Beside the normal, which would point at the viewer.
    (0..6).for_each(|_| page.press(Key::ArrowRight));
    let start = mean(page.mesh(), &ids);
    let drag = |page: &mut Page, axis: Vec3| {
        let [from, to] = [start, start + axis].map(|point| page.at(point.to_array()));
        let way = (to - from).normalized();
        page.drag(from + way * 50.0, from + way * 80.0);
        page.drop(from + way * 80.0);
        let moved = mean(page.mesh(), &ids) - start;
        assert_eq!(page.undo_labels().len(), 2, "the bevel and the move");
        page.press_with(Modifiers::COMMAND, Key::Z);
        moved
    };
    choose(&mut page, "Axes", "Normal axes");
    let moved = drag(&mut page, normal);
    assert!(moved.normalize().distance(normal) < 1e-4 && moved.length() > 0.05, "{moved} along {normal}");
    choose(&mut page, "Axes", "View axes");
    let [right, up] = picture_axes(&mut page);
    for axis in [right, up] {
        let moved = drag(&mut page, axis);
        assert!(moved.normalize().distance(axis) < 1e-4 && moved.length() > 0.05, "{moved} along {axis}");
    }
}

#[test]
fn shift_makes_the_gizmo_and_numbers_fine() {
    let mut page = Page::new();
    let all: Vec<u32> = (0..8).collect();
    page.select("vertex", &all);
    choose(&mut page, "Gizmo", "Move gizmo");
    let centre = page.at([0.0; 3]);
    let way = (page.at([1.0, 0.0, 0.0]) - centre).normalized();
    let from = centre + way * 50.0;
    let mut moved = |modifiers: Modifiers| {
        page.drag(from, from + way);
        page.harness.event_modifiers(Event::PointerMoved(from + way * 81.0), modifiers);
        page.run();
        page.drop(from + way * 81.0);
        let moved = mean(page.mesh(), &all).x;
        page.press_with(Modifiers::COMMAND, Key::Z);
        moved
    };
    let (coarse, fine) = (moved(Modifiers::NONE), moved(Modifiers::SHIFT));
    // A first point at full speed, then eighty of them.
    assert!(coarse > 0.3 && (fine / coarse - 9.0 / 81.0).abs() < 0.02, "{fine} {coarse}");
    assert_eq!(page.undo_labels(), Vec::<String>::new());

    // The number of an edit in its bar, and one of a form.
    page.press(Key::G);
    page.press(Key::X);
    let dragged = |page: &mut Page, field: &str, modifiers: Modifiers| {
        let at = page.harness.get_by_role_and_label(egui::accesskit::Role::SpinButton, field).rect().center();
        let value = |page: &Page| {
            let node = page.harness.get_by_role_and_label(egui::accesskit::Role::SpinButton, field);
            egui_kittest::kittest::NodeT::accesskit_node(&node).numeric_value().expect("a number")
        };
        let before = value(page);
        page.harness.hover_at(at);
        page.run();
        let press = |pos: Pos2, pressed| Event::PointerButton {
            pos,
            button: PointerButton::Primary,
            pressed,
            modifiers,
        };
        page.harness.event_modifiers(press(at, true), modifiers);
        // Beyond the distance at which a press becomes a drag.
        for step in 1..=5 {
            let to = at + vec2(20.0 * step as f32, 0.0);
            page.harness.event_modifiers(Event::PointerMoved(to), modifiers);
            page.run();
        }
        let change = value(page) - before;
        page.harness.event_modifiers(press(at + vec2(100.0, 0.0), false), modifiers);
        page.harness.event(Event::ModifiersChanged(Modifiers::NONE));
        page.run();
        change
    };
    let (coarse, fine) = (
        dragged(&mut page, "Translate x", Modifiers::NONE),
        dragged(&mut page, "Translate x", Modifiers::SHIFT),
    );
    assert!(coarse > 0.1 && (fine / coarse - 0.1).abs() < 0.05, "{fine} {coarse}");
    page.press(Key::Escape);
}

/// The circles that the last frame has drawn.
fn circles(page: &Page) -> Vec<CircleShape> {
    let shapes = page.harness.output().shapes.iter();
    shapes
        .filter_map(|clipped| match &clipped.shape {
            Shape::Circle(circle) => Some(*circle),
            _ => None,
        })
        .collect()
}

/// The lines that the last frame has drawn.
fn lines(page: &Page) -> Vec<[Pos2; 2]> {
    let shapes = page.harness.output().shapes.iter();
    shapes
        .filter_map(|clipped| match &clipped.shape {
            Shape::LineSegment { points, .. } => Some(*points),
            _ => None,
        })
        .collect()
}

#[test]
fn soft_selection_shows_its_circle_and_the_wheel_changes_it() {
    let mut page = Page::new();
    page.command(json!({ "op": "new", "shape": "grid", "columns": 8, "rows": 8 }));
    page.select("vertex", &[40]);
    page.press_with(Modifiers::ALT, Key::Num7);
    let centre = {
        let at = page.mesh().position(VertexId::new(40));
        page.at(at.to_array())
    };
    let outline = |page: &Page| -> Option<f32> {
        let around = |circle: &CircleShape| circle.center.distance(centre) < 2.0 && circle.radius > 20.0;
        let hits: Vec<_> = circles(page).into_iter().filter(around).collect();
        assert!(hits.len() <= 1, "{hits:?}");
        hits.first().map(|circle| circle.radius)
    };
    page.hover(centre);
    page.press(Key::G);
    page.hover(centre + vec2(1.0, 0.0));
    assert_eq!(outline(&page), None, "without soft selection there is none");
    page.press_with(Modifiers::SHIFT, Key::O);
    let first = outline(&page).expect("the circle");
    assert!((first - 90.0).abs() < 2.0, "{first}");
    let moved = |page: &mut Page| page.mesh().positions().iter().filter(|p| p.y.abs() > 1e-6).count();
    // Along y, towards the viewer: what moves can be counted.
    page.press(Key::Y);
    page.type_text("1");
    let few = moved(&mut page);
    assert!(few > 1, "{few}");
    page.press(Key::Backspace);
    let zoom = page.app().script().state()["view"]["distance"].clone();
    page.harness.event(wheel(MouseWheelUnit::Point, 120.0));
    page.run();
    let second = outline(&page).expect("the circle");
    assert!((second / first - 1.15).abs() < 0.01, "{second} after {first}");
    for _ in 0..6 {
        page.harness.event(wheel(MouseWheelUnit::Point, 120.0));
        page.run();
    }
    let large = outline(&page).expect("the circle");
    assert!((large / first - 1.15f32.powi(7)).abs() < 0.05, "{large} after {first}");
    page.type_text("1");
    assert!(moved(&mut page) > few, "a larger circle moves more");
    page.press(Key::Backspace);
    page.harness.event(wheel(MouseWheelUnit::Point, -120.0));
    page.run();
    assert!((large / outline(&page).expect("the circle") - 1.15).abs() < 0.01);
    assert_eq!(page.app().script().state()["view"]["distance"], zoom, "the view doesn't zoom");
    page.press(Key::Escape);
    assert_eq!(outline(&page), None);
}

#[test]
fn slides_show_the_rails_of_each_vertex() {
    let mut page = Page::new();
    page.select("edge", &[0]);
    page.command(json!({ "op": "loop-cut" }));
    let edges: Vec<EdgeId> = page.selected().1.iter().map(|&id| EdgeId::new(id as usize)).collect();
    let expected: Vec<[Vec3; 2]> = {
        let mesh = page.mesh();
        let rails = edge_rails(mesh, &edges).expect("a loop");
        rails.iter().flatten().map(|rail| [mesh.position(rail.vertex), rail.to]).collect()
    };
    assert_eq!(expected.len(), 8, "four vertices with two rails each");
    page.hover_off_middle(Vec2::ZERO);
    assert_rails(&mut page, &expected, Modifiers::SHIFT, Key::V);
    // A vertex has one along each of its edges.
    page.select("vertex", &[7]);
    let expected: Vec<[Vec3; 2]> = {
        let mesh = page.mesh();
        let v = VertexId::new(7);
        mesh.neighbors(v).map(|to| [mesh.position(v), mesh.position(to)]).collect()
    };
    assert_rails(&mut page, &expected, Modifiers::SHIFT, Key::V);
}

/// A key starts a slide, during which these rails are drawn, each with a dot at its end, wherever the pointer is.
fn assert_rails(page: &mut Page, rails: &[[Vec3; 2]], modifiers: Modifiers, key: Key) {
    let on_screen: Vec<[Pos2; 2]> =
        rails.iter().map(|rail| rail.map(|point| page.at(point.to_array()))).collect();
    let is_drawn = |page: &Page, rail: &[Pos2; 2]| {
        let close = |a: Pos2, b: Pos2| a.distance(b) < 0.5;
        let line = lines(page).iter().any(|[a, b]| close(*a, rail[0]) && close(*b, rail[1]));
        let end = circles(page).iter().any(|circle| close(circle.center, rail[1]) && circle.radius < 4.0);
        line && end
    };
    assert!(!on_screen.iter().any(|rail| is_drawn(page, rail)));
    page.press_with(modifiers, key);
    for by in [Vec2::ZERO, vec2(30.0, -10.0)] {
        page.hover_off_middle(by);
        for rail in &on_screen {
            assert!(is_drawn(page, rail), "{rail:?} with the pointer at {by:?}");
        }
    }
    page.press(Key::Escape);
    assert!(!on_screen.iter().any(|rail| is_drawn(page, rail)));
}
