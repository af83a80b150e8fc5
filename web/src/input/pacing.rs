//! When input counts: not before the page has its layout and its document, and at the time when it happened.

use std::collections::VecDeque;

use egui::{Event, RawInput};

/// Frames until the panels have their sizes; what is clicked before isn't where it will be.
const FRAMES_UNTIL_LAYOUT: u32 = 3;

/// How long input waits for the document of the last visit. A larger one leaves the rest of the page usable meanwhile.
const MAX_WAIT_SECONDS: f64 = 2.0;

/// Passes input on to egui. Frames may take longer than the time between the clicks of a double-click: a frame with a
/// button gets the time of the button as its own.
#[derive(Default)]
pub struct Pacing {
    /// The frames since the document was there.
    frames: u32,
    /// The time of the first frame.
    first: Option<f64>,
    /// Input that came before the layout, in the order of frames, with the time of its button.
    held: VecDeque<(Option<f64>, Vec<Event>)>,
    /// The time of the last frame.
    latest: f64,
}

impl Pacing {
    /// Replaces a frame's events and time by those that count in it. `pressed` is the time at which the button among the
    /// events was pressed or released, in seconds on the clock of `raw.time`. While `is_opening`, the document is still
    /// awaited. Returns whether there is input left for the next frame.
    pub fn pace(&mut self, raw: &mut RawInput, pressed: Option<f64>, is_opening: bool) -> bool {
        let mut time = pressed;
        let now = raw.time.unwrap_or_default();
        let waits = is_opening && now - *self.first.get_or_insert(now) < MAX_WAIT_SECONDS;
        self.frames = if waits { 0 } else { self.frames.saturating_add(1) };
        let is_early = self.frames <= FRAMES_UNTIL_LAYOUT;
        if is_early || !self.held.is_empty() {
            let events = std::mem::take(&mut raw.events);
            if !events.is_empty() {
                self.held.push_back((pressed, events));
            }
            time = None;
            // One button at a time, with what came before it.
            while !is_early
                && time.is_none()
                && let Some((pressed, events)) = self.held.pop_front()
            {
                time = pressed;
                raw.events.extend(events);
            }
        }
        if let Some(now) = raw.time {
            // Time never runs backwards.
            self.latest = time.map_or(now, |time| time.min(now)).max(self.latest);
            raw.time = Some(self.latest);
        }
        !self.held.is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::{Modifiers, PointerButton, Pos2};

    fn button(x: f32, pressed: bool) -> Event {
        let (pos, button, modifiers) = (Pos2::new(x, 0.0), PointerButton::Primary, Modifiers::NONE);
        Event::PointerButton { pos, button, pressed, modifiers }
    }

    fn frame(
        pacing: &mut Pacing,
        now: f64,
        events: &[Event],
        pressed: Option<f64>,
    ) -> (Vec<Event>, f64, bool) {
        let mut raw = RawInput { time: Some(now), events: events.to_vec(), ..RawInput::default() };
        let is_left = pacing.pace(&mut raw, pressed, false);
        (raw.events, raw.time.expect("a time"), is_left)
    }

    #[test]
    fn early_clicks_wait_for_the_layout_and_keep_their_times() {
        let mut pacing = Pacing::default();
        let click = [button(1.0, true), button(1.0, false)];
        assert_eq!(frame(&mut pacing, 1.0, &[], None), (vec![], 1.0, false));
        assert_eq!(frame(&mut pacing, 2.0, &click[..1], Some(1.1)), (vec![], 2.0, true));
        assert_eq!(frame(&mut pacing, 3.0, &click[1..], Some(1.2)), (vec![], 3.0, true));
        // Then one button at a time, and what came meanwhile.
        let key = [Event::Text("x".into())];
        assert_eq!(frame(&mut pacing, 4.0, &key, None), (click[..1].to_vec(), 3.0, true));
        assert_eq!(frame(&mut pacing, 5.0, &key, None), (click[1..].to_vec(), 3.0, true));
        assert_eq!(frame(&mut pacing, 6.0, &[], None), ([key.clone(), key].concat(), 6.0, false));
        assert_eq!(frame(&mut pacing, 7.0, &click, None), (click.to_vec(), 7.0, false));
    }

    #[test]
    fn clicks_wait_for_the_document_but_not_for_long() {
        let opening = |pacing: &mut Pacing, now: f64, events: &[Event], is_opening: bool| {
            let mut raw = RawInput { time: Some(now), events: events.to_vec(), ..RawInput::default() };
            pacing.pace(&mut raw, None, is_opening);
            raw.events
        };
        let click = [button(1.0, true)];
        let mut pacing = Pacing::default();
        for at in 0..9 {
            assert_eq!(
                opening(&mut pacing, 5.0 + 0.1 * f64::from(at), &click[..usize::from(at == 4)], true),
                []
            );
        }
        for _ in 0..FRAMES_UNTIL_LAYOUT {
            assert_eq!(opening(&mut pacing, 6.0, &[], false), [], "the view is still being set");
        }
        assert_eq!(opening(&mut pacing, 6.0, &[], false), click);

        let mut pacing = Pacing::default();
        assert_eq!(opening(&mut pacing, 5.0, &click, true), []);
        for _ in 0..FRAMES_UNTIL_LAYOUT {
            assert_eq!(opening(&mut pacing, 5.0 + MAX_WAIT_SECONDS, &[], true), []);
        }
        assert_eq!(opening(&mut pacing, 5.0 + MAX_WAIT_SECONDS, &[], true), click);
    }

    #[test]
    fn clicks_of_slow_frames_are_as_far_apart_as_they_were() {
        let mut pacing = Pacing::default();
        for now in [0.1, 0.2, 0.3] {
            frame(&mut pacing, now, &[], None);
        }
        let times: Vec<f64> = [(1.0, 0.5), (1.9, 0.6), (1.95, 0.7), (2.8, 0.75)]
            .map(|(now, at)| frame(&mut pacing, now, &[button(0.0, true)], Some(at)).1)
            .to_vec();
        assert_eq!(times, [0.5, 0.6, 0.7, 0.75]);
        // A clock that is ahead, or behind the last frame.
        assert_eq!(frame(&mut pacing, 3.0, &[button(0.0, true)], Some(9.0)).1, 3.0);
        assert_eq!(frame(&mut pacing, 3.5, &[button(0.0, true)], Some(2.0)).1, 3.0);
    }

    #[test]
    fn egui_sees_a_double_click_however_slow_its_frames_are() {
        for (apart, expected) in [(0.2, true), (0.9, false)] {
            let mut pacing = Pacing::default();
            let ctx = egui::Context::default();
            let mut doubles = 0;
            let mut now = 0.0;
            let mut run = |events: Vec<Event>, pressed: Option<f64>| {
                // Every frame takes a second.
                now += 1.0;
                let mut raw = RawInput { time: Some(now), events, ..RawInput::default() };
                pacing.pace(&mut raw, pressed, false);
                let id = egui::Id::unique("area");
                let mut output = ctx.run_ui(raw, |ui| {
                    let area = ui.interact(ui.max_rect(), id, egui::Sense::click());
                    doubles += usize::from(area.double_clicked());
                });
                output.textures_delta.clear();
            };
            (0..4).for_each(|_| run(vec![Event::PointerMoved(Pos2::new(9.0, 9.0))], None));
            for (at, pressed) in [(4.1, true), (4.2, false), (4.1 + apart, true), (4.2 + apart, false)] {
                let (pos, button, modifiers) = (Pos2::new(9.0, 9.0), PointerButton::Primary, Modifiers::NONE);
                run(vec![Event::PointerButton { pos, button, pressed, modifiers }], Some(at));
            }
            assert_eq!(doubles > 0, expected, "{apart} s apart");
        }
    }
}
