//! The save dialog.

use crate::page::Page;
use egui::{Event, Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};
use formats::Format;
use meshwright_web::input::actions;
use serde_json::json;

/// Opens the dialog and types a name over the one that is there.
fn ask(page: &mut Page, name: &str) {
    page.press_with(Modifiers::COMMAND, Key::S);
    page.harness.event(Event::Text(name.to_owned()));
    page.run();
}

fn choose(page: &mut Page, format: &str) {
    page.click("Format");
    page.click(format);
}

/// The names of the files that were saved.
fn saved(page: &Page) -> Vec<String> {
    page.outside.downloads().into_iter().map(|file| file.name).collect()
}

fn is_dirty(page: &mut Page) -> bool {
    page.app().editor().is_dirty()
}

#[test]
fn every_format_is_saved_and_reads_back() {
    let mut page = Page::new();
    page.command(json!({ "op": "triangulate-faces" }));
    for format in Format::all().filter(|format| !format.is_bezier()) {
        let before = page.outside.downloads().len();
        let label = actions::of_format(format).label;
        page.click("File");
        page.click("Save as");
        page.click(label);
        assert_eq!(page.find("Format").value().as_deref(), Some(format.name()));
        page.click("Save");
        let files = page.outside.downloads().split_off(before);
        if format.can_write() {
            let wanted = formats::write(format, &page.app().editor().document().to_model("Cube"));
            assert!(files == wanted.expect("a cube fits"), "{label}");
        }
        assert_eq!(files[0].name, format!("Cube.{}", format.extension()));
        if format.code() != "json" {
            page.outside.push(meshwright_web::platform::Event::Files(files));
            page.run();
            let mesh = page.mesh();
            assert_eq!((mesh.vertex_count(), mesh.face_count()), (8, 12), "{label}");
            if format.is_project() {
                // The step that came with it, which brings back the quads.
                page.press_with(Modifiers::COMMAND, Key::Z);
            }
            page.press_with(Modifiers::COMMAND, Key::Z);
        }
    }
}

#[test]
fn the_dialog_offers_the_name_it_was_given_until_another_document_opens() {
    let mut page = Page::new();
    ask(&mut page, "my cube");
    page.press(Key::Enter);
    page.press_with(Modifiers::COMMAND, Key::S);
    page.press(Key::Enter);
    assert_eq!(saved(&page), ["my cube.obj", "my cube.obj"]);
    page.open("other.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    page.press_with(Modifiers::COMMAND, Key::S);
    page.press(Key::Enter);
    assert_eq!(saved(&page)[2], "other.obj");
}

#[test]
fn the_document_takes_the_name_that_it_was_saved_under() {
    let mut page = Page::new();
    ask(&mut page, "my mug");
    page.press(Key::Enter);
    assert_eq!(page.app().editor().document().name(), "my mug");
    assert!(page.has("Document: my mug") && !is_dirty(&mut page));
    page.command(json!({ "op": "poke-faces", "faces": [0] }));
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert!(page.has("Document: my mug"), "undoing an edit doesn't take it away");
}

#[test]
fn files_that_a_script_opens_at_once_open_one_after_the_other() {
    let mut page = Page::new();
    let told = std::rc::Rc::new(std::cell::RefCell::new(Vec::new()));
    for name in ["a.obj", "b.obj", "c.obj"] {
        let file = meshwright_web::platform::NamedBytes::new(name, b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        let tell = told.clone();
        let reply = Box::new(move |answer: Result<_, String>| tell.borrow_mut().push(answer.map(drop)));
        page.app().script().open(vec![file], reply);
    }
    page.run();
    assert_eq!(*told.borrow(), [Ok(()), Ok(()), Ok(())]);
    assert_eq!(page.app().editor().document().name(), "c", "the last one stays");
    assert_eq!(page.undo_labels(), ["Open a", "Open b", "Open c"]);
}

#[test]
fn typing_replaces_the_name_and_enter_saves() {
    let mut page = Page::new();
    ask(&mut page, "my cube");
    page.press(Key::Enter);
    assert_eq!(saved(&page), ["my cube.obj"]);
    assert!(page.has("Saved my cube.obj"));
    assert!(!page.has("File name"), "the dialog is gone");
}

#[test]
fn an_extension_picks_its_format() {
    let mut page = Page::new();
    ask(&mut page, "cube.off");
    assert_eq!(page.find("Format").value().as_deref(), Some("OFF"));
    page.press(Key::Enter);
    assert_eq!(saved(&page), ["cube.off"]);
    // The format is kept for the next time, and on a later visit.
    assert_eq!(page.outside.setting("format").as_deref(), Some("off"));
    ask(&mut page, "again");
    page.press(Key::Enter);
    assert_eq!(saved(&page), ["cube.off", "again.off"]);
}

#[test]
fn an_empty_name_is_not_saved() {
    let mut page = Page::new();
    ask(&mut page, ".obj");
    assert!(page.find("Save").accesskit_node().is_disabled());
    page.press(Key::Enter);
    page.press(Key::Escape);
    assert_eq!(saved(&page), [""; 0]);
    assert!(!page.has("File name"));
}

#[test]
fn losses_are_shown_before_saving() {
    let mut page = Page::new();
    page.command(json!({ "op": "set-face-color", "faces": [0, 1], "color": "#ff0000" }));
    page.press_with(Modifiers::COMMAND, Key::S);
    assert!(page.has("OBJ holds everything in this document."));
    choose(&mut page, "STL");
    assert!(page.has("STL holds triangles only: 6 polygons are cut into triangles."));
    assert!(!page.has_part("colours"), "binary STL holds face colours");
    choose(&mut page, "STL (text)");
    assert!(page.has("STL (text) holds no face colours: those of 2 faces are lost."));
    choose(&mut page, "STL");
    page.click("Save");
    assert_eq!(saved(&page), ["Cube.stl"]);
    assert!(is_dirty(&mut page), "what was lost is not saved");

    page.press_with(Modifiers::COMMAND, Key::S);
    choose(&mut page, "OBJ");
    page.click("Save");
    assert_eq!(saved(&page), ["Cube.stl", "Cube.obj", "Cube.mtl"]);
    assert!(!is_dirty(&mut page));
}

#[test]
fn edits_made_while_a_file_is_written_count_as_unsaved() {
    let mut page = Page::new();
    page.command(json!({ "op": "split-edge", "edge": 0 }));
    page.outside.hold_jobs();
    ask(&mut page, "early");
    page.press(Key::Enter);
    page.command(json!({ "op": "split-edge", "edge": 1 }));
    page.outside.release_jobs();
    page.run();
    assert_eq!(saved(&page), ["early.obj"]);
    assert!(is_dirty(&mut page));
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert!(!is_dirty(&mut page), "undo is back at what the file has");
}

#[test]
fn escape_and_cancel_save_nothing() {
    let mut page = Page::new();
    for how in ["key", "button"] {
        ask(&mut page, "never");
        match how {
            "key" => page.press(Key::Escape),
            _ => page.harness.get_by_role_and_label(egui::accesskit::Role::Button, "Cancel").click(),
        }
        page.run();
        assert!(!page.has("File name"), "{how}");
    }
    assert_eq!(saved(&page), [""; 0]);
}

#[test]
fn coordinates_too_large_for_a_format_are_named() {
    let mut page = Page::new();
    page.open(
        "far.obj",
        "v 4458321.123 5412000.004 12.5\nv 4458323.125 5412000.011 12.25\nv 4458322.12 5412001.006 13\nf 1 2 3\n",
    );
    page.press_with(Modifiers::COMMAND, Key::S);
    choose(&mut page, "STL");
    assert!(page.has_part("STL holds 32 bits for a coordinate"));
    choose(&mut page, "PLY");
    assert!(!page.has_part("32 bits for a coordinate"));
}

#[test]
fn only_a_file_that_opens_again_counts_as_saved() {
    for format in Format::all().filter(|format| format.can_save() && !format.is_bezier()) {
        let mut page = Page::new();
        page.command(json!({ "op": "triangulate-faces" }));
        page.press_with(Modifiers::COMMAND, Key::S);
        if page.find("Format").value().as_deref() != Some(format.name()) {
            choose(&mut page, format.name());
        }
        let promises = page.has_part("holds everything");
        assert_eq!(promises, format.can_open(), "{}", format.name());
        page.click("Save");
        assert_eq!(is_dirty(&mut page), !format.can_open(), "{}", format.name());
    }
}

#[test]
fn formats_for_control_points_are_offered_only_where_there_are_some() {
    let mut page = Page::new();
    page.press_with(Modifiers::COMMAND, Key::S);
    page.click("Format");
    assert!(page.has("PLY") && !page.has("BZC") && !page.has("BEZ"));
    page.press(Key::Escape);
    page.press(Key::Escape);
    ask(&mut page, "cube.bzc");
    page.press(Key::Enter);
    assert_eq!(saved(&page), ["cube.bzc.obj"], "a mesh is no curve, whatever its name");
    page.click("File");
    page.click("Save as");
    let entry = page.harness.get_by_label(actions::of_format(Format::for_bezier(true).expect("BZC")).label);
    assert!(entry.accesskit_node().is_disabled());
    let why = entry.accesskit_node().description();
    assert_eq!(why.as_deref(), Some("BZC holds a Bezier curve, and the document has none."));
    page.press(Key::Escape);
    page.open("flat.bzc", "3\n0 0 5 5 10 0\n");
    page.press_with(Modifiers::COMMAND, Key::S);
    assert_eq!(page.find("Format").value().as_deref(), Some("BZC"));
}

#[test]
fn a_project_is_opened_as_the_document_with_its_steps() {
    let mut page = Page::new();
    page.command(json!({ "op": "poke-faces", "faces": [0] }));
    page.command(json!({ "op": "hide", "faces": [1] }));
    ask(&mut page, "box.meshwright");
    assert!(page.has_part("Meshwright project holds everything"), "the extension chooses the format");
    page.press(Key::Enter);
    assert_eq!(saved(&page), ["box.meshwright"]);
    assert!(!is_dirty(&mut page));
    let file = page.outside.downloads().remove(0);

    let mut page = Page::new();
    page.outside.push(meshwright_web::platform::Event::Files(vec![file]));
    page.run();
    let document = page.app().editor().document();
    assert_eq!((document.name(), document.objects()[0].hidden().len()), ("box", 1));
    assert!(page.has_part("Opened box") && !is_dirty(&mut page));
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(page.app().editor().document().objects()[0].hidden().len(), 0);
    page.press_with(Modifiers::COMMAND, Key::Z);
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(page.app().editor().document().name(), "Cube", "the document before");
}

#[test]
fn a_project_is_seen_as_it_was_saved() {
    let mut page = Page::new();
    page.command(json!({ "op": "poke-faces", "faces": [0] }));
    page.drag(egui::pos2(640.0, 150.0), egui::pos2(700.0, 190.0));
    page.drop(egui::pos2(700.0, 190.0));
    let camera = |page: &mut Page| page.app().script().state()["view"]["yaw"].clone();
    let yaw = camera(&mut page);
    ask(&mut page, "box.meshwright");
    page.press(Key::Enter);
    let file = page.outside.downloads().remove(0);
    let mut page = Page::new();
    assert_ne!(camera(&mut page), yaw);
    page.outside.push(meshwright_web::platform::Event::Files(vec![file]));
    page.run();
    assert_eq!(camera(&mut page), yaw);
}
