//! The bar at the bottom: what can be done now, counts, and jobs.

use editor::Jump;
use egui::{
    Align, Galley, Layout, ProgressBar, Rect, RichText, Role, Sense, StrokeKind, TextStyle, Ui, Vec2,
    WidgetInfo, pos2, vec2,
};
use halfedge::Element;

use crate::input::actions::Action;
use crate::lists::columns::plural;
use crate::page_view::Page;
use crate::panels::hints::{By, Hint, hints};
use crate::request::{Request, Requests};
use crate::widgets::icon_button::icon_button;
use crate::widgets::icons::Icon;
use halfedge::words::thousands;

/// Shorter jobs show no progress bar, which would only flash.
const SECONDS_BEFORE_PROGRESS_SHOWS: f64 = 0.3;

/// The kinds of elements that are counted where there is little room.
const NARROW_COUNTS: [Element; 2] = [Element::Vertex, Element::Face];

/// The height of the bar, in points. Only a job has a button in it.
const HEIGHT_POINTS: f32 = 24.0;

/// Shows the bar. `target_edge` is the edge length of resampling where one is set.
pub(crate) fn show(ui: &mut Ui, page: &Page<'_>, narrow: bool, target_edge: Option<f64>, out: &mut Requests) {
    let size = vec2(ui.available_width(), HEIGHT_POINTS);
    ui.allocate_ui_with_layout(size, Layout::right_to_left(Align::Center), |ui| {
        ui.spacing_mut().item_spacing.x = 12.0;
        counts(ui, page, narrow, target_edge);
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            match page.jobs.waited(ui.input(|input| input.time)) {
                Some(waited) if waited >= SECONDS_BEFORE_PROGRESS_SHOWS => {
                    job_progress(ui, page, narrow, out);
                }
                Some(waited) => {
                    ui.ctx().request_repaint_after_secs((SECONDS_BEFORE_PROGRESS_SHOWS - waited) as f32);
                }
                None => {}
            }
            let jumping = page.jump_since.map(|since| ui.input(|input| input.time) - since);
            if let Some(jump) = page.editor.jump()
                && jumping.is_some_and(|seconds| seconds >= SECONDS_BEFORE_PROGRESS_SHOWS)
            {
                jump_progress(ui, jump, narrow, out);
            }
            show_hints(ui, page);
        });
    });
}

/// Shows what buttons, fingers and keys do now, as many of the hints as there is room for.
fn show_hints(ui: &mut Ui, page: &Page<'_>) {
    const HINT_GAP_POINTS: f32 = 16.0;
    const ICON_WIDTH_POINTS: f32 = 16.0;
    let modifiers = ui.input(|input| input.modifiers);
    let font = TextStyle::Small.resolve(ui.style());
    let visuals = ui.visuals();
    let (strong, weak) = (visuals.text_color(), visuals.weak_text_color());
    let (area, response) = ui.allocate_exact_size(ui.available_size().max(Vec2::ZERO), Sense::hover());
    let painter = ui.painter().with_clip_rect(area);
    let (mut x, mut said) = (area.left(), Vec::new());
    for Hint { by, does } in hints(page, modifiers) {
        let key = painter.layout_no_wrap(by.words().to_owned(), font.clone(), strong);
        let text = painter.layout_no_wrap(does.to_string(), font.clone(), weak);
        let by_width = match by {
            By::Mouse(..) => ICON_WIDTH_POINTS,
            By::Key(_) => key.size().x + 8.0,
            By::Touch(_) => key.size().x,
        };
        let width = by_width + 4.0 + text.size().x;
        if x + width > area.right() {
            break;
        }
        let place = Rect::from_min_size(pos2(x, area.top()), vec2(by_width, area.height()));
        let top_of = |galley: &Galley| area.center().y - galley.size().y / 2.0;
        match by {
            By::Mouse(icon, _) => icon.paint(&painter, place, strong),
            By::Key(_) => {
                let cap = place.with_min_y(top_of(&key) - 1.0).with_max_y(top_of(&key) + key.size().y + 1.0);
                let stroke = ui.visuals().widgets.inactive.bg_stroke;
                painter.rect(cap, 3.0, ui.visuals().widgets.inactive.bg_fill, stroke, StrokeKind::Inside);
                painter.galley(pos2(x + 4.0, top_of(&key)), key, strong);
            }
            By::Touch(_) => painter.galley(pos2(x, top_of(&key)), key, strong),
        }
        painter.galley(pos2(x + by_width + 4.0, top_of(&text)), text, weak);
        said.push(format!("{}: {does}", by.words()));
        x += width + HINT_GAP_POINTS;
    }
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, said.join("; ")));
}

fn counts(ui: &mut Ui, page: &Page<'_>, narrow: bool, target_edge: Option<f64>) {
    let Some(mesh) = page.editor.mesh() else {
        ui.label(RichText::new("No mesh").small().weak());
        return;
    };
    // From right to left.
    let figure = |ui: &mut Ui, short: &str, value: String, meaning: &str| {
        let number = ui.label(RichText::new(&value).small());
        ui.ctx().accesskit_node_builder(number.id, |node| node.set_value(format!("{meaning}: {value}")));
        number.on_hover_text(meaning);
        ui.add_space(-8.0);
        ui.label(RichText::new(short).small().weak());
    };
    if let Some(length) = target_edge.filter(|_| !narrow) {
        figure(ui, "Target edge length", length.to_string(), "Target edge length of resampling");
    }
    let all = [(Element::Halfedge, "H"), (Element::Face, "F"), (Element::Edge, "E"), (Element::Vertex, "V")];
    for (kind, short) in all.into_iter().filter(|(kind, _)| !narrow || NARROW_COUNTS.contains(kind)) {
        figure(ui, short, thousands(mesh.count(kind)), plural(kind));
    }
}

/// The progress of a jump in the history.
fn jump_progress(ui: &mut Ui, jump: Jump, narrow: bool, out: &mut Requests) {
    let (done, verb) = (jump.all - jump.left, if jump.back { "Undo" } else { "Redo" });
    let text = format!("{verb} {} of {} steps", thousands(done), thousands(jump.all));
    progress_bar(ui, done as f32 / jump.all as f32, &text, narrow);
    let stop = icon_button(ui, Icon::Close, "Stop at this step", false);
    if stop.on_hover_text("Stop at this step (Escape)").clicked() {
        out.act(Action::Cancel);
    }
}

fn progress_bar(ui: &mut Ui, fraction: f32, text: &str, narrow: bool) {
    let bar = ProgressBar::new(fraction)
        .desired_width(bar_size(narrow).x)
        .desired_height(bar_size(narrow).y)
        .text(RichText::new(text).small());
    ui.add_sized(bar_size(narrow), bar).accessible_name(text);
}

fn bar_size(narrow: bool) -> Vec2 {
    vec2(if narrow { 120.0 } else { 200.0 }, 16.0)
}

fn job_progress(ui: &mut Ui, page: &Page<'_>, narrow: bool, out: &mut Requests) {
    let waiting = page.jobs.iter().count().saturating_sub(1);
    if let Some(job) = page.jobs.iter().next() {
        let text = if waiting > 0 { format!("{} (+{waiting})", job.label) } else { job.label.clone() };
        if job.fraction > 0.0 {
            progress_bar(ui, job.fraction, &text, narrow);
        } else {
            indeterminate_bar(ui, bar_size(narrow), &text, page.session.platform.reduces_motion());
        }
        if icon_button(ui, Icon::Close, &format!("Cancel {}", job.label), false)
            .on_hover_text("Cancel (Escape)")
            .clicked()
        {
            out.push(Request::CancelJob(job.id));
        }
    }
}

/// A bar for a job that has not reported progress: a segment moves to and fro, or stands in the middle.
fn indeterminate_bar(ui: &mut Ui, size: Vec2, text: &str, is_still: bool) {
    const SECONDS_PER_SWEEP: f64 = 1.6;
    const BAR_SHARE: f32 = 0.3;
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::ProgressIndicator, true, text));
    let time = if is_still { SECONDS_PER_SWEEP / 4.0 } else { ui.input(|input| input.time) };
    let turn = (time / SECONDS_PER_SWEEP).fract() * std::f64::consts::TAU;
    let start = (0.5 - 0.5 * turn.cos()) as f32 * (1.0 - BAR_SHARE) * size.x;
    let part = Rect::from_min_size(rect.min + vec2(start, 0.0), vec2(BAR_SHARE * size.x, size.y));
    let visuals = ui.visuals();
    let radius = size.y / 2.0;
    ui.painter().rect_filled(rect, radius, visuals.extreme_bg_color);
    ui.painter().rect_filled(part, radius, visuals.selection.bg_fill);
    let font = egui::TextStyle::Small.resolve(ui.style());
    let galley = ui.painter().layout(text.to_owned(), font, visuals.text_color(), size.x - 12.0);
    let at = rect.left_center() + vec2(6.0, -galley.size().y / 2.0);
    ui.painter().with_clip_rect(rect).galley(at, galley, visuals.text_color());
    if !is_still {
        // Frequent enough for visible motion, but no more: the worker needs the processor.
        ui.ctx().request_repaint_after_secs(0.05);
    }
}
