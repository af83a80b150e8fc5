//! The legend: what marks and the colours of faces stand for.

use editor::ops::four_digits;
use egui::{Align2, Color32, FontId, Mesh, Pos2, Rect, Sense, Ui, WidgetInfo, pos2, vec2};
use halfedge::words::thousands;
use viewport::{ColorBy, Legend, Ramp, Theme};

use crate::input::actions::{Action, describe};
use crate::page_view::Page;
use crate::theme;

/// The most labels that are listed.
const MAX_LABELS: usize = 12;
const BAR_POINTS: egui::Vec2 = vec2(14.0, 120.0);
const MARGIN_POINTS: f32 = 10.0;
const LINE_HEIGHT_POINTS: f32 = 16.0;

/// What is measured, in words and its unit.
fn title(by: ColorBy) -> (&'static str, &'static str) {
    match by {
        ColorBy::Material => ("Material", ""),
        ColorBy::Group => ("Group", ""),
        ColorBy::Valence => ("Valence", "edges at a vertex"),
        ColorBy::GaussianCurvature => ("Gaussian curvature", "1 / unit²"),
        ColorBy::MeanCurvature => ("Mean curvature", "1 / unit"),
        ColorBy::Quality => ("Face quality", "1 is regular"),
        ColorBy::Paint | ColorBy::Face | ColorBy::Vertex | ColorBy::Uniform => ("", ""),
    }
}

/// Draws the legend of the active object at the right of the viewport.
pub(super) fn paint(ui: &Ui, rect: Rect, page: &Page<'_>) {
    let shown = page.view.picture.as_ref().zip(page.editor.document().active());
    let Some((picture, active)) = shown else { return };
    let legend = picture.legend(active.id());
    let color = |[r, g, b]: [u8; 3]| Color32::from_rgb(r, g, b);
    let mut lines: Vec<(Option<Color32>, String)> = Vec::new();
    for mark in page.view.style.marks.iter() {
        let count = picture.mark_count(active.id(), mark) as usize;
        let line = format!("{}: {}", describe(Action::Mark(mark)).label, thousands(count));
        lines.push((Some(color(Theme::mark(mark).0)), line));
    }
    let (title, unit) = title(page.view.style.color_by);
    if legend.is_some() {
        lines.extend([title, unit].into_iter().filter(|line| !line.is_empty()).map(|l| (None, l.to_owned())));
    }
    if lines.is_empty() {
        return;
    }
    let mut bar = None;
    match &legend {
        None => {}
        Some(Legend::Ramp(ramp)) => bar = Some(*ramp),
        Some(Legend::Labels(labels)) => {
            let shown = labels.iter().take(MAX_LABELS);
            lines.extend(shown.map(|(label, c)| (Some(color(c.0)), label.clone())));
            match labels.len() {
                0 => lines.push((None, format!("This mesh has no {}s", title.to_lowercase()))),
                n if n > MAX_LABELS => lines.push((None, format!("and {} more", n - MAX_LABELS))),
                _ => {}
            }
        }
    }
    let font = FontId::proportional(12.0);
    let text = ui.visuals().text_color();
    let indent = |color: &Option<Color32>| if color.is_some() { 18.0 } else { 0.0 };
    let galleys: Vec<_> = lines
        .iter()
        .map(|(color, line)| {
            let galley = ui.painter().layout_no_wrap(line.clone(), font.clone(), text);
            (*color, indent(color), galley)
        })
        .collect();
    let width = galleys.iter().map(|(_, indent, galley)| indent + galley.size().x).fold(90.0, f32::max);
    let height = galleys.len() as f32 * LINE_HEIGHT_POINTS + bar.map_or(0.0, |_| BAR_POINTS.y + 14.0);
    let size = vec2(width.min(220.0), height) + vec2(MARGIN_POINTS, MARGIN_POINTS) * 2.0;
    if size.y + 24.0 > rect.height() || size.x + 24.0 > rect.width() {
        return;
    }
    let area = Align2::RIGHT_CENTER.anchor_size(rect.right_center() - vec2(12.0, 0.0), size);
    let said = lines.iter().map(|(_, line)| line.as_str()).collect::<Vec<_>>().join(", ");
    let said =
        bar.map_or(said.clone(), |ramp| format!("{said}, from {} to {}", short(ramp.low), short(ramp.high)));
    let response = ui.interact(area, ui.scope_id().with("legend"), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(egui::Role::Label, true, format!("Legend: {said}")));

    let painter = ui.painter().with_clip_rect(area);
    painter.rect_filled(area, 6.0, theme::palette(ui.visuals()).overlay);
    let mut at = area.min + vec2(MARGIN_POINTS, MARGIN_POINTS);
    for (color, indent, galley) in galleys {
        if let Some(color) = color {
            painter.rect_filled(Rect::from_min_size(at + vec2(0.0, 2.0), vec2(12.0, 12.0)), 2.0, color);
        }
        painter.galley(at + vec2(indent, 0.0), galley, text);
        at.y += LINE_HEIGHT_POINTS;
    }
    if let Some(ramp) = bar {
        draw_bar(&painter, at + vec2(0.0, 6.0), ramp, &font, text);
    }
}

/// The colours from high to low, with the numbers of both ends and the middle.
fn draw_bar(painter: &egui::Painter, at: Pos2, ramp: Ramp, font: &FontId, text: Color32) {
    let mut mesh = Mesh::default();
    let last = (ramp.colors.len() - 1) as f32;
    for (i, color) in ramp.colors.iter().rev().enumerate() {
        let y = at.y + BAR_POINTS.y * i as f32 / last;
        let [r, g, b] = color.0;
        for x in [at.x, at.x + BAR_POINTS.x] {
            mesh.colored_vertex(pos2(x, y), Color32::from_rgb(r, g, b));
        }
        if i > 0 {
            let first = i as u32 * 2 - 2;
            mesh.add_triangle(first, first + 1, first + 2);
            mesh.add_triangle(first + 1, first + 3, first + 2);
        }
    }
    painter.add(mesh);
    for (share, value) in [(0.0, ramp.high), (0.5, (ramp.low + ramp.high) * 0.5), (1.0, ramp.low)] {
        let y = at.y + BAR_POINTS.y * share;
        let place = pos2(at.x + BAR_POINTS.x + 8.0, y);
        painter.text(place, Align2::LEFT_CENTER, short(value), font.clone(), text);
    }
}

fn short(value: f32) -> String {
    let size = four_digits(value.abs().into());
    if value < 0.0 { format!("-{size}") } else { size.to_string() }
}
