//! Telephones, and windows that are narrower still.

use crate::page::{PHONE, Page};
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, PointerButton, Vec2, vec2};
use egui_kittest::kittest::Queryable;
use halfedge::Element;
use serde_json::json;

/// A tap that begins and ends within one frame, as a quick one does where frames are slow.
fn tap(page: &mut Page, label: &str) {
    let at = page.find(label).rect().center();
    let button = |pressed| Event::PointerButton {
        pos: at,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    let events = [Event::PointerMoved(at), button(true), button(false)];
    page.harness.input_mut().events.extend(events);
    page.run();
}

#[test]
fn a_submenu_that_is_opened_again_lies_over_its_parent() {
    let mut page = Page::sized(PHONE);
    page.command(json!({ "op": "poke-faces", "faces": [0] }));
    for (entry, count) in [("Select triangles", 4), ("Select quads", 5), ("Select triangles", 4)] {
        for label in ["Menu", "Select", "By criterion", entry] {
            tap(&mut page, label);
        }
        assert_eq!(page.selected().1.len(), count, "{entry}");
        // The menus close, and are opened again.
        for _ in 0..3 {
            page.harness.key_press(Key::Escape);
        }
        page.run();
    }
}

#[test]
fn choosing_a_kind_of_element_leaves_the_sheet_where_it_is() {
    let mut page = Page::sized(PHONE);
    page.harness.get_by_role_and_label(Role::Tab, "Operations").click();
    page.run();
    page.click("Edge mode");
    assert!(page.has("Filter operations"));
    assert_eq!(page.app().script().state()["view"]["list"], "edge");
}

#[test]
fn the_main_field_of_a_form_is_in_sight() {
    let mut page = Page::sized(PHONE);
    page.command(json!({ "op": "new", "shape": "torus", "segments": 300, "tube_segments": 150 }));
    page.wait();
    page.harness.get_by_role_and_label(Role::Tab, "Operations").click();
    page.run();
    page.choose("Simplify");
    page.run();
    let ratio = page.harness.get_by_role_and_label(Role::SpinButton, "Ratio").rect();
    let below = page.harness.get_by_label_contains("takes too long to show").rect();
    assert!(ratio.bottom() <= below.top(), "{ratio} is above {below}");
}

#[test]
fn the_welcome_view_shows_that_its_tiles_scroll() {
    let page = Page::welcoming(PHONE);
    let card = page.find("Close welcome").rect().right();
    let cut = page.harness.query_all_by_label_contains("Start with").any(|tile| {
        let seen = card - tile.rect().left();
        (0.3..0.7).contains(&(seen / tile.rect().width()))
    });
    assert!(cut, "a tile is cut at the right");
}

#[test]
fn symmetry_that_is_on_shows_on_a_telephone_too() {
    let mut page = Page::sized(PHONE);
    assert!(!page.has("Mirror edits"));
    page.command(json!({ "op": "select-all", "kind": "vertex" }));
    page.press_with(Modifiers::SHIFT, Key::O);
    let soft = page.find("Soft selection").rect();
    assert!(!soft.intersects(page.find("Half-edge mode").rect()));
    page.click("Soft selection");
    assert!(!page.has("Soft selection"));
}

#[test]
fn the_smallest_windows_have_no_negative_sizes() {
    let use_it = |page: &mut Page| {
        for key in [Key::Num4, Key::E] {
            page.press(key);
        }
        let middle = page.find("Viewport").rect().center();
        page.hover(middle);
        page.select("face", &[1]);
        page.press(Key::E);
        page.hover(middle + vec2(3.0, 1.0));
        page.press(Key::Enter);
        page.command(json!({ "op": "hide", "faces": [0] }));
        page.open("broken.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 1 2 9\nv 1 x 2\n");
        page.open("nothing.obj", "# no vertices\n");
        for (modifiers, key) in
            [(Modifiers::COMMAND, Key::K), (Modifiers::COMMAND, Key::S), (Modifiers::NONE, Key::Questionmark)]
        {
            page.press_with(modifiers, key);
            page.press(Key::Escape);
        }
    };
    for (width, height) in [(150.0, 200.0), (97.0, 300.0), (250.0, 150.0), (20.0, 20.0)] {
        let size = Vec2::new(width, height);
        let mut page = Page::welcoming(size);
        use_it(&mut page);
        assert_eq!(page.selected().0, Element::Face, "{size}");
        for tab in ["Elements", "Inspector", "Operations", "History"] {
            page.harness.get_by_role_and_label(Role::Tab, tab).click_accesskit();
            page.run();
        }
        assert!(page.has("Steps"), "{size}");
    }
}

/// The fades over the ends of the strip of tools: bands of four corners, two of them transparent.
fn fades(page: &Page) -> Vec<egui::Rect> {
    let shapes = page.harness.output().shapes.iter();
    let meshes = shapes.filter_map(|clipped| match &clipped.shape {
        egui::Shape::Mesh(mesh) => Some(mesh),
        _ => None,
    });
    // egui fades what is cut off too, over a lesser height.
    let is_fade = |mesh: &&std::sync::Arc<egui::Mesh>| {
        mesh.calc_bounds().height() > 30.0
            && mesh.vertices.len() == 4
            && mesh.vertices.iter().filter(|corner| corner.color == egui::Color32::TRANSPARENT).count() == 2
    };
    meshes.filter(is_fade).map(|mesh| mesh.calc_bounds()).collect()
}

#[test]
fn a_fade_says_that_more_tools_follow() {
    let mut page = Page::sized(PHONE);
    page.run();
    let strip = page.find("Tool: Select").rect();
    let below = fades(&page);
    assert_eq!(below.len(), 1, "{below:?}");
    assert!((below[0].center().x - strip.center().x).abs() < 4.0 && below[0].top() > strip.bottom());
    // Scrolled to the end, the fade is at the top.
    page.hover(strip.center());
    for _ in 0..20 {
        page.turn_wheel(egui::MouseWheelUnit::Point, -200.0);
    }
    let above = fades(&page);
    assert_eq!(above.len(), 1, "{above:?}");
    assert!(above[0].bottom() < below[0].top());
    // On a desktop all tools fit.
    let mut page = Page::new();
    page.run();
    assert!(fades(&page).is_empty());
}
