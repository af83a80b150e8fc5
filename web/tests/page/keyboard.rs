//! The page by the keyboard alone.

use std::collections::HashSet;

use egui::accesskit::NodeId;
use egui::{Key, Modifiers};

use crate::document::Document;
use crate::page::{DESKTOP, PHONE, Page};

const CTRL: Modifiers = Modifiers::COMMAND;

/// Presses Tab until the focus comes back to where it was; fails if it passes over a control that can be used.
fn assert_tab_reaches_all(page: &mut Page, document: &mut Document, what: &str) {
    let mut reached: HashSet<NodeId> = HashSet::new();
    let mut wanted: HashSet<NodeId> = HashSet::new();
    let mut first = None;
    for _ in 0..300 {
        page.press(Key::Tab);
        document.follow(page);
        // Arrow keys lead to the rows of a list.
        let usable = document.nodes.iter().filter(|(_, node)| {
            node.attributes.contains_key("tabindex")
                && !node.attributes.contains_key("aria-disabled")
                && Document::role(node) != "option"
                && document.is_in_front(node)
        });
        wanted.extend(usable.map(|(id, _)| *id));
        let focus = document.focus.expect("a focus");
        // In a list the focus is on a row.
        reached.extend([Some(focus), document.nodes[&focus].parent].into_iter().flatten());
        if first == Some(focus) {
            break;
        }
        first = first.or(Some(focus));
    }
    let name = |id: &NodeId| document.nodes.get(id).map(|node| (Document::role(node), Document::name(node)));
    let missed: Vec<_> = wanted.difference(&reached).filter_map(name).collect();
    assert!(missed.is_empty(), "{what}: Tab passes over {missed:?}");
    assert!(reached.len() > 2, "{what}: {} controls", reached.len());
}

#[test]
fn tab_reaches_every_control() {
    for size in [DESKTOP, PHONE] {
        let mut page = Page::sized(size);
        let mut document = Document::default();
        assert_tab_reaches_all(&mut page, &mut document, "at the start");
        page.select("face", &[1]);
        assert_tab_reaches_all(&mut page, &mut document, "with a face selected");
        page.press(Key::Escape);
        page.press_with(CTRL, Key::S);
        document.follow(&page);
        assert!(document.get("dialog", "Save document").attributes.contains_key("aria-modal"));
        assert_tab_reaches_all(&mut page, &mut document, "the save dialog");
        page.press(Key::Escape);
        page.press(Key::F1);
        assert_tab_reaches_all(&mut page, &mut document, "the keys");
    }
}

/// The role and the name of what has the focus.
fn focused(page: &Page, document: &mut Document) -> (String, String) {
    document.follow(page);
    let node = &document.nodes[&document.focus.expect("a focus")];
    (Document::role(node).to_owned(), Document::name(node).to_owned())
}

/// Presses a key until the focus is on what has this name.
fn press_until(page: &mut Page, document: &mut Document, key: Key, name: &str) {
    let mut passed: Vec<String> = Vec::new();
    while passed.last().is_none_or(|at| at != name) {
        assert!(passed.len() < 200, "{key:?} does not lead to {name}: {passed:?}");
        page.press(key);
        passed.push(focused(page, document).1);
    }
}

#[test]
fn a_menu_is_opened_walked_and_left_by_keys() {
    let mut page = Page::new();
    let mut document = Document::default();
    press_until(&mut page, &mut document, Key::Tab, "View");
    page.press(Key::Enter);
    press_until(&mut page, &mut document, Key::ArrowDown, "Ground grid");
    document.follow(&page);
    let is_on = |document: &Document| {
        document.get("menuitemcheckbox", "Ground grid").attributes["aria-checked"] == "true"
    };
    assert!(is_on(&document));
    page.press(Key::Space);
    page.run();
    press_until(&mut page, &mut document, Key::Tab, "View");
    page.press(Key::Enter);
    document.follow(&page);
    assert!(!is_on(&document), "Space has switched the grid off");
    page.press(Key::Escape);
    document.follow(&page);
    assert_eq!(document.all("menu", "").len(), 0, "Escape closes the menu");
}
