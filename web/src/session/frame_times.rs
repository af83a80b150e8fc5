//! The time that the page's own work takes per frame, and how much work that is split over several frames may take.

use halfedge::Budget;
use std::collections::VecDeque;
use std::ops::RangeInclusive;

/// The time of the last frames, in milliseconds, and the work of the next one.
#[derive(Debug)]
pub struct FrameTimes {
    last: VecDeque<f32>,
    /// When the frame in progress began, in seconds.
    began: f64,
    /// The mesh elements that the next frame may process.
    elements: usize,
}

/// The number of frames kept: at most two seconds' worth.
const KEPT_FRAMES: usize = 120;

/// Mesh elements processed in a frame before anything is known about the machine: uploaded, added to a picking tree, tested by
/// a region selection, counted.
const FIRST_ELEMENTS: usize = 150_000;

/// The limits of the elements of a later frame. Slow machines and costly work get fewer.
const ELEMENTS_RANGE: RangeInclusive<usize> = 20_000..=400_000;

/// How long a frame of such work should take: half of what 60 frames a second allow, since the next part may cost more.
const TARGET_MS: f32 = 8.0;

/// By what factor the elements grow at most from one frame to the next.
const MAX_GROWTH: f32 = 1.5;

impl Default for FrameTimes {
    fn default() -> Self {
        Self { last: VecDeque::new(), began: 0.0, elements: FIRST_ELEMENTS }
    }
}

impl FrameTimes {
    /// Begins a frame at this time in seconds; returns the elements that it may process.
    pub fn begin(&mut self, now: f64) -> Budget {
        self.began = now;
        Budget::new(self.elements)
    }

    /// Ends the frame in progress. `has_more` says whether it used its budget up: later ones then get as many elements as fit
    /// into their time.
    pub fn end(&mut self, now: f64, has_more: bool) {
        let took_ms = ((now - self.began).max(0.0) * 1000.0) as f32;
        if self.last.len() == KEPT_FRAMES {
            self.last.pop_front();
        }
        self.last.push_back(took_ms);
        // A clock that stands still, as in tests, says nothing.
        if has_more && took_ms > 0.0 {
            let (least, most) = (*ELEMENTS_RANGE.start(), *ELEMENTS_RANGE.end());
            let factor = (TARGET_MS / took_ms).min(MAX_GROWTH);
            self.elements = ((self.elements as f32 * factor) as usize).clamp(least, most);
        }
    }

    /// The median, or 0 before the first frame.
    pub fn median(&self) -> f32 {
        let mut sorted: Vec<f32> = self.last.iter().copied().collect();
        sorted.sort_unstable_by(f32::total_cmp);
        sorted.get(sorted.len() / 2).copied().unwrap_or_default()
    }

    /// The longest time.
    pub fn worst(&self) -> f32 {
        self.last.iter().copied().fold(0.0, f32::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn median_and_worst_of_the_last_frames() {
        let mut times = FrameTimes::default();
        assert_eq!((times.median(), times.worst()), (0.0, 0.0));
        let mut record = |seconds: f64| {
            times.begin(5.0);
            times.end(5.0 + seconds, false);
        };
        record(9.0);
        for _ in 0..KEPT_FRAMES - 1 {
            record(0.002);
        }
        record(0.004);
        assert!((times.median() - 2.0).abs() < 1e-3);
        assert!((times.worst() - 4.0).abs() < 1e-3, "the nine seconds are forgotten");
    }

    #[test]
    fn frames_take_as_many_elements_as_fit() {
        let mut times = FrameTimes::default();
        // A machine that takes this many seconds for an element.
        let mut frames = |seconds: f64, count: usize| {
            let mut last = 0;
            for _ in 0..count {
                last = times.begin(0.0).left();
                times.end(last as f64 * seconds, true);
            }
            last
        };
        let near = |elements: usize, wanted: usize| elements.abs_diff(wanted) <= wanted / 100;
        assert!(near(frames(4e-8, 10), 200_000), "8 ms");
        assert!(near(frames(1.6e-7, 2), 50_000), "costlier work is cut at once");
        assert_eq!(frames(1e-5, 2), *ELEMENTS_RANGE.start());
        assert_eq!(frames(1e-12, 20), *ELEMENTS_RANGE.end());
        // Frames with little to do say nothing about the machine.
        times.end(0.002, false);
        assert_eq!(times.begin(0.0).left(), *ELEMENTS_RANGE.end());
    }
}
