//! Operations on whole meshes: keys, forms, and adjusting the last one.

use crate::page::Page;
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};
use serde_json::json;

/// A sphere of 320 triangles.
fn sphere() -> Page {
    let mut page = Page::new();
    page.command(json!({ "op": "new", "shape": "ico-sphere", "subdivisions": 2 }));
    page
}

/// The result that the form promises.
fn promise(page: &Page) -> String {
    let node = page.harness.get_by_label_contains("Result: ");
    node.accesskit_node().label().or_else(|| node.value()).unwrap_or_default()
}

fn target_edge(page: &Page) -> Option<f64> {
    let start = "Target edge length of resampling: ";
    let mut labels = page.harness.root().children_recursive().map(|node| node.value());
    labels.find_map(|label| label?.strip_prefix(start)?.parse().ok())
}

fn mean_edge(page: &mut Page) -> f64 {
    surface::measure::mean_edge_length(page.mesh())
}

#[test]
fn d_simplifies_to_a_quarter_and_u_subdivides() {
    let mut page = sphere();
    page.press(Key::D);
    assert_eq!(page.mesh().face_count(), 80);
    page.press(Key::U);
    assert_eq!(page.mesh().face_count(), 320);
    page.press_with(Modifiers::COMMAND, Key::Z);
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(page.mesh().face_count(), 320);
    assert_eq!(page.undo_labels().len(), 1);
}

#[test]
fn equals_and_minus_change_the_length_that_r_resamples_to() {
    let mut page = sphere();
    assert_eq!(target_edge(&page), None, "nothing is set at first");
    let mean = mean_edge(&mut page);
    for _ in 0..7 {
        page.press(Key::Equals);
    }
    let long = target_edge(&page).expect("the status bar says it");
    assert!((long / mean - 1.1_f64.powi(7)).abs() < 0.01, "{long} is 1.1^7 times {mean}");
    page.press(Key::R);
    let coarse = page.mesh().face_count();
    assert!(coarse < 200, "{coarse} triangles of twice the side");
    assert!((mean_edge(&mut page) / long - 1.0).abs() < 0.25);
    for _ in 0..7 {
        page.press(Key::Minus);
    }
    let short = target_edge(&page).expect("it stays set");
    assert!((short / mean - 1.0).abs() < 0.01, "as often down as up");
    page.press(Key::R);
    assert!(page.mesh().face_count() > 200, "finer again");

    // For another mesh a length means nothing.
    page.command(json!({ "op": "new", "shape": "cube" }));
    assert_eq!(target_edge(&page), None);
}

#[test]
fn simplify_takes_one_of_three_targets() {
    let mut page = sphere();
    page.choose("Simplify");
    assert_eq!(promise(&page), "Result: 160 of 320 triangles");
    assert!(page.has("Preserve boundary") && page.has("Preserve seams"));
    page.type_into("Ratio", "0.3");
    assert_eq!(promise(&page), "Result: 96 of 320 triangles");

    // Another way starts where the last one was.
    page.click("Simplify to");
    page.click("Triangles");
    assert_eq!(promise(&page), "Result: 96 of 320 triangles");
    page.type_into("Triangles", "1000");
    assert_eq!(promise(&page), "Result: 320 of 320 triangles", "there are no more");
    page.type_into("Triangles", "64");
    page.apply("Simplify");
    assert_eq!(page.mesh().face_count(), 64);

    page.press_with(Modifiers::COMMAND, Key::Z);
    page.choose("Simplify");
    page.click("Simplify to");
    page.click("Max error");
    page.apply("Simplify");
    let left = page.mesh().face_count();
    assert!(left <= 320 && left > 64, "{left}: a thousandth of the size is little");
}

#[test]
fn remeshing_starts_from_the_mesh_s_own_length() {
    let mut page = sphere();
    page.choose("Remesh");
    page.click("Set Edge length");
    assert!((target_edge(&page).expect("set in the form") / mean_edge(&mut page) - 1.0).abs() < 0.01);
}

#[test]
fn remeshing_shows_an_estimate_or_none() {
    // Whether it can be said how much is made, for the mean length and for multiples of it.
    let shapes = [
        (json!({ "op": "new", "shape": "cube" }), [true; 4]),
        (json!({ "op": "new", "shape": "dodecahedron" }), [true; 4]),
        (json!({ "op": "new", "shape": "plane" }), [true; 4]),
        (json!({ "op": "new", "shape": "cylinder" }), [true; 4]),
        (json!({ "op": "new", "shape": "ico-sphere", "subdivisions": 2 }), [true; 4]),
        // Too large to be tried out.
        (json!({ "op": "new", "shape": "ico-sphere", "subdivisions": 4 }), [true, true, true, false]),
        (json!({ "op": "new", "shape": "torus" }), [true, true, true, false]),
        (json!({ "op": "new", "shape": "teapot" }), [true, true, true, false]),
        (json!({ "op": "new", "shape": "grid", "columns": 60, "rows": 60 }), [true, true, true, false]),
    ];
    for (new, is_said) in shapes {
        let mut page = Page::new();
        page.command(new.clone());
        let mean = mean_edge(&mut page);
        page.choose("Remesh");
        // What is previewed is counted anyway.
        page.click("Live preview");
        page.click("Set Edge length");
        for (times, is_said) in [0.5, 1.0, 1.4, 6.0].into_iter().zip(is_said) {
            page.choose("Remesh");
            page.type_into("Edge length", &format!("{:.5}", mean * times));
            let what = format!("{new} at {times} times its mean length");
            assert_eq!(page.has_part("Result: "), is_said, "{what}");
            if !is_said {
                continue;
            }
            let promised = promise(&page);
            let number: String = promised.chars().filter(char::is_ascii_digit).collect();
            let number: f64 = number.parse().expect("a number");
            page.apply("Remesh");
            let made = page.mesh().face_count() as f64;
            let off = if promised.contains("about") { 0.3 } else { 0.0 };
            assert!((made / number - 1.0).abs() <= off, "{what}: {promised}, {made} made");
            page.press_with(Modifiers::COMMAND, Key::Z);
        }
    }
}

#[test]
fn merging_counts_the_result_beforehand() {
    let mut page = Page::new();
    page.command(json!({ "op": "new", "shape": "grid", "size": 10.0, "columns": 10, "rows": 10 }));
    page.choose("Merge by distance");
    assert_eq!(promise(&page), "Result: 121 of 121 vertices");
    page.type_into("Distance", "1.1");
    let promised = promise(&page);
    page.apply("Merge by distance");
    let left = page.mesh().vertex_count();
    assert_eq!(promised, format!("Result: {left} of 121 vertices"));
    assert!(left < 121);
}

#[test]
fn every_whole_mesh_form_works_with_its_initial_values() {
    let names = [
        "Smooth",
        "Subdivide (Catmull-Clark)",
        "Subdivide (Loop)",
        "Subdivide (linear)",
        "Simplify",
        "Remesh",
    ];
    for name in names {
        let mut page = sphere();
        page.choose(name);
        page.apply(name);
        assert_eq!(page.undo_labels().len(), 2, "{name}");
        assert!(page.mesh().validate().is_ok(), "{name}");
        assert!(page.has("Adjust last operation") && page.has(name), "{name}");
    }
}

#[test]
fn a_quick_operation_follows_its_fields_while_they_are_dragged() {
    let mut page = sphere();
    page.command(json!({ "op": "smooth", "iterations": 1, "strength": 0.5 }));
    let once = page.mesh().clone();
    let field = page.harness.get_all_by_label("Strength").next().expect("its strength").rect().center();
    page.drag(field, field + egui::vec2(-60.0, 0.0));
    let during = page.mesh().clone();
    assert_ne!(during, once, "the mesh follows before the button is let go");
    page.drop(field + egui::vec2(-60.0, 0.0));
    assert_eq!(page.undo_labels().len(), 2, "in place of itself: {:?}", page.undo_labels());
    page.press_with(Modifiers::COMMAND, Key::Z);
    page.press_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    assert_eq!(page.mesh(), &during);
}

/// A sphere that is large enough for its operations to be jobs, simplified.
fn adjusted_job() -> Page {
    let mut page = Page::new();
    page.command(json!({ "op": "new", "shape": "ico-sphere", "subdivisions": 5 }));
    page.command(json!({ "op": "simplify", "faces": 5000 }));
    assert_eq!(page.mesh().face_count(), 5000);
    page.outside.hold_jobs();
    page.type_into("Triangles", "4000");
    page
}

#[test]
fn a_job_is_adjusted_from_its_original_input() {
    let mut page = adjusted_job();
    assert_eq!(page.mesh().face_count(), 20_480, "what it runs on");
    page.outside.release_jobs();
    page.run();
    assert_eq!(page.mesh().face_count(), 4000);
    assert_eq!(page.undo_labels(), ["New shape", "Simplify"]);
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(page.mesh().face_count(), 20_480);
}

#[test]
fn a_cancelled_adjustment_restores_the_last_result() {
    let mut page = adjusted_job();
    page.wait();
    page.click("Cancel Simplify");
    assert_eq!(page.mesh().face_count(), 5000);
    assert_eq!(page.undo_labels(), ["New shape", "Simplify"]);
    assert!(page.has("Adjust last operation") && page.has("Simplify"), "and it can be adjusted again");
    page.outside.release_jobs();
    page.run();
    assert_eq!(page.mesh().face_count(), 5000);
}

#[test]
fn a_number_counts_when_it_is_typed_and_may_be_an_expression() {
    let mut page = Page::new();
    page.command(json!({"op": "extrude-faces", "faces": [0], "distance": 1}));
    let distance = |page: &mut Page| {
        page.app().editor().last_command().expect("the extrusion").to_value()["distance"].clone()
    };
    page.harness.get_by_role_and_label(Role::SpinButton, "Distance").click();
    page.run();
    page.press_with(Modifiers::COMMAND, Key::A);
    for letter in ["0", ".", "2"] {
        page.harness.event(egui::Event::Text(letter.into()));
        page.run();
        assert_eq!(distance(&mut page), 1.0, "half a number changes nothing");
    }
    page.press(Key::Enter);
    assert_eq!(distance(&mut page), 0.2);
    page.type_into("Distance", "3/4");
    assert_eq!(distance(&mut page), 0.75);
    page.type_into("Distance", "three");
    assert_eq!(distance(&mut page), 0.75, "what is no number leaves the value");
    assert_eq!(page.undo_labels(), ["Extrude faces"]);
}
