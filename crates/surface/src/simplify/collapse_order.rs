//! The order in which edges collapse.

use super::queue::Queue;
use super::work::Work;
use crate::SurfaceError;
use crate::pace::Pace;
use halfedge::NONE;
use std::ops::Range;

/// Edges taken from the queue between two progress reports.
const EDGES_PER_REPORT: usize = 4096;
/// Triangles in a block, which fits the processor's cache.
const TRIANGLES_PER_BLOCK: usize = 1 << 13;

/// Collapses edges until this number of triangles is left, or no edge can collapse.
pub(super) fn collapse_to_face_count(
    work: &mut Work<'_>,
    wanted: usize,
    pace: &mut Pace<'_, '_>,
) -> Result<(), SurfaceError> {
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
        self.collapse_in_blocks()?;
        if self.work.limit.is_some() {
            let done = self.fraction_done();
            self.work.begin_measuring(&mut self.pace.part(done, done))?;
        }
        self.work.queue.ceiling = u16::MAX;
        let mut before = usize::MAX;
        // A refused collapse may become possible after its surroundings change.
        while self.work.tri.faces > self.wanted && self.work.tri.faces < before {
            before = self.work.tri.faces;
            for block in self.blocks() {
                self.work.price_edges(block);
                self.report()?;
            }
            self.drain(self.wanted)?;
        }
        Ok(())
    }

    /// Collapses the cheapest edges block by block: the triangles are ordered along a space-filling curve, so that a
    /// block fits the processor's cache, which the whole mesh doesn't. In each round all blocks collapse edges up
    /// to the same cost, the median of all edges, so that together they keep the order of cost, except across the
    /// rims of blocks. The last third of the remaining triangles is collapsed strictly by cost.
    fn collapse_in_blocks(&mut self) -> Result<(), SurfaceError> {
        let enough = self.wanted.saturating_add(self.wanted / 2);
        let close = enough.saturating_add(enough / 8).max(4 * TRIANGLES_PER_BLOCK);
        let mut before = usize::MAX;
        // If a round does little, most collapses are refused: another one is of no use.
        while self.work.tri.faces > close && self.work.tri.faces < before - before / 32 {
            before = self.work.tri.faces;
            let share = (1.0 - enough as f64 / before as f64).min(0.5);
            self.work.queue.ceiling = self.work.rank_above(share);
            for block in self.blocks() {
                self.work.price_edges(block);
                self.report()?;
                self.drain(enough)?;
            }
        }
        Ok(())
    }

    /// The half-edges of each block.
    fn blocks(&self) -> impl Iterator<Item = Range<u32>> + use<> {
        let end = self.work.tri.v.len() as u32;
        (0..end)
            .step_by(3 * TRIANGLES_PER_BLOCK)
            .map(move |first| first..end.min(first + 3 * TRIANGLES_PER_BLOCK as u32))
    }

    /// The fraction of the triangles to remove that are removed.
    fn fraction_done(&self) -> f32 {
        (self.start - self.work.tri.faces) as f32 / (self.start - self.wanted) as f32
    }

    fn report(&mut self) -> Result<(), SurfaceError> {
        let done = self.fraction_done();
        self.pace.at(done)
    }

    /// Collapses edges in the queue until this number of triangles is left.
    fn drain(&mut self, enough: usize) -> Result<(), SurfaceError> {
        while self.work.tri.faces > enough
            && let Some((h, rank)) = self.work.queue.pop()
        {
            self.steps += 1;
            if self.steps.is_multiple_of(EDGES_PER_REPORT) {
                self.report()?;
            }
            let work = &mut *self.work;
            // The last triangle can only be removed by collapsing an edge with one triangle.
            if work.tri.faces == self.wanted + 1 && work.tri.opp(h) != NONE {
                continue;
            }
            let Some(target) = work.find_target(h) else { continue };
            let rank_now = Queue::rank(target.cost);
            if rank_now > rank {
                // It costs more than when it was queued: it waits for its turn.
                work.queue.put(h, rank_now);
            } else if !work.try_collapse(h, target.at) {
                work.refused[work.tri.from(h) as usize] = true;
                work.refused[work.tri.to(h) as usize] = true;
            }
        }
        Ok(())
    }
}

impl Work<'_> {
    /// Queues the edges of these half-edges at their cost.
    fn price_edges(&mut self, halfedges: Range<u32>) {
        for h in halfedges {
            if self.tri.is_alive(h) && self.tri.edge(h) == h {
                self.price_edge(h);
            }
        }
    }

    fn price_edge(&mut self, h: u32) {
        match self.find_target(h) {
            Some(target) => self.queue.put(h, Queue::rank(target.cost)),
            None => self.queue.remove(h),
        }
    }

    /// Queues an edge unless it is queued. A queued edge keeps its rank: its cost can only have grown with the
    /// quadrics of its ends, which is noticed when it comes out.
    #[inline]
    pub(super) fn requeue_edge(&mut self, edge: u32) {
        if self.queue.rank_of(edge).is_none() {
            self.price_edge(edge);
        }
    }

    /// The rank that this share of the edges is below, estimated from a sample.
    fn rank_above(&self, share: f64) -> u16 {
        let mut ranks: Vec<u16> = (0..self.tri.v.len() as u32)
            .step_by(61)
            .filter(|&h| self.tri.is_alive(h))
            .filter_map(|h| self.find_target(h))
            .map(|target| Queue::rank(target.cost))
            .collect();
        let at = (ranks.len() as f64 * share) as usize;
        if at < ranks.len() { *ranks.select_nth_unstable(at).1 } else { u16::MAX }
    }
}
