//! A set of ids in which the place of a member and the member at a place are found quickly.

use halfedge::geometry::BitSet;

/// Ids whose smaller members are counted beforehand: a multiple of 64.
const IDS_PER_BLOCK: usize = 512;

/// A set of ids in ascending order. Finding a place or a member costs O(log size).
#[derive(Clone, Debug, Default)]
pub struct RankedSet {
    set: BitSet,
    /// The number of members before each block of ids.
    before: Vec<usize>,
}

impl RankedSet {
    /// Counts the members of a set. Costs O(largest id / 64).
    pub fn new(set: BitSet) -> Self {
        let mut ranked = Self { set, before: Vec::new() };
        ranked.count();
        ranked
    }

    /// Adds or removes ids: `change` returns whether it did. Counts the members again if so.
    pub fn change(&mut self, change: impl FnOnce(&mut BitSet) -> bool) {
        if change(&mut self.set) {
            self.count();
        }
    }

    fn count(&mut self) {
        let end = self.set.largest().map_or(0, |largest| largest + 1);
        let mut sum = 0;
        self.before.clear();
        self.before.extend((0..end).step_by(IDS_PER_BLOCK).map(|start| {
            let before = sum;
            sum += self.set.count_in(start, start + IDS_PER_BLOCK);
            before
        }));
    }

    /// The number of members.
    pub fn len(&self) -> usize {
        self.set.len()
    }

    /// Whether an id is a member.
    pub fn contains(&self, id: usize) -> bool {
        self.set.contains(id)
    }

    /// The number of members below an id.
    pub fn rank(&self, id: usize) -> usize {
        let block = id / IDS_PER_BLOCK;
        match self.before.get(block) {
            Some(before) => before + self.set.count_in(block * IDS_PER_BLOCK, id),
            None => self.len(),
        }
    }

    /// The member with so many members below it.
    pub fn nth(&self, rank: usize) -> Option<usize> {
        let block = self.before.partition_point(|before| *before <= rank).checked_sub(1)?;
        let before = self.before.get(block)?;
        self.set.iter_from(block * IDS_PER_BLOCK).nth(rank - before)
    }
}

#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    proptest! {
        #[test]
        fn places_and_members_are_those_of_a_sorted_list(
            ids in prop::collection::btree_set(0usize..5000, 0..600),
            changed in prop::collection::btree_set(0usize..6000, 0..50),
        ) {
            let mut ranked = RankedSet::new(ids.iter().copied().collect());
            let mut model: BTreeSet<usize> = ids;
            for &id in &changed {
                if !model.remove(&id) {
                    model.insert(id);
                }
            }
            ranked.change(|set| {
                set.toggle_with(&changed.iter().copied().collect());
                true
            });
            prop_assert_eq!(ranked.len(), model.len());
            for (rank, &id) in model.iter().enumerate() {
                prop_assert_eq!((ranked.rank(id), ranked.nth(rank)), (rank, Some(id)));
            }
            for id in [0, 511, 512, 513, 5120, 7000] {
                prop_assert_eq!(ranked.rank(id), model.range(..id).count());
                prop_assert_eq!(ranked.contains(id), model.contains(&id));
            }
            prop_assert_eq!(ranked.nth(model.len()), None);
        }
    }
}
