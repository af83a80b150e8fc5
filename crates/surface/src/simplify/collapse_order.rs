//! In which order edges collapse.

use super::Work;
use super::queue::Queue;
use crate::SurfaceError;
use crate::pace::Pace;
use halfedge::NONE;
use std::ops::Range;

/// How many edges come out of the queue between two questions whether to go on.
const ASK: usize = 4096;
/// How many triangles are worked on at a time.
const BLOCK: usize = 1 << 13;

/// Collapses until this many triangles are left, or none can.
pub(super) fn to(work: &mut Work<'_>, wanted: usize, pace: &mut Pace<'_, '_>) -> Result<(), SurfaceError> {
    let start = work.tri.faces;
    if start <= wanted {
        return Ok(());
    }
    Run { work, start, wanted, steps: 0, pace }.run()
}

struct Run<'r, 'w, 'p, 'q, 's> {
    work: &'r mut Work<'w>,
    start: usize,
    wanted: usize,
    steps: usize,
    pace: &'p mut Pace<'q, 's>,
}

impl Run<'_, '_, '_, '_, '_> {
    fn run(&mut self) -> Result<(), SurfaceError> {
        self.in_blocks()?;
        if self.work.limit.is_some() {
            let gone = self.gone();
            self.work.measure(&mut self.pace.part(gone, gone))?;
        }
        self.work.queue.ceiling = u16::MAX;
        let mut before = usize::MAX;
        // What was refused may be possible when its surroundings have changed.
        while self.work.tri.faces > self.wanted && self.work.tri.faces < before {
            before = self.work.tri.faces;
            for block in self.blocks() {
                self.work.fill(block);
                self.ask()?;
            }
            self.drain(self.wanted)?;
        }
        Ok(())
    }

    /// Collapses what costs least block by block of the triangles, which lie in order along a curve
    /// through space: what belongs to a block fits the processor's cache, the whole does not. In each
    /// round all blocks go up to the same cost, the median of the edges there are, so that together they
    /// keep to the order of cost but for what touches over a block's rim. The last third of the triangles
    /// left goes strictly by cost.
    fn in_blocks(&mut self) -> Result<(), SurfaceError> {
        let enough = self.wanted.saturating_add(self.wanted / 2);
        let close = enough.saturating_add(enough / 8).max(4 * BLOCK);
        let mut before = usize::MAX;
        // Where a round does little, collapses are refused: no use in going round again.
        while self.work.tri.faces > close && self.work.tri.faces < before - before / 32 {
            before = self.work.tri.faces;
            let share = (1.0 - enough as f64 / before as f64).min(0.5);
            self.work.queue.ceiling = self.work.rank_above(share);
            for block in self.blocks() {
                self.work.fill(block);
                self.ask()?;
                self.drain(enough)?;
            }
        }
        Ok(())
    }

    /// The half-edges, so many triangles at a time.
    fn blocks(&self) -> impl Iterator<Item = Range<u32>> + use<> {
        let end = self.work.tri.v.len() as u32;
        (0..end).step_by(3 * BLOCK).map(move |first| first..end.min(first + 3 * BLOCK as u32))
    }

    /// The share of the triangles to go that have.
    fn gone(&self) -> f32 {
        (self.start - self.work.tri.faces) as f32 / (self.start - self.wanted) as f32
    }

    fn ask(&mut self) -> Result<(), SurfaceError> {
        let gone = self.gone();
        self.pace.at(gone)
    }

    /// Collapses what is in the queue until this many triangles are left.
    fn drain(&mut self, enough: usize) -> Result<(), SurfaceError> {
        while self.work.tri.faces > enough
            && let Some((h, rank)) = self.work.queue.pop()
        {
            self.steps += 1;
            if self.steps.is_multiple_of(ASK) {
                self.ask()?;
            }
            let work = &mut *self.work;
            // With one triangle to go only an edge that has one triangle will do.
            if work.tri.faces == self.wanted + 1 && work.tri.opp(h) != NONE {
                continue;
            }
            let Some(place) = work.place(h) else { continue };
            let rank_now = Queue::rank(place.cost);
            if rank_now > rank {
                // It has come to cost more since it was put in: it waits for its turn.
                work.queue.put(h, rank_now);
            } else if !work.try_collapse(h, place.at) {
                work.refused[work.tri.from(h) as usize] = true;
                work.refused[work.tri.to(h) as usize] = true;
            }
        }
        Ok(())
    }
}

impl Work<'_> {
    /// Prices the edges of these half-edges.
    fn fill(&mut self, halfedges: Range<u32>) {
        for h in halfedges {
            if self.tri.is_alive(h) && self.tri.edge(h) == h {
                self.price(h);
            }
        }
    }

    fn price(&mut self, h: u32) {
        match self.place(h) {
            Some(place) => self.queue.put(h, Queue::rank(place.cost)),
            None => self.queue.remove(h),
        }
    }

    /// Prices an edge that is not in the queue. One that is there keeps its rank: what it costs can only
    /// have grown with the quadrics of its ends, and shows when it comes out.
    #[inline]
    pub(super) fn put_back(&mut self, edge: u32) {
        if self.queue.rank_of(edge).is_none() {
            self.price(edge);
        }
    }

    /// The rank that this share of the edges is below, from some of them.
    fn rank_above(&self, share: f64) -> u16 {
        let mut ranks: Vec<u16> = (0..self.tri.v.len() as u32)
            .step_by(61)
            .filter(|&h| self.tri.is_alive(h))
            .filter_map(|h| self.place(h))
            .map(|place| Queue::rank(place.cost))
            .collect();
        let at = (ranks.len() as f64 * share) as usize;
        if at < ranks.len() { *ranks.select_nth_unstable(at).1 } else { u16::MAX }
    }
}
