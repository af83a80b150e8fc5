//! Ranges of numbers that parameters take.

use std::fmt;
use std::ops::RangeInclusive;

/// The numbers that a parameter takes. Only finite numbers are in a range.
///
/// Displays as what follows "must be": "from 1 to 256", "above 0 and below 1", "0 or more".
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NumberRange {
    min: f64,
    max: f64,
    ends: Ends,
}

/// Which ends of a range belong to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Ends {
    /// Both.
    Both,
    /// The upper one.
    Upper,
    /// Neither.
    Neither,
}

/// The largest bound that says something: beyond it a parameter's type is the limit.
const MAX_BOUND: f64 = u32::MAX as f64;

/// The part of a range by which [`NumberRange::nearest`] stays away from an end that doesn't belong to it.
const OPEN_END_MARGIN: f64 = 0.01;

impl NumberRange {
    /// Every finite number.
    pub const ANY: Self = Self::new(f32::MIN as f64, f32::MAX as f64);

    /// 0 and every positive number.
    pub const NOT_NEGATIVE: Self = Self::new(0.0, f32::MAX as f64);

    /// Every positive number.
    pub const POSITIVE: Self = Self { ends: Ends::Upper, ..Self::NOT_NEGATIVE };

    /// The numbers from `min` to `max`.
    pub const fn new(min: f64, max: f64) -> Self {
        Self { min, max, ends: Ends::Both }
    }

    /// The numbers above `min` up to `max`.
    pub const fn above(min: f64, max: f64) -> Self {
        Self { min, max, ends: Ends::Upper }
    }

    /// The numbers above `min` and below `max`.
    pub const fn between(min: f64, max: f64) -> Self {
        Self { min, max, ends: Ends::Neither }
    }

    /// The whole numbers from `min` to `max`; `u32::MAX` stands for no limit.
    pub const fn counts(min: u32, max: u32) -> Self {
        Self::new(min as f64, max as f64)
    }

    /// Whether a number is in the range.
    pub fn contains(self, value: f64) -> bool {
        match self.ends {
            Ends::Both => self.min <= value && value <= self.max,
            Ends::Upper => self.min < value && value <= self.max,
            Ends::Neither => self.min < value && value < self.max,
        }
    }

    /// Both ends, whether they belong to the range or not.
    pub fn bounds(self) -> RangeInclusive<f64> {
        self.min..=self.max
    }

    /// Both ends of a range of whole numbers.
    pub fn whole_bounds(self) -> RangeInclusive<i64> {
        self.min as i64..=self.max as i64
    }

    /// The number of the range that is nearest to a number; a hundredth of the range away from an end that doesn't belong
    /// to it.
    pub fn nearest(self, value: f64) -> f64 {
        let margin = if self.has_max() {
            (self.max - self.min) * OPEN_END_MARGIN
        } else {
            f64::from(f32::MIN_POSITIVE)
        };
        let (min, max) = match self.ends {
            Ends::Both => (self.min, self.max),
            Ends::Upper => (self.min + margin, self.max),
            Ends::Neither => (self.min + margin, self.max - margin),
        };
        value.clamp(min, max)
    }

    /// Whether the lower end says something.
    pub fn has_min(self) -> bool {
        self.min > -MAX_BOUND
    }

    /// Whether the upper end says something.
    pub fn has_max(self) -> bool {
        self.max < MAX_BOUND
    }
}

impl fmt::Display for NumberRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { min, max, ends } = *self;
        match (self.has_min(), self.has_max(), ends) {
            (true, true, Ends::Both) => write!(f, "from {min} to {max}"),
            (true, true, Ends::Upper) => write!(f, "above {min} and at most {max}"),
            (true, true, Ends::Neither) => write!(f, "above {min} and below {max}"),
            (true, false, Ends::Both) => write!(f, "{min} or more"),
            (true, false, _) => write!(f, "above {min}"),
            (false, true, Ends::Both | Ends::Upper) => write!(f, "{max} or less"),
            (false, true, Ends::Neither) => write!(f, "below {max}"),
            (false, false, _) => f.write_str("a finite number"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn ranges_read_well_after_must_be() {
        for (range, words) in [
            (NumberRange::counts(1, 256), "from 1 to 256"),
            (NumberRange::counts(3, u32::MAX), "3 or more"),
            (NumberRange::new(-1.0, 1.0), "from -1 to 1"),
            (NumberRange::above(0.0, 180.0), "above 0 and at most 180"),
            (NumberRange::between(0.0, 1.0), "above 0 and below 1"),
            (NumberRange::NOT_NEGATIVE, "0 or more"),
            (NumberRange::POSITIVE, "above 0"),
            (NumberRange::ANY, "a finite number"),
        ] {
            assert_eq!(range.to_string(), words);
        }
    }

    #[test]
    fn what_is_not_finite_is_in_no_range() {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(!NumberRange::ANY.contains(value));
            assert!(!NumberRange::POSITIVE.contains(value));
        }
        assert!(!NumberRange::POSITIVE.contains(0.0) && NumberRange::NOT_NEGATIVE.contains(0.0));
    }

    proptest! {
        #[test]
        fn the_nearest_number_is_in_the_range(value in -1e6..1e6f64, kind in 0..5usize) {
            let range = [
                NumberRange::new(-1.0, 1.0),
                NumberRange::above(0.0, 180.0),
                NumberRange::between(0.0, 1.0),
                NumberRange::POSITIVE,
                NumberRange::counts(1, 1000),
            ][kind];
            let nearest = range.nearest(value);
            prop_assert!(range.contains(nearest), "{value}: {nearest} is not {range}");
            let is_inside = range.contains(value) && range.ends == Ends::Both;
            prop_assert!(!is_inside || nearest == value);
        }
    }
}
