//! A priority queue of edges in buckets of nearly equal cost: every step costs O(1).
//!
//! Costs within 0.4 percent of each other share a bucket and come out first in, first out. Their order
//! doesn't matter to the result's quality, and a heap's log n cache misses each would. An edge whose cost
//! changes is put in again, and passed over where it was.

use crate::trimesh::make_room;

/// How many buckets there are: a float's exponent and eight more bits.
const BUCKETS: usize = 1 << 16;
/// How many of them take memory together, once one has edges.
const PAGE: usize = 64;
/// From how many edges on a bucket no longer grows by doubling.
const LARGE: usize = 256;
/// Where edges are that are not in the queue. No cost goes there but what is not a number.
const NOWHERE: u16 = u16::MAX;

#[derive(Clone, Default)]
struct Bucket {
    edges: Vec<u32>,
    /// How many of them have come out.
    gone: usize,
}

pub(super) struct Queue {
    /// The buckets, so many at a time; none where all are empty.
    pages: Vec<Vec<Bucket>>,
    /// Per edge: its bucket.
    place: Vec<u16>,
    /// Per page: which of its buckets have edges; and which words of that have bits.
    filled: Vec<u64>,
    filled_words: [u64; BUCKETS / PAGE / 64],
    /// Edges of a rank above stay out.
    pub ceiling: u16,
}

impl Queue {
    /// An empty queue for edges below `edges`.
    pub fn new(edges: usize) -> Self {
        let mut queue = Self {
            pages: vec![Vec::new(); BUCKETS / PAGE],
            place: Vec::new(),
            filled: vec![0; BUCKETS / PAGE],
            filled_words: [0; BUCKETS / PAGE / 64],
            ceiling: 0,
        };
        queue.restart(edges);
        queue
    }

    /// Forgets all edges, and is ready for those below `edges`.
    pub fn restart(&mut self, edges: usize) {
        self.pages.fill(Vec::new());
        self.filled.fill(0);
        self.filled_words.fill(0);
        self.place = vec![NOWHERE; edges];
        self.ceiling = u16::MAX;
    }

    /// The rank of a cost, which is not negative: costs in order have ranks in order.
    #[inline]
    pub fn rank(cost: f64) -> u16 {
        // The bits of positive floats sort as the floats do.
        (((cost as f32).to_bits() >> 15) as u16).min(NOWHERE - 1)
    }

    /// The rank that an edge is in with.
    #[inline]
    pub fn rank_of(&self, edge: u32) -> Option<u16> {
        Some(self.place[edge as usize]).filter(|&rank| rank != NOWHERE)
    }

    /// Puts an edge in, or moves it to its new rank.
    pub fn put(&mut self, edge: u32, bucket: u16) {
        if self.place[edge as usize] == bucket {
            return;
        }
        if bucket > self.ceiling {
            self.place[edge as usize] = NOWHERE;
            return;
        }
        self.place[edge as usize] = bucket;
        let (page, bucket) = (bucket as usize / PAGE, bucket as usize % PAGE);
        let buckets = &mut self.pages[page];
        if buckets.is_empty() {
            *buckets = vec![Bucket::default(); PAGE];
        }
        let edges = &mut buckets[bucket].edges;
        if edges.len() >= LARGE {
            make_room(edges, 1);
        }
        edges.push(edge);
        self.filled[page] |= 1 << bucket;
        self.filled_words[page / 64] |= 1 << (page % 64);
    }

    /// Takes an edge out, if it is in.
    pub fn remove(&mut self, edge: u32) {
        self.place[edge as usize] = NOWHERE;
    }

    /// Takes out an edge of the least rank, and gives both.
    pub fn pop(&mut self) -> Option<(u32, u16)> {
        loop {
            let high = self.filled_words.iter().position(|&word| word != 0)?;
            let page = high * 64 + self.filled_words[high].trailing_zeros() as usize;
            let place = self.filled[page].trailing_zeros() as usize;
            let (at, bucket) = (page * PAGE + place, &mut self.pages[page][place]);
            while let Some(&edge) = bucket.edges.get(bucket.gone) {
                bucket.gone += 1;
                if self.place[edge as usize] == at as u16 {
                    self.place[edge as usize] = NOWHERE;
                    return Some((edge, at as u16));
                }
            }
            *bucket = Bucket::default();
            self.filled[page] &= !(1 << place);
            if self.filled[page] == 0 {
                self.pages[page] = Vec::new();
                self.filled_words[high] &= !(1 << (page % 64));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn comes_out_in_order_of_cost(costs in prop::collection::vec((0usize..50, -30f64..30.0, any::<bool>()), 0..200)) {
            let mut queue = Queue::new(50);
            let mut held = [None; 50];
            for (edge, exponent, remove) in costs {
                if remove {
                    queue.remove(edge as u32);
                    held[edge] = None;
                } else {
                    let cost = 2f64.powf(exponent);
                    queue.put(edge as u32, Queue::rank(cost));
                    held[edge] = Some(cost);
                }
            }
            let mut before = 0.0;
            while let Some((edge, _)) = queue.pop() {
                let cost = held[edge as usize].take().expect("put in and not removed");
                prop_assert!(cost >= before * 0.996, "{} after {}", cost, before);
                before = f64::max(before, cost);
            }
            prop_assert!(held.iter().all(Option::is_none));
        }
    }
}
