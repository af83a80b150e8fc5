//! Menus, keys, the palette, files and jobs.

use crate::page::Page;
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};
use halfedge::Element;
use meshwright_web::input::menus;
use serde_json::json;

const CTRL: Modifiers = Modifiers::COMMAND;
const CTRL_SHIFT: Modifiers = Modifiers::COMMAND.plus(Modifiers::SHIFT);

fn disabled(page: &Page, role: Role, label: &str) -> (bool, Option<String>) {
    let node = page.harness.get_by_role_and_label(role, label);
    let node = node.accesskit_node();
    (node.is_disabled(), node.description())
}

#[test]
fn unavailable_actions_are_greyed_with_a_reason() {
    let mut page = Page::new();
    let undo = disabled(&page, Role::Button, "Undo");
    assert_eq!(undo, (true, Some("There is nothing to undo.".to_owned())));
    page.click("Mesh");
    page.click("Edge edits");
    let split = disabled(&page, Role::Button, "Split edge S");
    assert_eq!(split, (true, Some("Select an edge first.".to_owned())));
    page.press(Key::Escape);
    page.select("edge", &[0]);
    page.press(Key::S);
    assert!(!disabled(&page, Role::Button, "Undo").0);
}

#[test]
fn joining_takes_two_objects_and_separating_two_pieces_or_faces() {
    let mut page = Page::new();
    page.click("Mesh");
    let join = disabled(&page, Role::Button, "Join objects Ctrl+J");
    assert_eq!(join, (true, Some("There is only one object, so there is nothing to join.".to_owned())));
    let separate = disabled(&page, Role::Button, "Separate… Shift+P");
    let why = "The mesh is one connected piece. Select the faces to separate first.";
    assert_eq!(separate, (true, Some(why.to_owned())));
    page.press(Key::Escape);
    page.select("face", &[0]);
    assert!(!disabled(&page, Role::Button, "Separate…").0, "in the operations panel");
    page.command(json!({"op": "new", "shape": "grid", "add": true}));
    // In the operations panel and in the menu.
    let enabled = |page: &Page| {
        let nodes = page.harness.query_all_by_label_contains("Join objects");
        nodes
            .filter(|node| {
                node.accesskit_node().role() == Role::Button && !node.accesskit_node().is_disabled()
            })
            .count()
    };
    assert_eq!(enabled(&page), 1);
    page.click("Mesh");
    assert_eq!(enabled(&page), 2);
}

#[test]
fn every_menu_opens_and_lists_its_entries() {
    let mut page = Page::new();
    let count = |page: &Page, label: &str| page.harness.query_all_by_label_contains(label).count();
    for menu in menus::MENUS {
        let entries = || menu.entries.iter().flatten();
        // Other parts of the page may have the same words.
        let before: Vec<usize> = entries().map(|entry| count(&page, entry.label)).collect();
        page.click(menu.id.title());
        let mut open = None;
        for (entry, before) in entries().zip(before) {
            let submenu = menus::submenu(entry.action);
            if let Some(title) = submenu.filter(|_| submenu != open) {
                page.click(title);
                open = submenu;
            }
            assert!(
                count(&page, entry.label) > before,
                "{} is not in the {} menu",
                entry.label,
                menu.id.title()
            );
        }
        page.press(Key::Escape);
    }
}

#[test]
fn filling_holes_says_how_many_and_why_there_are_none() {
    let mut page = Page::new();
    page.command(json!({"op": "delete-faces", "faces": [0]}));
    page.press(Key::Num2);
    page.press_with(CTRL, Key::A);
    page.press_with(Modifiers::ALT, Key::F);
    assert_eq!(page.mesh().face_count(), 6);
    assert!(page.has("Fill hole: 1 face created"), "nothing else may show it");
    page.press_with(CTRL, Key::A);
    page.press_with(Modifiers::ALT, Key::F);
    assert!(page.has_part("No selected edge is on a boundary"));
}

#[test]
fn keys_of_the_course_editors() {
    let mut page = Page::new();
    page.select("halfedge", &[0]);
    let next = page.mesh().next(halfedge::HalfedgeId::new(0)).raw();
    page.press(Key::N);
    assert_eq!(page.selected(), (Element::Halfedge, vec![next]));
    page.press(Key::T);
    assert_eq!(page.selected(), (Element::Halfedge, vec![next ^ 1]));
    assert!(page.undo_labels().is_empty(), "T on a half-edge is its twin and nothing else");

    page.press(Key::S);
    assert_eq!(page.mesh().vertex_count(), 9);
    page.press_with(CTRL, Key::Z);
    assert_eq!(page.mesh().vertex_count(), 8);
    page.press_with(CTRL_SHIFT, Key::Z);
    assert_eq!(page.mesh().vertex_count(), 9);
    page.press_with(CTRL, Key::Z);
    page.press_with(CTRL, Key::Y);
    assert_eq!(page.mesh().vertex_count(), 9);
    page.press_with(CTRL, Key::Z);

    page.press(Key::U);
    assert_eq!(page.mesh().face_count(), 24, "Catmull-Clark on a cube");
    page.press_with(CTRL, Key::Z);
    page.press_with(Modifiers::SHIFT, Key::T);
    assert_eq!(page.mesh().face_count(), 12);
    page.press(Key::U);
    assert_eq!(page.mesh().face_count(), 48, "Loop on triangles");
}

#[test]
fn keys_of_the_page() {
    let mut page = Page::new();
    let view = |page: &mut Page, name: &str| page.app().script().state()["view"][name].clone();
    for (key, name) in
        [(Key::W, "wireframe"), (Key::M, "smooth"), (Key::V, "vertices"), (Key::P, "orthographic")]
    {
        let before = view(&mut page, name);
        page.press(key);
        assert_ne!(view(&mut page, name), before, "{name}");
        page.press(key);
        assert_eq!(view(&mut page, name), before, "{name}");
    }
    page.press_with(Modifiers::SHIFT, Key::G);
    assert_eq!(view(&mut page, "grid"), false);
    for (key, list) in
        [(Key::Num2, "edge"), (Key::Num3, "half-edge"), (Key::Num4, "face"), (Key::Num1, "vertex")]
    {
        page.press(key);
        assert_eq!(view(&mut page, "list"), list);
    }
    page.press_with(CTRL, Key::A);
    assert_eq!(page.selected().1.len(), 8);
    page.press_with(CTRL, Key::I);
    assert!(page.selected().1.is_empty());
    page.press_with(CTRL, Key::O);
    assert_eq!(page.outside.dialogs(), 1);
    page.press(Key::Questionmark);
    assert!(page.has_part("Keyboard shortcuts") && page.has("Twin half-edge"));
    page.press(Key::Escape);
    assert!(!page.has("Twin half-edge"));
}

#[test]
fn delete_removes_what_is_selected() {
    for (kind, faces, vertices) in [("face", 5, 8), ("vertex", 3, 7), ("edge", 5, 6)] {
        for key in [Key::Delete, Key::X] {
            let mut page = Page::new();
            page.select(kind, &[0]);
            page.press(key);
            assert_eq!((page.mesh().face_count(), page.mesh().vertex_count()), (faces, vertices), "{kind}");
            page.press_with(CTRL, Key::Z);
            assert_eq!(page.mesh().face_count(), 6);
        }
    }
}

#[test]
fn a_new_document_is_framed() {
    let mut page = Page::new();
    let view = |page: &mut Page, name: &str| page.app().script().state()["view"][name].clone();
    let start = view(&mut page, "pitch");
    page.open("flat.bzc", "3\n0 0 5 5 10 0\n");
    assert_eq!(view(&mut page, "pitch"), 0.0);
    page.command(serde_json::json!({ "op": "new", "shape": "cube", "size": 100 }));
    assert_eq!(view(&mut page, "pitch"), start, "from where solids are looked at");
    assert!(view(&mut page, "distance").as_f64().expect("a number") > 100.0, "all of it");
    assert_eq!(view(&mut page, "target"), serde_json::json!([0.0, 0.0, 0.0]));
    // Another shape beside it leaves the view where it is.
    let before = view(&mut page, "distance");
    page.command(serde_json::json!({ "op": "new", "shape": "cube", "size": 1, "add": true }));
    assert_eq!(view(&mut page, "distance"), before);
}

#[test]
fn letters_typed_into_a_field_start_no_action() {
    let mut page = Page::new();
    page.select("edge", &[0]);
    page.press_with(CTRL, Key::G);
    page.press(Key::S);
    page.press(Key::U);
    assert_eq!(page.mesh().vertex_count(), 8);
}

#[test]
fn the_palette_finds_and_runs() {
    let mut page = Page::new();
    page.press_with(CTRL, Key::K);
    page.find("Find a command").type_text("catmull");
    page.run();
    page.press(Key::Enter);
    // It has fields, all with defaults: it runs at once.
    assert_eq!(page.mesh().face_count(), 24);
    page.press(Key::F3);
    page.find("Find a command").type_text("vertex dots");
    page.run();
    page.press(Key::Enter);
    assert_eq!(page.app().script().state()["view"]["vertices"], true);
    page.press(Key::F3);
    page.press(Key::Escape);
    assert!(!page.has("Find a command"));
}

#[test]
fn the_palette_says_why_a_command_is_greyed_and_so_does_enter() {
    let mut page = Page::new();
    page.press_with(CTRL, Key::K);
    page.find("Find a command").type_text("fill hole");
    page.run();
    let why = disabled(&page, Role::ListBoxOption, "Fill hole");
    assert_eq!(why, (true, Some("Select an edge or a half-edge first.".to_owned())));
    page.press(Key::Enter);
    assert!(page.has("Find a command"), "another command can be chosen");
    let said = page.harness.get_by_role_and_label(Role::Alert, "Select an edge or a half-edge first.");
    assert!(said.rect().width() > 0.0);
}

#[test]
fn a_hole_is_filled_from_an_edge_by_every_way() {
    let page_on_edge = || {
        let mut page = Page::new();
        page.open("triangle.obj", TRIANGLE);
        page.select("edge", &[0]);
        page
    };
    let mut page = page_on_edge();
    page.click("Fill hole");
    assert_eq!(page.mesh().face_count(), 2, "by the inspector");
    let mut page = page_on_edge();
    page.press_with(CTRL, Key::K);
    page.find("Find a command").type_text("fill hole");
    page.run();
    page.press(Key::Enter);
    assert_eq!(page.mesh().face_count(), 2, "by the palette");
    let mut page = page_on_edge();
    page.click("Mesh");
    page.click("Edge edits");
    page.harness.get_all_by_role_and_label(Role::Button, "Fill hole").last().expect("in the menu").click();
    page.run();
    assert_eq!(page.mesh().face_count(), 2, "by the menu");
}

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

#[test]
fn a_file_opens_saves_and_undo_brings_the_cube_back() {
    let mut page = Page::new();
    page.open("triangle.obj", TRIANGLE);
    assert_eq!(page.app().editor().document().name(), "triangle");
    assert_eq!((page.mesh().vertex_count(), page.mesh().face_count()), (3, 1));
    page.press_with(CTRL, Key::S);
    page.press(Key::Enter);
    let files = page.outside.downloads();
    assert_eq!(files.first().map(|file| file.name.as_str()), Some("triangle.obj"));
    let text = String::from_utf8(files[0].bytes.clone()).expect("text");
    assert_eq!(text.lines().filter(|line| line.starts_with("v ")).count(), 3);
    page.press_with(CTRL, Key::Z);
    assert_eq!(page.mesh().face_count(), 6);
}

#[test]
fn pasted_text_opens_as_a_mesh() {
    let mut page = Page::new();
    page.harness.event(egui::Event::Paste(TRIANGLE.to_owned()));
    page.run();
    assert_eq!(page.mesh().face_count(), 1);
}

#[test]
fn a_broken_file_changes_nothing_and_says_why() {
    let mut page = Page::new();
    let before = page.mesh().clone();
    page.open("broken.obj", "f 1 2 3\n");
    assert!(page.undo_labels().is_empty());
    assert_eq!(page.mesh(), &before);
    let messages = page.app().script().state()["messages"].to_string();
    assert!(messages.contains("line 1"), "{messages}");
    assert!(page.has_part("Could not open ") && !page.has_part("Open: "), "a sentence");
    assert!(page.has("Dismiss message"), "and it is in view");
}

#[test]
fn an_import_can_be_repaired_with_other_choices() {
    let mut page = Page::new();
    page.open("sound.obj", TRIANGLE);
    assert!(!page.has("Repair import"), "nothing was repaired");
    page.open("fin.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n");
    assert_eq!(page.mesh().face_count(), 3);
    let as_read = page.mesh().clone();
    let press = |page: &mut Page, role, label| {
        page.harness.get_by_role_and_label(role, label).click();
        page.run();
    };
    page.open("sound.obj", TRIANGLE);
    let link = page.harness.query_by_role_and_label(Role::Link, "Repair import");
    assert!(link.is_none(), "the offer goes with its document");
    page.press_with(CTRL, Key::Z);
    page.open("fin.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n");
    let width = page.find("Viewport").rect().width();
    press(&mut page, Role::Link, "Repair import");
    assert_eq!(page.find("Viewport").rect().width(), width, "the form has room beside it");
    press(&mut page, Role::ComboBox, "Non-manifold edges");
    page.click("Drop");
    press(&mut page, Role::Button, "Repair import");
    assert_eq!(page.mesh().face_count(), 2, "two faces meet at an edge, no third");
    page.press_with(CTRL, Key::Z);
    assert_eq!(page.mesh(), &as_read);
}

#[test]
fn a_page_fetches_and_opens_the_model_in_its_address() {
    use meshwright_web::platform::{Event, Fetched, NamedBytes};
    let wanting = || {
        let mut page = Page::wanting(&["https://a.example/tri%20angle.obj?x=1", "colors.mtl"]);
        page.wait();
        assert!(page.has("Fetch tri%20angle.obj"));
        assert_eq!(page.mesh().face_count(), 6, "on the cube meanwhile");
        let fetches = page.outside.fetches();
        assert_eq!(fetches.len(), 1);
        assert_eq!(fetches[0].1, ["https://a.example/tri%20angle.obj?x=1", "colors.mtl"]);
        (page, fetches[0].0)
    };
    let note = "colors.mtl, which belongs to triangle.obj, could not be fetched: the server answered 404.";
    let fetched = |name: &str, text: &str| {
        Ok(Fetched {
            files: vec![NamedBytes::new(name, text.as_bytes())],
            source: None,
            notes: vec![note.to_owned()],
        })
    };
    let files = || fetched("triangle.obj", TRIANGLE);

    let (mut page, job) = wanting();
    page.outside.push(Event::Fetched { job, files: files() });
    page.run();
    page.run();
    assert_eq!(page.mesh().face_count(), 1);
    assert!(!page.has("Fetch tri%20angle.obj"));
    assert!(page.has_part("colors.mtl, which belongs to triangle.obj"), "what is not there is told");
    let messages: Vec<String> = page.app().editor().messages().map(|message| message.text.clone()).collect();
    assert!(messages.iter().any(|text| text == note), "and stays in the report: {messages:?}");

    // Without which nothing could be read.
    let (mut page, job) = wanting();
    let gltf = r#"{"asset":{"version":"2.0"},"buffers":[{"uri":"data.bin","byteLength":36}],
        "bufferViews":[{"buffer":0,"byteLength":36}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}]}"#;
    page.outside.push(Event::Fetched { job, files: fetched("a.gltf", gltf) });
    page.run();
    page.run();
    assert_eq!(page.mesh().face_count(), 6);
    assert!(
        page.has_part("Could not open a.gltf. Open it together with data.bin, ")
            && page.has_part("the server answered 404.")
    );

    let (mut page, job) = wanting();
    page.outside.push(Event::Fetched { job, files: Err("a.example did not answer.".to_owned()) });
    page.run();
    assert_eq!(page.mesh().face_count(), 6);
    assert!(page.has_part("a.example did not answer.") && !page.has("Fetch tri%20angle.obj"));

    // Cancelled, and here after all.
    let (mut page, job) = wanting();
    page.click("Cancel Fetch tri%20angle.obj");
    assert_eq!(page.outside.cancelled(), [job]);
    page.outside.push(Event::Fetched { job, files: files() });
    page.run();
    assert_eq!(page.mesh().face_count(), 6);
}

#[test]
fn dragging_a_file_over_the_page_shows_where_to_drop_it() {
    let mut page = Page::new();
    let shapes = page.harness.output().shapes.len();
    page.harness.input_mut().hovered_files.push(egui::HoveredFile::default());
    page.harness.step();
    assert!(page.harness.output().shapes.len() >= shapes + 3, "a plate, a border and a text over everything");
}

#[test]
fn a_job_shows_its_progress_and_can_be_cancelled() {
    let mut page = Page::new();
    page.outside.hold_jobs();
    page.outside.push(meshwright_web::platform::Event::Files(vec![
        meshwright_web::platform::NamedBytes::new("triangle.obj", TRIANGLE.as_bytes()),
    ]));
    page.harness.step();
    assert!(!page.has("Open triangle.obj"), "what is done in no time flashes no bar");
    page.wait();
    let bar = |page: &Page| {
        page.harness
            .get_by_role_and_label(Role::ProgressIndicator, "Open triangle.obj")
            .accesskit_node()
            .numeric_value()
    };
    assert_eq!(bar(&page), None, "it has not said how far it is");
    let job = page.app().editor().jobs().next().expect("it runs").id.0;
    page.outside.push(meshwright_web::platform::Event::JobProgress { job, fraction: 0.3 });
    page.run();
    assert_eq!(bar(&page).map(|value| value.round()), Some(30.0));
    assert_eq!(page.mesh().face_count(), 6, "the document stays as it was");
    page.click("Cancel Open triangle.obj");
    assert_eq!(page.outside.cancelled().len(), 1);
    assert!(!page.has("Open triangle.obj"));
    page.outside.release_jobs();
    page.run();
    assert_eq!(page.mesh().face_count(), 6);

    page.outside.hold_jobs();
    page.outside.push(meshwright_web::platform::Event::Files(vec![
        meshwright_web::platform::NamedBytes::new("triangle.obj", TRIANGLE.as_bytes()),
    ]));
    page.run();
    page.outside.release_jobs();
    page.run();
    assert_eq!(page.mesh().face_count(), 1);
}

#[test]
fn the_theme_is_kept() {
    let mut page = Page::new();
    page.click("Edit");
    page.click("Theme");
    page.click("Light theme");
    assert_eq!(page.outside.setting("theme").as_deref(), Some("light"));
    assert_eq!(page.app().script().state()["view"]["theme"], "light");
}

#[test]
fn objects_are_listed_once_there_are_two() {
    let mut page = Page::new();
    assert!(!page.has("Objects"));
    page.command(json!({ "op": "new", "shape": "tetrahedron", "add": true }));
    assert!(page.has("Objects") && page.has("Tetrahedron"));
    page.click("Cube");
    assert_eq!(page.mesh().face_count(), 6);
    page.click("Hide Tetrahedron");
    assert!(!page.app().editor().document().objects()[1].visible());
    page.click("Show Tetrahedron");
    page.click("Delete Tetrahedron");
    assert!(!page.has("Objects"));
}

#[test]
fn keys_of_one_frame_act_in_order_and_as_often_as_they_are_pressed() {
    let mut page = Page::new();
    for x in 1..=5 {
        page.command(json!({"op": "set-vertex-position", "vertex": 0, "position": [x, 0, 0]}));
    }
    let key = |page: &mut Page, key: Key, modifiers: Modifiers| {
        let event = |pressed| egui::Event::Key { key, physical_key: None, pressed, repeat: false, modifiers };
        page.harness.input_mut().events.extend([event(true), event(false)]);
    };
    for _ in 0..4 {
        key(&mut page, Key::Z, Modifiers::COMMAND);
    }
    page.harness.step();
    assert_eq!(page.undo_labels().len(), 1, "four steps are undone");
    // The list is changed before everything in it is selected.
    key(&mut page, Key::Num4, Modifiers::NONE);
    key(&mut page, Key::A, Modifiers::COMMAND);
    page.harness.step();
    assert_eq!(page.selected(), (halfedge::Element::Face, (0..6).collect()));
}

#[test]
fn letters_typed_after_a_key_that_opens_a_field_go_there() {
    let mut page = Page::new();
    page.select("face", &[0]);
    let key = |page: &mut Page, key: Key, modifiers: Modifiers| {
        let event = |pressed| egui::Event::Key { key, physical_key: None, pressed, repeat: false, modifiers };
        page.harness.input_mut().events.extend([event(true), event(false)]);
    };
    // In one slow frame: clear the selection, open the palette, search for it.
    key(&mut page, Key::Escape, Modifiers::NONE);
    key(&mut page, Key::K, Modifiers::COMMAND);
    for (letter, text) in [(Key::U, "u"), (Key::N, "n"), (Key::D, "d"), (Key::O, "o")] {
        key(&mut page, letter, Modifiers::NONE);
        page.harness.input_mut().events.push(egui::Event::Text(text.into()));
    }
    page.run();
    assert!(page.selected().1.is_empty());
    assert_eq!(page.mesh().face_count(), 6, "no letter was taken for a key");
    let field = page.harness.get_by_role_and_label(Role::TextInput, "Find a command");
    assert_eq!(field.value().as_deref(), Some("undo"));
}

/// Types keys, each with the text that it types, within one frame.
fn type_at_once(page: &mut Page, keys: &[(Key, Modifiers, &str)]) {
    for &(key, modifiers, text) in keys {
        let event = |pressed| egui::Event::Key { key, physical_key: None, pressed, repeat: false, modifiers };
        let events = &mut page.harness.input_mut().events;
        events.push(event(true));
        events.extend((!text.is_empty()).then(|| egui::Event::Text(text.into())));
        events.push(event(false));
    }
    page.run();
}

#[test]
fn keys_after_one_that_starts_or_ends_a_live_edit_mean_what_they_mean_then() {
    let none = Modifiers::NONE;
    let palette =
        [(Key::K, Modifiers::COMMAND, ""), (Key::S, none, "s"), (Key::U, none, "u"), (Key::D, none, "d")];
    let searched = |page: &mut Page| {
        assert_eq!(page.mesh().face_count(), 6, "no letter was taken for a key");
        let field = page.harness.get_by_role_and_label(Role::TextInput, "Find a command");
        assert_eq!(field.value().as_deref(), Some("sud"));
    };
    // The edit began in an earlier frame.
    let mut page = Page::new();
    page.select("face", &[0]);
    page.press(Key::E);
    let escape = (Key::Escape, none, "");
    type_at_once(&mut page, &[&[escape], &palette[..]].concat());
    searched(&mut page);
    // All in one frame.
    let mut page = Page::new();
    page.select("face", &[0]);
    type_at_once(&mut page, &[&[(Key::E, none, "e"), escape], &palette[..]].concat());
    searched(&mut page);

    // A move, typed at once, and undone in the same frame.
    let mut page = Page::new();
    page.select("vertex", &[0]);
    let before = page.mesh().clone();
    let x = before.positions()[0].x;
    let moves = [(Key::G, none, "g"), (Key::X, none, "x"), (Key::Num2, none, "2"), (Key::Enter, none, "")];
    type_at_once(&mut page, &moves);
    assert_eq!(page.mesh().positions()[0].x, x + 2.0);
    assert_eq!(page.undo_labels().len(), 1);
    let back = [moves.as_slice(), &[(Key::Z, Modifiers::COMMAND, ""), (Key::Z, Modifiers::COMMAND, "")]];
    type_at_once(&mut page, &back.concat());
    assert_eq!(page.mesh(), &before);
}
