//! The ring around what has the keyboard focus, in pixels.

use crate::contrast::contrast;
use crate::page::{DESKTOP, PHONE, Page};
use egui::{Color32, Key, Rect, Theme, Vec2};
use image::RgbaImage;

/// The stops that are looked at, from the first on.
const STOPS: usize = 24;
/// The least contrast of the ring with what was there before, and the part of the ring's pixels that have it.
const MIN_CONTRAST: f64 = 3.0;
const MIN_PART: f64 = 0.5;

/// Where the control with the focus is seen.
fn focused(page: &Page) -> Rect {
    let focused = page.harness.ctx.memory(|memory| memory.focused()).expect("a focus");
    let response = page.harness.ctx.read_response(focused).expect("a control that was drawn");
    response.interact_rect.intersect(page.harness.ctx.content_rect())
}

/// The part of the pixels around a control that stand out from what another picture has there.
fn part_that_stands_out(with: &RgbaImage, without: &RgbaImage, control: Rect) -> f64 {
    let (outer, inner) = (control.expand(2.0), control.shrink(2.0));
    let color = |picture: &RgbaImage, x: u32, y: u32| {
        let [r, g, b, _] = picture.get_pixel(x, y).0;
        Color32::from_rgb(r, g, b)
    };
    let (mut around, mut seen) = (0, 0);
    for y in 0..with.height() {
        for x in 0..with.width() {
            let at = egui::pos2(x as f32 + 0.5, y as f32 + 0.5);
            if outer.contains(at) && !inner.contains(at) {
                around += 1;
                seen += u32::from(contrast(color(with, x, y), color(without, x, y)) >= MIN_CONTRAST);
            }
        }
    }
    // Two of the four points of the band are the ring's line.
    f64::from(seen) / (f64::from(around) / 2.0)
}

fn assert_ring_is_seen(size: Vec2, theme: Theme) {
    let mut page = Page::drawn(size, theme);
    let mut stops = Vec::new();
    for _ in 0..STOPS {
        page.press(Key::Tab);
        stops.push((focused(&page), page.harness.render().expect("a picture")));
    }
    for (at, (control, with)) in stops.iter().enumerate() {
        // The rings of neighbours overlap, so the picture without the ring is that of another stop.
        let others =
            [at.checked_sub(3), Some(at + 3)].into_iter().flatten().filter_map(|other| stops.get(other));
        let parts = others.map(|(_, without)| part_that_stands_out(with, without, *control));
        let part = parts.fold(0.0, f64::max);
        assert!(part > MIN_PART, "{theme:?}, stop {at}: {part} of the ring around {control:?} is seen");
    }
}

#[test]
fn the_focus_is_seen_on_every_control_in_both_themes() {
    for theme in [Theme::Dark, Theme::Light] {
        assert_ring_is_seen(DESKTOP, theme);
        assert_ring_is_seen(PHONE, theme);
    }
}
