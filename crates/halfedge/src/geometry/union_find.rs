//! Disjoint sets of ids (union-find).

/// Disjoint sets of the numbers from 0 up. Each set is identified by its smallest number, so that the
/// result doesn't depend on the order in which sets are joined.
///
/// R. Tarjan, "Efficiency of a good but not linear set union algorithm", 1975, with path halving.
/// Operations cost O(log n) amortised, and nearly O(1) if neighbouring numbers are joined.
#[derive(Clone, Debug, Default)]
pub struct UnionFind {
    /// Per number: another member of its set, nearer to the smallest.
    parent: Vec<u32>,
}

impl UnionFind {
    /// As many sets as numbers, each with one member.
    pub fn new(count: usize) -> Self {
        Self { parent: (0..count as u32).collect() }
    }

    /// The number of numbers in all sets.
    pub fn len(&self) -> usize {
        self.parent.len()
    }

    /// Whether there are no numbers.
    pub fn is_empty(&self) -> bool {
        self.parent.is_empty()
    }

    /// The smallest number in the set of this one, which must be less than [`UnionFind::len`].
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

    /// Joins two sets; returns whether they were different. The numbers must be less than
    /// [`UnionFind::len`].
    #[inline]
    pub fn union(&mut self, a: u32, b: u32) -> bool {
        // Most numbers are one step from the smallest of their set.
        let (a, b) = (self.parent[a as usize], self.parent[b as usize]);
        if a == b {
            return false;
        }
        let (a, b) = (self.find(a), self.find(b));
        self.parent[a.max(b) as usize] = a.min(b);
        a != b
    }
}
