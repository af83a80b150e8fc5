//! The loop cut at the pointer: the ring of quads under the pointer shows where it would be cut, the wheel or a typed
//! number sets the number of cuts, and a click or a drag cuts and slides.

use egui::{Context, Event, Key, Pos2, Stroke, Ui};
use halfedge::Element;
use halfedge::edit::LOOP_CUTS_RANGE;

use super::Viewport;
use crate::input::shortcut::is_digit;
use crate::live::edit::Start;
use crate::page_view::Page;
use crate::view::ring::{RingCut, ShownRing, lines};
use crate::view::{Tool, View};

/// The cut of the ring through an edge at a place on the page: the start of an edit that slides it from there.
pub(super) fn start_at(viewport: &mut Viewport<'_>, at: Pos2) -> Option<Start> {
    let edge = viewport.pick(at, Element::Edge)?;
    let cut = RingCut { edge, cuts: viewport.view.ring.cuts };
    Some(Start { from: Some(at), ..Start::ring_cut(cut) })
}

/// Shows the cuts through the edge under the pointer.
pub(super) fn follow_hovered(viewport: &mut Viewport<'_>) {
    let view = &mut *viewport.view;
    let edge = match view.hovered {
        Some((Element::Edge, edge)) if view.tool == Tool::LoopCut => Some(edge),
        _ => None,
    };
    let cut = edge.map(|edge| RingCut { edge, cuts: view.ring.cuts });
    let lines = cut.zip(viewport.session.editor.mesh()).and_then(|(cut, mesh)| lines(mesh, cut));
    view.ring.shown = ShownRing { cut, lines: lines.unwrap_or_default() };
}

/// Changes the number of cuts by notches of the wheel.
pub(super) fn turn_wheel(view: &mut View, notches: i32) {
    if notches != 0 {
        view.ring.typed = 0;
        set_cuts(view, view.ring.cuts.saturating_add_signed(notches));
    }
}

fn set_cuts(view: &mut View, cuts: u32) {
    view.ring.cuts = LOOP_CUTS_RANGE.nearest(cuts.into()) as u32;
    // The pointer finds its edge again, and the cuts through it.
    view.looked = None;
}

/// Takes the digits out of the frame's input: they type the number of cuts.
pub(crate) fn take_digits(ctx: &Context, view: &mut View) {
    let mut typed = view.ring.typed;
    ctx.input_mut(|input| {
        input.events.retain(|event| match event {
            Event::Text(text) => match text.parse::<u32>() {
                Ok(digit) => {
                    typed = typed.saturating_mul(10).saturating_add(digit);
                    // Beyond the most cuts, the digit begins another number.
                    if !LOOP_CUTS_RANGE.contains(typed.into()) {
                        typed = digit;
                    }
                    false
                }
                Err(_) => true,
            },
            Event::Key { key: Key::Backspace, pressed: true, .. } => {
                typed /= 10;
                false
            }
            // What they type is text: they must not do anything else.
            Event::Key { key, modifiers, .. } => modifiers.any() || !is_digit(*key),
            _ => true,
        });
    });
    if typed != view.ring.typed {
        view.ring.typed = typed;
        set_cuts(view, typed);
    }
}

/// Draws the cuts, also where they lie behind the model: they go around it.
pub(super) fn paint(ui: &Ui, page: &Page<'_>) {
    let hovered = page.view.ring.shown.cut.map(|cut| (Element::Edge, cut.edge));
    if page.view.tool != Tool::LoopCut || page.live.is_some() || hovered != page.view.hovered {
        return;
    }
    let painter = ui.painter().with_clip_rect(page.view.rect);
    let stroke = Stroke::new(2.0, ui.visuals().hyperlink_color);
    for line in &page.view.ring.shown.lines {
        if let [Some(from), Some(to)] = line.map(|point| page.view.project(point)) {
            painter.line_segment([from, to], stroke);
        }
    }
}
