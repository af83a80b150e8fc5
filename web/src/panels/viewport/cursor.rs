//! The 3D cursor in the viewport.

use egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, Ui, Vec2, vec2};

use crate::page_view::Page;

/// The radius of the ring, and from where to where the lines of the cross go, in points.
const RING_POINTS: f32 = 9.0;
const CROSS_POINTS: [f32; 2] = [4.0, 15.0];
/// The ring alternates between two colours this many times.
const DASHES: usize = 8;
const STEPS_PER_DASH: usize = 4;
const RED: Color32 = Color32::from_rgb(0xe5, 0x48, 0x4d);

/// Draws the cursor: a ring with a cross.
pub(super) fn paint(ui: &Ui, rect: Rect, page: &Page<'_>) {
    let cursor = &page.view.cursor;
    if !cursor.is_shown {
        return;
    }
    if let Some(middle) = page.view.project(cursor.in_scene(&page.editor)) {
        paint_at(&ui.painter().with_clip_rect(rect), middle);
    }
}

fn paint_at(painter: &Painter, middle: Pos2) {
    // The dark lines behind show on a light background.
    let dark = Stroke::new(3.5, Color32::from_black_alpha(150));
    painter.circle_stroke(middle, RING_POINTS, dark);
    let [from, to] = CROSS_POINTS;
    for stroke in [dark, Stroke::new(1.5, Color32::WHITE)] {
        for way in [Vec2::X, -Vec2::X, Vec2::Y, -Vec2::Y] {
            painter.line_segment([middle + way * from, middle + way * to], stroke);
        }
    }
    for dash in 0..DASHES {
        let angle = |step: usize| {
            let part = dash as f32 + step as f32 / STEPS_PER_DASH as f32;
            part / DASHES as f32 * std::f32::consts::TAU
        };
        let arc = (0..=STEPS_PER_DASH).map(|step| {
            let (sine, cosine) = angle(step).sin_cos();
            middle + vec2(cosine, sine) * RING_POINTS
        });
        let color = if dash % 2 == 0 { RED } else { Color32::WHITE };
        painter.add(Shape::line(arc.collect(), Stroke::new(1.5, color)));
    }
}
