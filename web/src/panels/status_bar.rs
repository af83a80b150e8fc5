//! The bar at the bottom: counts, jobs, renderer and frame time.

use egui::{Align, Layout, ProgressBar, Rect, RichText, Sense, Ui, Vec2, WidgetInfo, vec2};
use halfedge::Element;

use crate::page_view::Page;
use crate::request::{Request, Requests};
use crate::widgets::icons::{Icon, icon_button};
use halfedge::words::thousands;

/// Shorter jobs show no progress bar, which would only flash.
const SECONDS_BEFORE_PROGRESS_SHOWS: f64 = 0.3;

/// Shows the bar. `target_edge` is the edge length of resampling where one is set.
pub(crate) fn show(ui: &mut Ui, page: &Page<'_>, narrow: bool, target_edge: Option<f64>, out: &mut Requests) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = if narrow { 8.0 } else { 14.0 };
        match page.jobs.waited(ui.input(|input| input.time)) {
            Some(waited) if waited >= SECONDS_BEFORE_PROGRESS_SHOWS => job_progress(ui, page, narrow, out),
            Some(waited) => {
                ui.ctx().request_repaint_after_secs((SECONDS_BEFORE_PROGRESS_SHOWS - waited) as f32)
            }
            None => {}
        }
        counts(ui, page, narrow, target_edge);
        if !narrow {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| machine(ui, page));
        }
    });
}

fn counts(ui: &mut Ui, page: &Page<'_>, narrow: bool, target_edge: Option<f64>) {
    let Some(mesh) = page.editor.mesh() else {
        ui.label(RichText::new("No mesh").weak());
        return;
    };
    let figure = |ui: &mut Ui, short: &str, value: String, meaning: &str| {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            ui.label(RichText::new(short).small().weak());
            let number = ui.label(RichText::new(&value).small());
            number.clone().accessible_name(format!("{meaning}: {value}"));
            number.on_hover_text(meaning);
        });
    };
    let count = |kind| thousands(mesh.count(kind));
    figure(ui, "V", count(Element::Vertex), "Vertices");
    figure(ui, "E", count(Element::Edge), "Edges");
    figure(ui, "F", count(Element::Face), "Faces");
    figure(ui, "H", count(Element::Halfedge), "Half-edges");
    let found = page.survey.found();
    let number = |value: Option<usize>| value.map_or_else(|| "…".to_owned(), thousands);
    figure(
        ui,
        "Euler",
        mesh.euler_characteristic().to_string(),
        "Euler characteristic: vertices − edges + faces",
    );
    if !narrow {
        figure(ui, "Boundary loops", number(found.map(|f| f.boundary_loops)), "Boundary loops");
        figure(ui, "Components", number(found.map(|f| f.components)), "Connected components");
        if let Some(length) = target_edge {
            figure(ui, "Target edge length", length.to_string(), "Target edge length of resampling");
        }
    }
}

fn machine(ui: &mut Ui, page: &Page<'_>) {
    let device = page.platform.device();
    let renderer = match device.renderer.as_str() {
        "webgpu" => "WebGPU",
        "webgl2" => "WebGL2",
        other => other,
    };
    let time = format!("{:.1} ms", page.frames.median());
    ui.label(RichText::new(time).small().weak()).on_hover_text(format!(
        "Median processor time per frame; the longest was {:.1} ms",
        page.frames.worst()
    ));
    if !renderer.is_empty() {
        ui.label(RichText::new(renderer).small().weak())
            .on_hover_text(format!("Drawn with {renderer}. {}", device.adapter));
    }
}

fn job_progress(ui: &mut Ui, page: &Page<'_>, narrow: bool, out: &mut Requests) {
    let waiting = page.jobs.iter().count().saturating_sub(1);
    if let Some(job) = page.jobs.iter().next() {
        let text = if waiting > 0 { format!("{} (+{waiting})", job.label) } else { job.label.clone() };
        let width = if narrow { 120.0 } else { 200.0 };
        let size = vec2(width, 16.0);
        if job.fraction > 0.0 {
            let bar = ProgressBar::new(job.fraction)
                .desired_width(size.x)
                .desired_height(size.y)
                .text(RichText::new(&text).small());
            ui.add_sized(size, bar).accessible_name(text);
        } else {
            indeterminate_bar(ui, size, &text);
        }
        if icon_button(ui, Icon::Close, &format!("Cancel {}", job.label), false)
            .on_hover_text("Cancel (Escape)")
            .clicked()
        {
            out.push(Request::CancelJob(job.id));
        }
    }
}

/// A bar for a job that has not reported progress: a segment moves to and fro.
fn indeterminate_bar(ui: &mut Ui, size: Vec2, text: &str) {
    const SECONDS: f64 = 1.6;
    const LENGTH: f32 = 0.3;
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(egui::Role::ProgressIndicator, true, text));
    let turn = ui.input(|input| input.time / SECONDS).fract() * std::f64::consts::TAU;
    let start = (0.5 - 0.5 * turn.cos()) as f32 * (1.0 - LENGTH) * size.x;
    let part = Rect::from_min_size(rect.min + vec2(start, 0.0), vec2(LENGTH * size.x, size.y));
    let visuals = ui.visuals();
    let radius = size.y / 2.0;
    ui.painter().rect_filled(rect, radius, visuals.extreme_bg_color);
    ui.painter().rect_filled(part, radius, visuals.selection.bg_fill);
    let font = egui::TextStyle::Small.resolve(ui.style());
    let galley = ui.painter().layout(text.to_owned(), font, visuals.text_color(), size.x - 12.0);
    let at = rect.left_center() + vec2(6.0, -galley.size().y / 2.0);
    ui.painter().with_clip_rect(rect).galley(at, galley, visuals.text_color());
    // Frequent enough for visible motion, but no more: the worker needs the processor.
    ui.ctx().request_repaint_after_secs(0.05);
}
