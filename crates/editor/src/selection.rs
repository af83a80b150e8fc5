//! Which elements of the active object are selected.

use halfedge::geometry::BitSet;
use halfedge::{Element, Mesh};

/// A set of ids of one kind of element, and the id that was selected last.
#[derive(Clone, Debug, PartialEq)]
pub struct Selection {
    kind: Element,
    set: BitSet,
    latest: Option<u32>,
}

impl Default for Selection {
    fn default() -> Self {
        Self::new(Element::Vertex)
    }
}

impl Selection {
    /// An empty selection.
    pub fn new(kind: Element) -> Self {
        Self { kind, set: BitSet::new(), latest: None }
    }

    /// A selection of these ids, of which the last counts as selected last.
    pub fn of(kind: Element, ids: impl IntoIterator<Item = u32>) -> Self {
        let mut selection = Self::new(kind);
        for id in ids {
            selection.insert(id);
        }
        selection
    }

    /// A selection of a set of ids. The latest one is `latest` if it is in the set, else the largest.
    pub(crate) fn of_set(kind: Element, set: BitSet, latest: Option<u32>) -> Self {
        let latest = latest.filter(|&id| set.contains(id as usize));
        let latest = latest.or_else(|| set.largest().map(|id| id as u32));
        Self { kind, set, latest }
    }

    /// The kind of element.
    pub fn kind(&self) -> Element {
        self.kind
    }

    /// How many are selected.
    pub fn len(&self) -> usize {
        self.set.len()
    }

    /// Whether none is selected.
    pub fn is_empty(&self) -> bool {
        self.set.is_empty()
    }

    /// Whether the element of this kind and id is selected.
    #[inline]
    pub fn contains(&self, kind: Element, id: u32) -> bool {
        self.kind == kind && self.set.contains(id as usize)
    }

    /// The id that was selected last, if it still is.
    pub fn latest(&self) -> Option<u32> {
        self.latest
    }

    /// The ids in ascending order.
    pub fn ids(&self) -> impl Iterator<Item = u32> + '_ {
        self.set.iter().map(|id| id as u32)
    }

    /// The number of selected ids below this one: its row in a list that shows only the selection. Costs
    /// O(id / 64).
    pub fn rank(&self, id: u32) -> usize {
        self.set.rank(id as usize)
    }

    /// The selected id in this row, in ascending order: the inverse of [`Selection::rank`]. Costs O(largest
    /// id / 64).
    pub fn nth(&self, row: usize) -> Option<u32> {
        self.set.nth(row).map(|id| id as u32)
    }

    /// Heap bytes in use.
    pub fn bytes(&self) -> usize {
        self.set.bytes()
    }

    /// Whether changing another selection to this one is worth an undo step: which kind of element isn't selected is
    /// not.
    pub(crate) fn is_step_from(&self, before: &Self) -> bool {
        self != before && self.len() + before.len() > 0
    }

    /// The ids as a set.
    pub(crate) fn set(&self) -> &BitSet {
        &self.set
    }

    pub(crate) fn insert(&mut self, id: u32) {
        self.set.insert(id as usize);
        self.latest = Some(id);
    }

    /// Removes an id; the largest remaining one then counts as selected last.
    pub(crate) fn remove(&mut self, id: u32) {
        if self.set.remove(id as usize) && self.latest == Some(id) {
            self.latest = self.set.largest().map(|id| id as u32);
        }
    }

    /// Whether any id no longer exists in the mesh.
    pub(crate) fn has_gone(&self, mesh: &Mesh) -> bool {
        self.ids().any(|id| !mesh.exists(self.kind, id))
    }

    /// Drops the ids that no longer exist in the mesh.
    pub(crate) fn keep_existing(&mut self, mesh: &Mesh) {
        let gone: Vec<u32> = self.ids().filter(|&id| !mesh.exists(self.kind, id)).collect();
        for id in gone {
            self.remove(id);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    proptest! {
        #[test]
        fn behaves_like_a_set(steps in prop::collection::vec((any::<bool>(), 0u32..300), 0..200)) {
            let mut selection = Selection::new(Element::Edge);
            let mut model = BTreeSet::new();
            for (add, id) in steps {
                if add {
                    selection.insert(id);
                    model.insert(id);
                    prop_assert_eq!(selection.latest(), Some(id));
                } else {
                    selection.remove(id);
                    model.remove(&id);
                }
                prop_assert_eq!(selection.len(), model.len());
                prop_assert!(selection.latest().is_none_or(|id| model.contains(&id)));
                prop_assert_eq!(selection.latest().is_none(), model.is_empty());
            }
            prop_assert_eq!(selection.ids().collect::<Vec<_>>(), model.iter().copied().collect::<Vec<_>>());
            for (row, &id) in model.iter().enumerate() {
                prop_assert_eq!(selection.rank(id), row);
                prop_assert_eq!(selection.nth(row), Some(id));
            }
            prop_assert_eq!(selection.nth(model.len()), None);
        }
    }

    #[test]
    fn equality_ignores_capacity() {
        let mut a = Selection::of(Element::Face, [3, 900]);
        a.remove(900);
        assert_eq!(a, Selection::of(Element::Face, [3]));
        assert_ne!(a, Selection::of(Element::Face, [4]));
        assert_ne!(a, Selection::of(Element::Edge, [3]));
        assert!(!a.contains(Element::Edge, 3));
    }
}
