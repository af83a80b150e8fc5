//! Statements that hold for all faces until the next such statement: groups, materials, smoothing.

use crate::soup::labelled;
use halfedge::attribute::{Column, Key};
use std::collections::HashMap;

/// From which face on which value holds.
#[derive(Default)]
pub(crate) struct Runs {
    starts: Vec<(u32, u32)>,
}

impl Runs {
    /// From `face` on, `value` holds.
    pub(crate) fn start(&mut self, face: usize, value: u32) {
        if self.starts.last().is_some_and(|&(at, _)| at as usize == face) {
            self.starts.pop();
        }
        self.starts.push((face as u32, value));
    }

    /// The value of each of `count` faces, or nothing where all have `default`.
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

/// Names numbered in order of first appearance.
#[derive(Default)]
pub(crate) struct Names {
    names: Vec<String>,
    numbers: HashMap<String, u32>,
}

impl Names {
    /// The number of a name.
    pub(crate) fn number(&mut self, name: &str) -> u32 {
        if let Some(&number) = self.numbers.get(name) {
            return number;
        }
        let number = self.names.len() as u32;
        self.names.push(name.to_owned());
        self.numbers.insert(name.to_owned(), number);
        number
    }

    /// The name with this number.
    pub(crate) fn name(&self, number: u32) -> Option<&str> {
        self.names.get(number as usize).map(String::as_str)
    }
}

impl Names {
    /// [`labelled`] with these names.
    pub(crate) fn column(&self, key: Key<u32>, values: Vec<u32>) -> Column {
        labelled(key, values, &self.names)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use halfedge::{NONE, keys};

    #[test]
    fn runs_hold_until_the_next() {
        let mut runs = Runs::default();
        assert_eq!(runs.expand(3, 0), None);
        runs.start(1, 5);
        runs.start(2, 6);
        runs.start(2, 7);
        runs.start(9, 8);
        assert_eq!(runs.expand(4, 0), Some(vec![0, 5, 7, 7]));
        assert_eq!(runs.expand(1, 0), None);
    }

    #[test]
    fn labels_are_those_in_use_in_order_of_use() {
        let mut names = Names::default();
        for name in ["a", "b", "c", "a"] {
            names.number(name);
        }
        let column = names.column(keys::FACE_GROUP, vec![2, NONE, 0, 2]);
        assert_eq!(column.labels, ["c", "a"]);
        assert_eq!(
            column,
            Column {
                labels: column.labels.clone(),
                ..Column::with_values(keys::FACE_GROUP, vec![0, NONE, 1, 0])
            }
        );
    }
}
