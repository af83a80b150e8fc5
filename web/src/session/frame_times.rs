//! The time that the page's own work takes per frame.

use std::collections::VecDeque;

/// The processor time of the last frames, in milliseconds.
#[derive(Debug, Default)]
pub struct FrameTimes {
    last: VecDeque<f32>,
}

/// The number of frames kept: at most two seconds' worth.
const KEPT_FRAMES: usize = 120;

impl FrameTimes {
    /// Records a frame that took this many seconds.
    pub fn record(&mut self, seconds: f64) {
        if self.last.len() == KEPT_FRAMES {
            self.last.pop_front();
        }
        self.last.push_back((seconds.max(0.0) * 1000.0) as f32);
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
        times.record(9.0);
        for _ in 0..KEPT_FRAMES - 1 {
            times.record(0.002);
        }
        times.record(0.004);
        assert!((times.median() - 2.0).abs() < 1e-3);
        assert!((times.worst() - 4.0).abs() < 1e-3, "the nine seconds are forgotten");
    }
}
