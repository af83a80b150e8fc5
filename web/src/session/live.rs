//! Live edits: extrude, inset, bevel, move and the place of a split follow the pointer. A click or Enter
//! makes the edit one undo step; Escape cancels it without a trace. A number that is typed, or set in the
//! bar over the viewport, replaces the pointer, since touch screens have no hovering pointer.

use editor::ops::{Drag, Field};
use editor::{Command, CommandError, Facts, OpId};
use egui::{Context, Event, Key, Pos2};
use glam::Vec3;
use serde_json::{Value, json};

use super::form;
use crate::session::Session;
use crate::view::View;

/// The distance that the pointer travels to slide over a whole edge, in points.
const EDGE_TRAVEL_POINTS: f32 = 240.0;

/// A live edit in progress.
pub(crate) struct Live {
    pub id: OpId,
    pub field: &'static Field,
    pub drag: Drag,
    /// The amount; only an offset uses all three numbers.
    pub value: Vec3,
    /// The typed number, digit by digit.
    typed: String,
    /// The pointer position that the amount is measured from; none until the pointer is over the viewport,
    /// or while a number was entered instead.
    from: Option<Pos2>,
    /// The last pointer position. The preview changes only when the pointer moves, even if the panels
    /// beside the viewport change its size.
    at: Option<Pos2>,
    follows: bool,
    /// Whether the document shows the edit.
    in_document: bool,
    /// Why the document does not show the edit.
    pub refused: Option<String>,
}

impl Live {
    fn new(id: OpId) -> Option<Self> {
        let field = id.spec().dragged_field()?;
        let drag = field.drag?;
        let value = if drag == Drag::Fraction { Vec3::splat(0.5) } else { Vec3::ZERO };
        let (typed, from, at) = (String::new(), None, None);
        Some(Self {
            id,
            field,
            drag,
            value,
            typed,
            from,
            at,
            follows: true,
            in_document: false,
            refused: None,
        })
    }

    fn command(&self) -> Result<Command, CommandError> {
        let mut filled = form::initial(self.id.spec(), &Facts::default());
        let value: Value = match self.drag {
            Drag::Offset => json!(self.value.to_array()),
            Drag::Distance | Drag::Width | Drag::Fraction => json!(self.value.x),
        };
        filled.insert(self.field.name.to_owned(), value);
        form::command(self.id, &filled)
    }

    /// Whether the amount changes anything.
    fn does_something(&self) -> bool {
        self.drag == Drag::Fraction || self.value != Vec3::ZERO
    }

    fn set(&mut self, x: f32) {
        self.value.x = match self.drag {
            Drag::Width => x.max(0.0),
            Drag::Fraction => x.clamp(0.01, 0.99),
            Drag::Distance | Drag::Offset => x,
        };
    }
}

impl Session {
    /// Starts a live edit of the selection. Except for a split, nothing changes until the pointer moves.
    pub fn start_live(&mut self, id: OpId) {
        self.end_live(false);
        self.end_preview();
        self.live = Live::new(id);
        if self.live.as_ref().is_some_and(Live::does_something) {
            self.show_live();
        }
    }

    /// Makes the live edit one undo step, or cancels it without a trace.
    pub fn end_live(&mut self, apply: bool) {
        let Some(live) = self.live.take() else { return };
        if apply && live.refused.is_none() {
            self.editor.commit_edit();
        } else {
            self.editor.cancel_edit();
        }
    }

    /// Shows the live edit in the document.
    fn show_live(&mut self) {
        let Some(live) = &self.live else { return };
        if !live.does_something() {
            // The amount is back at zero: the document is unchanged, and the edit continues.
            self.editor.cancel_edit();
            if let Some(live) = &mut self.live {
                (live.in_document, live.refused) = (false, None);
            }
            return;
        }
        let result = live.command().and_then(|command| self.editor.update_edit(command));
        if let Some(live) = &mut self.live {
            live.in_document = self.editor.is_editing();
            live.refused = result.err().map(|error| error.reason());
        }
    }

    /// Handles the keys of a live edit, which come before all others: digits, Enter and Escape. Returns
    /// whether an edit is in progress.
    pub fn live_keys(&mut self, ctx: &Context) -> bool {
        let Some(live) = &mut self.live else { return false };
        if live.in_document && !self.editor.is_editing() {
            // An undo or a script ended the edit.
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
                Event::Text(text) if !typing && live.drag != Drag::Offset => {
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

    /// Updates the amount from the pointer over the viewport.
    pub fn live_pointer(&mut self, pointer: Option<Pos2>, view: &View) {
        let (Some(live), Some(at)) = (&mut self.live, pointer) else { return };
        if !live.follows || live.at.replace(at) == Some(at) {
            return;
        }
        let Some(from) = live.from else {
            live.from = Some(at);
            return;
        };
        let by = at - from;
        let units = view.drag_speed() as f32;
        let before = live.value;
        match live.drag {
            Drag::Distance | Drag::Width => live.set((by.x - by.y) * units),
            Drag::Fraction => live.set(0.5 + (by.x - by.y) / EDGE_TRAVEL_POINTS),
            Drag::Offset => {
                let anchor = view.camera.target.as_vec3();
                let to = view.camera.drag(anchor, glam::vec2(by.x, by.y), view.size());
                if to.is_finite() {
                    live.value = to - anchor;
                }
            }
        }
        if live.value != before {
            self.show_live();
        }
    }

    /// Sets the amount of the edit, which then no longer follows the pointer.
    pub fn set_live_amount(&mut self, value: Vec3) {
        let Some(live) = &mut self.live else { return };
        live.follows = false;
        live.typed.clear();
        live.value = value;
        live.set(value.x);
        self.show_live();
    }
}
