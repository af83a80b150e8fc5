//! Input of slow frames: what is typed within one frame goes where it would go if each key had a frame of its own.

use crate::page::Page;
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers};
use egui_kittest::kittest::Queryable;
use halfedge::Element;

const CTRL: Modifiers = Modifiers::COMMAND;

/// Types within one frame: keys with Ctrl, Enter as `\n`, and text with its keys.
fn type_at_once(page: &mut Page, control: Option<Key>, text: &str) {
    let mut events = Vec::new();
    let mut strike = |key: Key, modifiers: Modifiers, text: Option<char>| {
        let event = |pressed| Event::Key { key, physical_key: None, pressed, repeat: false, modifiers };
        events.push(event(true));
        events.extend(text.map(|letter| Event::Text(letter.to_string())));
        events.push(event(false));
    };
    control.into_iter().for_each(|key| strike(key, CTRL, None));
    for letter in text.chars() {
        match letter {
            '\n' => strike(Key::Enter, Modifiers::NONE, None),
            letter => {
                let name = letter.to_uppercase().to_string();
                strike(Key::from_name(&name).expect("a key"), Modifiers::NONE, Some(letter));
            }
        }
    }
    page.harness.input_mut().events.extend(events);
    page.harness.step();
    page.run();
}

fn value(page: &Page, field: &str) -> Option<String> {
    page.harness.get_by_role_and_label(Role::TextInput, field).value()
}

#[test]
fn what_is_typed_after_enter_goes_into_the_field_that_enter_opened() {
    let mut page = Page::new();
    type_at_once(&mut page, Some(Key::K), "save\nmug");
    assert_eq!(value(&page, "File name").as_deref(), Some("Cubemug"), "after the name that is there");
    assert!(page.undo_labels().is_empty() && page.mesh().face_count() == 6, "no letter was taken for a key");

    // And the next Enter saves under that name.
    let mut page = Page::new();
    type_at_once(&mut page, Some(Key::K), "save\nmug\n");
    let saved: Vec<String> = page.outside.downloads().into_iter().map(|file| file.name).collect();
    assert_eq!(saved, ["Cubemug.obj"]);
}

#[test]
fn what_is_typed_after_enter_closed_a_field_is_for_the_viewport() {
    let mut page = Page::new();
    page.press(Key::Num4);
    // To face 4, and extrude it by 2.
    type_at_once(&mut page, Some(Key::G), "4\ne2\n");
    assert_eq!(page.selected(), (Element::Face, vec![4]));
    assert_eq!(page.undo_labels(), ["Extrude faces"]);
    assert_eq!(page.mesh().face_count(), 10);
    // A number, and a key of the viewport after it.
    page.select("vertex", &[7]);
    page.harness.get_by_role_and_label(Role::SpinButton, "Position x").click();
    page.run();
    type_at_once(&mut page, Some(Key::A), "3\nw");
    assert_eq!(page.app().editor().element(Element::Vertex, 7).expect("it exists")["position"][0], 3.0);
    assert_eq!(page.app().script().state()["view"]["wireframe"], false, "W switches the wireframe");
}

#[test]
fn keys_that_wait_keep_their_order_with_those_of_later_frames() {
    let mut page = Page::new();
    let strike = |page: &mut Page, letters: &str| {
        for letter in letters.chars() {
            let key = Key::from_name(&letter.to_uppercase().to_string()).expect("a key");
            let event = |pressed| {
                let modifiers = Modifiers::NONE;
                Event::Key { key, physical_key: None, pressed, repeat: false, modifiers }
            };
            let events = [event(true), Event::Text(letter.to_string()), event(false)];
            page.harness.input_mut().events.extend(events);
        }
        page.harness.step();
    };
    page.press_with(CTRL, Key::K);
    page.type_text("save");
    let enter = |pressed| {
        let modifiers = Modifiers::NONE;
        Event::Key { key: Key::Enter, physical_key: None, pressed, repeat: false, modifiers }
    };
    page.harness.input_mut().events.extend([enter(true), enter(false)]);
    strike(&mut page, "ab");
    strike(&mut page, "cd");
    strike(&mut page, "ef");
    page.run();
    assert_eq!(value(&page, "File name").as_deref(), Some("Cubeabcdef"));
}
