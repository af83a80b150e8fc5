//! Telling two fingers on a trackpad from a wheel: browsers report both as the same event.

use egui::{MouseWheelUnit, Vec2};

/// Events further apart than this belong to different turns or strokes, in seconds.
const PAUSE_SECONDS: f64 = 0.2;
/// A turn of a wheel begins with a whole notch; browsers report at least this much of it, in points. A stroke of fingers
/// begins with little.
const LEAST_NOTCH_POINTS: f32 = 50.0;

/// What the latest events of a wheel or a trackpad came from.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Scrolling {
    /// When the last event came, in seconds.
    last: Option<f64>,
    by_fingers: bool,
}

impl Scrolling {
    /// Takes an event at a time in seconds; returns whether fingers made it. The first event of a stroke decides about
    /// all of it: strokes become fast and even out.
    pub fn is_by_fingers(&mut self, unit: MouseWheelUnit, delta: Vec2, now: f64) -> bool {
        if self.is_over(now) {
            let is_notch = delta.x == 0.0 && delta.y.abs() >= LEAST_NOTCH_POINTS;
            self.by_fingers = unit == MouseWheelUnit::Point && !is_notch;
        }
        self.last = Some(now);
        self.by_fingers
    }

    /// Whether the last stroke is over.
    pub fn is_over(&self, now: f64) -> bool {
        self.last.is_none_or(|last| now - last > PAUSE_SECONDS)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::vec2;

    #[test]
    fn the_first_event_of_a_stroke_decides() {
        let mut scrolling = Scrolling::default();
        let point = MouseWheelUnit::Point;
        assert!(scrolling.is_by_fingers(point, vec2(0.0, 1.5), 0.0));
        assert!(scrolling.is_by_fingers(point, vec2(0.0, 120.0), 0.1), "fast by now");
        assert!(!scrolling.is_by_fingers(point, vec2(0.0, 120.0), 1.0), "a notch");
        assert!(!scrolling.is_by_fingers(point, vec2(0.0, 4.0), 1.1), "smoothed by the system");
        assert!(scrolling.is_by_fingers(point, vec2(-60.0, 80.0), 2.0), "wheels turn one way");
        assert!(!scrolling.is_by_fingers(MouseWheelUnit::Line, vec2(0.0, 1.0), 3.0));
    }
}
