//! The list of steps: jumping to any of them, with the mouse and with keys, and undo that names its step.

use crate::looks::picture;
use crate::page::{DESKTOP, PHONE, Page};
use egui::accesskit::Role;
use egui::{Key, Modifiers, Theme, Vec2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use halfedge::{Element, Mesh};
use serde_json::json;

/// A window in which the list is open at first.
const TALL: Vec2 = vec2(1280.0, 1000.0);

/// Five edits on the cube; returns the mesh after each, the cube first.
fn edit(page: &mut Page) -> Vec<Mesh> {
    let mut meshes = vec![page.mesh().clone()];
    for command in [
        json!({ "op": "extrude-faces", "faces": [0], "distance": 1 }),
        json!({ "op": "inset-faces", "faces": [0], "amount": 0.2 }),
        json!({ "op": "poke-faces", "faces": [1] }),
        json!({ "op": "split-edge", "edge": 0 }),
        json!({ "op": "subdivide-catmull-clark" }),
    ] {
        page.command(command);
        meshes.push(page.mesh().clone());
    }
    meshes
}

fn click_row(page: &mut Page, name: &str) {
    page.row(name).click();
    page.run();
}

fn is_current(page: &Page, name: &str) -> bool {
    page.row(name).accesskit_node().is_selected() == Some(true)
}

#[test]
fn steps_are_listed_by_name_and_one_click_away() {
    let mut page = Page::sized(TALL);
    assert!(is_current(&page, "Start: New document") && page.has_part("Each edit becomes a step"));
    let meshes = edit(&mut page);
    assert!(
        is_current(&page, "Step 5: Subdivide (Catmull-Clark)") && !page.has_part("Each edit becomes a step")
    );
    click_row(&mut page, "Step 2: Inset faces");
    assert_eq!(*page.mesh(), meshes[2]);
    assert!(is_current(&page, "Step 2: Inset faces"));
    assert_eq!(page.row("Step 3: Poke faces").accesskit_node().value().as_deref(), Some("undone"));
    click_row(&mut page, "Step 4: Split edge");
    assert_eq!(*page.mesh(), meshes[4]);
    click_row(&mut page, "Start: New document");
    assert_eq!(*page.mesh(), meshes[0]);
    click_row(&mut page, "Step 1: Extrude faces");
    page.command(json!({ "op": "poke-faces", "faces": [2] }));
    assert!(is_current(&page, "Step 2: Poke faces"));
    assert!(!page.has_row("Step 3: Poke faces"), "a new edit drops what was undone");
    page.click("Undo");
    assert_eq!(*page.mesh(), meshes[1]);
}

#[test]
fn arrow_keys_go_through_the_list_that_has_the_focus() {
    let mut page = Page::sized(TALL);
    let meshes = edit(&mut page);
    let camera = page.at([0.0; 3]);
    click_row(&mut page, "Step 3: Poke faces");
    for (key, at) in [
        (Key::ArrowUp, 2),
        (Key::ArrowUp, 1),
        (Key::ArrowDown, 2),
        (Key::Home, 0),
        (Key::ArrowUp, 0),
        (Key::End, 5),
        (Key::ArrowDown, 5),
    ] {
        page.press(key);
        assert_eq!(*page.mesh(), meshes[at], "{key:?}");
    }
    assert_eq!(page.at([0.0; 3]), camera, "the view stays");
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(*page.mesh(), meshes[4]);
}

#[test]
fn undo_and_redo_name_their_steps() {
    let mut page = Page::sized(TALL);
    edit(&mut page);
    click_row(&mut page, "Step 2: Inset faces");
    page.click("Edit");
    assert!(page.has_part("Undo Inset faces"));
    page.harness.get_by_label_contains("Redo Poke faces").click();
    page.run();
    assert!(is_current(&page, "Step 3: Poke faces"));
    // The toolbar's buttons say so in their tooltips.
    page.find("Undo").hover();
    for _ in 0..8 {
        page.harness.step();
    }
    page.run();
    assert!(page.has("Undo Poke faces (Ctrl+Z)") || page.has("Undo Poke faces (⌘Z)"));
}

#[test]
fn a_live_edit_is_cancelled_by_a_jump() {
    let mut page = Page::sized(TALL);
    let meshes = edit(&mut page);
    page.select("vertex", &[0]);
    page.press(Key::G);
    page.harness.event(egui::Event::Text("3".to_owned()));
    page.run();
    assert_ne!(*page.mesh(), meshes[5]);
    click_row(&mut page, "Step 4: Split edge");
    assert_eq!(*page.mesh(), meshes[4]);
    page.harness.event(egui::Event::Text("5".to_owned()));
    page.run();
    assert_eq!(*page.mesh(), meshes[4], "nothing follows the keys any more");
}

#[test]
fn a_thousand_steps_are_a_list_that_scrolls() {
    let mut page = Page::sized(TALL);
    for step in 0..1000 {
        let command = json!({ "op": "set-vertex-position", "vertex": 0, "position": [step, 0, 0] });
        page.app().script().run(command, Box::new(|answer| drop(answer.expect("a vertex"))));
    }
    page.run();
    assert!(is_current(&page, "Step 1000: Move vertex"), "the current step is in view");
    let rows = page.harness.query_all_by_role(Role::ListBoxOption);
    let steps = rows.filter(|row| row.accesskit_node().label().is_some_and(|name| name.starts_with("Step")));
    assert!(steps.count() < 40, "only visible rows are laid out");
    click_row(&mut page, "Step 998: Move vertex");
    assert_eq!(page.mesh().position(halfedge::VertexId::new(0)).x, 997.0);
    page.press(Key::Home);
    assert!(is_current(&page, "Start: New document"));
}

#[test]
fn the_panel_closes_and_stays_closed() {
    let mut page = Page::sized(TALL);
    page.click("History panel");
    assert!(!page.has_row("Start: New document"));
    let kept = page.outside.setting("layout").expect("it is kept");
    let mut page = Page::with_setting(TALL, "layout", &kept);
    assert!(!page.has_row("Start: New document"), "{kept}");
    page.click("History panel");
    assert!(page.has_row("Start: New document"));
}

#[test]
fn a_layout_of_an_earlier_version_is_still_read() {
    let open = r#"{"left":false,"right":true,"overlay":false,"numbers":false,"course_light":false}"#;
    let sheet = r#"{"tab":"Lists","closed":false}"#;
    let kept = format!(
        r#"{{"arrangement":"Model","model":{open},"study":{open},"sheet":{sheet},"widths":[332,300]}}"#
    );
    let page = Page::with_setting(TALL, "layout", &kept);
    assert!(!page.has("Go to id") && page.has_row("Start: New document"));
}

#[test]
fn a_phone_has_the_steps_in_the_sheet() {
    let mut page = Page::drawn(PHONE, Theme::Light);
    let meshes = edit(&mut page);
    page.harness.get_by_role_and_label(Role::Tab, "History").click();
    page.run();
    click_row(&mut page, "Step 4: Split edge");
    click_row(&mut page, "Step 2: Inset faces");
    assert_eq!(*page.mesh(), meshes[2]);
    assert!(page.row("Step 2: Inset faces").rect().height() >= 44.0);
    picture(&mut page, "history phone light");
}

#[test]
fn pictures_of_the_list() {
    for (theme, name) in [(Theme::Dark, "dark"), (Theme::Light, "light")] {
        let mut page = Page::drawn(TALL, theme);
        picture(&mut page, &format!("history empty {name}"));
        edit(&mut page);
        click_row(&mut page, "Step 3: Poke faces");
        picture(&mut page, &format!("history {name}"));
    }
}

#[test]
fn in_a_low_window_the_panel_is_closed_until_it_is_opened() {
    let mut page = Page::new();
    assert!(page.has("Filter operations") && !page.has_row("Start: New document"));
    page.click("History panel");
    assert!(page.has_row("Start: New document"));
    page.click("History panel");
    assert!(!page.has_row("Start: New document"));
    page.click("History panel");
    assert!(page.has_row("Start: New document"));
    let kept = page.outside.setting("layout").expect("it is kept");
    assert!(Page::with_setting(DESKTOP, "layout", &kept).has_row("Start: New document"), "{kept}");
}

#[test]
fn operations_stay_in_sight_below_whatever_is_said_about_the_selection() {
    let mut page = Page::new();
    page.command(json!({ "op": "new", "shape": "torus" }));
    for selected in [0, 1, 40] {
        page.select("face", &(0..selected).collect::<Vec<_>>());
        assert!(page.has("Adjust last operation"));
        let top = page.find("Filter operations").rect().bottom();
        let bottom = page.find("History panel").rect().top();
        assert!(bottom - top >= 5.0 * 28.0 + 24.0, "a heading and five rows: {}", bottom - top);
    }
}

#[test]
fn moving_turning_and_scaling_have_their_own_names() {
    let mut page = Page::sized(TALL);
    for (fields, name) in [
        (json!({ "translate": [1, 0, 0] }), "Move"),
        (json!({ "rotate": { "axis": [0, 0, 1], "degrees": 20 } }), "Rotate"),
        (json!({ "scale": 2 }), "Scale"),
        (json!({ "scale": 2, "translate": [1, 0, 0] }), "Transform"),
    ] {
        let mut command = fields;
        command["op"] = "transform".into();
        command["vertices"] = json!([0, 1]);
        page.command(command);
        assert_eq!(page.undo_labels().last().map(String::as_str), Some(name));
        page.click("Edit");
        assert!(page.has_part(&format!("Undo {name}")));
        page.press(Key::Escape);
    }
    assert!(page.has_row("Step 2: Rotate"));
}

/// A page with steps that each move 160 thousand vertices, more than a frame's work; returns the mesh after each.
fn with_large_steps() -> (Page, Vec<Mesh>) {
    let mut page = Page::sized(TALL);
    page.command(json!({ "op": "new", "shape": "grid", "columns": 400, "rows": 1000 }));
    page.select("vertex", &(0..160_000).collect::<Vec<u32>>());
    let mut meshes = vec![page.mesh().clone()];
    for step in 1..=5 {
        page.press(Key::G);
        page.type_text(&step.to_string());
        page.press(Key::Enter);
        meshes.push(page.mesh().clone());
    }
    (page, meshes)
}

/// The number of the state that the page is in.
fn state_of(page: &mut Page, meshes: &[Mesh]) -> usize {
    let edits = page.app().editor().undo_labels().count() - 1;
    assert_eq!(*page.mesh(), meshes[edits], "the state after {edits} edits");
    edits
}

#[test]
fn a_long_jump_takes_several_frames_and_each_shows_a_whole_step() {
    let (mut page, meshes) = with_large_steps();
    assert_eq!(state_of(&mut page, &meshes), 5);
    page.row("Step 1: New shape").click();
    let mut seen = Vec::new();
    for _ in 0..40 {
        page.harness.step();
        seen.push(state_of(&mut page, &meshes));
    }
    seen.dedup();
    assert_eq!(seen, [4, 3, 2, 1, 0], "one after the other");
    assert!(page.app().editor().jump().is_none() && is_current(&page, "Step 1: New shape"));
}

#[test]
fn what_is_done_during_a_jump_comes_after_it_in_order() {
    let (mut page, meshes) = with_large_steps();
    page.row("Step 2: Move").click();
    page.harness.step();
    page.harness.step();
    assert!(page.app().editor().jump().is_some());
    // Two redos and another kind, in the middle of it.
    page.harness.key_press_modifiers(Modifiers::COMMAND, Key::Y);
    page.harness.key_press_modifiers(Modifiers::COMMAND, Key::Y);
    page.harness.key_press(Key::Num2);
    page.run();
    assert!(page.app().editor().jump().is_none());
    assert_eq!(state_of(&mut page, &meshes), 3, "the first move, and the two after it");
    assert_eq!(page.selected().0, Element::Edge);
}

#[test]
fn escape_stops_a_jump_at_a_step() {
    let (mut page, meshes) = with_large_steps();
    page.row("Step 1: New shape").click();
    page.harness.step();
    page.harness.step();
    page.press(Key::Escape);
    let at = state_of(&mut page, &meshes);
    assert!((1..5).contains(&at), "{at}");
    page.wait();
    assert_eq!(state_of(&mut page, &meshes), at, "it stays there");
    assert!(is_current(&page, &format!("Step {}: Move", at + 1)));
}
