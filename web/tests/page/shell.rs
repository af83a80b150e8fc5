//! New documents, the document's panel, the operations panel and the welcome view.

use crate::page::Page;
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;
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
