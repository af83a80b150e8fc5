//! What messages, forms and lists say.

use crate::page::Page;
use egui::Key;
use egui::accesskit::Role;
use egui_kittest::kittest::{NodeT, Queryable};
use serde_json::json;

/// A strip of this many quads, as an OBJ.
fn strip(quads: usize) -> String {
    let mut text: String = (0..=quads).map(|i| format!("v {i} 0 0\nv {i} 1 0\n")).collect();
    for i in 0..quads {
        let at = 2 * i + 1;
        text += &format!("f {} {} {} {}\n", at, at + 2, at + 3, at + 1);
    }
    text
}

#[test]
fn opening_says_what_was_opened_with_separated_thousands() {
    let mut page = Page::new();
    page.open("strip.obj", &strip(1200));
    assert!(page.has("Opened strip: 2\u{a0}402 vertices, 3\u{a0}601 edges and 1\u{a0}200 faces"));
    page.open("line.bzc", "3\n0 0 5 5 10 0\n");
    assert!(page.has("Opened line"), "a curve has no elements to count");
}

#[test]
fn an_empty_file_is_called_empty() {
    let mut page = Page::new();
    page.open("nothing.obj", "");
    assert!(page.has("Could not open nothing.obj. The file is empty."));
}

#[test]
fn refusals_name_operations_and_fields_as_forms_do() {
    let mut page = Page::new();
    page.open_not_now();
    assert!(page.has_part("Merge by distance works on any mesh") && !page.has_part("merge-by-distance"));
    page.choose("Simplify");
    page.type_into("Ratio", "0");
    page.apply("Simplify");
    assert!(!page.has_part("`ratio`"));
    let messages = page.app().script().state()["messages"].to_string();
    assert!(!messages.contains('`'), "{messages}");
}

#[test]
fn an_empty_mesh_promises_no_result() {
    for operation in ["Simplify", "Remesh"] {
        let mut page = Page::new();
        page.choose(operation);
        page.open("points.obj", "v 0 0 0\nv 1 0 0\n");
        assert!(page.has("All operations"), "the form stays open");
        assert!(!page.has_part("of 0") && !page.has_part("about 0"), "{operation}");
    }
}

#[test]
fn a_single_patch_is_not_chosen_among_several() {
    let patch: String = (0..16).map(|i| format!("{} {} 0\n", i % 4, i / 4)).collect();
    let mut page = Page::new();
    page.open("one.bez", &format!("1\n{patch}"));
    assert!(page.has("Control points") && !page.has("Patch") && !page.has_part("0 to 0"));
    page.open("two.bez", &format!("2\n{patch}{patch}"));
    assert!(page.has("Patch") && page.has("of patches 0 to 1"));
}

#[test]
fn a_preview_that_takes_too_long_is_not_ticked() {
    let mut page = Page::new();
    page.command(json!({ "op": "new", "shape": "ico-sphere", "subdivisions": 5 }));
    page.choose("Smooth");
    let node = page.harness.get_by_role_and_label(Role::CheckBox, "Live preview");
    let node = node.accesskit_node();
    assert!(node.is_disabled() && node.toggled() == Some(egui::accesskit::Toggled::False));
    page.command(json!({ "op": "new", "shape": "ico-sphere", "subdivisions": 1 }));
    page.type_into("Strength", "0.4");
    let node = page.harness.get_by_role_and_label(Role::CheckBox, "Live preview");
    let node = node.accesskit_node();
    assert!(
        !node.is_disabled() && node.toggled() == Some(egui::accesskit::Toggled::True),
        "it is possible again"
    );
}

#[test]
fn the_course_actions_say_which_operation_they_are() {
    let mut page = Page::new();
    for (menu, labels) in [
        ("Subdivide", ["Upsample (subdivide)", "Subdivide (Loop)"]),
        ("Simplify", ["Downsample (simplify)", "Simplify…"]),
        ("Remesh", ["Resample (remesh)", "Longer target edges"]),
    ] {
        page.click("Mesh");
        page.click(menu);
        for label in labels {
            assert!(page.has_part(label), "{label} in {menu}");
        }
        page.press(Key::Escape);
        page.press(Key::Escape);
    }
}
