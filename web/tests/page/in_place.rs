//! Saving to the file that was opened, and newer versions of the page.

use editor::MessageKind;
use egui::{Key, Modifiers};
use egui_kittest::kittest::NodeT;
use formats::{Format, NamedBytes};
use meshwright_web::platform::{Event, Placed};
use serde_json::json;

use crate::page::Page;

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// A page with a triangle from a file that can be written again.
fn opened(name: &str) -> Page {
    let mut page = Page::new();
    page.outside.open_writable(vec![NamedBytes::new(name, TRIANGLE)]);
    page.run();
    page
}

fn press_save(page: &mut Page) {
    page.press_with(Modifiers::COMMAND, Key::S);
}

/// The names of the files that were written where they were opened.
fn written(page: &Page) -> Vec<String> {
    page.outside.written().into_iter().map(|file| file.name).collect()
}

#[test]
fn a_file_is_saved_where_it_was_opened() {
    let mut page = opened("Part.OBJ");
    page.command(json!({ "op": "poke-faces", "faces": [0] }));
    assert!(page.app().editor().is_dirty());
    press_save(&mut page);
    assert!(!page.has("File name"), "there is nothing to ask");
    assert!(page.has("Saved Part.OBJ"));
    assert!(!page.app().editor().is_dirty());
    let files = page.outside.written();
    assert_eq!(written(&page), ["Part.OBJ"]);
    assert_eq!(String::from_utf8_lossy(&files[0].bytes).matches("\nf ").count(), 3);
    assert!(page.outside.downloads().is_empty());

    // Again, and by its name in the dialog to the downloads.
    press_save(&mut page);
    assert_eq!(written(&page).len(), 2);
    page.click("File");
    page.click("Save as");
    page.click(Format::from_code("off").expect("a format").save_label());
    page.click("Save");
    assert_eq!(page.outside.downloads()[0].name, "Part.off");
    // The document has gone its own way since.
    press_save(&mut page);
    assert!(page.has("File name"));
}

#[test]
fn another_document_is_not_written_over_the_file() {
    let mut page = opened("part.obj");
    page.press_with(Modifiers::COMMAND, Key::Z);
    press_save(&mut page);
    assert!(page.has("File name"), "undo has brought back the cube");
    page.press(Key::Escape);
    page.press_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    press_save(&mut page);
    assert_eq!(written(&page), ["part.obj"], "redo has brought back the file's document");

    page.open("other.obj", TRIANGLE);
    press_save(&mut page);
    assert!(page.has("File name"), "this one can't be written");
    page.press(Key::Escape);

    // A file that can't be read leaves the document and its file as they are.
    let mut page = opened("part.obj");
    page.outside.open_writable(vec![NamedBytes::new("broken.obj", "f 1 2 3\n")]);
    page.run();
    press_save(&mut page);
    assert_eq!(written(&page), ["part.obj"]);
}

#[test]
fn a_document_from_the_list_is_not_written_over_the_file_of_the_one_before() {
    let mut page = opened("first.obj");
    page.run();
    let outside = page.outside.clone();
    page.outside.advance(6000.0);
    page.run();
    // In another tab, so that both files are opened in the same revision of their editors.
    outside.open_in_new_tab();
    outside.set_setting("document", "");
    let mut page = Page::visit(&outside);
    outside.open_writable(vec![NamedBytes::new("second.obj", TRIANGLE)]);
    page.run();
    page.outside.advance(6000.0);
    page.run();
    page.click("File");
    page.click("Recent documents…");
    page.click("Duplicate first");
    page.click("Open document first copy");
    page.outside.advance(6000.0);
    page.run();
    assert_eq!(page.app().editor().document().name(), "first copy");
    press_save(&mut page);
    assert!(page.has("File name"), "where it goes is asked");
    assert!(written(&page).is_empty());
}

#[test]
fn after_a_reload_the_document_is_saved_to_its_file() {
    let mut page = opened("part.obj");
    page.command(json!({ "op": "poke-faces", "faces": [0] }));
    page.outside.advance(6000.0);
    page.run();
    let mut page = page.reload();
    assert_eq!(page.app().editor().document().name(), "part");
    assert!(page.app().editor().is_dirty());
    press_save(&mut page);
    assert_eq!(written(&page), ["part.obj"]);
    assert!(!page.app().editor().is_dirty());

    // A copy in another tab has no claim to the file.
    let outside = page.outside.clone();
    outside.open_in_new_tab();
    let mut other = Page::visit(&outside);
    press_save(&mut other);
    assert!(other.has("File name"), "where it goes is asked");
    drop(other);

    // Saved under another name, it has left the file, and a reload does not bring it back.
    page.click("File");
    page.click("Save as");
    page.click(Format::from_code("off").expect("a format").save_label());
    page.click("Save");
    page.run();
    let mut page = page.reload();
    press_save(&mut page);
    assert!(page.has("File name"));
    assert_eq!(written(&page).len(), 1);
}

#[test]
fn of_two_saves_in_a_row_each_counts_for_its_own_contents() {
    let mut page = opened("part.obj");
    page.outside.hold_writes();
    for face in [0, 1] {
        page.command(json!({ "op": "poke-faces", "faces": [face] }));
        press_save(&mut page);
    }
    page.outside.release_write();
    page.run();
    assert!(page.app().editor().is_dirty(), "the file has the first contents yet");
    page.outside.release_write();
    page.run();
    assert!(!page.app().editor().is_dirty());
}

#[test]
fn a_file_that_holds_less_is_saved_with_a_note() {
    let mut page = Page::new();
    let stl = Format::from_code("stl").expect("a format");
    let model = page.app().editor().document().to_model("part");
    page.outside.open_writable(formats::write(stl, &model).expect("a cube fits"));
    page.run();
    page.command(json!({ "op": "subdivide-catmull-clark" }));
    press_save(&mut page);
    assert_eq!(written(&page), ["part.stl"]);
    assert!(page.app().editor().is_dirty(), "STL holds no quads");
}

#[test]
fn a_file_that_cannot_be_written_is_said_to_be() {
    let mut page = opened("part.obj");
    page.command(json!({ "op": "poke-faces", "faces": [0] }));
    page.outside.refuse_writes("the browser was not allowed to write it");
    press_save(&mut page);
    let says = |page: &mut Page, text: &str| {
        page.app()
            .editor()
            .messages()
            .any(|message| message.kind == MessageKind::Error && message.text.contains(text))
    };
    assert!(says(&mut page, "part.obj could not be written: the browser was not allowed to write it."));
    assert!(page.app().editor().is_dirty());
    assert!(page.outside.downloads().is_empty());
}

#[test]
fn files_without_a_place_are_downloaded() {
    // Colours of faces go to a material library beside an OBJ, which was not opened.
    let mut page = opened("part.obj");
    page.command(json!({ "op": "set-face-color", "faces": [0], "color": "#ff0000" }));
    press_save(&mut page);
    let downloads: Vec<String> = page.outside.downloads().into_iter().map(|file| file.name).collect();
    assert_eq!(downloads, ["part.obj", "part.mtl"]);
    assert!(written(&page).is_empty());
}

#[test]
fn a_newer_version_is_offered_and_not_forced() {
    let mut page = Page::new();
    let entry = "Reload with the new version";
    page.click("Help");
    assert!(page.find(entry).accesskit_node().is_disabled());
    page.press(Key::Escape);
    page.command(json!({ "op": "poke-faces", "faces": [0] }));
    page.outside.push(Event::UpdateReady);
    page.run();
    assert!(page.has("A new version of Meshwright is ready. Your document is kept when the page reloads."));
    assert_eq!(page.outside.updates(), 0);
    assert_eq!(page.mesh().face_count(), 9);
    // The message goes, the menu still offers it.
    page.click("Dismiss message");
    page.outside.push(Event::UpdateReady);
    page.run();
    assert!(!page.has("Dismiss message"), "it is offered once");
    page.click("Help");
    page.click(entry);
    assert_eq!(page.outside.updates(), 1);
}

#[test]
fn the_installed_page_opens_every_format() {
    let manifest: serde_json::Value =
        serde_json::from_str(include_str!("../../site/manifest.webmanifest")).expect("JSON");
    let accepted = |value: &serde_json::Value| value.to_string();
    let handled = accepted(&manifest["file_handlers"]);
    let shared = accepted(&manifest["share_target"]["params"]["files"]);
    for format in Format::all().filter(|format| format.can_open()) {
        for extension in format.extensions() {
            let quoted = format!("\".{extension}\"");
            assert!(handled.contains(&quoted), "file_handlers leaves out {extension}");
            assert!(shared.contains(&quoted), "share_target leaves out {extension}");
        }
    }
}

#[test]
fn a_document_that_is_given_a_place_is_saved_there_from_then_on() {
    let mut page = Page::new();
    page.outside.ask_where();
    page.command(json!({ "op": "poke-faces", "faces": [0] }));
    let save_to = |page: &mut Page, placed: Option<Result<Placed, String>>| {
        press_save(page);
        page.click("Save");
        page.outside.push(Event::Placed(placed));
        page.run();
    };
    save_to(&mut page, None);
    assert!(page.app().editor().is_dirty(), "the user changed their mind");
    save_to(&mut page, Some(Err("disk.obj can't be written: it is full.".to_owned())));
    assert!(page.has("disk.obj can't be written: it is full."));
    assert!(page.app().editor().is_dirty());

    // A source of the page under test.
    page.outside.open_writable(vec![NamedBytes::new("mug.obj", TRIANGLE)]);
    page.run();
    page.command(json!({ "op": "new", "shape": "cube" }));
    page.command(json!({ "op": "poke-faces", "faces": [0] }));
    let names = vec!["mug.obj".to_owned()];
    save_to(&mut page, Some(Ok(Placed { source: 0, names, notes: Vec::new() })));
    assert!(page.has("Saved mug.obj"));
    assert!(!page.app().editor().is_dirty());
    assert_eq!(page.app().editor().document().name(), "mug");
    page.command(json!({ "op": "poke-faces", "faces": [1] }));
    press_save(&mut page);
    assert!(!page.has("File name"), "its place is known");
    assert_eq!(written(&page), ["mug.obj"]);
}
