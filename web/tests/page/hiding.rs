//! Criteria, hiding, and named selections by menus, keys and windows.

use crate::page::{DESKTOP, PHONE, Page};
use crate::viewport::click_at;
use egui::accesskit::Role;
use egui::{Key, Modifiers, Theme};
use egui_kittest::kittest::{NodeT, Queryable};
use halfedge::Element;
use serde_json::json;

fn hidden(page: &mut Page) -> usize {
    page.app().editor().document().active().expect("an object").hidden().len()
}

/// Chooses an entry of a submenu of the Select menu.
fn choose(page: &mut Page, submenu: &str, entry: &str) {
    page.click("Select");
    page.click(submenu);
    page.click(entry);
}

#[test]
fn criteria_are_chosen_from_the_menu_and_adjusted() {
    let mut page = Page::new();
    page.command(json!({"op": "poke-faces", "faces": [0]}));
    for (entry, kind, count) in [
        ("Select triangles", Element::Face, 4),
        ("Select quads", Element::Face, 5),
        ("Select sharp edges", Element::Edge, 12),
        ("Select facing the view", Element::Face, 0),
    ] {
        choose(&mut page, "By criterion", entry);
        let (now, ids) = page.selected();
        assert_eq!((now, ids.len()), (kind, count), "{entry}");
    }
    assert!(page.has("Select facing the same way: 0 faces found"), "nothing else would show it");
    choose(&mut page, "By criterion", "Select sharp edges");
    page.type_into("Angle", "100");
    assert!(page.selected().1.is_empty());
    page.type_into("Angle", "80");
    assert_eq!(page.selected().1.len(), 12);
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert!(page.selected().1.is_empty(), "one step, as it was before");
    assert_eq!(page.undo_labels(), ["Poke faces"]);

    page.select("face", &[1]);
    choose(&mut page, "Similar", "Same corners or valence");
    assert_eq!(page.selected().1.len(), 5);
    page.press(Key::Num2);
    page.press_with(Modifiers::COMMAND, Key::A);
    page.click("Select");
    page.click("Similar");
    assert!(page.find("Same corners or valence").accesskit_node().is_disabled());
}

#[test]
fn h_hides_alt_h_reveals_and_slash_isolates() {
    let mut page = Page::new();
    page.press(Key::Num4);
    let middle = page.find("Viewport").rect().center();
    click_at(&mut page, middle, Modifiers::NONE);
    let (_, front) = page.selected();
    assert_eq!(front.len(), 1);
    page.press(Key::H);
    assert_eq!((hidden(&mut page), page.selected().1.len()), (1, 0));
    assert!(page.has("1 face hidden"));
    click_at(&mut page, middle, Modifiers::NONE);
    let (_, behind) = page.selected();
    assert_eq!(behind.len(), 1, "what was behind it");
    assert_ne!(front, behind);
    page.press_with(Modifiers::COMMAND, Key::A);
    assert_eq!(page.selected().1.len(), 5);
    page.press_with(Modifiers::COMMAND, Key::I);
    assert!(page.selected().1.is_empty());
    page.press_with(Modifiers::ALT, Key::H);
    assert!(hidden(&mut page) == 0 && !page.has_part("hidden"));

    page.select("face", &front);
    page.press(Key::Slash);
    assert_eq!(hidden(&mut page), 5);
    page.press(Key::Slash);
    assert_eq!(hidden(&mut page), 0, "again reveals");
    assert_eq!(page.undo_labels().last().map(String::as_str), Some("Leave isolation"));
    page.press(Key::Slash);
    page.press(Key::Escape);
    page.press(Key::Slash);
    assert_eq!(hidden(&mut page), 0, "also with nothing selected");
    page.press(Key::Slash);
    assert!(page.has_part("Select something first."));
    for _ in 0..2 {
        page.press_with(Modifiers::COMMAND, Key::Z);
    }
    assert_eq!(hidden(&mut page), 5, "hiding is undone like an edit");
    // In the list and over the viewport.
    let reveals = page.harness.get_all_by_role_and_label(Role::Button, "Reveal").collect::<Vec<_>>();
    assert_eq!(reveals.len(), 2);
    reveals[1].click();
    page.run();
    assert_eq!(hidden(&mut page), 0);
}

#[test]
fn the_note_on_hidden_faces_lies_over_no_bar() {
    for size in [DESKTOP, PHONE] {
        let mut page = Page::sized(size);
        page.command(json!({"op": "hide", "faces": [0]}));
        let note = page.harness.get_by_role_and_label(Role::Button, "Reveal").rect();
        let words = page.find("1 face hidden").rect();
        for button in
            ["Vertex mode", "Edge mode", "Half-edge mode", "Face mode", "Tool: Select", "Tool: Move"]
        {
            let rect = page.find(button).rect();
            assert!(!rect.intersects(note.union(words)), "{button}: {rect} and {note}");
        }
    }
}

#[test]
fn selections_are_named_and_selected_again() {
    let mut page = Page::new();
    page.click("Select");
    page.click("Named selections…");
    assert!(page.has_part("No selection has a name yet"));
    page.select("face", &[1, 2]);
    let type_name = |page: &mut Page, field: &str, name: &str| {
        page.harness.get_by_role_and_label(Role::TextInput, field).click();
        page.run();
        page.press_with(Modifiers::COMMAND, Key::A);
        page.harness.event(egui::Event::Text(name.to_owned()));
        page.run();
        page.press(Key::Enter);
    };
    type_name(&mut page, "Name of the selection", "Sides");
    assert!(page.has("2 faces"));
    page.select("face", &[5]);
    page.click("Add Sides");
    assert_eq!(page.selected().1, [1, 2, 5]);
    page.click("Select Sides");
    assert_eq!(page.selected().1, [1, 2]);
    type_name(&mut page, "Name of Sides", "Walls");
    assert!(page.has("Select Walls") && !page.has("Select Sides"));
    page.click("Delete Walls");
    assert!(page.has_part("No selection has a name yet"));
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert!(page.has("Select Walls"));
    page.press(Key::Escape);
    assert!(!page.has("Select Walls"), "Escape closes the window");
}

#[test]
fn a_large_mesh_is_selected_over_several_frames() {
    let mut page = Page::new();
    page.command(json!({"op": "new", "shape": "grid", "columns": 500, "rows": 500}));
    page.press(Key::Num4);
    page.select("face", &[7]);
    page.harness.key_press_modifiers(Modifiers::COMMAND, Key::L);
    page.harness.step();
    assert_eq!(page.selected().1.len(), 1, "not yet");
    page.run();
    assert_eq!(page.selected().1.len(), 250_000);
    // Escape stops it; the next key waits for it.
    page.press(Key::Escape);
    page.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    page.harness.step();
    page.press(Key::Escape);
    assert!(page.selected().1.is_empty());
    page.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    page.harness.step();
    page.press(Key::H);
    assert_eq!(hidden(&mut page), 250_000);
}

#[test]
fn pictures_of_what_is_hidden_and_named() {
    for (size, theme, name) in
        [(DESKTOP, Theme::Dark, "hidden dark"), (PHONE, Theme::Light, "hidden phone light")]
    {
        let mut page = Page::drawn(size, theme);
        page.command(json!({"op": "new", "shape": "torus"}));
        page.run();
        let before = page.harness.render().expect("a picture");
        page.command(json!({"op": "hide", "faces": (0..200).collect::<Vec<u32>>()}));
        page.command(json!({"op": "select-elements", "faces": [300, 301, 302]}));
        page.command(json!({"op": "name-selection", "name": "Inner ring"}));
        let after = crate::looks::picture(&mut page, name);
        let differ = before.pixels().zip(after.pixels()).filter(|(a, b)| a != b).count();
        assert!(differ > 2000, "{differ}");
        if size == DESKTOP {
            page.click("Select");
            page.click("By criterion");
            crate::looks::picture(&mut page, "criteria menu");
            page.press(Key::Escape);
            page.press(Key::Escape);
            page.click("Select");
            page.click("Named selections…");
            crate::looks::picture(&mut page, "named selections");
        }
    }
}
