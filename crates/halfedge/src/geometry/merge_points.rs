//! Merging points that are close to each other.

use crate::NONE;
use glam::{DVec3, I64Vec3, Vec3};
use std::ops::Range;

/// The bounding box is divided into at most this many cells per axis, so that a cell's coordinate takes 42
/// bits.
const MAX_CELLS_PER_AXIS: u64 = 1 << 40;

/// Merges points within a distance of each other, some at a time: first call [`PointMerger::add`] for all
/// of them in order, then [`PointMerger::finish`].
///
/// Each point is merged into the nearest kept point before it, if there is one within the distance (the
/// earlier of two at the same distance); otherwise it is kept. So no point moves farther than the distance,
/// and the result depends only on the points and their order. A point that isn't finite is kept by itself.
/// Costs O(n log n) whatever the distance: kept points are farther apart than the distance, so few fit into
/// a cell of that size.
#[derive(Debug)]
pub struct PointMerger<'a> {
    points: &'a [Vec3],
    distance: f64,
    origin: DVec3,
    cell_size: f64,
    /// The keys of the cells that contain points, in ascending order.
    cells: Vec<u128>,
    /// Per cell: its last kept point.
    last: Vec<u32>,
    /// Per point: the previous kept point in its cell.
    before: Vec<u32>,
    /// Per point: the point that it is merged into.
    into: Vec<u32>,
}

/// The result of a [`PointMerger`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MergedPoints {
    /// The kept points, in ascending order.
    pub kept: Vec<u32>,
    /// Per point: its new number, the index in `kept` of the point that it is or is merged into.
    pub number: Vec<u32>,
}

impl<'a> PointMerger<'a> {
    /// Prepares merging points within a distance of 0 or more; 0 merges points at the same position.
    pub fn new(points: &'a [Vec3], distance: f64) -> Self {
        let finite = || points.iter().copied().filter(|p| p.is_finite());
        let low = finite().fold(Vec3::INFINITY, Vec3::min).as_dvec3();
        let high = finite().fold(Vec3::NEG_INFINITY, Vec3::max).as_dvec3();
        let diagonal = if low.x <= high.x { (high - low).length() } else { 0.0 };
        // Points within the distance are in the same or a neighbouring cell.
        let cell_size = distance.max(diagonal / MAX_CELLS_PER_AXIS as f64).max(f64::MIN_POSITIVE);
        let mut merger = Self {
            points,
            distance,
            origin: low,
            cell_size,
            cells: Vec::new(),
            last: Vec::new(),
            before: vec![NONE; points.len()],
            into: (0..points.len() as u32).collect(),
        };
        let mut cells: Vec<u128> = finite().map(|p| key(merger.cell_of(p))).collect();
        cells.sort_unstable();
        cells.dedup();
        merger.last = vec![NONE; cells.len()];
        merger.cells = cells;
        merger
    }

    fn cell_of(&self, p: Vec3) -> I64Vec3 {
        ((p.as_dvec3() - self.origin) / self.cell_size).floor().as_i64vec3()
    }

    /// Processes these points; all points before them must have been added.
    pub fn add(&mut self, points: Range<usize>) {
        for v in points {
            let p = self.points[v];
            if !p.is_finite() {
                continue;
            }
            let here = self.cell_of(p);
            let mut own = 0;
            let mut nearest = (self.distance * self.distance, NONE);
            for column in 0..9 {
                // Three cells along z have neighbouring keys.
                let low = here + I64Vec3::new(column / 3 - 1, column % 3 - 1, -1);
                let first = key(low);
                let start = self.cells.partition_point(|&key| key < first);
                for (at, _) in (start..).zip(self.cells[start..].iter().take_while(|&&key| key <= first + 2))
                {
                    if self.cells[at] == key(here) {
                        own = at;
                    }
                    let mut w = self.last[at];
                    while w != NONE {
                        let squared = p.as_dvec3().distance_squared(self.points[w as usize].as_dvec3());
                        if squared < nearest.0 || (squared == nearest.0 && w < nearest.1) {
                            nearest = (squared, w);
                        }
                        w = self.before[w as usize];
                    }
                }
            }
            if nearest.1 == NONE {
                self.before[v] = std::mem::replace(&mut self.last[own], v as u32);
            } else {
                self.into[v] = nearest.1;
            }
        }
    }

    /// The result, after all points were added.
    pub fn finish(self) -> MergedPoints {
        let mut kept = Vec::new();
        let mut number = self.into;
        for v in 0..number.len() {
            // The point that this one is merged into comes earlier, so it has its number already.
            let into = number[v] as usize;
            if into == v {
                number[v] = kept.len() as u32;
                kept.push(v as u32);
            } else {
                number[v] = number[into];
            }
        }
        MergedPoints { kept, number }
    }
}

/// Merges points within a distance of each other, all at once; see [`PointMerger`].
pub fn merge_points(points: &[Vec3], distance: f64) -> MergedPoints {
    let mut merger = PointMerger::new(points, distance);
    merger.add(0..points.len());
    merger.finish()
}

/// A cell as a number that grows by 1 along z. Coordinates start at -1.
fn key(cell: I64Vec3) -> u128 {
    ((cell.x + 2) as u128) << 84 | ((cell.y + 2) as u128) << 42 | (cell.z + 2) as u128
}
