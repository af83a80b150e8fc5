//! Improving the worst triangles one by one.
//!
//! Iterations of splitting, merging, flipping and relaxing make nearly all triangles good, but leave a few bad
//! ones. For each of these, the change (a flip, a merge or a move of a corner) is made that improves the worst
//! triangle it affects most (as in Freitag and Ollivier-Gooch: Tetrahedral mesh improvement using swapping and
//! smoothing, 1997). No triangle becomes worse than the worst one before.

use super::changes::Merge;
use super::work::{Work, quality};
use crate::SurfaceError;
use crate::pace::Pace;
use crate::trimesh::Role;
use glam::DVec3;
use halfedge::NONE;

/// The quality of good triangles, whose smallest angle is 36 degrees: its squared sine.
const GOOD_QUALITY: f64 = 0.345;
/// Below this quality (30 degrees) curves may be divided unevenly to improve a triangle.
const UNEVEN_CURVE_QUALITY: f64 = 0.25;
/// A change must improve the worst triangle by this factor, so that rounding causes no changes.
const MIN_IMPROVEMENT: f64 = 1.001;
/// The most rounds; each works on triangles that the last one left or changed.
const MAX_ROUNDS: u32 = 16;
/// The fractions of the way to a better position that are tried.
const STEP_FRACTIONS: [f64; 4] = [1.0, 0.5, 0.25, 0.125];
/// How much longer than the longest edge an edge may become, squared.
const MAX_STRETCH_SQUARED: f64 = 1.2;

/// A change that improves a triangle.
enum Change {
    Flip(u32),
    Merge(Merge),
    /// Move a free vertex to a position on a triangle of the input.
    Move {
        v: u32,
        to: DVec3,
        near: u32,
    },
    /// Move a vertex by a length along its curve.
    Slide {
        v: u32,
        by: f64,
    },
}

pub(super) fn polish(work: &mut Work, pace: &mut Pace<'_, '_>) -> Result<(), SurfaceError> {
    let mut bad: Vec<u32> = (0..work.tri.v.len() as u32 / 3).filter(|&f| is_bad(work, f)).collect();
    let mut following = Vec::new();
    for round in 0..MAX_ROUNDS {
        let mut part = pace.part(round as f32 / MAX_ROUNDS as f32, (round + 1) as f32 / MAX_ROUNDS as f32);
        let mut asked = 0;
        let mut changed = false;
        for (i, &f) in bad.iter().enumerate() {
            // Searching for a change takes a few microseconds.
            if i >= asked {
                part.at(i as f32 / bad.len() as f32)?;
                asked = i + 4096;
            }
            if !is_bad(work, f) {
                continue;
            }
            match best_change(work, f) {
                Some(change) => {
                    let v = apply(work, change);
                    changed = true;
                    work.tri.around(v, |out| following.push(out / 3));
                }
                None => following.push(f),
            }
        }
        if !changed {
            break;
        }
        following.sort_unstable();
        following.dedup();
        std::mem::swap(&mut bad, &mut following);
        following.clear();
    }
    Ok(())
}

fn is_bad(work: &Work, f: u32) -> bool {
    work.tri.is_alive(3 * f) && triangle_quality(work, 3 * f) < GOOD_QUALITY
}

fn triangle_quality(work: &Work, h: u32) -> f64 {
    let tri = &work.tri;
    quality(tri.at(tri.from(h)), tri.at(tri.to(h)), tri.at(tri.apex(h)))
}

fn best_change(work: &mut Work, f: u32) -> Option<Change> {
    let mut best = None;
    let mut worst = 0.0;
    let mut offer = |before: f64, after: f64, change: Change| {
        if after > before * MIN_IMPROVEMENT && after > worst {
            worst = after;
            best = Some(change);
        }
    };
    for h in 3 * f..3 * f + 3 {
        if work.can_flip(h) {
            let (before, after) = flip_quality(work, h);
            offer(before, after, Change::Flip(h));
        }
        let v = work.tri.from(h);
        match work.roles[v as usize] {
            Role::Free => {
                let before = star_quality(work, v, work.tri.at(v));
                for to in better_places(work, v) {
                    let to = to - work.tri.at(v);
                    for step in STEP_FRACTIONS {
                        let (to, near) = work.project(v, work.tri.at(v) + to * step);
                        offer(before, star_quality(work, v, to), Change::Move { v, to, near });
                    }
                }
            }
            Role::Curve => {
                let before = star_quality(work, v, work.tri.at(v));
                let [a, b] = work.kept_at(v);
                if a == NONE || b == NONE {
                    continue;
                }
                let from = work.places_from(v, a)[0];
                for edge in [a, b] {
                    let [start, end] = work.places_from(v, edge);
                    for step in &STEP_FRACTIONS[1..] {
                        let by = (end - start) * step;
                        let to = work.curve_point(a, from + by);
                        if before < UNEVEN_CURVE_QUALITY || stays_even(work, [a, b], v, to) {
                            offer(before, star_quality(work, v, to), Change::Slide { v, by });
                        }
                    }
                }
            }
            Role::Fixed => {}
        }
        for merge in work.merges_of(h) {
            let stretch = if work.is_kept(h) { 1.0 } else { MAX_STRETCH_SQUARED };
            if work.can_merge(merge, work.longest * stretch) {
                let (before, after) = merge_quality(work, merge);
                offer(before, after, Change::Merge(merge));
            }
        }
    }
    best
}

/// Makes a change; returns a vertex whose triangles are nearly all those that changed.
fn apply(work: &mut Work, change: Change) -> u32 {
    match change {
        Change::Flip(h) => {
            work.flip(h);
            work.tri.from(h)
        }
        Change::Merge(merge) => {
            let v = work.tri.from(merge.edge);
            work.merge(merge);
            v
        }
        Change::Move { v, to, near } => {
            work.tri.slide(v, to);
            work.near[v as usize] = near;
            v
        }
        Change::Slide { v, by } => {
            let edge = work.kept_at(v)[0];
            work.slide(v, by);
            let [place, _] = work.places_from(v, edge);
            work.tri.slide(v, work.curve_point(edge, place));
            v
        }
    }
}

/// Better positions of a vertex: the means of the tips of equilateral triangles on the opposite sides, once with
/// equal weights and once with larger weights for triangles that are bad now.
fn better_places(work: &Work, v: u32) -> [DVec3; 2] {
    let tri = &work.tri;
    let here = tri.at(v);
    let mut normal = DVec3::ZERO;
    tri.around(v, |out| normal += (tri.at(tri.to(out)) - here).cross(tri.at(tri.apex(out)) - here));
    let normal = normal.normalize_or_zero();
    let mut sums = [(DVec3::ZERO, 0.0f64); 2];
    tri.around(v, |out| {
        let (x, y) = (tri.at(tri.to(out)), tri.at(tri.apex(out)));
        let tip = (x + y) * 0.5 + normal.cross(y - x) * 0.866_025_403_784_438_6;
        let badness = 1.0 / (quality(here, x, y) + 0.01);
        for ((sum, weights), weight) in sums.iter_mut().zip([1.0, badness * badness]) {
            *sum += tip * weight;
            *weights += weight;
        }
    });
    sums.map(|(sum, weights)| {
        let by = sum / weights - here;
        if by.is_finite() { here + by - normal * by.dot(normal) } else { here }
    })
}

/// Whether curves stay divided evenly if a vertex slides to `at`: neither of its two edges on the curve becomes too
/// short or too long, unless it is already and improves.
fn stays_even(work: &Work, edges: [u32; 2], v: u32, at: DVec3) -> bool {
    edges.into_iter().all(|h| {
        let length = work.tri.at(work.other_end(v, h)).distance_squared(at);
        let was = work.length_squared(h);
        (length >= work.shortest || length >= was) && (length <= work.longest || length <= was)
    })
}

/// The quality of the worst triangle of a vertex if it were at `at`; negative if one turns over or becomes too
/// long.
fn star_quality(work: &Work, v: u32, at: DVec3) -> f64 {
    let tri = &work.tri;
    let here = tri.at(v);
    let limit = work.longest * MAX_STRETCH_SQUARED;
    let mut worst = f64::MAX;
    tri.around(v, |out| {
        let (x, y) = (tri.at(tri.to(out)), tri.at(tri.apex(out)));
        let old = (x - here).cross(y - here);
        let turned = (x - at).cross(y - at).dot(old) <= 0.0 && old != DVec3::ZERO;
        let stretched = [x, y].into_iter().any(|p| {
            let length = p.distance_squared(at);
            length > limit && length > p.distance_squared(here)
        });
        worst = worst.min(if turned || stretched { -1.0 } else { quality(at, x, y) });
    });
    worst
}

/// The quality of the worse of an edge's triangles before and after a flip.
fn flip_quality(work: &Work, h: u32) -> (f64, f64) {
    let tri = &work.tri;
    let across = tri.opp(h);
    let [a, b, c, d] = [tri.from(h), tri.to(h), tri.apex(h), tri.apex(across)].map(|v| tri.at(v));
    (quality(a, b, c).min(quality(b, a, d)), quality(a, d, c).min(quality(d, b, c)))
}

/// The quality of the worst triangle around an edge before and after a merge.
fn merge_quality(work: &Work, merge: Merge) -> (f64, f64) {
    let tri = &work.tri;
    let (a, b) = (tri.from(merge.edge), tri.to(merge.edge));
    let (mut before, mut after) = (f64::MAX, f64::MAX);
    for (v, other) in [(a, b), (b, a)] {
        tri.around(v, |out| {
            before = before.min(triangle_quality(work, out));
            let (x, y) = (tri.to(out), tri.apex(out));
            if x != other && y != other {
                after = after.min(quality(merge.at, tri.at(x), tri.at(y)));
            }
        });
    }
    (before, after)
}
