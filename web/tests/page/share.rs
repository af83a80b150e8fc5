//! The window with a link, and documents that come by one.

use crate::page::Page;
use editor::formats::Format;
use egui::{Key, Modifiers, OutputCommand, Role, vec2};
use egui_kittest::kittest::Queryable;
use meshwright_web::platform::Event;
use serde_json::json;

/// Opens the window and waits for the link; returns it.
fn share(page: &mut Page) -> String {
    page.click("File");
    page.click("Share…");
    page.wait();
    page.find("Link").value().expect("a link")
}

fn opened(fragment: &str) -> Page {
    let mut page = Page::linked(fragment);
    page.run();
    page
}

#[test]
fn a_link_opens_as_a_copy_that_the_first_change_makes_ones_own() {
    let mut page = Page::new();
    page.command(json!({ "op": "extrude-faces", "faces": [1], "distance": 0.5 }));
    let link = share(&mut page);
    let (address, fragment) = link.split_once('#').expect("a fragment");
    assert_eq!(address, "https://example.org/meshwright/");
    assert!(link.len() < 300, "{link}");
    assert!(page.has_part("short enough for every chat") && page.has("QR code of the link"));
    let faces = page.mesh().face_count();

    let mut page = opened(&format!("#{fragment}"));
    assert_eq!(page.mesh().face_count(), faces);
    assert!(page.has_part("Opened Cube") && page.has_part("It came by a link"));
    assert!(page.has_part("Shared by a link"), "the document's panel says so");
    assert!(!page.app().editor().is_dirty(), "nothing asks");
    assert_eq!(page.outside.fragment(), format!("#{fragment}"), "a reload shows it again");
    page.select("face", &[0]);
    assert_ne!(page.outside.fragment(), "", "selecting changes nothing");
    page.command(json!({ "op": "poke-faces", "faces": [0] }));
    assert_eq!(page.app().editor().document().name(), "Cube (copy)");
    assert_eq!(page.outside.fragment(), "");
    page.select("face", &[]);
    assert!(!page.has_part("Shared by a link") && page.has_part("Unsaved changes"));
}

#[test]
fn the_link_follows_the_document_and_is_copied() {
    let mut page = Page::new();
    let first = share(&mut page);
    page.command(json!({ "op": "poke-faces", "faces": [0] }));
    page.wait();
    let second = page.find("Link").value().expect("a link");
    assert_ne!(first, second);
    page.click("Copy link");
    let copied = page.harness.output().platform_output.commands.iter().find_map(|command| match command {
        OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    });
    assert!(copied == Some(second) || page.has_part("The link was copied"));
    page.press(Key::Escape);
    assert!(!page.has("Copy link"));
}

#[test]
fn larger_documents_are_offered_as_a_file() {
    let mut page = Page::new();
    // Without a history that begins with a shape.
    let mut text = String::new();
    for i in 0..3000 {
        let at = f64::from(i);
        text += &format!("v {} {} {}\n", (at * 0.7).sin(), (at * 1.3).cos(), (at * 0.37).sin() * 2.0);
    }
    (1..2998).for_each(|i| text += &format!("f {i} {} {}\n", i + 1, i + 2));
    page.open("strip.obj", &text);
    page.click("File");
    page.click("Share…");
    page.wait();
    assert!(page.has_part("characters; browsers and chat programs bear about 32"));
    page.click("Save as Meshwright project…");
    assert_eq!(page.find("Format").value().as_deref(), Some(Format::project().name()));
}

#[test]
fn a_damaged_link_is_refused_in_words_and_another_can_be_pasted_in_its_place() {
    let mut page = opened("#d=1AAAAAAAA");
    assert!(page.has_part("The link is damaged or incomplete"));
    assert_eq!(page.app().editor().document().name(), "Cube", "the document of every first visit");
    let mut other = Page::new();
    other.command(json!({ "op": "poke-faces", "faces": [0] }));
    let link = share(&mut other);
    let fragment = link.split_once('#').expect("a fragment").1;
    page.outside.push(Event::Fragment(format!("#{fragment}")));
    page.run();
    assert_eq!(page.mesh().face_count(), 9);
    page.outside.push(Event::Fragment("#elsewhere".to_owned()));
    page.run();
    assert_eq!(page.mesh().face_count(), 9, "other fragments mean nothing");
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert_ne!(page.app().editor().document().name(), "Cube (copy)", "the document before is no copy");
}

#[test]
fn the_whole_code_is_in_sight() {
    for size in [vec2(1280.0, 800.0), vec2(1920.0, 1080.0)] {
        let mut page = Page::sized(size);
        share(&mut page);
        page.run();
        let code = page.find("QR code of the link").rect();
        let window = page.harness.get_by_role_and_label(Role::Window, "Share").rect();
        assert!(window.contains_rect(code.expand(4.0)), "{code} in {window}");
    }
}

#[test]
fn the_window_fits_a_phone() {
    let mut page = Page::sized(vec2(390.0, 844.0));
    page.press_with(Modifiers::COMMAND, Key::K);
    page.type_text("share");
    page.press(Key::Enter);
    page.wait();
    let code = page.find("QR code of the link").rect();
    assert!(code.left() >= 0.0 && code.right() <= 390.0 && code.bottom() <= 844.0, "{code}");
    let copy = page.find("Copy link").rect();
    assert!(copy.height() >= 44.0, "{copy}");
}
