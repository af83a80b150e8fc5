//! Sets of ids that are joined bit by bit.

/// Disjoint sets of the numbers from 0 up. Each set is known by its smallest number, so that what comes out
/// doesn't depend on the order in which sets are joined.
///
/// R. Tarjan, "Efficiency of a good but not linear set union algorithm", 1975, with path halving. Operations
/// cost O(log n) amortised, near O(1) where neighbouring numbers are joined.
#[derive(Clone, Debug, Default)]
pub struct UnionFind {
    /// Towards the smallest of each set.
    parent: Vec<u32>,
}

impl UnionFind {
    /// As many sets as there are numbers.
    pub fn new(count: usize) -> Self {
        Self { parent: (0..count as u32).collect() }
    }

    /// How many numbers there are.
    pub fn len(&self) -> usize {
        self.parent.len()
    }

    /// Whether there are no numbers.
    pub fn is_empty(&self) -> bool {
        self.parent.is_empty()
    }

    /// The smallest number of the set that this one is in. The number must be smaller than
    /// [`UnionFind::len`].
    #[inline]
    pub fn find(&mut self, mut id: u32) -> u32 {
        loop {
            let parent = self.parent[id as usize];
            if parent == id {
                return id;
            }
            let above = self.parent[parent as usize];
            self.parent[id as usize] = above;
            id = above;
        }
    }

    /// Joins two sets; whether they weren't one already. The numbers must be smaller than
    /// [`UnionFind::len`].
    #[inline]
    pub fn union(&mut self, a: u32, b: u32) -> bool {
        // Most pairs are in a set already, one step from its smallest number.
        let (a, b) = (self.parent[a as usize], self.parent[b as usize]);
        if a == b {
            return false;
        }
        let (a, b) = (self.find(a), self.find(b));
        self.parent[a.max(b) as usize] = a.min(b);
        a != b
    }
}
