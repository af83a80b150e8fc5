//! A priority queue of edges in buckets of nearly equal cost: every step costs O(1).
//!
//! Costs within 0.4 percent of each other share a bucket and come out first in, first out. Their order
//! doesn't matter to the result's quality, and a heap's log n cache misses each would.

use halfedge::NONE;

/// How many buckets there are: a float's exponent and eight more bits.
const BUCKETS: usize = 1 << 16;

pub(super) struct Queue {
    /// Per bucket: its first edge.
    head: Vec<u32>,
    /// Per edge: the next and previous of its bucket's ring.
    next: Vec<u32>,
    prev: Vec<u32>,
    /// Per edge: its bucket; meaningless where `next` is none.
    bucket: Vec<u16>,
    /// Which buckets have edges, and which words of that have bits.
    filled: Vec<u64>,
    filled_words: [u64; BUCKETS / 4096],
}

impl Queue {
    /// An empty queue for edges below `edges`.
    pub fn new(edges: usize) -> Self {
        Self {
            head: vec![NONE; BUCKETS],
            next: vec![NONE; edges],
            prev: vec![NONE; edges],
            bucket: vec![0; edges],
            filled: vec![0; BUCKETS / 64],
            filled_words: [0; BUCKETS / 4096],
        }
    }

    /// Puts an edge in, or moves it to its new cost, which is not negative.
    pub fn put(&mut self, edge: u32, cost: f64) {
        self.remove(edge);
        // The bits of positive floats sort as the floats do.
        let bucket = (cost as f32).to_bits() >> 15;
        let bucket = (bucket as usize).min(BUCKETS - 1);
        self.bucket[edge as usize] = bucket as u16;
        let first = self.head[bucket];
        if first == NONE {
            self.head[bucket] = edge;
            self.next[edge as usize] = edge;
            self.prev[edge as usize] = edge;
            self.filled[bucket / 64] |= 1 << (bucket % 64);
            self.filled_words[bucket / 4096] |= 1 << (bucket / 64 % 64);
        } else {
            let last = self.prev[first as usize];
            self.next[last as usize] = edge;
            self.prev[edge as usize] = last;
            self.next[edge as usize] = first;
            self.prev[first as usize] = edge;
        }
    }

    /// Takes an edge out, if it is in.
    pub fn remove(&mut self, edge: u32) {
        let after = self.next[edge as usize];
        if after == NONE {
            return;
        }
        let bucket = self.bucket[edge as usize] as usize;
        let before = self.prev[edge as usize];
        if after == edge {
            self.head[bucket] = NONE;
            self.filled[bucket / 64] &= !(1 << (bucket % 64));
            if self.filled[bucket / 64] == 0 {
                self.filled_words[bucket / 4096] &= !(1 << (bucket / 64 % 64));
            }
        } else {
            self.next[before as usize] = after;
            self.prev[after as usize] = before;
            if self.head[bucket] == edge {
                self.head[bucket] = after;
            }
        }
        self.next[edge as usize] = NONE;
    }

    /// Takes out the edge of least cost.
    pub fn pop(&mut self) -> Option<u32> {
        let high = self.filled_words.iter().position(|&word| word != 0)?;
        let word = high * 64 + self.filled_words[high].trailing_zeros() as usize;
        let bucket = word * 64 + self.filled[word].trailing_zeros() as usize;
        let edge = self.head[bucket];
        self.remove(edge);
        Some(edge)
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
                    queue.put(edge as u32, cost);
                    held[edge] = Some(cost);
                }
            }
            let mut before = 0.0;
            while let Some(edge) = queue.pop() {
                let cost = held[edge as usize].take().expect("put in and not removed");
                prop_assert!(cost >= before * 0.996, "{} after {}", cost, before);
                before = f64::max(before, cost);
            }
            prop_assert!(held.iter().all(Option::is_none));
        }
    }
}
