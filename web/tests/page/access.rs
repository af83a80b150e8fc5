//! The mirror of the page for screen readers: what it shows, says and lets through.

use egui::accesskit::NodeId;
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;
use meshwright_web::access::aria::Urgency;
use meshwright_web::access::mirror::Patch;
use meshwright_web::access::tree::UiTree;

use crate::document::Document;
use crate::page::{DESKTOP, PHONE, Page};

const CTRL: Modifiers = Modifiers::COMMAND;
const TORUS: &str = r#"{ "op": "new", "shape": "torus" }"#;

#[test]
fn the_mirror_follows_the_page_bit_by_bit() {
    for size in [DESKTOP, PHONE] {
        let mut page = Page::sized(size);
        let mut document = Document::default();
        document.check(&page, "at the start");
        assert_eq!(document.said, [], "what is there at the start is no news");
        document.get("application", "Viewport");
        document.get("listbox", "Vertices");

        page.command(serde_json::from_str(TORUS).expect("a command"));
        document.check(&page, "another mesh");
        page.select("vertex", &[200]);
        document.check(&page, "a list scrolled far");
        page.select("face", &[3]);
        document.check(&page, "another list");
        page.press_with(CTRL, Key::K);
        document.check(&page, "the palette");
        page.press(Key::Escape);
        page.press_with(CTRL, Key::S);
        document.check(&page, "the save dialog");
        page.press(Key::Escape);
        document.check(&page, "without dialogs");
        page.press(Key::F1);
        document.check(&page, "the keys");
        page.press(Key::Escape);
    }
}

#[test]
fn menus_and_lists_that_open_are_told_by_their_buttons() {
    let mut page = Page::new();
    let mut document = Document::default();
    document.follow(&page);
    let file = document.get("button", "File");
    assert_eq!(file.attributes["aria-haspopup"], "menu");
    assert_eq!(file.attributes["aria-expanded"], "false");
    page.click("File");
    document.check(&page, "the menu");
    let file = document.get("button", "File").clone();
    assert_eq!(file.attributes["aria-expanded"], "true");
    let open = document.get("menuitem", "Open… Ctrl+O");
    let menu = &document.nodes[&open.parent.expect("a menu")];
    assert_eq!(Document::role(menu), "menu");
    assert_eq!(menu.parent, file.parent, "a button contains nothing");
    page.press(Key::Escape);

    page.click("View");
    document.check(&page, "a menu with toggles");
    assert_eq!(document.get("menuitemcheckbox", "Ground grid").attributes["aria-checked"], "true");
}

#[test]
fn the_focus_is_on_the_viewport_and_on_what_tab_and_arrows_reach() {
    let mut page = Page::new();
    let mut document = Document::default();
    document.follow(&page);
    let focused = |document: &Document| {
        let node = &document.nodes[&document.focus.expect("a focus")];
        (Document::role(node).to_owned(), Document::name(node).to_owned())
    };
    let is = |role: &str, name: &str| (role.to_owned(), name.to_owned());
    assert_eq!(focused(&document), is("application", "Viewport"), "where keys go at the start");
    page.press(Key::Tab);
    document.follow(&page);
    assert_eq!(focused(&document), is("button", "File"));

    page.harness.get_by_role_and_label(egui::accesskit::Role::ListBox, "Vertices").focus();
    page.run();
    page.press(Key::ArrowDown);
    page.press(Key::ArrowDown);
    document.check(&page, "a row");
    assert_eq!(focused(&document), is("option", "Vertex 1"));
    assert_eq!(document.get("option", "Vertex 1").attributes["aria-selected"], "true");

    page.press_with(CTRL, Key::K);
    page.harness.event(egui::Event::Text("undo".to_owned()));
    page.run();
    document.check(&page, "the palette");
    let (role, name) = focused(&document);
    assert_eq!(role, "option");
    assert!(name.starts_with("Undo"), "{name}: the row that Enter means");
}

#[test]
fn tab_leads_through_the_bar_the_viewport_the_lists_and_the_right_panel() {
    let mut page = Page::new();
    let mut document = Document::default();
    let mut order = Vec::new();
    for _ in 0..80 {
        page.press(Key::Tab);
        document.follow(&page);
        let node = &document.nodes[&document.focus.expect("a focus")];
        order.push(Document::name(node).to_owned());
    }
    let at = |name: &str| {
        let found = order.iter().position(|other| other == name);
        found.unwrap_or_else(|| panic!("Tab reaches {name}: {order:?}"))
    };
    let stops = ["File", "Help", "Viewport", "Vertices", "Go to id", "Only selected", "Filter operations"];
    assert!(stops.map(at).is_sorted(), "{order:?}");
    assert!(order.iter().filter(|name| *name == "File").count() > 1, "from the last to the first: {order:?}");
}

#[test]
fn messages_and_selections_are_said() {
    let mut page = Page::new();
    let mut document = Document::default();
    document.follow(&page);
    page.open("broken.obj", "v 0 0\n");
    document.follow(&page);
    let (urgency, text) = document.said.last().cloned().expect("something said");
    assert_eq!(urgency, Urgency::Assertive, "{text}");
    assert!(text.contains("broken.obj"), "{text}");

    document.said.clear();
    page.command(serde_json::json!({ "op": "split-edge", "edge": 3 }));
    page.select("face", &[3]);
    document.follow(&page);
    let said: Vec<&str> = document.said.iter().map(|(_, text)| text.as_str()).collect();
    assert_eq!(said, ["Cube: 9 vertices, 13 edges, 6 faces. Face 3 is selected"]);
    assert_eq!(document.said[0].0, Urgency::Polite);
    page.wait();
    document.follow(&page);
    assert_eq!(document.said.len(), 1, "said once");
}

#[test]
fn the_selection_is_walked_by_keys_in_the_viewport() {
    let mut page = Page::new();
    let mut document = Document::default();
    document.follow(&page);
    page.harness.get_by_label("Viewport").focus();
    page.run();
    page.press(Key::Num4);
    page.press(Key::PageDown);
    page.press(Key::PageDown);
    document.follow(&page);
    let description =
        |document: &Document| document.get("application", "Viewport").attributes["aria-description"].clone();
    assert!(description(&document).ends_with("Face 1 is selected"), "{}", description(&document));
    page.press(Key::PageUp);
    page.press(Key::PageUp);
    document.follow(&page);
    assert!(description(&document).ends_with("Face 5 is selected"), "{}", description(&document));
    page.press(Key::Num3);
    page.press(Key::PageDown);
    page.press(Key::N);
    page.press(Key::T);
    document.follow(&page);
    assert!(description(&document).contains("Half-edge"), "{}", description(&document));

    // Arrows turn the view, and Space resets it, as without a focus.
    let yaw = |page: &mut Page| page.app().script().state()["view"]["yaw"].as_f64().expect("a number");
    let before = yaw(&mut page);
    page.press(Key::ArrowLeft);
    assert!((yaw(&mut page) - before).abs() > 0.01, "the view turned");
    page.press(Key::Space);
    assert_eq!(yaw(&mut page), before);
    page.press(Key::PageDown);
    assert_eq!(page.selected().1.len(), 1, "the viewport still has the keys");
}

#[test]
fn an_unchanged_page_costs_nothing_and_a_scrolled_list_little() {
    let mut page = Page::new();
    page.command(serde_json::json!({ "op": "new", "shape": "grid", "columns": 300, "rows": 300 }));
    let mut document = Document::default();
    document.follow(&page);
    page.wait();
    document.follow(&page);
    page.harness.step();
    let changes = document.mirror.update(&page.harness.ctx.plugin::<UiTree>().lock());
    let is_time = |patch: &Patch| matches!(patch, Patch::Text(_, text) if text.ends_with(" ms"));
    assert!(changes.iter().all(is_time), "nothing changed but the frame time: {changes:?}");
    changes.into_iter().for_each(|patch| document.apply(patch));
    assert!(document.nodes.len() < 400, "only what is on the screen: {}", document.nodes.len());
    page.select("vertex", &[50_000]);
    document.check(&page, "far down");
    let row = document.get("option", "Vertex 50000").clone();
    assert_eq!(row.attributes["aria-posinset"], "50001");
    assert_eq!(row.attributes["aria-setsize"], "90601");

    page.harness.get_by_role_and_label(egui::accesskit::Role::ListBox, "Vertices").focus();
    page.run();
    document.follow(&page);
    let tree = page.harness.ctx.plugin::<UiTree>();
    page.press(Key::ArrowDown);
    let patches = document.mirror.update(&tree.lock());
    let touched: std::collections::HashSet<NodeId> = patches
        .iter()
        .filter_map(|patch| match patch {
            Patch::Create(id, _) | Patch::Text(id, _) | Patch::Attribute(id, ..) | Patch::Insert(id, _) => {
                Some(*id)
            }
            _ => None,
        })
        .collect();
    assert!(touched.len() < 100, "{} elements changed by one row: {patches:#?}", touched.len());
}

#[test]
fn less_motion_is_respected() {
    let mut page = Page::new();
    for reduces in [true, false, true] {
        page.outside.reduce_motion(reduces);
        page.harness.step();
        let style = page.harness.ctx.global_style();
        assert_eq!(style.animation_time == 0.0, reduces);
        assert_eq!(style.scroll_animation == egui::style::ScrollAnimation::none(), reduces);
    }
}
