//! Previews of operations while their forms are filled in.

use crate::page::{PHONE, Page};
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;
use halfedge::{Element, Mesh};
use serde_json::json;

fn sphere(subdivisions: u32) -> Page {
    let mut page = Page::new();
    page.command(json!({ "op": "new", "shape": "ico-sphere", "subdivisions": subdivisions }));
    page
}

fn smoothed(mesh: &Mesh, strength: f64) -> Mesh {
    let options = surface::Smooth { iterations: 1, strength, method: surface::SmoothMethod::Laplacian };
    surface::smooth(mesh, &options, &mut |_| std::ops::ControlFlow::Continue(())).expect("a mesh")
}

/// What can be undone, and whether there is anything to save.
fn trace(page: &mut Page) -> (Vec<String>, bool) {
    (page.undo_labels(), page.app().editor().is_dirty())
}

#[test]
fn smoothing_is_shown_before_it_is_done() {
    let mut page = sphere(2);
    let (before, steps) = (page.mesh().clone(), trace(&mut page));
    page.choose("Smooth");
    assert_eq!(page.mesh(), &smoothed(&before, 0.5), "as the form opens");
    page.type_into("Strength", "0.25");
    assert_eq!(page.mesh(), &smoothed(&before, 0.25), "of the mesh as it was, not of the preview");
    assert_eq!(trace(&mut page), steps);
    assert!(page.has_part("This is a preview"));

    // While a field is dragged, too.
    let field = page.harness.get_by_role_and_label(Role::SpinButton, "Strength").rect().center();
    let (shown, right) = (page.mesh().clone(), field + egui::vec2(40.0, 0.0));
    page.drag(field, right);
    assert_ne!(page.mesh(), &shown, "before the button is let go");
    page.drop(right);
    assert_eq!(trace(&mut page), steps);

    let shown = page.mesh().clone();
    page.apply("Smooth");
    assert_eq!(page.mesh(), &shown, "just what was shown");
    assert_eq!(page.undo_labels(), ["New shape", "Smooth"]);
    assert!(page.has("Adjust last operation") && page.has("Smooth"));
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(page.mesh(), &before);
}

#[test]
fn a_preview_leaves_no_trace() {
    let mut page = sphere(2);
    page.select("face", &[7]);
    let (before, steps) = (page.mesh().clone(), trace(&mut page));
    let gone = |page: &mut Page, how: &str| {
        assert_eq!(page.mesh(), &before, "{how}");
        assert_eq!(trace(page), steps, "{how}");
    };
    page.choose("Smooth");
    assert_ne!(page.mesh(), &before);
    page.press(Key::Escape);
    gone(&mut page, "Escape");
    assert_eq!(page.selected(), (Element::Face, vec![7]), "the selection is back");
    assert!(page.has("Change a field to preview it."));
    page.press(Key::Escape);
    assert!(page.has("Simplify…"), "the next Escape closes the form");
    page.press(Key::Escape);
    assert_eq!(page.selected().1, [0; 0], "and then it is for what is selected");
    page.select("face", &[7]);

    page.choose("Smooth");
    page.press(Key::Escape);
    page.type_into("Strength", "0.4");
    assert_ne!(page.mesh(), &before, "until a field is changed");
    page.press_with(Modifiers::COMMAND, Key::Z);
    gone(&mut page, "undo");

    // Another form, the panel closed, a script, saving.
    page.choose("Simplify");
    assert_eq!(page.mesh().face_count(), 160);
    page.choose("Separate");
    gone(&mut page, "another form");
    page.choose("Simplify");
    assert_eq!(page.mesh().face_count(), 160);
    page.press(Key::CloseBracket);
    gone(&mut page, "the panel closed");
    page.press(Key::CloseBracket);
    page.choose("Smooth");
    page.press_with(Modifiers::COMMAND, Key::S);
    gone(&mut page, "saving");
    page.press(Key::Escape);
    page.choose("Simplify");
    page.command(json!({ "op": "set-face-color", "faces": [319], "color": "#ff0000" }));
    assert_eq!(page.mesh().face_count(), 320, "a script's command is of what was there");
    assert_eq!(page.undo_labels(), ["New shape", "Paint faces"]);
}

#[test]
fn a_selection_outlives_a_preview_only_if_ids_keep_their_meaning() {
    let mut page = sphere(2);
    page.choose("Smooth");
    page.row("Vertex 3").click();
    page.run();
    assert_eq!(page.selected(), (Element::Vertex, vec![3]));
    assert!(page.has("Change a field to preview it."), "the preview is over");
    page.choose("Simplify");
    page.row("Vertex 3").click();
    page.run();
    assert_eq!(page.mesh().face_count(), 320);
    assert_eq!(page.selected(), (Element::Vertex, vec![3]), "vertex 3 of the preview was another one");
}

#[test]
fn the_form_estimates_from_the_mesh_before_the_preview() {
    let mut page = sphere(2);
    page.choose("Simplify");
    for faces in [64, 96, 40] {
        page.type_into("Ratio", &(faces as f64 / 320.0).to_string());
        assert_eq!(page.mesh().face_count(), faces);
        assert!(page.has(&format!("Result: {faces} of 320 triangles")));
    }
    page.choose("Remesh");
    let made = page.mesh().face_count();
    assert!(page.has(&format!("Result: {made} triangles")), "counted, not reckoned");
    page.choose("Subdivide (Loop)");
    assert_eq!(page.mesh().face_count(), 1280);
    assert!(page.has("Result: 1\u{a0}280 faces"));
    page.type_into("Levels", "2");
    assert_eq!(page.mesh().face_count(), 5120, "not of the preview");
}

#[test]
fn a_preview_can_be_switched_off() {
    let mut page = sphere(2);
    let before = page.mesh().clone();
    page.choose("Smooth");
    page.click("Live preview");
    assert_eq!(page.mesh(), &before);
    page.type_into("Strength", "0.9");
    assert_eq!(page.mesh(), &before, "it stays off");
    page.click("Live preview");
    assert_eq!(page.mesh(), &smoothed(&before, 0.9));
    page.click("Live preview");
    page.apply("Smooth");
    assert_eq!(page.mesh(), &smoothed(&before, 0.9), "and the form works without");
    assert_eq!(page.undo_labels(), ["New shape", "Smooth"]);
}

#[test]
fn a_form_says_why_there_is_no_preview() {
    let mut page = sphere(5);
    let before = page.mesh().clone();
    page.choose("Smooth");
    assert_eq!(page.mesh(), &before);
    assert!(page.has_part("the operation takes too long to show"));
    // A smaller one is shown, up to what its fields ask for.
    page.command(json!({ "op": "new", "shape": "ico-sphere", "subdivisions": 3 }));
    let before = page.mesh().clone();
    page.type_into("Strength", "0.6");
    assert_eq!(page.mesh(), &smoothed(&before, 0.6));
    page.type_into("Iterations", "1000");
    assert_eq!(page.mesh(), &before, "nothing that the fields don't say");
    assert!(page.has_part("the operation takes too long"));
    // Loop's subdivision is of triangles.
    page.command(json!({ "op": "new", "shape": "cube" }));
    page.click("All operations");
    page.open_not_now();
    assert!(page.has_part("Loop subdivision"), "the reason is on the screen");
    assert_eq!(page.mesh().face_count(), 6);
}

#[test]
fn a_telephone_previews_in_its_sheet() {
    let mut page = Page::sized(PHONE);
    page.command(json!({ "op": "new", "shape": "ico-sphere", "subdivisions": 2 }));
    page.click("Operations");
    page.choose("Simplify");
    assert_eq!(page.mesh().face_count(), 160);
    assert!(page.harness.query_by_role_and_label(Role::CheckBox, "Live preview").is_some());
    page.harness.get_by_role_and_label(Role::Tab, "Elements").click();
    page.run();
    assert_eq!(page.mesh().face_count(), 320, "another tab is in its place");
}

#[test]
fn a_telephone_adjusts_the_last_operation_in_its_sheet() {
    let mut page = Page::sized(PHONE);
    page.command(json!({ "op": "bevel-edges", "edges": [0], "width": 0.2 }));
    page.click("Operations");
    page.type_into("Segments", "3");
    assert_eq!(page.mesh().face_count(), 9, "three segments");
    assert_eq!(page.undo_labels().len(), 1, "in place of itself");
}
