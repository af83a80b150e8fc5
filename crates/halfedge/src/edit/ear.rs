//! Ears: which corners of a polygon to cut off, one after the other, so that triangles are left.
//!
//! The polygon is seen along its Newell normal. An ear is a corner that turns left, with no other
//! corner in its triangle and no side across it; any polygon without self-crossings has two, and
//! cutting one off leaves such a polygon. Where none is left that may be cut (the polygon crosses
//! itself, or existing edges forbid the cuts), all triangulations are weighed, which finds one if
//! there is one. Meisters 1975; Klincsek 1980.

use glam::{DVec2, DVec3};

/// The most corners for which all triangulations are weighed, at O(n³).
const WEIGHED: usize = 128;

/// A corner to cut off, between its neighbours of that moment: numbers of corners.
pub(crate) type Ear = [usize; 3];

/// The ears of a polygon in the order to cut them: n - 3. `allowed` says which pairs of corners may
/// be joined by a cut. None if there is no way (or, with more than 128 corners, none was found).
pub(crate) fn ears(corners: &[DVec3], allowed: impl Fn(usize, usize) -> bool) -> Option<Vec<Ear>> {
    let flat = project(corners);
    let mut left: Vec<usize> = (0..corners.len()).collect();
    let mut cut = Vec::with_capacity(corners.len());
    let mut at = 0;
    let mut failed = 0;
    while left.len() > 3 {
        let n = left.len();
        let ear = [left[(at + n - 1) % n], left[at % n], left[(at + 1) % n]];
        if is_ear(&flat, &left, ear) && allowed(ear[0], ear[2]) {
            cut.push(ear);
            left.remove(at % n);
            // Not the next corner but the one after: slivers from one corner are avoided.
            at = (at + 1) % left.len();
            failed = 0;
            continue;
        }
        at = (at + 1) % n;
        failed += 1;
        if failed == n {
            if corners.len() <= WEIGHED {
                return weigh(&flat, &(0..corners.len()).collect::<Vec<_>>(), allowed);
            }
            if n > WEIGHED {
                return None;
            }
            cut.extend(weigh(&flat, &left, allowed)?);
            return Some(cut);
        }
    }
    Some(cut)
}

/// The polygon in its plane, counter-clockwise.
fn project(corners: &[DVec3]) -> Vec<DVec2> {
    let base = corners.first().copied().unwrap_or_default();
    let after = corners.iter().skip(1).chain(corners.first());
    let normal: DVec3 = corners.iter().zip(after).map(|(a, b)| (*a - base).cross(*b - base)).sum();
    let normal = normal.try_normalize().unwrap_or(DVec3::Z);
    let (x, y) = normal.any_orthonormal_pair();
    corners.iter().map(|p| DVec2::new((*p - base).dot(x), (*p - base).dot(y))).collect()
}

/// Twice the signed area of a triangle: positive where it turns left.
fn area(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

fn is_ear(flat: &[DVec2], left: &[usize], [before, tip, after]: Ear) -> bool {
    let (a, b, c) = (flat[before], flat[tip], flat[after]);
    if area(a, b, c) <= 0.0 {
        return false;
    }
    let next_of = left.iter().skip(1).chain(left.first());
    left.iter().zip(next_of).all(|(&i, &next)| {
        let (p, q) = (flat[i], flat[next]);
        let is_own = i == before || i == tip || i == after;
        // A corner elsewhere in the same place as one of these is where the polygon touches itself.
        let touches = p == a || p == b || p == c;
        let inside =
            !is_own && !touches && area(a, b, p) >= 0.0 && area(b, c, p) >= 0.0 && area(c, a, p) >= 0.0;
        let crosses = area(a, c, p) * area(a, c, q) < 0.0 && area(p, q, a) * area(p, q, c) < 0.0;
        !inside && !crosses
    })
}

/// The triangulation with the least area turned the wrong way, and of those the shortest cuts.
fn weigh(flat: &[DVec2], polygon: &[usize], allowed: impl Fn(usize, usize) -> bool) -> Option<Vec<Ear>> {
    let n = polygon.len();
    let at = |i: usize| flat[polygon[i]];
    let scale: f64 = (0..n).map(|i| at(i).distance_squared(at((i + 1) % n))).sum();
    // cost[i * n + j]: of the part of the polygon from corner i to corner j, and its third corner.
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
    // Inner parts first: each triangle is then an ear of what is left. The last is not cut off.
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
