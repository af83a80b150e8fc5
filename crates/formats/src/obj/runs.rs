//! Statements that apply to all faces up to the next such statement: groups, materials and smoothing.

/// The values of faces, as runs of equal values.
#[derive(Default)]
pub(crate) struct Runs {
    starts: Vec<(u32, u32)>,
}

impl Runs {
    /// Starts a run of `value` at `face`.
    pub(crate) fn start(&mut self, face: usize, value: u32) {
        if self.starts.last().is_some_and(|&(at, _)| at as usize == face) {
            self.starts.pop();
        }
        self.starts.push((face as u32, value));
    }

    /// The value of each of `count` faces; `None` if all have `default`.
    pub(crate) fn expand(&self, count: usize, default: u32) -> Option<Vec<u32>> {
        let mut values = Vec::new();
        for (i, &(start, value)) in self.starts.iter().enumerate() {
            let end = self.starts.get(i + 1).map_or(count, |&(next, _)| next as usize);
            values.resize((start as usize).min(count), default);
            values.resize(end.min(count), value);
        }
        values.iter().any(|&value| value != default).then_some(values)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_end_at_the_next() {
        let mut runs = Runs::default();
        assert_eq!(runs.expand(3, 0), None);
        runs.start(1, 5);
        runs.start(2, 6);
        runs.start(2, 7);
        runs.start(9, 8);
        assert_eq!(runs.expand(4, 0), Some(vec![0, 5, 7, 7]));
        assert_eq!(runs.expand(1, 0), None);
    }
}
