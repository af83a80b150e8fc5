//! The axis widget: clicks look along axes, drags turn the view.

use crate::looks::picture;
use crate::page::{DESKTOP, PHONE, Page};
use crate::viewport::click_at;
use egui::accesskit::Role;
use egui::{Key, Modifiers, Rect, Theme, vec2};
use egui_kittest::kittest::Queryable;

const SIDES: [(&str, [f32; 3]); 6] = [
    ("View from the front", [0.0, 0.0, 1.0]),
    ("View from the back", [0.0, 0.0, -1.0]),
    ("View from the right", [1.0, 0.0, 0.0]),
    ("View from the left", [-1.0, 0.0, 0.0]),
    ("View from above", [0.0, 1.0, 0.0]),
    ("View from below", [0.0, -1.0, 0.0]),
];

/// Whether the camera looks at the origin from a direction.
fn is_from(page: &mut Page, direction: [f32; 3]) -> bool {
    let [x, y, z] = direction;
    let (near, far, beside) = (page.at(direction), page.at([-x, -y, -z]), page.at([y, z, x]));
    // What is nearer looks larger.
    let nearer = page.at([x + y * 0.1, y + z * 0.1, z + x * 0.1]).distance(near)
        > page.at([-x + y * 0.1, -y + z * 0.1, -z + x * 0.1]).distance(far);
    near.distance(far) < 0.5 && beside.distance(near) > 10.0 && nearer
}

fn ball(page: &Page, name: &str) -> Rect {
    page.harness.get_by_role_and_label(Role::Button, name).rect()
}

#[test]
fn a_click_on_a_ball_looks_along_its_axis_and_another_from_the_opposite_side() {
    for (name, direction) in SIDES {
        let mut page = Page::new();
        // By its place, as a mouse does: each is visible from the first view.
        let at = ball(&page, name).center();
        click_at(&mut page, at, Modifiers::NONE);
        assert!(is_from(&mut page, direction), "{name}");
        let at = ball(&page, name).center();
        click_at(&mut page, at, Modifiers::NONE);
        assert!(is_from(&mut page, direction.map(|part| -part)), "{name}, again");
    }
}

#[test]
fn tooltips_name_the_side_and_its_key() {
    let mut page = Page::new();
    let at = ball(&page, "View from the front").center();
    page.harness.hover_at(at);
    for _ in 0..8 {
        page.harness.step();
    }
    assert!(page.has("View from the front (Alt+1)"));
}

#[test]
fn balls_are_buttons_for_the_keyboard_too() {
    let mut page = Page::new();
    page.find("View from above").focus();
    page.run();
    page.press(Key::Enter);
    assert!(is_from(&mut page, [0.0, 1.0, 0.0]));
}

#[test]
fn a_drag_turns_the_view_and_selects_nothing() {
    let mut page = Page::new();
    let before = page.at([1.0, 0.0, 0.0]);
    let from = ball(&page, "View from the right").center();
    page.drag(from, from + vec2(-60.0, 10.0));
    page.drop(from + vec2(-60.0, 10.0));
    assert!(page.at([1.0, 0.0, 0.0]).distance(before) > 20.0);
    assert!(page.selected().1.is_empty());
    page.press_with(Modifiers::ALT, Key::Num1);
    assert!(is_from(&mut page, [0.0, 0.0, 1.0]), "the keys go on working");
}

#[test]
fn the_widget_lies_beside_the_bars() {
    for size in [DESKTOP, PHONE] {
        let mut page = Page::sized(size);
        let tools = page.find("Tool: Select").rect();
        let viewport = page.find("Viewport").rect();
        let all = SIDES.map(|(name, _)| ball(&page, name));
        let whole = all.into_iter().fold(Rect::NOTHING, Rect::union);
        assert!(viewport.contains_rect(whole), "{whole:?}");
        assert!(whole.right() < tools.left() || whole.left() > tools.right(), "{whole:?} {tools:?}");
        assert!(whole.width() >= 44.0 && whole.height() >= 44.0);
        // A finger beside a ball means the nearest one.
        let top = ball(&page, "View from above");
        click_at(&mut page, top.center() - vec2(0.0, 12.0), Modifiers::NONE);
        assert!(is_from(&mut page, [0.0, 1.0, 0.0]), "{size:?}");
    }
}

#[test]
fn pictures_of_the_widget() {
    for (theme, size, name) in [
        (Theme::Dark, DESKTOP, "dark"),
        (Theme::Light, DESKTOP, "light"),
        (Theme::Light, PHONE, "phone light"),
    ] {
        let mut page = Page::drawn(size, theme);
        let at = ball(&page, "View from the left").center();
        page.harness.hover_at(at);
        page.run();
        picture(&mut page, &format!("axis widget {name}"));
    }
}

#[test]
fn the_up_axis_turns_the_view_but_not_the_mesh() {
    let mut page = Page::drawn(DESKTOP, Theme::Dark);
    let before = page.mesh().clone();
    page.click("View");
    page.click("Up axis");
    page.click("Z up");
    page.command(serde_json::json!({ "op": "transform", "vertices": [4, 5, 6, 7], "translate": [0, 0, 1] }));
    picture(&mut page, "z up");
    assert_eq!(page.mesh().vertex_count(), before.vertex_count());
    for (name, direction) in [
        ("View from above", [0.0, 0.0, 1.0]),
        ("View from the front", [0.0, -1.0, 0.0]),
        ("View from the right", [1.0, 0.0, 0.0]),
    ] {
        page.find(name).focus();
        page.run();
        page.press(Key::Enter);
        assert!(is_from(&mut page, direction), "{name}");
    }
    let up = page.at([0.0, 0.0, 1.0]) - page.at([0.0; 3]);
    assert!(up.y < -10.0 && up.x.abs() < 1.0, "z points upwards: {up:?}");
    assert_eq!(page.outside.setting("up-axis").as_deref(), Some("z"));
    let mut page = Page::with_setting(DESKTOP, "up-axis", "z");
    page.press_with(Modifiers::ALT, Key::Num7);
    assert!(is_from(&mut page, [0.0, 0.0, 1.0]), "kept for later visits");
    // Flat curves are seen from straight above their plane all the same.
    page.press_with(Modifiers::ALT, Key::Num1);
    page.open("arc.bzc", "4\n0 0 1 2 3 2 4 0\n");
    assert!(page.at([0.0; 3]).distance(page.at([0.0, 1.0, 0.0])) > 10.0, "not from its edge");
}
