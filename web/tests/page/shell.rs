//! New documents, the document's panel, the operations panel and the welcome view.

use crate::page::Page;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};
use serde_json::json;

const CTRL: Modifiers = Modifiers::COMMAND;
const TETRAHEDRON: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

#[test]
fn a_new_document_asks_nothing_and_undo_brings_the_old_one_back() {
    let mut page = Page::new();
    page.open("pyramid.obj", TETRAHEDRON);
    page.command(json!({ "op": "new", "shape": "torus", "add": true }));
    let old = page.app().editor().document().clone();
    page.press_with(CTRL | Modifiers::ALT, Key::N);
    assert_eq!(page.app().editor().document().name(), "Cube");
    assert_eq!((page.mesh().vertex_count(), page.app().editor().document().objects().len()), (8, 1));
    assert!(page.has_part("pyramid is kept"), "what became of the old one is said");
    assert!(page.app().editor().is_dirty(), "the old document was not saved");
    page.harness.get_by_role_and_label(egui::accesskit::Role::Link, "Undo").click();
    page.run();
    assert_eq!(page.app().editor().document(), &old);
    page.press_with(CTRL, Key::Y);
    assert_eq!(page.app().editor().document().name(), "Cube");
}

#[test]
fn after_a_saved_document_a_new_one_has_nothing_to_save() {
    let mut page = Page::new();
    page.open("pyramid.obj", TETRAHEDRON);
    assert!(!page.app().editor().is_dirty());
    page.click("File");
    page.click("New Ctrl+Alt+N");
    assert!(!page.app().editor().is_dirty());
    page.press_with(CTRL, Key::Z);
    assert_eq!(page.app().editor().document().name(), "pyramid");
}

fn facts(page: &Page) -> Vec<String> {
    let nodes = page.harness.root().children_recursive();
    let labels = nodes.filter_map(|node| node.accesskit_node().label().or(node.value()));
    labels.filter(|label| label.contains(": ")).collect()
}

fn assert_facts(page: &Page, expected: &[&str]) {
    let facts = facts(page);
    for fact in expected {
        assert!(facts.iter().any(|found| found == fact), "{fact} is not among {facts:?}");
    }
}

#[test]
fn with_nothing_selected_the_panel_is_about_the_document() {
    let mut page = Page::new();
    assert_facts(
        &page,
        &[
            "Document: Cube",
            "Dimensions: 2 × 2 × 2",
            "Surface area: 24",
            "Volume: 8",
            "Vertices: 8",
            "Edges: 12",
            "Half-edges: 24",
            "Faces: 6",
            "Watertight: yes",
            "Boundary loops: 0",
            "Components: 1",
            "Euler characteristic: 2",
            "Genus: 0",
        ],
    );
    assert!(!page.has("Shape"), "no form that would replace the document");
    page.select("face", &[0]);
    assert!(page.has("Face 0") && !page.has_part("Surface area: "));
    page.press(Key::Delete);
    assert_facts(&page, &["Watertight: no", "Boundary loops: 1", "Surface area: 20", "Genus: 0"]);
    assert!(!page.has_part("Volume: "), "an open surface has none");
    page.command(json!({ "op": "new", "shape": "torus" }));
    assert_facts(&page, &["Document: Torus", "Genus: 1", "Euler characteristic: 0"]);
    page.command(json!({ "op": "new", "shape": "cube", "size": 0.5, "add": true }));
    assert_facts(&page, &["Name: Cube", "Dimensions: 0.5 × 0.5 × 0.5", "Volume: 0.125"]);
    assert!(page.has_part("2 objects"));
}

#[test]
fn sizes_follow_an_edit_and_its_undo() {
    let mut page = Page::new();
    page.command(json!({ "op": "transform", "vertices": [0, 1, 2, 3, 4, 5, 6, 7], "scale": [1, 2, 1] }));
    assert_facts(&page, &["Dimensions: 2 × 4 × 2", "Volume: 16", "Surface area: 40"]);
    page.press_with(CTRL, Key::Z);
    assert_facts(&page, &["Dimensions: 2 × 2 × 2", "Volume: 8"]);
}

/// The names of the panel's rows from top to bottom, the headings among them.
fn listed(page: &Page) -> Vec<String> {
    let top = page.find("Filter operations").rect().bottom();
    let left = page.find("Filter operations").rect().left();
    let mut rows: Vec<(f32, String)> = page
        .harness
        .root()
        .children_recursive()
        .filter(|node| node.accesskit_node().raw_bounds().is_some())
        .filter(|node| node.rect().top() >= top && (left - 1.0..left + 40.0).contains(&node.rect().left()))
        .filter_map(|node| {
            let accesskit = node.accesskit_node();
            Some((node.rect().top(), accesskit.label().or_else(|| accesskit.value())?))
        })
        // Below the list is the closed history.
        .filter(|(_, text)| !text.is_empty() && text != "History panel")
        .collect();
    rows.sort_by(|a, b| a.0.total_cmp(&b.0));
    // A label has its text in a node of its own.
    rows.dedup_by(|a, b| a.1 == b.1);
    rows.into_iter().map(|(_, text)| text).collect()
}

#[test]
fn operations_on_the_selection_come_first_and_refused_ones_last_with_their_reasons() {
    let mut page = Page::new();
    let rows = listed(&page);
    assert_eq!(rows.first().map(String::as_str), Some("Whole mesh"), "{rows:?}");
    page.select("face", &[0]);
    let rows = listed(&page);
    let at =
        |text: &str| rows.iter().position(|row| row == text).unwrap_or_else(|| panic!("{text}: {rows:?}"));
    assert_eq!((at("Selected face"), at("Transform…"), at("Extrude faces")), (0, 1, 2));
    assert!(at("Extrude faces") < at("Delete faces") && at("Delete faces") < at("Whole mesh"));
    assert!(rows.last().is_some_and(|row| row.starts_with("Not now")), "{rows:?}");
    assert!(!page.has("Flip edge"));
    page.open_not_now();
    let reason = "Select an edge first.";
    assert!(page.has("Flip edge") && page.has(reason));
    let flip = page.harness.get_by_label("Flip edge");
    assert!(flip.accesskit_node().is_disabled());
    page.select("face", &[0, 1, 2]);
    assert_eq!(listed(&page).first().map(String::as_str), Some("3 selected faces"));
}

#[test]
fn the_filter_finds_operations_by_other_names_and_enter_starts_the_first() {
    let mut page = Page::new();
    page.click("Filter operations");
    page.harness.event(egui::Event::Text("decimate".to_owned()));
    page.run();
    assert_eq!(listed(&page), ["Simplify…"]);
    page.press(Key::Enter);
    assert!(page.has("All operations") && page.has("Simplify to"));
    page.click("All operations");
    page.click("Clear the filter");
    assert_eq!(listed(&page).first().map(String::as_str), Some("Whole mesh"));
    page.click("Filter operations");
    page.harness.event(egui::Event::Text("no such thing".to_owned()));
    page.run();
    assert_eq!(listed(&page), ["No operation matches."]);
}

#[test]
fn a_row_acts_at_once_on_the_selection() {
    let mut page = Page::new();
    page.select("face", &[0]);
    page.click("Poke faces");
    assert_eq!((page.mesh().face_count(), page.undo_labels()), (9, vec!["Poke faces".to_owned()]));
}

#[test]
fn an_applied_form_gives_way_to_adjusting() {
    let mut page = Page::new();
    page.choose("Smooth");
    page.apply("Smooth");
    assert!(!page.has("All operations") && page.has("Adjust last operation"));
}
