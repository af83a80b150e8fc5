//! Sets of ids: of a few as of much of a mesh.

use halfedge::geometry::BitSet;
use std::collections::BTreeSet;

/// From so many ids on, a bit for each id of the mesh takes less time.
const MANY: usize = 1024;

/// Ids, each once. Adding one costs O(1), for few ids whatever their size.
#[derive(Default)]
pub(crate) struct IdSet {
    few: BTreeSet<usize>,
    many: BitSet,
}

impl IdSet {
    pub fn insert(&mut self, id: usize) {
        if self.many.is_empty() {
            self.few.insert(id);
            if self.few.len() >= MANY {
                for id in std::mem::take(&mut self.few) {
                    self.many.insert(id);
                }
            }
        } else {
            self.many.insert(id);
        }
    }

    pub fn len(&self) -> usize {
        if self.many.is_empty() { self.few.len() } else { self.many.len() }
    }

    /// The ids in order.
    pub fn iter(&self) -> impl Iterator<Item = usize> + '_ {
        self.few.iter().copied().chain(self.many.iter())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_and_many_ids_are_each_there_once_in_order() {
        for count in [0, 1, MANY - 1, MANY, MANY + 1, 3 * MANY] {
            let mut set = IdSet::default();
            for i in 0..2 * count {
                set.insert(i * 7919 % (2 * count) / 2 * 3);
            }
            let ids: Vec<usize> = set.iter().collect();
            assert_eq!(set.len(), count);
            assert_eq!(ids, (0..count).map(|i| i * 3).collect::<Vec<_>>());
        }
    }
}
