//! Screens with more pixels per point, and a larger interface: sizes stay what they are for eyes and fingers.

use std::collections::BTreeMap;

use crate::page::{DESKTOP, PHONE, Page};
use crate::viewport::click_at;
use egui::{Key, Modifiers, Rect, Shape, Vec2};
use meshwright_web::access::tree::UiTree;
use meshwright_web::platform::headless::Outside;

/// Positions are rounded to pixels, and text is laid out in whole ones.
const ROUNDING_POINTS: f32 = 1.5;

/// The controls on the page, by role and name, with their places in CSS pixels: those that are there once.
fn controls(page: &Page) -> BTreeMap<String, Rect> {
    let tree = page.harness.ctx.plugin::<UiTree>();
    let mut found: BTreeMap<String, Vec<Rect>> = BTreeMap::new();
    for widget in tree.lock().read() {
        let name = format!("{:?} {}", widget.node.role(), widget.name);
        found.entry(name).or_default().push(widget.rect);
    }
    found.into_iter().filter(|(_, rects)| rects.len() == 1).map(|(name, rects)| (name, rects[0])).collect()
}

/// The sizes of the letters that are drawn, by text.
fn letters(page: &Page) -> BTreeMap<String, f32> {
    let mut found = BTreeMap::new();
    let mut add = |shape: &Shape| {
        if let Shape::Text(text) = shape {
            for section in &text.galley.job.sections {
                found.insert(text.galley.job.text.clone(), section.format.font_id.size);
            }
        }
    };
    for clipped in &page.harness.output().shapes {
        match &clipped.shape {
            Shape::Vec(shapes) => shapes.iter().for_each(&mut add),
            shape => add(shape),
        }
    }
    found
}

/// Fails unless the controls of a page are as those of another, times a factor.
fn assert_same_size(page: &Page, like: &Page, factor: f32) {
    let (these, those) = (controls(page), controls(like));
    let mut compared = 0;
    for (name, rect) in &these {
        let Some(other) = those.get(name) else { continue };
        // What fills the rest of the window has no size of its own.
        if rect.height() > 80.0 || rect.width() > 200.0 || !rect.is_positive() {
            continue;
        }
        let away = (rect.size() - other.size() * factor).abs().max_elem();
        assert!(
            away <= ROUNDING_POINTS * factor,
            "{name}: {:?}, not {:?}",
            rect.size(),
            other.size() * factor
        );
        compared += 1;
    }
    assert!(compared > 15, "{compared} controls are on both pages");
}

/// The vertices, edges and faces under places of the cube, picked by clicks.
fn picked(page: &mut Page) -> Vec<(String, Vec<u32>)> {
    let mut found = Vec::new();
    let (_, corner) = crate::viewport::nearest_vertex(page);
    let middle = page.at([0.0; 3]);
    for (key, at) in [
        (Key::Num1, corner),
        (Key::Num1, corner + egui::vec2(6.0, 5.0)),
        (Key::Num2, corner + (middle - corner) * 0.4),
        (Key::Num4, corner + egui::vec2(-6.0, 30.0)),
        (Key::Num4, corner + egui::vec2(0.0, -30.0)),
    ] {
        page.press(key);
        click_at(page, at, Modifiers::NONE);
        let (kind, ids) = page.selected();
        found.push((kind.to_string(), ids));
    }
    found
}

#[test]
fn more_pixels_per_point_change_no_size_and_no_pick() {
    for (size, densities) in [(DESKTOP, &[2.0][..]), (PHONE, &[2.0, 3.0][..])] {
        for &density in densities {
            let mut coarse = Page::sized(size);
            let mut fine = Page::dense(size, density);
            assert_eq!(fine.harness.ctx.pixels_per_point(), density);
            assert_same_size(&fine, &coarse, 1.0);
            assert_eq!(letters(&fine), letters(&coarse), "at {density}");
            let found = picked(&mut fine);
            assert!(found.iter().all(|(_, ids)| ids.len() == 1), "{found:?}");
            assert_eq!(found, picked(&mut coarse), "at {density}");
            // The picture has the pixels.
            assert_eq!(fine.harness.ctx.content_rect().size(), size, "as large in points");
        }
    }
}

#[test]
fn a_larger_interface_makes_text_and_targets_larger_and_picks_the_same() {
    let scaled = |size: Vec2, percent: &str| {
        let outside = Outside::default();
        outside.set_setting("scale", percent);
        Page::visit_sized(&outside, size)
    };
    // A window that is larger by as much has room for the same.
    let mut plain = scaled(DESKTOP, "100");
    let mut large = scaled(DESKTOP * 1.5, "150");
    assert_eq!(large.harness.ctx.zoom_factor(), 1.5);
    assert_same_size(&large, &plain, 1.5);
    assert_eq!(letters(&large), letters(&plain), "in points, which are larger");
    assert_eq!(picked(&mut large), picked(&mut plain));
    // In a window of the same size too, what is clicked is selected.
    let mut crowded = scaled(DESKTOP, "150");
    let found = picked(&mut crowded);
    assert!(found.iter().all(|(_, ids)| ids.len() == 1), "{found:?}");
}
