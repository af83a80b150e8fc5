//! The 3D cursor: putting it somewhere, turning about it, and moving elements to it.

use crate::page::{DESKTOP, Page};
use crate::viewport::{click_with, nearest_vertex};
use egui::accesskit::Role;
use egui::{Color32, Event, Key, Modifiers, PointerButton, Pos2, Shape, Theme, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use glam::{DVec3, Vec3};
use halfedge::VertexId;
use serde_json::json;

fn blender() -> Page {
    Page::with_setting(DESKTOP, "keys", "blender")
}

/// Chooses an entry of the submenu with what the cursor is for.
fn choose(page: &mut Page, submenu: &str, entry: &str) {
    // The form of a transform, and its fields, have the same names.
    page.harness.query_all_by_label("Transform").next().expect("the menu").click();
    page.run();
    page.harness.get_by_role_and_label(Role::Button, submenu).click();
    page.run();
    page.click(entry);
}

/// Where the cursor is; none while it is hidden.
fn cursor(page: &mut Page) -> Option<Vec3> {
    let at = page.app().script().state()["view"]["cursor"].clone();
    let at: Option<[f64; 3]> = serde_json::from_value(at).expect("a place or none");
    at.map(|at| DVec3::from_array(at).as_vec3())
}

fn place(page: &mut Page, at: Pos2) {
    click_with(page, at, PointerButton::Secondary, Modifiers::SHIFT);
}

fn position(page: &mut Page, vertex: u32) -> Vec3 {
    page.mesh().position(VertexId::new(vertex as usize))
}

/// Types numbers and presses Enter.
fn type_and_apply(page: &mut Page, text: &str) {
    page.type_text(text);
    page.press(Key::Enter);
}

#[test]
fn shift_and_a_right_click_put_the_cursor_on_the_surface_or_beside_it() {
    for preset in ["course", "blender", "maya"] {
        let mut page = Page::with_setting(DESKTOP, "keys", preset);
        page.select("vertex", &[0]);
        assert_eq!(cursor(&mut page), None, "it is shown when it is first needed");
        let (v, corner) = nearest_vertex(&mut page);
        let at = corner + vec2(-20.0, 40.0);
        place(&mut page, at);
        let on = cursor(&mut page).expect("shown");
        assert!((on.abs().max_element() - 1.0).abs() < 1e-4, "on a side of the cube: {on}");
        assert!(on.distance(position(&mut page, v)) < 1.5, "on a side in front: {on}");
        let seen = page.at(on.to_array());
        assert!(seen.distance(at) < 0.5, "{preset}: {on} is seen at {seen}, not at {at}");

        let corner = page.find("Viewport").rect().left_bottom() + vec2(20.0, -20.0);
        place(&mut page, corner);
        let beside = cursor(&mut page).expect("shown");
        assert!(page.at(beside.to_array()).distance(corner) < 0.5, "under the pointer");
        let view = page.app().script().state()["view"].clone();
        let number = |name: &str| view[name].as_f64().expect("a number");
        let target: [f64; 3] = serde_json::from_value(view["target"].clone()).expect("three numbers");
        let (yaw, pitch) = (number("yaw"), number("pitch"));
        let back = DVec3::new(yaw.sin() * pitch.cos(), pitch.sin(), yaw.cos() * pitch.cos());
        let depth = (beside.as_dvec3() - DVec3::from_array(target)).dot(back);
        assert!(depth.abs() < 1e-3, "as far away as what the view turns about: {depth}");

        assert!(!page.has_part("Isolate"), "no menu opened");
        assert_eq!(page.selected().1, [0]);
        assert!(page.undo_labels().is_empty(), "no step");
    }
}

#[test]
fn the_cursor_is_a_ring_with_a_cross_that_shows_on_any_background() {
    for theme in [Theme::Dark, Theme::Light] {
        let mut page = Page::themed(DESKTOP, theme);
        choose(&mut page, "Cursor", "Cursor to origin");
        let middle = page.at([0.0; 3]);
        let mut colors = Vec::new();
        let mut ring = 0;
        for clipped in &page.harness.output().shapes {
            match &clipped.shape {
                Shape::LineSegment { points: [a, b], stroke }
                    if a.distance(middle) < 20.0 && b.distance(middle) < 20.0 =>
                {
                    colors.push(stroke.color);
                }
                Shape::Path(path) if path.points.iter().all(|at| (at.distance(middle) - 9.0).abs() < 0.1) => {
                    ring += 1;
                }
                _ => {}
            }
        }
        assert!(colors.contains(&Color32::WHITE) && colors.iter().any(|color| color.r() == 0), "{colors:?}");
        assert_eq!((colors.len(), ring), (8, 8), "a cross on a darker one, and a ring of two colours");
        choose(&mut page, "Cursor", "Show 3D cursor");
        assert_eq!(cursor(&mut page), None);
    }
}

#[test]
fn rotations_scales_and_the_gizmo_leave_the_cursor_in_place() {
    let mut page = blender();
    page.select("vertex", &[7]);
    choose(&mut page, "Cursor", "Cursor to selection");
    let fixed = position(&mut page, 7);
    assert_eq!(cursor(&mut page), Some(fixed));
    choose(&mut page, "Pivot", "Pivot: cursor");
    page.select("vertex", &[0, 1, 2, 3, 4, 5, 6, 7]);
    let before = page.mesh().clone();
    page.press(Key::S);
    type_and_apply(&mut page, "3");
    for v in before.vertices() {
        let wanted = fixed + (before.position(v) - fixed) * 3.0;
        assert!(page.mesh().position(v).distance(wanted) < 1e-5, "{v:?}");
    }
    page.press_with(Modifiers::COMMAND, Key::Z);

    page.press(Key::R);
    page.press(Key::Y);
    type_and_apply(&mut page, "90");
    for v in before.vertices() {
        let by = before.position(v) - fixed;
        let wanted = fixed + Vec3::new(by.z, by.y, -by.x);
        assert!(page.mesh().position(v).distance(wanted) < 1e-5, "{v:?}");
    }
    page.press_with(Modifiers::COMMAND, Key::Z);

    // The ring of the gizmo in the plane of the picture lies around the cursor.
    choose(&mut page, "Gizmo", "Rotate gizmo");
    let middle = page.at(fixed.to_array());
    let ring = page.harness.output().shapes.iter().any(|clipped| match &clipped.shape {
        Shape::Path(path) => {
            path.points.len() > 60
                && path.points.iter().all(|at| (at.distance(middle) - 84.0 * 1.15).abs() < 0.5)
        }
        _ => false,
    });
    assert!(ring, "around {middle}");
}

#[test]
fn the_form_of_a_transform_follows_the_cursor() {
    let mut page = Page::new();
    let pivot = |page: &Page, axis: &str| {
        let label = format!("Pivot {axis}");
        let field = page.harness.query_by_role_and_label(Role::SpinButton, &label);
        field.map(|field| field.accesskit_node().numeric_value().expect("a number"))
    };
    page.select("vertex", &[7]);
    choose(&mut page, "Cursor", "Cursor to selection");
    page.choose("Transform");
    assert_eq!(pivot(&page, "x"), None, "the centre of the vertices");
    choose(&mut page, "Pivot", "Pivot: cursor");
    let at = position(&mut page, 7);
    let shown = ["x", "y", "z"].map(|axis| pivot(&page, axis).expect("a field") as f32);
    assert_eq!(Vec3::from(shown), at);
    choose(&mut page, "Cursor", "Cursor to origin");
    assert_eq!(pivot(&page, "x"), Some(0.0));
    choose(&mut page, "Pivot", "Pivot: median");
    assert_eq!(pivot(&page, "x"), None);
}

#[test]
fn the_selection_goes_to_the_cursor_and_merges_there() {
    let mut page = blender();
    choose(&mut page, "Cursor", "Cursor to origin");
    page.select("vertex", &[0, 1]);
    let [a, b] = [0, 1].map(|v| position(&mut page, v));
    choose(&mut page, "Cursor", "Selection to cursor");
    let half = (a - b) / 2.0;
    assert!(position(&mut page, 0).distance(half) < 1e-6 && position(&mut page, 1).distance(-half) < 1e-6);
    assert_eq!(page.undo_labels(), ["Move"]);
    page.press_with(Modifiers::COMMAND, Key::Z);

    page.select("vertex", &[7]);
    choose(&mut page, "Cursor", "Cursor to selection");
    page.command(json!({"op": "set-vertex-position", "vertex": 7, "position": [2, 3, 4]}));
    page.select("vertex", &[0, 1]);
    choose(&mut page, "Cursor", "Merge at cursor");
    assert_eq!(page.mesh().vertex_count(), 7);
    assert!(page.mesh().positions().contains(&Vec3::ONE), "where vertex 7 was");
}

#[test]
fn the_palette_finds_the_cursor_and_says_what_is_missing() {
    let mut page = Page::new();
    page.press_with(Modifiers::COMMAND, Key::K);
    page.find("Find a command").type_text("3d cursor");
    page.run();
    for label in ["Cursor to origin", "Cursor to selection", "Selection to cursor", "Pivot: cursor"] {
        assert!(page.has_part(label), "{label}");
    }
    page.press(Key::Escape);
    page.click("Transform");
    page.click("Cursor");
    for (label, greyed) in
        [("Cursor to selection", true), ("Merge at cursor", true), ("Cursor to origin", false)]
    {
        assert_eq!(page.find(label).accesskit_node().is_disabled(), greyed, "{label}");
    }
}

#[test]
fn the_cursor_is_kept_with_its_document() {
    let mut page = Page::new();
    page.select("vertex", &[3]);
    choose(&mut page, "Cursor", "Cursor to selection");
    let at = cursor(&mut page);
    assert!(at.is_some());
    page.outside.advance(6000.0);
    page.run();
    let mut page = page.reload();
    assert_eq!(cursor(&mut page), at);
    page.press_with(Modifiers::COMMAND | Modifiers::ALT, Key::N);
    assert_eq!(cursor(&mut page), None, "another document has a cursor of its own");
}

#[test]
fn far_from_the_origin_the_cursor_is_where_files_say() {
    let mut page = Page::new();
    page.open("far.obj", "v 5000000 0 0\nv 5000001 0 0\nv 5000000 1 0\nf 1 2 3\n");
    assert_ne!(page.app().editor().document().offset(), DVec3::ZERO);
    page.select("vertex", &[1]);
    choose(&mut page, "Cursor", "Cursor to selection");
    assert_eq!(cursor(&mut page), Some(Vec3::new(5000001.0, 0.0, 0.0)));
    page.select("face", &[0]);
    choose(&mut page, "Pivot", "Pivot: cursor");
    let fixed = position(&mut page, 1);
    page.press_with(Modifiers::SHIFT, Key::D);
    page.harness.event(Event::Text("2".to_owned()));
    page.press(Key::Enter);
    assert_eq!(position(&mut page, 1), fixed);
}
