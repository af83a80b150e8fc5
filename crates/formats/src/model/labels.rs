//! Labelled columns: a number per face, each of which stands for a name.

use halfedge::attribute::{Column, Key};
use halfedge::{Element, Mesh, NONE, keys};
use std::collections::HashMap;

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

    /// All names, in order.
    pub(crate) fn iter(&self) -> impl Iterator<Item = &str> {
        self.names.iter().map(String::as_str)
    }

    /// [`labelled`] with these names.
    pub(crate) fn column(&self, key: Key<u32>, values: Vec<u32>) -> Column {
        labelled(key, values, &self.names)
    }
}

/// A labelled column of `values`, which are numbers of `names` or [`NONE`]. Unused names are left out, and
/// the others are numbered in order of first use.
pub(crate) fn labelled(key: Key<u32>, mut values: Vec<u32>, names: &[String]) -> Column {
    let mut labels = Vec::new();
    let mut renumbered = vec![NONE; names.len()];
    for value in &mut values {
        let Some((number, name)) = renumbered.get_mut(*value as usize).zip(names.get(*value as usize)) else {
            *value = NONE;
            continue;
        };
        if *number == NONE {
            *number = labels.len() as u32;
            labels.push(name.clone());
        }
        *value = *number;
    }
    Column { labels, ..Column::with_values(key, values) }
}

/// Removes labels that no face uses and numbers the others in order of first use. Called after faces were
/// removed, so that the mesh is the same after it was written and read.
pub(crate) fn tidy_labels(mesh: &mut Mesh) {
    for key in [keys::FACE_GROUP, keys::FACE_MATERIAL] {
        let Some(column) = mesh.column(Element::Face, key.name) else { continue };
        let Some(values) = mesh.attribute(key) else { continue };
        let tidy = labelled(key, values.to_vec(), &column.labels);
        mesh.insert_column(Element::Face, tidy);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
