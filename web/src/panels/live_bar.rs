//! The bar over the viewport for an edit that follows the pointer.

use editor::OpId;
use editor::ops::{Drag, Symmetry};
use egui::{Align2, Area, Context, Frame, Id, Order, Pos2, Rect, RichText, Ui, pos2};

use crate::input::actions::Action;
use crate::input::keys;
use crate::live::edit::{Live, measure_of};
use crate::live::lock::AXIS_NAMES;
use crate::page_view::Page;
use crate::request::{Request, Requests};
use crate::session::live::keeps_cut;
use crate::units::Measure;
use crate::widgets::number_box::number_box;

/// The width of a viewport that has room for a hint.
const MIN_WIDTH_FOR_HINT_POINTS: f32 = 620.0;

/// Shows the bar: the name of the edit, its amount, its lock, and buttons that end it.
pub(crate) fn show(ctx: &Context, page: &Page<'_>, out: &mut Requests) {
    let Some(live) = &page.live else { return };
    // At the bottom, where it hides none of the model, and a thumb reaches it.
    let bottom = page.view.free_area().center_bottom();
    let area = Area::new(id()).order(Order::Foreground).pivot(Align2::CENTER_BOTTOM);
    area.fixed_pos(pos2(bottom.x, bottom.y - 8.0)).constrain_to(page.view.area).show(ctx, |ui| {
        Frame::popup(ui.style()).show(ui, |ui| {
            ui.horizontal_wrapped(|ui| {
                // Beside the tools.
                ui.set_max_width((page.view.free_area().width() - 24.0).max(200.0));
                ui.label(RichText::new(live.label()).strong());
                amounts(ui, live, page.view.drag_speed(), out);
                count(ui, live, out);
                locks(ui, live, out);
                if ui
                    .button("Apply")
                    .on_hover_text("Apply the edit (Enter, or a click in the viewport)")
                    .clicked()
                {
                    out.push(Request::EndLive { commit: true });
                }
                let cancel = if keeps_cut(page) {
                    "Undo the cut. Escape or a right-click leaves it in the middle"
                } else {
                    "Cancel the edit (Escape, or a right-click)"
                };
                if ui.button("Cancel").on_hover_text(cancel).clicked() {
                    out.push(Request::EndLive { commit: false });
                }
            });
            match live.typed.refusal().or_else(|| live.refused.clone()) {
                Some(reason) => ui.colored_label(ui.visuals().warn_fg_color, reason),
                // In a narrow viewport the bar would hide what is edited.
                None if page.view.area.width() < MIN_WIDTH_FOR_HINT_POINTS => return,
                None => ui.label(RichText::new(hint(page, live)).small().weak()),
            };
        });
    });
}

fn id() -> Id {
    Id::unique("live edit")
}

/// Whether a place on the page is on the bar.
pub(crate) fn is_at(ctx: &Context, at: Pos2) -> bool {
    ctx.memory(|memory| memory.area_rect(id())).is_some_and(|bar| bar.contains(at))
}

/// The part of the viewport that neither the bars at its sides nor this one cover.
pub(crate) fn room_above(ctx: &Context, page: &Page<'_>) -> Rect {
    let free = page.view.free_area();
    let bar = ctx.memory(|memory| memory.area_rect(id())).filter(|_| page.live.is_some());
    bar.map_or(free, |bar| free.with_max_y(bar.top().clamp(free.top(), free.bottom())))
}

/// What the pointer and the keys do.
fn hint(page: &Page<'_>, live: &Live) -> String {
    if page.ctx.input(|input| input.any_touches()) {
        return "Drag in the viewport, or set the number.".to_owned();
    }
    let mut parts = vec!["Move the pointer or type a number"];
    let symmetry = page.live_settings.symmetry;
    let is_mirrored = symmetry != Symmetry::None;
    let mirrored = is_mirrored.then(|| format!("mirrored {}", symmetry.label().to_lowercase()));
    parts.extend(mirrored.as_deref());
    let [snap_keys, _] = keys::snap_keys(&page.ctx);
    let snaps = (!snap_keys.is_empty()).then(|| format!("hold {snap_keys} to snap"));
    if live.is_move() && snaps.is_some() {
        parts.extend(snaps.as_deref());
    } else if live.takes_lock() {
        parts.push("X, Y, Z lock an axis, with Shift a plane");
    }
    if live.takes_wheel(&page.live_settings) {
        parts.push(if live.count.is_some() {
            "the wheel sets the count"
        } else {
            "the wheel sets the radius"
        });
    }
    let slides = slide_hint(page, live);
    parts.extend(slides.as_deref());
    parts.push("Ctrl snaps, Shift slows the pointer");
    format!("{}.", parts.join("; "))
}

/// What the key of a move does while it goes on, if the selection can slide.
fn slide_hint(page: &Page<'_>, live: &Live) -> Option<String> {
    let slide = Action::Operation(OpId::SlideEdges).for_selection(page.editor.selection().kind());
    let key = keys::text(&page.ctx, Action::Move);
    let can = live.is_move() && !key.is_empty() && page.why_not(slide).is_none();
    can.then(|| format!("{key} slides"))
}

/// The numbers of the amount.
fn amounts(ui: &mut Ui, live: &Live, speed: f64, out: &mut Requests) {
    let label = live.field.label();
    let mut value = live.value;
    let (suffix, speed) = match live.drag {
        Drag::Rotation => ("°", 0.5),
        Drag::Factors | Drag::Fraction | Drag::Slide => ("", 0.005),
        Drag::Distance | Drag::Width | Drag::Offset => ("", speed),
    };
    let several = matches!(live.drag, Drag::Offset | Drag::Factors);
    let shown = if several { live.lock.free_axes() } else { &[0] };
    let before = value;
    for (at, &axis) in shown.iter().enumerate() {
        let Some(number) = value.as_mut().get_mut(axis) else { continue };
        let name = if several { AXIS_NAMES.get(axis).copied().unwrap_or_default() } else { "" };
        let prefix = if several { format!("{name} ") } else { String::new() };
        if let Some(text) = live.typed.text(at) {
            // As it was typed, also while it is no number yet.
            ui.label(RichText::new(format!("{prefix}{text}")).monospace().strong());
            continue;
        }
        let accessible = if several { format!("{label} {name}") } else { label.clone() };
        let field = number_box(ui, number, measure_of(live.drag))
            .speed(speed)
            .max_decimals(5)
            .prefix(prefix)
            .suffix(suffix);
        ui.add(field).on_hover_text("Drag, or type a number").accessible_name(accessible);
    }
    if value != before {
        out.push(Request::SetLiveAmount(value));
    }
}

/// The operation's count.
fn count(ui: &mut Ui, live: &Live, out: &mut Requests) {
    let Some((field, mut count)) = live.count else { return };
    let Some(range) = field.range() else { return };
    let label = field.label();
    ui.label(&label);
    let bounds = range.bounds();
    let field = number_box(ui, &mut count, Measure::Number)
        .range(*bounds.start() as u32..=*bounds.end() as u32)
        .speed(0.1);
    let response = ui.add(field).accessible_name(label);
    if response.on_hover_text("Drag, type a number, or turn the wheel over the viewport").changed() {
        out.push(Request::SetLiveCount(count));
    }
}

/// The buttons that limit the edit to an axis.
fn locks(ui: &mut Ui, live: &Live, out: &mut Requests) {
    if !live.takes_lock() {
        return;
    }
    for (axis, name) in AXIS_NAMES.iter().enumerate() {
        let on = live.lock.free_axes() == [axis];
        let key = name.to_uppercase();
        let hint = format!("Only along {name}; again for the selection's own axes ({key})");
        if ui.selectable_label(on, &key).on_hover_text(hint).clicked() {
            out.push(Request::LockLive(axis));
        }
    }
    if let Some(words) = live.lock.words() {
        ui.label(RichText::new(words).weak());
    }
}
