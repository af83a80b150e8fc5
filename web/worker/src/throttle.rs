//! How often a job's progress is reported.

/// Passes progress about 20 times a second, so that a job that reports a million times does not spend its
/// time, and the page's, on messages.
#[derive(Clone, Copy, Debug)]
pub struct Throttle {
    last: f64,
}

/// The shortest time between two messages, in milliseconds.
const INTERVAL_MILLISECONDS: f64 = 50.0;

impl Throttle {
    /// Nothing passes in the first interval after `now`, in milliseconds: a job that ends by then needs no
    /// progress.
    pub fn new(now: f64) -> Self {
        Self { last: now }
    }

    /// Whether to report at `now`, in milliseconds. If the clock is set back, that only delays the next
    /// report.
    pub fn allows(&mut self, now: f64) -> bool {
        if now - self.last < INTERVAL_MILLISECONDS && now >= self.last {
            return false;
        }
        self.last = now;
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn passes_one_per_interval() {
        let mut throttle = Throttle::new(1000.0);
        let told: Vec<u32> = (0..=200).filter(|t| throttle.allows(1000.0 + f64::from(*t))).collect();
        assert_eq!(told, [50, 100, 150, 200]);
    }

    #[test]
    fn a_clock_set_back_does_not_silence_it() {
        let mut throttle = Throttle::new(1_000_000.0);
        assert!(throttle.allows(10.0));
        assert!(!throttle.allows(59.0));
        assert!(throttle.allows(60.0));
    }
}
