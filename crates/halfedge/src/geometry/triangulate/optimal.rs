//! The best of all triangulations of a polygon, by dynamic programming (Klincsek 1980).

use super::touching::area;
use glam::DVec2;

/// The most corners for which all triangulations are compared, at O(n³).
pub(super) const MAX_OPTIMAL_CORNERS: usize = 128;

/// Finds the triangulation with the least area turned the wrong way, and among those the one with the
/// shortest cuts. `polygon` lists indices of corners in `flat`. Returns the ears in the order of cutting,
/// without the last triangle; none if `allowed` forbids every triangulation.
pub(super) fn find_optimal_triangles(
    flat: &[DVec2],
    polygon: &[usize],
    allowed: impl Fn(usize, usize) -> bool,
) -> Option<Vec<[usize; 3]>> {
    let n = polygon.len();
    let at = |i: usize| flat[polygon[i]];
    let scale: f64 = (0..n).map(|i| at(i).distance_squared(at((i + 1) % n))).sum();
    // cost[i * n + j] is the cost of the part from corner i to corner j, and the third corner of the
    // triangle at its cut.
    let mut cost = vec![(f64::INFINITY, 0); n * n];
    for i in 0..n - 1 {
        cost[i * n + i + 1] = (0.0, 0);
    }
    for span in 2..n {
        for i in 0..n - span {
            let j = i + span;
            let is_cut = span < n - 1;
            if is_cut && !allowed(polygon[i], polygon[j]) {
                continue;
            }
            let length = if is_cut { at(i).distance_squared(at(j)) } else { 0.0 };
            for k in i + 1..j {
                let turned = area(at(i), at(k), at(j));
                let wrong = if turned > 0.0 { 0.0 } else { (1e-9 * scale - turned) * 1e6 };
                let total = cost[i * n + k].0 + cost[k * n + j].0 + wrong + length;
                if total < cost[i * n + j].0 {
                    cost[i * n + j] = (total, k);
                }
            }
        }
    }
    if !cost[n - 1].0.is_finite() {
        return None;
    }
    // Inner parts first, so that each triangle is an ear of what is left. The last triangle is not cut off.
    let mut ears = Vec::with_capacity(n);
    let mut stack = vec![(0, n - 1)];
    while let Some((i, j)) = stack.pop() {
        if j - i >= 2 {
            let k = cost[i * n + j].1;
            ears.push([polygon[i], polygon[k], polygon[j]]);
            stack.extend([(i, k), (k, j)]);
        }
    }
    ears.reverse();
    ears.pop();
    Some(ears)
}
