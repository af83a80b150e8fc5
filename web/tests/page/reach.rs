//! Every operation is in a menu, and the palette finds every action.

use std::collections::{BTreeMap, BTreeSet};

use crate::page::Page;
use editor::OpId;
use egui::accesskit::{HasPopup, Role};
use egui::{Key, Modifiers, PointerButton};
use egui_kittest::kittest::{NodeT, Queryable};
use meshwright_web::input::actions;
use meshwright_web::input::menus::MENUS;

/// Operations that no menu names, and how a user carries them out.
const ELSEWHERE: &[(OpId, &str)] = &[
    (OpId::SelectElements, "a click"),
    (OpId::SelectAll, "the menu's “Select all”, which knows the kind"),
    (OpId::SelectRelated, "the menu's “Grow”, “Loops” and the like, one for each relation"),
    (OpId::SelectSimilar, "the menu's “Similar”, one entry for each property"),
    (OpId::SelectNamed, "the window of named selections"),
    (OpId::NameSelection, "the window of named selections"),
    (OpId::RenameNamedSelection, "the window of named selections"),
    (OpId::DeleteNamedSelection, "the window of named selections"),
    (OpId::ActivateObject, "the list of objects"),
    (OpId::RenameObject, "the list of objects"),
    (OpId::SetObjectVisible, "the list of objects"),
    (OpId::DeleteObject, "the list of objects"),
    (OpId::BezierMovePoint, "a drag"),
    (OpId::BezierSplit, "the menu's “Split at t”, which knows where"),
];

/// The names of the buttons on the page, each as often as it is there, and whether it opens a menu.
fn buttons(page: &Page) -> BTreeMap<String, (usize, bool)> {
    let mut found: BTreeMap<String, (usize, bool)> = BTreeMap::new();
    for role in [Role::Button, Role::CheckBox] {
        for node in page.harness.query_all_by_role(role) {
            let node = node.accesskit_node();
            let entry = found.entry(node.label().unwrap_or_default()).or_default();
            entry.0 += 1;
            entry.1 |= node.has_popup() == Some(HasPopup::Menu);
        }
    }
    found
}

/// What a menu that has opened lists, by the buttons that were there before.
fn listed(page: &Page, before: &BTreeMap<String, (usize, bool)>) -> Vec<(String, bool)> {
    let now = buttons(page).into_iter();
    let is_new = |name: &str, count| before.get(name).is_none_or(|(before, _)| count > *before);
    now.filter(|(name, (count, _))| is_new(name, *count)).map(|(name, (_, opens))| (name, opens)).collect()
}

/// Opens a menu by the path of titles to it, and returns what the last of them lists.
fn open(page: &mut Page, path: &[&str]) -> Vec<(String, bool)> {
    let mut before = buttons(page);
    for title in path {
        before = buttons(page);
        let nodes = page.harness.get_all_by_role_and_label(Role::Button, title);
        nodes.last().expect("a title").click_accesskit();
        page.run();
    }
    listed(page, &before)
}

/// Whether an entry of a menu is that of an operation: its label, perhaps with an ellipsis and a key.
fn names(entry: &str, id: OpId) -> bool {
    let rest = entry.strip_prefix(id.spec().label).map(|rest| rest.strip_prefix('…').unwrap_or(rest));
    rest.is_some_and(|rest| {
        let is_key = |word: &str| meshwright_web::input::shortcut::Shortcut::parse(word).is_some();
        rest.is_empty() || rest.strip_prefix(' ').is_some_and(is_key)
    })
}

/// Opens the context menu at a place in the viewport and returns its entries.
fn context_menu(page: &mut Page) -> Vec<String> {
    let before = buttons(page);
    let at = page.find("Viewport").rect().left_bottom() + egui::vec2(170.0, -30.0);
    page.hover(at);
    for pressed in [true, false] {
        let (button, modifiers) = (PointerButton::Secondary, Modifiers::NONE);
        page.harness.event(egui::Event::PointerButton { pos: at, button, pressed, modifiers });
    }
    page.run();
    let names = listed(page, &before).into_iter().map(|(name, _)| name).collect();
    page.press(Key::Escape);
    names
}

#[test]
fn menus_reach_every_operation() {
    let mut page = Page::new();
    let mut entries: BTreeSet<String> = BTreeSet::new();
    for menu in MENUS {
        let title = menu.id.title();
        let first = open(&mut page, &[title]);
        page.press(Key::Escape);
        for (name, opens) in first {
            if opens {
                entries.extend(open(&mut page, &[title, &name]).into_iter().map(|(name, _)| name));
                page.press(Key::Escape);
                page.press(Key::Escape);
            } else {
                entries.insert(name);
            }
        }
    }
    for kind in ["vertex", "edge", "halfedge", "face"] {
        page.select(kind, &[0]);
        let listed = context_menu(&mut page);
        let kind = page.selected().0;
        for id in actions::edits_of(kind) {
            assert!(listed.iter().any(|entry| names(entry, id)), "{id:?} on {kind}: {listed:?}");
        }
        entries.extend(listed);
    }
    page.open("arc.bzc", "4\n0 0 1 2 3 2 4 0\n");
    entries.extend(context_menu(&mut page));

    let is_elsewhere = |id: &OpId| ELSEWHERE.iter().any(|(other, _)| other == id);
    let is_listed = |id: &OpId| entries.iter().any(|entry| names(entry, *id));
    let missing: Vec<&OpId> = OpId::ALL.iter().filter(|id| !is_listed(id) && !is_elsewhere(id)).collect();
    assert!(missing.is_empty(), "in no menu: {missing:?}; menus have {entries:?}");
    let listed: Vec<&OpId> = OpId::ALL.iter().filter(|id| is_listed(id) && is_elsewhere(id)).collect();
    assert!(listed.is_empty(), "in a menu after all: {listed:?}");
}

/// What the palette finds for a text, the first first, and whether each can be done now.
fn found(page: &mut Page, text: &str) -> Vec<(String, bool)> {
    page.press_with(Modifiers::COMMAND, Key::K);
    page.type_text(text);
    let rows = page.harness.get_by_role_and_label(Role::ListBox, "Commands");
    let rows = rows.query_all_by_role(Role::ListBoxOption).map(|row| {
        let node = row.accesskit_node();
        (node.label().unwrap_or_default(), !node.is_disabled())
    });
    let rows = rows.collect();
    page.press(Key::Escape);
    rows
}

#[test]
fn the_palette_finds_every_action_by_its_label() {
    let mut page = Page::new();
    for entry in actions::all() {
        let rows = found(&mut page, entry.label);
        assert_eq!(rows.first().map(|(name, _)| name.as_str()), Some(entry.label), "{rows:?}");
    }
    // And so every operation that a menu lists.
    let is_elsewhere = |id: &OpId| ELSEWHERE.iter().any(|(other, _)| other == id);
    let is_found = |id: &OpId| actions::all().any(|entry| entry.label == id.spec().label);
    let missing: Vec<&OpId> = OpId::ALL.iter().filter(|id| !is_found(id) && !is_elsewhere(id)).collect();
    assert!(missing.is_empty(), "{missing:?}");
}

#[test]
fn the_palette_finds_by_words_of_other_programs_what_can_be_done_at_once() {
    let mut page = Page::new();
    for (text, label) in [
        ("mirror", "Symmetry along x"),
        ("decimate", "Simplify"),
        ("export", "Save…"),
        ("weld", "Merge by distance"),
        ("triangulate", "Triangulate"),
    ] {
        let rows = found(&mut page, text);
        assert_eq!(rows.first(), Some(&(label.to_owned(), true)), "{text}: {rows:?}");
    }
}

#[test]
fn flip_orientation_is_greyed_where_it_is_refused() {
    let mut page = Page::new();
    let greyed = |page: &mut Page| {
        open(page, &["Mesh", "Face edits"]);
        let nodes = page.harness.get_all_by_role_and_label(Role::Button, "Flip orientation");
        let node = nodes.last().expect("in the menu");
        let node = node.accesskit_node();
        let told = (node.is_disabled(), node.description());
        page.press(Key::Escape);
        assert!(!page.has("Face edits"), "the menu is closed");
        told
    };
    let before = page.mesh().clone();
    page.select("face", &[0]);
    let (is_greyed, reason) = greyed(&mut page);
    let reason = reason.unwrap_or_default();
    assert!(is_greyed && reason.contains("whole"), "part of a piece: {reason:?}");
    // The palette says the same, and Enter does nothing else.
    let rows = found(&mut page, "Flip orientation");
    assert_eq!(rows.first(), Some(&("Flip orientation".to_owned(), false)));
    page.press_with(Modifiers::COMMAND, Key::K);
    page.type_text("Flip orientation");
    page.press(Key::Enter);
    assert!(page.harness.query_by_role_and_label(Role::Alert, &reason).is_some(), "{reason}");
    page.press(Key::Escape);
    assert_eq!(page.mesh(), &before);

    page.select("face", &[0, 1, 2, 3, 4, 5]);
    assert_eq!(greyed(&mut page), (false, None), "the whole piece");
    open(&mut page, &["Mesh", "Face edits"]);
    let nodes = page.harness.get_all_by_role_and_label(Role::Button, "Flip orientation");
    nodes.last().expect("in the menu").click_accesskit();
    page.run();
    assert_eq!(page.undo_labels(), ["Flip orientation"]);
}
