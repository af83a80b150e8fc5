//! Keys and text that wait for a later frame, because what comes before them in the same frame decides what they mean.

use std::collections::VecDeque;

use egui::{Context, Event, Key};

/// Frames that what Enter opens needs until it has the focus: it is drawn in one, and has the focus in the next.
const FRAMES_AFTER_ENTER: u32 = 1;

/// Input that waits, in order.
#[derive(Default)]
pub struct HeldKeys {
    /// Each part with the frames that pass before its own.
    parts: VecDeque<(u32, Vec<Event>)>,
}

impl HeldKeys {
    /// Gives a frame the part that it is the turn of, and takes from it what has to wait: everything typed after Enter, which
    /// opens or closes a field or a dialog at the end of the frame, and everything typed while other keys wait.
    pub fn pace(&mut self, ctx: &Context) {
        let mut given = Vec::new();
        match self.parts.front_mut() {
            Some((frames, _)) if *frames > 0 => *frames -= 1,
            Some(_) => given = self.parts.pop_front().map(|(_, events)| events).unwrap_or_default(),
            None => {}
        }
        ctx.input_mut(|input| {
            if let Some((_, last)) = self.parts.back_mut() {
                last.extend(input.events.extract_if(.., |event| is_typed(event)));
            }
            input.events.splice(0..0, given);
            let mut after_enter = false;
            let mut later = Vec::new();
            input.events.retain(|event| {
                let waits = after_enter && is_typed(event) && !is_release_of_enter(event);
                later.extend(waits.then(|| event.clone()));
                after_enter |= matches!(event, Event::Key { key: Key::Enter, pressed: true, .. });
                !waits
            });
            if !later.is_empty() {
                self.parts.push_front((FRAMES_AFTER_ENTER, later));
            }
        });
        self.go_on(ctx);
    }

    /// Keeps keys for the next frame, before those that wait already.
    pub fn hold(&mut self, ctx: &Context, events: Vec<Event>) {
        if !events.is_empty() {
            self.parts.push_front((0, events));
        }
        self.go_on(ctx);
    }

    fn go_on(&self, ctx: &Context) {
        if !self.parts.is_empty() {
            ctx.request_repaint();
        }
    }
}

/// Whether an event comes from the keyboard.
pub(super) fn is_typed(event: &Event) -> bool {
    matches!(event, Event::Key { .. } | Event::Text(_) | Event::Ime(_))
}

fn is_release_of_enter(event: &Event) -> bool {
    matches!(event, Event::Key { key: Key::Enter, pressed: false, .. })
}
