//! Live edits: extrude, inset, bevel, move and the place of a split follow the pointer until a click
//! or Enter makes one undo step of them, or Escape leaves no trace. A number typed, or set in the
//! field over the viewport, does instead of the pointer: fingers have nothing to hover with.

use editor::Spec;
use egui::{Align2, Area, Context, DragValue, Event, Frame, Id, Key, Order, Pos2, RichText, Ui, pos2};
use glam::{Vec3, vec2};
use halfedge::Element;
use serde_json::{Value, json};

use crate::actions;
use crate::app::App;

/// What the pointer changes.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Amount {
    /// A length; right and up is more.
    Length,
    /// A length above zero.
    Width,
    /// A fraction of an edge, from the middle.
    Fraction,
    /// A vector in the plane of the view.
    Offset,
}

/// The operations that can be done live, with the field that changes.
const LIVE: &[(&str, &str, Amount)] = &[
    ("extrude-faces", "distance", Amount::Length),
    ("extrude-edges", "offset", Amount::Offset),
    ("inset-faces", "amount", Amount::Width),
    ("bevel-edges", "width", Amount::Width),
    ("bevel-vertices", "width", Amount::Width),
    ("split-edge", "t", Amount::Fraction),
    ("transform", "translate", Amount::Offset),
];

/// How far the pointer goes to slide over a whole edge, in points.
const EDGE_TRAVEL: f32 = 240.0;

/// A live edit that is going on.
pub(crate) struct Live {
    spec: &'static Spec,
    field: &'static str,
    amount: Amount,
    /// The amount; only the first number counts but for an offset.
    value: Vec3,
    /// What was typed, digit by digit.
    typed: String,
    /// Where the pointer was when it began to count; none until it is over the viewport, and again
    /// when a number was given otherwise.
    from: Option<Pos2>,
    /// Where the pointer was last: what is shown stays as it is, whatever the panels beside the
    /// viewport do to its size, until the pointer moves.
    at: Option<Pos2>,
    follows: bool,
    /// Whether the document has the edit in it.
    shown: bool,
    /// Why it has not.
    refused: Option<String>,
}

impl Live {
    fn new(name: &str) -> Option<Self> {
        let &(_, field, amount) = LIVE.iter().find(|(op, ..)| *op == name)?;
        let value = if amount == Amount::Fraction { Vec3::splat(0.5) } else { Vec3::ZERO };
        Some(Self {
            spec: actions::operation(name)?,
            field,
            amount,
            value,
            typed: String::new(),
            from: None,
            at: None,
            follows: true,
            shown: false,
            refused: None,
        })
    }

    fn command(&self) -> Value {
        let value = match self.amount {
            Amount::Offset => json!(self.value.to_array()),
            _ => json!(self.value.x),
        };
        json!({ "op": self.spec.name, self.field: value })
    }

    /// Whether the amount is one that changes something.
    fn does_something(&self) -> bool {
        self.amount == Amount::Fraction || self.value != Vec3::ZERO
    }

    fn set(&mut self, x: f32) {
        self.value.x = match self.amount {
            Amount::Width => x.max(0.0),
            Amount::Fraction => x.clamp(0.01, 0.99),
            _ => x,
        };
    }
}

/// Whether an operation has an amount that can be changed live.
pub(crate) fn is_live(name: &str) -> bool {
    LIVE.iter().any(|(op, ..)| *op == name)
}

/// Operations that exist for several kinds of elements and share a key: the one that has it, the kinds
/// that are selected where another is meant, and that other.
const FAMILIES: &[(&str, &[Element], &str)] = &[
    ("extrude-faces", &[Element::Edge, Element::Halfedge], "extrude-edges"),
    ("bevel-edges", &[Element::Vertex], "bevel-vertices"),
    ("delete-faces", &[Element::Vertex], "delete-vertices"),
    ("delete-faces", &[Element::Edge, Element::Halfedge], "dissolve-edge"),
];

/// The operation that a key means for what is selected.
pub(crate) fn for_selection(name: &'static str, kind: Element) -> &'static str {
    let meant = FAMILIES.iter().find(|(holder, kinds, _)| *holder == name && kinds.contains(&kind));
    meant.map_or(name, |(.., other)| other)
}

/// The operation that has the key of another.
pub(crate) fn key_holder(name: &'static str) -> &'static str {
    FAMILIES.iter().find(|(.., other)| *other == name).map_or(name, |(holder, ..)| holder)
}

impl App {
    /// Starts a live edit of what is selected. Nothing changes before the pointer moves.
    pub(crate) fn start_live(&mut self, name: &str) {
        self.end_live(false);
        self.end_preview();
        self.live = Live::new(name);
        if self.live.as_ref().is_some_and(Live::does_something) {
            self.show_live();
        }
    }

    /// Makes the live edit one undo step, or takes it back without a trace.
    pub(crate) fn end_live(&mut self, apply: bool) {
        let Some(live) = self.live.take() else { return };
        if apply && live.refused.is_none() {
            self.commit_preview();
        } else {
            self.editor.cancel_edit();
            self.follow();
        }
    }

    /// Shows the live edit in the document.
    fn show_live(&mut self) {
        let Some(live) = &self.live else { return };
        if !live.does_something() {
            // Back at nothing: as it was, and still going on.
            self.editor.cancel_edit();
            self.follow();
            if let Some(live) = &mut self.live {
                (live.shown, live.refused) = (false, None);
            }
            return;
        }
        let result =
            editor::Command::from_value(live.command()).and_then(|command| self.editor.update_edit(command));
        self.follow();
        if let Some(live) = &mut self.live {
            live.shown = self.editor.is_editing();
            live.refused = result.err().map(|error| error.problem.to_string());
        }
    }

    /// The keys of a live edit, which come before all others: digits, Enter and Escape. Gives whether
    /// one is going on.
    pub(crate) fn live_keys(&mut self, ctx: &Context) -> bool {
        let Some(live) = &mut self.live else { return false };
        if live.shown && !self.editor.is_editing() {
            // An undo or a script ended it.
            self.live = None;
            return false;
        }
        let typing = ctx.text_edit_focused();
        let (mut typed, mut done) = (false, None);
        ctx.input_mut(|input| {
            input.events.retain(|event| match event {
                Event::Key { key: Key::Escape, pressed: true, .. } => {
                    done = Some(false);
                    false
                }
                Event::Key { key: Key::Enter, pressed: true, .. } if !typing => {
                    done = Some(true);
                    false
                }
                Event::Key { key: Key::Backspace, pressed: true, .. } if !typing => {
                    typed |= live.typed.pop().is_some();
                    false
                }
                Event::Text(text) if !typing && live.amount != Amount::Offset => {
                    live.typed.extend(text.chars().filter(|c| c.is_ascii_digit() || ".-".contains(*c)));
                    typed = true;
                    false
                }
                _ => true,
            });
        });
        if typed {
            live.follows = false;
            live.set(live.typed.parse().unwrap_or_default());
            self.show_live();
        }
        if let Some(apply) = done {
            self.end_live(apply);
        }
        true
    }

    /// Lets the amount follow the pointer over the viewport.
    pub(crate) fn live_pointer(&mut self, pointer: Option<Pos2>) {
        let (Some(live), Some(at)) = (&mut self.live, pointer) else { return };
        if !live.follows || live.at.replace(at) == Some(at) {
            return;
        }
        let Some(from) = live.from else {
            live.from = Some(at);
            return;
        };
        let by = at - from;
        let units = self.view.drag_speed() as f32;
        let before = live.value;
        match live.amount {
            Amount::Length | Amount::Width => live.set((by.x - by.y) * units),
            Amount::Fraction => live.set(0.5 + (by.x - by.y) / EDGE_TRAVEL),
            Amount::Offset => {
                let anchor = self.view.camera.target.as_vec3();
                let to = self.view.camera.drag(anchor, vec2(by.x, by.y), self.view.size());
                if to.is_finite() {
                    live.value = to - anchor;
                }
            }
        }
        if live.value != before {
            self.show_live();
        }
    }

    /// The field over the viewport: what is going on, its amount, and how it ends.
    pub(crate) fn live_bar(&mut self, ctx: &Context) {
        let Some(live) = &self.live else { return };
        let top = self.view.rect().center_top();
        let (label, amount, field, mut value) = (live.spec.label, live.amount, live.field, live.value);
        let refused = live.refused.clone();
        let speed = self.view.drag_speed();
        let mut done = None;
        let mut changed = false;
        let area = Area::new(Id::unique("live edit")).order(Order::Foreground).pivot(Align2::CENTER_TOP);
        area.fixed_pos(pos2(top.x, top.y + 8.0)).show(ctx, |ui| {
            Frame::popup(ui.style()).show(ui, |ui| {
                ui.horizontal(|ui| {
                    ui.label(RichText::new(label).strong());
                    changed = amounts(ui, amount, field, speed, &mut value);
                    if ui
                        .button("Apply")
                        .on_hover_text("Makes one undo step of it (Enter, or a click in the viewport)")
                        .clicked()
                    {
                        done = Some(true);
                    }
                    if ui.button("Cancel edit").on_hover_text("Leaves no trace (Escape)").clicked() {
                        done = Some(false);
                    }
                });
                let hint = "Move the pointer, or type a number; Enter applies, Escape cancels.";
                match refused {
                    Some(reason) => ui.colored_label(ui.visuals().warn_fg_color, reason),
                    None => ui.label(RichText::new(hint).small().weak()),
                };
            });
        });
        if changed && let Some(live) = &mut self.live {
            live.follows = false;
            live.typed.clear();
            live.value = value;
            live.set(value.x);
            self.show_live();
        }
        if let Some(apply) = done {
            self.end_live(apply);
        }
    }
}

/// The amount's number, or three of them; gives whether one was changed.
fn amounts(ui: &mut Ui, amount: Amount, field: &str, speed: f64, value: &mut Vec3) -> bool {
    let label = crate::panels::fields::label_of(field);
    if amount != Amount::Offset {
        let speed = if amount == Amount::Fraction { 0.005 } else { speed };
        return ui
            .add(DragValue::new(&mut value.x).speed(speed).max_decimals(5))
            .on_hover_text("Drag, click to type, or just type a number")
            .accessible_name(label)
            .changed();
    }
    let mut changed = false;
    for (axis, number) in ["x", "y", "z"].iter().zip([&mut value.x, &mut value.y, &mut value.z]) {
        changed |= ui
            .add(DragValue::new(number).speed(speed).max_decimals(5))
            .accessible_name(format!("{label} {axis}"))
            .changed();
    }
    changed
}
