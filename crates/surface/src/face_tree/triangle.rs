//! A ray and a triangle, and the point of a triangle closest to another.

use glam::DVec3;

/// The distance at which a ray from the origin hits a triangle, and the barycentric coordinates there.
///
/// The signs of the sides' volumes decide (Plücker coordinates). A side shared by two triangles gives exactly
/// opposite numbers, so that no ray passes between them.
pub(super) fn intersect([a, b, c]: [DVec3; 3], direction: DVec3) -> Option<(f64, DVec3)> {
    let volumes = DVec3::new(direction.dot(c.cross(b)), direction.dot(a.cross(c)), direction.dot(b.cross(a)));
    if volumes.min_element() < 0.0 && volumes.max_element() > 0.0 {
        return None;
    }
    let sum = volumes.x + volumes.y + volumes.z;
    if sum == 0.0 {
        return None;
    }
    let weights = volumes / sum;
    let distance = direction.dot(a * weights.x + b * weights.y + c * weights.z);
    (distance >= 0.0).then_some((distance, weights))
}

/// The barycentric coordinates of the point of a triangle closest to `p` (Ericson: Real-time collision
/// detection, 5.1.5).
#[inline(always)]
pub(crate) fn closest_in_triangle([a, b, c]: [DVec3; 3], p: DVec3) -> DVec3 {
    let (ab, ac) = (b - a, c - a);
    let ap = p - a;
    let (d1, d2) = (ab.dot(ap), ac.dot(ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return DVec3::X;
    }
    let bp = p - b;
    let (d3, d4) = (ab.dot(bp), ac.dot(bp));
    if d3 >= 0.0 && d4 <= d3 {
        return DVec3::Y;
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 && d1 > d3 {
        let v = d1 / (d1 - d3);
        return DVec3::new(1.0 - v, v, 0.0);
    }
    let cp = p - c;
    let (d5, d6) = (ab.dot(cp), ac.dot(cp));
    if d6 >= 0.0 && d5 <= d6 {
        return DVec3::Z;
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 && d2 > d6 {
        let w = d2 / (d2 - d6);
        return DVec3::new(1.0 - w, 0.0, w);
    }
    let va = d3 * d6 - d5 * d4;
    let past_b = d4 - d3;
    let along = past_b + (d5 - d6);
    if va <= 0.0 && past_b >= 0.0 && d5 >= d6 && along > 0.0 {
        let w = past_b / along;
        return DVec3::new(0.0, 1.0 - w, w);
    }
    let sum = va + vb + vc;
    // In a triangle with hardly any area the three areas are noise: its sides decide.
    if sum <= 1e-14 * ab.length_squared() * ac.length_squared() {
        return closest_on_sides([a, b, c], p);
    }
    let (v, w) = (vb / sum, vc / sum);
    DVec3::new(1.0 - v - w, v, w)
}

/// The point of a segment closest to `p`, as a fraction of its length from 0 to 1.
pub(crate) fn along_segment(from: DVec3, to: DVec3, p: DVec3) -> f64 {
    let along = to - from;
    ((p - from).dot(along) / along.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0)
}

/// The barycentric coordinates of the point on a triangle's sides closest to `p`.
#[cold]
#[inline(never)]
fn closest_on_sides(corners: [DVec3; 3], p: DVec3) -> DVec3 {
    let on_side = |i: usize| {
        let (from, to) = (corners[i], corners[(i + 1) % 3]);
        let t = along_segment(from, to, p);
        let mut weights = DVec3::ZERO;
        weights[i] = 1.0 - t;
        weights[(i + 1) % 3] = t;
        (weights, from.lerp(to, t).distance_squared(p))
    };
    let [first, second, third] = [0, 1, 2].map(on_side);
    let nearer = |a: (DVec3, f64), b: (DVec3, f64)| if b.1 < a.1 { b } else { a };
    nearer(nearer(first, second), third).0
}
