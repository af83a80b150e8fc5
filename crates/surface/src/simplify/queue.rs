//! A priority queue of edges in buckets of nearly equal cost: each operation costs O(1).
//!
//! Costs within 0.4 percent of each other share a bucket and come out first in, first out. Their order doesn't
//! matter for the quality of the result, but the log n cache misses of a heap would matter for the time. An
//! edge whose cost changes is queued again, and skipped where it was.

use crate::trimesh::make_room;

/// The number of buckets: a float's exponent and eight more bits select one.
const BUCKET_COUNT: usize = 1 << 16;
/// Buckets whose memory is allocated together.
const BUCKETS_PER_PAGE: usize = 64;
/// Buckets with this many edges no longer grow by doubling.
const LARGE_BUCKET_EDGES: usize = 256;
/// The rank of edges that aren't queued. No cost has it except NaN.
const NOT_QUEUED: u16 = u16::MAX;

#[derive(Clone, Default)]
struct Bucket {
    edges: Vec<u32>,
    /// The number of edges that came out.
    gone: usize,
}

pub(super) struct Queue {
    /// The buckets of each page; none if all are empty.
    pages: Vec<Vec<Bucket>>,
    /// Per edge: its bucket.
    place: Vec<u16>,
    /// Per page a bit for each bucket with edges, and a bit for each page with such buckets.
    filled: Vec<u64>,
    filled_words: [u64; BUCKET_COUNT / BUCKETS_PER_PAGE / 64],
    /// Edges of a higher rank aren't queued.
    pub ceiling: u16,
}

impl Queue {
    /// An empty queue for edges below `edges`.
    pub fn new(edges: usize) -> Self {
        let mut queue = Self {
            pages: vec![Vec::new(); BUCKET_COUNT / BUCKETS_PER_PAGE],
            place: Vec::new(),
            filled: vec![0; BUCKET_COUNT / BUCKETS_PER_PAGE],
            filled_words: [0; BUCKET_COUNT / BUCKETS_PER_PAGE / 64],
            ceiling: 0,
        };
        queue.restart(edges);
        queue
    }

    /// Empties the queue, for edges below `edges`.
    pub fn restart(&mut self, edges: usize) {
        self.pages.fill(Vec::new());
        self.filled.fill(0);
        self.filled_words.fill(0);
        self.place = vec![NOT_QUEUED; edges];
        self.ceiling = u16::MAX;
    }

    /// The rank of a cost, which isn't negative. Ranks have the order of costs.
    #[inline]
    pub fn rank(cost: f64) -> u16 {
        // The bits of positive floats sort as the floats do.
        (((cost as f32).to_bits() >> 15) as u16).min(NOT_QUEUED - 1)
    }

    /// The rank of an edge, if it is queued.
    #[inline]
    pub fn rank_of(&self, edge: u32) -> Option<u16> {
        Some(self.place[edge as usize]).filter(|&rank| rank != NOT_QUEUED)
    }

    /// Queues an edge, or moves it to a new rank.
    pub fn put(&mut self, edge: u32, bucket: u16) {
        if self.place[edge as usize] == bucket {
            return;
        }
        if bucket > self.ceiling {
            self.place[edge as usize] = NOT_QUEUED;
            return;
        }
        self.place[edge as usize] = bucket;
        let (page, bucket) = (bucket as usize / BUCKETS_PER_PAGE, bucket as usize % BUCKETS_PER_PAGE);
        let buckets = &mut self.pages[page];
        if buckets.is_empty() {
            *buckets = vec![Bucket::default(); BUCKETS_PER_PAGE];
        }
        let edges = &mut buckets[bucket].edges;
        if edges.len() >= LARGE_BUCKET_EDGES {
            make_room(edges, 1);
        }
        edges.push(edge);
        self.filled[page] |= 1 << bucket;
        self.filled_words[page / 64] |= 1 << (page % 64);
    }

    /// Removes an edge, if it is queued.
    pub fn remove(&mut self, edge: u32) {
        self.place[edge as usize] = NOT_QUEUED;
    }

    /// Removes an edge of the least rank; returns both.
    pub fn pop(&mut self) -> Option<(u32, u16)> {
        loop {
            let high = self.filled_words.iter().position(|&word| word != 0)?;
            let page = high * 64 + self.filled_words[high].trailing_zeros() as usize;
            let place = self.filled[page].trailing_zeros() as usize;
            let (at, bucket) = (page * BUCKETS_PER_PAGE + place, &mut self.pages[page][place]);
            while let Some(&edge) = bucket.edges.get(bucket.gone) {
                bucket.gone += 1;
                if self.place[edge as usize] == at as u16 {
                    self.place[edge as usize] = NOT_QUEUED;
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
