//! The inspector and the operations panel.

use crate::page::Page;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};
use halfedge::{Color, Element, FaceId, HalfedgeId, VertexId, keys};
use serde_json::json;

#[test]
fn a_drag_on_a_spin_box_is_one_step() {
    let mut page = Page::new();
    page.select("vertex", &[2]);
    let before = page.mesh().position(VertexId::new(2));
    let start = page.find("Position x").rect().center();
    page.drag(start, start + egui::vec2(40.0, 0.0));
    let during = page.mesh().position(VertexId::new(2));
    assert!(during.x > before.x, "the mesh follows the drag: {before} to {during}");
    page.drop(start + egui::vec2(40.0, 0.0));
    let after = page.mesh().position(VertexId::new(2));
    assert_eq!((after.y, after.z), (before.y, before.z));
    assert_eq!(page.undo_labels().len(), 1, "{:?}", page.undo_labels());
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(page.mesh().position(VertexId::new(2)), before);
    assert!(page.undo_labels().is_empty());
}

#[test]
fn coordinates_of_far_models_are_those_of_the_file() {
    let mut page = Page::new();
    page.select("vertex", &[0]);
    assert!(!page.has("Offset"));
    page.open("far.obj", "v 1000000000.5 0 0\nv 1000000001.5 0 0\nv 1000000000.5 1 0\nf 1 2 3\n");
    page.select("vertex", &[0]);
    let offset = page.app().editor().document().offset();
    assert!(offset.x >= 1e9);
    assert!(page.has("Offset") && page.has(&format!("{}, {}, {}", offset.x, offset.y, offset.z)));
    assert_eq!(page.find("Position x").accesskit_node().numeric_value(), Some(1000000000.5));
    let row = page.row("Vertex 0").accesskit_node().value().unwrap_or_default();
    assert!(row.starts_with("x 1000000000.50, "), "{row}");
    page.click("Position x");
    page.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    page.harness.event(egui::Event::Text("1000000002.25".to_owned()));
    page.press(Key::Enter);
    let x = f64::from(page.mesh().position(VertexId::new(0)).x) + offset.x;
    assert_eq!(x, 1000000002.25);
}

#[test]
fn a_typed_coordinate_is_one_step() {
    let mut page = Page::new();
    page.select("vertex", &[5]);
    page.click("Position y");
    page.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    page.harness.event(egui::Event::Text("2.5".to_owned()));
    page.run();
    assert!(page.undo_labels().is_empty(), "nothing before Enter");
    page.press(Key::Enter);
    assert_eq!(page.mesh().position(VertexId::new(5)).y, 2.5);
    assert_eq!(page.undo_labels().len(), 1, "{:?}", page.undo_labels());
}

#[test]
fn pointers_of_a_half_edge_select() {
    let mut page = Page::new();
    let h = HalfedgeId::new(4);
    let (next, face, vertex) = {
        let mesh = page.mesh();
        (mesh.next(h).raw(), mesh.face_of(h).map(FaceId::raw), mesh.to(h).raw())
    };
    page.select("halfedge", &[4]);
    page.click(&format!("Next: Half-edge {next}"));
    assert_eq!(page.selected(), (Element::Halfedge, vec![next]));
    page.select("halfedge", &[4]);
    page.click(&format!("Face: Face {}", face.expect("a cube has no boundary")));
    assert_eq!(page.selected(), (Element::Face, vec![face.expect("a face")]));
    page.select("halfedge", &[4]);
    page.click(&format!("Vertex: Vertex {vertex}"));
    assert_eq!(page.selected(), (Element::Vertex, vec![vertex]));
    page.select("halfedge", &[4]);
    page.click("Edge: Edge 2");
    assert_eq!(page.selected(), (Element::Edge, vec![2]));
}

#[test]
fn picking_a_colour_is_one_step() {
    let mut page = Page::new();
    page.select("face", &[1, 2]);
    page.click("Face colour");
    page.click("#4c9aff");
    assert_eq!(page.undo_labels().len(), 1, "{:?}", page.undo_labels());
    // A drag along a slider is one step more.
    let slider = page.harness.get_by_role_and_label(egui::accesskit::Role::Slider, "Saturation").rect();
    page.drag(slider.left_center() + egui::vec2(60.0, 0.0), slider.left_center() + egui::vec2(20.0, 0.0));
    page.drop(slider.left_center() + egui::vec2(20.0, 0.0));
    let color = |page: &mut Page, f| page.mesh().get(keys::FACE_COLOR, f);
    let picked = color(&mut page, 1);
    let [r, g, b] = picked.0;
    assert!(b > g && g > r && r > 0x4c, "a paler blue: {picked:?}");
    assert_eq!(color(&mut page, 2), picked, "all selected faces");
    assert_eq!(color(&mut page, 3), Color::UNPAINTED);
    assert_eq!(page.undo_labels().len(), 2, "{:?}", page.undo_labels());
    page.press(Key::Escape);
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(color(&mut page, 1), Color([0x4c, 0x9a, 0xff]));
}

#[test]
fn measures_are_right() {
    let mut page = Page::new();
    page.select("face", &[0]);
    let side = {
        let mesh = page.mesh();
        let [a, b] = mesh.ends(halfedge::EdgeId::new(0));
        mesh.position(a).distance(mesh.position(b))
    };
    assert!(page.has(&format!("{:.6}", side * side)), "the area of a cube's face");
    page.select("edge", &[0]);
    assert!(page.has(&format!("{side:.6}")), "the length of a cube's edge");
    page.select("vertex", &[0]);
    assert!(page.has("3"), "the valence of a cube's vertex");
}

#[test]
fn an_edge_is_split_where_and_how_the_form_says() {
    let mut page = Page::new();
    page.select("edge", &[0]);
    page.click("Cut");
    page.click("Split both faces");
    page.click("Split edge");
    // Both squares are cut to the corner halfway round.
    assert_eq!((page.mesh().vertex_count(), page.mesh().face_count()), (9, 8));
    assert!(page.mesh().validate().is_ok());
}

#[test]
fn a_button_that_does_not_apply_says_why() {
    let mut page = Page::new();
    page.command(json!({ "op": "new", "shape": "tetrahedron" }));
    page.select("face", &[0]);
    page.open_not_now();
    let node = page.find("Triangulate");
    let node = node.accesskit_node();
    assert!(node.is_disabled());
    assert_eq!(node.description(), Some("The selected faces are triangles already.".to_owned()));
}

#[test]
fn a_shape_is_made_with_the_sizes_of_the_form() {
    let mut page = Page::new();
    page.choose("New shape");
    page.click("Shape");
    page.click("Grid");
    for (field, value) in [("Columns", "7"), ("Rows", "3")] {
        page.click(field);
        page.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        page.harness.event(egui::Event::Text(value.to_owned()));
        page.run();
        page.press(Key::Enter);
    }
    assert!(page.has("Result: 21 faces"));
    page.apply("New shape");
    assert_eq!(page.mesh().face_count(), 21);
}

#[test]
fn a_subdivision_predicts_its_size() {
    let mut page = Page::new();
    page.choose("Subdivide (Catmull-Clark)");
    page.click("Levels");
    page.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    page.harness.event(egui::Event::Text("3".to_owned()));
    page.run();
    page.press(Key::Enter);
    assert!(page.has("Result: 384 faces"));
    let apply =
        page.harness.get_by_role_and_label(egui::accesskit::Role::Button, "Subdivide (Catmull-Clark)");
    apply.click();
    page.run();
    assert_eq!(page.mesh().face_count(), 384);
    assert_eq!(page.undo_labels().len(), 1);
}

#[test]
fn texts_use_one_spelling() {
    let american = |text: &str| {
        let text = text.to_lowercase();
        ["color", "neighbor", "center", "gray"].into_iter().find(|word| text.contains(word))
    };
    for spec in editor::OpId::ALL.iter().map(|id| id.spec()) {
        let words = |field: &editor::ops::Field| {
            [field.label(), field.description.to_owned(), field.default_words().unwrap_or_default()]
        };
        let texts = [spec.label, spec.description].map(str::to_owned);
        for text in texts.into_iter().chain(spec.fields.iter().flat_map(words)) {
            assert_eq!(american(&text), None, "{}: {text}", spec.name);
        }
    }
    let mut page = Page::new();
    page.command(json!({ "op": "set-face-color", "faces": [1], "color": "#4c9aff" }));
    for kind in Element::ALL {
        page.select(&kind.to_string(), &[1]);
        for node in page.harness.root().children_recursive() {
            let node = node.accesskit_node();
            for text in [node.label(), node.value()].into_iter().flatten() {
                assert_eq!(american(&text), None, "{kind}: {text}, {:?}", node.role());
            }
        }
    }
}

#[test]
fn what_is_counted_is_a_click_away() {
    let mut page = Page::new();
    assert!(page.has("Boundary loops: 0"));
    page.command(json!({ "op": "delete-faces", "faces": [0] }));
    page.harness.get_by_role_and_label(egui::accesskit::Role::Link, "Boundary loops: 1").click();
    page.run();
    let (kind, ids) = page.selected();
    assert_eq!((kind, ids.len()), (Element::Edge, 4));
}

#[test]
fn a_click_on_the_components_selects_the_small_pieces() {
    let mut page = Page::new();
    let components = |page: &Page, text: &str| {
        page.harness.query_by_role_and_label(egui::accesskit::Role::Link, text).is_some()
    };
    assert!(!components(&page, "Components: 1"), "nothing to select");
    page.command(json!({ "op": "new", "shape": "tetrahedron", "add": true }));
    page.command(json!({ "op": "join-objects" }));
    page.run();
    assert!(components(&page, "Components: 2"));
    page.harness.get_by_role_and_label(egui::accesskit::Role::Link, "Components: 2").click();
    page.run();
    let (kind, ids) = page.selected();
    assert_eq!((kind, ids.len()), (Element::Face, 4));
    page.press(egui::Key::Delete);
    page.run();
    assert_eq!(page.mesh().face_count(), 6, "the cube is left");
}
