//! A set of ids as bits.

/// A set of small numbers, with one bit for each number up to the largest: 3 million half-edges take 375
/// kB. It grows as needed and knows its size. Operations cost O(1) unless stated otherwise.
#[derive(Clone, Debug, Default)]
pub struct BitSet {
    words: Vec<u64>,
    count: usize,
}

impl PartialEq for BitSet {
    fn eq(&self, other: &Self) -> bool {
        // Words past the end of the shorter set must be zero; comparing the counts ensures that.
        self.count == other.count && self.words.iter().zip(&other.words).all(|(a, b)| a == b)
    }
}

impl Eq for BitSet {}

impl FromIterator<usize> for BitSet {
    fn from_iter<I: IntoIterator<Item = usize>>(indices: I) -> Self {
        let mut set = Self::new();
        for index in indices {
            set.insert(index);
        }
        set
    }
}

impl BitSet {
    /// An empty set.
    pub const fn new() -> Self {
        Self { words: Vec::new(), count: 0 }
    }

    /// All numbers below this one.
    pub fn up_to(end: usize) -> Self {
        let mut words = vec![!0; end / 64];
        if !end.is_multiple_of(64) {
            words.push((1 << (end % 64)) - 1);
        }
        Self { words, count: end }
    }

    /// Whether a number is in the set.
    #[inline]
    pub fn contains(&self, index: usize) -> bool {
        self.words.get(index / 64).is_some_and(|word| word >> (index % 64) & 1 == 1)
    }

    /// Adds a number; returns whether it was new.
    #[inline]
    pub fn insert(&mut self, index: usize) -> bool {
        if self.contains(index) {
            return false;
        }
        if self.words.len() <= index / 64 {
            self.words.resize(index / 64 + 1, 0);
        }
        self.words[index / 64] |= 1 << (index % 64);
        self.count += 1;
        true
    }

    /// Removes a number; returns whether it was in the set.
    #[inline]
    pub fn remove(&mut self, index: usize) -> bool {
        let was_there = self.contains(index);
        if was_there {
            self.words[index / 64] &= !(1 << (index % 64));
            self.count -= 1;
        }
        was_there
    }

    /// The number of members.
    #[inline]
    pub fn len(&self) -> usize {
        self.count
    }

    /// Whether the set is empty.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// The numbers in ascending order. Costs O(largest / 64 + count) in all.
    pub fn iter(&self) -> impl Iterator<Item = usize> + '_ {
        self.iter_from(0)
    }

    /// The numbers from this one on, in ascending order. Costs O((largest - start) / 64 + count) in all.
    pub fn iter_from(&self, start: usize) -> impl Iterator<Item = usize> + '_ {
        self.words.iter().enumerate().skip(start / 64).flat_map(move |(at, &word)| {
            let mut left = if at == start / 64 { word & (!0 << (start % 64)) } else { word };
            std::iter::from_fn(move || {
                let bit = (left != 0).then(|| left.trailing_zeros() as usize)?;
                left &= left - 1;
                Some(at * 64 + bit)
            })
        })
    }

    /// Adds the numbers of another set. Costs O(largest / 64), as do the other operations on two sets.
    pub fn union_with(&mut self, other: &Self) {
        self.combine(other, |a, b| a | b);
    }

    /// Keeps the numbers that are in another set too.
    pub fn intersect_with(&mut self, other: &Self) {
        self.combine(other, |a, b| a & b);
    }

    /// Removes the numbers of another set.
    pub fn subtract(&mut self, other: &Self) {
        self.combine(other, |a, b| a & !b);
    }

    /// Removes the numbers of another set that are in this one, and adds its other numbers.
    pub fn toggle_with(&mut self, other: &Self) {
        self.combine(other, |a, b| a ^ b);
    }

    fn combine(&mut self, other: &Self, combined: impl Fn(u64, u64) -> u64) {
        if self.words.len() < other.words.len() {
            self.words.resize(other.words.len(), 0);
        }
        self.count = 0;
        for (at, word) in self.words.iter_mut().enumerate() {
            *word = combined(*word, other.words.get(at).copied().unwrap_or(0));
            self.count += word.count_ones() as usize;
        }
    }

    /// The number of members below this number. Costs O(index / 64).
    pub fn rank(&self, index: usize) -> usize {
        let whole = self.words.iter().take(index / 64).map(|word| word.count_ones() as usize).sum::<usize>();
        let part =
            self.words.get(index / 64).map_or(0, |word| (word & ((1 << (index % 64)) - 1)).count_ones());
        whole + part as usize
    }

    /// The number of members from `start` on and below `end`. Costs O((end - start) / 64).
    pub fn count_in(&self, start: usize, end: usize) -> usize {
        if start >= end {
            return 0;
        }
        let (first, last) = (start / 64, (end - 1) / 64);
        let words = self.words.iter().enumerate().take(last + 1).skip(first);
        let count = |(at, &word): (usize, &u64)| {
            let from = if at == first { !0 << (start % 64) } else { !0 };
            let to = if at == last { !0 >> (63 - (end - 1) % 64) } else { !0 };
            (word & from & to).count_ones() as usize
        };
        words.map(count).sum()
    }

    /// The member at this place in ascending order: the inverse of [`BitSet::rank`]. Costs O(largest / 64).
    pub fn nth(&self, rank: usize) -> Option<usize> {
        let mut left = rank;
        for (at, &word) in self.words.iter().enumerate() {
            let here = word.count_ones() as usize;
            if left < here {
                let without_lower = (0..left).fold(word, |word, _| word & (word - 1));
                return Some(at * 64 + without_lower.trailing_zeros() as usize);
            }
            left -= here;
        }
        None
    }

    /// The bits: number `n` is bit `n % 64` of word `n / 64`.
    pub fn words(&self) -> &[u64] {
        &self.words
    }

    /// The set with these bits: see [`BitSet::words`].
    pub fn from_words(words: Vec<u64>) -> Self {
        let count = words.iter().map(|word| word.count_ones() as usize).sum();
        Self { words, count }
    }

    /// The largest number. Costs O(largest ever / 64).
    pub fn largest(&self) -> Option<usize> {
        let at = self.words.iter().rposition(|&word| word != 0)?;
        Some(at * 64 + 63 - self.words[at].leading_zeros() as usize)
    }

    /// Heap bytes in use.
    pub fn bytes(&self) -> usize {
        self.words.len() * 8
    }
}
