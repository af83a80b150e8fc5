//! The welcome view: it offers where to start, is in nobody's way, and goes away with the first action.

use crate::page::{DESKTOP, PHONE, Page};
use egui::{Key, Modifiers, Vec2, vec2};
use egui_kittest::kittest::Queryable;
use serde_json::json;

const FULL_HD: Vec2 = vec2(1920.0, 1080.0);
const SIZES: [Vec2; 3] = [DESKTOP, FULL_HD, PHONE];

fn is_shown(page: &Page) -> bool {
    page.has("Close welcome")
}

/// The middle of a visible face of the cube.
fn on_model(page: &mut Page) -> egui::Pos2 {
    page.at([0.0, 0.3, 1.0])
}

fn click_at(page: &mut Page, at: egui::Pos2) {
    page.harness.hover_at(at);
    page.run();
    page.harness.drag_at(at);
    page.run();
    page.harness.drop_at(at);
    page.run();
}

#[test]
fn a_first_visit_offers_where_to_start_and_the_document_is_the_cube() {
    for size in SIZES {
        let mut page = Page::welcoming(size);
        assert!(is_shown(&page) && page.has("Open file…"));
        for name in ["Mug", "Fox", "Chair", "Pawn", "Teapot", "Cube", "Grid", "Sphere", "Cylinder", "Torus"] {
            assert!(page.has(&format!("Start with {name}")), "{name} at {size}");
        }
        assert_eq!((page.mesh().face_count(), page.undo_labels().len()), (6, 0));
        assert!(!page.app().editor().is_dirty());
    }
}

#[test]
fn it_covers_no_part_of_the_model_or_the_lists() {
    for size in SIZES {
        let mut page = Page::welcoming(size);
        let viewport = page.find("Viewport").rect();
        let top = page.find("Close welcome").rect().top();
        for v in 0..8 {
            let corner = page.mesh().position(halfedge::VertexId::new(v)).to_array();
            let at = page.at(corner);
            assert!(viewport.contains(at) && at.y < top, "{size}: {at:?} is not above {top} in {viewport:?}");
        }
        for node in page.harness.query_all_by_label_contains("Start with ") {
            assert!(
                viewport.expand(1.0).y_range().contains(node.rect().center().y),
                "{size}: {:?}",
                node.rect()
            );
        }
    }
}

#[test]
fn the_sizes_of_a_new_shape_can_be_adjusted() {
    let mut page = Page::welcoming(DESKTOP);
    page.click("Start with Cylinder");
    assert_eq!(page.mesh().face_count(), 34);
    page.type_into("Segments", "16");
    assert_eq!(page.mesh().face_count(), 18);
    page.type_into("Rings", "4");
    assert_eq!(page.mesh().face_count(), 2 + 4 * 16);
    assert_eq!(page.undo_labels(), ["New shape"], "one step");
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!((page.mesh().face_count(), page.undo_labels().len()), (6, 0));
}

#[test]
fn a_click_on_the_model_closes_it_and_selects() {
    for size in [DESKTOP, PHONE] {
        let mut page = Page::welcoming(size);
        page.press_with(Modifiers::NONE, Key::Tab);
        assert!(is_shown(&page), "Tab moves the focus");
        let mut page = Page::welcoming(size);
        let at = on_model(&mut page);
        click_at(&mut page, at);
        assert!(!is_shown(&page));
        assert_eq!(page.selected().1.len(), 1, "the click counts");
    }
}

#[test]
fn keys_scripts_files_and_menus_close_it() {
    let mut page = Page::welcoming(DESKTOP);
    page.press(Key::Num4);
    assert!(!is_shown(&page));
    assert_eq!(page.app().script().state()["view"]["list"], "face", "the key counts");

    let mut page = Page::welcoming(DESKTOP);
    page.press(Key::Escape);
    assert!(!is_shown(&page));

    let mut page = Page::welcoming(DESKTOP);
    page.select("face", &[1]);
    assert!(!is_shown(&page), "a script");

    let mut page = Page::welcoming(DESKTOP);
    page.command(json!({ "op": "poke-faces", "faces": [0] }));
    assert!(!is_shown(&page), "a command");

    let mut page = Page::welcoming(DESKTOP);
    page.open("dot.obj", "v 0 0 0\n");
    assert!(!is_shown(&page), "a file");

    let mut page = Page::welcoming(DESKTOP);
    page.click("Close welcome");
    assert!(!is_shown(&page));
}

#[test]
fn opening_asks_for_a_file_and_waits_for_it() {
    let mut page = Page::welcoming(DESKTOP);
    page.click("Open file…");
    assert_eq!(page.outside.dialogs(), 1);
    assert!(is_shown(&page), "the dialog may be cancelled");
}

#[test]
fn samples_and_shapes_open_as_documents_that_undo_takes_back() {
    for (name, faces) in [("Mug", 204), ("Fox", 163), ("Chair", 118), ("Pawn", 322)] {
        let mut page = Page::welcoming(DESKTOP);
        page.click(&format!("Start with {name}"));
        assert!(!is_shown(&page));
        assert_eq!(page.app().editor().document().name(), name);
        assert_eq!(page.mesh().face_count(), faces);
        assert!(page.mesh().validate().is_ok() && !page.app().editor().is_dirty());
        page.press_with(Modifiers::COMMAND, Key::Z);
        assert_eq!(page.mesh().face_count(), 6);
    }
    let mut page = Page::welcoming(DESKTOP);
    page.click("Start with Teapot");
    assert!(page.app().editor().document().active().is_some_and(|object| object.bezier().is_some()));
    let mut page = Page::welcoming(DESKTOP);
    page.click("Start with Torus");
    assert_eq!(page.app().editor().document().name(), "Torus");
    assert!(!is_shown(&page) && !page.app().editor().is_dirty());
}

#[test]
fn it_stays_away_where_a_file_is_wanted_and_where_it_was_switched_off() {
    let page = Page::welcoming_wanting("https://a.example/model.obj");
    assert!(!is_shown(&page));
    assert!(!is_shown(&Page::new()), "it was switched off");

    let mut page = Page::welcoming(DESKTOP);
    page.click("Show at start");
    assert_eq!(page.outside.setting("welcome").as_deref(), Some("off"));
    page.click("Show at start");
    assert_eq!(page.outside.setting("welcome").as_deref(), Some("on"));
}

#[test]
fn the_help_menu_shows_it_again() {
    let mut page = Page::new();
    page.press(Key::F3);
    page.find("Find a command").type_text("samples");
    page.run();
    page.press(Key::Enter);
    assert!(is_shown(&page));
    page.click("Welcome");
    assert!(!is_shown(&page), "the button in the bar");
}

#[test]
fn it_offers_the_preset_of_keys_and_stays_open() {
    let mut page = Page::welcoming(DESKTOP);
    page.click("Blender keys");
    assert!(is_shown(&page));
    assert_eq!(page.outside.setting("keys").as_deref(), Some("blender"));
}
