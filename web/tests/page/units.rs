//! Units in typed numbers: of lengths, angles and factors, in edits that follow the pointer and in forms.

use crate::page::{DESKTOP, Page};
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};
use glam::Vec3;
use halfedge::VertexId;

fn in_millimetres() -> Page {
    Page::with_setting(DESKTOP, "length-unit", "mm")
}

/// Types a text character by character, as keys with the text that they make.
fn type_keys(page: &mut Page, text: &str) {
    for letter in text.chars() {
        if let Some(key) = Key::from_name(&letter.to_ascii_uppercase().to_string()) {
            page.harness.key_press(key);
        }
        page.type_text(&letter.to_string());
    }
}

fn first(page: &mut Page) -> Vec3 {
    page.mesh().position(VertexId::new(0))
}

/// How far vertex 0 moves along x when this is typed.
fn moved_by(page: &mut Page, text: &str) -> f32 {
    page.select("vertex", &[0]);
    let before = first(page);
    page.press(Key::G);
    page.press(Key::X);
    type_keys(page, text);
    page.press(Key::Enter);
    let by = first(page) - before;
    assert_eq!((by.y, by.z), (0.0, 0.0), "{text}");
    page.press_with(Modifiers::COMMAND, Key::Z);
    by.x
}

#[test]
fn lengths_are_typed_in_any_unit() {
    let mut page = in_millimetres();
    for (text, wanted) in [
        ("2mm", 2.0),
        ("1cm", 10.0),
        ("1m", 1000.0),
        ("1in", 25.4),
        ("1ft", 304.8),
        ("1cm+2mm", 12.0),
        ("3", 3.0),
    ] {
        let moved = moved_by(&mut page, text);
        assert!((moved - wanted).abs() < wanted * 1e-5, "{text}: {moved}");
    }
}

#[test]
fn angles_and_factors_have_units_too() {
    let mut page = Page::new();
    page.select("vertex", &[0, 1, 2, 3, 4, 5, 6, 7]);
    let before = first(&mut page);
    for text in ["90deg", "90°", "pi/2rad"] {
        page.press_with(Modifiers::SHIFT, Key::R);
        page.press(Key::Y);
        // `pi` follows an operator.
        type_keys(&mut page, if text.starts_with('p') { "1*pi/2rad" } else { text });
        page.press(Key::Enter);
        let wanted = Vec3::new(before.z, before.y, -before.x);
        assert!(first(&mut page).distance(wanted) < 1e-5, "{text}");
        page.press_with(Modifiers::COMMAND, Key::Z);
    }
    page.press_with(Modifiers::SHIFT, Key::D);
    type_keys(&mut page, "50%");
    page.press(Key::Enter);
    assert!(first(&mut page).distance(before * 0.5) < 1e-6);
}

#[test]
fn a_unit_that_means_nothing_is_refused_and_can_be_typed_again() {
    let mut page = Page::new();
    page.select("vertex", &[0]);
    let before = first(&mut page);
    page.press(Key::G);
    page.press(Key::X);
    type_keys(&mut page, "1cm");
    assert!(page.has_part("choose what one unit of the mesh is in Edit > Unit of length"));
    page.press(Key::Enter);
    assert!(page.has("Apply"), "the edit goes on");
    assert_eq!(first(&mut page), before);
    page.press(Key::Backspace);
    page.press(Key::Backspace);
    page.press(Key::Enter);
    assert_eq!(first(&mut page), before + Vec3::X);

    page.press(Key::G);
    type_keys(&mut page, "3deg");
    assert!(page.has_part("\"deg\" belongs to an angle, and this is a length"));
    page.press(Key::Escape);
    assert_eq!(first(&mut page), before + Vec3::X);
}

#[test]
fn letters_that_follow_no_number_stay_keys() {
    let mut page = in_millimetres();
    page.select("vertex", &[0]);
    let before = first(&mut page);
    page.press(Key::G);
    page.press(Key::X);
    type_keys(&mut page, "2");
    page.press(Key::Y);
    page.press(Key::Enter);
    assert_eq!(first(&mut page), before + Vec3::Y * 2.0, "Y locks the axis");
}

#[test]
fn the_unit_is_chosen_in_a_menu_and_kept() {
    let mut page = Page::new();
    page.click("Edit");
    page.click("Unit of length");
    page.click("Inches");
    let unit = |page: &mut Page| page.app().script().state()["view"]["length_unit"].clone();
    assert_eq!(unit(&mut page), "in");
    let mut page = page.reload();
    assert_eq!(unit(&mut page), "in");
    assert!((moved_by(&mut page, "1ft") - 12.0).abs() < 1e-4);
}

#[test]
fn forms_take_units_and_say_which_they_take() {
    let mut page = in_millimetres();
    page.select("vertex", &[0]);
    page.choose("Transform");
    let value = |page: &Page| {
        let field = page.harness.get_by_role_and_label(Role::SpinButton, "Translate x");
        field.accesskit_node().numeric_value()
    };
    page.type_into("Translate x", "1cm+2mm");
    assert_eq!(value(&page), Some(12.0));
    page.type_into("Translate x", "3 deg");
    assert_eq!(value(&page), Some(12.0), "as before");
    assert!(
        page.has_part("\"deg\" belongs to an angle, and this is a length: use mm, cm, m, in, ft or no unit.")
    );
    page.type_into("Scale x", "50 %");
    let field = page.harness.get_by_role_and_label(Role::SpinButton, "Scale x");
    assert_eq!(field.accesskit_node().numeric_value(), Some(0.5));
}
